//! The pen: lines, areas and texts on a back end of plotters. The back end for SVG keeps lines and texts as such; [`png`] has
//! the one for PNG.

#[cfg(not(target_arch = "wasm32"))]
pub mod png;

use std::fmt::Display;

use plotters::prelude::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, ShapeStyle, TextStyle};

use super::text::{fitting_size, text_width};
use super::{BACKGROUND, Marker, Style};
use crate::error::Error;
use crate::numerics::functions::hypot;

/// A point on the picture \[px\], measured from its upper left corner.
pub type Point = (f64, f64);

/// Smallest distance of text from the edge of the picture \[px\].
const EDGE_MARGIN: f64 = 6.0;
/// Points of a curve that are closer than this \[px\] are drawn as one.
const MIN_POINT_DISTANCE: f64 = 2.0;

/// The differences between the two file formats.
#[derive(Clone, Copy)]
struct BackendFormat {
    /// Units of the back end per pixel of the picture: plotters takes whole numbers.
    units: f64,
    /// Size of the letters over the size of the letters in the PNG.
    letters: f64,
    /// How far plotters puts the middle of the capital letters above the place of a text, over the size of the text; read from
    /// a picture of capital letters.
    rise: f64,
    fonts: &'static str,
    /// Rectangles are larger by this on every side, so that a viewer shows no gap between neighbours \[px\].
    overlap: f64,
    /// True if lines are drawn piece by piece. The pixels of plotters have gaps where a wide line crosses itself.
    is_raster: bool,
}

/// The font of the PNG, a font of similar width, or any font of the viewer. In SVG plotters divides the size of letters by 1.24, in PNG
/// by the height of the font with its descent, 1.164 for DejaVu Sans.
const SVG_FORMAT: BackendFormat = BackendFormat {
    units: 10.0,
    letters: 1.24 / 1.164,
    rise: 0.073,
    fonts: "DejaVu Sans, Verdana, sans-serif",
    overlap: 0.5,
    is_raster: false,
};

/// The picture as SVG: shapes and text, which stay sharp at any size.
pub fn render_svg(
    sheet: (u32, u32),
    paint: impl FnOnce(&mut Pen<SVGBackend>) -> Result<(), Error>,
) -> Result<Vec<u8>, Error> {
    let [width, height] = [sheet.0, sheet.1].map(|side| side * whole_length(1.0, SVG_FORMAT.units));
    let mut svg = String::new();
    let mut backend = SVGBackend::with_string(&mut svg, (width, height));
    let mut pen = Pen { backend: &mut backend, format: SVG_FORMAT, sheet: (f64::from(sheet.0), f64::from(sheet.1)) };
    pen.draw_rectangle((0.0, 0.0), pen.sheet, BACKGROUND)?;
    paint(&mut pen)?;
    backend.present().map_err(drawing_error)?;
    drop(backend);
    let of_drawing = format!("width=\"{width}\" height=\"{height}\"");
    let of_picture = format!("width=\"{}\" height=\"{}\" stroke-linejoin=\"round\"", sheet.0, sheet.1);
    // all shapes are opaque, so the attribute is not needed
    Ok(svg.replacen(&of_drawing, &of_picture, 1).replace(" opacity=\"1\"", "").into_bytes())
}

/// The alignment of a text: it starts at its place, is centred on it, or ends at it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    Start,
    Middle,
    End,
    /// Centred, and reading upwards.
    Upward,
}

/// Draws on a back end of plotters, in pixels of the picture.
pub struct Pen<'a, B: DrawingBackend> {
    backend: &'a mut B,
    format: BackendFormat,
    /// Width and height of the picture \[px\].
    sheet: (f64, f64),
}

