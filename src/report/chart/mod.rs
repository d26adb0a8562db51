//! The one form of every picture: boxes one above the other with a common horizontal axis, series and guides in them, a
//! title, and a key or a colour bar beside them. Pictures are PNG or SVG, drawn in memory with a built-in font, with the same bytes on
//! every machine.
//!
//! The crate plotters draws lines, areas and texts. Axes, clipping and the key are laid out here, because the charts of plotters move
//! points outside the axes to the edge, which bends the lines (plotters issues 429 and 622). They also have no key outside the axes, and
//! no dash patterns of two lengths. Series differ by colour (the palette of Okabe and Ito, made for colour-blind readers), by dash
//! pattern and by marker.

pub mod axis;
pub(in crate::report) mod format;
pub(in crate::report) mod frame;
pub(in crate::report) mod heatmap;
pub(in crate::report) mod histogram;
pub(in crate::report) mod legend;
pub(in crate::report) mod pen;
pub(in crate::report) mod series;
pub(in crate::report) mod style;
pub(in crate::report) mod text;

pub use axis::{Axis, AxisScale, min_max};
pub use format::PictureFormat;
pub use heatmap::heatmap;
pub use histogram::histogram;
pub use series::{Series, SeriesKind};
pub(crate) use style::{BACKGROUND, DASHED, DOTTED, FOREGROUND, GREY, GRID, MARKER_RADIUS, PALETTE, SOLID};
pub use style::{Marker, SIZE, Style};

use crate::error::Error;
use plotters::prelude::DrawingBackend;
use plotters::style::RGBColor;

use frame::{BOTTOM, Bounds, LEFT, PanelFrame, TOP, draw_titles};
use legend::{Legend, MARGIN};
use pen::{Pen, Point};

/// Distance between the boxes \[px\].
const GAP: f64 = 28.0;
/// Width of the colour bar, its distance from the edge, and the width kept free for it and its labels \[px\].
const COLOR_BAR_WIDTH: f64 = 44.0;
const COLOR_BAR_MARGIN: f64 = 30.0;
const COLOR_BAR_SPACE: f64 = 250.0;
/// Width of a narrow picture and its height without the key \[px\].
const NARROW_SIZE: (f64, f64) = (800.0, 830.0);
/// Room at the right of axes without a key there \[px\].
const RIGHT_MARGIN: f64 = 40.0;
/// Largest share of the width that a key at the right of the axes takes.
const MAX_LEGEND_SHARE: f64 = 0.2;
/// Number of steps of the colour bar.
const COLOR_BAR_STEPS: u32 = 256;

/// A picture as data. [`Self::to_png`] and [`Self::to_svg`] draw it.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    pub title: String,
    /// The bodies and the law, below the title; empty to leave it out.
    pub caption: String,
    /// Common horizontal axis.
    pub x: Axis,
    /// The boxes, from the top down.
    pub panels: Vec<Panel>,
    /// Entries at the end of the key.
    pub(super) legend_entries: Vec<Series>,
    /// The axis of the colours of a map, with their scale.
    pub(super) color_axis: Option<(Axis, ColorMap)>,
}

/// The colour at a share of the axis of colours.
pub type ColorMap = fn(f64) -> RGBColor;

/// Where everything of a picture lies.
struct ChartLayout {
    /// Width and height of the picture \[px\].
    canvas: (u32, u32),
    /// The room of all boxes.
    bounds: Bounds,
    frames: Vec<PanelFrame>,
    legend: Legend,
    /// Its upper left corner.
    legend_position: Point,
}

/// One box.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    pub y: Axis,
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
        Self { y, series, guides: Vec::new(), cells: Vec::new() }
    }

    fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.series.iter().flat_map(|one| one.points.iter().copied())
    }
}

impl Chart {
    /// A picture of one box.
    pub fn new(title: impl Into<String>, [x, y]: [Axis; 2], series: Vec<Series>) -> Self {
        Self::with_panels(title, x, vec![Panel::new(y, series)])
    }

    /// A picture of several boxes one above the other.
    pub fn with_panels(title: impl Into<String>, x: Axis, panels: Vec<Panel>) -> Self {
        let (title, caption) = (title.into(), String::new());
        Self { title, caption, x, panels, legend_entries: Vec::new(), color_axis: None }
    }

    /// Returns the picture with a line below the title that names bodies and law.
    pub fn with_caption(self, caption: impl Into<String>) -> Self {
        Self { caption: caption.into(), ..self }
    }

