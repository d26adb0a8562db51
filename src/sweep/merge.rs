//! Shards to one table, byte for byte that of the undivided run.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{BufRead, BufReader, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::SweepError;
use super::plan::Plan;
use super::sidecar::{Sidecar, Tally, VERSION, part_path, sidecar_path};
use super::table::{Format, TextTable, read_line};
use crate::output::{Lock, NewFile, Origin, OutputDirectory, remove_stale};
use crate::scenario::Scenario;

const SIDECAR: &str = ".sidecar.json";
/// What the command writes beside a merged table, with the pictures.
const SUMMARY: &str = "summary.json";

/// A merged table, locked until it is dropped.
#[derive(Debug)]
pub struct Merged {
    /// What the shards say of themselves.
    pub sidecar: Sidecar,
    /// What was swept.
    pub plan: Plan,
    /// Rows, failures, distribution of e.
    pub tally: Tally,
    _lock: Lock,
}

/// The tables of shards in `inputs`: files, or directories of them.
fn tables(inputs: &[PathBuf]) -> Result<Vec<PathBuf>, SweepError> {
    let mut tables = Vec::new();
    for input in inputs {
        let failed = SweepError::file("cannot be read", input);
        if !input.is_dir() {
            tables.push(input.clone());
            continue;
        }
        for entry in fs::read_dir(input).map_err(&failed)? {
            let path = entry.map_err(&failed)?.path();
            let name = path.file_name().and_then(|name| name.to_str());
            if let Some(table) = name.and_then(|name| name.strip_suffix(SIDECAR)) {
                tables.push(path.with_file_name(table));
            }
        }
    }
    tables.sort();
    Ok(tables)
}

/// The shards by their number, if they make one table.
fn complete(tables: &[PathBuf]) -> Result<(Sidecar, Vec<PathBuf>), SweepError> {
    let mut problems = Vec::new();
    let mut first: Option<(Sidecar, &Path)> = None;
    let mut shards: BTreeMap<u64, &PathBuf> = BTreeMap::new();
    for table in tables {
        let name = table.display();
        let sidecar = match Sidecar::read(table) {
            Ok(Some(sidecar)) => sidecar,
            Ok(None) => {
                problems.push(format!("{name}: foreign: it has no sidecar {}", sidecar_path(table).display()));
                continue;
            }
            Err(SweepError::Damaged { path, problem }) => {
                problems.push(format!("{name}: foreign: its sidecar {} {problem}", path.display()));
                continue;
            }
            Err(error) => return Err(error),
        };
        // what is written beside the table has to come from the version that made the rows
        if sidecar.version != VERSION {
            let version = &sidecar.version;
            problems.push(format!(
                "{name}: foreign: its version is {version}, and this program's {VERSION}; merge with the version that wrote the shards"
            ));
            continue;
        }
        let (reference, reference_name) = first.get_or_insert_with(|| (sidecar.clone(), table));
        let like = Sidecar { shard: reference.shard, ..sidecar.clone() };
        if like != *reference {
            let which = [
                (sidecar.scenario_sha256 != reference.scenario_sha256, "scenario"),
                (sidecar.format != reference.format, "format"),
                (sidecar.shards != reference.shards, "number of shards"),
            ];
            let which = which.iter().find(|(differs, _)| *differs).map_or("division", |(_, which)| which);
            problems.push(format!("{name}: foreign: its {which} is not that of {}", reference_name.display()));
            continue;
        }
        if let Some(other) = shards.insert(sidecar.shard, table) {
            problems.push(format!("{name}: double: shard {} is in {} too", sidecar.shard, other.display()));
        }
        if !table.exists() {
            let part = part_path(table);
            let why = if part.exists() { "unfinished: run its command again" } else { "missing: run its command" };
            problems.push(format!("{name}: {why}"));
        }
    }
    let Some((reference, _)) = first else {
        problems.push("no shards (tables with a sidecar) are there".to_owned());
        return Err(SweepError::Shards(problems));
    };
    let missing: Vec<String> =
        (0..reference.shards).filter(|shard| !shards.contains_key(shard)).map(|shard| shard.to_string()).collect();
    if !missing.is_empty() {
        problems.push(format!("missing: shard {} of {}", missing.join(", "), reference.shards));
    }
    if problems.is_empty() {
        Ok((reference, shards.into_values().cloned().collect()))
    } else {
        Err(SweepError::Shards(problems))
    }
}

/// What the shards were run from.
fn plan(sidecar: &Sidecar, shards: &[PathBuf]) -> Result<Plan, SweepError> {
    let path = shards.first().map_or_else(PathBuf::new, |table| sidecar_path(table));
    let name = path.display().to_string();
    let damaged = |problem: String| SweepError::Damaged { path: path.clone(), problem };
    let scenario = Scenario::from_source(&name, &sidecar.scenario);
    let plan = scenario.and_then(|scenario| scenario.plan()).map_err(|error| damaged(error.to_string()))?;
    plan.ok_or_else(|| damaged("its scenario has no table".to_owned()))
}

