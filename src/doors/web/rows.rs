//! The rows of a table, in memory, and files as JSON.

use serde_json::{Map, Value};

use crate::error::Error;
use crate::files::OutputFile;
use crate::files::progress::Counter;
use crate::report::run::table;
use crate::scenario::plan::Plan;
use crate::table::count::Tally;
use crate::table::csv::Csv;
use crate::table::evaluator::Rows;

/// The table as CSV, and what its rows add up to.
pub fn rows_of(plan: &Plan) -> Result<(Vec<u8>, Tally), Error> {
    let form = Csv::new(plan);
    let encode = |rows: &Rows| {
        let mut piece = Vec::new();
        form.write(rows, &mut piece);
        piece
    };
    let mut text = (plan.column_names().join(",") + "\n").into_bytes();
    let tally = table::rows(plan, &Counter::default(), encode, |piece| text.extend(piece))?;
    Ok((text, tally))
}

/// The texts of files, by their names.
pub fn texts(files: Vec<OutputFile>) -> Value {
    let text = |file: OutputFile| (file.name, String::from_utf8_lossy(&file.bytes).into());
    Value::Object(files.into_iter().map(text).collect::<Map<_, _>>())
}
