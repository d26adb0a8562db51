//! The sheet: plotters' primitives on a buffer of twice the size, halved at the end for smooth edges.

use std::sync::LazyLock;

use plotters::prelude::{BitMapBackend, DrawingBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, TextStyle, register_font};

use super::PlotError;
use super::style::{PAPER, Stroke};

use crate::math::functions::hypot;

/// A place on the picture \[px\], from its upper left corner.
pub(super) type Point = (f64, f64);

/// Drawn pixels per pixel of the picture, in each direction.
const OVERSAMPLING: u32 = 2;
const SCALE: f64 = OVERSAMPLING as f64;

/// Paper that stays free around all text \[px\].
const EDGE: f64 = 6.0;

/// Points of a curve closer than this \[px\] are one.
const RESOLUTION: f64 = 2.0;

/// Text starts, is centred, or ends at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

pub(super) struct Canvas {
    size: (u32, u32),
    buffer: Vec<u8>,
}

#[allow(clippy::cast_possible_truncation)] // casts saturate, and what is outside the sheet is not drawn
fn device((x, y): Point) -> (i32, i32) {
    ((x * SCALE).round() as i32, (y * SCALE).round() as i32)
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // lengths of a few pixels
fn device_length(length: f64) -> u32 {
    (length * SCALE).round() as u32
}

impl Canvas {
    /// A white sheet.
    pub(super) fn try_new(size: (u32, u32)) -> Result<Self, PlotError> {
        static IS_REGISTERED: LazyLock<bool> =
            LazyLock::new(|| register_font("sans-serif", FontStyle::Normal, dejavu::sans::regular()).is_ok());
        if !*IS_REGISTERED {
            return Err(PlotError::Font);
        }
        let bytes = 3 * (size.0 * OVERSAMPLING) as usize * (size.1 * OVERSAMPLING) as usize;
        Ok(Self { size, buffer: vec![PAPER.0; bytes] })
    }

    fn draw<E: std::fmt::Display>(
        &mut self,
        what: impl FnOnce(&mut BitMapBackend) -> Result<(), E>,
    ) -> Result<(), PlotError> {
        let size = (self.size.0 * OVERSAMPLING, self.size.1 * OVERSAMPLING);
        what(&mut BitMapBackend::with_buffer(&mut self.buffer, size))
            .map_err(|error| PlotError::Drawing(error.to_string()))
    }

    /// A line through points, dashed along its length, with round joints.
    pub(super) fn polyline(&mut self, points: &[Point], stroke: Stroke) -> Result<(), PlotError> {
        for piece in dashes(&thinned(points), stroke.dash) {
            for pair in piece.windows(2) {
                self.segment(pair[0], pair[1], stroke)?;
            }
            // a line of one width bends without notches if a disc fills each joint
            for joint in piece.get(1..piece.len().saturating_sub(1)).unwrap_or_default() {
                self.disc(*joint, 0.5 * stroke.width - 0.25, stroke.color)?;
            }
        }
        Ok(())
    }

    fn segment(&mut self, from: Point, to: Point, stroke: Stroke) -> Result<(), PlotError> {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = hypot(dx, dy);
        if length == 0.0 {
            return Ok(());
        }
        let half = 0.5 * stroke.width / length;
        let (nx, ny) = (-dy * half, dx * half);
        let corners =
            [(from.0 + nx, from.1 + ny), (to.0 + nx, to.1 + ny), (to.0 - nx, to.1 - ny), (from.0 - nx, from.1 - ny)];
        self.polygon(&corners, stroke.color)
    }

    pub(super) fn polygon(&mut self, corners: &[Point], color: RGBColor) -> Result<(), PlotError> {
        self.draw(|backend| backend.fill_polygon(corners.iter().map(|corner| device(*corner)), &color.filled()))
    }

    pub(super) fn disc(&mut self, centre: Point, radius: f64, color: RGBColor) -> Result<(), PlotError> {
        self.draw(|backend| backend.draw_circle(device(centre), device_length(radius), &color.filled(), true))
    }

    /// A filled rectangle; neighbours that share an edge leave no gap.
    pub(super) fn rectangle(&mut self, from: Point, to: Point, color: RGBColor) -> Result<(), PlotError> {
        self.draw(|backend| backend.draw_rect(device(from), device(to), &color.filled(), true))
    }

    /// Text whose capitals are centred on the height of `at`. No text leaves the sheet: one that would is moved inward, and
    /// one that is longer than the sheet is set smaller.
    pub(super) fn text(
        &mut self,
        text: &str,
        at: Point,
        size: f64,
        color: RGBColor,
        anchor: Anchor,
    ) -> Result<(), PlotError> {
        let (width, height) = (f64::from(self.size.0), f64::from(self.size.1));
        let size = fitting(text, size, width - 2.0 * EDGE)?;
        let left = within(at.0 - start(text, size, anchor)?, text_width(text, size)?, width);
        let at = (left, within(at.1 - 0.5 * size, size, height) + 0.5 * size - centre(size));
        let style = text_style(size, color, FontTransform::None);
        self.draw(|backend| backend.draw_text(text, &style, device(at)))
    }

    /// The same, turned to read upwards and centred on `at`.
    pub(super) fn text_upward(&mut self, text: &str, at: Point, size: f64, color: RGBColor) -> Result<(), PlotError> {
        let (width, height) = (f64::from(self.size.0), f64::from(self.size.1));
        let size = fitting(text, size, height - 2.0 * EDGE)?;
        let length = text_width(text, size)?;
        let top = within(at.1 - 0.5 * length, length, height);
        let at = (within(at.0 - 0.5 * size, size, width) + 0.5 * size - centre(size), top + length);
        let style = text_style(size, color, FontTransform::Rotate270);
        self.draw(|backend| backend.draw_text(text, &style, device(at)))
    }

    /// The picture as PNG.
    pub(super) fn to_png(&self) -> Result<Vec<u8>, PlotError> {
        let (width, height) = (self.size.0 as usize, self.size.1 as usize);
        let n = OVERSAMPLING as usize;
        let mut pixels = Vec::with_capacity(3 * width * height);
        for y in 0..height {
            for x in 0..width {
                for channel in 0..3 {
                    let mut sum = 0;
                    for row in 0..n {
                        for column in 0..n {
                            sum += usize::from(self.buffer[3 * ((n * y + row) * n * width + n * x + column) + channel]);
                        }
                    }
                    pixels.push(u8::try_from((sum + n * n / 2) / (n * n)).unwrap_or(u8::MAX));
                }
            }
        }
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.size.0, self.size.1);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&pixels)?;
        writer.finish()?;
        Ok(file)
    }
}

