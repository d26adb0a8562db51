//! One comparison.

/// How far a number may be off, and who says so.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Largest deviation that passes, either way.
    pub limit: f64,
    /// Where it comes from.
    pub source: &'static str,
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
        }
    }

    /// A mean, or a root mean square, of deviations.
    #[must_use]
    pub fn mean(quantity: &str, case: String, reference: &'static str, deviation: f64, tolerance: Tolerance) -> Self {
        let quantity = quantity.to_owned();
        Self { quantity, case, reference, unit: "", expected: None, got: None, deviation, tolerance }
    }

    /// Whether the deviation is within the tolerance.
    #[must_use]
    pub fn passes(&self) -> bool {
        self.deviation.abs() <= self.tolerance.limit
    }

    /// "pass" or "MISS".
    #[must_use]
    pub fn verdict(&self) -> &'static str {
        if self.passes() { "pass" } else { "MISS" }
    }
}

/// got/expected − 1; zero if both are.
#[must_use]
pub fn deviation(expected: f64, got: f64) -> f64 {
    if got == expected { 0.0 } else { got / expected - 1.0 }
}

/// The one farthest from zero.
#[must_use]
pub fn largest(deviations: impl Iterator<Item = f64>) -> f64 {
    deviations.fold(0.0, |worst: f64, next| if next.abs() > worst.abs() { next } else { worst })
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
