//! A histogram: an area as high as the counts, with lines for mean and quantiles.

use super::{Axis, Chart, PALETTE, Series, Style};

/// A histogram of counts in bars of one width from `low` to `high`. `lines` are vertical lines, such as mean and quantiles,
/// with their labels in the key.
pub fn histogram(
    title: &str,
    x: Axis,
    (low, high): (f64, f64),
    counts: &[u64],
    lines: impl IntoIterator<Item = (f64, String)>,
) -> Chart {
    let edge = |i: usize| low + (high - low) * i as f64 / counts.len() as f64;
    let highest = counts.iter().fold(1.0, |highest: f64, count| highest.max(*count as f64));
    let tops = counts.iter().enumerate().flat_map(|(i, count)| [i, i + 1].map(|i| (edge(i), *count as f64)));
    let outline = [(low, 0.0)].into_iter().chain(tops).chain([(high, 0.0)]).collect();
    // black, vermillion, reddish purple and green over sky blue, each with its own dash
    let guides = lines.into_iter().enumerate().map(|(i, (at, label))| {
        let color = [PALETTE[6], PALETTE[1], PALETTE[3], PALETTE[2]][i % 4];
        Series::vertical(at, label).with_style(Style { color, ..Style::new(i).with_width(3.5) })
    });
    let axes = [x.with_range(low, high), Axis::linear("Count", "").with_range(0.0, 1.06 * highest)];
    Chart::new(title, axes, vec![Series::band("", outline).with_style(5)]).with_guides(guides.collect::<Vec<_>>())
}
