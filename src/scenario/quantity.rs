//! The quantities of a scenario: dimension and allowed range, checked while the file is read, so that a bad value is shown
//! where it stands.

use std::fmt;

use serde::de::{Deserialize, DeserializeSeed, Deserializer, Error, Visitor};
use thiserror::Error;

use crate::impact::Method;
use crate::law::UnloadingExponent;
use crate::nearest::nearest;
use crate::units::{self, Dimension};

/// An end of a range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Bound {
    /// Not itself allowed.
    Open(f64),
    /// Allowed.
    Closed(f64),
}

/// What a key holds: dimension, allowed range, and what to do outside of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quantity {
    /// With its article, for messages.
    pub name: &'static str,
    /// Its dimension.
    pub dimension: Dimension,
    /// Lower end.
    pub low: Bound,
    /// Upper end.
    pub high: Bound,
    /// How it may be written.
    pub example: &'static str,
    /// The way out at or beyond the upper end, or empty.
    pub hint: &'static str,
}

const fn positive(name: &'static str, dimension: Dimension, example: &'static str) -> Quantity {
    Quantity { name, dimension, low: Bound::Open(0.0), high: Bound::Open(f64::INFINITY), example, hint: "" }
}

/// A radius or diameter.
pub const LENGTH: Quantity = positive("a length", Dimension::Length, "\"5 mm\"");
/// An elastic modulus.
pub const MODULUS: Quantity = positive("a Young's modulus", Dimension::Pressure, "\"210 GPa\"");
/// The sphere's modulus, which may be without limit.
pub const SPHERE_MODULUS: Quantity = Quantity { hint: "for a rigid sphere write \"rigid\"", ..MODULUS };
/// A yield strength.
pub const STRENGTH: Quantity = Quantity {
    hint: "for an elastic body leave the key out",
    ..positive("a yield strength", Dimension::Pressure, "\"345 MPa\"")
};
/// A density.
pub const DENSITY: Quantity = positive("a density", Dimension::Density, "\"7850 kg/m^3\"");
/// An impact speed.
pub const SPEED: Quantity = positive("a speed", Dimension::Speed, "\"3 m/s\"");
const fn not_negative(name: &'static str, dimension: Dimension, example: &'static str) -> Quantity {
    Quantity { low: Bound::Closed(0.0), ..positive(name, dimension, example) }
}

/// A load that an indentation goes to.
pub const LOAD: Quantity = not_negative("a load", Dimension::Force, "\"200 N\"");
/// An indentation that it goes to.
pub const INDENTATION: Quantity = not_negative("an indentation", Dimension::Length, "\"12 um\"");
/// Poisson's ratio of a stable isotropic material.
pub const POISSONS_RATIO: Quantity = Quantity {
    name: "a Poisson's ratio",
    dimension: Dimension::Ratio,
    low: Bound::Open(-1.0),
    high: Bound::Open(0.5),
    example: "0.3",
    hint: "for an incompressible material write 0.4999",
};
/// The exponent n of the unloading branch.
pub const EXPONENT: Quantity = Quantity {
    name: "an unloading exponent",
    dimension: Dimension::Ratio,
    low: Bound::Open(1.0),
    high: Bound::Closed(2.0),
    example: "1.5",
    hint: "",
};
/// The relative tolerance of an integration: from 45 times the spacing of doubles at 1 to where steps carry no meaning.
pub const TOLERANCE: Quantity = Quantity {
    name: "a tolerance",
    dimension: Dimension::Ratio,
    low: Bound::Closed(1e-14),
    high: Bound::Closed(1e-2),
    example: "1e-10",
    hint: "",
};
/// Rows of a trace: two ends, and no more than a file of about a gigabyte.
pub const SAMPLES: Quantity = Quantity {
    name: "a number of samples",
    dimension: Dimension::Ratio,
    low: Bound::Closed(2.0),
    high: Bound::Closed(1e7),
    example: "400",
    hint: "",
};
/// Steps of the fixed-step method: at least one, and no more than seconds of computing.
pub const STEPS: Quantity = Quantity {
    name: "a number of steps",
    dimension: Dimension::Ratio,
    low: Bound::Closed(1.0),
    high: Bound::Closed(1e8),
    example: "50",
    hint: "",
};

