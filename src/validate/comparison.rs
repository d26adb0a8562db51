//! A number of a reference beside that of the law.

use crate::contact::law::UnloadingExponent;

/// The exponents that are compared, with their names in tables and pictures.
pub const EXPONENTS: [(UnloadingExponent, &str); 2] =
    [(UnloadingExponent::Paper, "exponent 3/2"), (UnloadingExponent::PressureShape, "pressure-shape")];

/// A quantity that is compared with one source.
#[derive(Debug, Clone, Copy)]
pub struct Group {
    /// If the deviation is not relative to the number of the reference, the name says what it is a share of.
    pub quantity: &'static str,
    /// Where the numbers of the reference come from.
    pub source: &'static str,
    /// Unit of the numbers; empty for plain numbers.
    pub unit: &'static str,
    /// True if the deviation is the difference of the numbers, because both are shares of another number.
    pub is_difference: bool,
}

impl Group {
    pub const fn new(quantity: &'static str, source: &'static str, unit: &'static str) -> Self {
        Self { quantity, source, unit, is_difference: false }
    }

    /// A group whose deviations are differences.
    pub const fn new_difference(quantity: &'static str, source: &'static str, unit: &'static str) -> Self {
        Self { is_difference: true, ..Self::new(quantity, source, unit) }
    }

    pub fn compare(self, case: String, [reference, law]: [f64; 2]) -> Comparison {
        let deviation = if self.is_difference { law - reference } else { deviation(reference, law) };
        Comparison { group: self, case, reference, law, deviation, built_in_law: None }
    }
}

/// A quantity of a case, and the numbers of reference and law; `None` if the reference has no such number.
pub type ComparedQuantity<T> = (Group, fn(&T) -> Option<[f64; 2]>);

/// Compares these quantities of these cases, one quantity after the other.
pub fn compare_all<T>(quantities: &[ComparedQuantity<T>], cases: &[T], name: impl Fn(&T) -> String) -> Vec<Comparison> {
    let of_quantity = |(group, numbers): &ComparedQuantity<T>| -> Vec<Comparison> {
        cases.iter().filter_map(|case| Some(group.compare(name(case), numbers(case)?))).collect()
    };
    quantities.iter().flat_map(of_quantity).collect()
}

/// One number of a reference, and that of the law.
#[derive(Debug, Clone)]
pub struct Comparison {
    pub group: Group,
    /// The case, run or speed.
    pub case: String,
    pub reference: f64,
    pub law: f64,
    /// Relative deviation, law/reference − 1. If it is relative to another number, the name of the quantity says so.
    pub deviation: f64,
    /// The deviation of the law with the built-in coefficients, if the law has others.
    pub built_in_law: Option<f64>,
}

/// The relative deviation law/reference − 1; 0 if both numbers are equal.
pub fn deviation(reference: f64, law: f64) -> f64 {
    if law == reference { 0.0 } else { law / reference - 1.0 }
}

/// The deviation farthest from zero; NaN if any is NaN.
pub fn max_magnitude(deviations: impl IntoIterator<Item = f64>) -> f64 {
    deviations.into_iter().fold(0.0, |a: f64, b: f64| if a.is_nan() || a.abs() >= b.abs() { a } else { b })
}

pub fn mean(values: &[f64]) -> f64 {
    let n = values.len() as f64;
    values.iter().sum::<f64>() / n
}

pub fn rms(values: &[f64]) -> f64 {
    mean(&values.iter().map(|value| value * value).collect::<Vec<_>>()).sqrt()
}
