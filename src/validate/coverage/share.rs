//! How many values of a set lie in an interval.

/// The table of a scenario with the exponent that is closest to finite elements.
pub(super) const PRESSURE_SHAPE: &str = "[law.plm]\nunloading_exponent = \"pressure-shape\"\n";

/// How many values of a set lie in the interval.
#[derive(Debug, Clone, PartialEq)]
pub struct Coverage {
    pub set: String,
    pub values: usize,
    pub inside: usize,
}

impl Coverage {
    pub(super) fn count(set: impl Into<String>, are_inside: impl IntoIterator<Item = bool>) -> Self {
        let (mut values, mut inside) = (0, 0);
        for is_inside in are_inside {
            values += 1;
            inside += usize::from(is_inside);
        }
        Self { set: set.into(), values, inside }
    }

    /// The share inside, 0 to 1.
    pub fn share(&self) -> f64 {
        self.inside as f64 / self.values as f64
    }
}
