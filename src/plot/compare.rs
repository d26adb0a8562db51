//! The picture of a comparison: force against indentation while each law unloads from one peak.

use super::axis::extremes;
use super::style::Style;
use super::{Axis, Chart, Series};
use crate::compare::{Comparison, Origin};
use crate::law::Unloading;
use crate::units::four_digits;

/// Number of pieces of a curve.
const POINTS: u32 = 200;

fn curve(unloading: &Unloading, length: f64, force: f64) -> Vec<(f64, f64)> {
    let (residual, way) = (unloading.peak.residual(), unloading.peak.elastic_approach);
    (0..=POINTS)
        .map(|i| residual + way * f64::from(i) / f64::from(POINTS))
        .map(|x| (x * length, unloading.force(x) * force))
        .collect()
}

/// The picture: force against indentation for every law and for the finite elements.
pub fn picture(comparison: &Comparison) -> Chart {
    let point = &comparison.bodies.yield_point;
    let (length, force) = (point.indentation, point.force);
    let mut series: Vec<Series> = comparison
        .compared()
        .into_iter()
        .filter_map(|one| Some(Series::line(one.name, curve(&one.unloading.ok()?, length, force))))
        .collect();
    if let Some(curve) = comparison.curve() {
        // scaled from the peak of the finite elements, which differs from this peak by less than 1 %
        let (top_x, top_f) = curve.points.first().copied().unwrap_or((1.0, 1.0));
        let (scale_x, scale_f) = (comparison.peak.indentation / top_x, comparison.peak.force / top_f);
        let points = curve.points.iter().map(|(x, f)| (x * scale_x * length, f * scale_f * force)).collect();
        series.push(Series::points("finite elements", points).styled(Style::BLACK));
    }
    let title = format!("Unloading from {} × the yield indentation", four_digits(comparison.peak.indentation));
    // the axis begins a little before the shallowest dent
    let (first, _) = extremes(series.iter().flat_map(|series| &series.points).map(|(x, _)| *x));
    let last = comparison.peak.indentation * length;
    let room = last - first;
    let x = Axis::engineering("Indentation", "m").between((first - 0.1 * room).max(0.0), last + 0.05 * room);
    let y = Axis::engineering("Force", "N").between(0.0, 1.05 * comparison.peak.force * force);
    let origin = match comparison.origin {
        Origin::Plm => "peak: from the PLM",
        Origin::Given => "peak: as given",
    };
    Chart::new(title, [x, y], series).with_notes([origin])
}
