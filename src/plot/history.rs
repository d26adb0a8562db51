//! Force, indentation and speed against time, in three boxes one above the other.

use super::axis::Axis;
use super::canvas::Canvas;
use super::force_indentation::{force_at_peak, is_damped, largest_force, peak_name, title};
use super::frame::{Bounds, Frame};
use super::key::{self, Entry};
use super::style::{DASHED, GREY, INK, SOLID, Stroke, series};
use super::{PlotError, SIZE};
use crate::impact::{Impact, TraceRow};
use crate::units::rounded::quantity;

/// Distance between the boxes \[px\].
const GAP: f64 = 28.0;

/// Number of markers along each curve of indentation.
const MARKS: usize = 5;

/// Width of the line of a series. The three curves of indentation have different widths, because they may lie on each
/// other.
fn width(series: usize) -> f64 {
    [7.0, 5.0].get(series).copied().unwrap_or(3.5)
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
    let panels: [(Axis, &[Quantity], usize); 3] = [
        (Axis::engineering("Force", "N").between(0.0, 1.1 * largest_force(impact)), &[|row| row.force], 3),
        (Axis::engineering("Indentation", "m").between(0.0, 1.1 * impact.peak_indentation), &indentations, 0),
        (Axis::engineering("Speed", "m/s").between(speeds.0, speeds.1), &[|row| row.speed], 4),
    ];
    let (peak, separation) =
        (Stroke { color: GREY, width: 2.5, dash: DASHED }, Stroke { color: GREY, width: 2.5, dash: SOLID });
    let entries = entries(impact, peak, separation);
    let all = key::bounds(&entries)?;
    let mut canvas = Canvas::try_new(SIZE)?;
    let step = (all.bottom - all.top + GAP) / 3.0;
    let mut top = all.top;
    for (i, (axis, curves, first_color)) in panels.into_iter().enumerate() {
        let frame = Frame {
            bounds: Bounds { top, bottom: top + step - GAP, ..all },
            x: Axis::engineering("Time", "s").between(0.0, 1.03 * impact.duration()).fitted(std::iter::empty()),
            y: axis.fitted(std::iter::empty()),
        };
        frame.draw_x(&mut canvas, i == 2)?;
        frame.draw_y(&mut canvas)?;
        for (time, stroke) in [(impact.loading_time, peak), (impact.duration(), separation)] {
            let (low, high) = (frame.y.value_at(0.0), frame.y.value_at(1.0));
            frame.curve(&mut canvas, [(time, low), (time, high)].into_iter(), stroke);
        }
        if i == 2 {
            let rest = [(0.0, 0.0), (frame.x.value_at(1.0), 0.0)];
            frame.curve(&mut canvas, rest.into_iter(), Stroke::solid(INK, 1.5));
        }
        frame.draw_outline(&mut canvas);
        for (j, quantity) in curves.iter().enumerate() {
            let (stroke, mark) = series(first_color + j);
            let stroke = Stroke { dash: SOLID, width: width(first_color + j), ..stroke };
            let points = impact.trace.iter().map(|row| (row.time, quantity(row)));
            frame.curve(&mut canvas, points, stroke);
            if curves.len() > 1 {
                // each curve has its markers at other times, because two curves may lie on each other
                let rows =
                    (0..MARKS).filter_map(|k| impact.trace.get(impact.trace.len() * (3 * k + j + 1) / (3 * MARKS + 1)));
                for row in rows {
                    frame.mark(&mut canvas, (row.time, quantity(row)), mark, 8.0, stroke.color);
                }
            }
        }
        if i == 0 {
            frame.draw_title(&mut canvas, &title(impact))?;
            key::draw(&mut canvas, &entries, &frame)?;
        }
        top += step;
    }
    Ok(canvas)
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

fn entries(impact: &Impact, peak: Stroke, separation: Stroke) -> Vec<Entry> {
    let curve = |name: &str, index: usize| {
        let (stroke, mark) = series(index);
        let entry = Entry::line(name, Stroke { dash: SOLID, width: width(index), ..stroke });
        Entry { mark: (index < 3).then_some((mark, 8.0, stroke.color)), ..entry }
    };
    let mut left = match impact.captured() {
        None => Entry::line("Separation", separation)
            .and(quantity(impact.contact_time, "s"))
            .and(format!("rebound at {}", quantity(impact.rebound_speed, "m/s"))),
        Some(under) => {
            let rest = under.static_indentation.map_or_else(String::new, |depth| quantity(depth, "m"));
            Entry::line("Captured", separation).and(quantity(under.end_time, "s")).and(format!("rest at δ = {rest}"))
        }
    };
    let mut at_peak = Entry::line(peak_name(impact), peak).and(quantity(impact.loading_time, "s"));
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
