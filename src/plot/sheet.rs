//! The layout of most pictures: boxes one above the other with a common horizontal axis, a title, and the key.

use super::PlotError;
use super::axis::FittedAxis;
use super::canvas::Canvas;
use super::frame::{Bounds, Frame};
use super::key::{self, Entry};

/// Distance between the boxes \[px\].
const GAP: f64 = 28.0;

/// A picture of one box. `content` draws what is inside of it, and its outline.
pub(super) fn single(
    title: &str,
    [x, y]: [FittedAxis; 2],
    entries: &[Entry],
    content: impl Fn(&Frame, &mut Canvas),
) -> Result<Canvas, PlotError> {
    stacked(title, &x, vec![(y, 1.0)], entries, |_, frame, canvas| content(frame, canvas))
}

/// A picture of several boxes. `panels` has their vertical axes from the top down, each with its share of the height.
/// `content` draws what is inside of the box with this number, and its outline.
pub(super) fn stacked(
    title: &str,
    x: &FittedAxis,
    panels: Vec<(FittedAxis, f64)>,
    entries: &[Entry],
    mut content: impl FnMut(usize, &Frame, &mut Canvas),
) -> Result<Canvas, PlotError> {
    let all = key::bounds(entries)?;
    let mut canvas = Canvas::default();
    let last = panels.len() - 1;
    #[allow(clippy::cast_precision_loss)] // a handful
    let room = all.bottom - all.top - GAP * last as f64;
    let shares: f64 = panels.iter().map(|(_, share)| share).sum();
    let mut top = all.top;
    for (i, (y, share)) in panels.into_iter().enumerate() {
        let bottom = top + room * share / shares;
        let frame = Frame { bounds: Bounds { top, bottom, ..all }, x: x.clone(), y };
        frame.draw_x(&mut canvas, i == last)?;
        frame.draw_y(&mut canvas)?;
        content(i, &frame, &mut canvas);
        if i == 0 {
            frame.draw_title(&mut canvas, title)?;
            key::draw(&mut canvas, entries, &frame)?;
        }
        top = bottom + GAP;
    }
    Ok(canvas)
}
