//! Coefficients of the PLM from loading curves: reads the curves, fits by least squares, and reports the fit.

pub mod curve;
mod header;
pub mod knots;
pub mod parameters;
pub mod report;
pub mod residuals;
pub mod solve;

pub use curve::{LoadingCurve, LoadingPoint};
pub use solve::{Fit, Plan, fit};
