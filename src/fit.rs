//! Coefficients of the PLM from loading curves: reading curves, the least-squares problem, and what is said of its outcome.

pub mod curve;
mod header;
pub mod knots;
pub mod parameters;
pub mod report;
pub mod residuals;
pub mod solve;

use thiserror::Error;

use crate::scenario::ScenarioError;

pub use curve::{CurveError, LoadingCurve, LoadingPoint};
pub use solve::{Fit, Plan, fit};

/// Why there are no coefficients.
#[derive(Debug, Error)]
pub enum FitError {
    /// A file cannot be read.
    #[error(transparent)]
    Unreadable(#[from] ScenarioError),
    /// A curve is refused.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// A request that cannot be met; the text says what and why.
    #[error("{0}")]
    Request(String),
    /// The minimiser gave up.
    #[error("the least-squares fit did not converge ({0}); take other knots, or curves with less scatter")]
    NotConverged(String),
    /// The table could not be written as TOML.
    #[error("coefficients: {0}")]
    Form(#[from] toml::ser::Error),
}

impl FitError {
    /// 2 where the input has to change, 1 where the fit failed.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        match self {
            Self::Unreadable(_) | Self::Curve(_) | Self::Request(_) => 2,
            Self::NotConverged(_) | Self::Form(_) => 1,
        }
    }
}
