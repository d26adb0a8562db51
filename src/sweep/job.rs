//! The request for a table, and the finished table.

use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

use super::SweepError;
use super::partition::Partition;
use super::shard::Shard;
use super::sidecar::{Tally, sidecar_path, table_name};
use super::table::Format;
use crate::output::{Lock, OutputDirectory, remove};
use crate::plan::{Plan, Source};

/// A sweep to be run.
pub struct Job<'a> {
    /// The cases of the table.
    pub plan: &'a Plan,
    /// The shard to compute; `None` for the whole table.
    pub shard: Option<Shard>,
    /// The format of the table.
    pub format: Format,
    /// For Parquet: the axis that gets one file for every value; `None` for one file.
    pub partition: Option<Partition>,
    /// The directory that the table is written to.
    pub directory: &'a OutputDirectory,
    /// The scenario that the plan was read from.
    pub source: &'a Source,
    /// Called after every piece of rows: with the number of rows computed, including those of an earlier run, and the
    /// number of all rows of this shard.
    pub progress: &'a (dyn Fn(u64, u64) + Sync),
    /// Set to stop within a fraction of a second, unless a single row takes longer.
    pub is_cancelled: &'a AtomicBool,
}

impl Job<'_> {
    /// The name of the table in the directory: a file, or the folder of a divided table.
    pub fn name(&self) -> String {
        self.partition.as_ref().map_or_else(|| table_name(self.shard, self.format), Partition::folder)
    }

    /// The files of the table, as paths relative to the directory.
    pub fn files(&self) -> Vec<String> {
        self.partition.as_ref().map_or_else(|| vec![self.name()], Partition::files)
    }
}

/// A finished table, locked until it is dropped.
#[derive(Debug)]
pub struct Written {
    /// The file, or the folder of a divided table.
    pub table: PathBuf,
    /// Counts of rows and failures, and the distribution of e.
    pub tally: Tally,
    /// Rows that an earlier run had written.
    pub resumed: u64,
    /// Whether it is the whole table, not a shard.
    pub(super) is_whole: bool,
    /// Keeps other processes from writing the table.
    pub(super) _lock: Lock,
}

impl Written {
    /// To be called when the summary and the pictures are written too: removes the sidecar of a whole table. Until then
    /// the same command keeps the table and writes only what is missing beside it.
    pub fn close(&self) -> Result<(), SweepError> {
        if self.is_whole {
            let path = sidecar_path(&self.table);
            remove(&path).map_err(SweepError::file("cannot be removed", &path))?;
        }
        Ok(())
    }
}
