//! Why there are no coefficients.

use thiserror::Error;

use crate::scenario::ScenarioError;

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

/// Why a curve is refused.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{name}{}: {message}", .line.map(|line| format!(":{line}")).unwrap_or_default())]
pub struct CurveError {
    /// The file.
    pub name: String,
    /// The line, counted from 1.
    pub line: Option<u64>,
    /// What is wrong, what is allowed, what to do.
    pub message: String,
}
