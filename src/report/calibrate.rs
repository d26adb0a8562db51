//! What is written about a calibration: `summary.json`, `residuals.csv`, `posterior.csv` and the table on the terminal.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::inputs::Inputs;
use super::resolved::of_scene;
use super::rows::written;
use crate::calibrate::minimum::Place;
use crate::calibrate::profile::Ends;
use crate::calibrate::quantity::MEASURED;
use crate::calibrate::{Calibration, Fit, Found, Measurements, NoAnswer};
use crate::error::Error;
use crate::provenance::Provenance;
use crate::scene::results::Fields;
use crate::units::aligned::aligned;
use crate::units::four_digits;
use crate::units::rounded::percent;

/// The note on an interval with an end outside of the range of the key.
const UNBOUNDED: &str = "not bounded by these data";

/// An interval in SI. An end that the data do not bound is `null`.
fn interval(ends: Ends) -> Value {
    let note = ends.iter().any(Option::is_none).then_some(UNBOUNDED);
    json!({ "low": ends[0], "high": ends[1], "note": note })
}

fn key(found: &Found, number: usize, of: &Calibration) -> Value {
    let told = found.posterior.as_ref().filter(|_| of.refusal.is_none());
    let at = |probability| told.map(|marginal| found.free.at(marginal.quantile(probability)));
    let largest = of.shifts.as_ref().filter(|_| of.refusal.is_none() && of.freedom > 0).and_then(|shifts| {
        let sizes = shifts.iter().map(|shift| shift[number]).enumerate();
        let (i, shift) = sizes.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        let value = &of.fit.problem.data.values[i];
        let slope = found.free.slope(of.fit.best().shares[number]);
        let line = of.fit.problem.data.rows[value.row].line;
        Some(json!({ "line": line, "quantity": MEASURED[value.what].name, "without_it": slope * shift }))
    });
    json!({
        "key": found.free.key.path,
        "column": found.free.key.column(),
        "range": [found.free.from, found.free.to],
        "is_logarithmic": found.free.is_logarithmic,
        "estimate": found.estimate,
        "sd": found.sd,
        "sd_if_model_error_is_common": found.sd_of_common_error,
        "interval_68": found.intervals.map(|[narrow, _]| interval(narrow)),
        "interval_95": found.intervals.map(|[_, wide]| interval(wide)),
        "posterior_median": at(0.5),
        "posterior_95": at(0.025).zip(at(0.975)).map(|(low, high)| [low, high]),
        "largest_shift": largest,
    })
}

/// `yield_strength x youngs_modulus^-0.8`.
fn combination(of: &Calibration, exponents: &[f64]) -> String {
    let factors = of.keys.iter().zip(exponents).map(|(key, exponent)| match *exponent {
        1.0 => key.free.key.path.to_owned(),
        exponent => format!("{}^{exponent:.2}", key.free.key.path),
    });
    factors.collect::<Vec<_>>().join(" x ")
}

/// What is known of the noise. For estimated noise, also its share of the largest value.
fn noise(of: &Calibration) -> (&'static str, Option<f64>) {
    let problem = &of.fit.problem;
    let share = || {
        let values = problem.data.values.iter().zip(&problem.deviations);
        let (largest, deviation) = values.max_by(|a, b| a.0.value.total_cmp(&b.0.value))?;
        largest.deviation.is_none().then_some(deviation / largest.value)
    };
    match of.fit.freedom {
        Some(_) => ("estimated from the residuals", share()),
        None if of.fit.has_no_noise => ("unknown", None),
        None => ("given", None),
    }
}

