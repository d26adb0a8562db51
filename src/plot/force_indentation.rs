//! Force against the approach, and against the indentations of sphere and half-space, during loading and unloading: the
//! loops of Xie et al. (2024), Figs. 8 and 12.

use super::PlotError;
use super::axis::Axis;
use super::canvas::Canvas;
use super::key::Entry;
use super::sheet::single;
use super::style::{DASHED, DOTTED, GREY, INK, Mark, Marker, SOLID, Stroke, solid};
use crate::impact::{Event, Impact, TraceRow};
use crate::units::rounded::{number, quantity};

/// Radius of markers \[px\].
const MARK: f64 = 9.0;
const PEAK: Marker = Marker { shape: Mark::Square, radius: MARK, color: INK };
const DENT: Marker = Marker { shape: Mark::Inverted, ..PEAK };
const YIELD: Marker = Marker { shape: Mark::Diamond, ..PEAK };
const KNOT: Marker = Marker { shape: Mark::Circle, radius: 4.0, ..PEAK };

/// One of the three loops.
struct Loop {
    name: &'static str,
    indentation: fn(&TraceRow) -> f64,
    width: f64,
    /// Force over peak force of the markers on loading and unloading. They differ from loop to loop, so that the
    /// markers are seen where loops lie on each other.
    marks: [f64; 2],
}

/// The loops in the order of drawing, each narrower than the one before, because loops may lie on each other. With a
/// rigid sphere the loop of the half-space lies on that of the approach; with equal elastic bodies it lies on that of
/// the sphere.
const LOOPS: [Loop; 3] = [
    Loop { name: "Approach δ", indentation: |row| row.indentation, width: 7.0, marks: [0.5, 0.7] },
    Loop { name: "Sphere δₛ", indentation: |row| row.sphere_indentation, width: 5.0, marks: [0.35, 0.85] },
    Loop { name: "Half-space δₕ", indentation: |row| row.half_space_indentation, width: 3.0, marks: [0.65, 0.45] },
];

impl Loop {
    /// Its style if it is the loop of this number.
    fn style(&self, index: usize) -> (Stroke, Marker) {
        solid(index, self.width, MARK)
    }

    fn place(&self, row: &TraceRow) -> (f64, f64) {
        ((self.indentation)(row), row.force)
    }
}

/// The picture of force against indentation of an impact. A trace of some hundred samples gives smooth curves.
///
/// # Errors
/// [`PlotError::Data`] for an impact without a trace; other [`PlotError`]s from drawing.
pub fn force_indentation(impact: &Impact) -> Result<Canvas, PlotError> {
    let trace = &impact.trace;
    // a sphere that creeps to rest has no turning point; its last row is the deepest
    let turn = trace.iter().position(|row| row.event == Some(Event::Peak));
    let Some(turn) = turn.or_else(|| impact.captured().and_then(|_| trace.len().checked_sub(1))) else {
        return Err(PlotError::Data("force against indentation needs a trace: run the impact with samples".into()));
    };
    let (loading, unloading) = (&trace[..=turn], &trace[turn..]);
    let x = Axis::engineering("Indentation", "m").between(0.0, 1.06 * impact.peak_indentation).fitted([]);
    let y = Axis::engineering("Force", "N").between(0.0, 1.08 * largest_force(impact)).fitted([]);
    single(&title(impact), [x, y], &entries(impact), |frame, canvas| {
        let guide = Stroke { color: GREY, width: 2.0, dash: DOTTED };
        let peak = (impact.peak_indentation, impact.peak_force);
        frame.curve(canvas, [(0.0, peak.1), peak, (peak.0, 0.0)], guide);
        frame.draw_outline(canvas);
        for (i, one) in LOOPS.iter().enumerate() {
            for (part, dash) in [(loading, SOLID), (unloading, DASHED)] {
                frame.curve(canvas, part.iter().map(|row| one.place(row)), Stroke { dash, ..one.style(i).0 });
            }
        }
        if is_damped(impact) {
            for part in [loading, unloading] {
                let curve = part.iter().filter_map(|row| Some((row.indentation, row.elastic_force?)));
                frame.curve(canvas, curve, ELASTIC);
            }
        }
        for (i, one) in LOOPS.iter().enumerate() {
            for (part, share) in [loading, unloading].into_iter().zip(one.marks) {
                if let Some(row) = near_force(part, share * impact.peak_force) {
                    frame.mark(canvas, one.place(row), one.style(i).1);
                }
            }
        }
        for row in trace {
            let marker = match row.event {
                Some(Event::Yield) => YIELD,
                Some(Event::Knot) => KNOT,
                _ => continue,
            };
            frame.mark(canvas, (row.indentation, row.force), marker);
        }
        frame.mark(canvas, peak, PEAK);
        if impact.has_dent() {
            frame.mark(canvas, (impact.residual_indentation, 0.0), DENT);
        }
    })
}

