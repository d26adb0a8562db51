//! How rows are counted: as results, as rows outside the range of a law, or as failures.

use super::Failure;
use super::statistics::Statistics;
use crate::impact::Essentials;
use crate::scenario::plan::Plan;

/// How a row counts: its coefficient of restitution e, which a sphere that was released at rest does not have; or why there is
/// no result.
pub type Count = Result<Option<f64>, Failure>;

/// How a computed row counts.
pub fn count(result: &Result<Essentials, Failure>) -> Count {
    result.as_ref().map(|row| row.has_speed().then_some(row.restitution)).map_err(|failure| *failure)
}

/// The count of a row that was read back; `None` for an unknown status.
pub(super) fn written(status: &str, restitution: Option<f64>) -> Option<Count> {
    if status == OK {
        return Some(Ok(restitution));
    }
    Failure::find(status).map(Err)
}

/// The status of a row with a result.
pub(super) const OK: &str = "ok";

pub(super) fn status(result: &Result<Essentials, Failure>) -> &'static str {
    result.as_ref().map_or_else(|failure| failure.name(), |_| OK)
}

/// Counts of rows, and the statistics of e.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    pub rows: u64,
    /// Rows without a result.
    pub failures: u64,
    /// Rows outside the range of the law.
    pub outside_law: u64,
    /// True if values are random; only then e goes into the statistics.
    is_random: bool,
    /// Statistics of e; empty if the values are not random.
    pub statistics: Statistics,
}

impl Tally {
    /// No rows of this plan yet.
    pub fn new(plan: &Plan) -> Self {
        Self { is_random: plan.is_monte_carlo(), ..Self::default() }
    }

    /// Counts a row. The statistics depend on the order of the rows in their last digits.
    pub fn push(&mut self, count: Count) {
        self.rows += 1;
        match count {
            // an answer, not a failure
            Err(Failure::OutsideLaw) => self.outside_law += 1,
            Err(_) => self.failures += 1,
            Ok(Some(restitution)) if self.is_random => self.statistics.push(restitution),
            Ok(_) => {}
        }
    }
}
