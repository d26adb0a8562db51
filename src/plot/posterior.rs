//! The posterior of two keys: a map with contours.

use super::axis::{Axis, extremes};
use super::chart::{Cell, Chart};
use super::key::Entry;
use super::of_key::axis_of;
use super::series::Series;
use super::style::{DASHED, Mark, PALETTE, SOLID, Style, tinted};
use crate::calibrate::profile::Sheet;
use crate::calibrate::statistics::LEVELS;
use crate::calibrate::{Calibration, Found};

/// Densities below this share of the highest density are not drawn.
const VISIBLE: f64 = 2e-3;
/// Number of steps of colour between two places.
const STEPS: u32 = 5;

/// A line of the map: a value of the first key, and values of the second key with the density there.
type Line = (f64, Vec<(f64, f64)>);

/// The map of a sheet over both keys.
pub fn map(of: &Calibration, [first, second]: [&Found; 2], sheet: &Sheet) -> Chart {
    let lines: Vec<Line> = sheet
        .iter()
        .map(|(x, line)| (first.free.at(*x), line.iter().map(|(y, density)| (second.free.at(*y), *density)).collect()))
        .collect();
    let all_places = || lines.iter().flat_map(|(_, line)| line);
    let highest = all_places().map(|(_, density)| *density).fold(0.0, f64::max);
    let is_seen = |(_, density): &&(f64, f64)| *density > VISIBLE * highest;
    let axis = |found: &Found, (low, high): (f64, f64)| -> Axis {
        let is_logarithmic = found.free.is_logarithmic && high > 5.0 * low;
        axis_of(found.free.key, is_logarithmic).between(low, high)
    };
    let seen_lines = lines.iter().filter(|(_, line)| line.iter().any(|place| is_seen(&place)));
    let x = axis(first, extremes(seen_lines.map(|(x, _)| *x)));
    let y = axis(second, extremes(all_places().filter(is_seen).map(|(y, _)| *y)));
    let mut series = Vec::new();
    let names = ["68 % lies inside", "95 % lies inside"];
    for ((level, dash), name) in levels(sheet).into_iter().zip([SOLID, DASHED]).zip(names) {
        for (i, contour) in contour(&lines, level).into_iter().enumerate() {
            let name = if i == 0 { name } else { "" };
            series.push(Series::bare(name, contour).styled(Style::of(1).dashed(dash)));
        }
    }
    let best = Style::marker(Mark::Cross, PALETTE[6]);
    series.push(Series::points("best", vec![(first.estimate, second.estimate)]).styled(best));
    let mut chart = Chart::new("What the measurements say of both keys", [x, y], series);
    if of.refusal.is_some() {
        chart = chart.with_entries([Entry::text("no interval: the data do not tell").and("the keys apart")]);
    } else {
        chart.notes.extend(of.correlation().map(|correlation| format!("correlation {correlation:.2}")));
    }
    chart.panels[0].cells = cells(&lines, highest);
    chart
}

/// The cells of the map. Between two places the density is linear, in steps that are too small to see.
fn cells(lines: &[Line], highest: f64) -> Vec<Cell> {
    let x_edges = edges(lines.iter().map(|(x, _)| *x));
    let mut cells = Vec::new();
    for (x, (_, places)) in x_edges.windows(2).zip(lines) {
        for pair in places.windows(2) {
            for step in 0..STEPS {
                let [below, at, above] = [0.0, 0.5, 1.0].map(|part| (f64::from(step) + part) / f64::from(STEPS));
                let between = |share: f64| pair[0].0 + share * (pair[1].0 - pair[0].0);
                let density = pair[0].1 + at * (pair[1].1 - pair[0].1);
                if density > VISIBLE * highest {
                    let (from, to) = ((x[0], between(above)), (x[1], between(below)));
                    cells.push(Cell { from, to, color: tinted(PALETTE[0], density / highest) });
                }
            }
        }
    }
    cells
}

/// Borders between the values: half-way between neighbours. The outer borders are the outer values.
fn edges(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let values: Vec<f64> = values.collect();
    let inner = values.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]));
    values.first().copied().into_iter().chain(inner).chain(values.last().copied()).collect()
}

/// The densities above which the posterior has the probabilities of [`LEVELS`].
fn levels(sheet: &Sheet) -> [f64; 2] {
    let x_edges = edges(sheet.iter().map(|(x, _)| *x));
    let mut cells: Vec<(f64, f64)> = Vec::new();
    for (i, (_, line)) in sheet.iter().enumerate() {
        let y_edges = edges(line.iter().map(|(y, _)| *y));
        let width = x_edges[i + 1] - x_edges[i];
        let heights = y_edges.windows(2).map(|edge| edge[1] - edge[0]);
        cells.extend(line.iter().zip(heights).map(|((_, density), height)| (*density, density * width * height)));
    }
    cells.sort_by(|a, b| b.0.total_cmp(&a.0));
    let all: f64 = cells.iter().map(|(_, mass)| mass).sum();
    LEVELS.map(|level| {
        let mut mass = 0.0;
        let last = cells.iter().find(|(_, part)| {
            mass += part;
            mass >= level * all
        });
        last.map_or(0.0, |(density, _)| *density)
    })
}

/// The borders of the regions above a density. Each line of the map that reaches the density adds a point to the lower
/// side and a point to the upper side of a region. A region ends in a tip before the first line below the density, and
/// a later line may begin a new region.
fn contour(lines: &[Line], level: f64) -> Vec<Vec<(f64, f64)>> {
    let top = |line: &Line| line.1.iter().copied().fold((f64::NAN, 0.0), |top, at| if at.1 > top.1 { at } else { top });
    let crossing = |from: (f64, f64), to: (f64, f64)| from.0 + (to.0 - from.0) * (level - from.1) / (to.1 - from.1);
    // the tip between a line below the level and a line that reaches it
    let tip = |outer: &Line, inner: &Line| (crossing((outer.0, top(outer).1), (inner.0, top(inner).1)), top(inner).0);
    let mut regions: Vec<[Vec<(f64, f64)>; 2]> = Vec::new();
    let mut before: Option<&Line> = None;
    for line in lines {
        let (x, places) = line;
        let first = places.iter().position(|(_, density)| *density >= level);
        let last = places.iter().rposition(|(_, density)| *density >= level);
        let was_inside = before.is_some_and(|before| top(before).1 >= level);
        match (first.zip(last), before) {
            (None, Some(before)) if was_inside => {
                regions.last_mut().into_iter().for_each(|[lower, _]| lower.push(tip(line, before)));
            }
            (Some((first, last)), _) => {
                if !was_inside {
                    let start = before.map(|before| tip(before, line));
                    regions.push([start.into_iter().collect(), Vec::new()]);
                }
                let low = if first == 0 { places[0].0 } else { crossing(places[first - 1], places[first]) };
                let high = places.get(last + 1).map_or(places[last].0, |after| crossing(*after, places[last]));
                if let Some([lower, upper]) = regions.last_mut() {
                    lower.push((*x, low));
                    upper.push((*x, high));
                }
            }
            (None, _) => {}
        }
        before = Some(line);
    }
    let closed = regions.into_iter().map(|[lower, upper]| {
        let start = lower[0];
        lower.into_iter().chain(upper.into_iter().rev()).chain([start]).collect()
    });
    closed.collect()
}
