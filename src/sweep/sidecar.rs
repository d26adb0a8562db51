//! The sidecar: a file beside a table that says which table it is. With it, only rows of the same table are resumed or
//! merged. Also reads the rows of an unfinished table.

use std::fmt::Display;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, Read as _};
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::SweepError;
use super::count::Count;
use super::seal::{Seal, Sum};
use super::shard::{Layout, Shard};
use super::statistics::Statistics;
use super::table::{Format, TextTable};
use crate::output::{PART, replace, with_suffix};
use crate::plan::{Plan, Source};
use crate::provenance::{FORMAT, NUMBERS, VERSION};

/// How this machine computes powers: the CRC-32 of many of them. The C library computes powers in one way on processors
/// with fused multiply-add and in another way on others, and some of the powers differ in their last digit.
fn powers_of_machine() -> u32 {
    let mut sum = Sum::default();
    for k in 0..4096 {
        let x = 0.5 + f64::from(k) / 4096.0;
        // the exponents of the first steps of dop853 and dopri5
        for exponent in [0.125, 0.2] {
            #[allow(clippy::disallowed_methods)] // has to be the power of the machine, not of the compiler
            let power = std::hint::black_box(x).powf(std::hint::black_box(exponent));
            sum.update(&power.to_bits().to_le_bytes());
        }
    }
    sum.seal().crc32
}

/// In messages: the other machine that unfinished rows or a shard come from.
pub const OTHER_MACHINE: &str =
    "a machine that computes powers with other last digits, on which dopri5 and dop853 depend";

/// What a table holds. Everything else follows from the scenario.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sidecar {
    /// [`FORMAT`] of the program.
    pub format_version: u64,
    /// [`VERSION`] of the program.
    pub version: String,
    /// [`NUMBERS`] of the program.
    pub numbers: u64,
    /// Hash of the scenario.
    pub scenario_sha256: String,
    /// The scenario itself, from which merging writes the summary.
    pub scenario: Source,
    /// Format of the table.
    pub format: Format,
    /// Which shard the table is, counted from 0.
    pub shard: u64,
    /// Number of shards.
    pub shards: u64,
    /// Checksum of how the machine that writes the table computes powers; `None` if the rows do not depend on it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub powers_of_machine: Option<u32>,
    /// Length and checksum of the finished table; `None` while it is unfinished.
    pub finished: Option<Seal>,
}

/// The part of a sidecar that is read first, because the other entries may differ between versions.
#[derive(Deserialize)]
struct Stamp {
    version: String,
    /// 0 if an older version wrote the sidecar without it.
    #[serde(default)]
    numbers: u64,
    /// 0 if an older version wrote the sidecar without it.
    #[serde(default)]
    format_version: u64,
}

impl Sidecar {
    /// The sidecar of a table that is being written. `scenario` is the scenario of `plan`.
    pub fn new(plan: &Plan, scenario: &Source, format: Format, shard: Shard) -> Self {
        Self {
            format_version: FORMAT,
            version: VERSION.to_owned(),
            numbers: NUMBERS,
            scenario_sha256: scenario.sha256(),
            scenario: scenario.clone(),
            format,
            shard: shard.index,
            shards: shard.count,
            powers_of_machine: plan.depends_on_machine().then(powers_of_machine),
            finished: None,
        }
    }

    /// Whether both belong to the same shard of the same table.
    pub fn is_of_same(&self, other: &Self) -> bool {
        Self { finished: other.finished, ..self.clone() } == *other
    }

    /// Reads the sidecar of a table; `None` if there is none.
    ///
    /// # Errors
    /// [`SweepError`] if the file cannot be read, is damaged, or was written by another version.
    pub fn read(table: &Path) -> Result<Option<Self>, SweepError> {
        let path = sidecar_path(table);
        let text = match fs::read(&path) {
            Ok(text) => text,
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(source) => return Err(SweepError::file("cannot be read", &path)(source)),
        };
        let damaged = |why: &dyn Display| {
            let problem = format!("is damaged ({why}); delete it and its table, and run its command again");
            SweepError::Damaged { path: path.clone(), problem }
        };
        let stamp: Stamp = serde_json::from_slice(&text).map_err(|error| damaged(&error))?;
        let Stamp { version, numbers, format_version } = stamp;
        if (version.as_str(), numbers, format_version) != (VERSION, NUMBERS, FORMAT) {
            let version = version.escape_debug();
            let form = |of: u64| if format_version == FORMAT { String::new() } else { format!(", format {of}") };
            let (theirs, ours) = (form(format_version), form(FORMAT));
            let versions = format!(
                "its version is {version} (table numbers {numbers}{theirs}), and this program's {VERSION} (table numbers {NUMBERS}{ours})"
            );
            return Err(SweepError::Version { sidecar: path, versions });
        }
        let sidecar: Self = serde_json::from_slice(&text).map_err(|error| damaged(&error))?;
        Shard::new(sidecar.shard, sidecar.shards).map_err(|error| damaged(&error))?;
        if sidecar.scenario.sha256() != sidecar.scenario_sha256 {
            return Err(damaged(&"its scenario has another hash"));
        }
        Ok(Some(sidecar))
    }

