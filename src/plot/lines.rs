//! Named curves on two axes, linear or logarithmic, such as restitution against speed.

use plotters::style::RGBColor;

use super::PlotError;
use super::axis::{Axis, FittedAxis};
use super::canvas::Canvas;
use super::frame::Frame;
use super::key::Entry;
use super::sheet::single;
use super::style::{GREY, Mark, Marker, Stroke, series, tinted};
use crate::math::functions::{hypot, pow};

/// Curves on two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Lines {
    pub title: String,
    pub x: Axis,
    pub y: Axis,
    /// The curves, in the order of the key.
    pub series: Vec<Series>,
    pub guides: Vec<Guide>,
    pub notes: Vec<String>,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Name in the key; a curve without a name has no entry.
    pub name: String,
    /// Points in the units of the axes. A point that is not finite, or not positive on a logarithmic axis, interrupts
    /// the curve.
    pub points: Vec<(f64, f64)>,
    pub look: Look,
    /// Index of the style: colour, dash and marker. `None` for the place of the curve in the list.
    pub style: Option<usize>,
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// A line with a few markers along it.
    Line,
    /// A line with a marker on every point, for a few computed points.
    MarkedLine,
    /// Markers only, for measured points.
    Points,
    /// A line without markers, for example on points of the same colour.
    Bare,
    /// The area inside a closed line, in a pale colour.
    Band,
}

impl Series {
    pub fn line(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { name: name.into(), points, look: Look::Line, style: None }
    }

    pub fn bare(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { look: Look::Bare, ..Self::line(name, points) }
    }

    pub fn band(name: impl Into<String>, outline: Vec<(f64, f64)>) -> Self {
        Self { look: Look::Band, ..Self::line(name, outline) }
    }

    pub fn marked_line(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { look: Look::MarkedLine, ..Self::line(name, points) }
    }

    pub fn points(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self { look: Look::Points, ..Self::line(name, points) }
    }

    /// The same series with the colour, dash and marker of this style.
    #[must_use]
    pub fn styled(self, style: usize) -> Self {
        Self { style: Some(style), ..self }
    }
}

/// A line that is not data. It does not extend the axes. If it is inside the box, its label is in the key; guides with
/// the same label have one entry.
#[derive(Debug, Clone, PartialEq)]
pub struct Guide {
    way: Way,
    label: String,
    /// Style of the series that the line belongs to.
    series: Option<usize>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Way {
    Vertical(f64),
    Horizontal(f64),
    Power { through: (f64, f64), slope: f64 },
}

impl Guide {
    fn new(way: Way, label: impl Into<String>) -> Self {
        Self { way, label: label.into(), series: None }
    }

    /// A vertical line at this value of the horizontal axis.
    pub fn vertical(at: f64, label: impl Into<String>) -> Self {
        Self::new(Way::Vertical(at), label)
    }

    /// A horizontal line at this value of the vertical axis.
    pub fn horizontal(at: f64, label: impl Into<String>) -> Self {
        Self::new(Way::Horizontal(at), label)
    }

    /// The curve y = y_0 (x/x_0)^slope through (x_0, y_0), which is straight if both axes are logarithmic.
    pub fn power(through: (f64, f64), slope: f64, label: impl Into<String>) -> Self {
        Self::new(Way::Power { through, slope }, label)
    }

    /// The same line in the colour of this style.
    #[must_use]
    pub fn styled(self, style: usize) -> Self {
        Self { series: Some(style), ..self }
    }

    fn stroke(&self) -> Stroke {
        let dash: &[f64] = match self.way {
            Way::Vertical(_) => &[4.0, 6.0],
            Way::Horizontal(_) => &[22.0, 8.0],
            Way::Power { .. } => &[12.0, 6.0, 2.0, 6.0],
        };
        Stroke { color: self.series.map_or(GREY, |style| series(style).0.color), width: 2.0, dash }
    }

    fn points(&self, x: &FittedAxis, y: &FittedAxis) -> Vec<(f64, f64)> {
        let (x, y) = (|share| x.value_at(share), |share| y.value_at(share));
        match self.way {
            Way::Vertical(at) => vec![(at, y(0.0)), (at, y(1.0))],
            Way::Horizontal(at) => vec![(x(0.0), at), (x(1.0), at)],
            Way::Power { through, slope } => {
                (0..=100).map(|i| x(f64::from(i) / 100.0)).map(|x| (x, through.1 * pow(x / through.0, slope))).collect()
            }
        }
    }
}

/// Number of markers along a curve without markers on its points.
const SPARSE_MARKS: u32 = 6;
/// Share of the colour in a band.
const PALE: f64 = 0.35;
/// Radius of markers \[px\].
const MARK: f64 = 9.0;

impl Lines {
    pub fn new(title: impl Into<String>, [x, y]: [Axis; 2], series: Vec<Series>) -> Self {
        Self { title: title.into(), x, y, series, guides: Vec::new(), notes: Vec::new() }
    }

