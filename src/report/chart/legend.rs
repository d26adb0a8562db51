//! The key of a picture: inside the axes where it covers no data, else in a column to the right of them or below them.

use crate::error::Error;
use plotters::prelude::DrawingBackend;
use plotters::style::RGBColor;

use super::frame::{Bounds, PanelFrame};
use super::pen::{Anchor, Pen, Point};
use super::style::LABEL_SIZE;
use super::text::{text_width, with_minus, wrap};
use super::{BACKGROUND, FOREGROUND, GREY, GRID, Series, Style};

/// Width of the sample of a line or marker \[px\].
const SAMPLE_WIDTH: f64 = 56.0;
/// Distance from the sample to the text \[px\].
const GAP: f64 = 12.0;
const LINE_HEIGHT: f64 = 38.0;
const ENTRY_GAP: f64 = 12.0;
/// Distance of the frame of the key from its texts \[px\].
const PADDING: f64 = 8.0;
/// Distance of the key from the axes and from the edge of the picture \[px\].
pub const MARGIN: f64 = 24.0;
/// Smallest text size over the usual size: smaller text cannot be read.
const MIN_TEXT_SCALE: f64 = 0.4;
/// Text is drawn smaller, down to this size, before a word is divided.
const MIN_TEXT_SCALE_FOR_WORDS: f64 = 0.7;
/// Places that are tried along each side of the axes.
const POSITIONS_PER_SIDE: u32 = 12;

/// A sample of a line or marker, and lines of text with their colours.
struct LegendEntry {
    sample: [Option<Style>; 2],
    lines: Vec<(String, RGBColor)>,
}

impl LegendEntry {
    /// The entry of a series in this style. The first text is black and the others are grey. Texts that are longer than
    /// `room` are wrapped.
    fn new(series: &Series, style: Style, scale: f64, room: f64) -> Self {
        let mut entry = Self { sample: series.legend_sample(style), lines: Vec::new() };
        let room = room - entry.indent();
        for (i, text) in series.legend_texts.iter().enumerate() {
            let color = if i == 0 { FOREGROUND } else { GREY };
            entry
                .lines
                .extend(wrap(&non_breaking(text), scale * LABEL_SIZE, room).into_iter().map(|line| (line, color)));
        }
        entry
    }

    fn indent(&self) -> f64 {
        if self.sample == [None; 2] { 0.0 } else { SAMPLE_WIDTH + GAP }
    }

    fn height(&self) -> f64 {
        self.lines.len() as f64 * LINE_HEIGHT + ENTRY_GAP
    }
}

pub struct Legend {
    /// Text size over the usual size.
    scale: f64,
    entries: Vec<LegendEntry>,
    /// True if it lies inside the axes, where it has a frame.
    is_inside: bool,
}

impl Legend {
    /// The key of these series, at most so wide and so high \[px\]. It is drawn smaller where that is needed. If it is still
    /// too high, the last entries are replaced by their number.
    pub fn new(series: &[(&Series, Style)], (room, height): (f64, f64)) -> Self {
        let texts = series.iter().flat_map(|(one, _)| &one.legend_texts).map(|text| non_breaking(text));
        let longest = |text: String| text.split(' ').map(|word| text_width(word, LABEL_SIZE)).fold(0.0, f64::max);
        let longest = texts.map(longest).fold(0.0, f64::max);
        let mut scale = 1.0;
        loop {
            let mut key = Self::with_scale(series, scale, room);
            let is_whole = scale * longest <= room - SAMPLE_WIDTH - GAP || scale <= MIN_TEXT_SCALE_FOR_WORDS;
            if key.height() <= height && is_whole {
                return key;
            }
            if scale <= MIN_TEXT_SCALE {
                let mut more = LegendEntry { sample: [None; 2], lines: vec![(String::new(), GREY)] };
                while key.height() + scale * more.height() > height {
                    key.entries.pop();
                }
                more.lines[0].0 = format!("and {} more", series.len() - key.entries.len());
                key.entries.push(more);
                return key;
            }
            scale *= 0.95;
        }
    }

    fn with_scale(series: &[(&Series, Style)], scale: f64, room: f64) -> Self {
        let entries = series.iter().map(|(one, style)| LegendEntry::new(one, *style, scale, room)).collect();
        Self { scale, entries, is_inside: false }
    }

