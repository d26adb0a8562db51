//! Force against the approach, and against the indentations of sphere and half-space, during loading and unloading: the
//! loops of Xie et al. (2024), Figs. 8 and 12.

use super::loops;
use crate::error::Error;
use crate::impact::{Event, Impact};
use crate::numerics::functions::atan2;
use crate::report::chart::{Axis, Chart, DOTTED, FOREGROUND, GREY, Marker, Series, Style};
use crate::units::{Dimension, format_four_digits, format_result};

/// The picture of force against indentation of an impact. A trace of some hundred samples gives smooth curves.
pub fn force_indentation(impact: &Impact) -> Result<Chart, Error> {
    let trace = &impact.trace;
    let peak = (impact.row.peak_indentation, impact.force_at_peak_indentation);
    let ink = |mark| Style::marker(mark, FOREGROUND);
    let to_peak = Style::line(GREY, 1.5);
    let mut series = vec![Series::line("", vec![(0.0, peak.1), peak, (peak.0, 0.0)]).with_style(to_peak)];
    let branches = loops::impact_loop(impact)
        .ok_or_else(|| Error::failed("force against indentation needs a trace: run the impact with samples"))?;
    series.extend(loops::indentation_loops(&branches));
    if is_damped(impact) {
        let of_law = trace.iter().filter_map(|row| Some((row.indentation, row.elastic_force?)));
        // the other curves include the damping
        let name = Series::line("force of the law", of_law.collect()).with_note("without damping, against δ");
        series.push(name.with_style(Style::line(FOREGROUND, 2.5).with_dash(DOTTED)));
    }
    let at = |event| trace.iter().filter(move |row| row.event == Some(event)).map(|row| (row.indentation, row.force));
    let points: Vec<_> = at(Event::Yield).collect();
    series.extend((!points.is_empty()).then(|| Series::points("First yield", points).with_style(ink(Marker::Diamond))));
    let length = |name: &str, value| format!("{name} = {}", format_result(value, Dimension::Length));
    let turning = Series::points(peak_name(impact), vec![peak]).with_style(ink(Marker::Square));
    series.push(turning.with_note(force_at_peak(impact)).with_note(length("δₘ", impact.row.peak_indentation)));
    if impact.row.has_dent() {
        let residual = impact.row.residual_indentation;
        let dent = Series::points("Residual indentation", vec![(residual, 0.0)]).with_style(ink(Marker::TriangleDown));
        series.push(dent.with_note(length("δᵣ", residual)));
    }
    let x = Axis::linear("Indentation", "m").with_range(0.0, 1.06 * impact.row.peak_indentation);
    let y = Axis::linear("Force", "N").with_range(0.0, 1.08 * impact.row.peak_force);
    // without dent and damping, unloading lies on loading
    let has_two = impact.row.has_dent() || is_damped(impact);
    let branches: &[&str] = if has_two { &["loading", "unloading"] } else { &["loading and unloading"] };
    Ok(Chart::new(title(impact), [x, y], series).with_branches(branches))
}

pub(in crate::report) fn is_damped(impact: &Impact) -> bool {
    impact.forces_result.is_some_and(|under| under.damping_loss.is_some())
}

/// The name of the turning point. With damping it is not the peak of the force, which is largest before it.
pub(in crate::report) fn peak_name(impact: &Impact) -> &'static str {
    if is_damped(impact) { "Deepest point" } else { "Peak" }
}

/// The force at the turning point. It is the peak force F_m only without damping.
pub(in crate::report) fn force_at_peak(impact: &Impact) -> String {
    let force = format_result(impact.force_at_peak_indentation, Dimension::Force);
    if is_damped(impact) { format!("F = {force} there") } else { format!("Fₘ = {force}") }
}

/// The title of the pictures of one impact: whole speed, angle and normal restitution.
pub(in crate::report) fn title(impact: &Impact) -> String {
    let first = impact.trace.first();
    let friction = first.and_then(|row| Some((row.speed, row.friction?.tangential.speed)));
    let angle = friction.map_or_else(String::new, |(normal, along)| {
        format!(" and {}°", format_four_digits(atan2(along, normal).to_degrees()))
    });
    let end = match impact.captured_result() {
        Some(_) => "captured".to_owned(),
        None => format!("restitution e = {}", format_four_digits(impact.row.restitution)),
    };
    format!("Impact at {}{angle}: {end}", format_result(impact.speed, Dimension::Speed))
}