fn text_style(size: f64, color: RGBColor, transform: FontTransform) -> TextStyle<'static> {
    let font = FontDesc::new(FontFamily::SansSerif, SCALE * size, FontStyle::Normal).transform(transform);
    TextStyle { font, color: color.to_backend_color(), pos: Pos::new(HPos::Left, VPos::Top) }
}

/// From plotters' place of a text to the middle of its capitals: it sets the base line half a size lower, and DejaVu's
/// capitals are 0.729 em high with 1.164 em to a size.
fn centre(size: f64) -> f64 {
    (0.5 - 0.5 * 0.729 / 1.164) * size
}

/// The beginning of something so long, moved to be within a sheet of this length.
fn within(start: f64, length: f64, sheet: f64) -> f64 {
    start.min(sheet - EDGE - length).max(EDGE)
}

/// The size, or the smaller one at which a text is no longer than `room`.
pub(super) fn fitting(text: &str, size: f64, room: f64) -> Result<f64, PlotError> {
    let mut fitting = size;
    // widths are whole pixels, so that the ratio alone may miss
    while fitting > 1.0 && text_width(text, fitting)? > room {
        fitting *= (room / text_width(text, fitting)?).min(0.99);
    }
    Ok(fitting)
}

/// The words of a text in lines no longer than `room`; a word that is longer is divided.
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

fn start(text: &str, size: f64, anchor: Anchor) -> Result<f64, PlotError> {
    Ok(match anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5 * text_width(text, size)?,
        Anchor::End => text_width(text, size)?,
    })
}

/// Width of a text \[px\].
pub(super) fn text_width(text: &str, size: f64) -> Result<f64, PlotError> {
    let font = FontDesc::new(FontFamily::SansSerif, SCALE * size, FontStyle::Normal);
    let (width, _) = font.box_size(text).map_err(|error| PlotError::Drawing(error.to_string()))?;
    Ok(f64::from(width) / SCALE)
}

/// Without points that are not a number, and without steps too small to see (the last point stays).
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

/// The parts of a line that have ink.
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
            if phase % 2 == 0 {
                piece.push(at);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece.push(at);
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