impl<B: DrawingBackend> Pen<'_, B> {
    /// A line through points with the dashes of its style and with round joints.
    pub fn draw_polyline(&mut self, points: &[Point], style: Style) -> Result<(), Error> {
        for piece in split_dashes(&without_short_steps(points), style.dash).into_iter().filter(|piece| piece.len() > 1)
        {
            if self.format.is_raster {
                self.draw_segments(&piece, style)?;
            } else {
                let width = whole_length(style.width, self.format.units);
                let stroke = ShapeStyle { stroke_width: width, ..style.color.into() };
                let points: Vec<_> = piece.into_iter().map(|point| self.to_device(point)).collect();
                self.backend.draw_path(points, &stroke).map_err(drawing_error)?;
            }
        }
        Ok(())
    }

    fn draw_segments(&mut self, points: &[Point], style: Style) -> Result<(), Error> {
        for pair in points.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let (dx, dy) = (to.0 - from.0, to.1 - from.1);
            let half = 0.5 * style.width / hypot(dx, dy);
            if half.is_finite() {
                let (nx, ny) = (-dy * half, dx * half);
                let [left, right] =
                    [1.0, -1.0].map(|side| [from, to].map(|end: Point| (end.0 + side * nx, end.1 + side * ny)));
                self.draw_polygon(&[left[0], left[1], right[1], right[0]], style.color)?;
            }
        }
        // a disc at each joint fills the notch between two pieces of the line
        for joint in points.get(1..points.len().saturating_sub(1)).unwrap_or_default() {
            self.draw_disc(*joint, 0.5 * style.width - 0.25, style.color)?;
        }
        Ok(())
    }

    pub fn draw_polygon(&mut self, corners: &[Point], color: RGBColor) -> Result<(), Error> {
        let corners: Vec<_> = corners.iter().map(|corner| self.to_device(*corner)).collect();
        self.backend.fill_polygon(corners, &color.filled()).map_err(drawing_error)
    }

    /// A filled rectangle between two corners. Rectangles that share an edge have no gap between them.
    pub fn draw_rectangle(&mut self, from: Point, to: Point, color: RGBColor) -> Result<(), Error> {
        let more = self.format.overlap;
        let low = self.to_device((from.0.min(to.0) - more, from.1.min(to.1) - more));
        let high = self.to_device((from.0.max(to.0) + more, from.1.max(to.1) + more));
        self.backend.draw_rect(low, high, &color.filled(), true).map_err(drawing_error)
    }

    fn draw_disc(&mut self, centre: Point, radius: f64, color: RGBColor) -> Result<(), Error> {
        let (centre, radius) = (self.to_device(centre), whole_length(radius, self.format.units));
        self.backend.draw_circle(centre, radius, &color.filled(), true).map_err(drawing_error)
    }

    pub fn draw_marker(&mut self, (x, y): Point, style: Style) -> Result<(), Error> {
        let Style { mark, radius: r, color, .. } = style;
        let stroke = Style::line(color, 4.0);
        match mark {
            Marker::Circle => self.draw_disc((x, y), r, color),
            Marker::Square => self.draw_rectangle((x - 0.9 * r, y - 0.9 * r), (x + 0.9 * r, y + 0.9 * r), color),
            Marker::Triangle | Marker::TriangleDown => {
                let up = if mark == Marker::Triangle { r } else { -r };
                self.draw_polygon(&[(x, y - 1.2 * up), (x + 1.1 * r, y + 0.8 * up), (x - 1.1 * r, y + 0.8 * up)], color)
            }
            Marker::Diamond => {
                let r = 1.25 * r;
                self.draw_polygon(&[(x, y - r), (x + r, y), (x, y + r), (x - r, y)], color)
            }
            Marker::Cross => {
                self.draw_polyline(&[(x - r, y - r), (x + r, y + r)], stroke)?;
                self.draw_polyline(&[(x - r, y + r), (x + r, y - r)], stroke)
            }
            Marker::Plus => {
                let r = 1.2 * r;
                self.draw_polyline(&[(x - r, y), (x + r, y)], stroke)?;
                self.draw_polyline(&[(x, y - r), (x, y + r)], stroke)
            }
        }
    }

    /// Text whose capital letters are centred on `at`, across its direction. A text that would go beyond the picture is
    /// moved inward, and a text that is longer than the picture is made smaller.
    pub fn draw_text(
        &mut self,
        text: &str,
        at: Point,
        size: f64,
        color: RGBColor,
        anchor: Anchor,
    ) -> Result<(), Error> {
        let turned = |(x, y)| if anchor == Anchor::Upward { (y, x) } else { (x, y) };
        let (length_of_sheet, height_of_sheet) = turned(self.sheet);
        let (before, horizontal) = match anchor {
            Anchor::Start => (0.0, HPos::Left),
            Anchor::Middle | Anchor::Upward => (0.5, HPos::Center),
            Anchor::End => (1.0, HPos::Right),
        };
        let BackendFormat { units, letters, rise, fonts, .. } = self.format;
        let size = fitting_size(text, size, length_of_sheet - 2.0 * EDGE_MARGIN);
        let (length, (along, across)) = (text_width(text, size), turned(at));
        let along = clamp_text(along, before * length, length, length_of_sheet);
        let at = turned((along, clamp_text(across, 0.5 * size, size, height_of_sheet) + rise * size));
        let font = FontDesc::new(FontFamily::Name(fonts), units * letters * size, FontStyle::Normal);
        let turn = if anchor == Anchor::Upward { FontTransform::Rotate270 } else { FontTransform::None };
        let pos = Pos::new(horizontal, VPos::Center);
        let style = TextStyle { font: font.transform(turn), color: color.to_backend_color(), pos };
        // control characters are not allowed in XML
        let text: String = text.chars().filter(|c| !c.is_control()).collect();
        let at = self.to_device(at);
        self.backend.draw_text(&text, &style, at).map_err(drawing_error)
    }

    #[allow(clippy::cast_possible_truncation)] // casts saturate, and places outside the picture are not seen
    fn to_device(&self, (x, y): Point) -> (i32, i32) {
        ((x * self.format.units).round() as i32, (y * self.format.units).round() as i32)
    }
}

