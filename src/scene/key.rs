//! What a key of a scenario is: where it stands, what may be written there, what it means.

use super::Scene;
use super::quantity::Quantity;
use super::words::Words;

/// A numeric key of the scene of an impact: it can be an axis or a random variable.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// As in the file, with dots: `impact.speed`.
    pub path: &'static str,
    /// Dimension and allowed range.
    pub quantity: &'static Quantity,
    /// A word that may stand in place of the number; it is an infinite number in the scene.
    pub word: Option<&'static str>,
    /// What it is, in one sentence.
    pub about: &'static str,
    /// Its value where the scenario does not give it, in words; empty where there is none.
    pub default: &'static str,
    /// Its value in a scene, SI; `None` where the scene has none.
    pub get: fn(&Scene) -> Option<f64>,
    /// Puts a checked value, SI, into a scene.
    pub set: fn(&mut Scene, f64),
}

/// A key of any kind, as it is read and described.
#[derive(Debug, Clone, Copy)]
pub struct AnyKey {
    /// As in the file, with dots; `[]` stands behind the name of a list of tables.
    pub path: &'static str,
    /// How its value is written.
    pub form: Form,
    /// What it is, in one sentence.
    pub about: &'static str,
    /// Its value where the scenario does not give it, in words; empty where there is none.
    pub default: &'static str,
}

/// How a value is written.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// A number in SI, or a text with a unit, or the word.
    Number(&'static Quantity, Option<&'static str>),
    /// A whole number.
    Count(&'static Quantity),
    /// A list of numbers.
    Numbers(&'static Quantity),
    /// A list of pairs of numbers.
    Pairs(&'static Quantity, &'static Quantity),
    /// One of some words.
    Word(&'static Words),
    /// A list of such words.
    WordList(&'static Words),
    /// Any text, such as this one.
    Text(&'static str),
    /// The axes of a table, by the keys that vary.
    Axes,
    /// The random variables of a table, by the keys that vary.
    Variables,
    /// Numeric keys that a calibration finds, with their ranges.
    Free,
    /// A word, or a table with keys of its own.
    WordOrTable(&'static Words),
}

impl Key {
    /// The name of its column in tables, with its unit: `impact_speed_m_per_s`.
    pub fn column(&self) -> String {
        format!("{}{}", self.path.replace('.', "_"), self.quantity.dimension.suffix())
    }
}
