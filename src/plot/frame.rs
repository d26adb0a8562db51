//! A box with two axes: draws grid, ticks and titles, and curves that are clipped to the box.

use super::axis::FittedAxis;
use super::canvas::{Anchor, Canvas, Point, text_width, wrapped};
use super::style::{AXIS_SIZE, GRID, INK, LABEL_SIZE, Mark, Marker, PAPER, SOLID, Stroke, TITLE_SIZE};
use super::{PlotError, SIZE};

/// Distance between labels of the horizontal and of the vertical axis \[px\].
const LABEL_DISTANCE: (f64, f64) = (150.0, 90.0);

/// Largest length of a line of the title \[px\], and the text size of a title in two lines.
const TITLE_ROOM: f64 = SIZE.0 as f64 - 40.0;
const TWO_LINES: f64 = 30.0;

/// Smallest number of labels that a vertical axis aims at, even in a low box.
const FEWEST: f64 = 4.0;
const GRID_LINE: Stroke = Stroke { color: GRID, width: 1.5, dash: SOLID };
const TICK: Stroke = Stroke { color: INK, width: 2.0, dash: SOLID };

fn tick_length(is_major: bool) -> f64 {
    if is_major { 10.0 } else { 5.0 }
}

/// Where the box lies on the picture \[px\].
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

pub(super) struct Frame {
    pub bounds: Bounds,
    pub x: FittedAxis,
    pub y: FittedAxis,
}

impl Frame {
    pub(super) fn place(&self, x: f64, y: f64) -> Point {
        let Bounds { left, top, right, bottom } = self.bounds;
        (left + self.x.at(x) * (right - left), bottom - self.y.at(y) * (bottom - top))
    }

    /// Grid, ticks, labels and titles of both axes.
    pub(super) fn draw_axes(&self, canvas: &mut Canvas) -> Result<(), PlotError> {
        self.draw_x(canvas, true)?;
        self.draw_y(canvas)
    }

    /// Draws the horizontal axis. It has no labels if a box below has the same axis.
    pub(super) fn draw_x(&self, canvas: &mut Canvas, has_labels: bool) -> Result<(), PlotError> {
        let Bounds { left, top, right, bottom } = self.bounds;
        for mark in self.x.ticks((right - left) / LABEL_DISTANCE.0) {
            let x = left + mark.at * (right - left);
            let is_major = mark.label.is_some();
            if is_major {
                canvas.polyline(&[(x, top), (x, bottom)], GRID_LINE);
            }
            canvas.polyline(&[(x, bottom), (x, bottom + tick_length(is_major))], TICK);
            if let Some(label) = mark.label.filter(|_| has_labels) {
                canvas.text(&label, (x, bottom + 32.0), LABEL_SIZE, INK, Anchor::Middle)?;
            }
        }
        if has_labels {
            canvas.text(&self.x.title, (0.5 * (left + right), bottom + 82.0), AXIS_SIZE, INK, Anchor::Middle)?;
        }
        Ok(())
    }

    /// Draws the vertical axis.
    pub(super) fn draw_y(&self, canvas: &mut Canvas) -> Result<(), PlotError> {
        let Bounds { left, top, right, bottom } = self.bounds;
        let mut widest: f64 = 0.0;
        for mark in self.y.ticks(((bottom - top) / LABEL_DISTANCE.1).max(FEWEST)) {
            let y = bottom - mark.at * (bottom - top);
            let is_major = mark.label.is_some();
            if is_major {
                canvas.polyline(&[(left, y), (right, y)], GRID_LINE);
            }
            canvas.polyline(&[(left - tick_length(is_major), y), (left, y)], TICK);
            if let Some(label) = mark.label {
                widest = widest.max(text_width(&label, LABEL_SIZE)?);
                canvas.text(&label, (left - 18.0, y), LABEL_SIZE, INK, Anchor::End)?;
            }
        }
        let title_at = (left - 18.0 - widest - 34.0).max(24.0);
        canvas.text_upward(&self.y.title, (title_at, 0.5 * (top + bottom)), AXIS_SIZE, INK)
    }

