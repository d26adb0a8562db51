//! A quantity over two axes in colour, with a colour bar, such as restitution over speed and strength.

use plotters::style::RGBColor;
use plotters::style::colors::colormaps::{ColorMap, ViridisRGB};

use super::{Axis, Cell, Chart, GRID, min_max};

/// A map of values on a grid. Along each axis the positions rise or fall. A `value` (of column, row) that is not finite is
/// drawn in grey. The cells fill the box, so the ranges of `x` and `y` are ignored. The range of `color` is the range of the
/// colours; without it, the range of the values is used.
pub fn heatmap(
    title: &str,
    [x, y]: [Axis; 2],
    [columns, rows]: [&[f64]; 2],
    value: impl Fn(usize, usize) -> f64,
    color: Axis,
) -> Chart {
    let (x_edges, y_edges) = (cell_edges(&x, columns), cell_edges(&y, rows));
    let mut cells = Vec::new();
    for (row, y) in y_edges.windows(2).enumerate() {
        for (column, x) in x_edges.windows(2).enumerate() {
            cells.push(((x[0], y[0]), (x[1], y[1]), value(column, row)));
        }
    }
    let full = |axis: Axis, edges: Vec<f64>| {
        let (low, high) = min_max(edges);
        axis.with_range(low, high)
    };
    let (low, high) = min_max(cells.iter().map(|cell| cell.2).filter(|value| value.is_finite()));
    let color = if color.range.is_none() { color.with_range(low, high) } else { color };
    let colors = color.fit(cells.iter().map(|cell| cell.2));
    let cells = cells.into_iter().map(|(from, to, value)| Cell { from, to, color: color_at(colors.position(value)) });
    let mut chart = Chart::new(title, [full(x, x_edges), full(y, y_edges)], Vec::new());
    chart.panels[0].cells = cells.collect();
    chart.color_axis = Some((color.with_range(colors.value_at(0.0), colors.value_at(1.0)), color_at));
    chart
}

/// The colour at a share of the axis of colours, from the colour map viridis; grey if it is not finite.
fn color_at(share: f64) -> RGBColor {
    if share.is_finite() { ViridisRGB.get_color(share.clamp(0.0, 1.0)) } else { GRID }
}

/// Borders of the cells: half-way between neighbouring values, on the scale of the axis. Fewer than two values have none.
fn cell_edges(axis: &Axis, values: &[f64]) -> Vec<f64> {
    let scaled: Vec<f64> = values.iter().map(|value| axis.scale.transform(*value)).collect();
    let ([first, second, ..], [.., before, last]) = (&scaled[..], &scaled[..]) else { return Vec::new() };
    let outer = |at: f64, inward: f64| 1.5 * at - 0.5 * inward;
    let inner = scaled.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    let all = [outer(*first, *second)].into_iter().chain(inner).chain([outer(*last, *before)]);
    all.map(|edge| axis.scale.inverse(edge)).collect()
}
