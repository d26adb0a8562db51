//! Sweeps: many cases of one scene are written to one table. A sweep uses all cores, can be divided into shards, and
//! can be resumed.
//!
//! A row depends on its case number alone ([`crate::scenario::plan`]), and the rows of part k of a table on k alone ([`parts`]). So
//! threads, shards and interruptions do not change the table: a part is there as a whole or not at all, and a run computes
//! the parts that are missing ([`job`]). Memory does not grow with the number of rows.

pub mod chunks;
pub mod corner_warnings;
pub mod evaluator;
pub mod format;
pub mod job;
mod missing_parts;
pub mod parts;
pub mod shard;
pub mod statistics;
pub(crate) mod table_files;
pub mod tally;
pub mod traces;

pub use chunks::compute_rows;
pub use evaluator::{Evaluator, RowFailure, Rows};
pub use format::Format;
pub use job::FinishedTable;
pub use parts::PartLayout;
pub use shard::Shard;
pub use table_files::TableJob;
pub use tally::{Tally, classify};

use std::io;
use std::path::Path;

use crate::error::{Error, ErrorKind};

/// The error of a table that cannot be written.
pub(crate) fn unwritable_table_error(path: &Path) -> impl Fn(io::Error) -> Error {
    Error::from_io(
        ErrorKind::Failed,
        path,
        "cannot be written",
        "free space on the disk, then run the same command again",
    )
}
