//! Draws markers.

use super::canvas::{Canvas, Point};
use super::style::{Mark, Marker, Stroke};

impl Marker {
    pub(super) fn draw(self, canvas: &mut Canvas, at: Point) {
        let Self { shape, radius: r, color } = self;
        let (x, y) = at;
        let stroke = Stroke::solid(color, 4.0);
        match shape {
            Mark::Circle => canvas.disc(at, r, color),
            Mark::Square => {
                let r = 0.9 * r;
                canvas.rectangle((x - r, y - r), (x + r, y + r), color);
            }
            Mark::Triangle => {
                canvas.polygon(&[(x, y - 1.2 * r), (x + 1.1 * r, y + 0.8 * r), (x - 1.1 * r, y + 0.8 * r)], color);
            }
            Mark::Inverted => {
                canvas.polygon(&[(x, y + 1.2 * r), (x + 1.1 * r, y - 0.8 * r), (x - 1.1 * r, y - 0.8 * r)], color);
            }
            Mark::Diamond => {
                let r = 1.25 * r;
                canvas.polygon(&[(x, y - r), (x + r, y), (x, y + r), (x - r, y)], color);
            }
            Mark::Cross => {
                canvas.polyline(&[(x - r, y - r), (x + r, y + r)], stroke);
                canvas.polyline(&[(x - r, y + r), (x + r, y - r)], stroke);
            }
            Mark::Plus => {
                let r = 1.2 * r;
                canvas.polyline(&[(x - r, y), (x + r, y)], stroke);
                canvas.polyline(&[(x, y - r), (x, y + r)], stroke);
            }
        }
    }
}
