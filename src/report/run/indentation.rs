//! Slow indentations.

use std::fmt::Display;

use super::outcome::{self, Outcome, RunOptions, output_file, put_notes, warning_texts, with_summary};
use crate::contact::body::Sphere;
use crate::error::{Error, ErrorKind};
use crate::impact::indentation::{IndentationError, SpecimenResult, StaticContact};
use crate::impact::{elastic_material_warning, half_space_warnings, sphere_warnings};
use crate::report::pictures;
use crate::report::pictures::caption::indentation_caption;
use crate::report::text::indentation as report;
use crate::report::text::note_blocks;
use crate::scenario::Scenario;
use crate::scenario::input::Body;
use crate::scenario::kinds::indentation::IndentationRequest;

/// The scene of a scenario, the results of every half-space, and all warnings; `samples` are the rows of the trace in each
/// step, if there is to be one.
pub fn compute(
    scenario: &Scenario,
    samples: Option<usize>,
) -> Result<(IndentationRequest, Vec<SpecimenResult>, Vec<String>), Error> {
    let scene = scenario.indentation()?;
    let mut warnings = warning_texts(&scene.warnings);
    let Sphere { radius, material, yield_strength, .. } = scene.sphere;
    warnings.extend(sphere_warnings(radius, &material, yield_strength, None).map(|warning| warning.to_string()));
    let mut tested = Vec::new();
    for specimen in &scene.specimens {
        let name = specimen.name.as_deref();
        let contact = StaticContact::try_new(&scene.sphere, &specimen.half_space, scene.law.as_contact_law());
        let contact = contact.map_err(|reason| indentation_error(scenario, None, reason))?;
        let indentation =
            contact.indent(&scene.targets, samples).map_err(|reason| indentation_error(scenario, name, reason))?;
        let named = |warning: &dyn Display| {
            specimen.name.as_ref().map_or_else(|| warning.to_string(), |name| format!("{name}, {warning}"))
        };
        warnings.extend(half_space_warnings(&specimen.half_space).map(|warning| named(&warning)));
        let material = scenario.input().materials().iter().find(|choice| choice.body == Body::HalfSpace);
        let elastic = material.and_then(|choice| elastic_material_warning(&specimen.half_space, choice.material));
        warnings.extend(elastic.map(|warning| warning.to_string()));
        warnings.extend(indentation.warnings.iter().map(|warning| named(warning)));
        let (pair, can_yield, is_spring) = (*contact.pair(), contact.can_yield(), contact.is_spring());
        tested.push(SpecimenResult { specimen: specimen.clone(), pair, can_yield, is_spring, indentation });
    }
    Ok((scene, tested, warnings))
}

pub(super) fn run(scenario: &Scenario, options: Option<&RunOptions>) -> Result<Outcome, Error> {
    let (scene, tested, warnings) = compute(scenario, options.map(|_| scenario.input().samples()))?;
    let inputs = report::inputs(scenario, &scene);
    let notes = report::material_notes(scenario, &tested);
    let Some(options) = options else {
        let blocks = report::overview(scenario, &scene, &tested, &notes);
        return Ok(Outcome { notes, ..Outcome::from_check(warnings, blocks, report::check_fields(&tested, &inputs)) });
    };
    let can_yield = scene.specimens.iter().any(|specimen| specimen.half_space.yield_strength.is_some());
    let provenance = outcome::provenance(scenario, &scene.law, can_yield, options.command);
    let mut files = vec![output_file("trace.csv", report::trace_csv(&tested)?)];
    files.extend(options.pictures.to_files(|| {
        let drawn = pictures::indentation(&tested).with_caption(indentation_caption(&scene));
        Ok(vec![("force_indentation", drawn)])
    })?);
    let mut results = report::summary_fields(&tested, &warnings);
    put_notes(&mut results, &notes);
    let files = with_summary(files, provenance, results, &inputs)?;
    let blocks = [report::result_blocks(&tested), note_blocks(&notes)].concat();
    Ok(Outcome { notes, ..Outcome::from_run(warnings, blocks, files) })
}

/// The error of a scenario without a result. If a step is the reason, the error points at the steps.
fn indentation_error(scenario: &Scenario, half_space: Option<&str>, reason: IndentationError) -> Error {
    let on = half_space.map_or_else(String::new, |name| format!("\"{name}\", "));
    match reason {
        reason @ (IndentationError::Range(_) | IndentationError::Pair(_) | IndentationError::Law(_)) => {
            Error::for_file(ErrorKind::Input, scenario.document.name(), format!("{on}{reason}"))
        }
        step => scenario.document.refusal("indentation.steps", format!("{on}{step}")),
    }
}
