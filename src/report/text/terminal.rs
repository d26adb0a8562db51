//! Results on the terminal: those that have a label in the registry, in the order of the registry.

use serde_json::Value;

use super::blocks::{Block, note_blocks};
use crate::impact::{Impact, WarningKind};
use crate::results::impact::{SingleImpact, impact_results};
use crate::results::{NumberFormat, ResultSpec};
use crate::scenario::keys::SMALL;
use crate::units::{Dimension, format_four_digits, format_percent, format_result, format_si_and_short};

/// How much the terminal shows of an impact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Detail {
    /// The few results that most people ask for.
    Brief,
    /// All results but how exact the integration was.
    Normal,
    Full,
}

pub fn impact_blocks(single: &SingleImpact, detail: Detail) -> Vec<Block> {
    let impact = single.impact;
    let is_of_the_integrator =
        |name: &str| ["accuracy.", "work.", "energy.balance_error"].iter().any(|begin| name.starts_with(begin));
    let mut results = impact_results();
    let is_brief = detail == Detail::Brief;
    let is_shared = impact.row.has_flat() && impact.row.dent_depth() > 0.0;
    let is_idle = |name: &str| match name {
        // parts of a sum with one part
        "dent_depth_m" | "flat_depth_m" => !is_shared,
        // springs know no bodies: they have no rim, and do not yield
        "dent_diameter_m" | "yield_speed_m_per_s" if single.contact.is_spring() => true,
        "dent_diameter_m" => impact.row.has_flat() && !is_shared,
        name => detail != Detail::Full && is_of_the_integrator(name),
    };
    results.retain(|result| !is_idle(result.name) && (!is_brief || result.is_brief));
    let speed = ["impact speed".to_owned(), format_result(impact.speed, Dimension::Speed), String::new()];
    let mut lines = if is_brief { Vec::new() } else { vec![speed] };
    lines.extend(result_lines(&results, single, Imprint::new(single.contact.is_spring(), impact.row.imprint_name())));
    put_measured_first(&mut lines);
    mark_doubtful(&mut lines, impact);
    [vec![Block::list(lines)], note_blocks(single.notes)].concat()
}

/// Where waves are computed, the restitution with waves is the one that is measured: its line comes first and has the interval, and
/// the restitution of the contact alone is the second.
fn put_measured_first(lines: &mut [Line]) {
    let [first, second] =
        ["restitution", "restitution with waves"].map(|label| lines.iter().position(|[name, ..]| name == label));
    if let (Some(first), Some(second)) = (first, second) {
        let [alone, measured] = [&lines[first], &lines[second]].map(|line| line[1].clone());
        lines[first][1] = measured;
        lines[second] = ["restitution without waves".to_owned(), alone, std::mem::take(&mut lines[second][2])];
    }
}

/// Marks a restitution that does not hold, and writes no digits where a warning says to take it for nearly 0.
fn mark_doubtful(lines: &mut [Line], impact: &Impact) {
    let has = |kind: WarningKind, size: f64| {
        impact.warnings.iter().any(|warning| warning.kind == kind && warning.size >= size)
    };
    let is_nearly_0 = has(WarningKind::InelasticWaveguide, 0.0);
    // the size is the sticking speed over the impact speed
    let sticks = has(WarningKind::Adhesion, 1.0);
    let restitution = impact.row.measured_restitution();
    let is_small = impact.row.waveguide.is_some() && restitution < SMALL;
    for [name, value, _] in lines {
        match name.as_str() {
            "restitution" if is_nearly_0 => *value = nearly_0(restitution),
            "restitution" if is_small => *value = format!("below {SMALL}"),
            "rebound speed" | "rebound height" if is_nearly_0 => "nearly 0".clone_into(value),
            "restitution" | "restitution without waves" if impact.row.is_outside_validity => {
                value.push_str(" (outside the range of validity)");
            }
            "restitution" | "restitution without waves" | "rebound speed" | "rebound height" if sticks => {
                value.push_str(" (below the sticking speed)");
            }
            _ => {}
        }
    }
}

/// A restitution without digits that nobody can rely on: the next of some round numbers above it.
fn nearly_0(restitution: f64) -> String {
    let above = [0.02, 0.05, 0.1, 0.2, 0.5].into_iter().find(|limit| restitution < *limit).unwrap_or(1.0);
    format!("nearly 0 (below {above})")
}

/// The imprint of an impact in labels: dent, flat, or both; a pair of springs keeps neither.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Imprint {
    Named(&'static str),
    OfSprings,
}

