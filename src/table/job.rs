//! The request for a table, and its work: existing parts are read, and the others are computed.

use std::fs::{self, File};
use std::io::{Seek as _, SeekFrom, Write as _};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use super::format::csv::CsvEncoder;
use super::format::{Format, TableEncoder};
use super::parts::{MAX_JOINED_ROWS, MAX_PARTS_OF_ONE_FILE, TableIdentity};
use super::shard::Shard;
use super::tally::RowOutcome;
use super::{Evaluator, PartLayout, Rows, Tally, classify, unwritable_error};
use crate::error::{Error, ErrorKind};
use crate::files::parts_folder::{PARTS_FOLDER, file_error};
use crate::files::{AtomicFile, OutputDirectory, Progress, remove, remove_stale};
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

/// A finished table or shard.
#[derive(Debug)]
pub struct FinishedTable {
    /// The file, or the folder of the parts.
    pub table: PathBuf,
    /// Counts of rows and failures, and the distribution of e.
    pub tally: Tally,
    /// Rows that an earlier run or another process wrote.
    pub resumed_rows: u64,
}

/// One piece of the work for a table.
enum Task {
    /// Read an existing part.
    Read(u64),
    /// Compute some rows of a part that is missing.
    Compute(Range<u64>),
}

/// Some rows of a part, encoded; without a chunk if the rows are in a file already.
struct EncodedChunk<T> {
    cases: Range<u64>,
    piece: Option<T>,
    counts: Vec<RowOutcome>,
}

impl TableJob<'_> {
    /// Writes the table, or its missing parts.
    ///
    /// # Errors
    /// [`Error`]; parts written so far stay.
    pub fn run(&self) -> Result<FinishedTable, Error> {
        let identity = TableIdentity::new(self.source, self.format, self.layout);
        match self.format {
            Format::Csv => self.run_with_encoder(&CsvEncoder::new(self.plan), &identity),
            #[cfg(feature = "parquet")]
            Format::Parquet => {
                let failed = |error| Error::failed(format!("Parquet: {error}"));
                self.run_with_encoder(
                    &super::format::parquet::ParquetEncoder::new(self.plan).map_err(failed)?,
                    &identity,
                )
            }
            #[cfg(not(feature = "parquet"))]
            Format::Parquet => Err(Error::input(
                "this build writes csv; for Parquet build with `cargo build --release --features parquet`",
            )),
        }
    }

    fn run_with_encoder<F: TableEncoder>(&self, form: &F, identity: &TableIdentity) -> Result<FinishedTable, Error> {
        let table = TableWriter {
            job: self,
            form,
            evaluator: &Evaluator::new(self.plan),
            layout: self.layout,
            name: format!("table.{}", self.format.name()),
        };
        let mut tries = 0;
        loop {
            match table.write(identity) {
                // another run has put the parts together and removed them: then the table is there
                Err(error) if error.is_not_found() && tries < 3 => tries += 1,
                result => return result,
            }
        }
    }
}

/// A table in one form.
struct TableWriter<'a, F> {
    job: &'a TableJob<'a>,
    form: &'a F,
    evaluator: &'a Evaluator<'a>,
    layout: PartLayout,
    name: String,
}

