//! The canvas: a list of shapes in the order of drawing. It is written as PNG (pixels) or as SVG (shapes and text).

mod png;
mod svg;

use std::fmt::Display;
use std::sync::LazyLock;

use plotters::style::{FontDesc, FontFamily, FontStyle, RGBColor, register_font};

use super::style::Stroke;
use super::{PlotError, SIZE};
use crate::math::functions::hypot;

/// A place on the picture \[px\], measured from its upper left corner.
pub(super) type Point = (f64, f64);

/// Texts are measured in a font that is larger than in the picture by this factor.
const SCALE: f64 = 2.0;

/// Smallest distance of text from the edge of the canvas \[px\].
const EDGE: f64 = 6.0;

/// Points of a curve that are closer than this \[px\] are drawn as one.
const RESOLUTION: f64 = 2.0;

/// Whether a text starts at its place, is centred on it, or ends at it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Anchor {
    /// The share of the text that is before its place.
    fn share(self) -> f64 {
        match self {
            Self::Start => 0.0,
            Self::Middle => 0.5,
            Self::End => 1.0,
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Line(Vec<Point>, Stroke),
    Polygon(Vec<Point>, RGBColor),
    Disc(Point, f64, RGBColor),
    Rectangle(Point, Point, RGBColor),
    Text(Text),
}

#[derive(Debug, Clone, PartialEq)]
struct Text {
    letters: String,
    /// Where the text begins: half of `size` above its base line. If the text reads upwards, half of `size` left of its
    /// base line.
    at: Point,
    /// Length of the text in the built-in font \[px\].
    length: f64,
    size: f64,
    color: RGBColor,
    anchor: Anchor,
    is_upward: bool,
}

/// A white canvas and the shapes on it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Canvas {
    shapes: Vec<Shape>,
}

impl Canvas {
    /// A line through points with the dashes of `stroke` and with round joints.
    pub(super) fn polyline(&mut self, points: &[Point], stroke: Stroke) {
        self.shapes.extend(dashes(&thinned(points), stroke.dash).into_iter().map(|piece| Shape::Line(piece, stroke)));
    }

    pub(super) fn polygon(&mut self, corners: &[Point], color: RGBColor) {
        self.shapes.push(Shape::Polygon(corners.to_vec(), color));
    }

    pub(super) fn disc(&mut self, centre: Point, radius: f64, color: RGBColor) {
        self.shapes.push(Shape::Disc(centre, radius, color));
    }

    /// A filled rectangle. Rectangles that share an edge have no gap between them.
    pub(super) fn rectangle(&mut self, from: Point, to: Point, color: RGBColor) {
        self.shapes.push(Shape::Rectangle(from, to, color));
    }

    /// Text whose capital letters are centred on the height of `at`. A text that would go beyond the canvas is moved
    /// inward, and a text that is longer than the canvas is made smaller.
    pub(super) fn text(
        &mut self,
        text: &str,
        at: Point,
        size: f64,
        color: RGBColor,
        anchor: Anchor,
    ) -> Result<(), PlotError> {
        let (width, height) = (f64::from(SIZE.0), f64::from(SIZE.1));
        let size = fitting(text, size, width - 2.0 * EDGE)?;
        let length = text_width(text, size)?;
        let left = within(at.0 - anchor.share() * length, length, width);
        let at = (left, within(at.1 - 0.5 * size, size, height) + 0.5 * size - centre(size));
        let letters = text.to_owned();
        self.shapes.push(Shape::Text(Text { letters, at, length, size, color, anchor, is_upward: false }));
        Ok(())
    }

    /// Text that reads upwards and is centred on `at`.
    pub(super) fn text_upward(&mut self, text: &str, at: Point, size: f64, color: RGBColor) -> Result<(), PlotError> {
        let (width, height) = (f64::from(SIZE.0), f64::from(SIZE.1));
        let size = fitting(text, size, height - 2.0 * EDGE)?;
        let length = text_width(text, size)?;
        let top = within(at.1 - 0.5 * length, length, height);
        let at = (within(at.0 - 0.5 * size, size, width) + 0.5 * size - centre(size), top + length);
        let (letters, anchor) = (text.to_owned(), Anchor::Middle);
        self.shapes.push(Shape::Text(Text { letters, at, length, size, color, anchor, is_upward: true }));
        Ok(())
    }
}

/// Text sizes per em of the font DejaVu.
const EM: f64 = 1.164;

