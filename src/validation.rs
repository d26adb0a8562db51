//! The law and the program against finite elements, published values and closed forms: how right the numbers are.
//!
//! Every comparison is a [`Check`]: expected, got, deviation, tolerance. What is expected never comes from the law or the
//! integrator under test. Tolerances are those that the law's documentation and the references state, plus a small margin
//! that is named with them.

pub mod cases;
pub mod check;
mod closed_restitution;
mod dents;
pub mod dynamic;
mod hertz;
mod loading;
mod oracle;
mod pictures;
pub mod report;
mod restitution;
mod unloading;

use thiserror::Error;

use crate::fit::CurveError;
use crate::impact::ImpactError;
use crate::law::{PlmCoefficients, UnloadingExponent};
use crate::material::OutOfFloatRange;
use crate::plot::PlotError;
use crate::reference::ReferenceError;
use crate::scenario::ScenarioError;
pub use check::{Check, Known, Tolerance, Verdict};
pub use pictures::pictures;

/// Why a validation could not be made.
#[derive(Debug, Error)]
pub enum ValidationError {
    /// A file of coefficients cannot be read.
    #[error(transparent)]
    Unreadable(ScenarioError),
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

impl ValidationError {
    /// 2 where the input has to change, 1 otherwise.
    #[must_use]
    pub fn exit_code(&self) -> u8 {
        if matches!(self, Self::Unreadable(_) | Self::Coefficients { .. }) { 2 } else { 1 }
    }
}

/// The exponents that are compared, with their names in tables and pictures.
pub const EXPONENTS: [(UnloadingExponent, &str); 2] =
    [(UnloadingExponent::Paper, "exponent 3/2"), (UnloadingExponent::PressureShape, "pressure-shape")];

/// Rows of one kind.
pub type Source = fn(&PlmCoefficients) -> Result<Vec<Check>, ValidationError>;

/// Where rows come from, in the order of the table.
pub const SOURCES: [Source; 8] = [
    loading::checks,
    unloading::checks,
    dents::checks,
    restitution::checks,
    dynamic::checks,
    hertz::checks,
    closed_restitution::checks,
    oracle::checks,
];

/// All rows for a law with these coefficients.
///
/// # Errors
/// [`ValidationError`].
pub fn checks(coefficients: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let mut all = Vec::new();
    for source in SOURCES {
        all.extend(source(coefficients)?);
    }
    if coefficients != PlmCoefficients::built_in() {
        // what is on record was found of the built-in law
        for check in &mut all {
            check.known = None;
        }
    }
    Ok(all)
}
