//! The rows of tables, column by column.

use pyo3::prelude::*;

use super::convert::warn;
use super::work;
use crate::impact::{Contact, Method};
use crate::plan::Plan;
use crate::plan::axis::keeps_contact;
use crate::scene::Key;
use crate::sweep::arrow;
use crate::sweep::column::{Column, columns};
use crate::sweep::evaluator::{Evaluator, Failure, Rows};

/// The columns of a table, and their names. The last is the status.
pub type Named = Vec<(String, Column)>;

/// All columns of a plan but the case number.
pub fn of_plan(plan: &Plan) -> Named {
    plan.column_names().into_iter().zip(columns(plan)).skip(1).collect()
}

/// Those of them that do not stand for the values of an axis: a yield strength that follows from these, and results.
pub fn without_axes(plan: &Plan) -> Named {
    let mut named = of_plan(plan).split_off(plan.axes().len());
    if plan.derives_strength() {
        named[0].1 = Column::Plain(0);
    }
    named
}

/// All rows of a plan.
pub fn all(py: Python<'_>, plan: &Plan, named: &Named) -> PyResult<Vec<Vec<f64>>> {
    let rows = usize::try_from(plan.count()).unwrap_or(usize::MAX);
    let evaluator = py.detach(|| Evaluator::new(plan));
    made(py, plan, named, rows, |cases, made| evaluator.rows(cases.start as u64..cases.end as u64, made))
}

/// Rows of a plan at listed values of these keys, without the columns of its axes. `contact` is that of the plan, which the
/// keys may change.
pub fn listed(
    py: Python<'_>,
    plan: &Plan,
    contact: &Contact,
    keys: &[(&Key, &[f64])],
    rows: usize,
    named: &Named,
) -> PyResult<Vec<Vec<f64>>> {
    let is_known = keys.iter().all(|(key, _)| keeps_contact(key.path));
    let evaluator = Evaluator::of_contact(plan, is_known.then_some(contact));
    made(py, plan, named, rows, |cases, made| evaluator.listed(keys, cases, made))
}

fn made(
    py: Python<'_>,
    plan: &Plan,
    named: &Named,
    rows: usize,
    make: impl Fn(std::ops::Range<usize>, &mut Rows) + Sync + Send,
) -> PyResult<Vec<Vec<f64>>> {
    // a step of the fixed-step method may be as short as one likes
    let is_slow = plan.scene.solver.method == Method::Verlet;
    work::columns(py, rows, &vec![1; named.len()], is_slow, |cases| {
        let mut made = Rows::default();
        make(cases, &mut made);
        Ok(named.iter().map(|(_, column)| column.values(&made)).collect())
    })
}

/// Warns of rows without a result, by the column of the status.
pub fn say_failures(py: Python<'_>, status: &[f64]) -> PyResult<()> {
    let mut failed = status.iter().filter(|code| **code > 0.0);
    let Some(first) = failed.next() else { return Ok(()) };
    let name = arrow::failure(*first).map_or("", Failure::name);
    let (count, rows) = (1 + failed.count(), status.len());
    warn(py, &[format!("{count} of {rows} cases have no result, the first: {name}; their values are not numbers")])
}
