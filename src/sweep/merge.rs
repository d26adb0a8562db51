//! Merges shards into one table, which is byte for byte the table of the undivided run.

mod reader;

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

use self::reader::Reader;
use super::SweepError;
use super::seal::Seal;
use super::shard::{Layout, Shard};
use super::sidecar::{OTHER_MACHINE, SIDECAR, Sidecar, Tally, part_path, sidecar_path};
use super::table::{Format, TextTable};
use crate::output::{Lock, NewFile, Origin, OutputDirectory, SUMMARY, remove_stale};
use crate::plan::{Plan, Source};

/// A merged table, locked until it is dropped.
#[derive(Debug)]
pub struct Merged {
    /// The sidecar of one of the shards.
    pub sidecar: Sidecar,
    /// The plan of the table.
    pub plan: Plan,
    /// Counts of rows and failures, and the distribution of e.
    pub tally: Tally,
    _lock: Lock,
}

/// The tables of the shards in `inputs`, which are files or directories.
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

/// A finished shard.
#[derive(Debug)]
struct Finished {
    table: PathBuf,
    seal: Seal,
}

/// The sidecar of the first shard given, and all shards in order, if they make one table.
fn complete(tables: &[PathBuf]) -> Result<(Sidecar, Vec<Finished>), SweepError> {
    let mut problems = Vec::new();
    let mut first: Option<(Sidecar, &Path)> = None;
    let mut found: BTreeMap<u64, &PathBuf> = BTreeMap::new();
    let mut finished = BTreeMap::new();
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
            // the summary has to be written by the version that made the rows
            Err(SweepError::Version { versions, .. }) => {
                problems.push(format!(
                    "{name}: foreign: {versions}; merge with the version that wrote the shards, or delete it and run its command again"
                ));
                continue;
            }
            Err(error) => return Err(error),
        };
        let (reference, reference_name) = first.get_or_insert_with(|| (sidecar.clone(), table));
        let which = [
            (sidecar.scenario != reference.scenario, "scenario"),
            (sidecar.format != reference.format, "format"),
            (sidecar.shards != reference.shards, "number of shards"),
        ];
        if let Some((_, which)) = which.iter().find(|(differs, _)| *differs) {
            problems.push(format!("{name}: foreign: its {which} is not that of {}", reference_name.display()));
            continue;
        }
        if sidecar.powers_of_machine != reference.powers_of_machine {
            problems.push(format!(
                "{name}: foreign: beside {}, it comes from {OTHER_MACHINE}: run all shards on machines of one kind",
                reference_name.display()
            ));
            continue;
        }
        if let Some(other) = found.insert(sidecar.shard, table) {
            problems.push(format!("{name}: double: shard {} is in {} too", sidecar.shard, other.display()));
        }
        let bytes = fs::metadata(table).ok().map(|file| file.len());
        match (sidecar.finished, bytes) {
            (Some(seal), Some(bytes)) if bytes == seal.bytes => {
                drop(finished.insert(sidecar.shard, Finished { table: table.clone(), seal }));
            }
            (Some(seal), Some(bytes)) => problems.push(format!(
                "{name}: damaged: it has {bytes} bytes, and {} were written: run its command again, which makes it anew",
                seal.bytes
            )),
            (None, None) if !part_path(table).exists() => problems.push(format!("{name}: missing: run its command")),
            (Some(_), None) => problems.push(format!("{name}: missing: run its command again")),
            (None, _) => problems.push(format!("{name}: unfinished: run its command again")),
        }
    }
    let Some((reference, _)) = first else {
        problems.push("no shards (tables with a sidecar) are there".to_owned());
        return Err(SweepError::Shards(problems));
    };
    if let Some(missing) = missing(&found, reference.shards) {
        problems.push(format!("missing: {missing} of {}: run its command", reference.shards));
    }
    if problems.is_empty() {
        Ok((reference, finished.into_values().collect()))
    } else {
        Err(SweepError::Shards(problems))
    }
}

/// The shards that were not found, as text: `shard 3`, `shards 1, 4-7`. `shards` is how many there should be.
fn missing(found: &BTreeMap<u64, &PathBuf>, shards: u64) -> Option<String> {
    let (mut ranges, mut next) = (Vec::new(), 0);
    for shard in found.keys().copied().chain([shards]) {
        match shard - next {
            0 => {}
            1 => ranges.push(next.to_string()),
            _ => ranges.push(format!("{next}-{}", shard - 1)),
        }
        next = shard + 1;
    }
    let is_one = ranges.len() == 1 && !ranges[0].contains('-');
    (!ranges.is_empty()).then(|| format!("{} {}", if is_one { "shard" } else { "shards" }, ranges.join(", ")))
}

/// Reads the plan of a table from the texts of its scenario. Messages use the given name for the file.
pub type PlanOf = fn(&str, &Source) -> Result<Plan, String>;

