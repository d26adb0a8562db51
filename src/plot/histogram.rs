//! A histogram: an area as high as the counts, with lines for mean and quantiles.

use super::PlotError;
use super::axis::Axis;
use super::chart::Chart;
use super::series::{Guide, Series};
use super::style::{PALETTE, Style};

/// A histogram of counts between rising edges, one more than there are counts. `lines` are vertical lines, such as mean
/// and quantiles, with their labels in the key.
///
/// # Errors
/// [`PlotError::Data`] if the numbers of edges and counts do not fit.
pub fn histogram(
    title: &str,
    x: Axis,
    (edges, counts): (&[f64], &[u64]),
    lines: impl IntoIterator<Item = (f64, String)>,
) -> Result<Chart, PlotError> {
    if counts.is_empty() || edges.len() != counts.len() + 1 {
        let (bins, edges) = (counts.len(), edges.len());
        return Err(PlotError::Data(format!("a histogram of {bins} bins needs one edge more, not {edges}")));
    }
    #[allow(clippy::cast_precision_loss)] // heights of bars
    let bars = edges.windows(2).zip(counts).map(|(pair, count)| (pair[0], pair[1], *count as f64));
    let highest = bars.clone().fold(1.0, |highest: f64, (.., height)| highest.max(height));
    let (first, last) = (edges[0], edges[counts.len()]);
    let tops = bars.flat_map(|(from, to, height)| [(from, height), (to, height)]);
    let outline = [(first, 0.0)].into_iter().chain(tops).chain([(last, 0.0)]).collect();
    // black, vermillion, reddish purple and green over sky blue, each with its own dash
    let guides = lines.into_iter().enumerate().map(|(i, (at, label))| {
        let color = [PALETTE[6], PALETTE[1], PALETTE[3], PALETTE[2]][i % 4];
        Guide::vertical(at, label).styled(Style { color, ..Style::of(i).wide(3.5) })
    });
    let axes = [x.between(first, last), Axis::linear("Count", "").between(0.0, 1.06 * highest)];
    Ok(Chart::new(title, axes, vec![Series::band("", outline).styled(5)]).with_guides(guides.collect::<Vec<_>>()))
}
