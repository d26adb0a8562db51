//! Loops of force against indentation: solid where the contact loads, dashed where it unloads.

use super::series::Series;
use super::style::Style;
use crate::impact::{Event, Impact, TraceRow};

type Points = Vec<(f64, f64)>;

/// The three indentations of a contact, and the widths of their lines \[px\]. With a rigid sphere the loop of the
/// half-space lies on that of the approach; with equal elastic bodies it lies on that of the sphere.
pub const INDENTATIONS: [(&str, f64); 3] = [("Approach δ", 7.0), ("Sphere δₛ", 5.0), ("Half-space δₕ", 3.0)];

/// The series of a loop. `first` has its name and look; `branches` are its parts in the order of time, each with whether
/// the contact loads.
pub fn series(first: Series, style: Style, branches: impl IntoIterator<Item = (bool, Points)>) -> Vec<Series> {
    let mut first = Some(first.styled(style));
    let series = branches.into_iter().map(|(is_loading, points)| {
        let drawn = style.branch(usize::from(!is_loading));
        match first.take() {
            Some(first) => Series { points, ..first },
            None => Series::bare("", points).styled(drawn),
        }
    });
    series.collect()
}

/// The loop of an impact against a kind of indentation; `None` without a trace.
pub fn of_impact(
    impact: &Impact,
    first: Series,
    style: Style,
    indentation: impl Fn(&TraceRow) -> f64,
) -> Option<Vec<Series>> {
    let trace = &impact.trace;
    // a sphere that creeps to rest has no turning point; its last row is the deepest
    let turn = trace.iter().position(|row| row.event == Some(Event::Peak));
    let turn = turn.or_else(|| impact.captured().and_then(|_| trace.len().checked_sub(1)))?;
    let points = |rows: &[TraceRow]| rows.iter().map(|row| (indentation(row), row.force)).collect();
    Some(series(first, style, [(true, points(&trace[..=turn])), (false, points(&trace[turn..]))]))
}

/// The style of the loop with this number. Loops may lie on each other, so each is narrower than the one before.
pub fn style(number: usize, width: f64) -> Style {
    Style::of(number).solid().wide(width)
}
