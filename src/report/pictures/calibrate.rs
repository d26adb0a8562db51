//! Pictures of a calibration: measurements with the fitted law, residuals, posterior of two keys, and a comparison of
//! laws.

use super::{caption, key_axis, law_title, path_title, posterior, with_captions};
use crate::calibrate::data::{MeasuredValue, MeasurementData, MeasurementRow};
use crate::calibrate::statistics::{LEVELS, half_width};
use crate::calibrate::{Calibration, Fit, KeyEstimate, Noise};
use crate::report::chart::{Axis, AxisScale, Chart, GREY, MARKER_RADIUS, Series, Style, min_max};
use crate::scenario::input::{MeasuredQuantity, NumericKey};
use crate::scenario::plan::FreeKey;
use crate::units::format_four_digits;

/// Largest number of points in a picture: the eye cannot separate more.
const MAX_POINTS: usize = 2000;
/// Largest number of points with error bars.
const MAX_ERROR_BARS: usize = 200;
/// Number of pieces of a fitted line.
const LINE_PIECES: u32 = 120;
/// Height of the box of a wide picture, and the least height of a band that is seen beside its line \[px\].
const BOX_HEIGHT: f64 = 750.0;
const BAND_HEIGHT: f64 = 8.0;
/// Length of error bars beyond their marker that are seen, both ends together \[px\].
const BAR_ENDS: f64 = 14.0;
/// If the largest value is more than this multiple of the smallest, the axis is logarithmic.
const LOG_AXIS_RATIO: f64 = 5.0;

type DataPoints = Vec<(f64, f64)>;

/// The pictures with their names.
pub fn pictures(calibration: &Calibration) -> Vec<(String, Chart)> {
    let mut pictures = Vec::new();
    let data = calibration.fit.problem.data;
    let has_lines = calibration.residuals.len() > calibration.keys.len();
    for quantity in data.measured_quantities().into_iter().filter(|_| has_lines) {
        pictures.push((format!("fit_{}", quantity.name()), FittedQuantity::new(calibration, quantity).fit_chart()));
    }
    if has_lines {
        pictures.push(("residuals".to_owned(), residual_chart(calibration)));
    }
    if let [first, second] = &calibration.keys[..] {
        let map =
            posterior::posterior_chart(calibration, [first, second]).filter(|_| !calibration.fit.is_noise_unknown());
        pictures.extend(map.map(|chart| ("posterior".to_owned(), chart)));
    }
    if !calibration.laws.is_empty() && has_lines {
        pictures.push(("laws".to_owned(), FittedQuantity::new(calibration, data.values[0].quantity).law_chart()));
    }
    let sought = calibration.keys.iter().map(|key| key.free.key.path());
    let varied: Vec<&str> = sought.chain(data.keys.iter().map(|key| key.path())).collect();
    with_captions(pictures, &caption(&calibration.fit.problem.input, &varied))
}

fn needs_log_axis(points: &[(f64, f64)]) -> bool {
    let (low, high) = min_max(points.iter().map(|point| point.0));
    low > 0.0 && high > LOG_AXIS_RATIO * low
}

/// The quantity on the horizontal axis: the only key that changes, the indentation of a curve, or the prediction.
enum Abscissa {
    Key(NumericKey),
    Indentation,
    Prediction,
}

impl Abscissa {
    fn new(data: &MeasurementData) -> Self {
        match data.keys[..] {
            _ if data.is_curve() => Self::Indentation,
            // speeds that follow from intervals are not in the data
            [key] if data.rows.iter().all(|row| row.preceding_interval.is_none()) => Self::Key(key),
            _ => Self::Prediction,
        }
    }

    fn coordinate(&self, calibration: &Calibration, value: usize) -> f64 {
        let row = &calibration.fit.problem.data.rows[calibration.fit.problem.data.values[value].row];
        match self {
            Self::Key(key) => key.quantity().picture_unit().1(row.keys[0]),
            Self::Indentation => row.indentation.unwrap_or(0.0),
            Self::Prediction => calibration.predicted[value],
        }
    }

