//! The keys of a scenario, their values as they are written, and the numbers that follow from these.

pub(crate) mod at;
pub(crate) mod body_material;
mod effect;
mod flight;
pub mod input;
pub mod interval;
pub mod key;
pub mod keys;
mod laws;
pub mod list;
pub mod measured;
pub mod quantity;
pub(crate) mod read;
mod resolve;
#[doc(hidden)]
pub mod results;
mod strength;
pub(crate) mod tables;
pub mod words;
pub(crate) mod written;

pub(crate) use at::{At, COUNT, NUMBER, OTHER, WORD, at, key_of, known};
pub(crate) use body_material::{Body, BodyMaterial};
pub use effect::{Purpose, without_effect};
pub use input::{Input, KeyValue, Value};
pub use interval::{HardnessRanges, RestitutionInterval, SMALL, Uncertainty, restitution_interval, strength_notes};
pub use key::{AnyKey, Form, Part, Words};
pub use keys::{BODIES, EITHER, KEYS, Key, NEEDED, SPHERE, partner, varied};
pub use list::EVERY_KEY;
pub use measured::Measured;
pub use quantity::Quantity;
