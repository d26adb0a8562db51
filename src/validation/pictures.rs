//! Pictures of the validation: deviations against depth, and the law (lines) beside the reference (points).

mod deviations;
mod experiments;
mod hardening;
mod impacts;
mod measured;
mod oblique;
mod plate;

use rayon::prelude::*;

use super::cases::cases;
use super::experiments::Experiment;
use crate::error::Error;
use crate::law::PlmCoefficients;
use crate::math::functions::{exp, ln};
use crate::output::OutputFile;
use crate::plot::{Chart, Pictures, PlotError};
use crate::progress::Counter;

/// A picture before it is drawn, with the name of its file without the ending.
type Picture = (String, Chart);

/// The name of a case in file names, such as "case-3".
fn slug(case: &str) -> String {
    case.to_lowercase().replace(' ', "-")
}

/// A curve of `n` equal pieces from `low` to `high`.
fn sampled(low: f64, high: f64, n: u32, point: impl Fn(f64) -> (f64, f64)) -> Vec<(f64, f64)> {
    (0..=n).map(|i| point(low + (high - low) * f64::from(i) / f64::from(n))).collect()
}

/// A curve of `n` pieces from `low` to `high`, with equal ratios.
fn log_sampled(low: f64, high: f64, n: u32, point: impl Fn(f64) -> (f64, f64)) -> Vec<(f64, f64)> {
    sampled(ln(low), ln(high), n, |at| point(exp(at)))
}

/// All pictures; those of the user's measurements come last. `progress` counts the pictures.
pub fn pictures(
    coefficients: &PlmCoefficients,
    measured: &[Experiment],
    format: Pictures,
    progress: &Counter,
) -> Result<Vec<OutputFile>, Error> {
    if format == Pictures::None {
        return Ok(Vec::new());
    }
    let cases = cases()?;
    let mut pictures = deviations::pictures(&cases, coefficients);
    pictures.extend(super::dynamic::cases(coefficients)?.iter().map(impacts::picture));
    pictures.push(hardening::picture(coefficients)?);
    pictures.push(measured::picture(coefficients)?);
    pictures.extend(plate::pictures()?);
    pictures.push(oblique::picture()?);
    pictures.extend(measured.iter().flat_map(experiments::pictures));
    progress.expect(pictures.len() as u64);
    let file = |(name, chart): &Picture| format.file(name, chart).inspect(|_| progress.step());
    let drawn: Result<Vec<Option<OutputFile>>, PlotError> = pictures.par_iter().map(file).collect();
    Ok(drawn?.into_iter().flatten().collect())
}
