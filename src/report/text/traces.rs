//! `traces.csv`: the traces of the rows of a table, one below the other.

use serde_json::Value;

use super::files::csv_bytes_after;
use crate::error::Error;
use crate::results::trace::trace_results;
use crate::scenario::plan::{AxisSetting, Plan, SweepAxis};
use crate::table::traces::RowTrace;

/// The traces in long form: the number of the row and the values of its axes, as in the table, and then the columns of a trace. A
/// column with a condition is written if any trace has a value for it.
pub fn traces_csv(plan: &Plan, traces: &[RowTrace]) -> Result<Vec<u8>, Error> {
    let axes = plan.axes();
    let axis_names = plan.axis_columns().into_iter().take(axes.len());
    let names: Vec<String> = std::iter::once("case".to_owned()).chain(axis_names).collect();
    let value = |(axis, place): (&SweepAxis, &u64)| match axis.setting {
        AxisSetting::Number { .. } => Value::from(axis.value_at(*place)),
        AxisSetting::Words { .. } => Value::from(axis.label(*place)),
    };
    let with_case = |trace: &RowTrace| {
        let values = axes.iter().zip(&trace.places).map(value);
        std::iter::once(Value::from(trace.case)).chain(values).collect::<Vec<Value>>()
    };
    let first: Vec<Vec<Value>> = traces.iter().map(with_case).collect();
    let rows = first.iter().zip(traces).flat_map(|(first, trace)| trace.rows().iter().map(|row| (&first[..], *row)));
    csv_bytes_after(&names, &trace_results(), rows)
}
