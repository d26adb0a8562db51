//! The request for a table, and its files.

use std::ops::Range;
use std::path::{Path, PathBuf};

use super::PartLayout;
use super::format::{Format, TableEncoder};
use super::shard::Shard;
use super::tally::RowOutcome;
use crate::error::Error;
use crate::files::parts_folder::{PARTS_FOLDER, file_error};
use crate::files::{OutputDirectory, Progress};
use crate::scenario::ScenarioSource;
use crate::scenario::plan::Plan;

/// A sweep to be run.
pub struct TableJob<'a> {
    /// The cases of the table.
    pub plan: &'a Plan,
    /// The shard to compute; `None` for the whole table.
    pub shard: Option<Shard>,
    pub format: Format,
    pub layout: PartLayout,
    /// The directory that the table is written to.
    pub directory: &'a OutputDirectory,
    /// The scenario that the plan was read from.
    pub source: &'a ScenarioSource,
    /// Counts the rows that are computed or resumed. If it is stopped, the job ends within a fraction of a second, unless a single
    /// row takes longer.
    pub progress: &'a Progress,
}

/// A table in one form.
pub(super) struct TableWriter<'a, F> {
    pub job: &'a TableJob<'a>,
    pub form: &'a F,
    pub layout: PartLayout,
    /// The name of the table as one file.
    pub name: String,
}

impl<F: TableEncoder> TableWriter<'_, F> {
    pub fn path(&self, name: &str) -> PathBuf {
        self.job.directory.path().join(name)
    }

    pub fn part_path(&self, part: u64) -> PathBuf {
        // enough digits, so that the names sort in the order of the parts
        self.path(PARTS_FOLDER).join(format!("part-{part:05}.{}", self.job.format.name()))
    }

    /// Reads a file that should have these cases. Returns true if the file is complete.
    pub fn read_part(&self, path: &Path, cases: Range<u64>, count: &mut dyn FnMut(RowOutcome)) -> Result<bool, Error> {
        self.form.read(path, cases.end - cases.start, count).map_err(file_error("cannot be read", path))
    }
}
