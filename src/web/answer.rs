//! The result of a scenario as JSON.

use serde_json::{Map, Value, json};

use super::curve::curve;
use crate::error::Error;
use crate::output::OutputFile;
use crate::plan::Plan;
use crate::plot::Pictures;
use crate::progress::Counter;
use crate::report::sweep::lines;
use crate::run::{Order, Outcome, Way, table, way};
use crate::scenario::{Kind, Scenario};
use crate::sweep::count::{Tally, count};
use crate::sweep::csv::Csv;
use crate::sweep::evaluator::{Evaluator, Rows};

/// The most rows of a table, which is held in memory.
const MOST_ROWS: u64 = 100_000;
/// Rows that are computed at a time.
const BATCH: u64 = 1024;

/// Runs a scenario of any kind.
pub fn run(scenario: &Scenario) -> Result<Value, Error> {
    let kind = scenario.kind()?;
    let command = format!("{} in a web page: run {}", env!("CARGO_PKG_NAME"), scenario.document.name());
    let Outcome { warnings, text, files, contradiction } = match way(kind) {
        Way::Once { run, .. } => {
            run(scenario, &Order { command: &command, pictures: Pictures::Svg, progress: &Counter::default() })?
        }
        Way::Table => of_table(scenario, &command)?,
    };
    let curve = if kind == Kind::Impact { curve(scenario)? } else { None };
    let files = files.into_iter().map(|file| (file.name, String::from_utf8_lossy(&file.bytes).into()));
    Ok(json!({
        "kind": kind.name(),
        "warnings": warnings,
        "text": text,
        "contradiction": contradiction,
        "files": files.collect::<Map<_, _>>(),
        "curve": curve
    }))
}

fn of_table(scenario: &Scenario, command: &str) -> Result<Outcome, Error> {
    let plan = table::plan(scenario)?;
    let rows = plan.count();
    if rows > MOST_ROWS {
        let key = if plan.is_monte_carlo() { "monte_carlo" } else { "sweep" };
        let message =
            format!("a table of {rows} rows: a page computes at most {MOST_ROWS}; ask for fewer, or use the command");
        return Err(scenario.document.refuse(key, message));
    }
    let warnings = table::warnings(&plan);
    let (csv, tally) = rows_of(&plan);
    let provenance = scenario.provenance(command);
    let mut files = table::files(&plan, &tally, &warnings, &provenance, Pictures::Svg)?;
    files.push(OutputFile { name: "table.csv".to_owned(), bytes: csv });
    Ok(Outcome { warnings, text: lines(&tally), files, contradiction: None })
}

/// The table as CSV, and what its rows add up to.
fn rows_of(plan: &Plan) -> (Vec<u8>, Tally) {
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
