//! A comparison of unloading laws.

use super::outcome::{Order, Outcome, file, texts};
use crate::error::Error;
use crate::output::SUMMARY;
use crate::plot;
use crate::report::compare as report;
use crate::scenario::Scenario;
use crate::scene::results::compare::rows;

pub(super) fn check(scenario: &Scenario) -> Result<Outcome, Error> {
    let comparison = scenario.comparison()?;
    let text = report::state(&comparison) + "\n" + &report::overview(scenario, &comparison);
    Ok(Outcome::checked(texts(&comparison.warnings), text))
}

pub(super) fn run(scenario: &Scenario, order: &Order) -> Result<Outcome, Error> {
    let comparison = scenario.comparison()?;
    let inputs = report::inputs(scenario);
    let provenance = scenario.provenance(order.command);
    let warnings = texts(&comparison.warnings);
    let rows = rows(&comparison);
    let mut files = vec![
        file(SUMMARY, report::summary(&comparison, &rows, &warnings, &inputs, &provenance)?),
        file("comparison.csv", report::csv(&rows)?),
    ];
    files.extend(order.pictures.files(|| Ok(vec![("unloading", plot::compare::picture(&comparison))]))?);
    Ok(Outcome::done(warnings, report::table(&comparison, &rows), files))
}
