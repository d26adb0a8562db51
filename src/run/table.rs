//! Summary, pictures and warnings of a table.

use super::outcome::{Outcome, file, no_result, texts};
use crate::error::Error;
use crate::impact::Contact;
use crate::output::{OutputFile, SUMMARY};
use crate::plan::Plan;
use crate::plot::Pictures;
use crate::plot::sweep::pictures;
use crate::provenance::Provenance;
use crate::report::overview::overview;
use crate::report::plan::plan_lines;
use crate::report::sweep::summary;
use crate::scenario::Scenario;
use crate::sweep::caution::at_corners;
use crate::sweep::count::Tally;

pub(super) fn check(scenario: &Scenario) -> Result<Outcome, Error> {
    let plan = plan(scenario)?;
    let contact = plan.scene.contact().map_err(|error| no_result(scenario, &error))?;
    Ok(Outcome::checked(warnings_of(&plan, &contact), plan_lines(&plan) + &overview(&plan.scene, &contact)))
}

/// The plan of a scenario that is a table.
pub fn plan(scenario: &Scenario) -> Result<Plan, Error> {
    let none = || Error::input("the scenario has neither [sweep] nor [monte_carlo]".to_owned());
    scenario.plan()?.ok_or_else(none)
}

/// The warnings about a table of this plan.
pub fn warnings(plan: &Plan) -> Vec<String> {
    [at_corners(plan, None), texts(&plan.scene.warnings)].concat()
}

/// The same where the contact of the plan is known.
pub fn warnings_of(plan: &Plan, contact: &Contact) -> Vec<String> {
    [at_corners(plan, Some(contact)), texts(&plan.scene.warnings)].concat()
}

/// `summary.json`, which repeats the `warnings`, and the pictures of a whole table.
pub fn files(
    plan: &Plan,
    tally: &Tally,
    warnings: &[String],
    provenance: &Provenance,
    format: Pictures,
) -> Result<Vec<OutputFile>, Error> {
    let mut files = vec![file(SUMMARY, summary(plan, tally, warnings, provenance)?)];
    files.extend(format.files(|| Ok(pictures(plan, tally)))?);
    Ok(files)
}