/// A value outside its range.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("{written} is not allowed: {} must be {}{}", .quantity.name, .quantity.allowed(), .quantity.way_out(*.value))]
pub struct RangeError {
    /// The value as it was written, and in SI.
    pub written: String,
    /// In SI.
    pub value: f64,
    /// What it should have been.
    pub quantity: Quantity,
}

impl Quantity {
    /// The value in SI, if it is allowed.
    ///
    /// # Errors
    /// [`RangeError`] with value, range and way out.
    pub fn check(&self, value: f64) -> Result<f64, RangeError> {
        let above = match self.low {
            Bound::Open(low) => value > low,
            Bound::Closed(low) => value >= low,
        };
        let below = match self.high {
            Bound::Open(high) => value < high,
            Bound::Closed(high) => value <= high,
        };
        let written = || units::describe(value, self.dimension);
        if above && below { Ok(value) } else { Err(RangeError { written: written(), value, quantity: *self }) }
    }

    /// Reads "5 mm" and the like, and checks it.
    ///
    /// # Errors
    /// The message of a [`units::UnitError`] or [`RangeError`].
    pub fn parse(&self, text: &str) -> Result<f64, String> {
        let value = units::parse(text, self.dimension).map_err(|error| error.to_string())?;
        self.check(value).map_err(|error| {
            let written = format!("\"{text}\" = {}", units::si(value, self.dimension));
            RangeError { written, ..error }.to_string()
        })
    }

    /// The ends of the allowed range.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        let (Bound::Open(low) | Bound::Closed(low)) = self.low;
        let (Bound::Open(high) | Bound::Closed(high)) = self.high;
        (low, high)
    }

    /// The allowed range in words: "> 0 m and finite".
    #[must_use]
    pub fn allowed(&self) -> String {
        let value = |value| units::si(value, self.dimension);
        let low = match self.low {
            Bound::Open(low) => format!("> {}", value(low)),
            Bound::Closed(low) => format!(">= {}", value(low)),
        };
        match self.high {
            Bound::Open(f64::INFINITY) => format!("{low} and finite"),
            Bound::Open(high) => format!("{low} and < {}", value(high)),
            Bound::Closed(high) => format!("{low} and <= {}", value(high)),
        }
    }

    fn way_out(&self, value: f64) -> String {
        let (Bound::Open(high) | Bound::Closed(high)) = self.high;
        if value >= high && !self.hint.is_empty() { format!("; {}", self.hint) } else { String::new() }
    }
}

/// Reads a number in SI or a text with a unit.
pub(super) struct Reader<'a>(pub(super) &'a Quantity);

impl<'de> DeserializeSeed<'de> for Reader<'_> {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<f64, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl Visitor<'_> for Reader<'_> {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} such as {}", self.0.name, self.0.example)
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<f64, E> {
        self.0.check(value).map_err(E::custom)
    }

    #[allow(clippy::cast_precision_loss)] // as if it had been written with a decimal point
    fn visit_i64<E: Error>(self, value: i64) -> Result<f64, E> {
        self.visit_f64(value as f64)
    }

    #[allow(clippy::cast_precision_loss)]
    fn visit_u64<E: Error>(self, value: u64) -> Result<f64, E> {
        self.visit_f64(value as f64)
    }

    #[allow(clippy::cast_precision_loss)]
    fn visit_i128<E: Error>(self, value: i128) -> Result<f64, E> {
        self.visit_f64(value as f64)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<f64, E> {
        self.0.parse(text).map_err(E::custom)
    }
}

/// A number, or one of a few words.
struct OrWord<'a> {
    quantity: &'a Quantity,
    words: &'static [(&'static str, f64)],
}

