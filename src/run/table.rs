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
use crate::report::strength;
use crate::report::sweep::summary;
use crate::scenario::Scenario;
use crate::sweep::caution::at_corners;
use crate::sweep::count::Tally;

pub(super) fn check(scenario: &Scenario) -> Result<Outcome, Error> {
    let plan = plan(scenario)?;
    let contact = plan.scene.contact().map_err(|error| no_result(scenario, &error))?;
    let (warnings, depth) = cautions(&plan, Some(&contact));
    let strength = strength::which(&plan.scene.half_space, plan.scene.has_flow(), depth);
    let text = plan_lines(&plan) + &overview(&plan.scene, &contact) + &strength.unwrap_or_default();
    Ok(Outcome::checked(warnings, text))
}

/// The plan of a scenario that is a table.
pub fn plan(scenario: &Scenario) -> Result<Plan, Error> {
    let none = || Error::input("the scenario has neither [sweep] nor [monte_carlo]".to_owned());
    scenario.plan()?.ok_or_else(none)
}

/// The warnings about a table of this plan.
pub fn warnings(plan: &Plan) -> Vec<String> {
    cautions(plan, None).0
}

/// The same where the contact of the plan is known.
pub fn warnings_of(plan: &Plan, contact: &Contact) -> Vec<String> {
    cautions(plan, Some(contact)).0
}

/// The warnings, and the largest peak indentation over the radius of the sphere.
fn cautions(plan: &Plan, known: Option<&Contact>) -> (Vec<String>, f64) {
    let (cautions, depth) = at_corners(plan, known);
    ([texts(&plan.scene.warnings), cautions].concat(), depth)
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
