//! Pictures of a calibration: measurements with the fitted law, residuals, posterior, and a comparison of laws.

use super::of_key::{axis_of, title_of};
use super::style::{BLACK, LAW};
use super::{Axis, Canvas, Guide, Lines, PlotError, Series, posterior};
use crate::calibrate::data::{Data, Row, Value};
use crate::calibrate::problem::Problem;
use crate::calibrate::quantity::MEASURED;
use crate::calibrate::statistics::{LEVELS, reach};
use crate::calibrate::{Calibration, Fit, Found};
use crate::plan::free::Free;
use crate::scene::Key;
use crate::units::human;

/// Largest number of points in a picture: the eye cannot separate more.
const MOST_POINTS: usize = 2000;
/// Number of pieces of a fitted line.
const PLACES: u32 = 120;
/// If the largest value is more than this multiple of the smallest, the axis is logarithmic.
const WIDE: f64 = 5.0;

/// The pictures with their names.
///
/// # Errors
/// [`PlotError`].
pub fn pictures(of: &Calibration) -> Result<Vec<(String, Canvas)>, PlotError> {
    let mut pictures = Vec::new();
    let has_lines = of.residuals.len() > of.keys.len();
    for what in of.fit.problem.data.measured().into_iter().filter(|_| has_lines) {
        pictures.push((format!("fit_{}", MEASURED[what].name), fitted(of, what)?));
    }
    if has_lines {
        pictures.push(("residuals".to_owned(), residuals(of)?));
    }
    if let Some(sheet) = &of.sheet {
        pictures.push(("posterior".to_owned(), posterior::map(of, sheet)?));
    } else if let Some(found) = of.keys.first().filter(|found| found.posterior.is_some()) {
        pictures.push(("posterior".to_owned(), density(found, of.refusal.is_some())?));
    }
    if !of.laws.is_empty() && has_lines {
        pictures.push(("laws".to_owned(), laws(of)?));
    }
    Ok(pictures)
}

fn is_wide(values: impl Iterator<Item = f64> + Clone) -> bool {
    let low = values.clone().fold(f64::INFINITY, f64::min);
    low > 0.0 && values.fold(0.0, f64::max) > WIDE * low
}

/// The quantity on the horizontal axis: the only key that changes, the indentation of a curve, or the prediction.
enum Over {
    Key(&'static Key),
    Indentation,
    Prediction,
}

impl Over {
    fn of(data: &Data) -> Self {
        match data.keys[..] {
            _ if data.is_curve() => Self::Indentation,
            [key] => Self::Key(key),
            _ => Self::Prediction,
        }
    }

    fn at(&self, of: &Calibration, value: usize) -> f64 {
        let row = &of.fit.problem.data.rows[of.fit.problem.data.values[value].row];
        match self {
            Self::Key(_) => row.keys[0],
            Self::Indentation => row.indentation.unwrap_or(0.0),
            Self::Prediction => of.predicted[value],
        }
    }

