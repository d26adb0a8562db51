//! What is asked of a table, and what comes of it.

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
    /// What is swept.
    pub plan: &'a Plan,
    /// Which part of it; `None`: all, with nothing to be merged.
    pub shard: Option<Shard>,
    /// What is written.
    pub format: Format,
    /// Parquet: the axis that has a file for every value; `None`: one file.
    pub partition: Option<Partition>,
    /// Where.
    pub directory: &'a OutputDirectory,
    /// The scenario that the plan is of.
    pub source: &'a Source,
    /// Told now and then how far it is.
    pub progress: &'a (dyn Fn(Progress) + Sync),
    /// Set to stop within a fraction of a second, unless a single row takes longer.
    pub is_cancelled: &'a AtomicBool,
}

impl Job<'_> {
    /// The name of the table in the directory: of a file, or of the folder that a divided table is.
    pub fn name(&self) -> String {
        self.partition.as_ref().map_or_else(|| table_name(self.shard, self.format), Partition::folder)
    }

    /// The names of its files, as seen from the directory.
    pub fn files(&self) -> Vec<String> {
        self.partition.as_ref().map_or_else(|| vec![self.name()], Partition::files)
    }
}

/// How far a sweep is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Rows computed, those of an earlier run included.
    pub rows: u64,
    /// All rows of this shard.
    pub total: u64,
    /// Rows of an earlier run.
    pub resumed: u64,
}

/// A finished table, locked until it is dropped.
#[derive(Debug)]
pub struct Written {
    /// The file.
    pub table: PathBuf,
    /// Rows, failures, distribution of e.
    pub tally: Tally,
    /// Rows that an earlier run had written.
    pub resumed: u64,
    /// Whether it is no shard.
    pub(super) is_whole: bool,
    /// Keeps other processes away.
    pub(super) _lock: Lock,
}

impl Written {
    /// Says that all that belongs beside the table is there too. Until then the same command goes on from the table.
    ///
    /// # Errors
    /// [`SweepError::File`].
    pub fn close(&self) -> Result<(), SweepError> {
        if self.is_whole {
            let path = sidecar_path(&self.table);
            remove(&path).map_err(SweepError::file("cannot be removed", &path))?;
        }
        Ok(())
    }
}
