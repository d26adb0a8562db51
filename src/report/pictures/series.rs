//! Pictures of repeated impacts: height against time, the loops of all impacts, and speed, e and dent against the number of the
//! impact.

use super::loops;
use crate::error::Error;
use crate::impact::Impact;
use crate::impact::flight::trajectory::Flight;
use crate::impact::series::{ImpactSeries, SeriesImpact, SeriesResult, SpotMode};
use crate::numerics::functions::pow;
use crate::report::chart::{Axis, Chart, GREY, Panel, Series, Style};
use crate::strings::capitalise;
use crate::units::{Dimension, format_four_digits, format_result};

/// Points of the curve of one flight.
pub(super) const FLIGHT_POINTS: u32 = 48;
/// Points of all flights together; more are not needed for a picture of 1600 px.
const MAX_POINTS: usize = 200_000;

/// The height of the lowest point of the sphere against time. `None` for shots, which have no times.
pub fn height_chart(repeat: &ImpactSeries, sequence: &SeriesResult) -> Option<Chart> {
    let last = sequence.impacts.last()?;
    let end = last.time? + if last.impact.row.contact_time.is_finite() { last.impact.row.contact_time } else { 0.0 };
    let flights: Vec<&Flight> =
        sequence.fall.iter().chain(sequence.impacts.iter().filter_map(|hit| hit.flight.as_ref())).collect();
    let points = (MAX_POINTS / flights.len().max(1)).clamp(2, FLIGHT_POINTS as usize);
    let points = u32::try_from(points).unwrap_or(FLIGHT_POINTS);
    let along = |flight: &Flight| flight_points(flight, points, |time| flight.begin + time);
    let mut curve: Vec<(f64, f64)> = flights.iter().flat_map(|flight| along(flight)).collect();
    curve.extend(last.time.map(|time| (time, 0.0)));
    // where the air takes more than 1 % of a height
    let free = flights.iter().map(|flight| (flight.apex_height(), flight.without_air()));
    let free = free.filter(|(top, free)| free.apex_height() > 1.01 * top).map(|(_, free)| along(&free));
    let mut without_air: Vec<Series> =
        free.map(|points| Series::line("", points).with_style(Style::line(GREY, 1.5))).collect();
    if let Some(first) = without_air.first_mut() {
        first.legend_texts.push("Same take-off without air".to_owned());
    }
    // a key that has no other entry would repeat the title of the axis
    let name = if without_air.is_empty() { "" } else { "With air" };
    let path = Series::line(name, curve);
    let drawn: Vec<Series> = [path].into_iter().chain(without_air).collect();
    let highest = drawn.iter().flat_map(|one| &one.points).map(|at| at.1).fold(0.0, f64::max);
    let y = Axis::linear("Height of the lowest point", "m").with_range(0.0, 1.06 * highest);
    let x = Axis::linear("Time", "s").with_range(0.0, 1.03 * end);
    Some(Chart::new(title(repeat, sequence), [x, y], drawn))
}

/// Heights along a flight over a quantity that follows from the time since its begin.
pub(super) fn flight_points(flight: &Flight, points: u32, over: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let times = (0..=points).map(|i| flight.duration * f64::from(i) / f64::from(points));
    times.map(|time| (over(time), flight.height_at(time))).collect()
}

/// Number of the impacts, and their spot.
pub(super) fn title(repeat: &ImpactSeries, sequence: &SeriesResult) -> String {
    let impacts = if repeat.is_bouncing() { "bounces" } else { "shots" };
    let place = match repeat.spot_mode {
        SpotMode::Same => "on the same spot",
        SpotMode::Fresh => "on fresh surface",
    };
    let count = sequence.impacts.len();
    let impacts = if count == 1 { impacts.trim_end_matches('s') } else { impacts };
    format!("{count} {impacts} {place}")
}

/// Impact speed, e, and the depth of the dent against the number of the impact.
pub fn impacts_chart(repeat: &ImpactSeries, sequence: &SeriesResult) -> Chart {
    let panel = |y: Axis, highest: f64, name: &str, style: usize, value: fn(&SeriesImpact) -> f64| {
        let points = sequence.impacts.iter().enumerate().map(|(i, hit)| ((i + 1) as f64, value(hit)));
        let series = Series::marked_line(name, points.collect()).with_style(Style::new(style).with_solid_line());
        Panel::new(y.with_range(0.0, highest), vec![series])
    };
    let last = sequence.impacts.len() as f64;
    let fastest = sequence.impacts.iter().map(|hit| hit.approach.normal).fold(0.0, f64::max);
    let largest = sequence.impacts.iter().map(|hit| hit.impact.row.measured_restitution()).fold(0.0, f64::max);
    let has_waves = sequence.impacts.iter().any(|hit| hit.impact.row.wave_loss_fraction.is_some());
    let name = if has_waves { "Restitution e with waves" } else { "Restitution e" };
    let top = if largest > 0.8 { 1.1 } else { 1.2 * largest };
    let mut panels = vec![
        panel(Axis::linear("Speed", "m/s"), 1.15 * fastest, "Impact speed v", 4, |hit| hit.approach.normal),
        panel(Axis::linear("Restitution", ""), top, name, 0, |hit| hit.impact.row.measured_restitution()),
    ];
    let deepest = sequence.deepest_dent();
    if deepest > 0.0 {
        let mark = capitalise(sequence.imprint_name());
        let y = Axis::linear(&format!("{mark} depth"), "m");
        panels.push(panel(y, 1.15 * deepest, &format!("{mark} δᵣ"), 1, |hit| hit.impact.row.residual_indentation));
    }
    let x = if last > 200.0 {
        Axis::log("Impact", "").with_range(0.9, 1.1 * last)
    } else {
        Axis::linear("Impact", "").with_range(0.0, last + 1.0)
    };
    Chart::with_panels(title(repeat, sequence), x, panels)
}

