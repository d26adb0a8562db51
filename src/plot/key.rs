//! The key of a picture: a column to the right of the axes or below them, so that it never covers data.

use plotters::prelude::DrawingBackend;
use plotters::style::RGBColor;

use super::frame::TOP;
use super::pen::{Anchor, Pen, Point};
use super::series::Series;
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
pub const MARGIN: f64 = 28.0;
/// Largest height of the key \[px\].
const ROOM: f64 = SIZE.1 as f64 - TOP - MARGIN;
/// Smallest text size over the usual size: smaller text cannot be read.
const SMALLEST: f64 = 0.4;

/// A sample of a line or marker, and lines of text with their colours.
struct Entry {
    sample: [Option<Style>; 2],
    lines: Vec<(String, RGBColor)>,
}

impl Entry {
    /// The entry of a series in this style. The first text is black and the others are grey. Long texts are wrapped, so
    /// that the key takes at most half of the picture.
    fn of(series: &Series, style: Style, scale: f64) -> Self {
        let mut entry = Self { sample: series.sample(style), lines: Vec::new() };
        let room = 0.5 * f64::from(SIZE.0) - 2.0 * MARGIN - entry.indent();
        for (i, text) in series.texts.iter().enumerate() {
            let color = if i == 0 { INK } else { GREY };
            entry.lines.extend(wrapped(text, scale * LABEL_SIZE, room).into_iter().map(|line| (line, color)));
        }
        entry
    }

    fn indent(&self) -> f64 {
        if self.sample == [None; 2] { 0.0 } else { SAMPLE + GAP }
    }

    #[allow(clippy::cast_precision_loss)] // a picture has no more
    fn height(&self) -> f64 {
        self.lines.len() as f64 * LINE_HEIGHT + ENTRY_GAP
    }
}

pub struct Key {
    /// Text size over the usual size.
    scale: f64,
    entries: Vec<Entry>,
}

impl Key {
    /// The key of these series. A key that is too high is drawn smaller. If it is still too high, the last entries are
    /// replaced by their number.
    pub fn of(series: &[(&Series, Style)]) -> Self {
        let mut scale = 1.0;
        loop {
            let entries = series.iter().map(|(series, style)| Entry::of(series, *style, scale));
            let mut key = Self { scale, entries: entries.collect() };
            if key.height() <= ROOM {
                return key;
            }
            if scale <= SMALLEST {
                let mut more = Entry { sample: [None; 2], lines: vec![(String::new(), GREY)] };
                while key.height() + scale * more.height() > ROOM {
                    key.entries.pop();
                }
                more.lines[0].0 = format!("and {} more", series.len() - key.entries.len());
                key.entries.push(more);
                return key;
            }
            scale *= 0.95;
        }
    }

    /// The height that the key takes \[px\].
    pub fn height(&self) -> f64 {
        self.scale * self.entries.iter().map(Entry::height).sum::<f64>()
    }

    /// The width that the key takes \[px\].
    pub fn width(&self) -> f64 {
        let mut widest = -MARGIN;
        for entry in &self.entries {
            for (line, _) in &entry.lines {
                widest = f64::max(widest, entry.indent() + text_width(line, self.scale * LABEL_SIZE));
            }
        }
        widest + 2.0 * MARGIN
    }

    /// Draws the key with this upper left corner.
    pub fn draw<B: DrawingBackend>(&self, pen: &mut Pen<B>, (left, top): Point) -> Result<(), PlotError> {
        let mut y = top + 0.5 * self.scale * LINE_HEIGHT;
        for entry in &self.entries {
            let [line, mark] = entry.sample;
            if let Some(style) = line {
                pen.polyline(&[(left, y), (left + SAMPLE, y)], style)?;
            }
            if let Some(style) = mark {
                pen.mark((left + 0.5 * SAMPLE, y), style)?;
            }
            for (text, color) in &entry.lines {
                pen.text(text, (left + entry.indent(), y), self.scale * LABEL_SIZE, *color, Anchor::Start)?;
                y += self.scale * LINE_HEIGHT;
            }
            y += self.scale * ENTRY_GAP;
        }
        Ok(())
    }
}
