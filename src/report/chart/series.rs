//! The lines and points of a picture: series of points, and guides that are not data.

use std::borrow::Cow;

use super::frame::PanelFrame;
use super::style::Dash;
use super::{GREY, MARKER_RADIUS, Marker, Style};

/// Radius of the markers of a [`SeriesKind::LabelledLine`], their distance along the horizontal axis \[px\], and the places of the
/// first one in shares of that distance, one for each series in turn.
const SMALL_MARK: f64 = 7.0;
const MARK_DISTANCE: f64 = 200.0;
const MARK_SHIFTS: [f64; 7] = [0.1, 0.53, 0.24, 0.67, 0.38, 0.81, 0.95];

/// Named points on two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// Texts in the key, the first one in black; a series without texts has no entry.
    pub legend_texts: Vec<String>,
    /// Points in the units of the axes. A point that is not finite interrupts the curve, and so does one that is not positive
    /// on a logarithmic horizontal axis. On a logarithmic vertical axis the curve then goes to the edge.
    pub points: Vec<(f64, f64)>,
    pub kind: SeriesKind,
    /// `None` for the style of the place of the series in its picture.
    pub style: Option<Style>,
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SeriesKind {
    /// A line without markers: a law.
    Line,
    /// Lines from low to high ends. A low end that a logarithmic axis cannot have is drawn at the lower end of the axis.
    Bars,
    /// A line with a marker on every point, for a few computed points.
    MarkedLine,
    /// A line with markers at even distances, which are no points of its own: one of many lines that cross.
    LabelledLine,
    /// Markers only, for measured points.
    Points,
    /// The area inside a closed line, in a pale colour.
    Band,
    /// Not drawn: texts in the key.
    Text,
    /// A guide at this value of the horizontal axis.
    Vertical(f64),
    /// A guide at this value of the vertical axis.
    Horizontal(f64),
}

impl Series {
    fn new(name: impl Into<String>, points: Vec<(f64, f64)>, kind: SeriesKind) -> Self {
        let name = name.into();
        Self { legend_texts: if name.is_empty() { Vec::new() } else { vec![name] }, points, kind, style: None }
    }

