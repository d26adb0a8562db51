//! Boxes one above the other with a common horizontal axis: several quantities against time or against a number.

use super::axis::Axis;
use super::canvas::Canvas;
use super::frame::{Bounds, Frame};
use super::key::{self, Entry};
use super::lines::{Look, Series};
use super::style::{SOLID, Stroke, series};
use super::{PlotError, SIZE};

/// Distance between the boxes \[px\].
const GAP: f64 = 28.0;
/// Radius of markers \[px\]. Points that are close together have smaller markers or none.
const MARK: f64 = 7.0;

/// Quantities with a common horizontal axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Stack {
    /// Title above the boxes.
    pub title: String,
    /// Common horizontal axis, with its range.
    pub x: Axis,
    /// The boxes, from the top down.
    pub panels: Vec<Panel>,
    /// Lines of text below the key.
    pub notes: Vec<String>,
}

/// One box.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// Vertical axis.
    pub y: Axis,
    /// Share of the height, relative to the other boxes.
    pub share: f64,
    /// The curves. If a series has no style, its style is its place among all series of the stack.
    pub series: Vec<Series>,
}

impl Stack {
    /// The picture.
    ///
    /// # Errors
    /// [`PlotError`].
    pub fn draw(&self) -> Result<Canvas, PlotError> {
        let entries = self.entries();
        let all = key::bounds(&entries)?;
        let mut canvas = Canvas::try_new(SIZE)?;
        #[allow(clippy::cast_precision_loss)] // a handful
        let room = all.bottom - all.top - GAP * (self.panels.len() - 1) as f64;
        let shares: f64 = self.panels.iter().map(|panel| panel.share).sum();
        let mut top = all.top;
        let mut index = 0;
        for (i, panel) in self.panels.iter().enumerate() {
            let bottom = top + room * panel.share / shares;
            let values = || panel.series.iter().flat_map(|series| series.points.iter().copied());
            let frame = Frame {
                bounds: Bounds { top, bottom, ..all },
                x: self.x.fitted(
                    self.panels
                        .iter()
                        .flat_map(|panel| &panel.series)
                        .flat_map(|one| one.points.iter().map(|point| point.0)),
                ),
                y: panel.y.fitted(values().map(|point| point.1)),
            };
            frame.draw_x(&mut canvas, i + 1 == self.panels.len())?;
            frame.draw_y(&mut canvas)?;
            for one in &panel.series {
                let (stroke, mark) = series(one.style.unwrap_or(index));
                index += 1;
                if one.look != Look::Points {
                    frame.curve(&mut canvas, one.points.iter().copied(), Stroke { dash: SOLID, ..stroke });
                }
                let mut radius = radius(one.points.len(), all.right - all.left);
                if one.look == Look::Points {
                    // without a line, the points must stay visible
                    radius = radius.max(2.0);
                }
                if one.look != Look::Line && radius > 0.0 {
                    for point in &one.points {
                        frame.mark(&mut canvas, *point, mark, radius, stroke.color);
                    }
                }
            }
            frame.draw_outline(&mut canvas);
            if i == 0 {
                frame.draw_title(&mut canvas, &self.title)?;
                key::draw(&mut canvas, &entries, &frame)?;
            }
            top = bottom + GAP;
        }
        Ok(canvas)
    }

    fn entries(&self) -> Vec<Entry> {
        let all = self.panels.iter().flat_map(|panel| &panel.series).enumerate();
        let mut entries: Vec<Entry> = all
            .filter(|(_, one)| !one.name.is_empty())
            .map(|(i, one)| {
                let (stroke, mark) = series(one.style.unwrap_or(i));
                let mark = Some((mark, MARK, stroke.color)).filter(|_| one.look != Look::Line);
                let entry = Entry::line(&one.name, Stroke { dash: SOLID, ..stroke });
                let line = entry.line.filter(|_| one.look != Look::Points);
                Entry { line, mark, ..entry }
            })
            .collect();
        entries.extend(self.notes.iter().map(|note| Entry::text(note)));
        entries
    }
}

/// Radius of the markers of `count` points in a box of this width.
fn radius(count: usize, width: f64) -> f64 {
    #[allow(clippy::cast_precision_loss)]
    let room = width / count.max(1) as f64;
    if room > 3.0 * MARK {
        MARK
    } else if room > 4.0 {
        3.0
    } else {
        0.0
    }
}