/// Distance from the place of a text in plotters down to the middle of its capital letters. The base line is half a
/// size below that place, and capital letters of DejaVu are 0.729 em high.
fn centre(size: f64) -> f64 {
    (0.5 - 0.5 * 0.729 / EM) * size
}

/// The start of a text of this length, moved so that the text is within the canvas. `sheet` is the length of the
/// canvas.
fn within(start: f64, length: f64, sheet: f64) -> f64 {
    start.min(sheet - EDGE - length).max(EDGE)
}

/// The given size, or a smaller one at which the text is not longer than `room`.
pub(super) fn fitting(text: &str, size: f64, room: f64) -> Result<f64, PlotError> {
    let mut fitting = size;
    // widths are rounded to whole pixels, so the ratio alone may not be small enough
    while fitting > 1.0 && text_width(text, fitting)? > room {
        fitting *= (room / text_width(text, fitting)?).min(0.99);
    }
    Ok(fitting)
}

/// The text in lines that are not longer than `room`. A word that is too long for a line is divided.
pub(super) fn wrapped(text: &str, size: f64, room: f64) -> Result<Vec<String>, PlotError> {
    let mut lines = vec![String::new()];
    for piece in text.split_inclusive(' ') {
        let line = lines.last().map_or("", String::as_str);
        if !line.is_empty() && text_width(format!("{line}{piece}").trim_end(), size)? > room {
            lines.push(String::new());
        }
        for letter in piece.chars() {
            let line = lines.last().map_or("", String::as_str);
            if !line.is_empty() && letter != ' ' && text_width(&format!("{line}{letter}"), size)? > room {
                lines.push(String::new());
            }
            if let Some(line) = lines.last_mut() {
                line.push(letter);
            }
        }
    }
    Ok(lines.into_iter().map(|line| line.trim_end().to_owned()).collect())
}

/// Width of a text \[px\].
pub(super) fn text_width(text: &str, size: f64) -> Result<f64, PlotError> {
    static IS_REGISTERED: LazyLock<bool> =
        LazyLock::new(|| register_font("sans-serif", FontStyle::Normal, dejavu::sans::regular()).is_ok());
    if !*IS_REGISTERED {
        return Err(PlotError::Font);
    }
    let font = FontDesc::new(FontFamily::SansSerif, SCALE * size, FontStyle::Normal);
    let (width, _) = font.box_size(text).map_err(failed)?;
    Ok(f64::from(width) / SCALE)
}

/// A place in whole units of a back end that has `units` units per pixel.
#[allow(clippy::cast_possible_truncation)] // casts saturate, and places outside the canvas are not seen
fn whole((x, y): Point, units: f64) -> (i32, i32) {
    ((x * units).round() as i32, (y * units).round() as i32)
}

/// A length in whole units of a back end.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // lengths of a few pixels
fn whole_length(length: f64, units: f64) -> u32 {
    (length * units).round() as u32
}

fn failed(error: impl Display) -> PlotError {
    PlotError::Drawing(error.to_string())
}

/// The points without those that are not finite, and without steps that are too small to see. The last point stays.
fn thinned(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let mut skipped = None;
    for &point in points.iter().filter(|(x, y)| x.is_finite() && y.is_finite()) {
        if kept.last().is_none_or(|last| hypot(point.0 - last.0, point.1 - last.1) >= RESOLUTION) {
            kept.push(point);
            skipped = None;
        } else {
            skipped = Some(point);
        }
    }
    kept.extend(skipped);
    kept
}

/// The dashes of a line.
fn dashes(points: &[Point], pattern: &[f64]) -> Vec<Vec<Point>> {
    if pattern.is_empty() {
        return vec![points.to_vec()];
    }
    let mut pieces = Vec::new();
    let mut piece = points.first().copied().into_iter().collect::<Vec<_>>();
    let (mut phase, mut left) = (0, pattern[0]);
    for pair in points.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let length = hypot(to.0 - from.0, to.1 - from.1);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let share = done / length;
            let at = (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
            piece.push(at);
            if phase % 2 == 0 {
                pieces.push(std::mem::take(&mut piece));
            }
            phase = (phase + 1) % pattern.len();
            left = pattern[phase];
        }
        left -= length - done;
        if phase % 2 == 0 {
            piece.push(to);
        }
    }
    pieces.push(piece);
    pieces
}
