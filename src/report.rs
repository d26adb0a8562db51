//! What is written about an impact: `summary.json`, `trace.csv` and the table on the terminal. Pure functions of the
//! result; nothing here opens a file or prints.

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
    /// JSON refused a value.
    #[error("summary: {0}")]
    Json(#[from] serde_json::Error),
    /// CSV refused a row.
    #[error("trace: {0}")]
    Csv(#[from] csv::Error),
}
