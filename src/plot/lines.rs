//! Curves with names on two axes, linear or logarithmic: work against precision, restitution against speed.

use super::axis::Axis;
use super::canvas::{Anchor, Canvas};
use super::frame::Frame;
use super::key::{self, Entry};
use super::style::{GREY, INK, Mark, Stroke, TITLE_SIZE, series};
use super::{PlotError, SIZE};

/// Curves on two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Lines {
    /// Above the axes; may be empty.
    pub title: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// In the order of the key; colour, dash and marker go by this order.
    pub series: Vec<Series>,
    /// Thin lines that are no data.
    pub guides: Vec<Guide>,
    /// Lines of text below the key.
    pub notes: Vec<String>,
}

/// One curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// In the key.
    pub name: String,
    /// In the units of the axes. A point that is not finite, or not positive on a logarithmic axis, breaks the curve.
    pub points: Vec<(f64, f64)>,
    /// Whether each point has a marker (for few, measured points); if not, a few markers along the curve tell it apart.
    pub has_marks: bool,
}

/// A line that is no data. Its label stands in the key; guides of the same label stand there once.
#[derive(Debug, Clone, PartialEq)]
pub enum Guide {
    /// At one x; in the colour of a series, if it belongs to one.
    Vertical {
        /// x.
        at: f64,
        /// In the key.
        label: String,
        /// Index of the series it belongs to.
        series: Option<usize>,
    },
    /// At one y.
    Horizontal {
        /// y.
        at: f64,
        /// In the key.
        label: String,
    },
    /// y = y_0 (x/x_0)^slope: straight where both axes are logarithmic.
    Power {
        /// (x_0, y_0).
        through: (f64, f64),
        /// Exponent.
        slope: f64,
        /// In the key.
        label: String,
    },
}

impl Guide {
    fn label(&self) -> &str {
        match self {
            Self::Vertical { label, .. } | Self::Horizontal { label, .. } | Self::Power { label, .. } => label,
        }
    }

    fn stroke(&self) -> Stroke {
        let (dash, color): (&[f64], _) = match self {
            Self::Vertical { series: owner, .. } => (&[4.0, 6.0], owner.map_or(GREY, |owner| series(owner).0.color)),
            Self::Horizontal { .. } => (&[22.0, 8.0], GREY),
            Self::Power { .. } => (&[12.0, 6.0, 2.0, 6.0], GREY),
        };
        Stroke { color, width: 2.0, dash }
    }

    fn points(&self, frame: &Frame) -> Vec<(f64, f64)> {
        let (x, y) = (|share| frame.x.value_at(share), |share| frame.y.value_at(share));
        match *self {
            Self::Vertical { at, .. } => vec![(at, y(0.0)), (at, y(1.0))],
            Self::Horizontal { at, .. } => vec![(x(0.0), at), (x(1.0), at)],
            Self::Power { through, slope, .. } => (0..=100)
                .map(|i| x(f64::from(i) / 100.0))
                .map(|x| (x, through.1 * (x / through.0).powf(slope)))
                .collect(),
        }
    }
}

/// Markers along a curve that has none on its points.
const SPARSE_MARKS: usize = 6;

impl Lines {
    /// The picture as PNG.
    ///
    /// # Errors
    /// What drawing and encoding report.
    pub fn to_png(&self) -> Result<Vec<u8>, PlotError> {
        let entries = self.entries();
        let values = || self.series.iter().flat_map(|series| series.points.iter().copied());
        let mut canvas = Canvas::try_new(SIZE)?;
        let frame = Frame {
            bounds: key::bounds(&entries)?,
            x: self.x.fitted(values().map(|point| point.0)),
            y: self.y.fitted(values().map(|point| point.1)),
        };
        frame.draw_axes(&mut canvas, true)?;
        for guide in &self.guides {
            frame.curve(&mut canvas, guide.points(&frame).into_iter(), guide.stroke())?;
        }
        frame.draw_outline(&mut canvas)?;
        for (i, curve) in self.series.iter().enumerate() {
            let (stroke, mark) = series(i);
            frame.curve(&mut canvas, curve.points.iter().copied(), stroke)?;
            let every = if curve.has_marks { 1 } else { (curve.points.len() / SPARSE_MARKS).max(1) };
            // series are shifted against each other, so that markers on a common curve do not hide each other
            let first = if curve.has_marks { 0 } else { (every / 2 + i * every / SPARSE_MARKS) % every };
            for &point in curve.points.iter().skip(first).step_by(every) {
                frame.mark(&mut canvas, point, mark, 9.0, stroke.color)?;
            }
        }
        let middle = 0.5 * (frame.bounds.left + frame.bounds.right);
        canvas.text(&self.title, (middle, 48.0), TITLE_SIZE, INK, Anchor::Middle)?;
        key::draw(&mut canvas, &entries, &frame)?;
        canvas.to_png()
    }

    fn entries(&self) -> Vec<Entry> {
        let mut entries: Vec<Entry> = self
            .series
            .iter()
            .enumerate()
            .map(|(i, curve)| {
                let (stroke, mark): (Stroke, Mark) = series(i);
                Entry { mark: Some((mark, stroke.color)), ..Entry::line(&curve.name, stroke) }
            })
            .collect();
        for (i, guide) in self.guides.iter().enumerate() {
            let same = |other: &Guide| other.label() == guide.label();
            if guide.label().is_empty() || self.guides[..i].iter().any(same) {
                continue;
            }
            let is_shared = self.guides.iter().filter(|other| same(other)).count() > 1;
            let stroke = guide.stroke();
            let color = if is_shared { GREY } else { stroke.color };
            entries.push(Entry::line(guide.label(), Stroke { color, ..stroke }));
        }
        entries.extend(self.notes.iter().map(|note| Entry::text(note)));
        entries
    }
}
