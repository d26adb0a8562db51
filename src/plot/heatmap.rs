//! A quantity over two axes in colour, with a colour bar, such as restitution over speed and strength.

use plotters::style::RGBColor;
use plotters::style::colors::colormaps::{ColorMap, ViridisRGB};

use super::PlotError;
use super::axis::Axis;
use super::chart::{Cell, Chart};
use super::style::GRID;

/// A map of values on a grid. Along each axis the places rise or fall, and there are at least two. `values` holds row
/// after row: a value for each of `columns`, for each of `rows`. A value that is not finite is drawn in grey. The cells
/// fill the box, so the ranges of `x` and `y` are ignored; the range of `color` is that of the colours.
///
/// # Errors
/// [`PlotError::Data`] if the lengths of the lists do not fit.
pub fn heatmap(
    title: &str,
    [x, y]: [Axis; 2],
    [columns, rows]: [&[f64]; 2],
    values: &[f64],
    color: Axis,
) -> Result<Chart, PlotError> {
    if columns.len() < 2 || rows.len() < 2 || values.len() != columns.len() * rows.len() {
        return Err(PlotError::Data(format!(
            "a heat map of {} by {} cannot hold {} values; it needs at least 2 by 2",
            columns.len(),
            rows.len(),
            values.len()
        )));
    }
    let (x_edges, y_edges) = (edges(&x, columns), edges(&y, rows));
    let full = |axis: Axis, edges: &[f64]| {
        let (first, last) = (edges[0], edges[edges.len() - 1]);
        axis.between(first.min(last), first.max(last))
    };
    let colors = color.fitted(values.iter().copied());
    let cell = |(at, value): (usize, &f64)| {
        let (column, row) = (at % columns.len(), at / columns.len());
        let (from, to) = ((x_edges[column], y_edges[row]), (x_edges[column + 1], y_edges[row + 1]));
        Cell { from, to, color: shade(colors.at(*value)) }
    };
    let mut chart = Chart::new(title, [full(x, &x_edges), full(y, &y_edges)], Vec::new());
    chart.panels[0].cells = values.iter().enumerate().map(cell).collect();
    chart.colors = Some((color.between(colors.value_at(0.0), colors.value_at(1.0)), shade));
    Ok(chart)
}

/// The colour at a share of the axis of colours, from the colour map viridis; grey if it is not finite.
fn shade(share: f64) -> RGBColor {
    if share.is_finite() { ViridisRGB.get_color(share.clamp(0.0, 1.0)) } else { GRID }
}

/// Borders of the cells: half-way between neighbouring values, on the scale of the axis.
fn edges(axis: &Axis, values: &[f64]) -> Vec<f64> {
    let n = values.len();
    let scaled = |at: usize| axis.scale.of(values[at]);
    let outer = |at: usize, inward: usize| 1.5 * scaled(at) - 0.5 * scaled(inward);
    let inner = (1..n).map(|at| 0.5 * (scaled(at - 1) + scaled(at)));
    let all = [outer(0, 1)].into_iter().chain(inner).chain([outer(n - 1, n - 2)]);
    all.map(|edge| axis.scale.back(edge)).collect()
}
