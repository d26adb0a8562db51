//! A sweep from plan to table: chunks of rows on all cores, appended in order while the next ones are computed.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use super::SweepError;
use super::count::Count;
use super::plan::{Evaluator, Plan, Rows};
use super::seal::Sealed;
use super::shard::{Layout, Shard};
use super::sidecar::{Read, Sidecar, Tally, part_path, read_rows, sidecar_path, table_name};
use super::table::{Format, TextTable};
use crate::scenario::Source;

/// Rows a task computes and writes as text: large against the cost of a task, small against memory.
pub const CHUNK: u64 = 4096;
/// Tasks a thread before their texts are written.
const CHUNKS_A_THREAD: u64 = 8;

/// A sweep to be run.
pub struct Job<'a> {
    /// What is swept.
    pub plan: &'a Plan,
    /// Which part of it; `None`: all, with nothing to be merged.
    pub shard: Option<Shard>,
    /// What is written.
    pub format: Format,
    /// Where.
    pub directory: &'a Path,
    /// The scenario that the plan is of.
    pub source: &'a Source,
    /// Told now and then how far it is.
    pub progress: &'a (dyn Fn(Progress) + Sync),
    /// Set to stop after the rows at hand.
    pub is_cancelled: &'a AtomicBool,
}

/// How far a sweep is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Rows written, those of an earlier run included.
    pub rows: u64,
    /// All rows of this shard.
    pub total: u64,
    /// Rows of an earlier run.
    pub resumed: u64,
}

/// A finished table.
#[derive(Debug, Clone)]
pub struct Written {
    /// The file.
    pub table: PathBuf,
    /// Rows, failures, distribution of e.
    pub tally: Tally,
    /// Rows that an earlier run had written.
    pub resumed: u64,
}

/// The text of consecutive rows, and how each counts.
struct Chunk {
    text: Vec<u8>,
    counts: Vec<Count>,
}