/// Largest number of loops with a colour and an entry in the key. The other loops are grey.
const MAX_COLORED_LOOPS: usize = 7;
/// Loops are drawn on logarithmic axes if the largest force is more than this multiple of the smallest.
const LOG_AXIS_RATIO: f64 = 20.0;
/// Largest number of loops that are drawn. More loops would only cover each other.
const MAX_LOOPS: usize = 300;

/// Force against approach of all traced impacts, for loading and unloading.
pub fn loops_chart(repeat: &ImpactSeries, sequence: &SeriesResult) -> Result<Chart, Error> {
    let traced: Vec<&Impact> = sequence.traced_impacts().iter().map(|hit| &hit.impact).collect();
    if traced.is_empty() {
        return Err(Error::failed("loops need traces: run the series with samples"));
    }
    // identical impacts have one loop
    let same = |a: &&Impact, b: &&Impact| {
        let identity = |one: &Impact| (one.speed, one.row.restitution, one.row.peak_indentation);
        identity(a) == identity(b)
    };
    let groups: Vec<&[&Impact]> = traced.chunk_by(same).collect();
    let mut named = spaced_indices(groups.len(), MAX_COLORED_LOOPS);
    let largest =
        (0..groups.len()).max_by(|a, b| groups[*a][0].row.peak_force.total_cmp(&groups[*b][0].row.peak_force));
    if let Some(largest) = largest.filter(|largest| !named.contains(largest)) {
        named.push(largest);
        named.sort_unstable();
    }
    let one_loop = |impact, name: String, style| {
        loops::impact_loop(impact).map(|branches| loops::loop_series(name, style, &branches, 0)).unwrap_or_default()
    };
    let grey = Style::line(GREY, 1.5);
    let mut series: Vec<Series> = spaced_indices(traced.len(), MAX_LOOPS)
        .into_iter()
        .flat_map(|i| one_loop(traced[i], String::new(), grey))
        .collect();
    // loops lie on each other where they follow the same branch, so each is narrower than the one before
    for (i, number) in named.iter().enumerate() {
        let first = 1 + groups[..*number].iter().map(|group| group.len()).sum::<usize>();
        let (impact, count) = (groups[*number][0], groups[*number].len());
        let name =
            if count == 1 { format!("Impact {first}") } else { format!("Impacts {first} to {}", first + count - 1) };
        let mut drawn = one_loop(impact, name, loops::loop_style(i, loop_width(i, named.len())));
        let about = format!(
            "{}, e = {}",
            format_result(impact.speed, Dimension::Speed),
            format_four_digits(impact.row.restitution)
        );
        drawn.iter_mut().take(1).for_each(|first| first.legend_texts.push(about.clone()));
        series.extend(drawn);
    }
    let deepest = traced.iter().map(|impact| impact.row.peak_indentation).fold(0.0, f64::max);
    let strongest = traced.iter().flat_map(|impact| &impact.trace).map(|row| row.force).fold(0.0, f64::max);
    let [x, y] = [Axis::linear("Indentation", "m"), Axis::linear("Force", "N")];
    let least = |value: fn(&Impact) -> f64| {
        traced.iter().copied().map(value).filter(|least| *least > 0.0).fold(f64::MAX, f64::min)
    };
    let (shallowest, weakest) = (least(|impact| impact.row.peak_indentation), least(|impact| impact.row.peak_force));
    let axes = if strongest > LOG_AXIS_RATIO * weakest {
        [
            x.logarithmic().with_range(0.1 * shallowest, 1.2 * deepest),
            y.logarithmic().with_range(0.05 * weakest, 1.5 * strongest),
        ]
    } else {
        [x.with_range(0.0, 1.06 * deepest), y.with_range(0.0, 1.08 * strongest)]
    };
    Ok(Chart::new(title(repeat, sequence), axes, series).with_branches(&["loading", "unloading"]))
}

fn loop_width(index: usize, count: usize) -> f64 {
    if count < 2 { 4.0 } else { 8.0 - 5.5 * index as f64 / (count - 1) as f64 }
}

/// At most `wanted` of the indices below `count`: all of them, or from the first to the last with equal ratios.
fn spaced_indices(count: usize, wanted: usize) -> Vec<usize> {
    if count <= wanted {
        return (0..count).collect();
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // below a million
    let at = |i: usize| (pow(count as f64, i as f64 / (wanted - 1) as f64).round() as usize).clamp(1, count) - 1;
    let mut indices: Vec<usize> = (0..wanted).map(at).collect();
    indices.dedup();
    indices
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn picked_loops_include_first_and_last() {
        assert_eq!(spaced_indices(3, 7), [0, 1, 2]);
        assert_eq!(spaced_indices(20, 7), [0, 1, 2, 3, 6, 11, 19]);
        assert_eq!(*spaced_indices(1_000_000, 300).last().unwrap(), 999_999);
    }
}
