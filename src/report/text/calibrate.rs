//! Texts about a calibration: `summary.json`, `residuals.csv` and the blocks for people.

use serde_json::{Map, Value, json};

use super::blocks::Block;
use super::files::into_bytes;
use super::inputs::{Inputs, constraint_factor_name};
use crate::calibrate::minimise::ParameterPoint;
use crate::calibrate::profile::IntervalEnds;
use crate::calibrate::{Calibration, CalibrationTask, KeyEstimate, LawFit, Noise};
use crate::error::Error;
use crate::results::{ResultSpec, result_specs, to_fields};
use crate::scenario::input::{Body, MeasuredQuantity};
use crate::scenario::keys::body_key;
use crate::units::{format_four_digits, format_percent};

/// The note on an interval with an end outside of the range of the key.
const UNBOUNDED: &str = "open interval";

/// An interval in SI. An end that the data do not bound is `null`.
fn interval_json(ends: IntervalEnds) -> Value {
    let note = ends.iter().any(Option::is_none).then_some(UNBOUNDED);
    json!({ "low": ends[0], "high": ends[1], "note": note })
}

/// `yield_strength x youngs_modulus^-0.8`.
fn combination_text(calibration: &Calibration, exponents: &[f64]) -> String {
    let factors = calibration.keys.iter().zip(exponents).map(|(key, exponent)| match *exponent {
        1.0 => key.free.key.path().to_owned(),
        exponent => format!("{}^{exponent:.2}", key.free.key.path()),
    });
    factors.collect::<Vec<_>>().join(" x ")
}

/// Tells in words how the noise is found, with the share of every value if it is estimated.
fn noise(calibration: &Calibration) -> (&'static str, Option<f64>) {
    match calibration.fit.noise {
        Noise::Estimated { share, .. } => ("estimated from the residuals", share),
        Noise::TooFew | Noise::NoScatter => ("unknown", None),
        Noise::Given => ("given", None),
    }
}

/// A calibration and its request.
pub struct CalibrationReport<'a> {
    measured: &'a CalibrationTask,
    calibration: &'a Calibration<'a>,
}

/// The results of a calibration, in the order of `summary.json`.
pub fn calibration_results<'a>() -> Vec<ResultSpec<CalibrationReport<'a>>> {
    result_specs! { |one: CalibrationReport<'a>|
        /// The result for each key, see below.
        "keys": (0..one.calibration.keys.len()).map(|i| json!(to_fields(&key_results(), &KeyResult { number: i, calibration: one.calibration }))).collect::<Vec<_>>();
        /// Reason why no interval is given; `null` if there is one.
        "refusal": one.calibration.reason_without_intervals.clone();
        /// Correlation of the two keys.
        "correlation": one.calibration.correlation().filter(|_| one.calibration.reason_without_intervals.is_none());
        /// `true` if the law fits, `null` if these measurements cannot tell.
        "fits": one.calibration.verdict().is_compatible();
        /// Reason for the rejection of the law.
        "contradiction": one.calibration.verdict().contradiction_reason();
        /// Reason why the fit of the law cannot be judged, although the misfit is large.
        "undecided": one.calibration.verdict().undecided_reason();
        /// Measured values.
        "values": one.calibration.residuals.len();
        /// Degrees of freedom: values without outliers, minus the number of keys.
        "degrees_of_freedom": one.calibration.degrees_of_freedom;
        /// Sum of squares of the residuals over their standard deviations, without outliers.
        "chi_square": one.calibration.chi_square;
        /// Chi-square over the degrees of freedom: about 1 if the law fits.
        "chi_square_per_degree_of_freedom": chi_square_per_degree(one.calibration);
        /// Relative rms misfit of the worst-fitting quantity.
        "misfit": one.calibration.misfit;
        /// p-value of chi-square, for a given noise.
        "p": one.calibration.p;
        /// p-value of the runs test of the signs of the residuals, ordered by speed.
        "p_of_runs": one.calibration.runs.map(|runs| runs.p);
        /// `given`, `estimated from the residuals`, or `unknown`.
        "noise": noise(one.calibration).0;
        /// Estimated relative standard deviation of every value.
        "estimated_noise": noise(one.calibration).1;
        /// Assumed relative model error of every value.
        "model_error": one.measured.request.model_error;
        /// `normal`, or `student-t with 4 degrees of freedom`.
        "likelihood": if one.calibration.fit.problem.is_robust { "student-t with 4 degrees of freedom" } else { "normal" };
        /// Number of outliers.
        "outliers": one.calibration.outliers;
        /// Akaike's information criterion (AIC); smaller is better.
        "aic": one.calibration.fit.aic;
        /// All local minima: values of the keys, and the excess of the sum of squares over the smallest one.
        "minima": one.calibration.fit.minima.iter().map(|place| basin_fields(one.calibration, place)).collect::<Vec<_>>();
        /// Singular values of the sensitivities: relative change of the predictions over relative change of the keys.
        "identifiability.singular_values": one.calibration.identifiability.as_ref().map(|found| found.singular_values.clone());
        /// Smallest relative change of the predictions if one key is doubled and the others are refitted.
        "identifiability.change_along_the_weakest_direction": one.calibration.identifiability.as_ref().map(|found| found.change);
        /// Product of powers of the keys that is known best.
        "identifiability.best_known_combination":
            one.calibration.identifiability.as_ref().map(|identifiability| combination_text(one.calibration, &identifiability.exponents));
        /// Relative standard deviation of this product.
        "identifiability.relative_sd_of_that": one.calibration.identifiability.as_ref().map(|found| found.deviation);
        /// All requested laws, the best first: AIC, difference from the smallest AIC, values of the keys.
        "laws": one.calibration.laws.iter().map(|law| law_fields(one.calibration, law)).collect::<Vec<_>>();
        /// Name of the file of measurements.
        "data_file": one.measured.sha256.is_some().then(|| file_name(&one.measured.data.name));
        /// SHA-256 of the file of measurements; `null` if the measurements are in the scenario.
        "data_sha256": one.measured.sha256.clone();
    }
}