/// `summary.json`.
pub fn summary(measured: &Measurements, of: &Calibration, provenance: &Provenance) -> Result<String, Error> {
    let (noise, estimated_noise) = noise(of);
    let problem = &of.fit.problem;
    let keys: Vec<Value> = of.keys.iter().enumerate().map(|(i, found)| key(found, i, of)).collect();
    let basin =
        |place: &Place| json!({ "values": problem.values(&place.shares), "excess": place.sum - of.fit.best().sum });
    let identified = of.identifiability.as_ref().map(|told| {
        json!({
            "singular_values": told.singular_values,
            "change_along_the_weakest_direction": told.change,
            "best_known_combination": combination(of, &told.exponents),
            "relative_sd_of_that": told.deviation,
        })
    });
    let law = |(name, fit): &(String, Result<Fit, NoAnswer>)| match fit {
        Ok(fit) => {
            json!({ "law": name, "aic": fit.aic, "delta_aic": fit.aic - of.least_aic(), "values": fit.values() })
        }
        Err(reason) => json!({ "law": name, "no_answer": reason.to_string() }),
    };
    #[allow(clippy::cast_precision_loss)] // counts of measurements
    let per_degree = (of.freedom > 0).then_some(of.chi_square / of.freedom as f64);
    let likelihood = if problem.is_robust { "student-t with 4 degrees of freedom" } else { "normal" };
    let contradiction = of.contradiction();
    let data_file = measured.sha256.is_some().then(|| file_name(&measured.data.name));
    let results = Fields(vec![
        ("keys", keys.into()),
        ("refusal", of.refusal.clone().into()),
        ("correlation", of.correlation().filter(|_| of.refusal.is_none()).into()),
        ("fits", contradiction.is_none().into()),
        ("contradiction", contradiction.into()),
        ("values", of.residuals.len().into()),
        ("degrees_of_freedom", of.freedom.into()),
        ("chi_square", of.chi_square.into()),
        ("chi_square_per_degree_of_freedom", per_degree.into()),
        ("misfit", of.misfit.into()),
        ("p", of.p.into()),
        ("p_of_runs", of.p_of_runs.into()),
        ("noise", noise.into()),
        ("estimated_noise", estimated_noise.into()),
        ("model_error", measured.wanted.model_error.into()),
        ("likelihood", likelihood.into()),
        ("outliers", of.outliers.into()),
        ("aic", of.fit.aic.into()),
        ("minima", of.fit.minima.iter().map(basin).collect()),
        ("identifiability", identified.into()),
        ("laws", of.laws.iter().map(law).collect()),
        ("data_file", data_file.into()),
        ("data_sha256", measured.sha256.clone().into()),
    ]);
    let varies = |key: &str| {
        of.keys.iter().any(|found| found.free.key.path == key)
            || measured.data.keys.iter().any(|column| column.path == key)
            || key == "output.samples"
            || key == "impact.speed" && measured.data.keys.iter().any(|column| column.path.starts_with("impact."))
    };
    let inputs = of_scene(&problem.scene).into_iter().filter(|entry| !varies(&entry.key) && !entry.is_nan());
    super::summary::of(results, &Inputs(inputs.collect()), provenance)
}

/// The name of a file without its folders, which differ from machine to machine.
fn file_name(path: &str) -> String {
    std::path::Path::new(path).file_name().map_or_else(|| path.to_owned(), |name| name.to_string_lossy().into_owned())
}

/// `residuals.csv`: a line for every measured value.
pub fn residuals(of: &Calibration) -> Result<Vec<u8>, Error> {
    let data = of.fit.problem.data;
    let mut writer = csv::Writer::from_writer(Vec::new());
    let keys = data.keys.iter().map(|key| key.column());
    let shifted = of.keys.iter().map(|found| format!("shift_without_it_{}", found.free.key.column()));
    let fixed = ["quantity", "measured", "sd", "predicted", "residual_over_sd"].map(str::to_owned);
    let indentation = data.is_curve().then(|| "indentation_m".to_owned());
    let header = ["line".to_owned()].into_iter().chain(keys).chain(indentation).chain(fixed).chain(shifted);
    writer.write_record(header)?;
    for (i, value) in data.values.iter().enumerate() {
        let row = &data.rows[value.row];
        let slope = |key: usize| of.keys[key].free.slope(of.fit.best().shares[key]);
        let shift =
            |key: usize| of.shifts.as_ref().map_or_else(String::new, |all| (all[i][key] * slope(key)).to_string());
        let numbers = [value.value, of.fit.problem.deviations[i], of.predicted[i], of.residuals[i]];
        let fields =
            [row.line.to_string()].into_iter().chain(row.keys.iter().chain(&row.indentation).map(f64::to_string));
        let fields =
            fields.chain([MEASURED[value.what].name.to_owned()]).chain(numbers.map(|number| number.to_string()));
        writer.write_record(fields.chain((0..of.keys.len()).map(shift)))?;
    }
    written(writer)
}

