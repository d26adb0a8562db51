//! Pictures of the validation: points are the reference, lines are the law. They have the form of Figs. 5-9, 11 and 12
//! of Xie et al. (2024), for all cases; others show deviations against depth.

mod cycles;
mod dents;
mod deviations;
mod experiments;
mod hardening;
mod impacts;
mod measured;
mod shares;

use rayon::prelude::*;

use super::ValidationError;
use super::cases::cases;
use super::experiments::Experiment;
use crate::law::{Peak, PlmCoefficients};
use crate::math::functions::{exp, ln};
use crate::output::OutputFile;
use crate::plot::{Axis, Chart, Pictures, PlotError};
use crate::progress::Counter;

/// A picture before it is drawn, with the name of its file without the ending.
type Picture = (String, Chart);

/// Add this to the index of a style to get a style of the same colour with other dashes and another marker.
const SISTER: usize = 7;

/// The name of a case in file names, such as "case-3".
fn slug(case: &str) -> String {
    case.to_lowercase().replace(' ', "-")
}

/// Axes of indentation and force in units of first yield, up to `room` times a peak. Also the number by which forces
/// are divided, because labels of five digits would overlap the title.
fn loop_axes(peak: &Peak, room: f64) -> ([Axis; 2], f64) {
    let (unit, title) =
        if peak.force >= 1e4 { (1e3, "Force over 1000 × yield force") } else { (1.0, "Force over yield force") };
    let x = Axis::linear("Indentation over yield indentation", "").between(0.0, room * peak.indentation);
    ([x, Axis::linear(title, "").between(0.0, room * peak.force / unit)], unit)
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
) -> Result<Vec<OutputFile>, ValidationError> {
    if format == Pictures::None {
        return Ok(Vec::new());
    }
    let cases = cases()?;
    let mut pictures = deviations::pictures(&cases, coefficients);
    for case in &cases {
        pictures.push(shares::shape(case, coefficients));
        pictures.extend(shares::pictures(case, coefficients));
        pictures.extend(cycles::pictures(case, coefficients));
        pictures.extend(dents::picture(case));
    }
    pictures.extend(impacts::pictures(&super::dynamic::cases(coefficients)?));
    pictures.push(hardening::picture(coefficients)?);
    pictures.push(measured::picture(coefficients)?);
    pictures.extend(measured.iter().map(experiments::picture));
    progress.expect(pictures.len() as u64);
    let file = |(name, chart): &Picture| format.file(name, chart).inspect(|_| progress.step());
    let drawn: Result<Vec<Option<OutputFile>>, PlotError> = pictures.par_iter().map(file).collect();
    Ok(drawn?.into_iter().flatten().collect())
}
