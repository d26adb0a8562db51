//! Sweeps: many cases of one scene to one table, on all cores, in shards, resumable.
//!
//! A case number alone says what a row holds ([`crate::plan`]), so threads, shards and interruptions change nothing.
//! Pieces of rows are computed and encoded on all threads and put into the file in order (`ordered`), as text or as Parquet.
//! Memory does not grow with the number of rows.

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

use thiserror::Error;

use crate::output::OutputError;

pub use job::{Job, Progress, Written};
pub use partition::Partition;
pub use shard::Shard;
pub use table::Format;

/// Why a sweep did not finish.
#[derive(Debug, Error)]
pub enum SweepError {
    /// The file system says no; what is written so far stays, and can be resumed.
    #[error("{}: {problem}", .path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What was tried.
        problem: &'static str,
        /// Why not.
        source: io::Error,
    },
    /// The table has no place, or another process is writing it.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// A file that is not what it should be.
    #[error("{}: {problem}", .path.display())]
    Damaged {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        problem: String,
    },
    /// An unfinished table, or a shard, of something else.
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
        /// What else it belongs to.
        of: &'static str,
    },
    /// A table that another version wrote.
    #[error(
        "{}: {versions}; go on with that version, name another --out, or delete this file and its table to start over",
        .sidecar.display()
    )]
    Version {
        /// The table's sidecar.
        sidecar: PathBuf,
        /// Which version wrote it, and which this is.
        versions: String,
    },
    /// Stopped on request.
    #[error("interrupted after {rows} of {total} rows; the same command goes on from there ({})", .part.display())]
    Interrupted {
        /// Complete rows.
        rows: u64,
        /// All.
        total: u64,
        /// Where they are.
        part: PathBuf,
    },
    /// Stopped on request, with nothing to go on from.
    #[error("interrupted; a Parquet table starts over, csv and json can be resumed")]
    Dropped,
    /// A request that the build or the format does not allow.
    #[error("{0}")]
    Unsupported(&'static str),
    /// A key by which no table can be divided into files.
    #[error("--partition-by {key}: {}", if .of_words.is_empty() {
        "no axis of this [sweep] has words for values, such as law = [\"plm\", \"thornton\"]".to_owned()
    } else {
        format!("a table is divided by an axis of words, here by {}", .of_words.join(" or "))
    })]
    PartitionBy {
        /// As given.
        key: String,
        /// The axes that would do.
        of_words: Vec<&'static str>,
    },
    /// A file that would be read as part of a data set.
    #[error("{}: is not of this table, and would be read as part of it; move or delete it, or name another --out", .0.display())]
    Stray(PathBuf),
    /// No place for a merged table.
    #[error("--out {}: {problem}; name another file", .path.display())]
    Place {
        /// Where it was to go.
        path: PathBuf,
        /// What is wrong with that.
        problem: &'static str,
    },
    /// Shards that do not make a table.
    #[error("these shards do not make a table:\n  {}", .0.join("\n  "))]
    Shards(Vec<String>),
}

impl SweepError {
    /// A file error, for `map_err`.
    pub(crate) fn file(problem: &'static str, path: &Path) -> impl Fn(io::Error) -> Self {
        let path = path.to_owned();
        move |source| Self::File { path: path.clone(), problem, source }
    }
}
