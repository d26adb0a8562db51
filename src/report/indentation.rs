//! What is written about an indentation: `summary.json`, `trace.csv` and the table on the terminal.

use serde::Serialize;

use super::ReportError;
use super::inputs::Inputs;
use super::table::aligned;
use crate::indentation::{Span, Spans, Specimen, Step, Target, Tested};
use crate::units::rounded::{number, quantity};

/// Where a result comes from: enough to repeat it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Provenance {
    /// Version of this program.
    pub version: String,
    /// The scenario as named on the command line.
    pub scenario_file: String,
    /// SHA-256 of its text, hexadecimal.
    pub scenario_sha256: String,
    /// The command line.
    pub command: String,
    /// Contact law.
    pub law: String,
    /// Name of its table of coefficients; `None` for a law without one.
    pub coefficients: Option<String>,
    /// What those coefficients were determined from.
    pub coefficients_source: Option<String>,
}

#[derive(Serialize)]
struct Summary<'a> {
    half_spaces: Vec<HalfSpaceReport<'a>>,
    warnings: &'a [String],
    inputs: &'a Inputs,
    provenance: &'a Provenance,
}

#[derive(Serialize)]
struct HalfSpaceReport<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
    #[serde(rename = "youngs_modulus_Pa")]
    youngs_modulus: f64,
    #[serde(rename = "youngs_modulus_uncertainty_Pa", skip_serializing_if = "Option::is_none")]
    youngs_modulus_uncertainty: Option<f64>,
    poissons_ratio: f64,
    #[serde(rename = "yield_strength_Pa", skip_serializing_if = "Option::is_none")]
    yield_strength: Option<f64>,
    #[serde(rename = "yield_strength_uncertainty_Pa", skip_serializing_if = "Option::is_none")]
    yield_strength_uncertainty: Option<f64>,
    #[serde(rename = "effective_modulus_Pa")]
    effective_modulus: f64,
    sphere_compliance: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    yield_indentation_m: Option<f64>,
    #[serde(rename = "yield_force_N", skip_serializing_if = "Option::is_none")]
    yield_force: Option<f64>,
    #[serde(rename = "work_J")]
    work: f64,
    #[serde(rename = "plastic_work_J", skip_serializing_if = "Option::is_none")]
    plastic_work: Option<f64>,
    steps: Vec<StepReport>,
}

#[derive(Serialize)]
struct StepReport {
    step: usize,
    #[serde(rename = "target_load_N", skip_serializing_if = "Option::is_none")]
    target_load: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    target_indentation_m: Option<f64>,
    branch: &'static str,
    indentation_m: f64,
    sphere_indentation_m: f64,
    #[serde(rename = "force_N")]
    force: f64,
    #[serde(rename = "work_J")]
    work: f64,
    #[serde(rename = "stored_energy_J")]
    stored_energy: f64,
    #[serde(rename = "plastic_work_J", skip_serializing_if = "Option::is_none")]
    plastic_work: Option<f64>,
    #[serde(rename = "peak_force_N")]
    peak_force: f64,
    peak_indentation_m: f64,
    peak_contact_radius_m: f64,
    #[serde(rename = "peak_mean_pressure_Pa")]
    peak_mean_pressure: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    residual_indentation_m: Option<f64>,
    #[serde(rename = "unloading_stiffness_N_per_m")]
    unloading_stiffness: f64,
    unloading_exponent: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    uncertainty: Option<SpansReport>,
}

/// Lowest and highest value over the corners of the uncertain inputs.
#[derive(Serialize)]
struct SpansReport {
    indentation_m: [f64; 2],
    #[serde(rename = "force_N")]
    force: [f64; 2],
    residual_indentation_m: [f64; 2],
    #[serde(rename = "unloading_stiffness_N_per_m")]
    unloading_stiffness: [f64; 2],
    peak_contact_radius_m: [f64; 2],
    #[serde(rename = "plastic_work_J")]
    plastic_work: [f64; 2],
}

impl SpansReport {
    fn of(spans: &Spans) -> Self {
        let ends = |span: Span| [span.low, span.high];
        Self {
            indentation_m: ends(spans.indentation),
            force: ends(spans.force),
            residual_indentation_m: ends(spans.residual_indentation),
            unloading_stiffness: ends(spans.unloading_stiffness),
            peak_contact_radius_m: ends(spans.contact_radius),
            plastic_work: ends(spans.plastic_work),
        }
    }
}

impl StepReport {
    fn of(number: usize, step: &Step, can_yield: bool, spans: Option<&Spans>) -> Self {
        let (target_load, target_indentation_m) = match step.target {
            Target::Load(load) => (Some(load), None),
            Target::Indentation(indentation) => (None, Some(indentation)),
        };
        let memory = &step.memory;
        Self {
            step: number,
            target_load,
            target_indentation_m,
            branch: step.branch.name(),
            indentation_m: step.indentation,
            sphere_indentation_m: step.sphere_indentation,
            force: step.force,
            work: step.work,
            stored_energy: step.stored_energy,
            plastic_work: can_yield.then_some(step.plastic_work),
            peak_force: memory.force,
            peak_indentation_m: memory.indentation,
            peak_contact_radius_m: memory.contact_radius,
            peak_mean_pressure: memory.mean_pressure,
            residual_indentation_m: can_yield.then_some(memory.residual_indentation),
            unloading_stiffness: memory.unloading_stiffness,
            unloading_exponent: memory.unloading_exponent,
            uncertainty: spans.map(SpansReport::of),
        }
    }
}