/// Merges the shards in `inputs` (files or directories) into `out`, a file of `directory` that appears when it is
/// complete. With `is_forced` it also replaces files that are not known to be results of the same shards. `plan_of`
/// reads the plan from the scenario in a sidecar.
///
/// # Errors
/// [`SweepError::Shards`] names every missing, double, unfinished, foreign and damaged shard. [`SweepError::Place`] if
/// `out` is one of the shards or not a name for a table. [`SweepError::Output`] and [`SweepError::File`]. After an
/// error nothing of the merged table is left.
pub fn merge(
    inputs: &[PathBuf],
    directory: &mut OutputDirectory,
    out: &Path,
    is_forced: bool,
    plan_of: PlanOf,
) -> Result<Merged, SweepError> {
    let (sidecar, shards) = complete(&tables(inputs)?)?;
    check_place(out, &shards)?;
    let path = shards.first().map_or_else(PathBuf::new, |shard| sidecar_path(&shard.table));
    let plan = plan_of(&path.display().to_string(), &sidecar.scenario);
    let plan = plan.map_err(|problem| SweepError::Damaged { path, problem })?;
    let name = Path::new(out.file_name().unwrap_or_default());
    let lock = directory.lock(name)?;
    let from = inputs.first().map_or(Path::new(""), PathBuf::as_path);
    directory.claim(Origin::File(from, &sidecar.scenario_sha256), is_forced)?;
    directory.check(name.to_str().into_iter().chain([SUMMARY]))?;
    remove_stale(out).map_err(SweepError::file("cannot be written", out))?;
    let mut table = NewFile::create(out).map_err(SweepError::file("cannot be written", out))?;
    let tally = write(&sidecar, &plan, &shards, &mut table)?;
    directory.put_table(vec![table])?;
    Ok(Merged { sidecar, plan, tally, _lock: lock })
}

fn check_place(out: &Path, shards: &[Finished]) -> Result<(), SweepError> {
    let is_out = |path: &Path| out.canonicalize().is_ok_and(|out| path.canonicalize().is_ok_and(|path| path == out));
    let problem = if out.is_dir() {
        "is a directory"
    } else if out.file_name().is_some_and(|name| name == SUMMARY) {
        "is the name of the summary, which goes beside the table"
    } else if out.extension().is_some_and(|extension| extension == "png" || extension == "svg") {
        "is the name of a picture, which goes beside the table"
    } else if shards.iter().any(|shard| is_out(&shard.table) || is_out(&sidecar_path(&shard.table))) {
        "is one of the shards"
    } else {
        return Ok(());
    };
    Err(SweepError::Place { path: out.to_owned(), problem })
}

/// Writes the rows of all shards in the order of the cases.
fn write(sidecar: &Sidecar, plan: &Plan, shards: &[Finished], out: &mut NewFile) -> Result<Tally, SweepError> {
    let is_json = sidecar.format == Format::Json;
    let table = TextTable::new(plan, sidecar.format);
    let layout = |index| Layout::new(plan.count(), Shard { index, count: sidecar.shards });
    // 64 MB for all shards together; 100 MB for the largest number of shards, with the least buffer for each
    let buffer = ((64 << 20) / shards.len()).clamp(1 << 10, 1 << 20);
    let readers = (0..).zip(shards).map(|(index, shard)| Reader::open(&shard.table, &table, &layout(index), buffer));
    let mut readers = readers.collect::<Result<Vec<_>, _>>()?;
    let place = out.place().to_owned();
    let unwritable = SweepError::file("cannot be written", &place);
    let mut writer = BufWriter::with_capacity(1 << 20, out);
    writer.write_all(&table.header()).map_err(&unwritable)?;
    let Layout { total, block, .. } = layout(0);
    let mut tally = Tally::of(plan);
    while tally.rows < total {
        // a block of each shard in turn
        for reader in &mut readers {
            for case in tally.rows..total.min(tally.rows + block) {
                let (count, line) = reader.row(case)?;
                // in JSON the last row of a shard and the last row of the table have no comma
                let line = line.strip_suffix(b"\n").unwrap_or(line);
                let body = if is_json { line.strip_suffix(b",").unwrap_or(line) } else { line };
                let end: &[u8] = if is_json && case + 1 < total { b",\n" } else { b"\n" };
                writer.write_all(body).and_then(|()| writer.write_all(end)).map_err(&unwritable)?;
                tally.push(count);
            }
        }
    }
    writer.write_all(table.footer()).map_err(&unwritable)?;
    let mut problems = Vec::new();
    for (reader, Finished { table, seal }) in readers.into_iter().zip(shards) {
        if !reader.ends_with(*seal)? {
            problems.push(format!(
                "{}: damaged: its checksum is not that of what was written: run its command again, which makes it anew",
                table.display()
            ));
        }
    }
    if !problems.is_empty() {
        return Err(SweepError::Shards(problems));
    }
    writer.flush().map_err(&unwritable)?;
    Ok(tally)
}
