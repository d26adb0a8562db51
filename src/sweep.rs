//! Sweeps: many cases of one scene are written to one table. A sweep uses all cores, can be divided into shards, and
//! can be resumed.
//!
//! A row depends on its case number alone ([`crate::plan`]), so threads, shards and interruptions do not change the
//! table. Pieces of rows are computed and encoded on all threads and written to the file in order (`ordered`), as text
//! or as Parquet. Memory does not grow with the number of rows.

pub mod caution;
mod column;
pub mod count;
pub mod driver;
pub mod evaluator;
pub mod job;
pub mod merge;
mod ordered;
pub mod pace;
#[cfg(feature = "parquet")]
pub mod parquet;
pub mod partition;
pub mod seal;
pub mod shard;
pub mod sidecar;
pub mod statistics;
pub mod table;
pub mod throughput;

use std::io;
use std::path::{Path, PathBuf};

use crate::error::{Error, ErrorKind};
use crate::output::OutputError;

pub use job::{Job, Written};
pub use partition::Partition;
pub use shard::Shard;
pub use table::Format;

/// Why a sweep did not finish.
#[derive(Debug, thiserror::Error)]
pub enum SweepError {
    /// The file system reported an error. The rows written so far stay, and can be resumed.
    #[error("{}: {problem}", .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What failed, such as `cannot be written`.
        problem: &'static str,
        /// The error of the file system.
        source: io::Error,
    },
    /// The table cannot be written to its directory, or another process is writing it.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A file does not hold what the program wrote into it.
    #[error("{}: {problem}", .path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// The file holds unfinished rows or a shard of another sweep.
    #[error(
        "{}: holds {what} of {of} (sidecar {}); go on as it was begun, name another --out, or delete both files to start over",
        .table.display(), .sidecar.display()
    )]
    Changed {
        /// The table.
        table: PathBuf,
        /// Its sidecar.
        sidecar: PathBuf,
        /// `unfinished rows` or `a shard`.
        what: &'static str,
        /// The other sweep or machine that the rows belong to.
        of: &'static str,
    },
    /// Another version of the program wrote the table.
    #[error(
        "{}: {versions}; go on with that version, name another --out, or delete this file and its table to start over",
        .sidecar.display()
    )]
    Version {
        /// The table's sidecar.
        sidecar: PathBuf,
        /// The version that wrote the table, and the version of this program.
        versions: String,
    },
    /// Stopped on request.
    #[error("interrupted after {rows} of {total} rows; the same command goes on from there ({})", .part.display())]
    Interrupted {
        /// Rows that are complete.
        rows: u64,
        /// All rows of the table or shard.
        total: u64,
        /// The unfinished table.
        part: PathBuf,
    },
    /// Stopped on request; the rows are lost, because a Parquet table cannot be resumed.
    #[error("interrupted; a Parquet table starts over, csv and json can be resumed")]
    Dropped,
    /// A request that the build or the format does not allow.
    #[error("{0}")]
    Unsupported(&'static str),
    /// The table cannot be divided into files by this key.
    #[error("--partition-by {key}: {}", if .of_words.is_empty() {
        "no axis of this [sweep] has words for values, such as law = [\"plm\", \"thornton\"]".to_owned()
    } else {
        format!("a table is divided by an axis of words, here by {}", .of_words.join(" or "))
    })]
    PartitionBy {
        /// The key as the user gave it.
        key: String,
        /// The axes by which this table can be divided.
        of_words: Vec<&'static str>,
    },
    /// Another file lies in the folder of a divided table, and would be read as part of the table.
    #[error("{}: is not of this table, and would be read as part of it; move or delete it, or name another --out", .0.display())]
    Stray(PathBuf),
    /// The merged table cannot be written to this path.
    #[error("--out {}: {problem}; name another file", .path.display())]
    Place {
        /// The path that was asked for.
        path: PathBuf,
        /// Why the table cannot be written there.
        problem: &'static str,
    },
    /// The shards do not make one table; each text names one problem.
    #[error("these shards do not make a table:\n  {}", .0.join("\n  "))]
    Shards(Vec<String>),
}

impl From<SweepError> for Error {
    fn from(error: SweepError) -> Self {
        let kind = match &error {
            SweepError::File { .. } => ErrorKind::Failed,
            SweepError::Interrupted { .. } | SweepError::Dropped => ErrorKind::Stopped(130),
            _ => ErrorKind::Input,
        };
        let told = Self::of(kind, &error);
        match error {
            SweepError::Output(error) => error.into(),
            SweepError::File { path, .. }
            | SweepError::Damaged { path, .. }
            | SweepError::Changed { table: path, .. }
            | SweepError::Version { sidecar: path, .. }
            | SweepError::Place { path, .. } => told.about(path.display()),
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
}
