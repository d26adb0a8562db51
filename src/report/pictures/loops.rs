//! Loops of force against indentation: solid where the contact loads, dashed where it unloads.

use crate::impact::{Event, Impact, TraceRow};
use crate::report::chart::{Axis, Chart, Series, Style};

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

/// A sphere with less than this share of the largest indentation has a box of its own: its loop would be too narrow.
const NARROW_SHARE: f64 = 0.35;

/// The loops of [`INDENTATIONS`] that share the box of the approach, and those of a box for the sphere alone.
pub fn split_by_width(branches: &LoopBranches) -> (Vec<Series>, Vec<Series>) {
    let drawn = |i: usize| {
        let (name, width) = INDENTATIONS[i];
        loop_series(name, loop_style(i, width), branches, i)
    };
    let [approach, sphere, half_space] = [0, 1, 2].map(drawn);
    let share = max_indentation(&sphere) / max_indentation(&approach);
    if share == 0.0 {
        // the half-space of a rigid sphere has the whole approach
        (approach, Vec::new())
    } else if share < NARROW_SHARE {
        ([approach, half_space].concat(), sphere)
    } else {
        ([approach, sphere, half_space].concat(), Vec::new())
    }
}

/// The picture with these loops of the sphere in a box of their own, if there are any.
pub fn with_sphere_panel(chart: Chart, sphere: Vec<Series>) -> Chart {
    if sphere.is_empty() {
        return chart;
    }
    let x = Axis::linear("Indentation of the sphere", "m").with_range(0.0, 1.15 * max_indentation(&sphere));
    chart.with_side_panel(x, sphere)
}

/// The largest indentation of a loop.
fn max_indentation(series: &[Series]) -> f64 {
    series.iter().flat_map(|one| &one.points).map(|at| at.0).fold(0.0, f64::max)
}

/// The style of the loop with this number. Loops may lie on each other, so each is narrower than the one before.
pub fn loop_style(number: usize, width: f64) -> Style {
    Style::new(number).with_solid_line().with_width(width)
}
