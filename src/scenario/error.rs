//! Why a scenario is refused.

use std::path::PathBuf;

use thiserror::Error;

use super::place::Refusal;

/// Why a scenario is refused.
#[derive(Debug, Error)]
pub enum ScenarioError {
    /// The file system says no.
    #[error("{}: cannot be read: {reason}", .path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: std::io::Error,
    },
    /// Larger than what is read.
    #[error("{}: is larger than {largest} MiB, the most that is read; write long lists as linspace or logspace, or split the file", .path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// In MiB.
        largest: u64,
    },
    /// Not UTF-8.
    #[error("{}:{line}: is not a text file (not UTF-8)", .path.display())]
    NotText {
        /// The file.
        path: PathBuf,
        /// Of the first byte that is no text.
        line: usize,
    },
    /// A `--set` that is no `key=value`.
    #[error("--set {text}: {problem}")]
    Override {
        /// As given.
        text: String,
        /// What is wrong.
        problem: String,
    },
    /// A key or a value.
    #[error("{0}")]
    Refused(Box<Refusal>),
}