    pub fn line(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, SeriesKind::Line)
    }

    pub fn band(name: impl Into<String>, outline: Vec<(f64, f64)>) -> Self {
        Self::new(name, outline, SeriesKind::Band)
    }

    /// A column from `left` to `right` as high as its value; it is empty where that is no number.
    pub fn column(name: impl Into<String>, [left, right]: [f64; 2], value: f64) -> Self {
        let outline = vec![(left, 0.0), (left, value), (right, value), (right, 0.0)];
        Self::new(name, if value.is_finite() { outline } else { Vec::new() }, SeriesKind::Band)
    }

    /// Error bars at (x, y), of a standard deviation on each side.
    pub fn error_bars(values: impl Iterator<Item = (f64, f64, f64)>) -> Self {
        // a point of NaN separates the bars
        let ends = values.flat_map(|(x, y, sd)| [(x, y - sd), (x, y + sd), (f64::NAN, f64::NAN)]);
        Self::new("", ends.collect(), SeriesKind::Bars)
    }

    pub fn text(text: impl Into<String>) -> Self {
        Self::new(text, Vec::new(), SeriesKind::Text)
    }

    pub fn marked_line(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, SeriesKind::MarkedLine)
    }

    pub fn points(name: impl Into<String>, points: Vec<(f64, f64)>) -> Self {
        Self::new(name, points, SeriesKind::Points)
    }

    /// A guide: a line that is not data, and does not extend the axes. It has an entry in the key if it crosses the box;
    /// guides with the same texts have one entry.
    fn guide(look: SeriesKind, label: impl Into<String>, dash: Dash) -> Self {
        Self::new(label, Vec::new(), look).with_style(Style::line(GREY, 2.0).with_dash(dash))
    }

    /// A vertical guide at this value of the horizontal axis.
    pub fn vertical(at: f64, label: impl Into<String>) -> Self {
        Self::guide(SeriesKind::Vertical(at), label, &[4.0, 6.0])
    }

    /// A horizontal guide at this value of the vertical axis.
    pub fn horizontal(at: f64, label: impl Into<String>) -> Self {
        Self::guide(SeriesKind::Horizontal(at), label, &[22.0, 8.0])
    }

    /// Returns the series in this style; a number is a place in the cycle of styles.
    pub fn with_style(self, style: impl Into<Style>) -> Self {
        Self { style: Some(style.into()), ..self }
    }

    /// Returns the series in this colour, with its width and dash.
    pub(in crate::report) fn with_color(self, style: impl Into<Style>) -> Self {
        let own = self.style.unwrap_or(Style::BLACK);
        Self { style: Some(Style { color: style.into().color, ..own }), ..self }
    }

    /// Returns the series with one more text in the key.
    pub fn with_note(mut self, text: impl Into<String>) -> Self {
        self.legend_texts.push(text.into());
        self
    }

    /// Its style if it is the series with this number in its picture.
    pub(in crate::report) fn style(&self, number: usize) -> Style {
        self.style.unwrap_or_else(|| Style::new(number))
    }

    pub(in crate::report) fn is_area(&self) -> bool {
        self.kind == SeriesKind::Band
    }

    /// The line and the marker that stand for it in the key.
    pub(in crate::report) fn legend_sample(&self, style: Style) -> [Option<Style>; 2] {
        match self.kind {
            SeriesKind::MarkedLine | SeriesKind::LabelledLine => [Some(style); 2],
            SeriesKind::Points => [None, Some(style)],
            SeriesKind::Band => [
                None,
                Some(Style { radius: 2.0 * MARKER_RADIUS, ..Style::marker(Marker::Square, style.light_color()) }),
            ],
            SeriesKind::Text => [None; 2],
            SeriesKind::Line | SeriesKind::Bars | SeriesKind::Vertical(_) | SeriesKind::Horizontal(_) => {
                [Some(style), None]
            }
        }
    }

    /// The points with a marker, and its radius. Points that are close together have smaller markers or none. The number
    /// of the series moves the markers of a [`SeriesKind::LabelledLine`], so that those of lines close together do not cover each
    /// other.
    pub(in crate::report) fn visible_markers(
        &self,
        frame: &PanelFrame,
        style: Style,
        number: usize,
    ) -> (Cow<'_, [(f64, f64)]>, f64) {
        let width = frame.bounds.right - frame.bounds.left;
        let room = width / self.points.len().max(1) as f64;
        let all = || Cow::from(&self.points);
        match self.kind {
            SeriesKind::MarkedLine if room <= 4.0 => (Cow::default(), 0.0),
            SeriesKind::MarkedLine if room <= 3.0 * style.radius => (all(), 3.0),
            SeriesKind::Points if room <= 4.0 => (all(), 4.0),
            SeriesKind::MarkedLine | SeriesKind::Points => (all(), style.radius),
            SeriesKind::LabelledLine => (self.spread(frame, number).into(), SMALL_MARK),
            _ => (Cow::default(), 0.0),
        }
    }

    /// Some points of the line that are about [`MARK_DISTANCE`] apart along the horizontal axis.
    fn spread(&self, frame: &PanelFrame, number: usize) -> Vec<(f64, f64)> {
        let mut next = frame.bounds.left + MARK_DISTANCE * MARK_SHIFTS[number % MARK_SHIFTS.len()];
        let is_next = |point: &&(f64, f64)| {
            let at = frame.to_pixels(**point);
            let is_reached = at.0 >= next && at.1.is_finite();
            while at.0 >= next && is_reached {
                next += MARK_DISTANCE;
            }
            is_reached
        };
        self.points.iter().filter(is_next).copied().collect()
    }

    /// The points of the line. That of a guide crosses the box.
    pub(in crate::report) fn line_points(&self, frame: &PanelFrame) -> Cow<'_, [(f64, f64)]> {
        let (x, y) = (|share| frame.x.value_at(share), |share| frame.y.value_at(share));
        match self.kind {
            SeriesKind::Vertical(at) => vec![(at, y(0.0)), (at, y(1.0))].into(),
            SeriesKind::Horizontal(at) => vec![(x(0.0), at), (x(1.0), at)].into(),
            SeriesKind::Bars => {
                let cut = |at: f64| if at.is_nan() || frame.y.position(at).is_finite() { at } else { y(0.0) };
                self.points.iter().map(|&(x, at)| (x, cut(at))).collect()
            }
            _ => (&self.points).into(),
        }
    }

    /// True if a part of a guide is inside the box, with an allowance for rounding.
    pub(in crate::report) fn is_visible(&self, frame: &PanelFrame) -> bool {
        let is_share = |at: f64| (-1e-9..=1.0 + 1e-9).contains(&at);
        self.line_points(frame)
            .iter()
            .any(|point| is_share(frame.x.position(point.0)) && is_share(frame.y.position(point.1)))
    }
}
