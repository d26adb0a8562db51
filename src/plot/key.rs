//! The key: a column right of the axes, so that it never covers data.

use plotters::style::RGBColor;

use super::canvas::{Anchor, Canvas, text_width};
use super::frame::{Bounds, Frame};
use super::style::{GREY, INK, LABEL_SIZE, Mark, Stroke};
use super::{PlotError, SIZE};

/// Width of the sample beside an entry, and the gap to its text \[px\].
const SAMPLE: f64 = 70.0;
const GAP: f64 = 16.0;
const LINE_HEIGHT: f64 = 38.0;
const ENTRY_GAP: f64 = 16.0;
/// Distance to the axes and to the edge of the picture \[px\].
const MARGIN: f64 = 28.0;
/// Margins of the box with axes \[px\]: labels and titles of the axes.
pub(super) const LEFT: f64 = 165.0;
pub(super) const TOP: f64 = 90.0;
pub(super) const BOTTOM: f64 = 125.0;

/// One entry: a sample of line or marker and its text, the first line in ink and the rest in grey.
pub(super) struct Entry {
    pub line: Option<Stroke>,
    pub mark: Option<(Mark, f64, RGBColor)>,
    pub text: Vec<String>,
}

impl Entry {
    pub(super) fn line(text: &str, stroke: Stroke) -> Self {
        Self { line: Some(stroke), mark: None, text: vec![text.into()] }
    }

    pub(super) fn mark(text: &str, mark: Mark, radius: f64, color: RGBColor) -> Self {
        Self { line: None, mark: Some((mark, radius, color)), text: vec![text.into()] }
    }

    pub(super) fn text(text: &str) -> Self {
        Self { line: None, mark: None, text: vec![text.into()] }
    }

    pub(super) fn and(mut self, text: String) -> Self {
        self.text.push(text);
        self
    }

    fn indent(&self) -> f64 {
        if self.line.is_some() || self.mark.is_some() { SAMPLE + GAP } else { 0.0 }
    }
}

/// Room for a box with axes beside the key.
pub(super) fn bounds(entries: &[Entry]) -> Result<Bounds, PlotError> {
    let mut widest: f64 = 0.0;
    for entry in entries {
        for text in &entry.text {
            widest = widest.max(entry.indent() + text_width(text, LABEL_SIZE)?);
        }
    }
    let room = if entries.is_empty() { MARGIN } else { widest + 2.0 * MARGIN };
    let (width, height) = (f64::from(SIZE.0), f64::from(SIZE.1));
    // however long the names are, half of the picture belongs to the data
    let right = (width - room).max(0.5 * width);
    Ok(Bounds { left: LEFT, top: TOP, right, bottom: height - BOTTOM })
}

/// Draws the key beside a box.
pub(super) fn draw(canvas: &mut Canvas, entries: &[Entry], frame: &Frame) -> Result<(), PlotError> {
    let left = frame.bounds.right + MARGIN;
    let mut y = frame.bounds.top + 0.5 * LINE_HEIGHT;
    for entry in entries {
        if let Some(stroke) = entry.line {
            canvas.polyline(&[(left, y), (left + SAMPLE, y)], stroke)?;
        }
        if let Some((mark, radius, color)) = entry.mark {
            mark.draw(canvas, (left + 0.5 * SAMPLE, y), radius, color)?;
        }
        for (i, text) in entry.text.iter().enumerate() {
            let color = if i == 0 { INK } else { GREY };
            canvas.text(text, (left + entry.indent(), y), LABEL_SIZE, color, Anchor::Start)?;
            y += LINE_HEIGHT;
        }
        y += ENTRY_GAP;
    }
    Ok(())
}
