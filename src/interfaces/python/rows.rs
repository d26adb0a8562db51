//! The rows of tables, column by column.

use pyo3::prelude::*;

use super::workers;
use crate::impact::{Contact, Method};
use crate::scenario::input::NumericKey;
use crate::scenario::plan::Plan;
use crate::table::format::arrow;
use crate::table::format::column::{TableColumn, table_columns};
use crate::table::{Evaluator, RowFailure, Rows};

/// The columns of a table, and their names. The last is the status.
pub type NamedColumns = Vec<(String, TableColumn)>;

/// All columns of a plan but the case number.
pub fn plan_columns(plan: &Plan) -> NamedColumns {
    plan.column_names().into_iter().zip(table_columns(plan)).skip(1).collect()
}

/// The columns that are no axis: yield strengths that follow from the axes, and results.
pub fn result_columns(plan: &Plan) -> NamedColumns {
    let mut named = plan_columns(plan).split_off(plan.axes().len());
    for (place, _) in plan.derived_bodies().enumerate() {
        named[place].1 = TableColumn::Value(place);
    }
    named
}

/// Rows of a plan at listed values of these keys, without the columns of its axes. `contact` is that of the plan, which the
/// keys may change.
pub fn evaluate(
    py: Python<'_>,
    plan: &Plan,
    contact: &Contact,
    keys: &[(NumericKey, &[f64])],
    rows: usize,
    named: &NamedColumns,
) -> PyResult<Vec<Vec<f64>>> {
    let is_known = !keys.iter().any(|(key, _)| key.part().changes_contact());
    let evaluator = Evaluator::with_contact(plan, is_known.then_some(contact));
    // a step of the fixed-step method may be as short as one likes
    let is_slow = plan.input.solver().method == Method::Verlet;
    workers::columns(py, rows, &vec![1; named.len()], is_slow, |cases| {
        let mut made = Rows::default();
        evaluator.append_rows_with_values(keys, cases, &mut made);
        Ok(values(named, &made))
    })
}

/// The values of these columns.
pub fn values(named: &NamedColumns, rows: &Rows) -> Vec<Vec<f64>> {
    named.iter().map(|(_, column)| column.values(rows)).collect()
}

/// The warning about rows without a result. The column of the status gives the reason for each row.
pub fn failures(status: &[f64]) -> Option<String> {
    let mut failed = status.iter().filter(|code| **code > 0.0);
    let name = arrow::failure_of_code(*failed.next()?).map_or("", RowFailure::name);
    let (count, rows) = (1 + failed.count(), status.len());
    Some(format!("{count} of {rows} cases have no result, the first: {name}; their values are not numbers"))
}
