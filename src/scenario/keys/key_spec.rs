//! A key of a scenario: its path, the form of its value, and its meaning.

use super::Quantity;

#[derive(Debug, Clone, Copy)]
pub struct KeySpec {
    /// With dots; `[]` stands behind the name of a list of tables.
    pub path: &'static str,
    pub part: Part,
    pub form: ValueForm,
    /// Its value if the scenario does not give it, in words; empty for a key without a default.
    pub default: &'static str,
    /// The meaning, in one sentence.
    pub description: &'static str,
}

/// The part of a scene that a key describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    Sphere,
    HalfSpace,
    /// Numbers of the bodies that only matter for a motion: masses, and the plate.
    Motion,
    /// The flow stress of a body.
    Flow,
    /// The strain-rate hardening.
    Rate,
    Law,
    /// Gravity and damping.
    Forces,
    /// Shot peening: coverage, mass flow and area.
    Peening,
    /// The arrival of the sphere: all keys that change from impact to impact on one contact.
    Approach,
    Solver,
    Output,
    /// A kind of scenario with its own table, such as `[repeat]`.
    Kind,
}

impl Part {
    /// True if such a key changes bodies, law or forces, and so the contact.
    pub fn changes_contact(self) -> bool {
        !matches!(self, Self::Approach | Self::Solver | Self::Output)
    }

    /// True if a quasi-static indentation may depend on such a key.
    pub fn is_static(self) -> bool {
        matches!(self, Self::Sphere | Self::HalfSpace | Self::Flow | Self::Law)
    }

    /// True if such a key changes the law or its flow curve.
    pub fn changes_law(self) -> bool {
        matches!(self, Self::Law | Self::Flow)
    }
}

/// The form of a value.
#[derive(Debug, Clone, Copy)]
pub enum ValueForm {
    /// A number in SI, or a text with a unit.
    Number(&'static Quantity),
    NumberOr(&'static Quantity, &'static str),
    /// A whole number.
    Count(&'static Quantity),
    /// true or false, as the number 1 or 0.
    Flag,
    Numbers(&'static Quantity),
    /// A list of points of a flow curve.
    Points,
    Word(&'static WordList),
    /// A list of such words.
    Words(&'static WordList),
    /// A word, or a table with keys of its own.
    WordOrTable(&'static WordList),
    /// Any text; the field is an example.
    Text(&'static str),
    /// The name of a file; the field is an example.
    File(&'static str),
    /// The axes of a table, by the varied keys.
    Axes,
    /// The random variables of a table, by the varied keys.
    Variables,
    /// The free numeric keys of a calibration, with their ranges.
    Free,
}

/// Words that a key takes.
#[derive(Debug)]
pub struct WordList {
    /// The name of one of them in messages.
    pub singular: &'static str,
    /// The name of several of them in messages.
    pub plural: &'static str,
    pub values: fn() -> Vec<String>,
}

impl KeySpec {
    /// The quantity of a number, and the word that may replace it.
    pub fn number(&self) -> Option<(&'static Quantity, Option<&'static str>)> {
        match self.form {
            ValueForm::Number(quantity) => Some((quantity, None)),
            ValueForm::NumberOr(quantity, word) => Some((quantity, Some(word))),
            _ => None,
        }
    }
}

/// A list of tables, each item with the keys below its path.
#[derive(Debug)]
pub struct TableList {
    pub path: &'static str,
    /// An example of the list.
    pub example: &'static str,
    /// Describes an item in messages.
    pub item: &'static str,
}

/// How steps of an indentation are written.
pub const STEPS_EXAMPLE: &str = "steps = [{ load = \"200 N\" }, { load = \"0 N\" }]";

pub const TABLE_LISTS: [TableList; 2] = [
    TableList {
        path: "indentation.steps[]",
        example: STEPS_EXAMPLE,
        item: "a step such as { load = \"200 N\" } or { indentation = \"12 um\" }",
    },
    TableList {
        path: "indentation.half_space[]",
        example: "[[indentation.half_space]] with a name",
        item: "a table with a name",
    },
];
