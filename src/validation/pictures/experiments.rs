//! Pictures of the user's measured restitution against speed.

use super::{Picture, log_sampled};
use crate::plot::axis::extremes;
use crate::plot::{Axis, Chart, Series};
use crate::validation::experiments::Experiment;

pub(super) fn picture(experiment: &Experiment) -> Picture {
    let points: Vec<(f64, f64)> = experiment.rows.iter().map(|row| (row.speed, row.restitution)).collect();
    let (slowest, fastest) = extremes(points.iter().map(|point| point.0));
    let law = log_sampled(slowest / 1.5, 1.5 * fastest, 300, |speed| (speed, experiment.law_at(speed)));
    // a point of NaN separates the bars
    let bar = |e: f64, sd: f64, speed: f64| [(speed, e - sd), (speed, e + sd), (f64::NAN, f64::NAN)];
    let bars = experiment.rows.iter().filter_map(|row| Some(bar(row.restitution, row.sd?, row.speed)));
    let bars: Vec<(f64, f64)> = bars.flatten().collect();
    let mut series = vec![Series::points("measured", points)];
    if !bars.is_empty() {
        series.push(Series::bare("± standard deviation", bars).styled(0));
    }
    series.push(Series::bare("law", law).styled(1));
    let axes = [Axis::log("Impact speed", "m/s"), Axis::linear("Restitution e", "").between(0.0, 1.05)];
    let notes = (!experiment.source.is_empty()).then(|| experiment.source.clone());
    (format!("experiment-{}", experiment.name), Chart::new(&experiment.name, axes, series).with_notes(notes))
}
