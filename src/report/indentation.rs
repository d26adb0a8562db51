//! What is written about an indentation: `summary.json`, `trace.csv` and the table on the terminal.

use super::ReportError;
use serde::Serialize;

use super::inputs::Inputs;
use super::rows::csv;
use super::table::aligned;
use crate::indentation::{Span, Spans, Step, Target, Tested};
use crate::provenance::Provenance;
use crate::scene::results::indentation::{self as results, half_space, steps};
use crate::scene::results::{Fields, fields};
use crate::units::rounded::{number, quantity};

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