    fn axis(&self, quantity: MeasuredQuantity, points: &[(f64, f64)]) -> Axis {
        match self {
            Self::Key(key) => key_axis(*key, needs_log_axis(points)),
            Self::Indentation => Axis::linear("Indentation", "m"),
            Self::Prediction => quantity_axis(quantity, " predicted"),
        }
    }
}

fn quantity_axis(quantity: MeasuredQuantity, how: &str) -> Axis {
    Axis::linear(&(path_title(quantity.name()) + how), quantity.quantity().dimension.si_unit())
}

/// The places of the values of a quantity, at most [`MAX_POINTS`] of them.
fn sampled_indices(calibration: &Calibration, quantity: MeasuredQuantity) -> Vec<usize> {
    let values = &calibration.fit.problem.data.values;
    let all: Vec<usize> = (0..values.len()).filter(|at| values[*at].quantity == quantity).collect();
    let step = all.len().div_ceil(MAX_POINTS).max(1);
    all.into_iter().step_by(step).collect()
}

/// The values of a quantity over the quantity on the horizontal axis.
struct FittedQuantity<'a> {
    calibration: &'a Calibration<'a>,
    quantity: MeasuredQuantity,
    abscissa: Abscissa,
    sampled: Vec<usize>,
    points: DataPoints,
    axes: [Axis; 2],
}

impl<'a> FittedQuantity<'a> {
    fn new(calibration: &'a Calibration, quantity: MeasuredQuantity) -> Self {
        let data = calibration.fit.problem.data;
        let (abscissa, sampled) = (Abscissa::new(data), sampled_indices(calibration, quantity));
        let points: DataPoints =
            sampled.iter().map(|value| (abscissa.coordinate(calibration, *value), data.values[*value].value)).collect();
        let [x, y] = [abscissa.axis(quantity, &points), quantity_axis(quantity, "")];
        // small values stay visible where both quantities go over decades
        let is_logarithmic =
            x.scale == AxisScale::Log && needs_log_axis(&points.iter().map(|(x, y)| (*y, *x)).collect::<DataPoints>());
        let axes = with_one_prefix([x, if is_logarithmic { y.logarithmic() } else { y }], &points);
        Self { calibration, quantity, abscissa, sampled, points, axes }
    }

    fn fit_chart(self) -> Chart {
        let Self { calibration, quantity, sampled: shown, points, .. } = &self;
        let has_bars = shown.len() <= MAX_ERROR_BARS && !calibration.fit.is_noise_unknown();
        let bars = || {
            let deviation = |value: usize| calibration.fit.problem.deviations[value];
            shown.iter().zip(points).filter(|_| has_bars).map(move |(value, (x, y))| (*x, *y, deviation(*value)))
        };
        let line = if let Abscissa::Prediction = self.abscissa {
            let (low, high) = min_max(points.iter().map(|point| point.0));
            vec![(low, low), (high, high)]
        } else {
            self.fit_line(&calibration.fit)
        };
        let band = self.confidence_band().filter(|band| {
            // its outline goes along one side and comes back along the other
            let sides = band.iter().zip(band.iter().rev()).map(|(one, other)| [one.1, other.1]);
            self.height(sides) > BAND_HEIGHT
        });
        let mut series: Vec<Series> =
            band.map(|band| Series::band("95 % band of the line", band).with_style(5)).into_iter().collect();
        let law = law_title(&calibration.fit.problem.input.named_law.name());
        series.push(Series::line(law, line).with_style(Style::LAW));
        series.push(Series::error_bars(bars()).with_style(0));
        let are_bars_seen = self.height(bars().map(|(_, y, sd)| [y - sd, y + sd])) > 2.0 * MARKER_RADIUS + BAR_ENDS;
        let measured = match calibration.fit.noise {
            _ if !are_bars_seen => "measured",
            Noise::Given => "measured, with its standard deviation",
            Noise::Estimated { .. } => "measured, with the estimated standard deviation",
            Noise::TooFew | Noise::NoScatter => "measured",
        };
        let mut measured = Series::points(measured, points.clone()).with_style(0);
        if has_bars && !are_bars_seen {
            measured.legend_texts.push("standard deviation below the size of the marker".to_owned());
        }
        series.push(measured);
        let notes = calibration.keys.iter().flat_map(|KeyEstimate { free, estimate, sd, .. }| {
            let sd = sd.map_or_else(String::new, |sd| format!(", standard deviation {}", free.format_value(sd, 2)));
            [path_title(free.key.path()), free.format_value(*estimate, 4) + &sd]
        });
        let title = format!("{} and the fitted law", path_title(quantity.name()));
        Chart::new(title, self.axes.clone(), series).with_notes(notes)
    }

