//! From the scenario of the options to its outcome, in memory.

use plm_impact::error::Error;
use plm_impact::files::{Progress, SUMMARY_FILE};
use plm_impact::report::chart::PictureFormat;
use plm_impact::report::run::table::{compute_rows, summarise};
use plm_impact::report::run::{Outcome, RunOptions};
use plm_impact::report::text::Detail;
use plm_impact::scenario::Scenario;
use serde_json::Value;

use super::super::output::command_line;
use super::super::request::run_whole;
use super::scenario_text::OPTIONS;

pub fn read(text: &str) -> Result<Scenario, Error> {
    Scenario::from_text(&OPTIONS.scenario_name(), text, &[]).map_err(|error| OPTIONS.error_at_options(error))
}

/// The outcome of a scenario of any kind. A table is computed in memory.
pub fn compute(scenario: &Scenario, pictures: PictureFormat) -> Result<Outcome, Error> {
    let (command, progress) = (command_line(), Progress::default());
    let options = RunOptions { command: &command, detail: Detail::Brief, pictures, progress: &progress };
    let outcome = || {
        if !scenario.kind()?.is_table() {
            return run_whole(scenario, &options);
        }
        let plan = scenario.plan()?;
        let tally = compute_rows(&plan, &progress, |_| (), |()| ())?;
        summarise(scenario, &plan, &tally, &options, None)
    };
    outcome().map_err(|error| OPTIONS.error_at_options(error))
}

/// The summary of an outcome.
pub fn summary(outcome: &Outcome) -> Option<Value> {
    let file = outcome.files.iter().find(|file| file.name == SUMMARY_FILE)?;
    serde_json::from_slice(&file.bytes).ok()
}
