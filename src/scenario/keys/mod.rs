//! The keys of a scenario, their values as they are written, and the numbers that follow from these.

mod flight;
pub mod interval;
pub mod key;
pub(crate) mod key_id;
pub mod list;
pub mod quantity;
pub mod words;

pub(crate) use key_id::{At, COUNT, NUMBER, OTHER, WORD, at, key_of, known};

pub use interval::{HardnessRanges, RestitutionInterval, SMALL, Uncertainty, restitution_interval, strength_notes};
pub use key::{AnyKey, Form, Part, Words};

pub use list::EVERY_KEY;

pub use quantity::Quantity;