/// One of the keys that were found.
pub struct KeyResult<'a> {
    number: usize,
    calibration: &'a Calibration<'a>,
}

impl KeyResult<'_> {
    fn estimate(&self) -> &KeyEstimate {
        &self.calibration.keys[self.number]
    }

    /// The value that shifts the key most.
    fn largest_shift(&self) -> Option<Value> {
        let calibration = self.calibration;
        let shifts = calibration
            .shifts
            .as_ref()
            .filter(|_| calibration.reason_without_intervals.is_none() && calibration.degrees_of_freedom > 0)?
            .column(self.number);
        let value = &calibration.fit.problem.data.values[shifts.icamax()];
        let slope = self.estimate().free.slope_at_share(calibration.fit.best().shares[self.number]);
        let line = calibration.fit.problem.data.rows[value.row].line;
        Some(json!({ "line": line, "quantity": value.quantity.name(), "without_it": slope * shifts[shifts.icamax()] }))
    }
}

/// The results for one of the keys.
pub fn key_results<'a>() -> Vec<ResultSpec<KeyResult<'a>>> {
    result_specs! { |one: KeyResult<'a>|
        /// Path of the key.
        "key": one.estimate().free.key.path();
        /// Name of the key as a column, with the unit of the values.
        "column": one.estimate().free.key.column_name();
        /// Range that was searched.
        "range": vec![one.estimate().free.from, one.estimate().free.to];
        /// `true` if the search used the logarithm of the value.
        "is_logarithmic": one.estimate().free.is_logarithmic;
        /// Best value.
        "estimate": one.estimate().estimate;
        /// Estimate in the hardness scale of the scenario, such as `254.3 HV`; `null` for other keys.
        "estimate_on_its_scale": one.estimate().free.hardness.and_then(|_| one.estimate().free.to_scenario_text(one.estimate().estimate));
        /// Standard deviation; `null` if there is no interval.
        "sd": one.estimate().sd;
        /// Ends of the 68 % confidence interval; an unbounded end is `null`, and `note` states the reason.
        "interval_68": one.estimate().intervals.map(|[narrow, _]| interval_json(narrow));
        /// Ends of the 95 % confidence interval.
        "interval_95": one.estimate().intervals.map(|[_, wide]| interval_json(wide));
        /// Most influential value: its line, its quantity, and the change of the estimate without this value.
        "largest_shift": one.largest_shift();
    }
}

fn chi_square_per_degree(calibration: &Calibration) -> Option<f64> {
    (calibration.degrees_of_freedom > 0).then_some(calibration.chi_square / calibration.degrees_of_freedom as f64)
}

fn basin_fields(calibration: &Calibration, place: &ParameterPoint) -> Value {
    json!({ "values": calibration.fit.problem.values(&place.shares), "excess": place.sum - calibration.fit.best().sum })
}

