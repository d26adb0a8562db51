//! Quantities as people write them: "5 mm", "210GPa", "7.85 g/cm^3", to SI and back.
//!
//! A leaf: knows neither scenarios nor mechanics. One table holds every unit; where a unit is a power of ten of the SI
//! unit its exponent joins the decimal text before the one rounding to binary, so that "5 mm" is the same number as 0.005.

mod format;
pub mod nearest;
pub mod rounded;
mod table;

use thiserror::Error;

pub use format::{describe, four_digits, human, number, si};
use nearest::nearest;
use table::{Scale, UNITS, Unit};

/// What a quantity measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// Metres.
    Length,
    /// Seconds.
    Time,
    /// Metres per second.
    Speed,
    /// Metres per second squared.
    Acceleration,
    /// Seconds per metre.
    InverseSpeed,
    /// Kilograms.
    Mass,
    /// Kilograms per cubic metre.
    Density,
    /// Pascals.
    Pressure,
    /// Newtons.
    Force,
    /// Joules.
    Energy,
    /// A plain number.
    Ratio,
}

impl Dimension {
    /// With its article, for messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Length => "a length",
            Self::Time => "a time",
            Self::Speed => "a speed",
            Self::Acceleration => "an acceleration",
            Self::InverseSpeed => "an inverse speed",
            Self::Mass => "a mass",
            Self::Density => "a density",
            Self::Pressure => "a pressure",
            Self::Force => "a force",
            Self::Energy => "an energy",
            Self::Ratio => "a plain number",
        }
    }

    /// The SI unit, empty for a plain number.
    #[must_use]
    pub fn si_unit(self) -> &'static str {
        match self {
            Self::Length => "m",
            Self::Time => "s",
            Self::Speed => "m/s",
            Self::Acceleration => "m/s^2",
            Self::InverseSpeed => "s/m",
            Self::Mass => "kg",
            Self::Density => "kg/m^3",
            Self::Pressure => "Pa",
            Self::Force => "N",
            Self::Energy => "J",
            Self::Ratio => "",
        }
    }

    /// The end of a column or key name in this unit: `_m_per_s`; empty for a plain number.
    #[must_use]
    pub fn suffix(self) -> &'static str {
        match self {
            Self::Length => "_m",
            Self::Time => "_s",
            Self::Speed => "_m_per_s",
            Self::Acceleration => "_m_per_s2",
            Self::InverseSpeed => "_s_per_m",
            Self::Mass => "_kg",
            Self::Density => "_kg_per_m3",
            Self::Pressure => "_Pa",
            Self::Force => "_N",
            Self::Energy => "_J",
            Self::Ratio => "",
        }
    }

    /// How such a quantity may be written.
    #[must_use]
    pub fn example(self) -> &'static str {
        match self {
            Self::Length => "\"5 mm\"",
            Self::Time => "\"20 us\"",
            Self::Speed => "\"3 m/s\"",
            Self::Acceleration => "\"9.81 m/s^2\"",
            Self::InverseSpeed => "\"0.1 s/m\"",
            Self::Mass => "\"4 g\"",
            Self::Density => "\"7850 kg/m^3\"",
            Self::Pressure => "\"210 GPa\"",
            Self::Force => "\"1 kN\"",
            Self::Energy => "\"1 mJ\"",
            Self::Ratio => "0.3",
        }
    }

    fn units(self) -> impl Iterator<Item = &'static Unit> {
        UNITS.iter().filter(move |unit| unit.dimension == self)
    }

    /// The units that may be written, for messages.
    #[must_use]
    pub fn unit_names(self) -> String {
        self.units().map(|unit| unit.name).collect::<Vec<_>>().join(", ")
    }
}

/// Why a text is no quantity.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum UnitError {
    /// It does not begin with a number.
    #[error("\"{text}\" does not begin with a number; write {} such as {}", .dimension.name(), .dimension.example())]
    NoNumber {
        /// The text.
        text: String,
        /// What was wanted.
        dimension: Dimension,
    },
    /// A decimal comma.
    #[error("\"{text}\" has a decimal comma; write a decimal point")]
    DecimalComma {
        /// The text.
        text: String,
    },
    /// A number in quotes without a unit.
    #[error("\"{text}\" has no unit; write {} such as {}, or a number without quotes in {}", .dimension.name(), .dimension.example(), .dimension.si_unit())]
    NoUnit {
        /// The text.
        text: String,
        /// What was wanted.
        dimension: Dimension,
    },
    /// A unit of something else.
    #[error("\"{text}\" is {}, but {} is needed, such as {}", .found.name(), .wanted.name(), .wanted.example())]
    WrongDimension {
        /// The text.
        text: String,
        /// What the unit measures.
        found: Dimension,
        /// What was wanted.
        wanted: Dimension,
    },
    /// No such unit.
    #[error("unknown unit \"{unit}\" in \"{text}\"{}; units of {}: {}", did_you_mean(*.nearest), .dimension.name(), allowed(*.dimension))]
    UnknownUnit {
        /// The text.
        text: String,
        /// Its unit.
        unit: String,
        /// What was wanted.
        dimension: Dimension,
        /// The unit most like it.
        nearest: Option<&'static str>,
    },
}

