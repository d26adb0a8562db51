//! Sweeps: many cases of one scene are written to one table. A sweep uses all cores, can be divided into shards, and
//! can be resumed.
//!
//! A row depends on its case number alone ([`crate::plan`]), and the rows of part k of a table on k alone ([`parts`]). So
//! threads, shards and interruptions do not change the table: a part is there as a whole or not at all, and a run computes
//! the parts that are missing ([`job`]). Memory does not grow with the number of rows.

pub mod caution;
mod column;
pub mod count;
pub mod csv;
pub mod evaluator;
pub mod form;
pub mod job;
mod ordered;
#[cfg(feature = "parquet")]
mod parquet;
pub mod parts;
pub mod shard;
pub mod statistics;
pub mod throughput;

use std::io;
use std::path::{Path, PathBuf};

use crate::error::{Error, ErrorKind};
use crate::output::OutputError;

pub use form::Format;
pub use job::{Job, Written};
pub use shard::Shard;

/// Why a sweep did not finish.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// The file system reported an error. The parts written so far stay.
    #[error("{}: {problem}", .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What failed, such as `cannot be written`.
        problem: &'static str,
        /// The error of the file system.
        source: io::Error,
    },
    /// The table cannot be written to its directory.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A file does not hold what the program wrote into it.
    #[error("{}: {problem}", .path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong, and the way out.
        problem: String,
    },
    /// The folder holds parts of another table.
    #[error("{}: these parts are {difference}; go on as they were begun, name another --out, or start over with --force", .path.display())]
    Changed {
        /// The folder of the parts.
        path: PathBuf,
        /// In what the other table differs.
        difference: String,
    },
    /// Stopped on request.
    #[error("interrupted after {rows} of {total} rows; {}", if *.is_in_parts {
        "the same command goes on from the parts that are whole"
    } else {
        "nothing was written, as a table of this size is written at once; the same command starts anew"
    })]
    Interrupted {
        /// Rows that were computed or found.
        rows: u64,
        /// All rows of the table or shard.
        total: u64,
        /// Whether they are in parts.
        is_in_parts: bool,
    },
    /// A request that the build does not allow.
    #[error("{0}")]
    Unsupported(&'static str),
}

impl From<SweepError> for Error {
    fn from(error: SweepError) -> Self {
        let kind = match &error {
            SweepError::File { .. } => ErrorKind::Failed,
            SweepError::Interrupted { .. } => ErrorKind::Stopped(130),
            _ => ErrorKind::Input,
        };
        let told = Self::of(kind, &error);
        match error {
            SweepError::Output(error) => error.into(),
            SweepError::File { path, .. } | SweepError::Damaged { path, .. } | SweepError::Changed { path, .. } => {
                told.about(path.display())
            }
            _ => told,
        }
    }
}

impl SweepError {
    /// Makes a [`SweepError::File`] from an error of the file system, for `map_err`.
    pub(crate) fn file(problem: &'static str, path: &Path) -> impl Fn(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::File { path: path.clone(), problem, source }
    }

    /// Whether a file or a folder was gone.
    pub(crate) fn is_not_found(&self) -> bool {
        let (Self::File { source, .. } | Self::Output(OutputError::Unwritable { reason: source, .. })) = self else {
            return false;
        };
        source.kind() == io::ErrorKind::NotFound
    }
}
