//! Loops of force against indentation: solid where the contact loads, dashed where it unloads.

use super::series::Series;
use super::style::Style;

type Points = Vec<(f64, f64)>;

/// The three indentations of a contact, and the widths of their lines \[px\]. With a rigid sphere the loop of the half-space lies on
/// that of the approach; with equal elastic bodies it lies on that of the sphere.
pub const INDENTATIONS: [(&str, f64); 3] = [("Approach δ", 7.0), ("Sphere δₛ", 5.0), ("Half-space δₕ", 3.0)];

/// The series of a loop. `first` has its name, look and style; `branches` are its parts in the order of time, each with
/// whether the contact loads.
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

/// The style of the loop with this number. Loops may lie on each other, so each is narrower than the one before.
pub fn style(number: usize, width: f64) -> Style {
    Style::of(number).solid().wide(width)
}