fn law_fields(calibration: &Calibration, (name, fit): &LawFit) -> Value {
    match fit {
        Ok(fit) => {
            json!({ "law": name, "aic": fit.aic, "delta_aic": fit.aic - calibration.min_aic(), "values": fit.values() })
        }
        Err(reason) => json!({ "law": name, "no_answer": reason.to_string() }),
    }
}

/// The results by their names.
pub fn summary_fields(measured: &CalibrationTask, calibration: &Calibration) -> Map<String, Value> {
    to_fields(&calibration_results(), &CalibrationReport { measured, calibration })
}

/// The inputs that neither the data give nor the calibration finds.
pub fn inputs(measured: &CalibrationTask, calibration: &Calibration) -> Inputs {
    let varies = |key: &str| {
        calibration.keys.iter().any(|found| found.free.key.path() == key)
            || measured.data.keys.iter().any(|column| column.path() == key)
            || key == "output.samples"
            || key == "impact.speed" && measured.data.keys.iter().any(|column| column.path().starts_with("impact."))
    };
    let input = &calibration.fit.problem.input;
    let mut inputs = Inputs::new(input);
    // a strength that follows from a hardness changes with it
    let changing: Vec<String> = Body::ALL
        .into_iter()
        .filter(|body| input.number(body_key!(body, "hardness")).is_some())
        .filter(|body| body.strength_numbers().into_iter().any(|number| varies(number.path())))
        .flat_map(|body| [body.yield_strength().to_owned(), constraint_factor_name(body)])
        .collect();
    inputs.0.retain(|entry| !varies(&entry.path) && !changing.contains(&entry.path));
    inputs
}

/// The name of a file without its folders, which differ from machine to machine.
fn file_name(path: &str) -> String {
    std::path::Path::new(path).file_name().map_or_else(|| path.to_owned(), |name| name.to_string_lossy().into_owned())
}

/// `residuals.csv`: a line for every measured value.
pub fn residuals_csv(calibration: &Calibration) -> Result<Vec<u8>, Error> {
    let data = calibration.fit.problem.data;
    let mut writer = csv::Writer::from_writer(Vec::new());
    let keys = data.keys.iter().map(|key| key.column_name());
    let shifted = calibration.keys.iter().map(|found| format!("shift_without_it_{}", found.free.key.column_name()));
    let fixed = ["quantity", "measured", "sd", "predicted", "residual_over_sd"].map(str::to_owned);
    let indentation = data.is_curve().then(|| "indentation_m".to_owned());
    let header = ["line".to_owned()].into_iter().chain(keys).chain(indentation).chain(fixed).chain(shifted);
    writer.write_record(header)?;
    for (i, value) in data.values.iter().enumerate() {
        let row = &data.rows[value.row];
        let slope = |key: usize| calibration.keys[key].free.slope_at_share(calibration.fit.best().shares[key]);
        let shift = |key: usize| {
            calibration.shifts.as_ref().map_or_else(String::new, |all| (all[(i, key)] * slope(key)).to_string())
        };
        let numbers =
            [value.value, calibration.fit.problem.deviations[i], calibration.predicted[i], calibration.residuals[i]];
        let fields = [row.line.to_string()].into_iter().chain(
            row.keys
                .iter()
                .chain(&row.indentation)
                .map(|key| if key.is_nan() { String::new() } else { key.to_string() }),
        );
        let fields = fields.chain([value.quantity.name().to_owned()]).chain(numbers.map(|number| number.to_string()));
        writer.write_record(fields.chain((0..calibration.keys.len()).map(shift)))?;
    }
    into_bytes(writer)
}

/// A line for every law, the best first: its AIC, how far that is above the smallest AIC, and the values of the keys.
fn law_rows(calibration: &Calibration) -> Vec<Vec<String>> {
    let row = |(law, fit): &LawFit| match fit {
        Ok(fit) => {
            // where the law does not know the keys, rounding alone is left of their information
            let is_known = fit.covariance.as_ref().is_some_and(|all| all.diagonal().iter().all(|square| *square < 1.0));
            let text = |(value, found): (f64, &KeyEstimate)| {
                if is_known { found.free.format_value(value, 4) } else { "not identified".to_owned() }
            };
            let values = fit.values().into_iter().zip(&calibration.keys).map(text);
            let numbers = [fit.aic, fit.aic - calibration.min_aic()].map(|number| format!("{number:.2}"));
            [law.clone()].into_iter().chain(numbers).chain(values).collect()
        }
        Err(reason) => vec![law.clone(), reason.to_string()],
    };
    let names = calibration.keys.iter().map(|found| found.free.key.path().to_owned());
    let header = ["law", "AIC", "above the best"].map(str::to_owned).into_iter().chain(names).collect();
    [header].into_iter().chain(calibration.laws.iter().map(row)).collect()
}

