//! Summary, pictures and warnings of a table.

use super::outcome::{Outcome, RunOptions, no_result, put_notes, texts, with_summary};
use crate::error::{Error, ErrorKind};
use crate::files::{Counter, OutputFile, Provenance};
use crate::impact::Contact;
use crate::report::plot::Pictures;
use crate::report::plot::sweep::pictures;
use crate::report::text::checked::of_plan;
use crate::report::text::inputs::Inputs;
use crate::report::text::notes as report_notes;
use crate::report::text::overview::overview;
use crate::report::text::plan::plan_lines;
use crate::report::text::sweep::{found, lines};
use crate::scenario::Scenario;
use crate::scenario::plan::Plan;
use crate::scenario::scene::strength_notes;
use crate::table::caution::{Corners, at_corners};
use crate::table::job::in_order;
use crate::table::{Evaluator, Rows, Tally, count};

pub(super) fn check(scenario: &Scenario) -> Result<Outcome, Error> {
    let plan = scenario.plan()?;
    let contact = plan.input.contact().map_err(|error| no_result(scenario, &error))?;
    let Cautions { warnings, notes } = cautions(&plan, Some(&contact));
    let text = plan_lines(&plan) + &overview(&plan.input, &contact, &notes);
    Ok(Outcome { notes, ..Outcome::checked(warnings, text, of_plan(&plan, &contact)) })
}

/// All rows of a table, in memory. On any thread `encode` makes a piece of some rows, and `take` gets the pieces in order.
///
/// # Errors
/// [`Error`] of the kind `Stopped` if the progress is asked to stop.
pub fn rows<P: Send>(
    plan: &Plan,
    progress: &Counter,
    encode: impl Fn(&Rows) -> P + Sync + Send,
    mut take: impl FnMut(P) + Send,
) -> Result<Tally, Error> {
    let step = if plan.microseconds() > SLOW { 16 } else { 1024 };
    let evaluator = Evaluator::new(plan);
    let mut tally = Tally::new(plan);
    let with_statistics = plan.statistics_columns();
    let make = |piece: u64| {
        if progress.is_stopped() {
            return Err(Error::new(ErrorKind::Stopped(130), "the table was stopped"));
        }
        let mut rows = Rows::default();
        evaluator.rows(piece * step..plan.count().min((piece + 1) * step), &mut rows);
        let counts: Vec<_> = rows.results.iter().map(|row| count(row, &with_statistics)).collect();
        Ok((encode(&rows), counts))
    };
    in_order(0..plan.count().div_ceil(step), make, |(piece, counts)| {
        take(piece);
        for count in counts {
            tally.push(count);
        }
        Ok(())
    })?;
    Ok(tally)
}

/// Rows that take longer than this \[µs\] are made a few at a time, so that a stop is heard soon.
const SLOW: f64 = 100.0;

/// The outcome of a whole table with this tally, and with the file of the table where it is one of the results.
pub fn outcome(
    scenario: &Scenario,
    plan: &Plan,
    tally: &Tally,
    options: &RunOptions,
    table: Option<OutputFile>,
) -> Result<Outcome, Error> {
    let cautions = cautions(plan, None);
    let names = table.iter().map(|file| file.name.clone()).collect();
    let provenance = Provenance { files: names, ..scenario.provenance(options.command) };
    let mut files = files(plan, tally, &cautions, provenance, options.pictures)?;
    files.extend(table);
    let text = table_text(plan, tally, &cautions);
    let Cautions { warnings, notes } = cautions;
    Ok(Outcome { notes, ..Outcome::done(warnings, text, files) })
}

/// The text of a finished table, with the notes.
pub fn table_text(plan: &Plan, tally: &Tally, cautions: &Cautions) -> String {
    lines(plan, tally) + &report_notes(&cautions.notes)
}

/// Warnings and notes on a table, before its rows are computed.
#[derive(Debug, Clone)]
pub struct Cautions {
    pub warnings: Vec<String>,
    /// Notes on the strength and on the exponent behind e.
    pub notes: Vec<String>,
}

/// The warnings and the notes about a table of this plan; `known` is its contact, if that is made already.
pub fn cautions(plan: &Plan, known: Option<&Contact>) -> Cautions {
    let Corners { warnings, has_dent } = at_corners(plan, known);
    let own = if has_dent && known.is_none() { plan.input.contact().ok() } else { None };
    let notes = known.or(own.as_ref()).map(|contact| strength_notes(&plan.input, contact, has_dent, &plan.paths()));
    Cautions { warnings: with_warnings_of_plan(warnings, plan), notes: notes.unwrap_or_default() }
}

/// The warnings alone, for callers that show no notes.
pub fn warnings(plan: &Plan, known: Option<&Contact>) -> Vec<String> {
    with_warnings_of_plan(at_corners(plan, known).warnings, plan)
}

fn with_warnings_of_plan(at_corners: Vec<String>, plan: &Plan) -> Vec<String> {
    [at_corners, texts(&plan.warnings)].concat()
}

/// `summary.json`, which repeats warnings and notes, and the pictures of a whole table. Its own file is in the provenance.
pub fn files(
    plan: &Plan,
    tally: &Tally,
    cautions: &Cautions,
    provenance: Provenance,
    format: Pictures,
) -> Result<Vec<OutputFile>, Error> {
    let pictures = format.files(|| Ok(pictures(plan, tally)))?;
    let mut results = found(plan, tally, &cautions.warnings);
    put_notes(&mut results, &cautions.notes);
    with_summary(pictures, provenance, results, &Inputs::of_plan(plan))
}
