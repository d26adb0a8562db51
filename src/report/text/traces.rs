//! `traces.csv`: the traces of the rows of a table, one below the other.

use serde_json::Value;

use super::files::into_bytes;
use crate::error::Error;
use crate::impact::TraceRow;
use crate::results::ResultSpec;
use crate::results::trace::trace_results;
use crate::scenario::plan::{AxisSetting, Plan};
use crate::table::traces::RowTrace;

/// The traces in long form: the number of the row and the values of its axes, as in the table, and then the columns of a trace. A
/// column with a condition is written if any trace has a value for it.
pub fn traces_csv(plan: &Plan, traces: &[RowTrace]) -> Result<Vec<u8>, Error> {
    let rows = || traces.iter().flat_map(RowTrace::rows);
    let is_there =
        |column: &ResultSpec<TraceRow>| column.condition.is_empty() || rows().any(|row| (column.value)(row).is_some());
    let columns: Vec<ResultSpec<TraceRow>> = trace_results().into_iter().filter(is_there).collect();
    let axes = plan.axes();
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    let names = plan.axis_columns().into_iter().take(axes.len());
    let own = columns.iter().map(|column| column.name.to_owned());
    writer.write_record(std::iter::once("case".to_owned()).chain(names).chain(own))?;
    for RowTrace { case, places, impact } in traces {
        let mut first = vec![Some(Value::from(*case))];
        first.extend(axes.iter().zip(places).map(|(axis, place)| {
            Some(match axis.setting {
                AxisSetting::Number { .. } => axis.value_at(*place).into(),
                AxisSetting::Words { .. } => axis.label(*place).into(),
            })
        }));
        for row in &impact.trace {
            let own = columns.iter().map(|column| (column.value)(row));
            writer.serialize(first.iter().cloned().chain(own).collect::<Vec<_>>())?;
        }
    }
    into_bytes(writer)
}