/// The row of a branch whose force is nearest to `force`.
fn near_force(rows: &[TraceRow], force: f64) -> Option<&TraceRow> {
    rows.iter().min_by(|a, b| (a.force - force).abs().total_cmp(&(b.force - force).abs()))
}

fn entries(impact: &Impact) -> Vec<Entry> {
    let length = |value| quantity(value, "m");
    let entry = |(i, one): (usize, &Loop)| {
        let (stroke, marker) = one.style(i);
        Entry::line(one.name, stroke).marked(marker)
    };
    let mut entries: Vec<Entry> = LOOPS.iter().enumerate().map(entry).collect();
    let branches: &[&str] = if impact.has_dent() { &["loading", "unloading"] } else { &["loading and unloading"] };
    entries.extend(Entry::branches(branches));
    if is_damped(impact) {
        entries.push(Entry::line("force of the law", ELASTIC).and("without damping, against δ"));
    }
    let at_peak = format!("δₘ = {}", length(impact.peak_indentation));
    entries.push(Entry::mark(peak_name(impact), PEAK).and(force_at_peak(impact)).and(at_peak));
    if impact.has_dent() {
        let residual = format!("δᵣ = {}", length(impact.residual_indentation));
        entries.push(Entry::mark("Residual indentation", DENT).and(residual));
    }
    for (event, name, marker) in [(Event::Yield, "First yield", YIELD), (Event::Knot, "Knot of the law", KNOT)] {
        if impact.trace.iter().any(|row| row.event == Some(event)) {
            entries.push(Entry::mark(name, marker));
        }
    }
    entries
}

/// Line of the force of the law without damping. The other curves include the damping.
const ELASTIC: Stroke = Stroke { color: INK, width: 2.0, dash: DOTTED };

pub(super) fn is_damped(impact: &Impact) -> bool {
    impact.under_forces.is_some_and(|under| under.damping_loss.is_some())
}

/// The name of the turning point. With damping it is not the peak of the force, which is largest before it.
pub(super) fn peak_name(impact: &Impact) -> &'static str {
    if is_damped(impact) { "Deepest point" } else { "Peak" }
}

/// The force at the turning point. It is the peak force F_m only without damping.
pub(super) fn force_at_peak(impact: &Impact) -> String {
    let force = quantity(impact.peak_force, "N");
    if is_damped(impact) { format!("F = {force} there") } else { format!("Fₘ = {force}") }
}

/// The largest force in the pictures. With damping it occurs before the peak indentation.
pub(super) fn largest_force(impact: &Impact) -> f64 {
    if is_damped(impact) {
        impact.trace.iter().fold(impact.peak_force, |largest, row| largest.max(row.force))
    } else {
        impact.peak_force
    }
}

/// The title of the pictures of one impact.
pub(super) fn title(impact: &Impact) -> String {
    if impact.captured().is_some() {
        return format!("Impact at {}: captured", quantity(impact.speed, "m/s"));
    }
    format!("Impact at {}: restitution e = {}", quantity(impact.speed, "m/s"), number(impact.restitution))
}
