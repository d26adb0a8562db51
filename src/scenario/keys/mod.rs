//! The keys of a scenario, their values as they are written, and the numbers that follow from these.

mod flight;
pub mod interval;
pub(crate) mod key_id;
pub mod key_spec;
pub mod list;
pub mod quantity;
pub mod words;

pub(crate) use key_id::{COUNT, KeyId, NUMBER, OTHER, WORD, body_key, find_key, key};

pub use interval::{
    HardnessRanges, RestitutionInterval, SMALL, Uncertainty, dent_interval, restitution_interval, strength_notes,
};
pub use key_spec::{KeySpec, Part, ValueForm, WordList};

pub use list::ALL_KEYS;

pub use quantity::Quantity;