    /// Writes it beside a table.
    pub fn write(&self, table: &Path) -> Result<(), SweepError> {
        let path = sidecar_path(table);
        let text = serde_json::to_vec_pretty(self).map_err(io::Error::from);
        text.and_then(|text| replace(&path, &text)).map_err(SweepError::file("cannot be written", &path))
    }
}

/// The end of the name of a sidecar, behind the name of its table.
pub const SIDECAR: &str = ".sidecar.json";

/// The path of a table while it is unfinished.
pub fn part_path(table: &Path) -> PathBuf {
    with_suffix(table, PART)
}

/// The path of the sidecar of a table.
pub fn sidecar_path(table: &Path) -> PathBuf {
    with_suffix(table, SIDECAR)
}

/// The name of a shard's table, or of an undivided one.
pub fn table_name(shard: Option<Shard>, format: Format) -> String {
    let extension = format.name();
    match shard {
        None => format!("table.{extension}"),
        Some(Shard { index, count }) => format!("table-{index}-of-{count}.{extension}"),
    }
}

/// Counts of the rows so far, and the statistics of e.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    /// Complete rows.
    pub rows: u64,
    /// Rows without a result.
    pub failures: u64,
    /// Rows outside the range of the law.
    pub outside_law: u64,
    /// Whether values are random; only then e goes into the statistics.
    is_random: bool,
    /// Statistics of e; empty if the values are not random.
    pub statistics: Statistics,
}

impl Tally {
    /// No rows of this plan yet.
    pub fn of(plan: &Plan) -> Self {
        Self { is_random: plan.is_monte_carlo(), ..Self::default() }
    }

    /// Counts a row.
    pub fn push(&mut self, count: Count) {
        self.rows += 1;
        match count {
            Count::Failure => self.failures += 1,
            Count::OutsideLaw => self.outside_law += 1,
            Count::Restitution(value) if self.is_random => self.statistics.push(value),
            Count::Restitution(_) | Count::AtRest => {}
        }
    }
}

/// The complete rows of a table.
#[derive(Debug, Clone, Default)]
pub struct Read {
    /// Counts of the rows.
    pub tally: Tally,
    /// Length and checksum of header and rows.
    pub sum: Sum,
    /// Seal of the whole file, if it has all its rows and nothing after them.
    pub finished: Option<Seal>,
}

impl Read {
    /// No rows of this plan.
    pub fn of(plan: &Plan) -> Self {
        Self { tally: Tally::of(plan), ..Self::default() }
    }
}

/// Reads the complete rows of a table. An incomplete last line is left out; with an incomplete header there are no
/// rows.
///
/// # Errors
/// [`SweepError::Damaged`] if a row is damaged or not the expected case.
pub fn read_rows(path: &Path, table: &TextTable, layout: &Layout, plan: &Plan) -> Result<Read, SweepError> {
    let failed = SweepError::file("cannot be read", path);
    let mut reader = BufReader::with_capacity(1 << 20, File::open(path).map_err(&failed)?);
    let (mut read, mut line) = (Read::of(plan), Vec::new());
    let header = table.header();
    reader.read_until(b'\n', &mut line).map_err(&failed)?;
    if !header.starts_with(&line) {
        let problem = "its first line is not that of this table; delete it to start over".to_owned();
        return Err(SweepError::Damaged { path: path.to_owned(), problem });
    }
    if line != header {
        return Ok(read);
    }
    read.sum.update(&line);
    let rows = layout.rows();
    while read.tally.rows < rows {
        line.clear();
        reader.read_until(b'\n', &mut line).map_err(&failed)?;
        let Some(complete) = line.strip_suffix(b"\n") else { return Ok(read) };
        let (expected, row) = (layout.case(read.tally.rows), read.tally.rows + 1);
        let (_, count) = table.read(complete, row == rows).filter(|(case, _)| *case == expected).ok_or_else(|| {
            let problem = format!("row {row} is damaged, or is not case {expected}; delete it to start over");
            SweepError::Damaged { path: path.to_owned(), problem }
        })?;
        read.tally.push(count);
        read.sum.update(&line);
    }
    // one byte more than the end of a table has, so that anything appended is noticed
    let footer = table.footer();
    let mut rest = Vec::new();
    reader.take(footer.len() as u64 + 1).read_to_end(&mut rest).map_err(&failed)?;
    if rest == footer {
        let mut whole = read.sum.clone();
        whole.update(footer);
        read.finished = Some(whole.seal());
    }
    Ok(read)
}