    #[must_use]
    pub fn with_guides(self, guides: Vec<Guide>) -> Self {
        Self { guides, ..self }
    }

    #[must_use]
    pub fn with_notes<T: Into<String>>(self, notes: impl IntoIterator<Item = T>) -> Self {
        Self { notes: notes.into_iter().map(Into::into).collect(), ..self }
    }

    pub fn draw(&self) -> Result<Canvas, PlotError> {
        let values = || self.series.iter().flat_map(|series| series.points.iter().copied());
        let x = self.x.fitted(values().map(|point| point.0));
        let y = self.y.fitted(values().map(|point| point.1));
        let is_visible = |guide: &&Guide| {
            let mut points = guide.points(&x, &y).into_iter();
            points.any(|(at_x, at_y)| is_share(x.at(at_x)) && is_share(y.at(at_y)))
        };
        let guides: Vec<&Guide> = self.guides.iter().filter(is_visible).collect();
        let series = || self.series.iter().enumerate();
        single(&self.title, [x, y], &self.entries(&guides), |frame, canvas| {
            for (i, band) in series().filter(|(_, one)| one.look == Look::Band) {
                let corners: Vec<_> = band.points.iter().map(|(x, y)| frame.place(*x, *y)).collect();
                canvas.polygon(&corners, self.pale(i));
            }
            for guide in &guides {
                frame.curve(canvas, guide.points(&frame.x, &frame.y), guide.stroke());
            }
            frame.draw_outline(canvas);
            for (i, curve) in series().filter(|(_, one)| one.look != Look::Band) {
                let (stroke, marker) = self.style(i);
                if curve.look != Look::Points {
                    frame.curve(canvas, curve.points.iter().copied(), stroke);
                }
                let marked = match curve.look {
                    Look::Line => self.sparse_marks(frame, i),
                    Look::MarkedLine | Look::Points => curve.points.clone(),
                    Look::Bare | Look::Band => Vec::new(),
                };
                for point in marked {
                    frame.mark(canvas, point, marker);
                }
            }
        })
    }

    fn style(&self, index: usize) -> (Stroke, Marker) {
        let (stroke, shape) = series(self.series[index].style.unwrap_or(index));
        (stroke, Marker { shape, radius: MARK, color: stroke.color })
    }

    fn pale(&self, index: usize) -> RGBColor {
        tinted(self.style(index).0.color, PALE)
    }

    /// Points of a series at equal distances along its curve. They are shifted from series to series, so that markers
    /// do not hide each other where curves coincide.
    fn sparse_marks(&self, frame: &Frame, index: usize) -> Vec<(f64, f64)> {
        let points = &self.series[index].points;
        let mut length = 0.0;
        let lengths: Vec<f64> = std::iter::once(0.0)
            .chain(points.windows(2).map(|pair| {
                let (from, to) = (frame.place(pair[0].0, pair[0].1), frame.place(pair[1].0, pair[1].1));
                let step = hypot(to.0 - from.0, to.1 - from.1);
                length += if step.is_finite() { step } else { 0.0 };
                length
            }))
            .collect();
        #[allow(clippy::cast_precision_loss)] // a handful of series
        let shift = (index + 1) as f64 / (self.series.len() + 1) as f64;
        (0..SPARSE_MARKS)
            .map(|k| length * (f64::from(k) + shift) / f64::from(SPARSE_MARKS))
            .filter_map(|at| points.get(lengths.partition_point(|length| *length < at)).copied())
            .collect()
    }

    fn entries(&self, guides: &[&Guide]) -> Vec<Entry> {
        let entry = |(i, curve): (usize, &Series)| {
            let (stroke, marker) = self.style(i);
            let entry = Entry::text(&curve.name);
            match curve.look {
                Look::Line | Look::MarkedLine => Entry { line: Some(stroke), mark: Some(marker), ..entry },
                Look::Points => entry.marked(marker),
                Look::Bare => Entry { line: Some(stroke), ..entry },
                Look::Band => entry.marked(Marker { shape: Mark::Square, radius: 2.0 * MARK, color: self.pale(i) }),
            }
        };
        let named = self.series.iter().enumerate().filter(|(_, curve)| !curve.name.is_empty());
        let mut entries: Vec<Entry> = named.map(entry).collect();
        for (i, guide) in guides.iter().enumerate() {
            let same = |other: &&Guide| other.label == guide.label;
            if guide.label.is_empty() || guides[..i].iter().any(same) {
                continue;
            }
            let stroke = guide.stroke();
            let is_shared = guides.iter().any(|other| same(other) && other.stroke().color != stroke.color);
            let color = if is_shared { GREY } else { stroke.color };
            entries.push(Entry::line(&guide.label, Stroke { color, ..stroke }));
        }
        entries.extend(self.notes.iter().map(|note| Entry::text(note)));
        entries
    }
}

/// Whether a place is on the axis, with an allowance for rounding.
fn is_share(at: f64) -> bool {
    (-1e-9..=1.0 + 1e-9).contains(&at)
}