/// `posterior.csv`: the density over the keys, divided by its largest value. For one key also the probability of smaller
/// values.
pub fn posterior(of: &Calibration) -> Result<Option<Vec<u8>>, Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let names = of.keys.iter().map(|found| found.free.key.column());
    let at = |key: usize, share: f64| of.keys[key].free.at(share).to_string();
    if let Some(sheet) = &of.sheet {
        writer.write_record(names.chain(["relative_density".to_owned()]))?;
        for (first, line) in sheet {
            for (second, density) in line {
                writer.write_record([at(0, *first), at(1, *second), density.to_string()])?;
            }
        }
        return written(writer).map(Some);
    }
    let Some(marginal) = of.keys.first().and_then(|found| found.posterior.as_ref()) else { return Ok(None) };
    writer.write_record(names.chain(["relative_density".to_owned(), "probability_below".to_owned()]))?;
    let highest = marginal.density.iter().copied().fold(0.0, f64::max);
    let (mut below, mut before) = (0.0, None);
    for (share, density) in marginal.shares.iter().copied().zip(marginal.density.iter().copied()) {
        below += before.map_or(0.0, |(last, height)| 0.5 * (share - last) * (density + height));
        before = Some((share, density));
        writer.write_record([at(0, share), (density / highest).to_string(), f64::min(below, 1.0).to_string()])?;
    }
    written(writer).map(Some)
}

/// A line for every law, the best first: its AIC, how far that is above the smallest AIC, and the values of the keys.
fn ranked(of: &Calibration) -> Vec<Vec<String>> {
    let row = |(law, fit): &(String, Result<Fit, NoAnswer>)| match fit {
        Ok(fit) => {
            let values = fit.values().into_iter().zip(&of.keys).map(|(value, found)| found.free.say(value, 4));
            let numbers = [fit.aic, fit.aic - of.least_aic()].map(|number| format!("{number:.2}"));
            [law.clone()].into_iter().chain(numbers).chain(values).collect()
        }
        Err(reason) => vec![law.clone(), reason.to_string()],
    };
    let names = of.keys.iter().map(|found| found.free.key.path.to_owned());
    let header = ["law", "AIC", "above the best"].map(str::to_owned).into_iter().chain(names).collect();
    [header].into_iter().chain(of.laws.iter().map(row)).collect()
}

/// The table for the terminal.
pub fn table(of: &Calibration) -> String {
    let mut rows: Vec<[String; 2]> = Vec::new();
    let mut row = |name: &str, value: String| rows.push([name.to_owned(), value]);
    for found in &of.keys {
        let say = |value: f64| found.free.say(value, 4);
        let sd = found.sd.map_or_else(String::new, |sd| format!("   sd {}", found.free.say(sd, 2)));
        row(found.free.key.path, say(found.estimate) + &sd);
        for (name, ends) in ["  68 %", "  95 %"].into_iter().zip(found.intervals.iter().flatten()) {
            let end = |end: Option<f64>, what: &str| end.map_or_else(|| format!("{what} {UNBOUNDED}"), say);
            row(name, format!("{} to {}", end(ends[0], "below"), end(ends[1], "above")));
        }
    }
    if let Some(told) = of.identifiability.as_ref().filter(|_| of.refusal.is_some() && of.keys.len() > 1) {
        let known = combination(of, &told.exponents);
        row("best known", format!("{known}, to {}", percent(told.deviation)));
    }
    let measured = of.fit.problem.data.measured().into_iter().map(|what| MEASURED[what].name).collect::<Vec<_>>();
    row(
        "data",
        format!(
            "{} value{} of {}",
            of.residuals.len(),
            if of.residuals.len() == 1 { "" } else { "s" },
            measured.join(", ")
        ),
    );
    let (noise, share) = noise(of);
    let share = share.map_or_else(String::new, |share| format!(", {} of a value", percent(share)));
    row("noise", format!("{noise}{share}"));
    if let Some(p) = of.p {
        let outliers = if of.outliers > 0 { format!(", without {} outliers", of.outliers) } else { String::new() };
        let chi_square = four_digits(of.chi_square);
        row(
            "chi-square",
            format!("{chi_square} on {} degrees of freedom{outliers}, p = {}", of.freedom, four_digits(p)),
        );
    }
    if let Some(p) = of.p_of_runs {
        row("runs of signs", format!("p = {}", four_digits(p)));
    }
    if of.fit.minima.len() > 1 && of.refusal.is_none() {
        let second = &of.fit.minima[1];
        let values = of.fit.problem.values(&second.shares);
        let values = of.keys.iter().zip(values).map(|(found, value)| found.free.say(value, 4));
        let excess = four_digits(second.sum - of.fit.best().sum);
        row("second best", format!("{}, with a sum of squares {excess} higher", values.collect::<Vec<_>>().join(", ")));
    }
    let mut text = aligned(&rows, |_| true);
    if !of.laws.is_empty() {
        let _ = write!(text, "\n{}", aligned(&ranked(of), |column| column == 0));
    }
    text
}
