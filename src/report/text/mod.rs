//! Texts about a run: files, and blocks for people. Nothing here opens a file or prints.

pub mod blocks;
pub mod calibrate;
pub mod check;
pub mod contact_trace;
pub(crate) mod files;
pub mod indentation;
pub mod inputs;
pub mod laws;
pub mod materials;
pub(crate) mod overview;
pub(crate) mod plan;
pub(crate) mod series;
pub mod sweep;
mod terminal;
pub mod testers;
pub(crate) mod traces;
pub mod units;

pub use blocks::{Block, note_blocks, to_text};
pub use files::trace_csv;
pub(crate) use files::{pulse_csv, spectrum_csv};
pub use terminal::{Detail, impact_blocks};
