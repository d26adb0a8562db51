//! What is written about a run: files as text, and tables for the terminal. Nothing here opens a file or prints.

pub(crate) mod calibrate;
pub(crate) mod indentation;
pub mod inputs;
pub mod laws;
pub mod materials;
pub(crate) mod overview;
pub(crate) mod plan;
pub mod reference;
pub(crate) mod repeat;
pub(crate) mod rows;
pub(crate) mod summary;
pub mod sweep;
mod terminal;

pub use rows::trace;
pub use summary::summary;
pub use terminal::{Detail, impact as table};
