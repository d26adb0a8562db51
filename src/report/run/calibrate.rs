//! Keys that are found from measurements.

use std::path::absolute;

use toml_edit::{DocumentMut, Value};

use super::outcome::{Outcome, RunOptions, output_file, provenance, put_notes, with_summary};
use crate::calibrate::fit::MIN_SCATTER;
use crate::calibrate::{Calibration, CalibrationTask, KeyEstimate};
use crate::contact::strength::kind::StrengthKind;
use crate::error::{Error, ErrorKind};
use crate::files::{OutputFile, PROGRAM, Progress};
use crate::materials::Property;
use crate::report::pictures::calibrate::pictures;
use crate::report::text::calibrate as report;
use crate::report::text::note_blocks;
use crate::report::text::overview::calibration_overview;
use crate::scenario::Scenario;
use crate::scenario::document::edit::set;
use crate::scenario::input::{Body, Input};
use crate::scenario::keys::interval::WHICH_STRENGTH;
use crate::scenario::keys::strength_notes;
use crate::units::{Dimension, format_exact, format_four_digits};

pub(super) fn run(scenario: &Scenario, options: Option<&RunOptions>) -> Result<Outcome, Error> {
    let measured = CalibrationTask::new(scenario)?;
    let unwatched = Progress::default();
    let found = measured.calibrate(options.map_or(&unwatched, |options| options.progress))?;
    let contradiction = found.verdict().contradiction_reason();
    let Some(options) = options else {
        let mut checked = report::summary_fields(&measured, &found);
        checked.insert("inputs".to_owned(), report::inputs(&measured, &found).to_json().into());
        let blocks = calibration_overview(&measured, &found);
        return Ok(Outcome { contradiction, ..Outcome::from_check(warnings(&found), blocks, checked) });
    };
    let files = result_files(scenario, &measured, &found, options)?;
    let known = calibration_notes(&found);
    let blocks = [report::result_blocks(&found), note_blocks(&known)].concat();
    Ok(Outcome { contradiction, notes: known, ..Outcome::from_run(warnings(&found), blocks, files) })
}

/// Notes for the user on the law behind the values that were found, and on a strength that was not found.
fn calibration_notes(found: &Calibration) -> Vec<String> {
    let input = found.input();
    let Ok(contact) = input.contact() else { return Vec::new() };
    let mut notes = strength_notes(&input, &contact, true, &[]);
    // a fitted strength is the strength at the strain rates of the impacts
    let is_found =
        found.keys.iter().any(|key| Body::ALL.into_iter().any(|body| key.free.key.path() == body.yield_strength()));
    notes.retain(|note| !(is_found && note.starts_with(WHICH_STRENGTH)));
    notes
}

/// The files with these results.
fn result_files(
    scenario: &Scenario,
    measured: &CalibrationTask,
    found: &Calibration,
    options: &RunOptions,
) -> Result<Vec<OutputFile>, Error> {
    let provenance = provenance(scenario, &measured.request.input.law(), true, options.command);
    let mut files = vec![output_file("residuals.csv", report::residuals_csv(found)?)];
    if !found.keys.is_empty() {
        files.push(output_file("calibrated.toml", calibrated_scenario(scenario, measured, found)?));
    }
    files.extend(options.pictures.to_files(|| Ok(pictures(found)))?);
    let mut results = report::summary_fields(measured, found);
    put_notes(&mut results, &calibration_notes(found));
    with_summary(files, provenance, results, &report::inputs(measured, found))
}

