//! Errors of a validation, and the exponents that it compares.

use crate::calibrate::CalibrateError;
use crate::error::{Error, ErrorKind};
use crate::impact::ImpactError;
use crate::law::UnloadingExponent;
use crate::material::OutOfFloatRange;
use crate::plot::PlotError;
use crate::reference::ReferenceError;
use crate::scenario::ScenarioError;
use crate::units::csv_text::TableError;

/// Why a validation has no result.
#[derive(Debug, thiserror::Error)]
pub enum ValidationError {
    /// A file of the user cannot be read.
    #[error(transparent)]
    Unreadable(ScenarioError),
    /// A file of measurements is refused.
    #[error(transparent)]
    Measured(#[from] CalibrateError),
    #[error("{file}: {problem}")]
    Coefficients { file: String, problem: String },
    /// A reference table of the program is damaged.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    /// A reference curve of the program is damaged.
    #[error("reference curve {0}")]
    Curve(#[from] TableError),
    /// A reference scenario of the program is refused.
    #[error("reference scenario {0}")]
    Scenario(ScenarioError),
    #[error(transparent)]
    Impact(#[from] ImpactError),
    #[error(transparent)]
    Plot(#[from] PlotError),
    #[error("table: {0}")]
    Csv(#[from] csv::Error),
}

impl From<ValidationError> for Error {
    fn from(error: ValidationError) -> Self {
        match error {
            ValidationError::Unreadable(error) => error.into(),
            ValidationError::Measured(error) => error.into(),
            ValidationError::Coefficients { ref file, .. } => Self::of(ErrorKind::Input, &error).about(file),
            error => Self::of(ErrorKind::Failed, &error),
        }
    }
}

impl From<OutOfFloatRange> for ValidationError {
    fn from(error: OutOfFloatRange) -> Self {
        Self::Impact(error.into())
    }
}

/// The exponents that are compared, with their names in tables and pictures.
pub const EXPONENTS: [(UnloadingExponent, &str); 2] =
    [(UnloadingExponent::Paper, "exponent 3/2"), (UnloadingExponent::PressureShape, "pressure-shape")];
