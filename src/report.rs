//! What is written about a run: files as text, and tables for the terminal. Nothing here opens a file or prints.

pub(crate) mod calibrate;
pub(crate) mod compare;
pub(crate) mod indentation;
pub mod inputs;
pub mod laws;
pub mod materials;
pub(crate) mod overview;
pub(crate) mod plan;
pub(crate) mod repeat;
pub mod resolved;
pub(crate) mod rows;
pub(crate) mod strength;
pub(crate) mod summary;
pub mod sweep;
mod terminal;

use thiserror::Error;

pub use rows::trace;
pub use summary::summary;
pub use terminal::impact as table;

/// Why a report could not be made.
#[derive(Debug, Error)]
pub enum ReportError {
    /// A value cannot be written as JSON.
    #[error("summary: {0}")]
    Json(#[from] serde_json::Error),
    /// A row cannot be written as CSV.
    #[error("trace: {0}")]
    Csv(#[from] csv::Error),
}
