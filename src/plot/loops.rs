//! Loops of force against indentation: solid where the contact loads, dashed where it unloads.

use super::series::Series;
use super::style::{DASHED, Style};

type Points = Vec<(f64, f64)>;

/// The series of a loop. `first` has its name, look and style; `branches` are its parts in the order of time, each with
/// whether the contact loads.
pub fn series(first: Series, style: Style, branches: impl IntoIterator<Item = (bool, Points)>) -> Vec<Series> {
    let mut first = Some(first.styled(style));
    let series = branches.into_iter().map(|(is_loading, points)| {
        let drawn = if is_loading { style } else { style.dashed(DASHED) };
        match first.take() {
            Some(first) => Series { points, ..first },
            None => Series::bare("", points).styled(drawn),
        }
    });
    series.collect()
}

/// The style of the loop with this number. Loops may lie on each other, so each is narrower than the one before.
pub fn style(number: usize, width: f64) -> Style {
    Style::of(number).solid().wide(width)
}