    /// Returns the picture with these guides in every box.
    pub fn with_guides(mut self, guides: impl Into<Vec<Series>>) -> Self {
        let guides = guides.into();
        for panel in &mut self.panels {
            panel.guides.extend_from_slice(&guides);
        }
        self
    }

    /// Returns the picture with these texts at the end of the key.
    pub fn with_notes<T: Into<String>>(self, notes: impl IntoIterator<Item = T>) -> Self {
        self.with_legend_entries(notes.into_iter().map(Series::text))
    }

    pub(super) fn with_legend_entries(mut self, entries: impl IntoIterator<Item = Series>) -> Self {
        self.legend_entries.extend(entries);
        self
    }

    /// Returns the picture with entries of the key, in grey, for what the dashes of all colours mean: the first name is that
    /// of solid lines, the second of dashed ones ([`Style::with_line_of_branch`]).
    pub fn with_branches(self, names: &[&str]) -> Self {
        let entry = |(which, name): (usize, &&str)| {
            Series::line(*name, Vec::new()).with_style(Style::line(GREY, 3.0).with_line_of_branch(which))
        };
        self.with_legend_entries(names.iter().enumerate().map(entry))
    }

    /// The picture as PNG: pixels, with the same bytes on every machine.
    ///
    /// # Errors
    /// [`Error`] in a browser, where plotters draws no letters into pixels.
    pub fn to_png(&self) -> Result<Vec<u8>, Error> {
        #[cfg(not(target_arch = "wasm32"))]
        return pen::png::render_png(|pen| self.draw(&self.layout(false), pen));
        #[cfg(target_arch = "wasm32")]
        Err(Error::failed("the built-in font cannot be used"))
    }

    /// The picture as SVG: shapes and text, which stay sharp at any size.
    pub fn to_svg(&self) -> Result<Vec<u8>, Error> {
        self.svg(&self.layout(false))
    }

    /// The picture as SVG for a column of a paper or a narrow window: the axes half as wide, with letters of the same size, and
    /// the key below them.
    pub fn to_narrow_svg(&self) -> Result<Vec<u8>, Error> {
        self.svg(&self.layout(true))
    }

    fn svg(&self, layout: &ChartLayout) -> Result<Vec<u8>, Error> {
        pen::render_svg(layout.canvas, |pen| self.draw(layout, pen))
    }

    fn layout(&self, is_narrow: bool) -> ChartLayout {
        let (width, height) = if is_narrow { NARROW_SIZE } else { (f64::from(SIZE.0), f64::from(SIZE.1)) };
        let all = Bounds { left: LEFT, top: TOP, right: width - RIGHT_MARGIN, bottom: height - BOTTOM };
        // the axis of the colours is at the right of the box, in a narrow picture too
        let right = if self.color_axis.is_some() { width - COLOR_BAR_SPACE } else { all.right };
        let mut frames = self.panel_frames(Bounds { right, ..all });
        let entries = self.styled_legend_entries(&frames);
        let inside = match &self.panels[..] {
            [one] if !is_narrow && self.color_axis.is_none() => {
                let shown: Vec<&Series> = one.series.iter().chain(&one.guides).collect();
                Legend::fit_inside(&entries, &frames[0], &shown)
            }
            _ => None,
        };
        let (key, key_at) = match inside {
            Some(found) => found,
            None if is_narrow => {
                let key = Legend::new(&entries, (width - 2.0 * MARGIN, f64::from(SIZE.1)));
                (key, (MARGIN, height))
            }
            None if self.color_axis.is_some() => {
                (Legend::new(&entries, (COLOR_BAR_SPACE, all.bottom - all.top)), (right + MARGIN, TOP))
            }
            None => {
                let key = Legend::new(&entries, (MAX_LEGEND_SHARE * width - 2.0 * MARGIN, height - TOP - MARGIN));
                let right = if entries.is_empty() { all.right } else { width - key.width() - 2.0 * MARGIN };
                frames = self.panel_frames(Bounds { right, ..all });
                (key, (right + MARGIN, TOP))
            }
        };
        let more = if is_narrow { key.height() } else { 0.0 };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // some thousand pixels
        let sheet = (width as u32, (height + more).ceil() as u32);
        ChartLayout { canvas: sheet, bounds: all, frames, legend: key, legend_position: key_at }
    }

