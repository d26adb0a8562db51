//! Numbers and texts with units, read and checked while the file is, so that a bad value is shown where it stands.

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, Visitor};

use super::quantity::Quantity;

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
pub(super) struct OrWord<'a> {
    pub(super) quantity: &'a Quantity,
    pub(super) words: &'static [(&'static str, f64)],
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

/// A whole number.
pub(super) fn whole<'de, D: Deserializer<'de>>(deserializer: D, quantity: &Quantity) -> Result<f64, D::Error> {
    let value = deserializer.deserialize_any(Reader(quantity))?;
    if value.fract() == 0.0 {
        return Ok(value);
    }
    Err(D::Error::custom(format!("{value} is not allowed: {} must be a whole number", quantity.name)))
}
