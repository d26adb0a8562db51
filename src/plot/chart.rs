//! The one form of every picture: boxes one above the other with a common horizontal axis, series and guides in them, a
//! title, and a key or a colour bar beside them.

use plotters::prelude::DrawingBackend;
use plotters::style::RGBColor;

use super::axis::Axis;
use super::frame::{BOTTOM, Bounds, Frame, LEFT, TOP};
use super::key::{Key, MARGIN};
use super::pen::{self, Pen, Point};
use super::series::{Look, Series};
use super::style::{GREY, Style};
use super::{PlotError, SIZE};

/// Distance between the boxes \[px\].
const GAP: f64 = 28.0;
/// Width of the colour bar, its distance from the edge, and the width kept free for it and its labels \[px\].
const BAR: f64 = 44.0;
const BAR_MARGIN: f64 = 30.0;
const BAR_ROOM: f64 = 250.0;
/// Width of a narrow picture, its height without the key, and the room at the right of its axes \[px\].
const NARROW: (f64, f64) = (800.0, 830.0);
const NARROW_MARGIN: f64 = 40.0;
/// Number of steps of the colour bar.
const STEPS: u32 = 256;

/// A picture as data. [`Self::to_png`] and [`Self::to_svg`] draw it.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    pub title: String,
    /// Common horizontal axis.
    pub x: Axis,
    /// The boxes, from the top down.
    pub panels: Vec<Panel>,
    /// Entries at the end of the key.
    pub(super) entries: Vec<Series>,
    /// The axis of the colours of a map, with their scale.
    pub(super) colors: Option<(Axis, Shade)>,
}

/// The colour at a share of the axis of colours.
pub type Shade = fn(f64) -> RGBColor;

/// Where everything of a picture lies.
struct Layout {
    /// Width and height of the picture \[px\].
    sheet: (u32, u32),
    /// The room of all boxes, with that at their right.
    all: Bounds,
    frames: Vec<Frame>,
    key: Key,
    /// Its upper left corner.
    key_at: Point,
}

/// One box.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    pub y: Axis,
    /// Share of the height, relative to the other boxes.
    pub share: f64,
    /// If a series has no style, its style is that of its place among all series of the picture.
    pub series: Vec<Series>,
    pub guides: Vec<Series>,
    /// Coloured rectangles below all else.
    pub(super) cells: Vec<Cell>,
}

/// A coloured rectangle between two corners.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    pub from: (f64, f64),
    pub to: (f64, f64),
    pub color: RGBColor,
}

impl Panel {
    pub fn new(y: Axis, series: Vec<Series>) -> Self {
        Self { y, share: 1.0, series, guides: Vec::new(), cells: Vec::new() }
    }

    fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.series.iter().flat_map(|one| one.points.iter().copied())
    }
}

impl Chart {
    /// A picture of one box.
    pub fn new(title: impl Into<String>, [x, y]: [Axis; 2], series: Vec<Series>) -> Self {
        Self::stacked(title, x, vec![Panel::new(y, series)])
    }

    /// A picture of several boxes one above the other.
    pub fn stacked(title: impl Into<String>, x: Axis, panels: Vec<Panel>) -> Self {
        Self { title: title.into(), x, panels, entries: Vec::new(), colors: None }
    }

    /// The same picture with these guides in every box.
    #[must_use]
    pub fn with_guides(mut self, guides: impl Into<Vec<Series>>) -> Self {
        let guides = guides.into();
        for panel in &mut self.panels {
            panel.guides.extend_from_slice(&guides);
        }
        self
    }

    /// The same picture with these texts at the end of the key.
    #[must_use]
    pub fn with_notes<T: Into<String>>(self, notes: impl IntoIterator<Item = T>) -> Self {
        self.with_entries(notes.into_iter().map(Series::text))
    }

    pub(super) fn with_entries(mut self, entries: impl IntoIterator<Item = Series>) -> Self {
        self.entries.extend(entries);
        self
    }

    /// The same picture with entries of the key, in grey, for what the dashes of all colours mean: the first name is that
    /// of solid lines, the second of dashed ones ([`Style::branch`]).
    #[must_use]
    pub fn with_branches(self, names: &[&str]) -> Self {
        let entry = |(which, name): (usize, &&str)| {
            Series::bare(*name, Vec::new()).styled(Style::line(GREY, 3.0).branch(which))
        };
        self.with_entries(names.iter().enumerate().map(entry))
    }

    /// The picture as PNG: pixels, with the same bytes on every machine.
    ///
    /// # Errors
    /// [`PlotError::Font`] in a browser, where plotters draws no letters into pixels.
    pub fn to_png(&self) -> Result<Vec<u8>, PlotError> {
        #[cfg(not(target_arch = "wasm32"))]
        return pen::png::png(|pen| self.paint(&self.layout(false), pen));
        #[cfg(target_arch = "wasm32")]
        Err(PlotError::Font)
    }

    /// The picture as SVG: shapes and text, which stay sharp at any size.
    pub fn to_svg(&self) -> Result<Vec<u8>, PlotError> {
        self.svg(&self.layout(false))
    }

    /// The picture as SVG for a column of a paper or a narrow window: the axes half as wide, with letters of the same size, and
    /// the key below them.
    pub fn to_narrow_svg(&self) -> Result<Vec<u8>, PlotError> {
        self.svg(&self.layout(true))
    }

    fn svg(&self, layout: &Layout) -> Result<Vec<u8>, PlotError> {
        pen::svg(layout.sheet, |pen| self.paint(layout, pen))
    }