impl<F: TableEncoder> TableWriter<'_, F> {
    fn path(&self, name: &str) -> PathBuf {
        self.job.directory.path().join(name)
    }

    fn part_path(&self, part: u64) -> PathBuf {
        // enough digits, so that the names sort in the order of the parts
        self.path(PARTS_FOLDER).join(format!("part-{part:05}.{}", self.job.format.name()))
    }

    fn write(&self, identity: &TableIdentity) -> Result<FinishedTable, Error> {
        let Self { job, layout, .. } = *self;
        let (table, folder) = (self.path(&self.name), self.path(PARTS_FOLDER));
        job.directory.check_replaceable(&self.name, |path| self.form.is_own(path))?;
        remove_stale(&table).map_err(file_error("cannot be written", &table))?;
        let is_begun = identity.matches_parts_in(job.directory)?;
        if !is_begun && job.shard.is_none() && layout.n_parts() <= MAX_PARTS_OF_ONE_FILE {
            let (tally, found) =
                self.compute_missing_parts(PartLayout { rows_per_part: layout.rows.max(1), ..layout }, true)?;
            return Ok(FinishedTable { table, tally, resumed_rows: found });
        }
        // CSV becomes one file in the end
        let is_joined = job.format == Format::Csv && layout.rows <= MAX_JOINED_ROWS;
        if !is_begun {
            job.directory.remove_earlier_results(&[])?;
            remove(&table).map_err(file_error("cannot be removed", &table))?;
            identity.create(job.directory)?;
        } else if is_joined && table.exists() {
            // the table is finished, perhaps by another run, and its parts are removed
            let mut tally = Tally::new(job.plan);
            if self.read_part(&table, 0..layout.rows, &mut |count| tally.push(count))? {
                job.directory.remove_parts()?;
                return Ok(FinishedTable { table, resumed_rows: tally.rows, tally });
            }
        }
        fs::create_dir_all(&folder).map_err(file_error("cannot be made", &folder))?;
        let (tally, found) = self.compute_missing_parts(layout, false)?;
        if job.shard.is_some() || !is_joined {
            return Ok(FinishedTable { table: folder, tally, resumed_rows: found });
        }
        self.join_parts()?;
        Ok(FinishedTable { table, tally, resumed_rows: found })
    }

    /// Joins the parts to one file, and removes them.
    fn join_parts(&self) -> Result<(), Error> {
        let (table, header) = (self.path(&self.name), self.form.header());
        let unwritable = unwritable_error(&table);
        let mut whole = AtomicFile::create(&table).map_err(&unwritable)?;
        whole.write_all(header).map_err(&unwritable)?;
        for part in 0..self.layout.n_parts() {
            let path = self.part_path(part);
            let mut part = File::open(&path).map_err(file_error("cannot be read", &path))?;
            part.seek(SeekFrom::Start(header.len() as u64)).map_err(file_error("cannot be read", &path))?;
            whole.append(&mut part).map_err(&unwritable)?;
        }
        whole.sync().and_then(|()| whole.persist()).map_err(&unwritable)?;
        self.job.directory.remove_parts()
    }

    /// Reads a file that should have these cases. Returns true if the file is complete.
    fn read_part(&self, path: &Path, cases: Range<u64>, count: &mut dyn FnMut(RowOutcome)) -> Result<bool, Error> {
        self.form.read(path, cases.end - cases.start, count).map_err(file_error("cannot be read", path))
    }

    /// Reads the existing parts of this table or shard, and computes the others. A table of one file is computed as a whole. Returns the
    /// counts of all rows, and the number of resumed rows.
    fn compute_missing_parts(&self, layout: PartLayout, is_one_file: bool) -> Result<(Tally, u64), Error> {
        let job = self.job;
        let path = |part| if is_one_file { self.path(&self.name) } else { self.part_path(part) };
        // rows may be slow, so a signal must be noticed between two chunks
        let step = F::BATCH_ROWS.min(self.layout.rows_per_part / 64).max(1);
        let pieces = |part: u64| {
            let cases = layout.part_cases(part);
            let count = (cases.end - cases.start).div_ceil(step);
            (0..count).map(move |k| cases.start + k * step..cases.end.min(cases.start + (k + 1) * step))
        };
        let mine = || (0..layout.n_parts()).filter(|part| job.shard.is_none_or(|shard| shard.contains(*part)));
        let total = mine().map(|part| layout.part_cases(part)).map(|cases| cases.end - cases.start).sum();
        let tasks = mine().flat_map(|part| -> Box<dyn Iterator<Item = Task> + Send> {
            // the part is looked up late, because another process may have written it in the meantime
            if !is_one_file && path(part).exists() {
                Box::new(std::iter::once(Task::Read(part)))
            } else {
                Box::new(pieces(part).map(Task::Compute))
            }
        });
        let interrupted = |rows: u64| {
            let then = if is_one_file {
                "No part was written, because a table of this size is written at once. Run the same command again."
            } else {
                "Run the same command again to resume."
            };
            Error::new(ErrorKind::Stopped(130), format!("interrupted after {rows} of {total} rows. {then}"))
        };
        let with_statistics = job.plan.statistics_columns();
        // rows of finished chunks: their memory is reused
        let spare = Mutex::new(Vec::new());
        let compute = |cases: Range<u64>| {
            if job.progress.is_stopped() {
                return Err(interrupted(0));
            }
            let known: Option<Rows> = spare.lock().unwrap_or_else(PoisonError::into_inner).pop();
            let mut rows =
                known.unwrap_or_else(|| Rows::with_capacity(cases.end - cases.start, self.evaluator.n_axis_values()));
            rows.clear();
            self.evaluator.append_rows(cases.clone(), &mut rows);
            let piece = self.form.encode(&rows).map_err(file_error("cannot be encoded", &self.path(&self.name)))?;
            let counts = rows.results.iter().map(|row| classify(row, &with_statistics)).collect();
            spare.lock().unwrap_or_else(PoisonError::into_inner).push(rows);
            Ok(EncodedChunk { cases, piece: Some(piece), counts })
        };
        let make = |task| -> Result<Vec<EncodedChunk<F::Chunk>>, Error> {
            let part = match task {
                Task::Compute(cases) => return Ok(vec![compute(cases)?]),
                Task::Read(part) => part,
            };
            let (path, cases, mut counts) = (path(part), layout.part_cases(part), Vec::new());
            if self.read_part(&path, cases.clone(), &mut |count| counts.push(count))? {
                return Ok(vec![EncodedChunk { cases, piece: None, counts }]);
            }
            pieces(part).collect::<Vec<_>>().into_par_iter().map(compute).collect()
        };
        let (mut tally, mut found, mut open) = (Tally::new(job.plan), 0, None);
        let append = |cases: &Range<u64>, piece: &F::Chunk, open: &mut Option<F::Writer>| -> Result<(), Error> {
            let part = cases.start / layout.rows_per_part;
            let (of_part, path) = (layout.part_cases(part), path(part));
            let unwritable = unwritable_error(&path);
            let begin = || AtomicFile::create(&path).and_then(|file| self.form.begin(file));
            let mut writer = open.take().map_or_else(begin, Ok).map_err(&unwritable)?;
            self.form.append(&mut writer, piece).map_err(&unwritable)?;
            if cases.end < of_part.end {
                *open = Some(writer);
                return Ok(());
            }
            // the part is complete: it gets its final name
            let file = self.form.finish(writer).and_then(|file| file.sync().map(|()| file)).map_err(&unwritable)?;
            if is_one_file {
                job.directory.remove_earlier_results(&[&self.name])?;
            }
            file.persist().map_err(&unwritable)
        };
        let take = |many: Vec<EncodedChunk<F::Chunk>>| {
            for EncodedChunk { cases, piece, counts } in many {
                match piece {
                    Some(piece) => append(&cases, &piece, &mut open)?,
                    None => found += cases.end - cases.start,
                }
                for count in counts {
                    tally.push(count);
                }
                job.progress.set(tally.rows, total);
            }
            Ok(())
        };
        match ordered_parallel(tasks, make, take) {
            Err(error) if error.kind == ErrorKind::Stopped(130) => Err(interrupted(tally.rows)),
            result => result.map(|()| (tally, found)),
        }
    }
}

/// Pieces in memory for each thread: enough that few threads wait at the end of a round.
const CHUNKS_PER_THREAD: usize = 16;

/// Makes a piece of every task on all threads, and takes the pieces in the order of the tasks. While the pieces of one round
/// are taken, those of the next are made.
///
/// # Errors
/// The first error of `make` or `take`; then nothing more is begun.
pub fn ordered_parallel<T: Send, M: Send, E: Send>(
    mut tasks: impl Iterator<Item = T> + Send,
    make: impl Fn(T) -> Result<M, E> + Sync + Send,
    mut take: impl FnMut(M) -> Result<(), E> + Send,
) -> Result<(), E> {
    let mut made: Vec<Result<M, E>> = Vec::new();
    loop {
        let round: Vec<T> = tasks.by_ref().take(CHUNKS_PER_THREAD * rayon::current_num_threads()).collect();
        if round.is_empty() && made.is_empty() {
            return Ok(());
        }
        let ready = std::mem::take(&mut made);
        let (result, next) = rayon::join(
            || ready.into_iter().try_for_each(|piece| take(piece?)),
            || round.into_par_iter().map(&make).collect(),
        );
        result?;
        made = next;
    }
}
