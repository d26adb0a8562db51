//! Boxes one above the other with a common horizontal axis: several quantities against time or against a number.

use super::PlotError;
use super::axis::Axis;
use super::canvas::Canvas;
use super::key::Entry;
use super::lines::{Look, Series};
use super::sheet::stacked;
use super::style::{Marker, solid};

/// Width of the curves \[px\].
const WIDTH: f64 = 3.0;
/// Radius of markers \[px\]. Points that are close together have smaller markers or none.
const MARK: f64 = 7.0;

/// Quantities with a common horizontal axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Stack {
    pub title: String,
    /// Common horizontal axis, with its range.
    pub x: Axis,
    /// The boxes, from the top down.
    pub panels: Vec<Panel>,
    pub notes: Vec<String>,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    pub y: Axis,
    /// Share of the height, relative to the other boxes.
    pub share: f64,
    /// The curves. If a series has no style, its style is its place among all series of the stack.
    pub series: Vec<Series>,
}

impl Panel {
    fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        self.series.iter().flat_map(|one| one.points.iter().copied())
    }
}

impl Stack {
    pub fn draw(&self) -> Result<Canvas, PlotError> {
        let x = self.x.fitted(self.panels.iter().flat_map(Panel::points).map(|(x, _)| x));
        let fitted = |panel: &Panel| (panel.y.fitted(panel.points().map(|(_, y)| y)), panel.share);
        let panels = self.panels.iter().map(fitted).collect();
        let mut index = 0;
        stacked(&self.title, &x, panels, &self.entries(), |i, frame, canvas| {
            for one in &self.panels[i].series {
                let (stroke, marker) = solid(one.style.unwrap_or(index), WIDTH, MARK);
                index += 1;
                if one.look != Look::Points {
                    frame.curve(canvas, one.points.iter().copied(), stroke);
                }
                let mut radius = radius(one.points.len(), frame.bounds.right - frame.bounds.left);
                if one.look == Look::Points {
                    // without a line, the points must stay visible
                    radius = radius.max(2.0);
                }
                if one.look != Look::Line && radius > 0.0 {
                    for point in &one.points {
                        frame.mark(canvas, *point, Marker { radius, ..marker });
                    }
                }
            }
            frame.draw_outline(canvas);
        })
    }

    fn entries(&self) -> Vec<Entry> {
        let all = self.panels.iter().flat_map(|panel| &panel.series).enumerate();
        let named = all.filter(|(_, one)| !one.name.is_empty()).map(|(i, one)| {
            let (stroke, marker) = solid(one.style.unwrap_or(i), WIDTH, MARK);
            Entry {
                line: Some(stroke).filter(|_| one.look != Look::Points),
                mark: Some(marker).filter(|_| one.look != Look::Line),
                ..Entry::text(&one.name)
            }
        });
        named.chain(self.notes.iter().map(|note| Entry::text(note))).collect()
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
