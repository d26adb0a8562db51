//! The keys of a scenario, their values as they are written, and the numbers that follow from these.

pub(crate) mod at;
pub mod band;
pub(crate) mod body_material;
mod effect;
pub mod input;
pub mod key;
pub mod keys;
mod laws;
pub mod list;
pub mod measured;
pub mod quantity;
pub(crate) mod read;
mod resolve;
pub(crate) mod results;
mod strength;
pub(crate) mod tables;
pub mod words;
pub(crate) mod written;

pub use effect::{Purpose, without_effect};
pub use input::Input;
pub use keys::{EITHER, KEYS, Key};
pub use list::EVERY_KEY;
