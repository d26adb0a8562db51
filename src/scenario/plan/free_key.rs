//! A free key of a calibration: its range, and the scale of the search in this range.

use crate::contact::strength::hardness::HardnessScale;
use crate::numerics::functions::{exp, ln};
use crate::scenario::input::NumericKey;
use crate::units::{Dimension, format_exact, format_input, format_number};

/// A free key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeKey {
    pub key: NumericKey,
    /// The lower end of its range, SI.
    pub from: f64,
    /// The upper end of its range, SI.
    pub to: f64,
    /// True if the scale is logarithmic: equal ratios count equally, instead of equal differences.
    pub is_logarithmic: bool,
    /// The hardness scale on which the scenario gives the key; the results are on this scale too.
    pub hardness: Option<HardnessScale>,
}

impl FreeKey {
    /// The value at a fraction of the range from the lower end to the upper end; the ends are exact.
    pub fn value_at_share(&self, share: f64) -> f64 {
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
    pub fn slope_at_share(&self, share: f64) -> f64 {
        if self.is_logarithmic { self.value_at_share(share) * ln(self.to / self.from) } else { self.to - self.from }
    }

    /// A value of the key with `digits` digits in a fitting unit; a hardness on its scale, with the pressure beside it; an angle in
    /// degrees.
    pub fn format_value(&self, value: f64, digits: usize) -> String {
        if self.key.quantity().dimension == Dimension::Angle {
            return degrees_text(value, digits);
        }
        let pressure = format_input(round_to_digits(value, digits), self.key.quantity().dimension);
        match self.hardness_number(value) {
            Some((value, scale)) => {
                format!("{} {} ({pressure})", format_number(round_to_digits(value, digits)), scale.name())
            }
            None => pressure,
        }
    }

    /// The standard deviation of a value, with `digits` digits.
    pub fn format_deviation(&self, value: f64, deviation: f64, digits: usize) -> String {
        match self.hardness_number(value).zip(self.hardness_number(value + deviation)) {
            Some(((value, scale), (more, _))) => {
                format!("{} {}", format_number(round_to_digits(more - value, digits)), scale.name())
            }
            None => format_input(round_to_digits(deviation, digits), self.key.quantity().dimension),
        }
    }

    /// A value as in a scenario, with its unit and all digits; `None` for a plain number.
    pub fn to_scenario_text(&self, value: f64) -> Option<String> {
        let dimension = self.key.quantity().dimension;
        let on_scale =
            || self.hardness_number(value).map(|(value, scale)| format!("{} {}", format_number(value), scale.name()));
        (dimension != Dimension::Ratio).then(|| on_scale().unwrap_or_else(|| format_exact(value, dimension)))
    }

    /// A value as in a scenario, in TOML: a text with its unit, or a plain number.
    pub fn to_toml(&self, value: f64) -> String {
        self.to_scenario_text(value).map_or_else(|| format!("{value:?}"), |text| format!("{text:?}"))
    }

    /// A value as in a scenario, with its unit and `digits` digits.
    pub fn to_rounded_text(&self, value: f64, digits: usize) -> String {
        if let Some((number, scale)) = self.hardness_number(value) {
            return format!("{} {}", format_number(round_to_digits(number, digits)), scale.name());
        }
        if self.key.quantity().dimension == Dimension::Angle {
            return degrees_text(value, digits);
        }
        let value = round_to_digits(value, digits);
        self.to_scenario_text(value).unwrap_or_else(|| format_number(value))
    }

    /// A hardness on the scale of the scenario, if the scale covers it.
    fn hardness_number(&self, value: f64) -> Option<(f64, HardnessScale)> {
        let scale = self.hardness?;
        Some((scale.number_at_mean_pressure(value)?, scale))
    }
}

/// An angle as people write it.
fn degrees_text(angle: f64, digits: usize) -> String {
    format!("{} deg", format_number(round_to_digits(angle.to_degrees(), digits)))
}

/// A value with `digits` significant digits.
fn round_to_digits(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits - 1).parse().unwrap_or(value)
}