/// Merges the shards in `inputs` (files or directories) into `out`, a file of `directory` that appears when it is complete.
/// With `is_forced` it replaces what is not known to be a result of the same shards.
///
/// # Errors
/// [`SweepError::Shards`] naming every missing, double, unfinished and foreign shard, [`SweepError::Place`] for an `out`
/// that would take the place of a shard or is no name of a table; [`SweepError::Output`]; file errors. Then nothing is left of the table.
pub fn merge(
    inputs: &[PathBuf],
    directory: &mut OutputDirectory,
    out: &Path,
    is_forced: bool,
) -> Result<Merged, SweepError> {
    let (sidecar, shards) = complete(&tables(inputs)?)?;
    check_place(out, &shards)?;
    let plan = plan(&sidecar, &shards)?;
    let name = Path::new(out.file_name().unwrap_or_default());
    let lock = directory.lock(name)?;
    let from = inputs.first().map_or(Path::new(""), PathBuf::as_path);
    directory.claim(Origin::File(from, &sidecar.scenario_sha256), is_forced)?;
    directory.check(name.to_str().into_iter().chain([SUMMARY]))?;
    remove_stale(out).map_err(SweepError::file("cannot be written", out))?;
    let mut table = NewFile::create(out).map_err(SweepError::file("cannot be written", out))?;
    let tally = write(&sidecar, &plan, &shards, &mut table)?;
    directory.put_table(table)?;
    Ok(Merged { sidecar, plan, tally, _lock: lock })
}

fn check_place(out: &Path, shards: &[PathBuf]) -> Result<(), SweepError> {
    let is_out = |path: &Path| out.canonicalize().is_ok_and(|out| path.canonicalize().is_ok_and(|path| path == out));
    let problem = if out.is_dir() {
        "is a directory"
    } else if out.file_name().is_some_and(|name| name == SUMMARY) {
        "is the name of the summary, which goes beside the table"
    } else if out.extension().is_some_and(|extension| extension == "png") {
        "is the name of a picture, which goes beside the table"
    } else if shards.iter().any(|table| is_out(table) || is_out(&sidecar_path(table))) {
        "is one of the shards"
    } else {
        return Ok(());
    };
    Err(SweepError::Place { path: out.to_owned(), problem })
}

/// The rows of all shards in their order.
fn write(sidecar: &Sidecar, plan: &Plan, shards: &[PathBuf], table: &mut NewFile) -> Result<Tally, SweepError> {
    let is_json = sidecar.format == Format::Json.name();
    let header = TextTable::new(plan, if is_json { Format::Json } else { Format::Csv }).header();
    // 64 MB for all shards together, however many
    let buffer = ((64 << 20) / shards.len()).clamp(1 << 16, 1 << 20);
    let mut readers = Vec::new();
    for table in shards {
        let file = File::open(table).map_err(SweepError::file("cannot be read", table))?;
        let mut reader = BufReader::with_capacity(buffer, file);
        let mut first = Vec::new();
        reader.read_until(b'\n', &mut first).map_err(SweepError::file("cannot be read", table))?;
        if first != header {
            let problem = "its first line is not that of this table; delete the shard and run it again".to_owned();
            return Err(SweepError::Damaged { path: table.clone(), problem });
        }
        readers.push((reader, table));
    }
    let place = table.place().to_owned();
    let unwritable = SweepError::file("cannot be written", &place);
    let mut writer = BufWriter::with_capacity(1 << 20, table);
    let mut line = Vec::new();
    writer.write_all(&header).map_err(&unwritable)?;
    let mut tally = Tally::default();
    while tally.rows < sidecar.cases {
        let shard = usize::try_from(tally.rows / sidecar.block % sidecar.shards).unwrap_or(usize::MAX);
        let (reader, table) = &mut readers[shard];
        line.clear();
        reader.read_until(b'\n', &mut line).map_err(SweepError::file("cannot be read", table))?;
        let body = line.strip_suffix(b"\n").unwrap_or(&line);
        let body = body.strip_suffix(b",").unwrap_or(body);
        let row =
            read_line(body, sidecar.restitution_column).filter(|row| row.case == tally.rows).ok_or_else(|| {
                let problem = format!("case {} is not where it belongs; delete the shard and run it again", tally.rows);
                SweepError::Damaged { path: (*table).clone(), problem }
            })?;
        tally.push(row.count, sidecar.is_monte_carlo);
        let end: &[u8] = if is_json && tally.rows < sidecar.cases { b",\n" } else { b"\n" };
        writer.write_all(body).and_then(|()| writer.write_all(end)).map_err(&unwritable)?;
    }
    if is_json {
        writer.write_all(b"]\n").map_err(&unwritable)?;
    }
    writer.flush().map_err(&unwritable)?;
    Ok(tally)
}
