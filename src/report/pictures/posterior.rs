//! The regions of two keys together in which their true values lie with 68 % and 95 %.

use super::key_axis;
use crate::calibrate::statistics::LEVELS;
use crate::calibrate::{Calibration, KeyEstimate};
use crate::report::chart::{Axis, Chart, DASHED, Marker, PALETTE, SOLID, Series, Style, min_max};

/// The regions over both keys; `None` if they have none.
pub fn posterior_chart(calibration: &Calibration, [first, second]: [&KeyEstimate; 2]) -> Option<Chart> {
    let [x_unit, y_unit] = [first, second].map(|found| found.free.key.quantity().picture_unit().1);
    let mut series = Vec::new();
    for ((level, dash), name) in LEVELS.into_iter().zip([SOLID, DASHED]).zip(["region of 68 %", "region of 95 %"]) {
        for (i, outline) in calibration.fit.region(level).into_iter().enumerate() {
            let region: Vec<_> = outline
                .iter()
                .map(|[x, y]| (x_unit(first.free.value_at_share(*x)), y_unit(second.free.value_at_share(*y))))
                .collect();
            series.push(Series::band("", region.clone()).with_style(5));
            let name = if i == 0 { name } else { "" };
            series.push(Series::line(name, region).with_style(Style::new(1).with_dash(dash)));
        }
    }
    let axis = |found: &KeyEstimate, (low, high): (f64, f64)| -> Axis {
        let is_logarithmic = found.free.is_logarithmic && high > 5.0 * low;
        key_axis(found.free.key, is_logarithmic)
    };
    let seen = || series.iter().flat_map(|one| &one.points);
    let x = axis(first, min_max(seen().map(|at| at.0)));
    let y = axis(second, min_max(seen().map(|at| at.1)));
    if series.is_empty() {
        return None;
    }
    let best = Style::marker(Marker::Cross, PALETTE[6]);
    series.push(Series::points("best", vec![(x_unit(first.estimate), y_unit(second.estimate))]).with_style(best));
    let chart = Chart::new("What the measurements say of both keys", [x, y], series);
    if calibration.reason_without_intervals.is_some() {
        return Some(chart.with_legend_entries([Series::text("no interval: the data do not tell the keys apart")]));
    }
    Some(chart.with_notes(calibration.correlation().map(|correlation| format!("correlation {correlation:.2}"))))
}
