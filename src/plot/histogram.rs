//! A histogram: bars for counts, with lines for mean and quantiles.

use super::PlotError;
use super::axis::Axis;
use super::canvas::Canvas;
use super::key::Entry;
use super::sheet::single;
use super::style::{PALETTE, PAPER, Stroke, series};

/// Bars over adjoining bins.
#[derive(Debug, Clone, PartialEq)]
pub struct Histogram {
    pub title: String,
    pub x: Axis,
    /// Borders of the bins, rising: one more than there are counts.
    pub edges: Vec<f64>,
    pub counts: Vec<u64>,
    /// Vertical lines (mean, quantiles) with their labels in the key.
    pub lines: Vec<(f64, String)>,
    pub notes: Vec<String>,
}

impl Histogram {
    /// The picture.
    ///
    /// # Errors
    /// [`PlotError::Data`] if the numbers of edges and counts do not fit; other [`PlotError`]s from drawing.
    pub fn draw(&self) -> Result<Canvas, PlotError> {
        if self.counts.is_empty() || self.edges.len() != self.counts.len() + 1 {
            return Err(PlotError::Data(format!(
                "a histogram of {} bins needs one edge more, not {}",
                self.counts.len(),
                self.edges.len()
            )));
        }
        let entries: Vec<Entry> = (self.lines.iter().zip((0..).map(stroke)))
            .map(|((_, label), stroke)| Entry::line(label, stroke))
            .chain(self.notes.iter().map(|note| Entry::text(note)))
            .collect();
        #[allow(clippy::cast_precision_loss)] // heights of bars
        let heights: Vec<f64> = self.counts.iter().map(|count| *count as f64).collect();
        let highest = heights.iter().fold(1.0_f64, |highest, height| highest.max(*height));
        let x = match self.x.range {
            Some(_) => self.x.clone(),
            None => self.x.clone().between(self.edges[0], self.edges[self.counts.len()]),
        };
        let x = x.fitted(self.edges.iter().copied());
        let y = Axis::linear("Count", "").between(0.0, 1.06 * highest).fitted([]);
        single(&self.title, [x, y], &entries, |frame, canvas| {
            for (edges, height) in self.edges.windows(2).zip(&heights) {
                let (low, high) = (frame.place(edges[0], 0.0), frame.place(edges[1], *height));
                if high.1 < low.1 {
                    canvas.rectangle((low.0, high.1), (high.0, low.1), PALETTE[5]);
                    // a thin gap between bars, if they are wide enough
                    if high.0 - low.0 > 6.0 {
                        canvas.polyline(&[(high.0, high.1), (high.0, low.1)], Stroke::solid(PAPER, 1.0));
                    }
                }
            }
            for (i, (at, _)) in self.lines.iter().enumerate() {
                frame.curve(canvas, [(*at, 0.0), (*at, frame.y.value_at(1.0))], stroke(i));
            }
            frame.draw_outline(canvas);
        })
    }
}

/// Strokes of the lines over the sky-blue bars: black, vermillion, reddish purple and green, each with its own dash.
fn stroke(index: usize) -> Stroke {
    let color = [PALETTE[6], PALETTE[1], PALETTE[3], PALETTE[2]][index % 4];
    Stroke { color, width: 3.5, ..series(index).0 }
}