/// A length in whole units of a back end.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // lengths of a few pixels
fn whole_length(length: f64, units: f64) -> u32 {
    (length * units).round() as u32
}

/// A place, moved so that a text of this length around it stays within a picture with sides of `sheet`.
fn clamp_text(at: f64, before: f64, length: f64, sheet: f64) -> f64 {
    at.min(sheet - EDGE_MARGIN - length + before).max(EDGE_MARGIN + before)
}

fn drawing_error(error: impl Display) -> Error {
    Error::failed(format!("drawing: {error}"))
}

/// The points without those that are not finite, and without steps that are too small to see. The last point stays.
fn without_short_steps(points: &[Point]) -> Vec<Point> {
    let mut finite: Vec<Point> = points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
    let last = finite.last().copied();
    let mut is_skipped = false;
    finite.dedup_by(|point, before| {
        is_skipped = hypot(point.0 - before.0, point.1 - before.1) < MIN_POINT_DISTANCE;
        is_skipped
    });
    finite.extend(last.filter(|_| is_skipped));
    finite
}

fn split_dashes(points: &[Point], pattern: &[f64]) -> Vec<Vec<Point>> {
    if pattern.is_empty() {
        return vec![points.to_vec()];
    }
    let mut pieces = Vec::new();
    let mut piece = points.first().copied().into_iter().collect::<Vec<_>>();
    let (mut phase, mut remaining) = (0, pattern[0]);
    for pair in points.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let length = hypot(to.0 - from.0, to.1 - from.1);
        let mut done = 0.0;
        while length - done > remaining {
            done += remaining;
            let share = done / length;
            let at = (from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1));
            piece.push(at);
            if phase % 2 == 0 {
                pieces.push(std::mem::take(&mut piece));
            }
            phase = (phase + 1) % pattern.len();
            remaining = pattern[phase];
        }
        remaining -= length - done;
        if phase % 2 == 0 {
            piece.push(to);
        }
    }
    pieces.push(piece);
    pieces
}
