//! The output files of a comparison.

use crate::compare::Comparison;
use crate::error::Error;
use crate::output::OutputFile;
use crate::plot::compare::picture;
use crate::report::compare::{csv, summary};
use crate::scenario::Scenario;

/// All files of a comparison.
///
/// # Errors
/// [`Error`] of reports and pictures.
pub fn files(comparison: &Comparison, scenario: &Scenario, command: &str) -> Result<Vec<OutputFile>, Error> {
    let summary = summary(comparison, scenario, scenario.sha256()?, command)?;
    let file = |name: &str, bytes| OutputFile { name: name.to_owned(), bytes };
    Ok(vec![
        file("summary.json", summary.into_bytes()),
        file("comparison.csv", csv(comparison)?),
        file("unloading.png", picture(comparison)?),
    ])
}