impl<'a> HalfSpaceReport<'a> {
    fn of(tested: &'a Tested) -> Self {
        let Specimen { name, half_space, modulus_uncertainty, strength_uncertainty } = &tested.specimen;
        let can_yield = tested.can_yield;
        let steps = &tested.indentation.steps;
        let spans = |i: usize| tested.spans.as_ref().and_then(|spans| spans.get(i));
        let report = |(i, step)| StepReport::of(i + 1, step, can_yield, spans(i));
        Self {
            name: name.as_deref(),
            youngs_modulus: half_space.material.youngs_modulus,
            youngs_modulus_uncertainty: *modulus_uncertainty,
            poissons_ratio: half_space.material.poissons_ratio,
            yield_strength: half_space.yield_strength,
            yield_strength_uncertainty: *strength_uncertainty,
            effective_modulus: tested.pair.effective_modulus,
            sphere_compliance: tested.pair.sphere_compliance,
            yield_indentation_m: tested.pair.yield_point.map(|point| point.indentation),
            yield_force: tested.pair.yield_point.map(|point| point.force),
            work: steps.iter().map(|step| step.work).sum(),
            plastic_work: can_yield.then(|| steps.iter().map(|step| step.plastic_work).sum()),
            steps: steps.iter().enumerate().map(report).collect(),
        }
    }
}

/// `summary.json`, with a newline at its end.
///
/// # Errors
/// [`ReportError::Json`], which numbers and text do not give.
pub fn summary(
    tested: &[Tested],
    warnings: &[String],
    inputs: &Inputs,
    provenance: &Provenance,
) -> Result<String, ReportError> {
    let half_spaces = tested.iter().map(HalfSpaceReport::of).collect();
    Ok(serde_json::to_string_pretty(&Summary { half_spaces, warnings, inputs, provenance })? + "\n")
}

/// `trace.csv` with a header line; the first column names the half-space where it has a name.
///
/// # Errors
/// [`ReportError::Csv`], which a buffer in memory does not give.
pub fn trace(tested: &[Tested]) -> Result<Vec<u8>, ReportError> {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    let has_names = tested.iter().any(|one| one.specimen.name.is_some());
    let columns = ["step", "indentation_m", "sphere_indentation_m", "half_space_indentation_m", "force_N", "branch"];
    writer.write_record(has_names.then_some("half_space").into_iter().chain(columns))?;
    for Tested { specimen, indentation, .. } in tested {
        let name = specimen.name.as_deref();
        for row in &indentation.trace {
            let lengths = (row.indentation, row.sphere_indentation, row.half_space_indentation);
            // a name that is absent is no field
            match name {
                Some(name) => writer.serialize((name, row.step, lengths, row.force, row.branch.name()))?,
                None => writer.serialize((row.step, lengths, row.force, row.branch.name()))?,
            }
        }
    }
    writer.into_inner().map_err(|error| ReportError::Csv(error.into_error().into()))
}

/// The table a person reads: a line a step for every half-space.
#[must_use]
pub fn table(tested: &[Tested]) -> String {
    let mut text = String::new();
    for one in tested {
        if let Some(name) = &one.specimen.name {
            text.push_str(if text.is_empty() { "" } else { "\n" });
            text.push_str(name);
            text.push('\n');
        }
        let can_yield = one.can_yield;
        let mut head = vec!["step", "to", "indentation", "force", "stiffness S", "contact radius", "work"];
        if can_yield {
            head.extend(["residual", "plastic work"]);
        }
        let mut rows = vec![head.into_iter().map(str::to_owned).collect::<Vec<_>>()];
        for (i, step) in one.indentation.steps.iter().enumerate() {
            let spans = one.spans.as_ref().and_then(|spans| spans.get(i));
            rows.push(row(i + 1, step, can_yield, spans));
        }
        text.push_str(&aligned(&rows));
    }
    text
}

fn row(number: usize, step: &Step, can_yield: bool, spans: Option<&Spans>) -> Vec<String> {
    let with = |value: f64, span: Option<Span>, unit: &str| with_span(value, span, unit);
    let memory = &step.memory;
    let target = match step.target {
        Target::Load(load) => quantity(load, "N"),
        Target::Indentation(indentation) => quantity(indentation, "m"),
    };
    let mut cells = vec![
        number.to_string(),
        target,
        with(step.indentation, spans.map(|spans| spans.indentation), "m"),
        with(step.force, spans.map(|spans| spans.force), "N"),
        with(memory.unloading_stiffness, spans.map(|spans| spans.unloading_stiffness), "N/m"),
        quantity(memory.contact_radius, "m"),
        quantity(step.work, "J"),
    ];
    if can_yield {
        cells.push(with(memory.residual_indentation, spans.map(|spans| spans.residual_indentation), "m"));
        cells.push(quantity(step.plastic_work, "J"));
    }
    cells
}

/// "12.3 µm (11.9 to 12.7)", the span in the unit of the value.
fn with_span(value: f64, span: Option<Span>, unit: &str) -> String {
    let text = quantity(value, unit);
    match span.filter(|span| span.high - span.low > 1e-9 * span.high.abs()) {
        Some(Span { low, high }) => {
            let factor = crate::units::rounded::Prefix::of(value).factor;
            format!("{text} ({} to {})", number(low / factor), number(high / factor))
        }
        None => text,
    }
}
