//! Compares the law and the program with finite elements, published values and closed forms.
//!
//! Every comparison is a [`Check`]: expected, got, deviation, tolerance. The expected number never comes from the law
//! or the integrator under test. The tolerances are those that the documentation of the law and the references state,
//! plus a small margin that is named with them.

pub mod cases;
pub mod check;
mod closed_restitution;
mod dents;
pub mod dynamic;
mod error;
pub mod experiments;
mod hardening;
mod hertz;
mod loading;
mod measured;
mod oracle;
mod pictures;
pub mod report;
mod restitution;
mod unloading;

use crate::law::PlmCoefficients;
use crate::progress::Counter;
pub use check::{Check, Known, Tolerance, Verdict};
pub use error::{EXPONENTS, ValidationError};
pub use pictures::pictures;

/// A function that makes the checks of one kind.
type Source = fn(&PlmCoefficients) -> Result<Vec<Check>, ValidationError>;

/// All kinds of checks, in the order of the table.
const SOURCES: [Source; 10] = [
    loading::checks,
    unloading::checks,
    dents::checks,
    restitution::checks,
    dynamic::checks,
    hardening::checks,
    measured::checks,
    hertz::checks,
    closed_restitution::checks,
    oracle::checks,
];

/// All checks of a law with these coefficients. `progress` counts the kinds of checks.
pub fn checks(coefficients: &PlmCoefficients, progress: &Counter) -> Result<Vec<Check>, ValidationError> {
    let mut all = Vec::new();
    progress.expect(SOURCES.len() as u64);
    for source in SOURCES {
        all.extend(source(coefficients)?);
        progress.step();
    }
    if coefficients != PlmCoefficients::built_in() {
        // the known deviations were found for the built-in law
        for check in &mut all {
            check.known = None;
        }
    }
    Ok(all)
}
