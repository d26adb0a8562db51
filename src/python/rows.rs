//! Computes the rows of tables on all threads.

use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

use pyo3::exceptions::PyMemoryError;
use pyo3::prelude::*;
use rayon::prelude::*;

use super::convert::warn;
use super::table::Column;
use super::work::{FEW, interruptible};
use crate::impact::{Contact, Method};
use crate::plan::Plan;
use crate::plan::axis::{Axis, Setting, Word, keeps_contact};
use crate::scene::Key;
use crate::scene::results::Column as Result;
use crate::sweep::evaluator::{Evaluator, Failure, Rows};

/// Computed rows.
#[derive(Debug)]
pub struct Made {
    /// The columns of numbers: swept values, then results.
    pub columns: Vec<Vec<f64>>,
    /// The status of every row, as [`code`] numbers it.
    pub status: Vec<u8>,
}

impl Made {
    /// The whole table: the columns of `swept`, the computed columns, and the status.
    pub fn table(self, plan: &Plan, results: &[Result], swept: Vec<Column>) -> Vec<(String, Column)> {
        let words = ["ok"].into_iter().chain(Failure::ALL.map(Failure::name)).map(str::to_owned);
        let status = Column::Words(words.collect(), self.status.iter().map(|code| i32::from(*code)).collect());
        let names = plan.columns().into_iter().chain(results.iter().map(|column| column.name.to_owned()));
        let columns = swept.into_iter().chain(self.columns.into_iter().map(Column::numbers));
        names.zip(columns).chain([("status".to_owned(), status)]).collect()
    }
}

/// Rows of a plan at listed values of these keys, with these results. If the yield strength follows from the keys, it
/// is the first column. `contact` is that of the plan, which the keys may change.
pub fn listed(
    py: Python<'_>,
    plan: &Plan,
    contact: &Contact,
    keys: &[(&Key, &[f64])],
    rows: usize,
    results: &[Result],
) -> PyResult<Made> {
    let compute = |is_cancelled: Option<&AtomicBool>| {
        let is_known = keys.iter().all(|(key, _)| keeps_contact(key.path));
        let evaluator = if is_known { Evaluator::of_contact(plan, contact) } else { Evaluator::new(plan) };
        let n_derived = usize::from(plan.derives_strength());
        fill(rows, n_derived, results, is_cancelled, |cases, made| evaluator.listed(keys, cases, made))
    };
    // a step of the fixed-step method may be as short as one likes
    if rows <= FEW && plan.scene.solver.method != Method::Verlet {
        return py.detach(|| compute(None));
    }
    interruptible(py, |is_cancelled| compute(Some(is_cancelled)))?
}

/// All rows of a plan, and the columns of its axes.
pub fn of_plan(py: Python<'_>, plan: &Plan) -> PyResult<(Made, Vec<Column>)> {
    let rows = usize::try_from(plan.count()).unwrap_or(usize::MAX);
    let mut made = interruptible(py, |is_cancelled| {
        let evaluator = Evaluator::new(plan);
        fill(rows, evaluator.n_swept(), &plan.results(), Some(is_cancelled), |cases, made| {
            evaluator.rows(cases.start as u64..cases.end as u64, made);
        })
    })??;
    // on a grid the first columns are places on its axes
    let axes = plan.axes();
    let swept =
        axes.iter().zip(made.columns.drain(..axes.len())).map(|(axis, places)| on_axis(axis, &places)).collect();
    Ok((made, swept))
}

/// The values at these places of an axis.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole numbers below the length of the axis
fn on_axis(axis: &Axis, places: &[f64]) -> Column {
    match &axis.setting {
        Setting::Number { values, .. } => {
            Column::numbers(places.iter().map(|place| values.at(*place as u64)).collect())
        }
        Setting::Words { words, .. } => {
            Column::Words(words.iter().map(Word::name).collect(), places.iter().map(|place| *place as i32).collect())
        }
    }
}

