//! How rows are counted: as results, as rows outside the range of a law, or as failures.

use super::evaluator::Failure;
use crate::impact::Essentials;

/// How a row counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Count {
    /// The row has a coefficient of restitution e.
    Restitution(f64),
    /// The sphere was released at rest at first touch. Its speed is zero, so e is not defined.
    AtRest,
    /// The case lies outside the range of the law. This is an answer, not a failure.
    OutsideLaw,
    /// The row has no result.
    Failure,
}

impl Count {
    /// How a computed row counts.
    pub fn of(result: &Result<Essentials, Failure>) -> Self {
        match result {
            Ok(row) if row.has_speed() => Self::Restitution(row.restitution),
            Ok(_) => Self::AtRest,
            Err(failure) => (*failure).into(),
        }
    }
}

impl From<Failure> for Count {
    fn from(failure: Failure) -> Self {
        if failure == Failure::OutsideLaw { Self::OutsideLaw } else { Self::Failure }
    }
}
