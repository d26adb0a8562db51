//! Errors of a fit.

use crate::error::{Error, ErrorKind};
use crate::scenario::ScenarioError;
use crate::units::csv_text::TableError;

/// Why a fit gave no coefficients.
#[derive(Debug, thiserror::Error)]
pub enum FitError {
    /// A file cannot be read.
    #[error(transparent)]
    Unreadable(#[from] ScenarioError),
    /// A curve is refused.
    #[error(transparent)]
    Curve(#[from] TableError),
    /// The request cannot be met; the text says why.
    #[error("{0}")]
    Request(String),
    /// The least-squares fit did not converge.
    #[error("the least-squares fit did not converge ({0}); take other knots, or curves with less scatter")]
    NotConverged(String),
    /// The table could not be written as TOML.
    #[error("coefficients: {0}")]
    Form(#[from] toml::ser::Error),
}

impl From<FitError> for Error {
    fn from(error: FitError) -> Self {
        match error {
            FitError::Unreadable(error) => error.into(),
            FitError::Curve(error) => error.into(),
            FitError::Request(text) => Self::input(text),
            FitError::NotConverged(_) | FitError::Form(_) => Self::of(ErrorKind::Failed, &error),
        }
    }
}
