//! The picture as SVG: lines, areas and texts are kept as such. Texts are shown in a font of the viewer.

use plotters::prelude::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, FontTransform, ShapeStyle, TextStyle};

use super::{Anchor, Canvas, Point, Shape, Text, failed, whole, whole_length};
use crate::plot::PlotError;
use crate::plot::style::PAPER;

/// Units of the drawing per pixel. plotters takes whole numbers, and a tenth of a pixel is too small to see.
const UNITS: u32 = 10;

/// The font of the PNG, a font of similar width, or any font of the viewer.
const FONTS: FontFamily = FontFamily::Name("DejaVu Sans, Verdana, sans-serif");

/// plotters draws a text of size s in a font of size s/1.24, with the base line 0.76 of the font size lower; see
/// [`super::centre`].
const SIZE: f64 = 1.24 / super::EM;
const RISE: f64 = 0.76 / super::EM - 0.5;

/// Each rectangle is made larger by this on every side, so that no gap is seen between neighbours \[px\].
const OVERLAP: f64 = 0.5;

fn device(point: Point) -> (i32, i32) {
    whole(point, f64::from(UNITS))
}

impl Canvas {
    pub fn to_svg(&self) -> Result<Vec<u8>, PlotError> {
        let (width, height) = crate::plot::SIZE;
        let size = (width * UNITS, height * UNITS);
        let mut svg = String::new();
        let mut backend = SVGBackend::with_string(&mut svg, size);
        let paper = Shape::Rectangle((0.0, 0.0), (f64::from(width), f64::from(height)), PAPER);
        std::iter::once(&paper).chain(&self.shapes).try_for_each(|shape| draw(&mut backend, shape))?;
        backend.present().map_err(failed)?;
        drop(backend);
        let of_drawing = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
        let of_picture = format!("width=\"{width}\" height=\"{height}\" stroke-linejoin=\"round\"");
        // all shapes are opaque, so the attribute is not needed
        Ok(svg.replacen(&of_drawing, &of_picture, 1).replace(" opacity=\"1\"", "").into_bytes())
    }
}

fn draw(backend: &mut SVGBackend, shape: &Shape) -> Result<(), PlotError> {
    match shape {
        Shape::Line(points, _) if points.len() < 2 => Ok(()),
        Shape::Line(points, stroke) => {
            let style =
                ShapeStyle { stroke_width: whole_length(stroke.width, f64::from(UNITS)), ..stroke.color.into() };
            backend.draw_path(points.iter().map(|point| device(*point)), &style).map_err(failed)
        }
        Shape::Polygon(corners, color) => {
            backend.fill_polygon(corners.iter().map(|corner| device(*corner)), &color.filled()).map_err(failed)
        }
        Shape::Disc(centre, radius, color) => backend
            .draw_circle(device(*centre), whole_length(*radius, f64::from(UNITS)), &color.filled(), true)
            .map_err(failed),
        Shape::Rectangle(from, to, color) => {
            let low = (from.0.min(to.0) - OVERLAP, from.1.min(to.1) - OVERLAP);
            let high = (from.0.max(to.0) + OVERLAP, from.1.max(to.1) + OVERLAP);
            backend.draw_rect(device(low), device(high), &color.filled(), true).map_err(failed)
        }
        Shape::Text(text) => draw_text(backend, text),
    }
}

/// Draws a text with its own anchor: in a font of another width its start, middle or end stays at the same place.
fn draw_text(backend: &mut SVGBackend, shown: &Text) -> Result<(), PlotError> {
    let pos = match shown.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    let (along, rise) = (shown.anchor.share() * shown.length, RISE * shown.size);
    let (at, turned) = if shown.is_upward {
        ((shown.at.0 - rise, shown.at.1 - along), FontTransform::Rotate270)
    } else {
        ((shown.at.0 + along, shown.at.1 - rise), FontTransform::None)
    };
    let font = FontDesc::new(FONTS, f64::from(UNITS) * SIZE * shown.size, FontStyle::Normal).transform(turned);
    let style = TextStyle { font, color: shown.color.to_backend_color(), pos: Pos::new(pos, VPos::Top) };
    // control characters are not allowed in XML
    let text: String = shown.letters.chars().filter(|c| !c.is_control()).collect();
    backend.draw_text(&text, &style, device(at)).map_err(failed)
}
