//! How rows are counted: results, rows outside a law, failures.

use super::evaluator::Failure;
use crate::impact::Essentials;

/// How a row counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Count {
    /// It has e.
    Restitution(f64),
    /// It was let go at first touch, without a speed that e could be a part of.
    AtRest,
    /// The law has no answer there, which is one: no failure.
    OutsideLaw,
    /// It has no result.
    Failure,
}

impl Count {
    /// Of a row as it was computed.
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
