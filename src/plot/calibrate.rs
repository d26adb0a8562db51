//! Pictures of a calibration: measurements with the fitted law, residuals, posterior of two keys, and a comparison of
//! laws.

use super::axis::extremes;
use super::of_key::{axis_of, title_of};
use super::style::Style;
use super::{Axis, Chart, Guide, Series, posterior};
use crate::calibrate::data::{Data, Row, Value};
use crate::calibrate::quantity::Measured;
use crate::calibrate::statistics::{LEVELS, reach};
use crate::calibrate::{Calibration, Fit, Found};
use crate::plan::free::Free;
use crate::scene::Key;
use crate::units::four_digits;

/// Largest number of points in a picture: the eye cannot separate more.
const MOST_POINTS: usize = 2000;
/// Number of pieces of a fitted line.
const PLACES: u32 = 120;
/// If the largest value is more than this multiple of the smallest, the axis is logarithmic.
const WIDE: f64 = 5.0;

/// The pictures with their names.
pub fn pictures(of: &Calibration) -> Vec<(String, Chart)> {
    let mut pictures = Vec::new();
    let has_lines = of.residuals.len() > of.keys.len();
    for what in of.fit.problem.data.measured().into_iter().filter(|_| has_lines) {
        pictures.push((format!("fit_{}", what.name()), fitted(of, what)));
    }
    if has_lines {
        pictures.push(("residuals".to_owned(), residuals(of)));
    }
    if let (Some(sheet), [first, second]) = (&of.sheet, &of.keys[..]) {
        pictures.push(("posterior".to_owned(), posterior::map(of, [first, second], sheet)));
    }
    if !of.laws.is_empty() && has_lines {
        pictures.push(("laws".to_owned(), laws(of)));
    }
    pictures
}

fn is_wide(values: impl Iterator<Item = f64>) -> bool {
    let (low, high) = extremes(values);
    low > 0.0 && high > WIDE * low
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

    /// The axis for these points of a quantity.
    fn axis(&self, what: Measured, points: &[(f64, f64)]) -> Axis {
        match self {
            Self::Key(key) => axis_of(key, is_wide(points.iter().map(|point| point.0))),
            Self::Indentation => Axis::engineering("Indentation", "m"),
            Self::Prediction => of_quantity(what, "predicted"),
        }
    }
}

/// The axis of a measured quantity.
fn of_quantity(what: Measured, how: &str) -> Axis {
    let title = format!("{} {how}", title_of(what.name()));
    Axis::engineering(title.trim_end(), what.quantity().dimension.si_unit())
}

/// The places of the values of a quantity, at most [`MOST_POINTS`] of them.
fn shown(of: &Calibration, what: Measured) -> Vec<usize> {
    let values = &of.fit.problem.data.values;
    let all: Vec<usize> = (0..values.len()).filter(|at| values[*at].what == what).collect();
    let step = all.len().div_ceil(MOST_POINTS).max(1);
    all.into_iter().step_by(step).collect()
}

fn fitted(of: &Calibration, what: Measured) -> Chart {
    let (data, over) = (of.fit.problem.data, Over::of(of.fit.problem.data));
    let shown = shown(of, what);
    let at = |value: &usize| over.at(of, *value);
    let points: Vec<(f64, f64)> = shown.iter().map(|value| (at(value), data.values[*value].value)).collect();
    let bars = shown.iter().flat_map(|value| {
        let (x, y, sd) = (at(value), data.values[*value].value, of.fit.problem.deviations[*value]);
        [(x, y - sd), (x, y + sd), (f64::NAN, f64::NAN)]
    });
    let bars = if shown.len() > 200 { Vec::new() } else { bars.collect() };
    let line = match over {
        Over::Prediction => {
            let (low, high) = extremes(points.iter().map(|point| point.0));
            vec![(low, low), (high, high)]
        }
        _ => line(of, &over, &of.fit, what, &points),
    };
    let mut series = Vec::new();
    if let Over::Key(key) = over {
        series.extend(band(of, key, what, &points).map(|band| Series::band("95 % band of the line", band).styled(5)));
    }
    series.push(Series::bare(of.fit.problem.scene.law.name(), line).styled(Style::LAW));
    series.push(Series::bare("", bars).styled(0));
    let axes = [over.axis(what, &points), of_quantity(what, "")];
    series.push(Series::points("measured, with its sd", points).styled(0));
    let notes = of.keys.iter().flat_map(|Found { free, estimate, sd, .. }| {
        let sd = sd.map_or_else(String::new, |sd| format!(", sd {}", free.say(sd, 2)));
        [title_of(free.key.path), free.say(*estimate, 4) + &sd]
    });
    let title = format!("{} and the law with the best keys", title_of(what.name()));
    Chart::new(title, axes, series).with_notes(notes)
}

type Points = Vec<(f64, f64)>;

