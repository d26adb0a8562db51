//! Summary, pictures and warnings of a table.

use super::outcome::{Outcome, RunOptions, output_file, put_notes, warning_texts, with_summary};
use crate::error::Error;
use crate::files::{OutputFile, Provenance};
use crate::impact::Contact;
use crate::report::chart::PictureFormat;
use crate::report::pictures::sweep::pictures;
use crate::report::pictures::traces::charts;
use crate::report::pictures::{caption, with_captions};
use crate::report::text::check::plan_fields;
use crate::report::text::inputs::Inputs;
use crate::report::text::overview::overview;
use crate::report::text::plan::plan_blocks;
use crate::report::text::sweep::{result_blocks, summary_fields};
use crate::report::text::traces::traces_csv;
use crate::report::text::{Block, note_blocks};
use crate::scenario::keys::strength_notes;
use crate::scenario::plan::Plan;
use crate::scenario::{Scenario, no_result_error};
use crate::table::Tally;
pub use crate::table::compute_rows;
use crate::table::corner_warnings::{CornerWarnings, corner_warnings};
use crate::table::traces::row_traces;

pub(super) fn check(scenario: &Scenario) -> Result<Outcome, Error> {
    let plan = scenario.plan()?;
    let contact = plan.input.contact().map_err(|error| no_result_error(scenario, &error))?;
    let TableWarnings { warnings, notes } = table_warnings(&plan, Some(&contact));
    let blocks = [plan_blocks(&plan), overview(&plan.input, &contact, &notes)].concat();
    Ok(Outcome { notes, ..Outcome::from_check(warnings, blocks, plan_fields(&plan, &contact)) })
}

/// The outcome of a whole table with this tally, and with the file of the table where it is one of the results.
pub fn summarise(
    scenario: &Scenario,
    plan: &Plan,
    tally: &Tally,
    options: &RunOptions,
    table: Option<OutputFile>,
) -> Result<Outcome, Error> {
    let warnings_and_notes = table_warnings(plan, None);
    let names = table.iter().map(|file| file.name.clone()).collect();
    let provenance = Provenance { files: names, ..scenario.provenance(options.command) };
    let mut files = files(plan, tally, &warnings_and_notes, provenance, options.pictures)?;
    files.extend(table);
    let blocks = table_blocks(plan, tally, &warnings_and_notes);
    let TableWarnings { warnings, notes } = warnings_and_notes;
    Ok(Outcome { notes, ..Outcome::from_run(warnings, blocks, files) })
}

/// The blocks about a finished table, with the notes.
pub fn table_blocks(plan: &Plan, tally: &Tally, warnings_and_notes: &TableWarnings) -> Vec<Block> {
    [result_blocks(plan, tally), note_blocks(&warnings_and_notes.notes)].concat()
}

/// Warnings and notes on a table, before its rows are computed.
#[derive(Debug, Clone)]
pub struct TableWarnings {
    pub warnings: Vec<String>,
    /// Notes on the strength and on the exponent behind e.
    pub notes: Vec<String>,
}

/// The warnings and the notes about a table of this plan; `known` is its contact, if that is made already.
pub fn table_warnings(plan: &Plan, known: Option<&Contact>) -> TableWarnings {
    let CornerWarnings { warnings, has_dent } = corner_warnings(plan, known);
    let own = if has_dent && known.is_none() { plan.input.contact().ok() } else { None };
    let contact = known.or(own.as_ref());
    let notes = contact.map(|contact| strength_notes(&plan.input, contact, has_dent, &plan.varied_paths()));
    TableWarnings { warnings: with_plan_warnings(warnings, plan), notes: notes.unwrap_or_default() }
}

/// The warnings alone, for callers that show no notes.
pub fn warnings_of_table(plan: &Plan, known: Option<&Contact>) -> Vec<String> {
    with_plan_warnings(corner_warnings(plan, known).warnings, plan)
}

fn with_plan_warnings(corners: Vec<String>, plan: &Plan) -> Vec<String> {
    [corners, warning_texts(&plan.warnings)].concat()
}

/// `summary.json`, which repeats warnings and notes, and the pictures of a whole table. Its own file is in the provenance.
pub fn files(
    plan: &Plan,
    tally: &Tally,
    warnings_and_notes: &TableWarnings,
    provenance: Provenance,
    format: PictureFormat,
) -> Result<Vec<OutputFile>, Error> {
    let traces = if plan.has_traces { row_traces(plan) } else { Vec::new() };
    let pictures = format.to_files(|| {
        let mut drawn = pictures(plan, tally);
        if !traces.is_empty() {
            drawn.extend(with_captions(charts(plan, &traces), &caption(&plan.input, &plan.varied_paths())));
        }
        Ok(drawn)
    })?;
    let mut files = Vec::new();
    if plan.has_traces {
        files.push(output_file("traces.csv", traces_csv(plan, &traces)?));
    }
    files.extend(pictures);
    let mut results = summary_fields(plan, tally, &warnings_and_notes.warnings);
    put_notes(&mut results, &warnings_and_notes.notes);
    with_summary(files, provenance, results, &Inputs::from_plan(plan))
}
