//! The result of a scenario as JSON, with its files. An impact has a curve beside it: e against its speed or its drop height, with the
//! impact as a point on the curve.

use serde_json::{Map, Value, json};

use crate::error::Error;
use crate::files::{OutputFile, Progress};
use crate::numerics::functions::log10;
use crate::report::chart::{PictureFormat, Series, Style};
use crate::report::pictures::sweep::pictures;
use crate::report::run::{Outcome, RunOptions, impact, run as run_scenario, table};
use crate::report::text::{Block, Detail};
use crate::results::RESTITUTION;
use crate::scenario::keys::key;
use crate::scenario::plan::Plan;
use crate::scenario::{Kind, Scenario};
use crate::table::Tally;
use crate::table::format::csv::CsvEncoder;
use crate::units::format_four_digits;

/// The most rows of a table, which is held in memory.
const MAX_ROWS: u64 = 100_000;
const POINTS: usize = 601;
/// The decades of the curve below, and also above, the power of ten at or below the impact.
const DECADES: f64 = 2.0;

/// Runs a scenario of any kind.
pub fn run(scenario: &Scenario, pictures: PictureFormat) -> Result<Value, Error> {
    let kind = scenario.kind()?;
    let command = format!("{} in a web page: run {}", env!("CARGO_PKG_NAME"), scenario.document.name());
    let options = RunOptions { command: &command, detail: Detail::Full, pictures, progress: &Progress::default() };
    let Outcome { warnings, mut blocks, files, contradiction, .. } = match run_scenario(scenario, Some(&options))? {
        Some(outcome) => outcome,
        None => table_outcome(scenario, &options)?,
    };
    // the page has distances of its own
    blocks.retain(|block| *block != Block::EmptyLine);
    let curve = if kind == Kind::Impact { curve(scenario, pictures)? } else { None };
    Ok(json!({
        "kind": kind.name(),
        "warnings": warnings,
        "blocks": blocks,
        "contradiction": contradiction,
        "files": file_texts(files),
        "curve": curve
    }))
}

fn table_outcome(scenario: &Scenario, options: &RunOptions) -> Result<Outcome, Error> {
    let plan = scenario.plan()?;
    let rows = plan.n_cases();
    if rows > MAX_ROWS {
        let key = if plan.is_monte_carlo() { "monte_carlo" } else { "sweep" };
        let message = format!(
            "the page is limited to {MAX_ROWS} rows, and {rows} are requested. Use fewer rows, or the command line."
        );
        return Err(scenario.document.refusal(key, message));
    }
    let (csv, tally) = table_csv(&plan)?;
    let table = OutputFile { name: "table.csv".to_owned(), bytes: csv };
    table::summarise(scenario, &plan, &tally, options, Some(table))
}

/// The picture in this format, if pictures are wanted, and its points as CSV; `None` for a sphere that is released at first contact.
fn curve(scenario: &Scenario, format: PictureFormat) -> Result<Option<Value>, Error> {
    let (input, _, impact) = impact::compute(scenario, None)?;
    let (key, at) = match input.number(key!("impact.drop_height")) {
        Some(height) => ("impact.drop_height", height),
        None => ("impact.speed", input.speed()),
    };
    if at <= 0.0 {
        return Ok(None);
    }
    let decade = log10(at).floor();
    let axis =
        format!("sweep.\"{key}\"={{ logspace = [1e{}, 1e{}], points = {POINTS} }}", decade - DECADES, decade + DECADES);
    let mut plan = scenario.to_table([axis])?.plan()?;
    plan.columns = Some(vec![RESTITUTION]);
    let mut files = Vec::new();
    if format != PictureFormat::None {
        let Some((_, mut chart)) = pictures(&plan, &Tally::new(&plan)).into_iter().next() else { return Ok(None) };
        let point = Series::points("this impact", vec![(at, impact.row.restitution)]).with_style(Style::BLACK);
        let point = point.with_note(format!("e = {}", format_four_digits(impact.row.restitution)));
        chart.panels.iter_mut().for_each(|panel| panel.series.push(point.clone()));
        "Restitution of the same bodies".clone_into(&mut chart.title);
        files.extend(format.to_file("restitution", &chart)?);
    }
    files.push(OutputFile { name: "restitution.csv".to_owned(), bytes: table_csv(&plan)?.0 });
    Ok(Some(file_texts(files)))
}

/// The table as CSV, and what its rows add up to.
fn table_csv(plan: &Plan) -> Result<(Vec<u8>, Tally), Error> {
    let encoder = CsvEncoder::new(plan);
    let mut text = (plan.column_names().join(",") + "\n").into_bytes();
    let tally = table::compute_rows(
        plan,
        &Progress::default(),
        |rows| encoder.rows_as_lines(rows),
        |piece| text.extend(piece),
    )?;
    Ok((text, tally))
}

/// The texts of files, by their names.
fn file_texts(files: Vec<OutputFile>) -> Value {
    let text = |file: OutputFile| (file.name, String::from_utf8_lossy(&file.bytes).into());
    Value::Object(files.into_iter().map(text).collect::<Map<_, _>>())
}
