//! Errors of a calibration.

use crate::error::{Error, ErrorKind};
use crate::impact::ImpactError;
use crate::indentation::IndentationError;
use crate::scenario::ScenarioError;
use crate::units::csv_text::TableError;

/// Why a calibration has no result.
#[derive(Debug, thiserror::Error)]
pub enum CalibrateError {
    /// The scenario is refused, or a file cannot be read.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// The measurements are refused.
    #[error(transparent)]
    Data(#[from] TableError),
    /// The law gives no result anywhere in the ranges of the keys.
    #[error(
        "{name}: the law has no answer for these measurements anywhere in the range of the keys: {reason}; choose another range"
    )]
    NoAnswer {
        /// The name of the file of measurements.
        name: String,
        /// Why there is no result in the middle of the ranges.
        reason: NoAnswer,
    },
}

impl From<CalibrateError> for Error {
    fn from(error: CalibrateError) -> Self {
        match error {
            CalibrateError::Scenario(error) => error.into(),
            CalibrateError::Data(error) => error.into(),
            CalibrateError::NoAnswer { ref name, .. } => Self::of(ErrorKind::Input, &error).about(name),
        }
    }
}

/// Why the law predicts nothing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NoAnswer {
    /// An impact has no result.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// An indentation has no result.
    #[error(transparent)]
    Indentation(#[from] IndentationError),
    /// The sphere stays in its dent, so a measured quantity such as the contact time does not exist.
    #[error("a quantity that was measured does not exist there, as the sphere does not leave")]
    Captured,
}
