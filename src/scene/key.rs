//! What is known of a key of a scenario: where it stands, what may be written there, what it means.

use super::quantity::Quantity;

/// A key of any kind, as it is described.
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
    /// The way to its field: the number of the field in each table.
    pub way: &'static [usize],
}

/// How a value is written.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// A number in SI, or a text with a unit.
    Number(&'static Quantity),
    /// The same, or the word.
    NumberOr(&'static Quantity, &'static str),
    /// A whole number.
    Count(&'static Quantity),
    /// A pair of numbers.
    Pair(&'static Quantity, &'static Quantity),
    /// One of some words.
    Word(&'static Words),
    /// Any text, such as this one.
    Text(&'static str),
    /// A list of such values.
    List(&'static Form),
    /// The axes of a table, by the keys that vary.
    Axes,
    /// The random variables of a table, by the keys that vary.
    Variables,
    /// Numeric keys that a calibration finds, with their ranges.
    Free,
    /// A word, or a table with keys of its own.
    WordOrTable(&'static Words),
    /// A table with keys of its own.
    Table,
    /// A list of tables with keys of their own: how it is written, and what an item of it is.
    Items(&'static str, &'static str),
}

/// Words that a key takes.
#[derive(Debug)]
pub struct Words {
    /// What one of them is called in messages.
    pub one: &'static str,
    /// What several of them are called in messages.
    pub several: &'static str,
    /// All of them.
    pub known: fn() -> Vec<String>,
}