impl Imprint {
    pub(super) fn new(is_spring: bool, name: &'static str) -> Self {
        if is_spring { Self::OfSprings } else { Self::Named(name) }
    }

    /// A label of the registry, which says dent. Where the sphere flows too, the residual indentation is the sum of a dent and a
    /// flat on the sphere.
    fn label(self, label: &str) -> String {
        match (self, label) {
            (Self::OfSprings, "dent depth" | "dent") => "residual indentation".to_owned(),
            (Self::OfSprings, "deepest dent") => "largest residual indentation".to_owned(),
            (Self::Named(name), "dent" | "dent depth" | "deepest dent") => label.replace("dent", name),
            _ => label.to_owned(),
        }
    }
}

/// A name, a value and remarks.
pub(super) type Line = [String; 3];

/// A line for every result; a label with braces adds its value to the remarks of the line above.
pub(super) fn result_lines<T>(results: &[ResultSpec<T>], subject: &T, imprint: Imprint) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    let mut whole = f64::NAN;
    for ResultSpec { format: shown, label, value, .. } in with_label(results) {
        let Some(value) = value(subject) else { continue };
        let Some((before, after)) = label.split_once('{') else {
            whole = value.as_f64().unwrap_or(f64::NAN);
            lines.push([
                imprint.label(label),
                format_value(*shown, &value).unwrap_or_else(|| "none".to_owned()),
                String::new(),
            ]);
            continue;
        };
        let share =
            value.as_f64().map(|part| part / whole).filter(|share| after.starts_with('%') && share.abs() <= 1.0);
        let (Some(remark), Some([_, _, remarks])) =
            (share.map(format_percent).or_else(|| format_value(*shown, &value)), lines.last_mut())
        else {
            continue;
        };
        let comma = if remarks.is_empty() { "" } else { ", " };
        remarks.extend([comma, before, &remark, after.trim_start_matches(['%', '}'])]);
    }
    lines
}

/// A line of labels, and a line for every row. Results with the same label share a column; a column without values is left
/// out.
pub(super) fn result_columns<T>(results: &[ResultSpec<T>], rows: &[T], imprint: Imprint) -> Vec<Vec<String>> {
    let cell = |label: &str, row: &T| {
        with_label(results).filter(|result| result.label == label).find_map(|result| {
            let value = (result.value)(row)?;
            format_value(result.format, &value)
        })
    };
    let mut labels: Vec<&str> = with_label(results).map(|result| result.label).collect();
    labels.dedup();
    let columns = labels.into_iter().filter_map(|label| {
        let cells: Vec<Option<String>> = rows.iter().map(|row| cell(label, row)).collect();
        let is_there = cells.iter().any(Option::is_some);
        is_there
            .then(|| [Some(imprint.label(label))].into_iter().chain(cells).map(|cell| cell.unwrap_or("-".to_owned())))
    });
    let mut lines = vec![Vec::new(); rows.len() + 1];
    for column in columns {
        for (line, cell) in lines.iter_mut().zip(column) {
            line.push(cell);
        }
    }
    lines
}

/// A label and a value for every result, with the SI unit and all digits where they are few: as `check` shows numbers.
pub(super) fn label_value_rows<T>(results: &[ResultSpec<T>], subject: &T) -> impl Iterator<Item = [String; 2]> {
    with_label(results).filter_map(|ResultSpec { format: shown, label, value, .. }| {
        let value = value(subject)?;
        let text = match (shown, value.as_f64()) {
            (NumberFormat::Unit(dimension), Some(number)) => format_si_and_short(number, *dimension),
            _ => format_value(*shown, &value)?,
        };
        Some([(*label).to_owned(), text])
    })
}

fn with_label<T>(results: &[ResultSpec<T>]) -> impl Iterator<Item = &ResultSpec<T>> {
    results.iter().filter(|result| !result.label.is_empty())
}

/// A value as text; `None` where there is no value.
fn format_value(shown: NumberFormat, value: &Value) -> Option<String> {
    let value = match value {
        Value::String(word) => return Some(word.clone()),
        Value::Number(count) if !count.is_f64() => return Some(count.to_string()),
        value => value.as_f64()?,
    };
    Some(match shown {
        NumberFormat::Plain => format_four_digits(value),
        NumberFormat::Unit(dimension) => format_result(value, dimension),
        NumberFormat::Percent => format_percent(value),
        NumberFormat::Deviation => format!("{:+.1} %", 100.0 * value),
        NumberFormat::Error => format!("{value:.1e}"),
    })
}