/// What a law with its best keys predicts of a quantity.
fn line(of: &Calibration, over: &Over, fit: &Fit, what: Measured, points: &[(f64, f64)]) -> Points {
    let shares = &fit.best().shares;
    if let Over::Key(key) = over {
        let (data, at) = line_data(key, what, points);
        let predicted = fit.problem.predicting(&data).predict(shares).unwrap_or_default();
        return at.into_iter().zip(predicted).collect();
    }
    let predicted = fit.problem.predict(shares).unwrap_or_default();
    shown(of, what).into_iter().filter_map(|value| Some((over.at(of, value), *predicted.get(value)?))).collect()
}

/// The outline of the 95 % band around the fitted line over a key, which is linear in the keys.
fn band(of: &Calibration, key: &'static Key, what: Measured, points: &[(f64, f64)]) -> Option<Points> {
    let (data, at) = line_data(key, what, points);
    let (line, shares) = (of.fit.problem.predicting(&data), &of.fit.best().shares);
    let (covariance, matrix) = (of.fit.covariance.as_ref()?, line.jacobian(shares).ok()?);
    let predicted = line.predict(shares).ok()?;
    let reach = reach(LEVELS[1], of.fit.freedom());
    let half = |i: usize| reach * (matrix.row(i) * covariance).dot(&matrix.row(i)).max(0.0).sqrt();
    let edge = |side: f64| at.iter().zip(&predicted).enumerate().map(move |(i, (x, y))| (*x, y + side * half(i)));
    let upper: Points = edge(1.0).collect();
    Some(edge(-1.0).chain(upper.into_iter().rev()).collect())
}

/// Impacts along a key, from its smallest to its largest measured value, and the values of that key.
fn line_data(key: &'static Key, what: Measured, points: &[(f64, f64)]) -> (Data, Vec<f64>) {
    let values = || points.iter().map(|point| point.0);
    let (from, to) = extremes(values());
    let range = Free { key, from, to, is_logarithmic: is_wide(values()) };
    let at: Vec<f64> = (0..=PLACES).map(|i| range.at(f64::from(i) / f64::from(PLACES))).collect();
    let rows = at.iter().map(|value| Row { line: 0, keys: vec![*value], indentation: None }).collect();
    let values = (0..at.len()).map(|row| Value { row, what, value: 1.0, deviation: None }).collect();
    (Data { name: String::new(), keys: vec![key], rows, values }, at)
}

fn residuals(of: &Calibration) -> Chart {
    let data = of.fit.problem.data;
    let measured = data.measured();
    let over = match Over::of(data) {
        // predictions of several quantities have no common axis
        Over::Prediction if measured.len() > 1 => None,
        over => Some(over),
    };
    #[allow(clippy::cast_precision_loss)] // counts of measurements
    let at = |value: usize| over.as_ref().map_or(value as f64 + 1.0, |over| over.at(of, value));
    let points = |what: Measured| shown(of, what).into_iter().map(|value| (at(value), of.residuals[value])).collect();
    let series: Vec<Series> =
        measured.iter().map(|what| Series::points(title_of(what.name()), points(*what))).collect();
    let all: Points = series.iter().flat_map(|one| one.points.clone()).collect();
    let x = over.map_or_else(|| Axis::linear("Value, in the order of the file", ""), |x| x.axis(measured[0], &all));
    let level = reach(LEVELS[1], None);
    let guides = [(0.0, "law"), (level, "± 1.96"), (-level, "± 1.96")];
    let guides = guides.map(|(at, label)| Guide::horizontal(at, label)).to_vec();
    let largest = of.residuals.iter().map(|residual| residual.abs()).fold(3.0, f64::max);
    let y =
        Axis::linear("Measured less predicted, over the standard deviation", "").between(-1.1 * largest, 1.1 * largest);
    let notes = [("chi-square", of.p), ("runs of signs", of.runs.map(|runs| runs.p))];
    let notes = notes.into_iter().filter_map(|(test, p)| Some(format!("{test}: p = {}", four_digits(p?))));
    Chart::new("Residuals", [x, y], series).with_guides(guides).with_notes(notes)
}

/// The predictions of every law with its best keys, with the measurements of the first quantity.
fn laws(of: &Calibration) -> Chart {
    let (data, over) = (of.fit.problem.data, Over::of(of.fit.problem.data));
    let what = data.values[0].what;
    let points: Points =
        shown(of, what).into_iter().map(|value| (over.at(of, value), data.values[value].value)).collect();
    let fits = of.laws.iter().filter_map(|(name, fit)| Some((name, fit.as_ref().ok()?)));
    let least = of.least_aic();
    let lines = fits.map(|(name, fit)| {
        Series::line(format!("{name}  +{:.1}", fit.aic - least), line(of, &over, fit, what, &points))
    });
    let mut series: Vec<Series> = lines.collect();
    let axes = [over.axis(what, &points), of_quantity(what, "")];
    series.push(Series::points("measured", points).styled(Style::BLACK));
    Chart::new("Laws with their best keys, and how far their AIC is above the least", axes, series)
}
