//! Compares the law with finite elements and with measurements.
//!
//! Every comparison is a [`Check`]: expected, got, deviation, tolerance. The expected number comes from a reference, never
//! from the law. What the checks of a quantity have in common is a [`Group`]. Few references state a tolerance. Where none
//! does, the limit is the deviation that was found when the law was fixed, and a margin: it shows changes of the law.
//!
//! Comparisons of the program with exact arithmetic and closed forms are no part of this, but tests of the program.

pub mod cases;
pub mod check;
pub mod dynamic;
pub mod experiments;
mod figure_10;
mod hardening;
pub mod laws;
mod measured;
mod oblique;
mod pictures;
mod quasi_static;
pub mod report;

use crate::error::{Error, ErrorKind};
use crate::impact::ImpactError;
use crate::law::PlmCoefficients;
use crate::material::OutOfFloatRange;
use crate::progress::Counter;
pub use check::{Check, Group, Known, Tolerance, Verdict};
pub use pictures::pictures;

impl From<ImpactError> for Error {
    fn from(error: ImpactError) -> Self {
        Self::of(ErrorKind::Failed, &error)
    }
}

impl From<OutOfFloatRange> for Error {
    fn from(error: OutOfFloatRange) -> Self {
        Self::of(ErrorKind::Failed, &error)
    }
}

/// A function that makes the checks against one kind of reference.
type Source = fn(&PlmCoefficients) -> Result<Vec<Check>, Error>;

/// All of them, in the order of the table.
const SOURCES: &[Source] = &[
    quasi_static::loading,
    quasi_static::cycles,
    dynamic::checks,
    hardening::checks,
    measured::checks,
    oblique::checks,
];

/// All checks of a law with these coefficients. `progress` counts the kinds of references.
pub fn checks(coefficients: &PlmCoefficients, progress: &Counter) -> Result<Vec<Check>, Error> {
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
