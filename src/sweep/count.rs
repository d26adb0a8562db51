//! How rows are counted: as results, as rows outside the range of a law, or as failures.

use super::evaluator::Failure;
use super::statistics::Statistics;
use crate::impact::Essentials;
use crate::plan::Plan;

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

    /// How a row counts by its failure and its e, which is `None` where the field is empty.
    pub fn of_row(failure: Option<Failure>, restitution: Option<f64>) -> Self {
        failure.map_or_else(|| restitution.map_or(Self::AtRest, Self::Restitution), Self::from)
    }

    /// The same of a written row, by its status.
    pub(super) fn of_written(status: &str, restitution: Option<f64>) -> Option<Self> {
        let failure = Failure::ALL.into_iter().find(|failure| failure.name() == status);
        (failure.is_some() || status == OK).then(|| Self::of_row(failure, restitution))
    }
}

impl From<Failure> for Count {
    fn from(failure: Failure) -> Self {
        if failure == Failure::OutsideLaw { Self::OutsideLaw } else { Self::Failure }
    }
}

/// The status of a row with a result.
pub(super) const OK: &str = "ok";

/// The status of a row.
pub(super) fn status(result: &Result<Essentials, Failure>) -> &'static str {
    result.as_ref().map_or_else(|failure| failure.name(), |_| OK)
}

/// Counts of rows, and the statistics of e.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    /// Rows.
    pub rows: u64,
    /// Rows without a result.
    pub failures: u64,
    /// Rows outside the range of the law.
    pub outside_law: u64,
    /// Whether values are random; only then e goes into the statistics.
    is_random: bool,
    /// Statistics of e; empty if the values are not random.
    pub statistics: Statistics,
}

impl Tally {
    /// No rows of this plan yet.
    pub fn of(plan: &Plan) -> Self {
        Self { is_random: plan.is_monte_carlo(), ..Self::default() }
    }

    /// Counts a row. The statistics depend on the order of the rows in their last digits.
    pub fn push(&mut self, count: Count) {
        self.rows += 1;
        match count {
            Count::Failure => self.failures += 1,
            Count::OutsideLaw => self.outside_law += 1,
            Count::Restitution(value) if self.is_random => self.statistics.push(value),
            Count::Restitution(_) | Count::AtRest => {}
        }
    }
}
