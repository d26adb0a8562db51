//! The posterior of two keys: a map with contours, and the posteriors of the single keys above and beside it.

use super::PlotError;
use super::axis::{Axis, extremes};
use super::canvas::Canvas;
use super::frame::{Bounds, Frame};
use super::key::{self, Entry};
use super::of_key::axis_of;
use super::style::{DASHED, Mark, Marker, PALETTE, SOLID, Stroke, tinted};
use crate::calibrate::profile::Sheet;
use crate::calibrate::statistics::LEVELS;
use crate::calibrate::{Calibration, Found};

/// Height of the box above the map and width of the box beside it \[px\].
const MARGIN: f64 = 150.0;
/// Distance of these boxes from the map \[px\].
const GAP: f64 = 14.0;
/// Densities below this share of the highest density are not drawn.
const VISIBLE: f64 = 2e-3;

/// Number of steps of colour between two places.
const STEPS: u32 = 5;

/// A line of the map: a value of the first key, and values of the second key with the density there.
type Line = (f64, Vec<(f64, f64)>);

pub fn map(of: &Calibration, sheet: &Sheet) -> Result<Canvas, PlotError> {
    let [first, second] = &of.keys[..] else { return Err(PlotError::Data("a map needs two keys".to_owned())) };
    let lines: Vec<Line> = sheet
        .iter()
        .map(|(x, line)| (first.free.at(*x), line.iter().map(|(y, density)| (second.free.at(*y), *density)).collect()))
        .collect();
    let all_places = || lines.iter().flat_map(|(_, line)| line);
    let highest = all_places().map(|(_, density)| *density).fold(0.0, f64::max);
    let is_seen = |(_, density): &&(f64, f64)| *density > VISIBLE * highest;
    let axis = |found: &Found, (low, high): (f64, f64)| {
        let is_logarithmic = found.free.is_logarithmic && high > 5.0 * low;
        axis_of(found.free.key, is_logarithmic).between(low, high).fitted([])
    };
    let seen_lines = lines.iter().filter(|(_, line)| line.iter().any(|place| is_seen(&place)));
    let x = axis(first, extremes(seen_lines.map(|(x, _)| *x)));
    let y = axis(second, extremes(all_places().filter(is_seen).map(|(y, _)| *y)));
    let contours = [SOLID, DASHED].map(|dash| Stroke { color: PALETTE[1], width: 3.0, dash });
    let best = Marker { shape: Mark::Cross, radius: 9.0, color: PALETTE[6] };
    let names = ["68 % lies inside", "95 % lies inside"];
    let mut entries: Vec<Entry> = names.iter().zip(contours).map(|(name, stroke)| Entry::line(name, stroke)).collect();
    entries.push(Entry::mark("best", best));
    if of.refusal.is_some() {
        entries.push(Entry::text("no interval: the data do not tell").and("the keys apart"));
    } else {
        entries.extend(of.correlation().map(|correlation| Entry::text(&format!("correlation {correlation:.2}"))));
    }
    let all = key::bounds(&entries)?;
    let density = Axis::linear("", "").between(0.0, 1.05).fitted([]);
    let bounds = Bounds { top: all.top + MARGIN + GAP, right: all.right - MARGIN - GAP, ..all };
    let above = Bounds { bottom: all.top + MARGIN, top: all.top, ..bounds };
    let right = Bounds { left: all.right - MARGIN, right: all.right, ..bounds };
    let above = Frame { bounds: above, x: x.clone(), y: density.clone() };
    let right = Frame { bounds: right, x: density, y: y.clone() };
    let main = Frame { bounds, x, y };
    let mut canvas = Canvas::default();
    main.draw_axes(&mut canvas)?;
    let inside = |(x, y): (f64, f64)| (x.clamp(bounds.left, bounds.right), y.clamp(bounds.top, bounds.bottom));
    let x_edges = edges(lines.iter().map(|(x, _)| *x));
    for (line, (_, places)) in x_edges.windows(2).zip(&lines) {
        for pair in places.windows(2) {
            // linear between two places, in steps that are too small to see
            for step in 0..STEPS {
                let [below, at, above] = [0.0, 0.5, 1.0].map(|part| (f64::from(step) + part) / f64::from(STEPS));
                let between = |share: f64| pair[0].0 + share * (pair[1].0 - pair[0].0);
                let density = pair[0].1 + at * (pair[1].1 - pair[0].1);
                if density > VISIBLE * highest {
                    let from = inside(main.place(line[0], between(above)));
                    let to = inside(main.place(line[1], between(below)));
                    canvas.rectangle(from, to, tinted(PALETTE[0], density / highest));
                }
            }
        }
    }
    for (level, stroke) in levels(sheet).into_iter().zip(contours) {
        for contour in contour(&lines, level) {
            main.curve(&mut canvas, contour, stroke);
        }
    }
    main.mark(&mut canvas, (first.estimate, second.estimate), best);
    main.draw_outline(&mut canvas);
    for (frame, found, is_turned) in [(&above, first, false), (&right, second, true)] {
        let points = found.relative_posterior().into_iter();
        let points = points.map(|(x, y)| if is_turned { (y, x) } else { (x, y) });
        frame.curve(&mut canvas, points, Stroke::solid(PALETTE[0], 3.0));
        frame.draw_outline(&mut canvas);
    }
    above.draw_title(&mut canvas, "What the measurements say of both keys")?;
    key::draw(&mut canvas, &entries, &Frame { bounds: all, ..above })?;
    Ok(canvas)
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
