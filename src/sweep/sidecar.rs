//! The file beside a table that says what the table is, so that only what belongs together is continued or merged; and the
//! reading of a table that was left unfinished.

use std::fs::{self, File};
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::SweepError;
use super::count::Count;
use super::shard::{Layout, Shard};
use super::statistics::Statistics;
use super::table::{Format, TextTable, read_line};
use crate::output::{PART, replace, with_suffix};
use crate::scenario::Source;

/// Version of the program, which makes the rows and what is written beside them.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// What a table is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sidecar {
    /// Version of the program.
    pub version: String,
    /// Hash of the scenario.
    pub scenario_sha256: String,
    /// The scenario itself, for what is written beside the whole table.
    pub scenario: Source,
    /// `csv` or `json`.
    pub format: String,
    /// Cases of all shards together.
    pub cases: u64,
    /// Cases a block.
    pub block: u64,
    /// Which shard, from 0 on.
    pub shard: u64,
    /// Of how many.
    pub shards: u64,
    /// Place of e among the columns.
    pub restitution_column: usize,
    /// Whether the values are random, so that e has a distribution.
    pub is_monte_carlo: bool,
}

impl Sidecar {
    /// How its rows are dealt out.
    #[must_use]
    pub fn layout(&self) -> Layout {
        Layout { total: self.cases, block: self.block, shard: Shard { index: self.shard, count: self.shards } }
    }

    /// Reads the sidecar of a table; `None` if there is none.
    ///
    /// # Errors
    /// [`SweepError`] if it cannot be read or is none.
    pub fn read(table: &Path) -> Result<Option<Self>, SweepError> {
        let path = sidecar_path(table);
        let text = match fs::read(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(source) => return Err(SweepError::file("cannot be read", &path)(source)),
        };
        let sidecar = serde_json::from_slice(&text).map_err(|error| error.to_string());
        let sidecar = sidecar.and_then(|sidecar: Self| {
            let is_its = sidecar.scenario.sha256() == sidecar.scenario_sha256;
            if is_its { Ok(sidecar) } else { Err("its scenario has another hash".to_owned()) }
        });
        sidecar.map(Some).map_err(|why| {
            let problem = format!("is damaged, or of another version ({why}); delete it and its table to start over");
            SweepError::Damaged { path, problem }
        })
    }

    /// Writes it beside a table.
    ///
    /// # Errors
    /// [`SweepError::File`].
    pub fn write(&self, table: &Path) -> Result<(), SweepError> {
        let path = sidecar_path(table);
        let text = serde_json::to_vec_pretty(self).map_err(io::Error::from);
        text.and_then(|text| replace(&path, &text)).map_err(SweepError::file("cannot be written", &path))
    }
}

/// Where a table lies while it is unfinished.
#[must_use]
pub fn part_path(table: &Path) -> PathBuf {
    with_suffix(table, PART)
}

/// Where its sidecar lies.
#[must_use]
pub fn sidecar_path(table: &Path) -> PathBuf {
    with_suffix(table, ".sidecar.json")
}

/// The name of a shard's table.
#[must_use]
pub fn table_name(shard: Shard, format: Format) -> String {
    let extension = format.name();
    if shard.is_whole() {
        format!("table.{extension}")
    } else {
        format!("table-{}-of-{}.{extension}", shard.index, shard.count)
    }
}

/// What the rows so far come to.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    /// Complete rows.
    pub rows: u64,
    /// Rows without a result.
    pub failures: u64,
    /// Rows that the law has no answer for.
    pub outside_law: u64,
    /// Of e, for random values.
    pub statistics: Statistics,
}

impl Tally {
    /// Counts a row.
    pub fn push(&mut self, count: Count, is_monte_carlo: bool) {
        self.rows += 1;
        match count {
            Count::Failure => self.failures += 1,
            Count::OutsideLaw => self.outside_law += 1,
            Count::Restitution(value) if is_monte_carlo => self.statistics.push(value),
            Count::Restitution(_) | Count::AtRest => {}
        }
    }

    /// Counts the rows of another tally; e is left out.
    #[cfg(feature = "parquet")]
    pub(super) fn add(&mut self, other: &Self) {
        self.rows += other.rows;
        self.failures += other.failures;
        self.outside_law += other.outside_law;
    }
}

/// Reads the complete rows of a table, and where they end in bytes; a torn last line is left out. Without a complete
/// header both are zero.
///
/// # Errors
/// [`SweepError::Damaged`] where a row is not the one that belongs there.
pub fn read_rows(path: &Path, table: &TextTable, sidecar: &Sidecar) -> Result<(Tally, u64), SweepError> {
    let failed = SweepError::file("cannot be read", path);
    let mut reader = BufReader::with_capacity(1 << 20, File::open(path).map_err(&failed)?);
    let layout = sidecar.layout();
    let (mut tally, mut line) = (Tally::default(), Vec::new());
    let header = table.header();
    reader.read_until(b'\n', &mut line).map_err(&failed)?;
    if !header.starts_with(&line) {
        let problem = "its first line is not that of this table; delete it to start over".to_owned();
        return Err(SweepError::Damaged { path: path.to_owned(), problem });
    }
    if line != header {
        return Ok((tally, 0));
    }
    let mut end = line.len() as u64;
    let rows = layout.rows();
    while tally.rows < rows {
        line.clear();
        reader.read_until(b'\n', &mut line).map_err(&failed)?;
        let Some(complete) = line.strip_suffix(b"\n") else { break };
        let expected = layout.case(tally.rows);
        let row =
            read_line(complete, sidecar.restitution_column).filter(|row| row.case == expected).ok_or_else(|| {
                let problem = format!("row {} is not case {expected}; delete it to start over", tally.rows + 1);
                SweepError::Damaged { path: path.to_owned(), problem }
            })?;
        tally.push(row.count, sidecar.is_monte_carlo);
        end += line.len() as u64;
    }
    Ok((tally, end))
}