    /// The largest distance of these pairs of values on the vertical axis \[px\].
    fn height(&self, pairs: impl Iterator<Item = [f64; 2]>) -> f64 {
        let axis = self.axes[1].fit(self.points.iter().map(|point| point.1));
        let distance = |[one, other]: [f64; 2]| BOX_HEIGHT * (axis.position(one) - axis.position(other)).abs();
        pairs.map(distance).filter(|distance| !distance.is_nan()).fold(0.0, f64::max)
    }

    /// The predictions of every law with its best keys, with the measurements.
    fn law_chart(self) -> Chart {
        let fits = self.calibration.laws.iter().filter_map(|(name, fit)| Some((name, fit.as_ref().ok()?)));
        let named =
            |name: &str, fit: &Fit| format!("{}  +{:.1}", law_title(name), fit.aic - self.calibration.min_aic());
        let mut series: Vec<Series> =
            fits.map(|(name, fit)| Series::line(named(name, fit), self.fit_line(fit))).collect();
        series.push(Series::points("measured", self.points).with_style(Style::BLACK));
        Chart::new("Laws with their best keys, and how far their AIC is above the least", self.axes, series)
    }

    /// The predictions of a law with its best keys.
    fn fit_line(&self, fit: &Fit) -> DataPoints {
        let shares = &fit.best().shares;
        let along = match self.abscissa {
            Abscissa::Key(key) => Some(self.impacts_along(key)),
            Abscissa::Indentation => Some(self.refined_curve()),
            Abscissa::Prediction => None,
        };
        if let Some((data, at)) = along {
            let predicted = fit.problem.for_prediction(&data).predict(shares).unwrap_or_default();
            return at.into_iter().zip(predicted).collect();
        }
        let predicted = fit.problem.predict(shares).unwrap_or_default();
        self.sampled
            .iter()
            .zip(&self.points)
            .filter_map(|(value, (x, _))| Some((*x, *predicted.get(*value)?)))
            .collect()
    }

    /// The outline of the 95 % band around the fitted line over a key, which is linear in the keys.
    fn confidence_band(&self) -> Option<DataPoints> {
        let Abscissa::Key(key) = self.abscissa else { return None };
        let (data, at) = self.impacts_along(key);
        let fit = &self.calibration.fit;
        let (line, shares) = (fit.problem.for_prediction(&data), &fit.best().shares);
        let (covariance, matrix) = (fit.covariance.as_ref()?, line.jacobian(shares).ok()?);
        let predicted = line.predict(shares).ok()?;
        let reach = half_width(LEVELS[1], fit.degrees_of_freedom());
        let half = |i: usize| reach * (matrix.row(i) * covariance).dot(&matrix.row(i)).max(0.0).sqrt();
        let edge = |side: f64| at.iter().zip(&predicted).enumerate().map(move |(i, (x, y))| (*x, y + side * half(i)));
        let upper: DataPoints = edge(1.0).collect();
        Some(edge(-1.0).chain(upper.into_iter().rev()).collect())
    }

    /// The points of an indentation curve with more points between them, and their indentations.
    fn refined_curve(&self) -> (MeasurementData, Vec<f64>) {
        let points: Vec<f64> =
            self.calibration.fit.problem.data.rows.iter().filter_map(|row| row.indentation).collect();
        let steps = LINE_PIECES.div_ceil(u32::try_from(points.len()).unwrap_or(LINE_PIECES)).max(1);
        let between = |pair: &[f64]| {
            let (from, to) = (pair[0], pair[1]);
            (1..=steps).map(move |i| from + (to - from) * f64::from(i) / f64::from(steps))
        };
        let at: Vec<f64> = points.first().copied().into_iter().chain(points.windows(2).flat_map(between)).collect();
        let rows = at.iter().map(|at| MeasurementRow { indentation: Some(*at), ..MeasurementRow::default() }).collect();
        (MeasurementData { name: String::new(), keys: Vec::new(), rows, values: self.unit_values(at.len()) }, at)
    }