    /// The key and a position in the box at which it covers neither curves nor guides; `None` if it covers one everywhere.
    pub fn fit_inside(series: &[(&Series, Style)], frame: &PanelFrame, shown: &[&Series]) -> Option<(Self, Point)> {
        let lines: Vec<Vec<Point>> =
            shown.iter().map(|one| one.line_points(frame).iter().map(|at| frame.to_pixels(*at)).collect()).collect();
        let is_covered = |box_: &Bounds| {
            let areas = shown.iter().zip(&lines).filter(|(one, _)| one.is_area());
            lines.iter().any(|line| line.windows(2).any(|pair| box_.clip_segment(pair[0], pair[1]).is_some()))
                || lines.iter().flatten().any(|at| box_.clip_segment(*at, *at).is_some())
                || areas.into_iter().any(|(_, line)| is_inside_polygon((box_.left, box_.top), line))
        };
        let Bounds { left, top, right, bottom } = frame.bounds;
        for scale in [1.0, 0.9, 0.8] {
            let key = Self::with_scale(series, scale, 0.45 * (right - left));
            let room = (right - left - key.width() - 2.0 * MARGIN, bottom - top - key.height() - 2.0 * MARGIN);
            if room.0 < 0.0 || room.1 < 0.0 {
                continue;
            }
            // from the upper left corner, in rows
            for (row, column) in
                (0..=POSITIONS_PER_SIDE).flat_map(|row| (0..=POSITIONS_PER_SIDE).map(move |column| (row, column)))
            {
                let share = |i: u32| f64::from(i) / f64::from(POSITIONS_PER_SIDE);
                let at = (left + MARGIN + share(column) * room.0, top + MARGIN + share(row) * room.1);
                let (half, margin) = (0.5 * MARGIN, 1.5 * MARGIN);
                let area = Bounds {
                    left: at.0 - half,
                    top: at.1 - half,
                    right: at.0 - half + key.width() + margin,
                    bottom: at.1 - half + key.height() + margin,
                };
                if !is_covered(&area) {
                    return Some((Self { is_inside: true, ..key }, at));
                }
            }
        }
        None
    }

    /// The height that the key takes \[px\].
    pub fn height(&self) -> f64 {
        self.scale * self.entries.iter().map(LegendEntry::height).sum::<f64>()
    }

    /// The width that the key takes \[px\]; 0 if it is empty.
    pub fn width(&self) -> f64 {
        let lines = self.entries.iter().flat_map(|entry| entry.lines.iter().map(move |(line, _)| (entry, line)));
        lines.map(|(entry, line)| entry.indent() + text_width(line, self.scale * LABEL_SIZE)).fold(0.0, f64::max)
    }

    /// Draws the key with this upper left corner, on white.
    pub fn draw<B: DrawingBackend>(&self, pen: &mut Pen<B>, (left, top): Point) -> Result<(), Error> {
        if !self.entries.is_empty() {
            let (right, bottom) = (left + self.width() + PADDING, top + self.height());
            let (left, top) = (left - PADDING, top - PADDING);
            pen.draw_rectangle((left, top), (right, bottom), BACKGROUND)?;
            // without a frame a white rectangle would only look like a hole in the grid
            if self.is_inside {
                let corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
                pen.draw_polyline(&corners, Style::line(GRID, 1.5))?;
            }
        }
        let mut y = top + 0.5 * self.scale * LINE_HEIGHT;
        for entry in &self.entries {
            let [line, mark] = entry.sample;
            if let Some(style) = line {
                pen.draw_polyline(&[(left, y), (left + SAMPLE_WIDTH, y)], style)?;
            }
            if let Some(style) = mark {
                pen.draw_marker((left + 0.5 * SAMPLE_WIDTH, y), style)?;
            }
            for (text, color) in &entry.lines {
                pen.draw_text(text, (left + entry.indent(), y), self.scale * LABEL_SIZE, *color, Anchor::Start)?;
                y += self.scale * LINE_HEIGHT;
            }
            y += self.scale * ENTRY_GAP;
        }
        Ok(())
    }
}

/// The text with the minus sign of numbers, and with spaces that do not break a line between a number and its unit, and around
/// an equals sign.
fn non_breaking(text: &str) -> String {
    let letters: Vec<char> = with_minus(text).chars().collect();
    let is_tight = |at: usize| {
        let (before, after) = (at.checked_sub(1).and_then(|at| letters.get(at)), letters.get(at + 1));
        before.is_some_and(|c| c.is_ascii_digit() || *c == '=') || after == Some(&'=')
    };
    let joined = letters.iter().enumerate().map(|(at, c)| if *c == ' ' && is_tight(at) { '\u{a0}' } else { *c });
    joined.collect()
}

/// True if a place lies inside a closed line: a ray from it to the right crosses the line an odd number of times.
fn is_inside_polygon((x, y): Point, line: &[Point]) -> bool {
    let ends = line.iter().zip(line.iter().cycle().skip(1));
    let crosses = |(a, b): &(&Point, &Point)| (a.1 > y) != (b.1 > y) && x < a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0);
    ends.filter(crosses).count() % 2 == 1
}
