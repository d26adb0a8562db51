//! Why a validation could not be made, and the exponents that it compares.

use thiserror::Error;

use crate::fit::CurveError;
use crate::impact::ImpactError;
use crate::law::UnloadingExponent;
use crate::material::OutOfFloatRange;
use crate::plot::PlotError;
use crate::reference::ReferenceError;
use crate::scenario::ScenarioError;

/// Why a validation could not be made.
#[derive(Debug, Error)]
pub enum ValidationError {
    /// A file that was given cannot be read, or its keys are refused.
    #[error(transparent)]
    Unreadable(ScenarioError),
    /// A file of measurements is refused.
    #[error(transparent)]
    Experiment(CurveError),
    /// A file of coefficients is refused.
    #[error("{file}: {problem}")]
    Coefficients {
        /// The file.
        file: String,
        /// What is wrong with it.
        problem: String,
    },
    /// A reference table that is compiled in is damaged.
    #[error(transparent)]
    Reference(#[from] ReferenceError),
    /// A reference curve that is compiled in is damaged.
    #[error("reference curve {0}")]
    Curve(#[from] CurveError),
    /// A reference scenario that is compiled in is refused.
    #[error("reference scenario {0}")]
    Scenario(ScenarioError),
    /// An impact without a result.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// A picture could not be drawn.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// The table could not be written.
    #[error("table: {0}")]
    Csv(#[from] csv::Error),
}

impl From<OutOfFloatRange> for ValidationError {
    fn from(error: OutOfFloatRange) -> Self {
        Self::Impact(error.into())
    }
}

/// The exponents that are compared, with their names in tables and pictures.
pub const EXPONENTS: [(UnloadingExponent, &str); 2] =
    [(UnloadingExponent::Paper, "exponent 3/2"), (UnloadingExponent::PressureShape, "pressure-shape")];
