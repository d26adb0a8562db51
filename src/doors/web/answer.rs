//! The result of a scenario as JSON.

use serde_json::{Value, json};

use super::curve::curve;
use super::rows::{rows_of, texts};
use crate::error::Error;
use crate::files::OutputFile;
use crate::files::progress::Counter;
use crate::report::plot::Pictures;
use crate::report::run::{Outcome, RunOptions, at_once, table};
use crate::report::text::Detail;
use crate::scenario::{Kind, Scenario};

/// The most rows of a table, which is held in memory.
const MOST_ROWS: u64 = 100_000;

/// Runs a scenario of any kind.
pub fn run(scenario: &Scenario, pictures: Pictures) -> Result<Value, Error> {
    let kind = scenario.kind()?;
    let command = format!("{} in a web page: run {}", env!("CARGO_PKG_NAME"), scenario.document.name());
    let order = RunOptions { command: &command, detail: Detail::Whole, pictures, progress: &Counter::default() };
    let Outcome { warnings, text, files, contradiction, .. } = match at_once(scenario, Some(&order))? {
        Some(outcome) => outcome,
        None => of_table(scenario, &order)?,
    };
    let curve = if kind == Kind::Impact { curve(scenario, pictures)? } else { None };
    Ok(json!({
        "kind": kind.name(),
        "warnings": warnings,
        "text": text,
        "contradiction": contradiction,
        "files": texts(files),
        "curve": curve
    }))
}

fn of_table(scenario: &Scenario, order: &RunOptions) -> Result<Outcome, Error> {
    let plan = scenario.plan()?;
    let rows = plan.count();
    if rows > MOST_ROWS {
        let key = if plan.is_monte_carlo() { "monte_carlo" } else { "sweep" };
        let message =
            format!("a table of {rows} rows: a page computes at most {MOST_ROWS}; ask for fewer, or use the command");
        return Err(scenario.document.refuse(key, message));
    }
    let (csv, tally) = rows_of(&plan)?;
    let table = OutputFile { name: "table.csv".to_owned(), bytes: csv };
    table::outcome(scenario, &plan, &tally, order, Some(table))
}
