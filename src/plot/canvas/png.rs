//! The picture as PNG. It is drawn by plotters at twice the size, and reduced at the end for smooth edges.

use plotters::prelude::{BitMapBackend, DrawingBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, FontTransform, RGBColor, TextStyle};

use super::{Canvas, Point, SCALE, Shape, Text, failed, whole, whole_length};
use crate::math::functions::hypot;
use crate::plot::style::{PAPER, Stroke};
use crate::plot::{PlotError, SIZE};

/// Drawn pixels per pixel of the picture, in each direction.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
const OVERSAMPLING: u32 = SCALE as u32;

fn device(point: Point) -> (i32, i32) {
    whole(point, SCALE)
}

impl Canvas {
    pub fn to_png(&self) -> Result<Vec<u8>, PlotError> {
        let size = (SIZE.0 * OVERSAMPLING, SIZE.1 * OVERSAMPLING);
        let mut buffer = vec![PAPER.0; 3 * size.0 as usize * size.1 as usize];
        let mut backend = BitMapBackend::with_buffer(&mut buffer, size);
        self.shapes.iter().try_for_each(|shape| draw(&mut backend, shape))?;
        drop(backend);
        encoded(&buffer)
    }
}

/// The PNG of a buffer that has [`OVERSAMPLING`] times as many pixels in each direction.
fn encoded(buffer: &[u8]) -> Result<Vec<u8>, PlotError> {
    let (width, height) = (SIZE.0 as usize, SIZE.1 as usize);
    let n = OVERSAMPLING as usize;
    let mut pixels = Vec::with_capacity(3 * width * height);
    for y in 0..height {
        for x in 0..width {
            for channel in 0..3 {
                let mut sum = 0;
                for row in 0..n {
                    for column in 0..n {
                        sum += usize::from(buffer[3 * ((n * y + row) * n * width + n * x + column) + channel]);
                    }
                }
                pixels.push(u8::try_from((sum + n * n / 2) / (n * n)).unwrap_or(u8::MAX));
            }
        }
    }
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, SIZE.0, SIZE.1);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&pixels)?;
    writer.finish()?;
    Ok(file)
}

fn draw(backend: &mut BitMapBackend, shape: &Shape) -> Result<(), PlotError> {
    match shape {
        Shape::Line(points, stroke) => line(backend, points, *stroke),
        Shape::Polygon(corners, color) => polygon(backend, corners, *color),
        Shape::Disc(centre, radius, color) => disc(backend, *centre, *radius, *color),
        Shape::Rectangle(from, to, color) => {
            backend.draw_rect(device(*from), device(*to), &color.filled(), true).map_err(failed)
        }
        Shape::Text(Text { letters, at, size, color, is_upward, .. }) => {
            let turned = if *is_upward { FontTransform::Rotate270 } else { FontTransform::None };
            let font = FontDesc::new(FontFamily::SansSerif, SCALE * size, FontStyle::Normal).transform(turned);
            let pos = Pos::new(HPos::Left, VPos::Top);
            backend
                .draw_text(letters, &TextStyle { font, color: color.to_backend_color(), pos }, device(*at))
                .map_err(failed)
        }
    }
}

fn line(backend: &mut BitMapBackend, points: &[Point], stroke: Stroke) -> Result<(), PlotError> {
    for pair in points.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let length = hypot(dx, dy);
        if length == 0.0 {
            continue;
        }
        let half = 0.5 * stroke.width / length;
        let (nx, ny) = (-dy * half, dx * half);
        let corners =
            [(from.0 + nx, from.1 + ny), (to.0 + nx, to.1 + ny), (to.0 - nx, to.1 - ny), (from.0 - nx, from.1 - ny)];
        polygon(backend, &corners, stroke.color)?;
    }
    // a disc at each joint fills the notch between two pieces of the line
    for joint in points.get(1..points.len().saturating_sub(1)).unwrap_or_default() {
        disc(backend, *joint, 0.5 * stroke.width - 0.25, stroke.color)?;
    }
    Ok(())
}

fn polygon(backend: &mut BitMapBackend, corners: &[Point], color: RGBColor) -> Result<(), PlotError> {
    backend.fill_polygon(corners.iter().map(|corner| device(*corner)), &color.filled()).map_err(failed)
}

fn disc(backend: &mut BitMapBackend, centre: Point, radius: f64, color: RGBColor) -> Result<(), PlotError> {
    backend.draw_circle(device(centre), whole_length(radius, SCALE), &color.filled(), true).map_err(failed)
}
