//! A numeric key that a calibration has to find: its range, and the scale on which the range is searched.

use crate::math::functions::{exp, ln};
use crate::scene::Key;
use crate::units::human;

/// A key to find.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Free {
    pub key: &'static Key,
    /// The lower end of its range, SI.
    pub from: f64,
    /// The upper end of its range, SI.
    pub to: f64,
    /// Whether the scale is logarithmic: equal ratios count the same, not equal differences.
    pub is_logarithmic: bool,
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

    /// A value of the key, or its standard deviation, with so many digits in a fitting unit.
    pub fn say(&self, value: f64, digits: usize) -> String {
        human(format!("{value:.*e}", digits - 1).parse().unwrap_or(value), self.key.quantity.dimension)
    }
}
