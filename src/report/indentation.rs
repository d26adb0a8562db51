//! What is written about an indentation: its inputs, `summary.json`, `trace.csv` and what the terminal shows.

use super::ReportError;
use serde::Serialize;

use super::inputs::Inputs;
use super::overview;
use super::resolved::{Entry, SPHERE, STRENGTH, given, of_law, of_materials, words_of_strength};
use super::rows::csv;
use crate::indentation::{Span, Spans, Step, Target, Tested};
use crate::provenance::Provenance;
use crate::scenario::Scenario;
use crate::scenario::indentation::IndentationScene;
use crate::scene::results::indentation::{self as results, half_space, steps};
use crate::scene::results::{Fields, fields};
use crate::units::aligned::aligned;
use crate::units::rounded::{number, quantity};
use crate::units::{self, Dimension, describe, human};

#[derive(Serialize)]
struct Results<'a> {
    half_spaces: Vec<HalfSpace>,
    warnings: &'a [String],
}

#[derive(Serialize)]
struct HalfSpace {
    #[serde(flatten)]
    results: Fields,
    steps: Vec<Fields>,
}

/// `summary.json`.
///
/// # Errors
/// [`ReportError::Json`], which numbers and text do not give.
pub fn summary(
    tested: &[Tested],
    warnings: &[String],
    inputs: &Inputs,
    provenance: &Provenance,
) -> Result<String, ReportError> {
    let list = half_space();
    let half_space = |one| HalfSpace { results: fields(&list, one), steps: steps(one) };
    let half_spaces = tested.iter().map(half_space).collect();
    super::summary::of(Results { half_spaces, warnings }, inputs, provenance)
}

/// `trace.csv`.
///
/// # Errors
/// [`ReportError::Csv`], which a buffer in memory does not give.
pub fn trace(tested: &[Tested]) -> Result<Vec<u8>, ReportError> {
    let rows = tested.iter().flat_map(|one| {
        let name = one.specimen.name.as_deref();
        one.indentation.trace.iter().map(move |row| (name, row))
    });
    csv(&results::trace(), rows)
}

/// The table a person reads: a line a step for every half-space.
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
        text.push_str(&aligned(&rows, |_| true));
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

/// What an indentation came to, but for its steps and half-spaces.
pub fn inputs(scenario: &Scenario, scene: &IndentationScene) -> Vec<Entry> {
    let mut entries = given(scenario, &[&SPHERE[..], &["sphere.yield_strength"], &STRENGTH].concat());
    entries.extend(words_of_strength(scenario.number_of(STRENGTH[0]), scene.law.flow()));
    entries.extend(of_materials(&scenario.taken));
    if scene.specimens.iter().any(|specimen| specimen.half_space.yield_strength.is_some()) {
        entries.push(Entry::word("law", scene.law.name()));
        entries.extend(of_law(&scene.law));
    }
    entries.push(Entry::count("output.samples", scene.samples));
    entries
}

/// What was understood of it, and the contact of every half-space.
pub fn overview(scenario: &Scenario, scene: &IndentationScene, tested: &[Tested]) -> String {
    let mut rows = overview::rows(&inputs(scenario, scene));
    let mut row = |name: &str, value: String| rows.push([name.to_owned(), value]);
    for (i, target) in (1..).zip(&scene.targets) {
        let (what, value) = match *target {
            Target::Load(load) => ("load", describe(load, Dimension::Force)),
            Target::Indentation(indentation) => ("indentation", describe(indentation, Dimension::Length)),
        };
        row(&format!("step {i}"), format!("{what} {value}"));
    }
    for Tested { specimen, pair, .. } in tested {
        let half_space = &specimen.half_space;
        row("", String::new());
        row("half-space", specimen.name.clone().unwrap_or_default());
        let pressure = |value: f64, uncertainty: Option<f64>| match uncertainty {
            Some(by) => format!("{} ± {}", describe(value, Dimension::Pressure), human(by, Dimension::Pressure)),
            None => describe(value, Dimension::Pressure),
        };
        row("youngs_modulus", pressure(half_space.material.youngs_modulus, specimen.modulus_uncertainty));
        row("poissons_ratio", units::number(half_space.material.poissons_ratio));
        if let Some(strength) = half_space.yield_strength {
            row("yield_strength", pressure(strength, specimen.strength_uncertainty));
        }
        for [name, value] in overview::paired(pair) {
            row(&name, value);
        }
    }
    aligned(&rows, |_| true)
}
