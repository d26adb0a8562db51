//! Draws markers.

use plotters::style::RGBColor;

use super::canvas::{Canvas, Point};
use super::style::{Mark, Stroke};

impl Mark {
    pub(super) fn draw(self, canvas: &mut Canvas, at: Point, radius: f64, color: RGBColor) {
        let (x, y) = at;
        let r = radius;
        let stroke = Stroke::solid(color, 4.0);
        match self {
            Self::Circle => canvas.disc(at, r, color),
            Self::Square => {
                let r = 0.9 * r;
                canvas.rectangle((x - r, y - r), (x + r, y + r), color);
            }
            Self::Triangle => {
                canvas.polygon(&[(x, y - 1.2 * r), (x + 1.1 * r, y + 0.8 * r), (x - 1.1 * r, y + 0.8 * r)], color);
            }
            Self::Inverted => {
                canvas.polygon(&[(x, y + 1.2 * r), (x + 1.1 * r, y - 0.8 * r), (x - 1.1 * r, y - 0.8 * r)], color);
            }
            Self::Diamond => {
                let r = 1.25 * r;
                canvas.polygon(&[(x, y - r), (x + r, y), (x, y + r), (x - r, y)], color);
            }
            Self::Cross => {
                canvas.polyline(&[(x - r, y - r), (x + r, y + r)], stroke);
                canvas.polyline(&[(x - r, y + r), (x + r, y - r)], stroke);
            }
            Self::Plus => {
                let r = 1.2 * r;
                canvas.polyline(&[(x - r, y), (x + r, y)], stroke);
                canvas.polyline(&[(x, y - r), (x, y + r)], stroke);
            }
        }
    }
}
