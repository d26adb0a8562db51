//! What stands beside a table, be it written at once or merged from shards.

use crate::error::Error;
use crate::output::OutputFile;
use crate::plan::Plan;
use crate::plot::sweep::pictures;
use crate::report::sweep::{Provenance, summary};
use crate::sweep::caution::cautions;
use crate::sweep::sidecar::Tally;

/// The name of a table's summary.
pub const SUMMARY: &str = "summary.json";

/// What is doubtful in a table of this plan.
#[must_use]
pub fn warnings(plan: &Plan) -> Vec<String> {
    let of_scene = plan.scene.warnings.iter().map(ToString::to_string);
    of_scene.chain(cautions(plan)).collect()
}

/// `summary.json`, which repeats the `warnings` of the plan, and the pictures of a whole table.
///
/// # Errors
/// [`Error::Report`], [`Error::Plot`].
pub fn files(
    plan: &Plan,
    tally: &Tally,
    warnings: &[String],
    provenance: Provenance,
) -> Result<Vec<OutputFile>, Error> {
    let summary = summary(plan, tally, warnings, provenance)?;
    let mut files = vec![OutputFile { name: SUMMARY.to_owned(), bytes: summary.into_bytes() }];
    for (name, bytes) in pictures(plan, tally)? {
        files.push(OutputFile { name: name.to_owned(), bytes });
    }
    Ok(files)
}