/// A name and a value.
type Row = [String; 2];

fn row(name: &str, value: impl Into<String>) -> Row {
    [name.to_owned(), value.into()]
}

/// The keys that were found, the fit, and the laws that were compared.
pub fn result_blocks(calibration: &Calibration) -> Vec<Block> {
    let (noise, share) = noise(calibration);
    let share = share.map_or_else(String::new, |share| format!(", {} (relative)", format_percent(share)));
    let mut rows: Vec<Row> = calibration.keys.iter().flat_map(key_rows).collect();
    rows.extend(combination_row(calibration));
    rows.push(data_row(calibration));
    rows.push(row("noise", format!("{noise}{share}")));
    rows.push(row("misfit", format!("{} rms", format_percent(calibration.misfit))));
    rows.extend(chi_square_row(calibration));
    let runs = calibration.runs;
    rows.extend(runs.map(|runs| row("runs test of residuals", format!("p = {}", format_four_digits(runs.p)))));
    rows.extend(second_minimum_row(calibration));
    let mut blocks = vec![Block::list(rows)];
    if !calibration.laws.is_empty() {
        let laws = Block::table(law_rows(calibration), 1);
        blocks.extend([Block::EmptyLine, laws, Block::Sentence(ABOUT_AIC.to_owned())]);
    }
    blocks
}

const ABOUT_AIC: &str =
    "Laws within 2 AIC units of the best fit equally well; laws 10 or more units above fit clearly worse.";

/// A key that was found, and its intervals.
fn key_rows(found: &KeyEstimate) -> Vec<Row> {
    let text = |value: f64| found.free.format_value(value, 4);
    let sd = found.sd.map(|sd| format!("   sd {}", found.free.format_deviation(found.estimate, sd, 2)));
    let estimate = row(found.free.key.path(), text(found.estimate) + &sd.unwrap_or_default());
    let interval = |(name, ends): (&str, &[Option<f64>; 2])| {
        let value = match *ends {
            [Some(low), Some(high)] => format!("{} to {}", text(low), text(high)),
            [Some(low), None] => format!("{} and more ({UNBOUNDED})", text(low)),
            [None, Some(high)] => format!("{} and less ({UNBOUNDED})", text(high)),
            [None, None] => UNBOUNDED.to_owned(),
        };
        row(name, value)
    };
    let intervals = ["  68 %", "  95 %"].into_iter().zip(found.intervals.iter().flatten()).map(interval);
    [estimate].into_iter().chain(intervals).collect()
}

/// The combination of several keys that the data determine, where they determine no single key.
fn combination_row(calibration: &Calibration) -> Option<Row> {
    let is_undetermined = calibration.reason_without_intervals.is_some() && calibration.keys.len() > 1;
    let identifiability = calibration.identifiability.as_ref().filter(|_| is_undetermined)?;
    let known = combination_text(calibration, &identifiability.exponents);
    Some(row("best-determined combination", format!("{known} (+- {})", format_percent(identifiability.deviation))))
}

fn data_row(calibration: &Calibration) -> Row {
    let measured = calibration.fit.problem.data.measured_quantities();
    let measured: Vec<&str> = measured.into_iter().map(MeasuredQuantity::name).collect();
    let count = calibration.residuals.len();
    let plural = if count == 1 { "" } else { "s" };
    row("data", format!("{count} value{plural} of {}", measured.join(", ")))
}

fn chi_square_row(calibration: &Calibration) -> Option<Row> {
    let p = format_four_digits(calibration.p?);
    let outliers = match calibration.outliers {
        0 => String::new(),
        outliers => format!(", without {outliers} outliers"),
    };
    let (chi_square, freedom) = (format_four_digits(calibration.chi_square), calibration.degrees_of_freedom);
    Some(row("chi-square", format!("{chi_square} on {freedom} degrees of freedom{outliers}, p = {p}")))
}

fn second_minimum_row(calibration: &Calibration) -> Option<Row> {
    let second = calibration.fit.minima.get(1).filter(|_| calibration.reason_without_intervals.is_none())?;
    let values = calibration.fit.problem.values(&second.shares);
    let values = calibration.keys.iter().zip(values).map(|(found, value)| found.free.format_value(value, 4));
    let excess = format_four_digits(second.sum - calibration.fit.best().sum);
    let values = values.collect::<Vec<_>>().join(", ");
    Some(row("second minimum", format!("{values}, with a sum of squares {excess} higher")))
}