fn did_you_mean(nearest: Option<&str>) -> String {
    nearest.map_or_else(String::new, |unit| format!(", did you mean \"{unit}\"?"))
}

fn allowed(dimension: Dimension) -> String {
    if dimension == Dimension::Ratio { "none, or %".to_owned() } else { dimension.unit_names() }
}

/// Reads a quantity with its unit and gives it in SI.
///
/// # Errors
/// [`UnitError`], naming the unit and what would be understood.
///
/// ```
/// use plm_impact::units::{Dimension, parse};
/// assert_eq!(parse("5 mm", Dimension::Length)?, 0.005);
/// assert_eq!(parse("7.85 g/cm³", Dimension::Density)?, 7850.0);
/// # Ok::<(), plm_impact::units::UnitError>(())
/// ```
pub fn parse(text: &str, dimension: Dimension) -> Result<f64, UnitError> {
    let written = || text.to_owned();
    let no_number = || UnitError::NoNumber { text: written(), dimension };
    let (number, unit) = split(text.trim());
    if !number.bytes().any(|byte| byte.is_ascii_digit()) {
        return Err(no_number());
    }
    if unit.is_empty() {
        return match dimension {
            Dimension::Ratio => number.parse().map_err(|_| no_number()),
            _ => Err(UnitError::NoUnit { text: written(), dimension }),
        };
    }
    if unit.starts_with(',') {
        return Err(UnitError::DecimalComma { text: written() });
    }
    let plain = plain_spelling(unit);
    let find = |unit: &&Unit| plain_spelling(unit.name) == plain;
    match (dimension.units().find(find), UNITS.iter().find(find)) {
        (Some(unit), _) => unit.scale.apply(number).ok_or_else(no_number),
        (None, Some(other)) => {
            Err(UnitError::WrongDimension { text: written(), found: other.dimension, wanted: dimension })
        }
        (None, None) => Err(UnitError::UnknownUnit {
            text: written(),
            unit: unit.to_owned(),
            dimension,
            nearest: nearest(unit, dimension.units().map(|unit| unit.name)),
        }),
    }
}

impl Scale {
    /// The number in SI, rounded once.
    fn apply(self, number: &str) -> Option<f64> {
        match self {
            Self::Ten(power) => {
                let (digits, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
                match exponent.parse::<i32>() {
                    Ok(exponent) => format!("{digits}e{}", exponent.saturating_add(power)).parse().ok(),
                    // an exponent of ten digits: infinite or zero in any unit
                    Err(_) => number.parse().ok(),
                }
            }
            Self::Times(factor) => number.parse::<f64>().ok().map(|value| value * factor),
            Self::Over(divisor) => number.parse::<f64>().ok().map(|value| value / divisor),
        }
    }
}

/// Splits "5e3 mm" into "5e3" and "mm".
fn split(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digits = |mut at: usize| {
        while bytes.get(at).is_some_and(u8::is_ascii_digit) {
            at += 1;
        }
        at
    };
    let sign = |at: usize| at + usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
    let mut end = digits(sign(0));
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    // an exponent only where digits follow: "5 e" is no number
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let from = sign(end + 1);
        let to = digits(from);
        if to > from {
            end = to;
        }
    }
    (&text[..end], text[end..].trim_start())
}

/// One spelling for all of "kg/m^3", "kg / m³", "kg/m**3", "kg/m3"; "µm" with either sign, "um".
fn plain_spelling(unit: &str) -> String {
    let parts: Vec<&str> = unit.split('/').map(str::trim).collect();
    parts
        .join("/")
        .replace(['\u{b5}', '\u{3bc}'], "u")
        .replace('²', "2")
        .replace('³', "3")
        .replace("**", "")
        .replace('^', "")
}
