//! One impact.

use super::outcome::{self, Outcome, RunOptions, file, no_result, texts, with_summary};
use crate::error::Error;
use crate::files::{MethodOf, Provenance};
use crate::impact::{Contact, Impact, ImpactError, Method};
use crate::report::plot;
use crate::report::plot::{caption, captioned};
use crate::report::text::checked::of_contact;
use crate::report::text::inputs::Inputs;
use crate::report::text::overview::overview;
use crate::report::text::{table, trace};
use crate::scenario::Scenario;
use crate::scenario::scene::results::fields;
use crate::scenario::scene::results::impact::{Single, results};
use crate::scenario::scene::{Input, Purpose, restitution_interval, strength_notes};

/// The input of a scenario, its contact and the impact with all warnings; `samples` are the rows of the trace, if there is
/// to be one.
pub fn compute(scenario: &Scenario, samples: Option<usize>) -> Result<(Input, Contact, Impact), Error> {
    let (input, contact) = prepare(scenario)?;
    can_be_traced(scenario, &input)?;
    let refuse = |reason| no_result(scenario, &reason);
    // the strength is that of this speed from here on
    let [speed, _] = input.approach().components();
    let contact = contact.at_speed(speed).map_err(refuse)?;
    let mut impact = contact.impact(input.approach(), &input.solver(), samples).map_err(refuse)?;
    impact.warnings.extend(scenario.without_effect(std::slice::from_ref(&input), Purpose::Impact));
    impact.warnings.extend(input.flight_warnings());
    Ok((input, contact, impact))
}

pub fn prepare(scenario: &Scenario) -> Result<(Input, Contact), Error> {
    scenario.refuse_columns()?;
    let input = scenario.resolve()?;
    let contact = input.contact().map_err(|error| no_result(scenario, &error))?;
    Ok((input, contact))
}

/// Refuses a method without a trace, which a run writes.
pub(super) fn can_be_traced(scenario: &Scenario, input: &Input) -> Result<(), Error> {
    let method = input.solver().method.chosen(&input.forces(), true);
    method.map(drop).ok_or_else(|| no_result(scenario, &ImpactError::NoClosedForm))
}

/// The provenance of results that were computed by this method.
pub(super) fn provenance(scenario: &Scenario, input: &Input, method: Method, command: &str) -> Provenance {
    let method = Some(MethodOf { method: method.name(), tolerance: input.solver().tolerance });
    Provenance { method, ..outcome::provenance(scenario, &input.law(), input.can_yield(), command) }
}

pub(super) fn outcome(scenario: &Scenario, options: Option<&RunOptions>) -> Result<Outcome, Error> {
    let (input, contact, impact) = compute(scenario, options.map(|_| scenario.input().samples()))?;
    let notes = strength_notes(&input, &contact, impact.has_dent(), &[]);
    let Some(options) = options else {
        let (text, checked) = (overview(&input, &contact, &notes), of_contact(&input, &contact));
        return Ok(Outcome { notes, ..Outcome::checked(texts(&impact.warnings), text, checked) });
    };
    let provenance = provenance(scenario, &input, impact.method, options.command);
    let mut files = vec![file("trace.csv", trace(&impact)?)];
    files.extend(options.pictures.files(|| {
        let mut drawn =
            vec![("force_indentation", plot::force_indentation(&impact)?), ("history", plot::history(&impact)?)];
        drawn.extend(plot::friction(&impact).map(|friction| ("friction", friction)));
        Ok(captioned(drawn, &caption(&input, &[])))
    })?);
    let interval = restitution_interval(&input, &contact, impact.speed, &impact.essentials);
    let drop_height = input.drop_height();
    let single = Single { contact: &contact, impact: &impact, interval: interval.as_ref(), notes: &notes, drop_height };
    let files = with_summary(files, provenance, fields(&results(), &single), &Inputs::new(&input))?;
    let text = table(&single, options.detail);
    Ok(Outcome { notes, ..Outcome::done(texts(&impact.warnings), text, files) })
}