    /// Values to predict, one in every row.
    fn unit_values(&self, rows: usize) -> Vec<MeasuredValue> {
        (0..rows).map(|row| MeasuredValue { row, quantity: self.quantity, value: 1.0, deviation: None }).collect()
    }

    /// Impacts along a key, from its smallest to its largest measured value, and the values of that key.
    fn impacts_along(&self, key: NumericKey) -> (MeasurementData, Vec<f64>) {
        let data = self.calibration.fit.problem.data;
        let (from, to) = min_max(self.sampled.iter().map(|value| data.rows[data.values[*value].row].keys[0]));
        let range = FreeKey { key, from, to, is_logarithmic: needs_log_axis(&self.points), hardness: None };
        let at: Vec<f64> =
            (0..=LINE_PIECES).map(|i| range.value_at_share(f64::from(i) / f64::from(LINE_PIECES))).collect();
        let rows = at.iter().map(|value| MeasurementRow { keys: vec![*value], ..MeasurementRow::default() }).collect();
        let data = MeasurementData { name: String::new(), keys: vec![key], rows, values: self.unit_values(at.len()) };
        (data, at.into_iter().map(key.quantity().picture_unit().1).collect())
    }
}

/// These axes with the same prefix, if they have the same unit: that of the largest value, or, on logarithmic axes, that which
/// an axis with the values of both would have.
fn with_one_prefix([x, y]: [Axis; 2], points: &[(f64, f64)]) -> [Axis; 2] {
    if x.unit != y.unit {
        return [x, y];
    }
    let (low, high) = min_max(points.iter().flat_map(|(x, y)| [x.abs(), y.abs()]).filter(|size| *size > 0.0));
    let size = match x.scale {
        AxisScale::Log if low <= 1.0 && high >= 1.0 => 1.0,
        AxisScale::Log if low < high => low.sqrt() * high.sqrt(),
        _ => high,
    };
    [x, y].map(|axis| axis.with_prefix_of(size))
}

fn residual_chart(calibration: &Calibration) -> Chart {
    let data = calibration.fit.problem.data;
    let measured = data.measured_quantities();
    // predictions of several quantities have no common axis
    let abscissa =
        Some(Abscissa::new(data)).filter(|abscissa| !matches!(abscissa, Abscissa::Prediction) || measured.len() == 1);
    let at =
        |value: usize| abscissa.as_ref().map_or(value as f64 + 1.0, |abscissa| abscissa.coordinate(calibration, value));
    let points = |quantity: MeasuredQuantity| {
        sampled_indices(calibration, quantity)
            .into_iter()
            .map(|value| (at(value), calibration.residuals[value]))
            .collect()
    };
    let series: Vec<Series> =
        measured.iter().map(|quantity| Series::points(path_title(quantity.name()), points(*quantity))).collect();
    let all: DataPoints = series.iter().flat_map(|one| one.points.clone()).collect();
    let x = abscissa.map_or_else(|| Axis::linear("Value, in the order of the file", ""), |x| x.axis(measured[0], &all));
    let level = half_width(LEVELS[1], None);
    let guides = [(0.0, "law"), (level, "± 1.96"), (-level, "± 1.96")];
    let largest = calibration.residuals.iter().map(|residual| residual.abs()).fold(3.0, f64::max);
    let y = Axis::linear("Measured less predicted, over the standard deviation", "")
        .with_range(-1.1 * largest, 1.1 * largest);
    let notes = [("chi-square", calibration.p), ("runs of signs", calibration.runs.map(|runs| runs.p))];
    let notes = notes.into_iter().filter_map(|(test, p)| Some(format!("{test}: p = {}", format_four_digits(p?))));
    let chart = Chart::new("Residuals", [x, y], series);
    let guide = |(at, label): (f64, &str)| {
        let guide = Series::horizontal(at, label);
        if at == 0.0 { guide.with_style(Style::line(GREY, 2.0)) } else { guide }
    };
    chart.with_guides(guides.map(guide)).with_notes(notes)
}
