//! A quantity over two axes in colour, with a colour bar, such as restitution over speed and strength.

use plotters::style::RGBColor;
use plotters::style::colors::colormaps::{ColorMap, ViridisRGB};

use super::axis::{Axis, FittedAxis};
use super::canvas::Canvas;
use super::frame::{Bounds, Frame};
use super::key::{BOTTOM, LEFT, TOP};
use super::style::GRID;
use super::{PlotError, SIZE};

/// Width of the colour bar \[px\].
const BAR: f64 = 44.0;
/// Width kept free for the colour bar and its labels \[px\].
const ROOM: f64 = 250.0;
/// Number of steps of the colour bar.
const STEPS: u32 = 256;

/// A map of the values on a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Heatmap {
    pub title: String,
    /// Horizontal axis; its `range` is ignored, because the cells fill the box.
    pub x: Axis,
    /// Vertical axis; its `range` is ignored, because the cells fill the box.
    pub y: Axis,
    /// Values along the horizontal axis: rising or falling, at least two.
    pub x_values: Vec<f64>,
    /// Values along the vertical axis: rising or falling, at least two.
    pub y_values: Vec<f64>,
    /// The values of the map, row after row: a row has one value for each of `x_values`, and there is one row for each
    /// of `y_values`. A value that is not finite is drawn in grey.
    pub values: Vec<f64>,
    /// Title and range of the colours, such as 0 … 1 for restitution.
    pub color: Axis,
}

impl Heatmap {
    /// The picture.
    ///
    /// # Errors
    /// [`PlotError::Data`] if the lengths of the lists do not fit; other [`PlotError`]s from drawing.
    pub fn draw(&self) -> Result<Canvas, PlotError> {
        let (columns, rows) = (self.x_values.len(), self.y_values.len());
        if columns < 2 || rows < 2 || self.values.len() != columns * rows {
            return Err(PlotError::Data(format!(
                "a heat map of {columns} by {rows} cannot hold {} values; it needs at least 2 by 2",
                self.values.len()
            )));
        }
        let (x_edges, y_edges) = (edges(&self.x, &self.x_values), edges(&self.y, &self.y_values));
        let mut canvas = Canvas::default();
        let (width, height) = (f64::from(SIZE.0), f64::from(SIZE.1));
        let bounds = Bounds { left: LEFT, top: TOP, right: width - ROOM, bottom: height - BOTTOM };
        let full = |axis: &Axis, edges: &[f64]| {
            let (first, last) = (edges[0], edges[edges.len() - 1]);
            axis.clone().between(first.min(last), first.max(last)).fitted([])
        };
        let frame = Frame { bounds, x: full(&self.x, &x_edges), y: full(&self.y, &y_edges) };
        let color = self.color.fitted(self.values.iter().copied());
        frame.draw_axes(&mut canvas)?;
        for (row, values) in self.values.chunks_exact(columns).enumerate() {
            for (column, value) in values.iter().enumerate() {
                let from = frame.place(x_edges[column], y_edges[row]);
                let to = frame.place(x_edges[column + 1], y_edges[row + 1]);
                let (low, high) = ((from.0.min(to.0), from.1.min(to.1)), (from.0.max(to.0), from.1.max(to.1)));
                canvas.rectangle(low, high, shade(&color, *value));
            }
        }
        frame.draw_outline(&mut canvas);
        draw_bar(&mut canvas, color, bounds)?;
        frame.draw_title(&mut canvas, &self.title)?;
        Ok(canvas)
    }
}

fn draw_bar(canvas: &mut Canvas, color: FittedAxis, bounds: Bounds) -> Result<(), PlotError> {
    let right = f64::from(SIZE.0) - 30.0;
    let bar =
        Frame { bounds: Bounds { left: right - BAR, right, ..bounds }, x: Axis::linear("", "").fitted([]), y: color };
    bar.draw_y(canvas)?;
    for step in 0..STEPS {
        let (from, to) = (f64::from(step) / f64::from(STEPS), f64::from(step + 1) / f64::from(STEPS));
        let (low, high) = (bar.place(0.0, bar.y.value_at(from)), bar.place(1.0, bar.y.value_at(to)));
        let shade = shade(&bar.y, bar.y.value_at(0.5 * (from + to)));
        canvas.rectangle((bar.bounds.left, high.1), (bar.bounds.right, low.1), shade);
    }
    bar.draw_outline(canvas);
    Ok(())
}

/// The colour of a value, from the colour map viridis; grey for a value that is not finite.
fn shade(color: &FittedAxis, value: f64) -> RGBColor {
    let share = color.at(value);
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
