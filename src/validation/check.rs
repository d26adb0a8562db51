//! One comparison: expected and computed number, deviation, tolerance and verdict.

use crate::math::power::farther_or_nan;

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Largest deviation that passes, in either direction.
    pub limit: f64,
    /// Where the limit comes from.
    pub source: &'static str,
}

/// A known deviation beyond the tolerance. It does not count as a pass, but the validation does not fail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Known {
    /// A deviation larger than this is a miss.
    pub limit: f64,
    /// Where the deviation occurs, and why.
    pub remark: &'static str,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    Pass,
    Known,
    Miss,
}

impl Verdict {
    /// The word for it in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Known => "known",
            Self::Miss => "MISS",
        }
    }
}

#[derive(Debug, Clone, PartialEq)]
pub struct Check {
    /// The quantity that is compared. Checks of the same quantity share a row of the summary.
    pub quantity: String,
    /// The case, run or speed.
    pub case: String,
    /// Where the expected number comes from.
    pub reference: &'static str,
    /// Unit of both numbers; empty for plain numbers.
    pub unit: &'static str,
    /// The number of the reference; `None` for a mean over many.
    pub expected: Option<f64>,
    /// The number of the law or the program; `None` for a mean over many.
    pub got: Option<f64>,
    /// Relative deviation, got/expected − 1. If it is relative to another number, the name of the quantity says so.
    pub deviation: f64,
    pub tolerance: Tolerance,
    pub known: Option<Known>,
}

impl Check {
    /// A check of one number against another.
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

    /// The same check with the difference of both numbers as its deviation, because both are shares of another number.
    #[must_use]
    pub fn of_difference(self) -> Self {
        let deviation = self.expected.zip(self.got).map_or(f64::NAN, |(expected, got)| got - expected);
        Self { deviation, ..self }
    }

    /// A check of a mean, or of a root mean square, of deviations.
    pub fn mean(quantity: &str, case: String, reference: &'static str, deviation: f64, tolerance: Tolerance) -> Self {
        let quantity = quantity.to_owned();
        Self { quantity, case, reference, unit: "", expected: None, got: None, deviation, tolerance, known: None }
    }

    /// A check of a statistic of the deviations of these checks, which are of one quantity and of these `things`.
    pub fn overall(checks: &[Self], (name, statistic): Statistic, things: &str, tolerance: Tolerance) -> Option<Self> {
        let Self { quantity, reference, .. } = checks.first()?;
        let deviations: Vec<f64> = checks.iter().map(|check| check.deviation).collect();
        let case = format!("{} {things}", checks.len());
        Some(Self::mean(&format!("{quantity}, {name}"), case, reference, statistic(&deviations), tolerance))
    }

    /// Whether the deviation is within the tolerance, or at least within the known deviation.
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

/// How many checks have this verdict.
pub fn count(checks: &[Check], verdict: Verdict) -> usize {
    checks.iter().filter(|check| check.verdict() == verdict).count()
}

/// The relative deviation got/expected − 1; 0 if both numbers are equal.
pub fn deviation(expected: f64, got: f64) -> f64 {
    if got == expected { 0.0 } else { got / expected - 1.0 }
}

/// The deviation farthest from zero; NaN if any is NaN.
pub fn largest(deviations: impl Iterator<Item = f64>) -> f64 {
    deviations.fold(0.0, farther_or_nan)
}

/// A number that sums up many: its name, and how it is computed.
pub type Statistic = (&'static str, fn(&[f64]) -> f64);
pub const MEAN: Statistic = ("mean", mean);
pub const RMS: Statistic = ("rms", rms);

pub fn mean(values: &[f64]) -> f64 {
    #[allow(clippy::cast_precision_loss)]
    let n = values.len() as f64;
    values.iter().sum::<f64>() / n
}

pub fn rms(values: &[f64]) -> f64 {
    mean(&values.iter().map(|value| value * value).collect::<Vec<_>>()).sqrt()
}
