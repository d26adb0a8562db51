//! The rows of a table, in memory, and files as JSON.

use serde_json::{Map, Value};

use crate::output::OutputFile;
use crate::plan::Plan;
use crate::sweep::count::{Tally, count};
use crate::sweep::csv::Csv;
use crate::sweep::evaluator::{Evaluator, Rows};

/// Rows that are computed at a time.
const BATCH: u64 = 1024;

/// The table as CSV, and what its rows add up to.
pub fn rows_of(plan: &Plan) -> (Vec<u8>, Tally) {
    let (evaluator, form) = (Evaluator::new(plan), Csv::new(plan));
    let mut text = (plan.column_names().join(",") + "\n").into_bytes();
    let mut tally = Tally::of(plan);
    let (mut begin, mut rows) = (0, Rows::default());
    while begin < plan.count() {
        let end = plan.count().min(begin + BATCH);
        rows.clear();
        evaluator.rows(begin..end, &mut rows);
        form.write(&rows, &mut text);
        rows.results.iter().map(count).for_each(|count| tally.push(count));
        begin = end;
    }
    (text, tally)
}

/// The texts of files, by their names.
pub fn texts(files: Vec<OutputFile>) -> Value {
    let text = |file: OutputFile| (file.name, String::from_utf8_lossy(&file.bytes).into());
    Value::Object(files.into_iter().map(text).collect::<Map<_, _>>())
}
