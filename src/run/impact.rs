//! One impact.

use super::outcome::{self, Order, Outcome, file, no_result, texts, with_summary};
use crate::error::Error;
use crate::impact::{Contact, Impact, ImpactError, Method};
use crate::plot;
use crate::provenance::{MethodOf, Provenance};
use crate::report::inputs::Inputs;
use crate::report::overview::overview;
use crate::report::{summary, table, trace};
use crate::scenario::Scenario;
use crate::scene::Scene;

/// The scene of a scenario, its contact and the impact with all warnings; `samples` are the rows of the trace, if there is
/// to be one.
pub fn compute(scenario: &Scenario, samples: Option<usize>) -> Result<(Scene, Contact, Impact), Error> {
    let (scene, contact) = prepare(scenario)?;
    can_be_traced(scenario, &scene)?;
    let impact = contact.impact(scene.approach_at(scene.speed), &scene.solver, samples);
    let mut impact = impact.map_err(|reason| no_result(scenario, &reason))?;
    impact.warnings.extend_from_slice(&scene.warnings);
    Ok((scene, contact, impact))
}

/// The scene of a scenario and its contact.
pub fn prepare(scenario: &Scenario) -> Result<(Scene, Contact), Error> {
    scenario.refuse_columns("one impact")?;
    let scene = scenario.resolve()?;
    let contact = scene.contact().map_err(|error| no_result(scenario, &error))?;
    Ok((scene, contact))
}

/// Refuses a method without a trace, which a run writes.
pub(super) fn can_be_traced(scenario: &Scenario, scene: &Scene) -> Result<(), Error> {
    let method = scene.solver.method.chosen(&scene.forces, true);
    method.map(drop).ok_or_else(|| no_result(scenario, &ImpactError::NoClosedForm))
}

/// The provenance of results that were computed by this method.
pub(super) fn provenance(scenario: &Scenario, scene: &Scene, method: Method, command: &str) -> Provenance {
    let method = Some(MethodOf { method: method.name(), tolerance: scene.solver.tolerance });
    let can_yield = scene.half_space.yield_strength.is_some();
    Provenance { method, ..outcome::provenance(scenario, &scene.law, can_yield, command) }
}

pub(super) fn check(scenario: &Scenario) -> Result<Outcome, Error> {
    let (scene, contact, impact) = compute(scenario, None)?;
    Ok(Outcome::checked(texts(&impact.warnings), overview(&scene, &contact)))
}

pub(super) fn run(scenario: &Scenario, order: &Order) -> Result<Outcome, Error> {
    let (scene, contact, impact) = compute(scenario, Some(scenario.as_given().samples))?;
    let provenance = provenance(scenario, &scene, impact.method, order.command);
    let mut files = vec![file("trace.csv", trace(&impact)?)];
    files.extend(order.pictures.files(|| {
        let mut drawn =
            vec![("force_indentation", plot::force_indentation(&impact)?), ("history", plot::history(&impact)?)];
        drawn.extend(plot::friction(&impact).map(|friction| ("friction", friction)));
        let caption = plot::caption::caption(&scene, &[]);
        Ok(drawn.into_iter().map(|(name, chart)| (name, chart.with_caption(caption.as_str()))).collect())
    })?);
    let files = with_summary(files, provenance, |of| summary(&contact, &impact, &Inputs::of(&scene), of))?;
    Ok(Outcome::done(texts(&impact.warnings), table(&contact, &impact), files))
}