    /// Draws the outline, over the ends of the curves.
    pub(super) fn draw_outline(&self, canvas: &mut Canvas) {
        let Bounds { left, top, right, bottom } = self.bounds;
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        canvas.polyline(&corners, Stroke::solid(INK, 2.0));
    }

    /// Draws the title above the box. A long title is drawn in two lines, and smaller if needed.
    pub(super) fn draw_title(&self, canvas: &mut Canvas, title: &str) -> Result<(), PlotError> {
        let middle = 0.5 * (self.bounds.left + self.bounds.right);
        let height = self.bounds.top - 42.0;
        if text_width(title, TITLE_SIZE)? <= TITLE_ROOM {
            return canvas.text(title, (middle, height), TITLE_SIZE, INK, Anchor::Middle);
        }
        let mut size = TWO_LINES;
        let mut lines = wrapped(title, size, TITLE_ROOM)?;
        while lines.len() > 2 && size > 1.0 {
            size *= 0.95;
            lines = wrapped(title, size, TITLE_ROOM)?;
        }
        for (line, shift) in lines.iter().zip([-18.0, 18.0]) {
            canvas.text(line, (middle, height + shift), size, INK, Anchor::Middle)?;
        }
        Ok(())
    }

    /// Draws a curve through values. Parts outside the box are cut off.
    pub(super) fn curve(&self, canvas: &mut Canvas, values: impl IntoIterator<Item = (f64, f64)>, stroke: Stroke) {
        let mut piece: Vec<Point> = Vec::new();
        let mut before: Option<Point> = None;
        for (x, y) in values {
            let point = self.place(x, y);
            if !point.0.is_finite() || !point.1.is_finite() {
                canvas.polyline(&std::mem::take(&mut piece), stroke);
                before = None;
                continue;
            }
            if let Some((from, to)) = before.and_then(|before| self.clipped(before, point)) {
                if piece.last() != Some(&from) {
                    canvas.polyline(&std::mem::take(&mut piece), stroke);
                    piece.push(from);
                }
                piece.push(to);
            }
            before = Some(point);
        }
        canvas.polyline(&piece, stroke);
    }

    /// Draws a marker with a white rim, if it is inside the box.
    pub(super) fn mark(&self, canvas: &mut Canvas, (x, y): (f64, f64), marker: Marker) {
        let at = self.place(x, y);
        let Bounds { left, top, right, bottom } = self.bounds;
        // half a pixel is allowed for rounding
        if !(left - 0.5..=right + 0.5).contains(&at.0) || !(top - 0.5..=bottom + 0.5).contains(&at.1) {
            return;
        }
        if !matches!(marker.shape, Mark::Cross | Mark::Plus) {
            Marker { radius: marker.radius + 2.0, color: PAPER, ..marker }.draw(canvas, at);
        }
        marker.draw(canvas, at);
    }

    /// The part of a straight line inside the box (Liang and Barsky 1984).
    fn clipped(&self, from: Point, to: Point) -> Option<(Point, Point)> {
        let Bounds { left, top, right, bottom } = self.bounds;
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for (along, room) in [(-dx, from.0 - left), (dx, right - from.0), (-dy, from.1 - top), (dy, bottom - from.1)] {
            if along == 0.0 {
                if room < -0.5 {
                    return None;
                }
            } else if along < 0.0 {
                enter = enter.max(room / along);
            } else {
                leave = leave.min(room / along);
            }
        }
        let at = |share: f64| (from.0 + share * dx, from.1 + share * dy);
        (enter <= leave)
            .then(|| (if enter == 0.0 { from } else { at(enter) }, if leave == 1.0 { to } else { at(leave) }))
    }
}