/// The number of a failure in a status; 0 is a row with results.
pub fn code(failure: Failure) -> u8 {
    (1..).zip(Failure::ALL).find(|(_, known)| *known == failure).map_or(0, |(code, _)| code)
}

/// The failure of a status; `None` for a row with results.
pub fn failure(status: u8) -> Option<Failure> {
    Failure::ALL.get(usize::from(status).checked_sub(1)?).copied()
}

/// Warns of rows without a result.
pub fn say_failures(py: Python<'_>, rows: usize, status: impl Iterator<Item = u8>) -> PyResult<()> {
    let mut failed = status.filter_map(failure);
    let Some(first) = failed.next() else { return Ok(()) };
    let (count, first) = (1 + failed.count(), first.name());
    warn(py, &[format!("{count} of {rows} cases have no result, the first: {first}; their values are not numbers")])
}

/// A piece of a table that one thread fills.
struct Piece<'a> {
    rows: Range<usize>,
    columns: Vec<&'a mut [f64]>,
    status: &'a mut [u8],
}

/// The most rows of a piece.
const LONGEST: usize = 4096;
/// Rows between two looks for an interruption.
const HEARD: usize = 64;

/// Computes rows: the columns of swept values, the columns of results, and the status of every row. If they can be
/// cancelled, they are computed on the threads of the pool, else in the calling one.
fn fill(
    rows: usize,
    n_swept: usize,
    results: &[Result],
    is_cancelled: Option<&AtomicBool>,
    make: impl Fn(Range<usize>, &mut Rows) + Sync,
) -> PyResult<Made> {
    let width = n_swept + results.len();
    // one more column for the status
    let cells = rows.saturating_mul(width + 1);
    if Vec::<f64>::new().try_reserve_exact(cells).is_err() {
        return Err(PyMemoryError::new_err(format!("a table of {rows} rows does not fit into memory; divide it")));
    }
    let mut columns = vec![vec![0.0; rows]; width];
    let mut status = vec![0; rows];
    let Some(is_cancelled) = is_cancelled else {
        let mut computed = Rows::default();
        make(0..rows, &mut computed);
        let columns_of_piece = columns.iter_mut().map(Vec::as_mut_slice).collect();
        let mut piece = Piece { rows: 0..rows, columns: columns_of_piece, status: &mut status };
        piece.put(&computed, n_swept, results);
        return Ok(Made { columns, status });
    };
    let longest = rows.div_ceil(8 * rayon::current_num_threads()).clamp(1, LONGEST);
    let starts = (0..rows).step_by(longest);
    let mut pieces: Vec<Piece> = starts
        .zip(status.chunks_mut(longest))
        .map(|(start, status)| Piece { rows: start..start + status.len(), columns: Vec::with_capacity(width), status })
        .collect();
    for column in &mut columns {
        for (piece, part) in pieces.iter_mut().zip(column.chunks_mut(longest)) {
            piece.columns.push(part);
        }
    }
    pieces.into_par_iter().for_each(|mut piece| {
        let mut made = Rows::default();
        for start in piece.rows.clone().step_by(HEARD) {
            if is_cancelled.load(Ordering::Relaxed) {
                break;
            }
            make(start..piece.rows.end.min(start + HEARD), &mut made);
        }
        piece.put(&made, n_swept, results);
    });
    Ok(Made { columns, status })
}

impl Piece<'_> {
    fn put(&mut self, made: &Rows, n_swept: usize, results: &[Result]) {
        let (swept, of_results) = self.columns.split_at_mut(n_swept);
        for (place, column) in swept.iter_mut().enumerate() {
            for (cell, values) in column.iter_mut().zip(made.swept.chunks(n_swept)) {
                *cell = values[place];
            }
        }
        for (column, result) in of_results.iter_mut().zip(results) {
            for (cell, row) in column.iter_mut().zip(&made.results) {
                *cell = row.as_ref().ok().and_then(result.value).unwrap_or(f64::NAN);
            }
        }
        for (cell, row) in self.status.iter_mut().zip(&made.results) {
            *cell = row.as_ref().err().map_or(0, |failure| code(*failure));
        }
    }
}
