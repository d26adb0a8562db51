//! Force, indentation and speed against time, in three boxes one above the other.

use super::PlotError;
use super::axis::Axis;
use super::canvas::Canvas;
use super::force_indentation::{force_at_peak, is_damped, largest_force, peak_name, title};
use super::key::Entry;
use super::sheet::stacked;
use super::style::{DASHED, GREY, INK, Marker, SOLID, Stroke, solid};
use crate::impact::{Impact, TraceRow};
use crate::units::rounded::quantity;

/// Number of markers along each curve of indentation.
const MARKS: usize = 5;

/// The times of the peak and of separation.
const PEAK: Stroke = Stroke { color: GREY, width: 2.5, dash: DASHED };
const SEPARATION: Stroke = Stroke { color: GREY, width: 2.5, dash: SOLID };

/// The style of a curve. The three curves of indentation have different widths, because they may lie on each other.
fn style(index: usize) -> (Stroke, Marker) {
    solid(index, [7.0, 5.0].get(index).copied().unwrap_or(3.5), 8.0)
}

type Quantity = fn(&TraceRow) -> f64;

/// The history of an impact. A trace of some hundred samples gives smooth curves.
///
/// # Errors
/// [`PlotError::Data`] for an impact without a trace; other [`PlotError`]s from drawing.
pub fn history(impact: &Impact) -> Result<Canvas, PlotError> {
    if impact.trace.is_empty() {
        return Err(PlotError::Data("a history needs a trace: run the impact with samples".into()));
    }
    let indentations: [Quantity; 3] =
        [|row| row.indentation, |row| row.sphere_indentation, |row| row.half_space_indentation];
    let speeds = speeds(impact);
    // vertical axis, curves, style of the first curve
    let panels: [(Axis, &[Quantity], usize); 3] = [
        (Axis::engineering("Force", "N").between(0.0, 1.1 * largest_force(impact)), &[|row| row.force], 3),
        (Axis::engineering("Indentation", "m").between(0.0, 1.1 * impact.peak_indentation), &indentations, 0),
        (Axis::engineering("Speed", "m/s").between(speeds.0, speeds.1), &[|row| row.speed], 4),
    ];
    let x = Axis::engineering("Time", "s").between(0.0, 1.03 * impact.duration()).fitted([]);
    let axes = panels.each_ref().map(|(y, ..)| (y.fitted([]), 1.0)).into();
    stacked(&title(impact), &x, axes, &entries(impact), |i, frame, canvas| {
        let (_, curves, first) = panels[i];
        for (time, stroke) in [(impact.loading_time, PEAK), (impact.duration(), SEPARATION)] {
            frame.curve(canvas, [0.0, 1.0].map(|end| (time, frame.y.value_at(end))), stroke);
        }
        if i == 2 {
            frame.curve(canvas, [(0.0, 0.0), (frame.x.value_at(1.0), 0.0)], Stroke::solid(INK, 1.5));
        }
        frame.draw_outline(canvas);
        for (j, quantity) in curves.iter().enumerate() {
            let (stroke, marker) = style(first + j);
            let point = |row: &TraceRow| (row.time, quantity(row));
            frame.curve(canvas, impact.trace.iter().map(point), stroke);
            if curves.len() > 1 {
                // each curve has its markers at other times, because two curves may lie on each other
                let place = |k| impact.trace.len() * (3 * k + j + 1) / (3 * MARKS + 1);
                for row in (0..MARKS).filter_map(|k| impact.trace.get(place(k))) {
                    frame.mark(canvas, point(row), marker);
                }
            }
        }
    })
}

/// The ends of the axis of speeds. With forces they come from the trace: gravity may accelerate the sphere beyond its
/// impact speed, and a captured sphere has no rebound speed.
fn speeds(impact: &Impact) -> (f64, f64) {
    if impact.under_forces.is_none() {
        return (1.1 * -impact.rebound_speed, 1.1 * impact.speed);
    }
    let speeds = || impact.trace.iter().map(|row| row.speed);
    (1.1 * speeds().fold(0.0, f64::min), 1.1 * speeds().fold(0.0, f64::max))
}

fn entries(impact: &Impact) -> Vec<Entry> {
    let curve = |name: &str, index: usize| {
        let (stroke, marker) = style(index);
        let entry = Entry::line(name, stroke);
        if index < 3 { entry.marked(marker) } else { entry }
    };
    let mut left = match impact.captured() {
        None => Entry::line("Separation", SEPARATION)
            .and(quantity(impact.contact_time, "s"))
            .and(format!("rebound at {}", quantity(impact.rebound_speed, "m/s"))),
        Some(under) => {
            let rest = under.static_indentation.map_or_else(String::new, |depth| quantity(depth, "m"));
            Entry::line("Captured", SEPARATION).and(quantity(under.end_time, "s")).and(format!("rest at δ = {rest}"))
        }
    };
    let mut at_peak = Entry::line(peak_name(impact), PEAK).and(quantity(impact.loading_time, "s"));
    if is_damped(impact) {
        at_peak = at_peak.and(force_at_peak(impact));
    }
    if impact.has_dent() {
        left = left.and(format!("dent δᵣ = {}", quantity(impact.residual_indentation, "m")));
    }
    vec![
        if is_damped(impact) { curve("Force F", 3) } else { curve("Force F", 3).and(force_at_peak(impact)) },
        curve("Approach δ", 0).and(format!("δₘ = {}", quantity(impact.peak_indentation, "m"))),
        curve("Sphere δₛ", 1),
        curve("Half-space δₕ", 2),
        curve("Speed δ′", 4).and(format!("impact at {}", quantity(impact.speed, "m/s"))),
        at_peak,
        left,
    ]
}
