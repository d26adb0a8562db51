//! One impact.

use super::outcome::{self, Outcome, RunOptions, output_file, warning_texts, with_summary};
use crate::error::Error;
use crate::files::{MethodProvenance, Provenance};
use crate::impact::{Contact, Impact, ImpactError, Method, Pulse, PulseError, Warning};
use crate::report::pictures;
use crate::report::pictures::{caption, with_captions};
use crate::report::text::check::contact_fields;
use crate::report::text::inputs::Inputs;
use crate::report::text::overview::overview;
use crate::report::text::{impact_blocks, pulse_csv, spectrum_csv, trace_csv};
use crate::results::impact::{SingleImpact, impact_results};
use crate::results::to_fields;
use crate::scenario::input::Input;
use crate::scenario::keys::{dent_interval, restitution_interval, strength_notes};
use crate::scenario::{Kind, Scenario, no_result_error};

/// The input of a scenario, its contact and the impact with all warnings; `samples` are the rows of the trace, if there is
/// to be one.
pub fn compute(scenario: &Scenario, samples: Option<usize>) -> Result<(Input, Contact, Impact), Error> {
    let (input, contact) = prepare(scenario)?;
    check_trace_method(scenario, &input)?;
    let refuse = |reason| no_result_error(scenario, &reason);
    // the strength is that of this speed from here on
    let speed = input.approach().normal;
    let contact = contact.at_speed(speed).map_err(refuse)?.into_owned();
    let mut impact = contact.impact(input.approach(), &input.solver(), samples).map_err(refuse)?;
    impact.warnings.extend(scenario.unused_key_warnings(std::slice::from_ref(&input), Kind::Impact));
    impact.warnings.extend(input.flight_warnings());
    Ok((input, contact, impact))
}

pub fn prepare(scenario: &Scenario) -> Result<(Input, Contact), Error> {
    scenario.refuse_columns()?;
    scenario.resolve_contact()
}

/// Refuses a method without a trace, which a run writes.
pub(super) fn check_trace_method(scenario: &Scenario, input: &Input) -> Result<(), Error> {
    let method = input.solver().method.resolve(&input.forces(), true);
    method.map(drop).ok_or_else(|| no_result_error(scenario, &ImpactError::NoClosedForm))
}

/// The provenance of results that were computed by this method.
pub(super) fn provenance(scenario: &Scenario, input: &Input, method: Method, command: &str) -> Provenance {
    let method = Some(MethodProvenance { method: method.name(), tolerance: input.solver().tolerance });
    Provenance { method, ..outcome::provenance(scenario, &input.law(), input.can_yield(), command) }
}

/// The pulse of an impact at this speed \[m/s\] normal to the surface, if the scenario asks for one; a captured sphere has none.
pub fn compute_pulse(
    scenario: &Scenario,
    input: &Input,
    contact: &Contact,
    speed: f64,
) -> Result<Option<Pulse>, Error> {
    let Some(request) = input.pulse() else { return Ok(None) };
    match contact.pulse(speed, &input.solver(), &request) {
        Ok(pulse) => Ok(Some(pulse)),
        Err(PulseError::Captured) => Ok(None),
        Err(PulseError::Impact(reason)) => Err(no_result_error(scenario, &reason)),
        Err(reason) => Err(scenario.document.refusal("output.pulse.step", reason.to_string())),
    }
}

pub(super) fn run(scenario: &Scenario, options: Option<&RunOptions>) -> Result<Outcome, Error> {
    let (input, contact, mut impact) = compute(scenario, options.map(|_| scenario.input().samples()))?;
    let pulse = compute_pulse(scenario, &input, &contact, input.approach().normal)?;
    if pulse.is_none() && input.pulse().is_some() {
        impact.warnings.push(Warning::unused_key("output.pulse", &PulseError::Captured.to_string()));
    }
    let notes = strength_notes(&input, &contact, impact.row.has_dent(), &[]);
    let Some(options) = options else {
        let (blocks, checked) = (overview(&input, &contact, &notes), contact_fields(&input, &contact));
        return Ok(Outcome { notes, ..Outcome::from_check(warning_texts(&impact.warnings), blocks, checked) });
    };
    let provenance = provenance(scenario, &input, impact.method, options.command);
    let (inputs, caption) = (Inputs::new(&input), caption(&input, &[]));
    let interval = restitution_interval(&input, &contact, impact.speed, &impact.row);
    let drop_height = input.drop_height();
    let peened = impact.row.peened.filter(|_| interval.is_some());
    let dent_interval = peened.and_then(|_| dent_interval(&input, &contact, impact.speed, &impact.row));
    let single = SingleImpact {
        contact: &contact,
        impact: &impact,
        interval: interval.as_ref(),
        dent_interval: dent_interval.as_ref(),
        notes: &notes,
        drop_height,
        pulse: pulse.as_ref(),
    };
    let mut files = vec![output_file("trace.csv", trace_csv(&impact)?)];
    if let Some(pulse) = &pulse {
        files.push(output_file("pulse.csv", pulse_csv(pulse)?));
        files.push(output_file("spectrum.csv", spectrum_csv(pulse)?));
    }
    files.extend(options.pictures.to_files(|| {
        let mut drawn = vec![
            ("force_indentation", pictures::force_indentation(&impact)?),
            ("history", pictures::history(&impact)?),
        ];
        drawn.extend(pictures::friction(&impact).map(|friction| ("friction", friction)));
        if let Some(pulse) = &pulse {
            drawn
                .extend([("pulse", pictures::pulse(&impact, pulse)), ("spectrum", pictures::spectrum(&impact, pulse))]);
        }
        Ok(with_captions(drawn, &caption))
    })?);
    let files = with_summary(files, provenance, to_fields(&impact_results(), &single), &inputs)?;
    let blocks = impact_blocks(&single, options.detail);
    Ok(Outcome { notes, ..Outcome::from_run(warning_texts(&impact.warnings), blocks, files) })
}
