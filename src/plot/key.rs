//! The key of a picture: a column to the right of the axes, so that it never covers data.

use plotters::prelude::DrawingBackend;

use super::frame::{Frame, TOP};
use super::pen::{Anchor, Pen};
use super::style::{GREY, INK, LABEL_SIZE, Style};
use super::text::{text_width, wrapped};
use super::{PlotError, SIZE};

/// Width of the sample of a line or marker \[px\].
const SAMPLE: f64 = 70.0;
/// Distance from the sample to the text \[px\].
const GAP: f64 = 16.0;
const LINE_HEIGHT: f64 = 38.0;
const ENTRY_GAP: f64 = 16.0;
/// Distance of the key from the axes and from the edge of the picture \[px\].
const MARGIN: f64 = 28.0;

/// One entry: a sample of a line or marker, and texts. The first text is black and the others are grey.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    pub line: Option<Style>,
    pub mark: Option<Style>,
    pub texts: Vec<String>,
}

impl Entry {
    pub fn line(text: &str, style: Style) -> Self {
        Self { line: Some(style), ..Self::text(text) }
    }

    pub fn text(text: &str) -> Self {
        Self { line: None, mark: None, texts: vec![text.into()] }
    }

    pub fn and(mut self, text: impl Into<String>) -> Self {
        self.texts.push(text.into());
        self
    }

    fn indent(&self) -> f64 {
        if self.line.is_some() || self.mark.is_some() { SAMPLE + GAP } else { 0.0 }
    }
}

/// The lines and the text size of all entries.
struct Layout {
    /// Text size over the usual size.
    scale: f64,
    /// For every entry that is drawn, its lines and whether each is black.
    entries: Vec<Vec<(String, bool)>>,
}

/// Smallest scale: smaller text cannot be read.
const SMALLEST: f64 = 0.4;

impl Layout {
    /// Lays out the entries. Long texts are wrapped, so that the key takes at most half of the picture. A key that is
    /// too high is drawn smaller. If it is still too high, the last entries are replaced by their number.
    fn of(entries: &[Entry]) -> Result<Self, PlotError> {
        let mut scale = 1.0;
        loop {
            let mut laid = Vec::new();
            for entry in entries {
                let room = 0.5 * f64::from(SIZE.0) - 2.0 * MARGIN - entry.indent();
                let mut lines = Vec::new();
                for (i, text) in entry.texts.iter().enumerate() {
                    let wrapped = wrapped(text, scale * LABEL_SIZE, room)?;
                    lines.extend(wrapped.into_iter().map(|line| (line, i == 0)));
                }
                laid.push(lines);
            }
            let layout = Self { scale, entries: laid };
            if layout.height() <= ROOM {
                return Ok(layout);
            }
            if scale <= SMALLEST {
                return Ok(layout.cut());
            }
            scale *= 0.95;
        }
    }

    #[allow(clippy::cast_precision_loss)] // a picture has no more
    fn height(&self) -> f64 {
        let lines: usize = self.entries.iter().map(Vec::len).sum();
        self.scale * (lines as f64 * LINE_HEIGHT + self.entries.len() as f64 * ENTRY_GAP)
    }

    /// As many entries as there is room for, and a line with the number of the others.
    fn cut(mut self) -> Self {
        let all = self.entries.len();
        loop {
            self.entries.pop();
            let more = vec![(format!("and {} more", all - self.entries.len()), false)];
            self.entries.push(more);
            if self.height() <= ROOM || self.entries.len() == 1 {
                return self;
            }
            self.entries.pop();
        }
    }
}

/// Largest height of the key \[px\].
const ROOM: f64 = SIZE.1 as f64 - TOP - MARGIN;

/// The width that the key takes \[px\].
pub fn width(entries: &[Entry]) -> Result<f64, PlotError> {
    if entries.is_empty() {
        return Ok(MARGIN);
    }
    let layout = Layout::of(entries)?;
    let mut widest: f64 = 0.0;
    for (entry, lines) in entries.iter().zip(&layout.entries) {
        for (line, _) in lines {
            widest = widest.max(entry.indent() + text_width(line, layout.scale * LABEL_SIZE)?);
        }
    }
    Ok(widest + 2.0 * MARGIN)
}

/// Draws the key beside a box.
pub fn draw<B: DrawingBackend>(pen: &mut Pen<B>, entries: &[Entry], frame: &Frame) -> Result<(), PlotError> {
    let left = frame.bounds.right + MARGIN;
    let layout = Layout::of(entries)?;
    let mut y = frame.bounds.top + 0.5 * layout.scale * LINE_HEIGHT;
    for (i, lines) in layout.entries.iter().enumerate() {
        // the last line may be the number of the entries that are left out
        let entry = entries.get(i).filter(|_| layout.entries.len() == entries.len() || i + 1 < layout.entries.len());
        if let Some(style) = entry.and_then(|entry| entry.line) {
            pen.polyline(&[(left, y), (left + SAMPLE, y)], style)?;
        }
        if let Some(style) = entry.and_then(|entry| entry.mark) {
            pen.mark((left + 0.5 * SAMPLE, y), style)?;
        }
        for (line, is_ink) in lines {
            let color = if *is_ink { INK } else { GREY };
            let at = (left + entry.map_or(0.0, Entry::indent), y);
            pen.text(line, at, layout.scale * LABEL_SIZE, color, Anchor::Start)?;
            y += layout.scale * LINE_HEIGHT;
        }
        y += layout.scale * ENTRY_GAP;
    }
    Ok(())
}