fn warnings(found: &Calibration) -> Vec<String> {
    let unbounded = |key: &KeyEstimate| {
        key.intervals.is_some_and(|[_, wide]| wide.iter().any(Option::is_none)).then(|| {
            format!("The interval of {} is open: it reaches the end of the search range.", key.free.key.path())
        })
    };
    // what is left of measurements that the law itself made is rounding, with any signs
    let runs = found.runs.filter(|_| found.misfit > MIN_SCATTER);
    let runs = runs.filter(|runs| runs.p < 0.01 && found.verdict().contradiction_reason().is_none()).map(|runs| {
        let p = format_four_digits(runs.p);
        format!("The intervals are too narrow: the residuals are not random (runs test, p = {p}), so the law has a systematic error.")
    });
    let unlikely = found.keys.iter().filter_map(|key| material_doubt(key, &found.fit.problem.input));
    let range_warnings = found.range_warnings().into_iter().map(|(warning, line)| {
        let place = line.map_or_else(String::new, |line| format!("at line {line} of the data: "));
        format!("{place}{warning}")
    });
    let refusal = found.reason_without_intervals.iter().map(|reason| format!("No confidence interval: {reason}"));
    refusal
        .chain(found.verdict().undecided_reason())
        .chain(runs)
        .chain(found.keys.iter().filter_map(unbounded))
        .chain(unlikely)
        .chain(range_warnings)
        .collect()
}

/// Warns if a fitted strength or hardness is far from the value of the material that the body names.
fn material_doubt(key: &KeyEstimate, input: &Input) -> Option<String> {
    let choice = input.materials().iter().find(|choice| key.free.key.path().starts_with(choice.body.table_name()))?;
    let hardness = choice.material.get(Property::Hardness)?.value.value;
    let usual = match key.free.key.path() {
        path if path == choice.body.hardness() => hardness,
        path if path == choice.body.yield_strength() && input.flow_curve(choice.body).is_none() => {
            choice.material.flow_stress(hardness)
        }
        _ => return None,
    };
    let ratio = key.estimate / usual;
    (!(0.5..=2.0).contains(&ratio)).then(|| {
        format!(
            "The result may be meaningless: {} is {} times the {} of {}. Check the units of the data and of the scenario.",
            key.free.key.path(),
            format_four_digits(ratio),
            key.free.format_value(usual, 4),
            choice.material.name
        )
    })
}

/// The scenario with the values that were found, and without `[calibrate]`: it runs as it is. Its comments stay; the first
/// line says which keys are new.
fn calibrated_scenario(scenario: &Scenario, measured: &CalibrationTask, found: &Calibration) -> Result<String, Error> {
    let document = scenario.document.edited_text().parse::<DocumentMut>();
    let mut document = document.map_err(|error| Error::caused_by(ErrorKind::Input, &error))?;
    document.remove("calibrate");
    for KeyEstimate { free, estimate, .. } in &found.keys {
        let path = free.key.path();
        set(&mut document, path, free.to_scenario_text(*estimate).map_or_else(|| (*estimate).into(), Value::from));
        // a strength that impacts give is that of impacts; one of a slow indentation is not
        let bodies = Body::ALL.into_iter().filter(|_| !measured.data.is_curve());
        for body in bodies.filter(|body| [body.yield_strength(), body.hardness()].contains(&path)) {
            set(&mut document, &format!("{}.strength_kind", body.table_name()), Value::from(StrengthKind::Flow.name()));
        }
    }
    for (key, path) in scenario.files().filter(|(key, _)| !key.starts_with("calibrate.")) {
        if let Ok(path) = absolute(path) {
            set(&mut document, key, path.display().to_string());
        }
    }
    let data = &measured.data;
    if data.is_curve() {
        let deepest = data.rows.iter().filter_map(|row| row.indentation).fold(0.0, f64::max);
        let steps = format!("[{{ indentation = {deepest:?} }}, {{ load = 0.0 }}]");
        document.remove("impact");
        if let Ok(steps) = steps.parse::<Value>() {
            set(&mut document, "indentation.steps", steps);
        }
    } else if found.fit.problem.input.speed().is_nan() {
        let mut speeds = found.fit.problem.speeds();
        speeds.sort_by(f64::total_cmp);
        set(&mut document, "impact.speed", format_exact(speeds[speeds.len() / 2], Dimension::Speed));
    }
    let keys: Vec<&str> = found.keys.iter().map(|key| key.free.key.path()).collect();
    Ok(format!(
        "# {}: fitted by {PROGRAM}. The other comments come from {}.\n{}",
        keys.join(", "),
        scenario.document.name(),
        document
    ))
}
