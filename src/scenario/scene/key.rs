//! A key of a scenario: where it stands, what may be written there, and its meaning.

use super::Quantity;

#[derive(Debug, Clone, Copy)]
pub struct AnyKey {
    /// With dots; `[]` stands behind the name of a list of tables.
    pub path: &'static str,
    pub part: Part,
    pub form: Form,
    /// Its value where the scenario does not give it, in words; empty where there is none.
    pub default: &'static str,
    /// The meaning, in one sentence.
    pub about: &'static str,
}

/// The part of a scene that a key describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    Sphere,
    HalfSpace,
    /// Numbers of the bodies that only count where something moves: masses, and the plate.
    Motion,
    /// The flow stress of a body.
    Flow,
    /// How strengths rise with the rate of strain.
    Rate,
    Law,
    /// Gravity and damping.
    Forces,
    /// How the sphere comes in: all that changes from impact to impact on one contact.
    Approach,
    Solver,
    Output,
    /// A kind of scene with a table of its own, such as `[repeat]`.
    Kind,
}

impl Part {
    /// True if such a key changes bodies, law or forces, and so the contact.
    pub fn changes_contact(self) -> bool {
        !matches!(self, Self::Approach | Self::Solver | Self::Output)
    }

    /// True if a slow indentation may depend on such a key.
    pub fn is_static(self) -> bool {
        matches!(self, Self::Sphere | Self::HalfSpace | Self::Flow | Self::Law)
    }

    /// True if such a key changes the law or its flow curve.
    pub fn changes_law(self) -> bool {
        matches!(self, Self::Law | Self::Flow)
    }
}

/// How a value is written.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// A number in SI, or a text with a unit.
    Number(&'static Quantity),
    NumberOr(&'static Quantity, &'static str),
    /// A whole number.
    Count(&'static Quantity),
    Numbers(&'static Quantity),
    /// A list of points of a flow curve.
    Points,
    Word(&'static Words),
    /// A list of such words.
    Words(&'static Words),
    /// A word, or a table with keys of its own.
    WordOrTable(&'static Words),
    /// Any text, such as this one.
    Text(&'static str),
    /// The name of a file, such as this one.
    File(&'static str),
    /// The axes of a table, by the keys that vary.
    Axes,
    /// The random variables of a table, by the keys that vary.
    Variables,
    /// Numeric keys that a calibration finds, with their ranges.
    Free,
}

/// Words that a key takes.
#[derive(Debug)]
pub struct Words {
    /// The name of one of them in messages.
    pub one: &'static str,
    /// The name of several of them in messages.
    pub several: &'static str,
    pub known: fn() -> Vec<String>,
}

impl AnyKey {
    /// The quantity of a number, and the word that may stand in its place.
    pub fn number(&self) -> Option<(&'static Quantity, Option<&'static str>)> {
        match self.form {
            Form::Number(quantity) => Some((quantity, None)),
            Form::NumberOr(quantity, word) => Some((quantity, Some(word))),
            _ => None,
        }
    }
}

/// A list of tables, each item with the keys below its path.
#[derive(Debug)]
pub struct List {
    pub path: &'static str,
    /// Shows how the list is written.
    pub example: &'static str,
    /// Describes an item in messages.
    pub item: &'static str,
}

/// How steps of an indentation are written.
pub const STEPS: &str = "steps = [{ load = \"200 N\" }, { load = \"0 N\" }]";

pub const LISTS: [List; 2] = [
    List {
        path: "indentation.steps[]",
        example: STEPS,
        item: "a step such as { load = \"200 N\" } or { indentation = \"12 um\" }",
    },
    List {
        path: "indentation.half_space[]",
        example: "[[indentation.half_space]] with a name",
        item: "a table with a name",
    },
];
