//! Compares the law with finite elements and with measurements. The number of the reference comes from a table of
//! `src/reference`, never from the law.
//!
//! Comparisons with exact arithmetic and closed forms are not here: they are tests of the program.

pub mod atlas;
mod bounces;
pub mod cases;
pub mod comparison;
pub mod coverage;
pub mod dynamic;
mod figure_10;
mod hardening;
pub mod law_error;
pub mod laws;
mod leeb;
mod load_cycle;
pub mod measured;
pub mod oblique;
mod pictures;
mod poisson;
mod quasi_static;
mod rate;
pub mod report;
mod residual;
mod viscoelastic;
mod yielding;

use crate::contact::law::PlmCoefficients;
use crate::error::Error;
use crate::files::Progress;
pub use comparison::{Comparison, Group};
pub use pictures::pictures;

/// A function that compares the law with one kind of reference.
type ComparisonFn = fn(&PlmCoefficients) -> Result<Vec<Comparison>, Error>;

/// All these functions, in the order of the table in the report.
const SOURCES: &[ComparisonFn] = &[
    quasi_static::loading,
    quasi_static::cycles,
    dynamic::impacts,
    hardening::unloadings,
    hardening::deep_unloadings,
    residual::dents,
    poisson::unloadings,
    yielding::load_cycles,
    rate::impacts,
    rate::deep_impacts,
    leeb::rebounds,
    leeb::restitutions_by_hardness,
    yielding::equal_balls,
    bounces::bounce_heights,
    oblique::rebounds,
    viscoelastic::restitutions,
    measured::comparisons,
];

/// All comparisons of a law with these coefficients. `progress` counts the kinds of references.
pub fn comparisons(coefficients: &PlmCoefficients, progress: &Progress) -> Result<Vec<Comparison>, Error> {
    let (mut all, built_in) = (Vec::new(), PlmCoefficients::built_in());
    progress.add_total(SOURCES.len() as u64);
    for source in SOURCES {
        let mut compared = source(coefficients)?;
        if coefficients != built_in {
            for (own, other) in compared.iter_mut().zip(source(built_in)?) {
                own.built_in_law = Some(other.deviation);
            }
        }
        all.extend(compared);
        progress.advance();
    }
    Ok(all)
}
