//! Pictures of a ball that hops along a surface: its path from the side, and from above if the path turns.

use super::series::{FLIGHT_POINTS, flight_points, title};
use crate::impact::flight::trajectory::Flight;
use crate::impact::series::{ImpactSeries, SeriesImpact, SeriesResult};
use crate::report::chart::{Axis, Chart, FOREGROUND, Series, Style, min_max};

/// Width over height of the box of a picture, nearly.
const BOX_ASPECT: f64 = 2.0;
/// Free share of the box around the path.
const MARGIN: f64 = 0.06;

/// The height of the lowest point over the position along the first path. `None` for a ball without an angle, a spin or a flight.
pub fn path_chart(repeat: &ImpactSeries, sequence: &SeriesResult) -> Option<Chart> {
    let flights: Vec<&Flight> = sequence.impacts.iter().filter_map(|hit| hit.flight.as_ref()).collect();
    sequence.impacts.first()?.tangential().filter(|_| !flights.is_empty())?;
    let points =
        flights.iter().flat_map(|flight| flight_points(flight, FLIGHT_POINTS, |time| flight.position_at(time)[0]));
    let hits = sequence.impacts.iter().map(|hit| (hit.position[0], 0.0)).collect();
    let series = vec![Series::line("Lowest point of the sphere", points.collect()), Series::points("Impacts", hits)];
    let axes = [Axis::linear("Place along the surface", "m"), Axis::linear("Height", "m")];
    Some(Chart::new(title(repeat, sequence), axes, series))
}

/// The path along the surface, seen from above, with nearly the same scale on both axes. `None` without a spin about the path or the
/// normal, and without a flight.
pub fn path_from_above_chart(repeat: &ImpactSeries, sequence: &SeriesResult) -> Option<Chart> {
    sequence.impacts.first()?.cross_motion()?;
    let flights = sequence.impacts.iter().filter_map(|hit| hit.flight);
    let to_point = |[x, y]: [f64; 2]| (x, y);
    // a flight is a straight line from above
    let path: Vec<(f64, f64)> =
        flights.flat_map(|flight| [0.0, flight.duration].map(|time| to_point(flight.position_at(time)))).collect();
    let hits: Vec<(f64, f64)> = sequence.impacts.iter().map(|hit: &SeriesImpact| to_point(hit.position)).collect();
    if path.is_empty() {
        return None;
    }
    let all = || path.iter().chain(&hits);
    let (x, y) = (min_max(all().map(|at| at.0)), min_max(all().map(|at| at.1)));
    let height = (y.1 - y.0).max((x.1 - x.0) / BOX_ASPECT) * (1.0 + 2.0 * MARGIN);
    let range = |(low, high): (f64, f64), length: f64| (0.5 * (low + high - length), 0.5 * (low + high + length));
    let (x, y) = (range(x, BOX_ASPECT * height), range(y, height));
    let axes = [
        Axis::linear("Distance along the first path", "m").with_range(x.0, x.1),
        Axis::linear("Distance to the left", "m").with_range(y.0, y.1),
    ];
    let series = vec![Series::line("Path from above", path), Series::points("Impacts", hits)];
    let first_path = Series::horizontal(0.0, "").with_style(Style::line(FOREGROUND, 1.5));
    Some(Chart::new(title(repeat, sequence), axes, series).with_guides([first_path]))
}
