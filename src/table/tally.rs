//! Rows are classified as results, as rows outside the range of a law, or as failures.

use super::RowFailure;
use super::statistics::{ColumnStatistics, RunningStatistics};
use crate::impact::ImpactRow;
use crate::results::ResultColumn;
use crate::scenario::plan::Plan;

/// The outcome of a row: its values in [`Plan::statistics_columns`], where a missing value is NaN; or the reason why it has no result.
pub type RowOutcome = Result<Vec<f64>, RowFailure>;

/// Classifies a computed row. `columns` are the columns with statistics.
pub fn classify(result: &Result<ImpactRow, RowFailure>, columns: &[ResultColumn]) -> RowOutcome {
    let values = |row: &ImpactRow| columns.iter().map(|column| (column.value)(row).unwrap_or(f64::NAN)).collect();
    result.as_ref().map(values).map_err(|failure| *failure)
}

/// The outcome of a row that is read from a file; `None` for an unknown status.
pub(super) fn parse_outcome(status: &str, values: Vec<f64>) -> Option<RowOutcome> {
    if status == OK {
        return Some(Ok(values));
    }
    RowFailure::from_name(status).map(Err)
}

/// The status of a row with a result.
pub(super) const OK: &str = "ok";

pub(super) fn status_word(result: &Result<ImpactRow, RowFailure>) -> &'static str {
    result.as_ref().map_or_else(|failure| failure.name(), |_| OK)
}

/// Counts of rows, and the statistics of their columns.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    pub rows: u64,
    /// Rows without a result.
    pub failures: u64,
    /// Rows outside the range of the law.
    pub outside_law: u64,
    /// The columns of [`Plan::statistics_columns`], the restitution first. Empty if the values are not random.
    pub statistics: Vec<(ResultColumn, RunningStatistics)>,
}

impl Tally {
    /// No rows of this plan yet.
    pub fn new(plan: &Plan) -> Self {
        let statistics =
            plan.statistics_columns().into_iter().map(|column| (column, RunningStatistics::default())).collect();
        Self { statistics, ..Self::default() }
    }

    /// Counts a row. The statistics depend on the order of the rows in their last digits.
    pub fn push(&mut self, count: RowOutcome) {
        self.rows += 1;
        match count {
            // a row outside of the law has a known reason and is no failure
            Err(RowFailure::OutsideLaw) => self.outside_law += 1,
            Err(_) => self.failures += 1,
            Ok(values) => {
                for ((_, statistics), value) in self.statistics.iter_mut().zip(values) {
                    statistics.push(value);
                }
            }
        }
    }

    /// The distribution of every column that has values.
    pub fn distributions(&self) -> Vec<(ResultColumn, ColumnStatistics)> {
        self.statistics.iter().filter_map(|(column, all)| Some((*column, all.distribution()?))).collect()
    }
}