impl Job<'_> {
    /// Runs it, or goes on where an earlier run stopped.
    ///
    /// # Errors
    /// [`SweepError`]; what is written so far stays and can be resumed.
    pub fn run(&self) -> Result<Written, SweepError> {
        fs::create_dir_all(self.directory).map_err(SweepError::file("cannot be created", self.directory))?;
        let table = self.directory.join(table_name(self.shard, self.format));
        if self.format == Format::Parquet {
            return self.run_parquet(&table);
        }
        let sidecar = Sidecar::new(self.source, self.format, self.shard.unwrap_or(Shard::WHOLE));
        let layout = Layout::new(self.total(), self.shard.unwrap_or(Shard::WHOLE));
        let text = TextTable::new(self.plan, self.format);
        let part = part_path(&table);
        let mut read = Read::default();
        let is_shard = self.shard.is_some();
        match Sidecar::read(&table)? {
            Some(old) if old.is_of_same(&sidecar) => {
                if part.exists() {
                    read = read_rows(&part, &text, &layout, self.plan.is_monte_carlo())?;
                } else if is_shard && table.exists() {
                    // a finished shard is kept, so that a scheduler may start it again
                    if let Some(tally) = self.kept(&table, &text, &layout, old)? {
                        return Ok(Written { table, resumed: tally.rows, tally });
                    }
                }
            }
            Some(_) if part.exists() || (is_shard && table.exists()) => {
                let what = if part.exists() { "unfinished rows" } else { "a shard" };
                return Err(SweepError::Changed { sidecar: sidecar_path(&table), table, what });
            }
            _ => {}
        }
        sidecar.write(&table)?;
        let Read { mut tally, sum, .. } = read;
        let (resumed, end) = (tally.rows, sum.seal().bytes);
        let unwritable = SweepError::file("cannot be written", &part);
        let mut file = Sealed::new(open(&part, end).map_err(&unwritable)?, sum);
        if end == 0 {
            file.write_all(&text.header()).map_err(&unwritable)?;
        }
        self.append(&mut file, &part, &text, &layout, &mut tally)?;
        file.write_all(text.footer()).map_err(&unwritable)?;
        let finished = Some(file.seal());
        fs::rename(&part, &table).map_err(SweepError::file("cannot be renamed", &part))?;
        if is_shard {
            Sidecar { finished, ..sidecar }.write(&table)?;
        } else {
            let path = sidecar_path(&table);
            fs::remove_file(&path).map_err(SweepError::file("cannot be removed", &path))?;
        }
        Ok(Written { table, tally, resumed })
    }

    /// The rows of a finished shard, if the file is as it was written. Of a run that was stopped just before it completed the
    /// sidecar, only the rows can be checked; the sidecar is then completed.
    fn kept(
        &self,
        table: &Path,
        text: &TextTable,
        layout: &Layout,
        sidecar: Sidecar,
    ) -> Result<Option<Tally>, SweepError> {
        let Read { tally, finished: Some(seal), .. } = (match read_rows(table, text, layout, self.plan.is_monte_carlo())
        {
            Err(SweepError::Damaged { .. }) => return Ok(None),
            read => read?,
        }) else {
            return Ok(None);
        };
        match sidecar.finished {
            Some(written) => return Ok((written == seal).then_some(tally)),
            None => Sidecar { finished: Some(seal), ..sidecar }.write(table)?,
        }
        Ok(Some(tally))
    }

    fn total(&self) -> u64 {
        // a plan of more than 2^63 cases is refused while the scenario is read
        self.plan.count().unwrap_or(u64::MAX)
    }

    /// Computes the rows after those of `tally` and appends them.
    fn append(
        &self,
        file: &mut (impl Write + Send),
        part: &Path,
        text: &TextTable,
        layout: &Layout,
        tally: &mut Tally,
    ) -> Result<(), SweepError> {
        let evaluator = Evaluator::new(self.plan);
        let total = layout.rows();
        let resumed = tally.rows;
        let is_monte_carlo = self.plan.is_monte_carlo();
        let mut next = tally.rows;
        let mut ready: Vec<Chunk> = Vec::new();
        // one chunk a thread first, so that the first rows are there at once
        let mut group = rayon::current_num_threads() as u64 * CHUNK;
        loop {
            let end = if self.is_cancelled.load(Ordering::Relaxed) { next } else { total.min(next + group) };
            let (written, computed) = rayon::join(
                || ready.iter().try_for_each(|chunk| file.write_all(&chunk.text)),
                || chunks(&evaluator, text, layout, next..end),
            );
            written.map_err(SweepError::file("cannot be written (free space, then the same command goes on)", part))?;
            for count in ready.iter().flat_map(|chunk| &chunk.counts) {
                tally.push(*count, is_monte_carlo);
            }
            (self.progress)(Progress { rows: tally.rows, total, resumed });
            if computed.is_empty() {
                break;
            }
            (ready, next) = (computed, end);
            group = rayon::current_num_threads() as u64 * CHUNKS_A_THREAD * CHUNK;
        }
        if tally.rows < total {
            return Err(SweepError::Interrupted { rows: tally.rows, total, part: part.to_owned() });
        }
        Ok(())
    }

    #[cfg(feature = "parquet")]
    fn run_parquet(&self, table: &Path) -> Result<Written, SweepError> {
        if self.shard.is_some() {
            return Err(SweepError::Unsupported(
                "shards are written as csv or json; Parquet files are neither resumed nor merged",
            ));
        }
        let tally = super::parquet::write(self, table, self.total())?;
        Ok(Written { table: table.to_owned(), tally, resumed: 0 })
    }

    #[cfg(not(feature = "parquet"))]
    #[allow(clippy::unused_self)] // has the form of its other half
    fn run_parquet(&self, _table: &Path) -> Result<Written, SweepError> {
        Err(SweepError::Unsupported(
            "this build writes csv and json; for Parquet build with `cargo build --release --features parquet`",
        ))
    }
}

/// Opens the unfinished table to append at `end`; what is behind is a torn line.
fn open(part: &Path, end: u64) -> io::Result<File> {
    let mut file = OpenOptions::new().write(true).create(true).truncate(false).open(part)?;
    file.set_len(end)?;
    file.seek(SeekFrom::Start(end))?;
    Ok(file)
}

/// The rows of this range as text, in chunks.
fn chunks(evaluator: &Evaluator, text: &TextTable, layout: &Layout, rows: Range<u64>) -> Vec<Chunk> {
    let starts: Vec<u64> = rows.clone().step_by(usize::try_from(CHUNK).unwrap_or(usize::MAX)).collect();
    starts
        .into_par_iter()
        .map(|start| {
            let end = rows.end.min(start + CHUNK);
            let computed = compute(evaluator, layout, start..end);
            // numbers take up to 24 characters
            let mut lines = Vec::with_capacity(computed.cases.len() * 192);
            text.write(&computed, end == layout.rows(), &mut lines);
            let counts = computed.results.iter().map(Count::of).collect();
            Chunk { text: lines, counts }
        })
        .collect()
}

/// The rows of this range as numbers.
#[must_use]
pub fn compute(evaluator: &Evaluator, layout: &Layout, rows: Range<u64>) -> Rows {
    let mut computed = Rows::with_capacity(rows.end - rows.start, evaluator.n_swept());
    for cases in layout.cases(rows) {
        evaluator.rows(cases, &mut computed);
    }
    computed
}
