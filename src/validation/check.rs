//! One comparison: expected and computed number, deviation, tolerance and verdict.

use crate::law::UnloadingExponent;
use crate::math::power::farther_or_nan;

/// The exponents that are compared, with their names in tables and pictures.
pub const EXPONENTS: [(UnloadingExponent, &str); 2] =
    [(UnloadingExponent::Paper, "exponent 3/2"), (UnloadingExponent::PressureShape, "pressure-shape")];

/// Largest deviation that passes, in either direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    pub limit: f64,
    source: Source,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Source {
    Found(f64),
    Stated(&'static str),
}

impl Tolerance {
    /// A limit that a reference states, or that follows from the error of the reference.
    pub const fn stated(limit: f64, source: &'static str) -> Self {
        Self { limit, source: Source::Stated(source) }
    }

    /// Where the limit comes from.
    pub fn source(&self) -> String {
        match self.source {
            Source::Found(deviation) => format!("found {:.2} %, and a margin", 100.0 * deviation),
            Source::Stated(source) => source.to_owned(),
        }
    }
}

/// A limit beyond the deviation that was found when the law was fixed. It shows changes; no reference states it.
pub const fn found(deviation: f64, limit: f64) -> Tolerance {
    Tolerance { limit, source: Source::Found(deviation) }
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

/// What the checks of one quantity have in common.
#[derive(Debug, Clone, Copy)]
pub struct Group {
    /// The quantity. If the deviation is not relative to the expected number, the name says what else it is a share of.
    pub quantity: &'static str,
    /// Where the expected numbers come from.
    pub reference: &'static str,
    /// Unit of the numbers; empty for plain numbers.
    pub unit: &'static str,
    /// Tolerance of one number.
    pub tolerance: Tolerance,
    /// Whether the deviation is the difference of the numbers, because both are shares of another number.
    pub is_difference: bool,
    /// Tolerances of statistics over all numbers.
    pub overall: &'static [(Statistic, Tolerance)],
}

impl Group {
    /// Checks of numbers against a reference.
    pub const fn of(quantity: &'static str, reference: &'static str, unit: &'static str, tolerance: Tolerance) -> Self {
        Self { quantity, reference, unit, tolerance, is_difference: false, overall: &[] }
    }

    /// The same with tolerances of statistics.
    #[must_use]
    pub const fn with_overall(self, overall: &'static [(Statistic, Tolerance)]) -> Self {
        Self { overall, ..self }
    }

    /// The same with differences as deviations.
    #[must_use]
    pub const fn of_differences(self) -> Self {
        Self { is_difference: true, ..self }
    }

    /// The check of one number.
    pub fn check(self, case: String, [expected, got]: [f64; 2]) -> Check {
        let deviation = if self.is_difference { got - expected } else { deviation(expected, got) };
        Check { numbers: Some([expected, got]), ..self.check_of(case, deviation) }
    }

    /// The check of a deviation that sums up many numbers.
    pub fn check_of(self, case: String, deviation: f64) -> Check {
        let Self { tolerance, .. } = self;
        Check { group: self, statistic: None, case, numbers: None, deviation, tolerance, known: None }
    }

    /// The checks of these numbers, then those of their statistics. `things` says what the cases are.
    pub fn checks(self, numbers: impl IntoIterator<Item = (String, [f64; 2])>, things: &str) -> Vec<Check> {
        let mut checks: Vec<Check> = numbers.into_iter().map(|(case, numbers)| self.check(case, numbers)).collect();
        let deviations: Vec<f64> = checks.iter().map(|check| check.deviation).collect();
        checks.extend(self.overall.iter().map(|((name, statistic), tolerance)| Check {
            statistic: Some(name),
            tolerance: *tolerance,
            ..self.check_of(format!("{} {things}", deviations.len()), statistic(&deviations))
        }));
        checks
    }
}

#[derive(Debug, Clone)]
pub struct Check {
    /// Quantity, reference and unit.
    pub group: Group,
    /// The name of the statistic, if the check is of one over all numbers of the group.
    pub statistic: Option<&'static str>,
    /// The case, run or speed.
    pub case: String,
    /// The number of the reference and that of the law; `None` for what sums up many.
    pub numbers: Option<[f64; 2]>,
    /// Relative deviation, got/expected − 1. If it is relative to another number, the name of the quantity says so.
    pub deviation: f64,
    pub tolerance: Tolerance,
    pub known: Option<Known>,
}

impl Check {
    /// The quantity, and the name of the statistic.
    pub fn quantity(&self) -> String {
        let statistic = self.statistic.map_or_else(String::new, |name| format!(", {name}"));
        self.group.quantity.to_owned() + &statistic
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
pub fn largest(deviations: impl IntoIterator<Item = f64>) -> f64 {
    deviations.into_iter().fold(0.0, farther_or_nan)
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
