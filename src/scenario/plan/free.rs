//! A numeric key that a calibration has to find: its range, and the scale on which the range is searched.

use crate::contact::strength::hardness::Scale;
use crate::numerics::functions::{exp, ln};
use crate::scenario::scene::Key;
use crate::units::{Dimension, exact, human, number};

/// A key to find.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Free {
    pub key: &'static Key,
    /// The lower end of its range, SI.
    pub from: f64,
    /// The upper end of its range, SI.
    pub to: f64,
    /// True if the scale is logarithmic: equal ratios count the same, not equal differences.
    pub is_logarithmic: bool,
    /// The scale of hardness on which the scenario gives the key, if it is one: results are on it too.
    pub hardness: Option<Scale>,
}

impl Free {
    /// The value at a share of the way from the lower end to the upper one; the ends are exact.
    pub fn at(&self, share: f64) -> f64 {
        let Self { from, to, is_logarithmic, .. } = *self;
        if share <= 0.0 {
            from
        } else if share >= 1.0 {
            to
        } else if is_logarithmic {
            exp(ln(from) + share * ln(to / from))
        } else {
            from + share * (to - from)
        }
    }

    /// How fast the value rises with the share.
    pub fn slope(&self, share: f64) -> f64 {
        if self.is_logarithmic { self.at(share) * ln(self.to / self.from) } else { self.to - self.from }
    }

    /// A value of the key with so many digits in a fitting unit; a hardness on its scale, with the pressure beside it.
    pub fn text(&self, value: f64, digits: usize) -> String {
        let pressure = human(rounded(value, digits), self.key.quantity.dimension);
        match self.on_scale(value) {
            Some((value, scale)) => format!("{} {} ({pressure})", number(rounded(value, digits)), scale.name()),
            None => pressure,
        }
    }

    /// The standard deviation of a value, with so many digits.
    pub fn deviation_text(&self, value: f64, deviation: f64, digits: usize) -> String {
        match self.on_scale(value).zip(self.on_scale(value + deviation)) {
            Some(((value, scale), (more, _))) => format!("{} {}", number(rounded(more - value, digits)), scale.name()),
            None => human(rounded(deviation, digits), self.key.quantity.dimension),
        }
    }

    /// A value as a scenario gives it, with its unit and all digits; `None` for a plain number.
    pub fn written(&self, value: f64) -> Option<String> {
        let dimension = self.key.quantity.dimension;
        let on_scale = || self.on_scale(value).map(|(value, scale)| format!("{} {}", number(value), scale.name()));
        (dimension != Dimension::Ratio).then(|| on_scale().unwrap_or_else(|| exact(value, dimension)))
    }

    /// A hardness on the scale of the scenario, if it has a number there.
    fn on_scale(&self, value: f64) -> Option<(f64, Scale)> {
        let scale = self.hardness?;
        Some((scale.of_mean_pressure(value)?, scale))
    }
}

/// A value with so many significant digits.
fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits - 1).parse().unwrap_or(value)
}
