//! A box with two axes: draws grid, ticks and titles, and curves that are clipped to the box.

use crate::error::Error;
use plotters::prelude::DrawingBackend;

use super::axis::FittedAxis;
use super::pen::{Anchor, Pen, Point};
use super::style::{AXIS_SIZE, LABEL_SIZE, TITLE_SIZE};
use super::text::{fitting_size, text_width, with_minus};
use super::{BACKGROUND, FOREGROUND, GREY, GRID, Marker, Style};
use crate::numerics::functions::{exp, ln};

/// Margins around the boxes for labels and titles \[px\].
pub const LEFT: f64 = 165.0;
pub const TOP: f64 = 122.0;
pub const BOTTOM: f64 = 125.0;

/// Distance between labels of the horizontal and of the vertical axis \[px\].
const LABEL_DISTANCE: (f64, f64) = (150.0, 90.0);
/// Least room between two labels of the horizontal axis \[px\].
pub const LABEL_GAP: f64 = 12.0;
/// Distance of the labels, and of the title of the horizontal axis, from the box \[px\].
const LABELS: (f64, f64) = (18.0, 32.0);
const X_TITLE: f64 = 82.0;
/// By how much the title of an axis may be longer than its box, and the size of its letters in two lines \[px\].
const TITLE_OVERHANG: f64 = 16.0;
const SMALL_TITLE: f64 = 26.0;
/// Points of a curve between a positive value and the edge of a logarithmic axis.
const EDGE_POINTS: i32 = 8;
/// Distance of the title of the vertical axis from its labels, and its least distance from the edge \[px\].
const Y_TITLE: (f64, f64) = (34.0, 24.0);
/// Heights of the middle of the title and of the caption above the box \[px\].
const TITLE: f64 = 80.0;
const CAPTION: f64 = 32.0;

fn tick_length(is_major: bool) -> f64 {
    if is_major { 10.0 } else { 5.0 }
}

/// Where the box lies on the picture \[px\].
#[derive(Debug, Clone, Copy)]
pub struct Bounds {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

pub struct PanelFrame {
    pub bounds: Bounds,
    pub x: FittedAxis,
    pub y: FittedAxis,
}

impl PanelFrame {
    pub fn to_pixels(&self, (x, y): (f64, f64)) -> Point {
        let Bounds { left, top, right, bottom } = self.bounds;
        (left + self.x.position(x) * (right - left), bottom - self.y.position(y) * (bottom - top))
    }

    /// Draws the horizontal axis. It has no labels if a box below has the same axis.
    pub fn draw_x<B: DrawingBackend>(&self, pen: &mut Pen<B>, has_labels: bool) -> Result<(), Error> {
        let Bounds { left, top, right, bottom } = self.bounds;
        let extent = |label: &str| text_width(label, LABEL_SIZE) + LABEL_GAP;
        for tick in self.x.ticks(right - left, LABEL_DISTANCE.0, extent) {
            let x = left + tick.at * (right - left);
            if tick.label.is_some() {
                pen.draw_polyline(&[(x, top), (x, bottom)], Style::line(GRID, 1.5))?;
            }
            let end = bottom + tick_length(tick.label.is_some());
            pen.draw_polyline(&[(x, bottom), (x, end)], Style::line(FOREGROUND, 2.0))?;
            if let Some(label) = tick.label.filter(|_| has_labels) {
                pen.draw_text(&label, (x, bottom + LABELS.1), LABEL_SIZE, FOREGROUND, Anchor::Middle)?;
            }
        }
        if !has_labels {
            return Ok(());
        }
        // a title that is longer than its box has two lines in smaller letters
        let (middle, room) = (0.5 * (left + right), right - left + TITLE_OVERHANG);
        if text_width(&self.x.title, AXIS_SIZE) <= room {
            return pen.draw_text(&self.x.title, (middle, bottom + X_TITLE), AXIS_SIZE, FOREGROUND, Anchor::Middle);
        }
        let (first, second) = split_title(&self.x.title);
        let longest = if text_width(first, AXIS_SIZE) > text_width(second, AXIS_SIZE) { first } else { second };
        let size = fitting_size(longest, SMALL_TITLE, room);
        for (line, at) in [(first, X_TITLE - 0.5 * SMALL_TITLE), (second, X_TITLE + 0.65 * SMALL_TITLE)] {
            pen.draw_text(line, (middle, bottom + at), size, FOREGROUND, Anchor::Middle)?;
        }
        Ok(())
    }

    /// Draws the vertical axis.
    pub fn draw_y<B: DrawingBackend>(&self, pen: &mut Pen<B>) -> Result<(), Error> {
        let Bounds { left, top, right, bottom } = self.bounds;
        let mut widest: f64 = 0.0;
        for tick in self.y.ticks(bottom - top, LABEL_DISTANCE.1, |_| LABEL_SIZE) {
            let y = bottom - tick.at * (bottom - top);
            if tick.label.is_some() {
                pen.draw_polyline(&[(left, y), (right, y)], Style::line(GRID, 1.5))?;
            }
            pen.draw_polyline(
                &[(left - tick_length(tick.label.is_some()), y), (left, y)],
                Style::line(FOREGROUND, 2.0),
            )?;
            if let Some(label) = tick.label {
                widest = widest.max(text_width(&label, LABEL_SIZE));
                pen.draw_text(&label, (left - LABELS.0, y), LABEL_SIZE, FOREGROUND, Anchor::End)?;
            }
        }
        let title_at = (left - LABELS.0 - widest - Y_TITLE.0).max(Y_TITLE.1);
        let size = fitting_size(&self.y.title, AXIS_SIZE, bottom - top + TITLE_OVERHANG);
        pen.draw_text(&self.y.title, (title_at, 0.5 * (top + bottom)), size, FOREGROUND, Anchor::Upward)
    }