    fn axis(&self, what: usize, values: impl Iterator<Item = f64> + Clone) -> Axis {
        match self {
            Self::Key(key) => axis_of(key, is_wide(values)),
            Self::Indentation => Axis::engineering("Indentation", "m"),
            Self::Prediction => of_quantity(what, "predicted"),
        }
    }
}

/// The axis of a measured quantity.
fn of_quantity(what: usize, how: &str) -> Axis {
    let title = format!("{} {how}", title_of(MEASURED[what].name));
    Axis::engineering(title.trim_end(), MEASURED[what].quantity.dimension.si_unit())
}

/// The places of the values of a quantity, at most [`MOST_POINTS`] of them.
fn shown(of: &Calibration, what: usize) -> Vec<usize> {
    let values = &of.fit.problem.data.values;
    let all: Vec<usize> = (0..values.len()).filter(|at| values[*at].what == what).collect();
    let step = all.len().div_ceil(MOST_POINTS).max(1);
    all.into_iter().step_by(step).collect()
}

fn fitted(of: &Calibration, what: usize) -> Result<Canvas, PlotError> {
    let (data, over) = (of.fit.problem.data, Over::of(of.fit.problem.data));
    let shown = shown(of, what);
    let at = |value: &usize| over.at(of, *value);
    let points: Vec<(f64, f64)> = shown.iter().map(|value| (at(value), data.values[*value].value)).collect();
    let bars = shown.iter().flat_map(|value| {
        let (x, y, sd) = (at(value), data.values[*value].value, of.fit.problem.deviations[*value]);
        [(x, y - sd), (x, y + sd), (f64::NAN, f64::NAN)]
    });
    let bars = if shown.len() > 200 { Vec::new() } else { bars.collect() };
    let (line, band) = match over {
        Over::Key(key) => along(of, key, what, &points),
        Over::Indentation => {
            let line = shown.iter().map(|value| (at(value), of.predicted[*value])).collect();
            (line, Vec::new())
        }
        Over::Prediction => {
            let ends = points.iter().map(|point| point.0);
            let ends = [ends.clone().fold(f64::INFINITY, f64::min), ends.fold(0.0, f64::max)];
            (ends.map(|end| (end, end)).to_vec(), Vec::new())
        }
    };
    let mut series = Vec::new();
    if !band.is_empty() {
        series.push(Series::band("95 % of the law", band).styled(5));
    }
    series.push(Series::bare(of.fit.problem.scene.law.name(), line).styled(LAW));
    series.push(Series::bare("", bars).styled(0));
    series.push(Series::points("measured, with its sd", points.clone()).styled(0));
    let notes = of.keys.iter().flat_map(|found| {
        let two_digits = |sd: f64| say(format!("{sd:.1e}").parse().unwrap_or(sd), &found.free);
        let sd = found.sd.map_or_else(String::new, |sd| format!(", sd {}", two_digits(sd)));
        [title_of(found.free.key.path), say(found.estimate, &found.free) + &sd]
    });
    let x = over.axis(what, points.iter().map(|point| point.0));
    let title = format!("{} and the law with the best keys", title_of(MEASURED[what].name));
    Lines { title, x, y: of_quantity(what, ""), series, guides: Vec::new(), notes: notes.collect() }.draw()
}

/// Points of a line.
type Points = Vec<(f64, f64)>;

/// The fitted line over a key, and the outline of its 95 % band, which is linear in the keys.
fn along(of: &Calibration, key: &'static Key, what: usize, points: &[(f64, f64)]) -> (Points, Points) {
    let problem = &of.fit.problem;
    let (data, at) = line_data(key, what, points);
    let ones = vec![1.0; data.values.len()];
    let line = Problem::new(&problem.scene, problem.free, &data, ones, false);
    let shares = &of.fit.minima[0].shares;
    let Ok(predicted) = line.predict(shares) else { return Default::default() };
    let points: Vec<(f64, f64)> = at.iter().copied().zip(predicted.iter().copied()).collect();
    let (Some(covariance), Ok(columns)) = (&of.covariance, line.jacobian(shares)) else { return (points, Vec::new()) };
    let reach = reach(LEVELS[1], of.fit.freedom);
    let half = |i: usize| {
        let sum = |key: usize| covariance[key].iter().zip(&columns).map(|(part, column)| part * column[i]).sum::<f64>();
        reach * (0..columns.len()).map(|key| columns[key][i] * sum(key)).sum::<f64>().max(0.0).sqrt()
    };
    let edge = |side: f64| at.iter().zip(&predicted).enumerate().map(move |(i, (x, y))| (*x, y + side * half(i)));
    let upper: Vec<(f64, f64)> = edge(1.0).collect();
    let band = edge(-1.0).chain(upper.into_iter().rev()).collect();
    (points, band)
}

/// Impacts along a key, from its smallest to its largest measured value, and the values of that key.
fn line_data(key: &'static Key, what: usize, points: &[(f64, f64)]) -> (Data, Vec<f64>) {
    let ends = || points.iter().map(|point| point.0);
    let (from, to) = (ends().fold(f64::INFINITY, f64::min), ends().fold(0.0, f64::max));
    let range = Free { key, from, to, is_logarithmic: is_wide(ends()) };
    let at: Vec<f64> = (0..=PLACES).map(|i| range.at(f64::from(i) / f64::from(PLACES))).collect();
    let rows = at.iter().map(|value| Row { line: 0, keys: vec![*value], indentation: None }).collect();
    let values = (0..at.len()).map(|row| Value { row, what, value: 1.0, deviation: None }).collect();
    (Data { name: String::new(), keys: vec![key], rows, values }, at)
}

fn residuals(of: &Calibration) -> Result<Canvas, PlotError> {
    let data = of.fit.problem.data;
    let measured = data.measured();
    let over = match Over::of(data) {
        // predictions of several quantities have no common axis
        Over::Prediction if measured.len() > 1 => None,
        over => Some(over),
    };
    #[allow(clippy::cast_precision_loss)] // counts of measurements
    let at = |value: &usize| over.as_ref().map_or(*value as f64 + 1.0, |over| over.at(of, *value));
    let series: Vec<Series> = measured
        .iter()
        .map(|what| {
            let points = shown(of, *what).iter().map(|value| (at(value), of.residuals[*value])).collect();
            Series::points(title_of(MEASURED[*what].name), points)
        })
        .collect();
    let xs = series.iter().flat_map(|one| &one.points).map(|point| point.0);
    let x = over.map_or_else(|| Axis::linear("Value, in the order of the file", ""), |over| over.axis(measured[0], xs));
    let level = reach(LEVELS[1], None);
    let guides = [(0.0, "law"), (level, "± 1.96"), (-level, "± 1.96")];
    let guides = guides.map(|(at, label)| Guide::Horizontal { at, label: label.to_owned() }).to_vec();
    let largest = of.residuals.iter().map(|residual| residual.abs()).fold(3.0, f64::max);
    let y =
        Axis::linear("Measured less predicted, over the standard deviation", "").between(-1.1 * largest, 1.1 * largest);
    let notes = of.p_of_runs.map(|p| format!("runs of signs: p = {}", crate::units::four_digits(p)));
    let p = of.p.map(|p| format!("chi-square: p = {}", crate::units::four_digits(p)));
    Lines { title: "Residuals".to_owned(), x, y, series, guides, notes: p.into_iter().chain(notes).collect() }.draw()
}

/// The posterior of one key.
fn density(found: &Found, is_refused: bool) -> Result<Canvas, PlotError> {
    let marginal = found.posterior.clone().unwrap_or_default();
    let highest = marginal.density.iter().copied().fold(0.0, f64::max);
    let points: Vec<(f64, f64)> = marginal
        .shares
        .iter()
        .zip(&marginal.density)
        .map(|(share, density)| (found.free.at(*share), density / highest))
        .collect();
    let is_wide = is_wide(points.iter().map(|point| point.0)) && found.free.is_logarithmic;
    let vertical =
        |at: f64, label: &str, color: usize| Guide::Vertical { at, label: label.to_owned(), series: Some(color) };
    let mut guides = vec![vertical(found.estimate, "best", 6)];
    for (ends, (name, color)) in found.intervals.iter().flatten().zip([("68 %", 1), ("95 %", 3)]) {
        guides.extend(ends.iter().flatten().map(|end| vertical(*end, &format!("{name} interval"), color)));
    }
    let median = format!("median {}", say(found.free.at(marginal.quantile(0.5)), &found.free));
    let notes = if is_refused { vec!["no interval: see the summary".to_owned()] } else { vec![median] };
    let series = vec![Series::bare("posterior", points)];
    let title = format!("{}: what the measurements say", title_of(found.free.key.path));
    let y = Axis::linear("Posterior density, highest = 1", "").between(0.0, 1.05);
    Lines { title, x: axis_of(found.free.key, is_wide), y, series, guides, notes }.draw()
}

/// The predictions of every law with its best keys, with the measurements of the first quantity.
fn laws(of: &Calibration) -> Result<Canvas, PlotError> {
    let (data, over) = (of.fit.problem.data, Over::of(of.fit.problem.data));
    let what = data.values[0].what;
    let shown = shown(of, what);
    let points: Vec<(f64, f64)> = shown.iter().map(|value| (over.at(of, *value), data.values[*value].value)).collect();
    let fits: Vec<(&String, &Fit)> =
        of.laws.iter().filter_map(|(name, fit)| Some((name, fit.as_ref().ok()?))).collect();
    let least = fits.first().map_or(0.0, |(_, fit)| fit.aic);
    let line = |fit: &Fit| -> Vec<(f64, f64)> {
        let shares = &fit.minima[0].shares;
        if let Over::Key(key) = over {
            let (data, at) = line_data(key, what, &points);
            let line = Problem::new(&fit.problem.scene, fit.problem.free, &data, vec![1.0; at.len()], false);
            return line
                .predict(shares)
                .map_or_else(|_| Vec::new(), |predicted| at.into_iter().zip(predicted).collect());
        }
        let predicted = fit.problem.predict(shares).unwrap_or_default();
        shown.iter().filter_map(|value| Some((over.at(of, *value), *predicted.get(*value)?))).collect()
    };
    let lines = fits.iter().map(|(name, fit)| Series::line(format!("{name}  +{:.1}", fit.aic - least), line(fit)));
    let mut series: Vec<Series> = lines.collect();
    series.push(Series::points("measured", points.clone()).styled(BLACK));
    let x = over.axis(what, points.iter().map(|point| point.0));
    let title = "Laws with their best keys, and how far their AIC is above the least".to_owned();
    Lines { title, x, y: of_quantity(what, ""), series, guides: Vec::new(), notes: Vec::new() }.draw()
}

/// A value with four digits, in a fitting unit.
fn say(value: f64, of: &Free) -> String {
    human(format!("{value:.3e}").parse().unwrap_or(value), of.key.quantity.dimension)
}
