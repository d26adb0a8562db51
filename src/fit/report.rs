//! The results of a fit: a table for the terminal and the file of coefficients.

use std::fmt::Write as _;

use super::LoadingPoint;
use super::solve::{CaseFit, Fit};
use crate::error::Error;
use crate::law::PlmCoefficients;
use crate::law::plm::Provenance;
use crate::math::power::max_or_nan;
use crate::units::aligned::aligned;
use crate::units::four_digits;

fn percent(share: f64) -> String {
    format!("{:.2}", 100.0 * share)
}

/// A table with the deviations \[%\] of each curve in force, elastic approach and contact radius: rms and largest. For
/// force and approach it also has the rms from a law fitted to the other curves, and from the built-in table
/// (`built_in`).
pub fn table(fit: &Fit, built_in: &[CaseFit]) -> String {
    let header = "curve|E*/E_s*|F: rms %|largest|left out|built-in|delta_e: rms %|largest|left out|built-in|a: rms %";
    let mut rows = vec![header.split('|').map(str::to_owned).collect::<Vec<_>>()];
    for (case, built_in) in fit.cases.iter().zip(built_in) {
        let or_none = |rms: Option<f64>| rms.map_or_else(|| "-".to_owned(), percent);
        rows.push(vec![
            case.curve.name.clone(),
            format!("{:.4}", case.curve.pair.sphere_compliance),
            percent(case.force.rms),
            format!("{:+.2}", 100.0 * case.force.largest),
            or_none(case.left_out.map(|(force, _)| force.rms)),
            percent(built_in.force.rms),
            percent(case.approach.rms),
            format!("{:+.2}", 100.0 * case.approach.largest),
            or_none(case.left_out.map(|(_, approach)| approach.rms)),
            percent(built_in.approach.rms),
            or_none(case.radius.map(|radius| radius.rms)),
        ]);
    }
    let mut text = aligned(&rows, |column| column == 0);
    let rise = fit.cases.iter().map(|case| case.restitution_rise).fold(0.0, max_or_nan);
    let _ = writeln!(text, "largest rise of restitution with indentation: {} %", percent(rise));
    text
}

/// The coefficients with their provenance. `name` is the name of the table in results.
pub fn coefficients(fit: &Fit, name: &str, command: &str) -> PlmCoefficients {
    let over = |value: &dyn Fn(&CaseFit) -> f64| {
        let values = || fit.cases.iter().map(value);
        (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, max_or_nan))
    };
    let percents = |(low, high): (f64, f64)| format!("{}-{} %", percent(low), percent(high));
    let mut accuracy = format!(
        "rms {} in force, {} in elastic approach",
        percents(over(&|case| case.force.rms)),
        percents(over(&|case| case.approach.rms))
    );
    if fit.cases.iter().all(|case| case.left_out.is_some()) {
        let _ = write!(
            accuracy,
            "; curves left out of the fit: {} and {}",
            percents(over(&|case| case.left_out.map_or(0.0, |left| left.0.rms))),
            percents(over(&|case| case.left_out.map_or(0.0, |left| left.1.rms)))
        );
    }
    let end = |point: Option<&LoadingPoint>| point.map_or(f64::NAN, |point| point.indentation);
    let (from, _) = over(&|case| end(case.curve.points.first()));
    let (_, to) = over(&|case| end(case.curve.points.last()));
    let (least, most) = over(&|case| case.curve.pair.sphere_compliance);
    let mut range = format!(
        "indentation / yield indentation {} to {}, E*/E_s* {least:.3} to {most:.3}",
        four_digits(from),
        four_digits(to)
    );
    let ratios = fit.cases.iter().flat_map(|case| {
        let radii = case.curve.points.iter().filter_map(|point| point.contact_radius);
        radii.map(|radius| radius * case.curve.yield_radius_ratio)
    });
    if let Some(ratio) = ratios.reduce(max_or_nan) {
        let _ = write!(range, ", contact radius / sphere radius <= {ratio:.2}");
    }
    PlmCoefficients {
        provenance: Provenance {
            name: name.to_owned(),
            source: format!(
                "least squares of ln F and ln delta_e against {} loading curves: {command}",
                fit.cases.len()
            ),
            accuracy,
            range,
        },
        ..fit.coefficients.clone()
    }
}

/// The text of the file that `[law.plm] coefficients` reads: TOML, with numbers of ten digits.
pub fn toml(coefficients: &PlmCoefficients) -> Result<String, Error> {
    let failed = |error: toml::ser::Error| Error::failed(format!("coefficients: {error}"));
    let mut rounded = toml::Value::try_from(coefficients).map_err(failed)?;
    round(&mut rounded);
    let text = toml::to_string(&rounded).map_err(failed)?;
    Ok(format!(
        "# Coefficients of the piecewise-linear loading law, for `[law.plm] coefficients = \"...\"` in a scenario.\n\n{text}"
    ))
}

/// Rounds all numbers in `value` to ten digits.
fn round(value: &mut toml::Value) {
    match value {
        toml::Value::Float(number) => *number = format!("{number:.9e}").parse().unwrap_or(*number),
        toml::Value::Array(list) => list.iter_mut().for_each(round),
        toml::Value::Table(table) => table.iter_mut().for_each(|(_, value)| round(value)),
        _ => {}
    }
}
