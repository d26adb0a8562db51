//! Coefficients of the PLM from loading curves: reading the curves, the least-squares fit, and the report of it.

pub mod curve;
mod error;
mod header;
pub mod knots;
pub mod parameters;
pub mod report;
pub mod residuals;
pub mod solve;

pub use curve::{LoadingCurve, LoadingPoint};
pub use error::{CurveError, FitError};
pub use solve::{Fit, Plan, fit};
