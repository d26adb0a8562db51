//! The law and the program against finite elements, published values and closed forms: how right the numbers are.
//!
//! Every comparison is a [`Check`]: expected, got, deviation, tolerance. What is expected never comes from the law or the
//! integrator under test. Tolerances are those that the law's documentation and the references state, plus a small margin
//! that is named with them.

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

/// Rows of one kind.
pub type Source = fn(&PlmCoefficients) -> Result<Vec<Check>, ValidationError>;

/// Where rows come from, in the order of the table.
pub const SOURCES: [Source; 10] = [
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

/// All rows for a law with these coefficients. Counted are the sources.
///
/// # Errors
/// [`ValidationError`].
pub fn checks(coefficients: &PlmCoefficients, progress: &Counter) -> Result<Vec<Check>, ValidationError> {
    let mut all = Vec::new();
    progress.expect(SOURCES.len() as u64);
    for source in SOURCES {
        all.extend(source(coefficients)?);
        progress.step();
    }
    if coefficients != PlmCoefficients::built_in() {
        // what is on record was found of the built-in law
        for check in &mut all {
            check.known = None;
        }
    }
    Ok(all)
}
