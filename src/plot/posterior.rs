//! What the measurements say of two keys together: the regions of 68 % and 95 %.

use super::axis::{Axis, extremes};
use super::chart::Chart;
use super::of_key::axis_of;
use super::series::Series;
use super::style::{DASHED, Mark, PALETTE, SOLID, Style};
use crate::calibrate::profile::Sheet;
use crate::calibrate::statistics::LEVELS;
use crate::calibrate::{Calibration, Found};

/// Densities below this share of the highest density are not in the picture.
const VISIBLE: f64 = 2e-3;

/// A value of the first key, and values of the second key with the density there.
type Line = (f64, Vec<(f64, f64)>);

/// The regions over both keys.
pub fn map(of: &Calibration, [first, second]: [&Found; 2], sheet: &Sheet) -> Chart {
    let lines: Vec<Line> = sheet
        .iter()
        .map(|(x, line)| (first.free.at(*x), line.iter().map(|(y, density)| (second.free.at(*y), *density)).collect()))
        .collect();
    let seen = || lines.iter().flat_map(|(x, line)| line.iter().filter(|at| at.1 > VISIBLE).map(|at| (*x, at.0)));
    let axis = |found: &Found, (low, high): (f64, f64)| -> Axis {
        let is_logarithmic = found.free.is_logarithmic && high > 5.0 * low;
        axis_of(found.free.key, is_logarithmic).between(low, high)
    };
    let x = axis(first, extremes(seen().map(|at| at.0)));
    let y = axis(second, extremes(seen().map(|at| at.1)));
    let mut series = Vec::new();
    for ((level, dash), name) in LEVELS.into_iter().zip([SOLID, DASHED]).zip(["region of 68 %", "region of 95 %"]) {
        for (i, region) in regions(&lines, of.fit.density_around(level)).into_iter().enumerate() {
            series.push(Series::band("", region.clone()).styled(5));
            let name = if i == 0 { name } else { "" };
            series.push(Series::bare(name, region).styled(Style::of(1).dashed(dash)));
        }
    }
    let best = Style::marker(Mark::Cross, PALETTE[6]);
    series.push(Series::points("best", vec![(first.estimate, second.estimate)]).styled(best));
    let chart = Chart::new("What the measurements say of both keys", [x, y], series);
    if of.refusal.is_some() {
        return chart.with_entries([Series::text("no interval: the data do not tell").and("the keys apart")]);
    }
    chart.with_notes(of.correlation().map(|correlation| format!("correlation {correlation:.2}")))
}

/// The outlines of the regions above a density. A region ends in a tip between its last line and the next.
fn regions(lines: &[Line], level: f64) -> Vec<Vec<(f64, f64)>> {
    let crossing = |from: (f64, f64), to: (f64, f64)| from.0 + (to.0 - from.0) * (level - from.1) / (to.1 - from.1);
    let top = |line: &Line| line.1.iter().copied().fold((f64::NAN, 0.0), |top, at| if at.1 > top.1 { at } else { top });
    let tip = |outer: &Line, inner: &Line| (crossing((outer.0, top(outer).1), (inner.0, top(inner).1)), top(inner).0);
    // where a line first reaches the level, from its beginning or from its end
    let edge = |x: f64, places: Vec<(f64, f64)>| {
        let at = places.iter().position(|place| place.1 >= level)?;
        Some((x, if at == 0 { places[0].0 } else { crossing(places[at - 1], places[at]) }))
    };
    let is_inside = |line: &Line| top(line).1 >= level;
    let (mut regions, mut at) = (Vec::new(), 0_usize);
    for chunk in lines.chunk_by(|a, b| is_inside(a) == is_inside(b)) {
        let before = at.checked_sub(1).map(|before| tip(&lines[before], &chunk[0]));
        at += chunk.len();
        let after = lines.get(at).map(|after| tip(after, &chunk[chunk.len() - 1]));
        if is_inside(&chunk[0]) {
            let lower = chunk.iter().filter_map(|(x, line)| edge(*x, line.clone()));
            let upper = chunk.iter().rev().filter_map(|(x, line)| edge(*x, line.iter().rev().copied().collect()));
            let mut outline: Vec<(f64, f64)> = before.into_iter().chain(lower).chain(after).chain(upper).collect();
            outline.extend(outline.first().copied());
            regions.push(outline);
        }
    }
    regions
}
