//! One comparison.

use crate::math::power::farther_or_nan;

/// How far a number may be off, and who says so.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Largest deviation that passes, either way.
    pub limit: f64,
    /// Where it comes from.
    pub source: &'static str,
}

/// A deviation beyond the tolerance that is on record: not a pass, but no news either.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Known {
    /// How large it was found to be; beyond this it is a miss.
    pub limit: f64,
    /// What is off, and where.
    pub remark: &'static str,
}

/// How a row ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Within the tolerance.
    Pass,
    /// Beyond it, as is known of the law.
    Known,
    /// Beyond it.
    Miss,
}

impl Verdict {
    /// In tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Known => "known",
            Self::Miss => "MISS",
        }
    }
}

/// One row of the validation.
#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// What is compared; rows of the same quantity are summed up together.
    pub quantity: String,
    /// For what: case, run, speed.
    pub case: String,
    /// Where the expected number comes from.
    pub reference: &'static str,
    /// Of both numbers; empty for plain ones.
    pub unit: &'static str,
    /// The reference; `None` for a mean over many.
    pub expected: Option<f64>,
    /// The law or the program; `None` for a mean over many.
    pub got: Option<f64>,
    /// Relative deviation, got/expected − 1, unless the quantity says of what else it is a share.
    pub deviation: f64,
    /// What passes.
    pub tolerance: Tolerance,
    /// What is known not to.
    pub known: Option<Known>,
}

impl Check {
    /// Two numbers.
    #[must_use]
    pub fn numbers(
        quantity: &str,
        case: String,
        reference: &'static str,
        unit: &'static str,
        [expected, got]: [f64; 2],
        tolerance: Tolerance,
    ) -> Self {
        Self {
            quantity: quantity.to_owned(),
            case,
            reference,
            unit,
            expected: Some(expected),
            got: Some(got),
            deviation: deviation(expected, got),
            tolerance,
            known: None,
        }
    }

    /// A mean, or a root mean square, of deviations.
    #[must_use]
    pub fn mean(quantity: &str, case: String, reference: &'static str, deviation: f64, tolerance: Tolerance) -> Self {
        let quantity = quantity.to_owned();
        Self { quantity, case, reference, unit: "", expected: None, got: None, deviation, tolerance, known: None }
    }

    /// Whether the deviation is within the tolerance, or else within what is on record.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let off = self.deviation.abs();
        if off <= self.tolerance.limit {
            Verdict::Pass
        } else if self.known.is_some_and(|known| off <= known.limit) {
            Verdict::Known
        } else {
            Verdict::Miss
        }
    }
}

/// Rows with a verdict.
#[must_use]
pub fn count(checks: &[Check], verdict: Verdict) -> usize {
    checks.iter().filter(|check| check.verdict() == verdict).count()
}

/// got/expected − 1; zero if both are.
#[must_use]
pub fn deviation(expected: f64, got: f64) -> f64 {
    if got == expected { 0.0 } else { got / expected - 1.0 }
}

/// The one farthest from zero; NaN if any is.
#[must_use]
pub fn largest(deviations: impl Iterator<Item = f64>) -> f64 {
    deviations.fold(0.0, farther_or_nan)
}

/// Arithmetic mean.
#[must_use]
pub fn mean(values: &[f64]) -> f64 {
    #[allow(clippy::cast_precision_loss)]
    let n = values.len() as f64;
    values.iter().sum::<f64>() / n
}

/// Root mean square.
#[must_use]
pub fn rms(values: &[f64]) -> f64 {
    mean(&values.iter().map(|value| value * value).collect::<Vec<_>>()).sqrt()
}
