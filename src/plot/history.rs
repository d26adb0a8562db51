//! Force, indentation and speed against time, one above the other.

use super::axis::Axis;
use super::canvas::Canvas;
use super::frame::{Bounds, Frame};
use super::key::{self, Entry};
use super::style::{DASHED, GREY, INK, SOLID, Stroke, series};
use super::{PlotError, SIZE};
use crate::impact::{Impact, TraceRow};
use crate::report::human::{number, quantity};

/// Distance between the boxes \[px\].
const GAP: f64 = 28.0;

type Quantity = fn(&TraceRow) -> f64;

/// The picture `history.png`. The trace is drawn as it is: some hundred samples make smooth curves.
///
/// # Errors
/// [`PlotError::Data`] for an impact without a trace; otherwise what drawing and encoding report.
pub fn history(impact: &Impact) -> Result<Vec<u8>, PlotError> {
    if impact.trace.is_empty() {
        return Err(PlotError::Data("a history needs a trace: run the impact with samples".into()));
    }
    let indentations: [Quantity; 3] =
        [|row| row.indentation, |row| row.sphere_indentation, |row| row.half_space_indentation];
    let speeds = (1.1 * -impact.rebound_speed, 1.1 * impact.speed);
    let panels: [(Axis, &[Quantity], usize); 3] = [
        (Axis::engineering("Force", "N").between(0.0, 1.1 * impact.peak_force), &[|row| row.force], 3),
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
            x: Axis::engineering("Time", "s").between(0.0, 1.03 * impact.contact_time).fitted(std::iter::empty()),
            y: axis.fitted(std::iter::empty()),
        };
        frame.draw_axes(&mut canvas, i == 2)?;
        for (time, stroke) in [(impact.loading_time, peak), (impact.contact_time, separation)] {
            let (low, high) = (frame.y.value_at(0.0), frame.y.value_at(1.0));
            frame.curve(&mut canvas, [(time, low), (time, high)].into_iter(), stroke)?;
        }
        if i == 2 {
            let rest = [(0.0, 0.0), (frame.x.value_at(1.0), 0.0)];
            frame.curve(&mut canvas, rest.into_iter(), Stroke::solid(INK, 1.5))?;
        }
        frame.draw_outline(&mut canvas)?;
        for (j, quantity) in curves.iter().enumerate() {
            let (stroke, mark) = series(first_color + j);
            let stroke = Stroke { dash: SOLID, width: if curves.len() > 1 && j == 0 { 5.5 } else { 3.5 }, ..stroke };
            let points = impact.trace.iter().map(|row| (row.time, quantity(row)));
            frame.curve(&mut canvas, points, stroke)?;
            if curves.len() > 1 {
                // markers of the three shares at different times, as two shares may be one curve
                let every = (impact.trace.len() / 6).max(1);
                for row in impact.trace.iter().skip(every * (1 + j) / 3).step_by(every) {
                    frame.mark(&mut canvas, (row.time, quantity(row)), mark, 8.0, stroke.color)?;
                }
            }
        }
        if i == 0 {
            key::draw(&mut canvas, &entries, &frame)?;
        }
        top += step;
    }
    canvas.to_png()
}

fn entries(impact: &Impact, peak: Stroke, separation: Stroke) -> Vec<Entry> {
    let curve = |name: &str, index: usize| {
        let (stroke, mark) = series(index);
        let entry = Entry::line(name, Stroke { dash: SOLID, width: if index == 0 { 5.5 } else { 3.5 }, ..stroke });
        Entry { mark: (index < 3).then_some((mark, stroke.color)), ..entry }
    };
    let mut left = Entry::line("Separation", separation)
        .and(quantity(impact.contact_time, "s"))
        .and(format!("rebound at {}", quantity(impact.rebound_speed, "m/s")));
    if impact.has_dent() {
        left = left.and(format!("dent δᵣ = {}", quantity(impact.residual_indentation, "m")));
    }
    vec![
        curve("Force F", 3).and(format!("Fₘ = {}", quantity(impact.peak_force, "N"))),
        curve("Approach δ", 0).and(format!("δₘ = {}", quantity(impact.peak_indentation, "m"))),
        curve("Sphere δₛ", 1),
        curve("Half-space δₕ", 2),
        curve("Speed δ′", 4).and(format!("impact at {}", quantity(impact.speed, "m/s"))),
        Entry::line("Peak", peak).and(quantity(impact.loading_time, "s")),
        left,
        Entry::text(&format!("Restitution e = {}", number(impact.restitution))),
    ]
}
