//! Loops of force against indentation: solid where the contact loads, dashed where it unloads.

use crate::impact::{Event, Impact, TraceRow};
use crate::report::chart::{Series, Style};

type Points = Vec<(f64, f64)>;

/// The three indentations of a contact, and the widths of their lines \[px\]. With a rigid sphere the loop of the
/// half-space lies on that of the approach; with equal elastic bodies it lies on that of the sphere.
pub const INDENTATIONS: [(&str, f64); 3] = [("Approach δ", 7.0), ("Sphere δₛ", 5.0), ("Half-space δₕ", 3.0)];

/// A row of a loop: the three indentations, and the force.
pub type LoopRow = ([f64; 3], f64);

/// The parts of a loop in the order of time, each with whether the contact loads.
pub type LoopBranches = Vec<(bool, Vec<LoopRow>)>;

/// The points without those between two others without force.
fn without_zero_force(points: Points) -> Points {
    let is_idle = |i: usize| points.get(i).is_none_or(|at| at.1 == 0.0);
    let moving = (0..points.len()).filter(|i| !(is_idle(*i) && is_idle(i + 1) && (*i == 0 || is_idle(i - 1))));
    let moving: Points = moving.map(|i| points[i]).collect();
    if moving.is_empty() { points } else { moving }
}

/// The series of a loop against one of the indentations.
pub fn loop_series(name: impl Into<String>, style: Style, branches: &LoopBranches, which: usize) -> Vec<Series> {
    let mut first = Some(Series::line(name, Vec::new()).with_style(style));
    let series = branches.iter().map(|(loads, rows)| {
        // a sphere that has left the surface moves without force
        let points =
            without_zero_force(rows.iter().map(|(indentations, force)| (indentations[which], *force)).collect());
        match first.take() {
            Some(first) => Series { points, ..first },
            None => Series::line("", points).with_style(style.with_line_of_branch(usize::from(!loads))),
        }
    });
    series.collect()
}

pub fn indentations(row: &TraceRow) -> [f64; 3] {
    [row.indentation, row.sphere_indentation, row.half_space_indentation]
}

/// The loop of an impact; `None` without a trace.
pub fn impact_loop(impact: &Impact) -> Option<LoopBranches> {
    let trace = &impact.trace;
    // a sphere that creeps to rest has no turning point; its last row is the deepest
    let turn = trace.iter().position(|row| row.event == Some(Event::Peak));
    let turn = turn.or_else(|| impact.captured_result().and_then(|_| trace.len().checked_sub(1)))?;
    let rows = |rows: &[TraceRow]| rows.iter().map(|row| (indentations(row), row.force)).collect();
    Some(vec![(true, rows(&trace[..=turn])), (false, rows(&trace[turn..]))])
}

/// The loops of [`INDENTATIONS`]. The half-space of a rigid sphere has the whole approach, which is then drawn alone.
pub fn indentation_loops(branches: &LoopBranches) -> Vec<Series> {
    let is_rigid = branches.iter().flat_map(|(_, rows)| rows).all(|([_, sphere, _], _)| *sphere == 0.0);
    let drawn = INDENTATIONS.into_iter().enumerate().take(if is_rigid { 1 } else { INDENTATIONS.len() });
    drawn.flat_map(|(i, (name, width))| loop_series(name, loop_style(i, width), branches, i)).collect()
}

/// The style of the loop with this number. Loops may lie on each other, so each is narrower than the one before.
pub fn loop_style(number: usize, width: f64) -> Style {
    Style::new(number).with_solid_line().with_width(width)
}
