//! A free key of a calibration: its range, and the scale of the search in this range.

use crate::contact::strength::hardness::HardnessScale;
use crate::numerics::functions::{exp, ln};
use crate::scenario::input::Key;
use crate::units::{Dimension, format_exact, format_input, format_number};

/// A free key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Free {
    pub key: &'static Key,
    /// The lower end of its range, SI.
    pub from: f64,
    /// The upper end of its range, SI.
    pub to: f64,
    /// True if the scale is logarithmic: equal ratios count equally, instead of equal differences.
    pub is_logarithmic: bool,
    /// The hardness scale on which the scenario gives the key; the results are on this scale too.
    pub hardness: Option<HardnessScale>,
}

impl Free {
    /// The value at a fraction of the range from the lower end to the upper end; the ends are exact.
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

    /// The derivative of the value with respect to the fraction.
    pub fn slope(&self, share: f64) -> f64 {
        if self.is_logarithmic { self.at(share) * ln(self.to / self.from) } else { self.to - self.from }
    }

    /// A value of the key with `digits` digits in a fitting unit; a hardness on its scale, with the pressure beside it.
    pub fn text(&self, value: f64, digits: usize) -> String {
        let pressure = format_input(rounded(value, digits), self.key.quantity.dimension);
        match self.on_scale(value) {
            Some((value, scale)) => format!("{} {} ({pressure})", format_number(rounded(value, digits)), scale.name()),
            None => pressure,
        }
    }

    /// The standard deviation of a value, with `digits` digits.
    pub fn deviation_text(&self, value: f64, deviation: f64, digits: usize) -> String {
        match self.on_scale(value).zip(self.on_scale(value + deviation)) {
            Some(((value, scale), (more, _))) => {
                format!("{} {}", format_number(rounded(more - value, digits)), scale.name())
            }
            None => format_input(rounded(deviation, digits), self.key.quantity.dimension),
        }
    }

    /// A value as in a scenario, with its unit and all digits; `None` for a plain number.
    pub fn written(&self, value: f64) -> Option<String> {
        let dimension = self.key.quantity.dimension;
        let on_scale =
            || self.on_scale(value).map(|(value, scale)| format!("{} {}", format_number(value), scale.name()));
        (dimension != Dimension::Ratio).then(|| on_scale().unwrap_or_else(|| format_exact(value, dimension)))
    }

    /// A hardness on the scale of the scenario, if the scale covers it.
    fn on_scale(&self, value: f64) -> Option<(f64, HardnessScale)> {
        let scale = self.hardness?;
        Some((scale.number_at_mean_pressure(value)?, scale))
    }
}

/// A value with `digits` significant digits.
fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits - 1).parse().unwrap_or(value)
}
