//! Distributions and statistical tests of a fit.

use statrs::distribution::{ChiSquared, ContinuousCDF, StudentsT};
use statrs::function::factorial::ln_binomial;

use crate::numerics::functions::exp;

/// The two levels of every interval.
pub const LEVELS: [f64; 2] = [0.682_689_492_137_085_9, 0.95];

/// Rounds to twelve digits. The crate takes its logarithms from the C library of the machine, and their last digit
/// differs from machine to machine.
fn round_to_twelve_digits(value: f64) -> f64 {
    format!("{value:.11e}").parse().unwrap_or(value)
}

/// Half-width of an interval of this level, in standard deviations. `freedom` is the degrees of freedom of the
/// estimated noise; `None` if the noise is known.
pub fn half_width(level: f64, freedom: Option<f64>) -> f64 {
    let below = 0.5 + 0.5 * level;
    let student = freedom.and_then(|freedom| StudentsT::new(0.0, 1.0, freedom).ok());
    student.map_or_else(
        || crate::numerics::functions::normal_quantile(below),
        |student| round_to_twelve_digits(student.inverse_cdf(below)),
    )
}

/// Probability of this chi-square or a larger one; `None` without a degree of freedom.
pub fn chi_square_p_value(chi_square: f64, freedom: usize) -> Option<f64> {
    ChiSquared::new(freedom as f64).ok().map(|distribution| round_to_twelve_digits(distribution.sf(chi_square)))
}

/// The test of runs of equal signs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunsTest {
    /// Probability of as few runs, or fewer.
    pub p: f64,
    /// Probability of the fewest runs that these signs can have.
    pub min_p: f64,
}

/// The test of runs in residuals of random order (Wald and Wolfowitz 1940, exact). `None` with fewer than two residuals
/// that are not zero.
pub fn runs_test(residuals: &[f64]) -> Option<RunsTest> {
    let signs: Vec<bool> =
        residuals.iter().filter(|residual| **residual != 0.0).map(|residual| *residual > 0.0).collect();
    let above = signs.iter().filter(|sign| **sign).count() as u64;
    let below = signs.len() as u64 - above;
    if above == 0 || below == 0 {
        // all on one side: the probability that a coin falls on the same side every time
        let halvings = i32::try_from(signs.len().saturating_sub(1)).unwrap_or(i32::MAX);
        let p = crate::numerics::functions::powi(0.5, halvings);
        return (signs.len() > 1).then_some(RunsTest { p, min_p: p });
    }
    let runs = 1 + signs.windows(2).filter(|pair| pair[0] != pair[1]).count() as u64;
    let ways = |n: u64, k: u64| if k > n { f64::NEG_INFINITY } else { ln_binomial(n, k) };
    let all = ways(above + below, above);
    let probability_of = |runs: u64| {
        let half = runs / 2;
        let probability = |a: u64, b: u64| exp(ways(above - 1, a) + ways(below - 1, b) - all);
        if runs.is_multiple_of(2) {
            2.0 * probability(half - 1, half - 1)
        } else {
            probability(half, half - 1) + probability(half - 1, half)
        }
    };
    let p = round_to_twelve_digits((2..=runs).map(probability_of).sum::<f64>().min(1.0));
    Some(RunsTest { p, min_p: round_to_twelve_digits(probability_of(2)) })
}