    /// The boxes in this room.
    fn panel_frames(&self, all: Bounds) -> Vec<PanelFrame> {
        let x = self.x.fit(self.panels.iter().flat_map(Panel::points).map(|(x, _)| x));
        let count = self.panels.len() as f64;
        let height = (all.bottom - all.top - GAP * (count - 1.0)) / count;
        let mut bottom = all.top - GAP;
        let mut frames: Vec<PanelFrame> = Vec::new();
        for panel in &self.panels {
            let top = bottom + GAP;
            bottom = top + height;
            let y = panel.y.fit(panel.points().map(|(_, y)| y));
            frames.push(PanelFrame { bounds: Bounds { top, bottom, ..all }, x: x.clone(), y });
        }
        frames
    }

    fn draw<B: DrawingBackend>(&self, layout: &ChartLayout, pen: &mut Pen<B>) -> Result<(), Error> {
        let mut number = 0;
        for (i, (panel, frame)) in self.panels.iter().zip(&layout.frames).enumerate() {
            frame.draw_x(pen, i + 1 == self.panels.len())?;
            frame.draw_y(pen)?;
            for cell in &panel.cells {
                let inside = |value| frame.bounds.clamp(frame.to_pixels(value));
                pen.draw_rectangle(inside(cell.from), inside(cell.to), cell.color)?;
            }
            draw_panel(&panel.series, &panel.guides, frame, number, pen)?;
            number += panel.series.len();
        }
        let right = layout.frames.last().map_or(layout.bounds.right, |frame| frame.bounds.right);
        // in a narrow picture the letters of a caption would be too small to read
        let caption = if layout.canvas.0 < SIZE.0 { "" } else { &self.caption };
        draw_titles(pen, Bounds { right, ..layout.bounds }, [&self.title, caption])?;
        layout.legend.draw(pen, layout.legend_position)?;
        self.draw_color_bar(pen, layout.bounds)
    }

    /// The entries of the key. Guides with the same texts have one entry, in grey if their colours differ.
    fn styled_legend_entries(&self, frames: &[PanelFrame]) -> Vec<(&Series, Style)> {
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
            match named[first..].iter_mut().find(|(other, _)| other.legend_texts == guide.legend_texts) {
                Some((_, other)) if other.color != style.color => other.color = GREY,
                Some(_) => {}
                None => named.push((guide, style)),
            }
        }
        named.extend(self.legend_entries.iter().enumerate().map(styled));
        named.retain(|(series, _)| !series.legend_texts.is_empty());
        named
    }

    /// The colour bar of a map.
    fn draw_color_bar<B: DrawingBackend>(&self, pen: &mut Pen<B>, all: Bounds) -> Result<(), Error> {
        let Some((axis, shade)) = &self.color_axis else { return Ok(()) };
        let right = all.right + RIGHT_MARGIN - COLOR_BAR_MARGIN;
        let bounds = Bounds { left: right - COLOR_BAR_WIDTH, right, ..all };
        let bar = PanelFrame { bounds, x: Axis::linear("", "").fit([]), y: axis.fit([]) };
        bar.draw_y(pen)?;
        let height = (bounds.bottom - bounds.top) / f64::from(COLOR_BAR_STEPS);
        for step in 0..COLOR_BAR_STEPS {
            let below = bounds.bottom - f64::from(step) * height;
            let color = shade((f64::from(step) + 0.5) / f64::from(COLOR_BAR_STEPS));
            pen.draw_rectangle((bounds.left, below - height), (bounds.right, below), color)?;
        }
        bar.draw_outline(pen)
    }
}

/// Draws series and guides of a box, and its outline. `first` is the number of its first series.
fn draw_panel<B: DrawingBackend>(
    series: &[Series],
    guides: &[Series],
    frame: &PanelFrame,
    first: usize,
    pen: &mut Pen<B>,
) -> Result<(), Error> {
    let series = || series.iter().enumerate().map(|(i, one)| (one, one.style(first + i)));
    for (band, style) in series().filter(|(one, _)| one.is_area()) {
        let corners: Vec<_> = band.points.iter().map(|point| frame.to_pixels(*point)).collect();
        pen.draw_polygon(&corners, style.light_color())?;
    }
    for guide in guides {
        frame.draw_curve(pen, &guide.line_points(frame), guide.style(0))?;
    }
    frame.draw_outline(pen)?;
    for (number, (one, style)) in series().enumerate().filter(|(_, (one, _))| !one.is_area()) {
        if one.kind != SeriesKind::Points {
            frame.draw_curve(pen, &one.line_points(frame), style)?;
        }
        let (marked, radius) = one.visible_markers(frame, style, number);
        for point in marked.iter() {
            frame.draw_marker(pen, *point, Style { radius, ..style })?;
        }
    }
    Ok(())
}
