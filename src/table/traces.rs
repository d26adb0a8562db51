//! The traces of the rows of a short table: every row is computed again, with its trace.

use crate::impact::{Impact, ImpactError, TraceRow};
use crate::scenario::plan::{Plan, axis_indices};

/// A row with its trace.
#[derive(Debug, Clone)]
pub struct RowTrace {
    /// The number of the row.
    pub case: u64,
    /// The indices of its values on the axes.
    pub places: Vec<u64>,
    pub impact: Impact,
}

impl RowTrace {
    pub fn rows(&self) -> &[TraceRow] {
        &self.impact.trace
    }
}

/// The traces of all rows of a grid. A row without a result has no trace; the table states the reason.
pub fn row_traces(plan: &Plan) -> Vec<RowTrace> {
    let trace = |case: u64| {
        let places = axis_indices(plan.axes(), case);
        let impact = impact_with_trace(plan, &places).ok()?;
        Some(RowTrace { case, places, impact })
    };
    (0..plan.n_cases()).filter_map(trace).collect()
}

fn impact_with_trace(plan: &Plan, places: &[u64]) -> Result<Impact, ImpactError> {
    let input = plan.input_at(places);
    input.contact()?.impact(input.approach(), &input.solver(), Some(input.samples()))
}