    /// Draws the outline, over the ends of the curves.
    pub fn draw_outline<B: DrawingBackend>(&self, pen: &mut Pen<B>) -> Result<(), Error> {
        let Bounds { left, top, right, bottom } = self.bounds;
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        pen.draw_polyline(&corners, Style::line(FOREGROUND, 2.0))
    }

    /// Draws a curve through values. Parts outside the box are cut off, and values that are not finite interrupt it. On a
    /// logarithmic vertical axis, a curve that falls to zero or below goes to the edge of the box.
    pub fn draw_curve<B: DrawingBackend>(
        &self,
        pen: &mut Pen<B>,
        values: &[(f64, f64)],
        style: Style,
    ) -> Result<(), Error> {
        let mut piece: Vec<Point> = Vec::new();
        let to_edge: Vec<(f64, f64)>;
        let values = if self.y.is_logarithmic() {
            let from = if self.x.is_logarithmic() { 0.0 } else { f64::NEG_INFINITY };
            to_edge = down_to_edge(values, self.y.value_at(0.0), from);
            &to_edge
        } else {
            values
        };
        for pair in values.windows(2) {
            let clipped = self.bounds.clip_segment(self.to_pixels(pair[0]), self.to_pixels(pair[1]));
            if piece.last().copied() != clipped.map(|(from, _)| from) {
                pen.draw_polyline(&std::mem::take(&mut piece), style)?;
                piece.extend(clipped.map(|(from, _)| from));
            }
            piece.extend(clipped.map(|(_, to)| to));
        }
        pen.draw_polyline(&piece, style)
    }

    /// Draws a marker with a white rim, if it is inside the box.
    pub fn draw_marker<B: DrawingBackend>(
        &self,
        pen: &mut Pen<B>,
        value: (f64, f64),
        style: Style,
    ) -> Result<(), Error> {
        let at = self.to_pixels(value);
        let Bounds { left, top, right, bottom } = self.bounds;
        // half a pixel is allowed for rounding
        if !(left - 0.5..=right + 0.5).contains(&at.0) || !(top - 0.5..=bottom + 0.5).contains(&at.1) {
            return Ok(());
        }
        if !matches!(style.mark, Marker::Cross | Marker::Plus) {
            pen.draw_marker(at, Style { radius: style.radius + 2.0, color: BACKGROUND, ..style })?;
        }
        pen.draw_marker(at, style)
    }
}

/// The values of a curve with points on each straight piece from a positive value to one that is not positive, down to
/// `low`. A logarithmic axis cannot show the rest of the piece. Pieces that end at `from` or before have no such points: a
/// straight piece from the origin would not follow a power law on logarithmic axes.
fn down_to_edge(values: &[(f64, f64)], low: f64, from: f64) -> Vec<(f64, f64)> {
    let mut points = Vec::with_capacity(values.len());
    for (i, end) in values.iter().enumerate() {
        if let Some(begin) = i.checked_sub(1).map(|before| values[before]) {
            let (upper, lower) = if begin.1 > end.1 { (begin, *end) } else { (*end, begin) };
            if upper.1 > low && lower.1 <= 0.0 && lower.0 > from {
                let share = |i: i32| f64::from(i) / f64::from(EDGE_POINTS);
                let height = |i: i32| exp(ln(upper.1) + share(i) * (ln(low) - ln(upper.1)));
                let place = |y: f64| lower.0 + (upper.0 - lower.0) * (y - lower.1) / (upper.1 - lower.1);
                let mut piece: Vec<_> = (1..=EDGE_POINTS).map(height).map(|y| (place(y), y)).collect();
                if begin.1 < end.1 {
                    piece.reverse();
                }
                points.extend(piece);
            }
        }
        points.push(*end);
    }
    points
}

/// A title in two lines: it is divided at the space nearest to its middle.
fn split_title(title: &str) -> (&str, &str) {
    let middle = title.len() / 2;
    let spaces = title.match_indices(' ').map(|(at, _)| at);
    match spaces.min_by_key(|at| at.abs_diff(middle)) {
        Some(at) => (&title[..at], &title[at + 1..]),
        None => (title, ""),
    }
}

/// Draws the title above the boxes, and below it in grey the caption, which names bodies and law. Long texts are drawn
/// smaller.
pub fn draw_titles<B: DrawingBackend>(pen: &mut Pen<B>, all: Bounds, titles: [&str; 2]) -> Result<(), Error> {
    let middle = 0.5 * (all.left + all.right);
    let [title, caption] = &titles.map(with_minus);
    if caption.is_empty() {
        let between = 0.5 * (TITLE + CAPTION);
        return pen.draw_text(title, (middle, all.top - between), TITLE_SIZE, FOREGROUND, Anchor::Middle);
    }
    pen.draw_text(title, (middle, all.top - TITLE), TITLE_SIZE, FOREGROUND, Anchor::Middle)?;
    pen.draw_text(caption, (middle, all.top - CAPTION), LABEL_SIZE, GREY, Anchor::Middle)
}

impl Bounds {
    /// The place inside that is nearest to this one.
    pub fn clamp(&self, (x, y): Point) -> Point {
        (x.clamp(self.left, self.right), y.clamp(self.top, self.bottom))
    }

    /// The part of a straight line inside (Liang and Barsky 1984); none if an end is not finite.
    pub fn clip_segment(&self, from: Point, to: Point) -> Option<(Point, Point)> {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        if !dx.is_finite() || !dy.is_finite() {
            return None;
        }
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        let rooms = [from.0 - self.left, self.right - from.0, from.1 - self.top, self.bottom - from.1];
        for (along, room) in [-dx, dx, -dy, dy].into_iter().zip(rooms) {
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