    fn layout(&self, is_narrow: bool) -> Layout {
        let x = self.x.fitted(self.panels.iter().flat_map(Panel::points).map(|(x, _)| x));
        let width = if is_narrow { NARROW.0 } else { f64::from(SIZE.0) };
        let bottom = if is_narrow { NARROW.1 } else { f64::from(SIZE.1) } - BOTTOM;
        let all = Bounds { left: LEFT, top: TOP, right: width, bottom };
        #[allow(clippy::cast_precision_loss)] // a handful
        let room = all.bottom - all.top - GAP * (self.panels.len() - 1) as f64;
        let shares: f64 = self.panels.iter().map(|panel| panel.share).sum();
        let mut bottom = all.top - GAP;
        let mut frames: Vec<Frame> = Vec::new();
        for panel in &self.panels {
            let top = bottom + GAP;
            bottom = top + room * panel.share / shares;
            let y = panel.y.fitted(panel.points().map(|(_, y)| y));
            frames.push(Frame { bounds: Bounds { top, bottom, ..all }, x: x.clone(), y });
        }
        let key = Key::of(&self.key(&frames));
        let beside = match self.colors {
            Some(_) => BAR_ROOM,
            None if is_narrow => NARROW_MARGIN,
            None => key.width(),
        };
        let right = width - beside;
        for frame in &mut frames {
            frame.bounds.right = right;
        }
        if !is_narrow {
            return Layout { sheet: SIZE, all, frames, key, key_at: (right + MARGIN, TOP) };
        }
        let height = NARROW.1 + key.height();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // some thousand pixels
        let sheet = (NARROW.0 as u32, height.ceil() as u32);
        Layout { sheet, all, frames, key, key_at: (MARGIN, NARROW.1) }
    }

    fn paint<B: DrawingBackend>(&self, layout: &Layout, pen: &mut Pen<B>) -> Result<(), PlotError> {
        let mut number = 0;
        for (i, (panel, frame)) in self.panels.iter().zip(&layout.frames).enumerate() {
            frame.draw_x(pen, i + 1 == self.panels.len())?;
            frame.draw_y(pen)?;
            self.fill(panel, frame, number, pen)?;
            number += panel.series.len();
            if i == 0 {
                frame.draw_title(pen, &self.title)?;
                layout.key.draw(pen, layout.key_at)?;
            }
        }
        self.draw_colors(pen, layout.all)
    }

    /// Draws the content of a box, and its outline. `first` is the number of its first series.
    fn fill<B: DrawingBackend>(
        &self,
        panel: &Panel,
        frame: &Frame,
        first: usize,
        pen: &mut Pen<B>,
    ) -> Result<(), PlotError> {
        let Bounds { left, top, right, bottom } = frame.bounds;
        let inside = |value| {
            let (x, y) = frame.place(value);
            (x.clamp(left, right), y.clamp(top, bottom))
        };
        for cell in &panel.cells {
            pen.rectangle(inside(cell.from), inside(cell.to), cell.color)?;
        }
        let series = || panel.series.iter().enumerate().map(|(i, one)| (one, one.style(first + i), first + i));
        for (band, style, _) in series().filter(|(one, ..)| one.look == Look::Band) {
            let corners: Vec<_> = band.points.iter().map(|point| frame.place(*point)).collect();
            pen.polygon(&corners, style.pale())?;
        }
        for guide in &panel.guides {
            frame.curve(pen, &guide.drawn(frame), guide.style(0))?;
        }
        frame.draw_outline(pen)?;
        let count: usize = self.panels.iter().map(|panel| panel.series.len()).sum();
        for (one, style, number) in series().filter(|(one, ..)| one.look != Look::Band) {
            if one.look != Look::Points {
                frame.curve(pen, &one.points, style)?;
            }
            #[allow(clippy::cast_precision_loss)] // a handful of series
            let (marked, radius) = one.marks(frame, style, (number + 1) as f64 / (count + 1) as f64);
            for point in marked {
                frame.mark(pen, point, Style { radius, ..style })?;
            }
        }
        Ok(())
    }

    /// What the key shows. Guides with the same texts have one entry, in grey if their colours differ.
    fn key(&self, frames: &[Frame]) -> Vec<(&Series, Style)> {
        fn styled((number, one): (usize, &Series)) -> (&Series, Style) {
            (one, one.style(number))
        }
        let series = self.panels.iter().flat_map(|panel| &panel.series).enumerate();
        let mut named: Vec<(&Series, Style)> = series.map(styled).collect();
        let panels = self.panels.iter().zip(frames);
        let seen = panels.flat_map(|(panel, frame)| panel.guides.iter().filter(|guide| guide.is_visible(frame)));
        let first = named.len();
        for guide in seen {
            let style = guide.style(0);
            match named[first..].iter_mut().find(|(other, _)| other.texts == guide.texts) {
                Some((_, other)) if other.color != style.color => other.color = GREY,
                Some(_) => {}
                None => named.push((guide, style)),
            }
        }
        named.extend(self.entries.iter().enumerate().map(styled));
        named.retain(|(series, _)| !series.texts.is_empty());
        named
    }

    /// The colour bar of a map.
    fn draw_colors<B: DrawingBackend>(&self, pen: &mut Pen<B>, all: Bounds) -> Result<(), PlotError> {
        let Some((axis, shade)) = &self.colors else { return Ok(()) };
        let right = all.right - BAR_MARGIN;
        let bounds = Bounds { left: right - BAR, right, ..all };
        let bar = Frame { bounds, x: Axis::linear("", "").fitted([]), y: axis.fitted([]) };
        bar.draw_y(pen)?;
        let height = (bounds.bottom - bounds.top) / f64::from(STEPS);
        for step in 0..STEPS {
            let below = bounds.bottom - f64::from(step) * height;
            let color = shade((f64::from(step) + 0.5) / f64::from(STEPS));
            pen.rectangle((bounds.left, below - height), (bounds.right, below), color)?;
        }
        bar.draw_outline(pen)
    }
}
