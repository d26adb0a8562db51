//! Why nothing was found.

use thiserror::Error;

use crate::impact::ImpactError;
use crate::indentation::IndentationError;
use crate::scenario::ScenarioError;

/// Why nothing was found.
#[derive(Debug, Error)]
pub enum CalibrateError {
    /// The scenario is refused, or a file cannot be read.
    #[error(transparent)]
    Scenario(#[from] ScenarioError),
    /// The measurements are refused.
    #[error("{name}{}: {message}", .line.map(|line| format!(":{line}")).unwrap_or_default())]
    Data {
        /// The file.
        name: String,
        /// From 1.
        line: Option<u64>,
        /// What is wrong, what is allowed, what to do.
        message: String,
    },
    /// The law has no answer anywhere in the ranges.
    #[error(
        "{name}: the law has no answer for these measurements anywhere in the range of the keys: {reason}; choose another range"
    )]
    NoAnswer {
        /// The measurements.
        name: String,
        /// Why, in the middle of the ranges.
        reason: NoAnswer,
    },
}

/// Why the law predicts nothing.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum NoAnswer {
    /// An impact has no result.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// An indentation has no result.
    #[error(transparent)]
    Indentation(#[from] IndentationError),
    /// A sphere that stays in its dent has no time in contact.
    #[error("a quantity that was measured does not exist there, as the sphere does not leave")]
    Captured,
}
