//! The division of a table into parts, and the file that identifies the table of the parts in a folder.

use std::ops::Range;
use std::{fs, io};

use serde::Serialize;
use serde_json::Value;

use super::format::Format;
use super::shard::Shard;
use crate::error::Error;
use crate::files::parts_folder::{IDENTITY_FILE, PARTS_FOLDER, file_error};
use crate::files::{FORMAT_VERSION, OutputDirectory, RESULTS_VERSION, VERSION, create};
use crate::scenario::ScenarioSource;
use crate::scenario::plan::Plan;

/// A table of at most this number of parts is written as one file: about a second of work.
pub const MAX_PARTS_OF_ONE_FILE: u64 = 16;
/// CSV is joined to one file up to this number of rows.
pub const MAX_JOINED_ROWS: u64 = 10_000_000;
/// The maximum number of rows of a part.
const MAX_ROWS_PER_PART: u64 = 1 << 18;
/// The maximum number of parts: a folder with more files is slow.
const MAX_PARTS: u64 = 1 << 16;

/// The parts of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PartLayout {
    pub rows: u64,
    /// Rows of a part; the last part may have fewer.
    pub rows_per_part: u64,
}

impl PartLayout {
    /// The parts of this plan have the rows of about 65 ms on one core. That follows from the number of rows and from the method
    /// alone, so that the parts of all runs fit together.
    pub fn new(plan: &Plan) -> Self {
        let at_most = 65_536.0 / plan.row_time_us();
        // a power of two
        let mut rows_per_part = MAX_ROWS_PER_PART;
        while rows_per_part > 16 && rows_per_part as f64 > at_most {
            rows_per_part /= 2;
        }
        let rows = plan.n_cases();
        Self { rows, rows_per_part: rows_per_part.max(rows.div_ceil(MAX_PARTS).next_multiple_of(16)) }
    }

    /// True if the table is written in parts, from which the same command resumes: a shard, a large table, or one that was begun in
    /// parts.
    pub fn is_split(&self, shard: Option<Shard>, directory: &OutputDirectory) -> bool {
        shard.is_some() || self.n_parts() > MAX_PARTS_OF_ONE_FILE || directory.path().join(IDENTITY_FILE).exists()
    }

    /// The number of parts.
    pub fn n_parts(&self) -> u64 {
        self.rows.div_ceil(self.rows_per_part)
    }

    pub fn part_cases(&self, part: u64) -> Range<u64> {
        let first = part * self.rows_per_part;
        first..self.rows.min(first.saturating_add(self.rows_per_part))
    }
}

/// The description of the table to which the parts in a folder belong. Tables with equal descriptions have the same bytes.
#[derive(Debug, Serialize)]
pub struct TableIdentity {
    format_version: u64,
    version: String,
    numbers: u64,
    format: Format,
    rows: u64,
    rows_per_part: u64,
    #[serde(flatten)]
    scenario: ScenarioSource,
}

impl TableIdentity {
    /// The table that was read from `scenario`.
    pub fn new(scenario: &ScenarioSource, format: Format, layout: PartLayout) -> Self {
        Self {
            format_version: FORMAT_VERSION,
            version: VERSION.to_owned(),
            numbers: RESULTS_VERSION,
            format,
            rows: layout.rows,
            rows_per_part: layout.rows_per_part,
            scenario: scenario.clone(),
        }
    }

    fn to_text(&self) -> String {
        serde_json::to_string_pretty(self).unwrap_or_default() + "\n"
    }

    /// True if the table was begun in parts here, perhaps by another process. Parts of another table are refused, or removed
    /// by force.
    pub fn matches_parts_in(&self, directory: &OutputDirectory) -> Result<bool, Error> {
        let (path, folder) = (directory.path().join(IDENTITY_FILE), directory.path().join(PARTS_FOLDER));
        let there = fs::read_to_string(&path);
        if there.as_ref().is_ok_and(|there| *there == self.to_text()) {
            return Ok(true);
        }
        if directory.is_forced() || !directory.has_parts()? {
            directory.clear_parts()?;
            return Ok(false);
        }
        let difference = match there {
            Ok(there) => self.difference(&there),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                format!("of an unknown table ({IDENTITY_FILE} is missing)")
            }
            Err(error) => return Err(file_error("cannot be read", &path)(error)),
        };
        let way_out = "Resume with the original command, choose another --out, or use --force to start over.";
        Err(Error::for_path(&folder, format!("these parts are {difference}. {way_out}")))
    }

    /// Writes it into a folder that has none.
    ///
    /// # Errors
    /// [`Error`] if another process has written that of another table in the meantime.
    pub fn create(&self, directory: &OutputDirectory) -> Result<(), Error> {
        let path = directory.path().join(IDENTITY_FILE);
        match create(&path, self.to_text().as_bytes()) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => match fs::read_to_string(&path) {
                Ok(there) if there != self.to_text() => Err(Error::for_path(
                    &path,
                    format!("another process has begun a table {}", self.difference(&there)),
                )),
                _ => Ok(()),
            },
            result => result.map_err(file_error("cannot be written", &path)),
        }
    }

    /// The first entry in which another table differs.
    fn difference(&self, there: &str) -> String {
        let object = |text: &str| serde_json::from_str::<serde_json::Map<String, Value>>(text).ok();
        let (Some(ours), Some(theirs)) = (object(&self.to_text()), object(there)) else {
            return format!("of an unknown table ({IDENTITY_FILE} cannot be read)");
        };
        let Some((name, own)) = ours.iter().find(|(name, own)| theirs.get(*name) != Some(own)) else {
            return "of another version of the program".to_owned();
        };
        let other = theirs.get(name).unwrap_or(&Value::Null);
        let lines = |text: &Value| text.as_str().unwrap_or_default().lines().map(str::to_owned).collect::<Vec<_>>();
        let (own_lines, other_lines) = (lines(own), lines(other));
        match (1..).zip(own_lines.iter().zip(&other_lines)).find(|(_, (own, other))| own != other) {
            Some((line, (own, other))) if own_lines.len() > 1 => {
                format!("of another table: line {line} of its {name} is `{other}`, now `{own}`")
            }
            _ => format!("of another table: its {name} is {other}, now {own}"),
        }
    }
}