impl Visitor<'_> for OrWord<'_> {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Reader(self.quantity).expecting(f)?;
        self.words.iter().try_for_each(|(word, _)| write!(f, ", or \"{word}\""))
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<f64, E> {
        Reader(self.quantity).visit_f64(value)
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<f64, E> {
        Reader(self.quantity).visit_i64(value)
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<f64, E> {
        if let Some((_, value)) = self.words.iter().find(|(word, _)| *word == text.trim()) {
            return Ok(*value);
        }
        self.quantity.parse(text).map_err(|message| {
            let words: Vec<_> = self.words.iter().map(|(word, _)| format!("\"{word}\"")).collect();
            E::custom(format!("{message}; or write {}", words.join(", ")))
        })
    }
}

macro_rules! checked {
    ($($(#[$doc:meta])* $name:ident: $quantity:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $name(
            /// In SI.
            pub f64,
        );

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(Reader(&$quantity)).map(Self)
            }
        }
    )*};
}

checked! {
    /// A radius or diameter.
    Length: LENGTH;
    /// A Young's modulus.
    Modulus: MODULUS;
    /// A yield strength.
    Strength: STRENGTH;
    /// A density.
    Density: DENSITY;
    /// A speed.
    Speed: SPEED;
    /// A load.
    Load: LOAD;
    /// An indentation.
    Depth: INDENTATION;
    /// A Poisson's ratio.
    PoissonsRatio: POISSONS_RATIO;
    /// A relative tolerance.
    Tolerance: TOLERANCE;
}

/// The sphere's Young's modulus; infinite if "rigid".
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphereModulus(
    /// In Pa.
    pub f64,
);

impl<'de> Deserialize<'de> for SphereModulus {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let visitor = OrWord { quantity: &SPHERE_MODULUS, words: &[("rigid", f64::INFINITY)] };
        deserializer.deserialize_any(visitor).map(Self)
    }
}

/// The exponent of the unloading branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponent(pub UnloadingExponent);

impl From<f64> for Exponent {
    fn from(value: f64) -> Self {
        Self(match value {
            1.5 => UnloadingExponent::Paper,
            _ if value.is_infinite() => UnloadingExponent::PressureShape,
            _ => UnloadingExponent::Fixed(value),
        })
    }
}

impl<'de> Deserialize<'de> for Exponent {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        // infinity, which no number of the range is, stands for the word between reader and type
        let visitor = OrWord { quantity: &EXPONENT, words: &[("pressure-shape", f64::INFINITY)] };
        deserializer.deserialize_any(visitor).map(Self::from)
    }
}

/// Rows of a trace.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Samples(pub usize);

impl<'de> Deserialize<'de> for Samples {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a whole number within SAMPLES
        whole(deserializer, &SAMPLES).map(|samples| Self(samples as usize))
    }
}

/// Steps of the fixed-step method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Steps(pub u32);

impl<'de> Deserialize<'de> for Steps {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a whole number within STEPS
        whole(deserializer, &STEPS).map(|steps| Self(steps as u32))
    }
}

fn whole<'de, D: Deserializer<'de>>(deserializer: D, quantity: &Quantity) -> Result<f64, D::Error> {
    let value = deserializer.deserialize_any(Reader(quantity))?;
    if value.fract() == 0.0 {
        return Ok(value);
    }
    Err(D::Error::custom(format!("{value} is not allowed: {} must be a whole number", quantity.name)))
}

/// A method by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MethodName(pub Method);

impl<'de> Deserialize<'de> for MethodName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Method::ALL.iter().find(|(known, _)| *known == name).map(|(_, method)| Self(*method)).ok_or_else(|| {
            let names = || Method::ALL.iter().map(|(name, _)| *name);
            let guess = nearest(&name, names()).map_or_else(String::new, |near| format!(", did you mean \"{near}\"?"));
            let known: Vec<_> = names().map(|name| format!("\"{name}\"")).collect();
            D::Error::custom(format!("unknown method \"{name}\"{guess}; methods are {}", known.join(", ")))
        })
    }
}
