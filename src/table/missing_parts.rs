//! The work of a table or a shard: existing parts are read, and the others are computed.

use std::ops::Range;
use std::path::PathBuf;

use rayon::prelude::*;

use super::chunks::{ChunkComputer, ordered_parallel};
use super::format::TableEncoder;
use super::table_files::TableWriter;
use super::tally::RowOutcome;
use super::{PartLayout, Tally, unwritable_table_error};
use crate::error::{Error, ErrorKind};
use crate::files::AtomicFile;
use crate::files::parts_folder::file_error;

/// The parts of a table, of which some may be missing.
pub(super) struct MissingParts<'a, F> {
    pub table: &'a TableWriter<'a, F>,
    pub layout: PartLayout,
    /// True for a table of one file, which is computed as a whole.
    pub is_one_file: bool,
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
    outcomes: Vec<RowOutcome>,
}

impl<F: TableEncoder> MissingParts<'_, F> {
    /// Reads the existing parts, and computes the others. Returns the counts of all rows, and the number of resumed rows.
    pub fn complete(&self) -> Result<(Tally, u64), Error> {
        let job = self.table.job;
        let computer = ChunkComputer::new(job.plan, job.progress);
        let total = self.parts().map(|part| self.layout.part_cases(part)).map(|cases| cases.end - cases.start).sum();
        let (mut tally, mut resumed, mut open) = (Tally::new(job.plan), 0, None);
        let take = |chunks: Vec<EncodedChunk<F::Chunk>>| {
            for EncodedChunk { cases, piece, outcomes } in chunks {
                match piece {
                    Some(piece) => self.append(&cases, &piece, &mut open)?,
                    None => resumed += cases.end - cases.start,
                }
                for outcome in outcomes {
                    tally.push(outcome);
                }
                job.progress.set(tally.rows, total);
            }
            Ok(())
        };
        match ordered_parallel(self.tasks(), |task| self.make(&computer, task), take) {
            Err(error) if error.kind == ErrorKind::Stopped(130) => Err(self.interruption(tally.rows, total)),
            result => result.map(|()| (tally, resumed)),
        }
    }

    /// The parts of the table or the shard.
    fn parts(&self) -> impl Iterator<Item = u64> + Send {
        let shard = self.table.job.shard;
        (0..self.layout.n_parts()).filter(move |part| shard.is_none_or(|shard| shard.contains(*part)))
    }

    fn tasks(&self) -> impl Iterator<Item = Task> + Send {
        self.parts().flat_map(|part| -> Box<dyn Iterator<Item = Task> + Send> {
            // the part is looked up late, because another process may have written it in the meantime
            if !self.is_one_file && self.path(part).exists() {
                Box::new(std::iter::once(Task::Read(part)))
            } else {
                Box::new(self.chunks(part).map(Task::Compute))
            }
        })
    }

    /// The cases of the chunks of a part. Rows may be slow, so a signal must be noticed between two chunks.
    fn chunks(&self, part: u64) -> impl Iterator<Item = Range<u64>> + Send + use<F> {
        let step = F::BATCH_ROWS.min(self.table.layout.rows_per_part / 64).max(1);
        let cases = self.layout.part_cases(part);
        let count = (cases.end - cases.start).div_ceil(step);
        (0..count).map(move |k| cases.start + k * step..cases.end.min(cases.start + (k + 1) * step))
    }

    /// The file of a part.
    fn path(&self, part: u64) -> PathBuf {
        if self.is_one_file { self.table.path(&self.table.name) } else { self.table.part_path(part) }
    }

    fn make(&self, computer: &ChunkComputer, task: Task) -> Result<Vec<EncodedChunk<F::Chunk>>, Error> {
        let part = match task {
            Task::Compute(cases) => return Ok(vec![self.compute(computer, cases)?]),
            Task::Read(part) => part,
        };
        let (path, cases, mut outcomes) = (self.path(part), self.layout.part_cases(part), Vec::new());
        if self.table.read_part(&path, cases.clone(), &mut |outcome| outcomes.push(outcome))? {
            return Ok(vec![EncodedChunk { cases, piece: None, outcomes }]);
        }
        // the file is not whole
        self.chunks(part).collect::<Vec<_>>().into_par_iter().map(|cases| self.compute(computer, cases)).collect()
    }

    fn compute(&self, computer: &ChunkComputer, cases: Range<u64>) -> Result<EncodedChunk<F::Chunk>, Error> {
        let (piece, outcomes) = computer.compute(cases.clone(), |rows| self.table.form.encode(rows))?;
        let piece = piece.map_err(file_error("cannot be encoded", &self.table.path(&self.table.name)))?;
        Ok(EncodedChunk { cases, piece: Some(piece), outcomes })
    }

    /// Appends a chunk to the file of its part, which is open if it has rows before. A complete part gets its final name.
    fn append(&self, cases: &Range<u64>, piece: &F::Chunk, open: &mut Option<F::Writer>) -> Result<(), Error> {
        let part = cases.start / self.layout.rows_per_part;
        let path = self.path(part);
        let unwritable = unwritable_table_error(&path);
        let begin = || AtomicFile::create(&path).and_then(|file| self.table.form.begin(file));
        let mut writer = open.take().map_or_else(begin, Ok).map_err(&unwritable)?;
        self.table.form.append(&mut writer, piece).map_err(&unwritable)?;
        if cases.end < self.layout.part_cases(part).end {
            *open = Some(writer);
            return Ok(());
        }
        let file = self.table.form.finish(writer).and_then(|file| file.sync().map(|()| file)).map_err(&unwritable)?;
        if self.is_one_file {
            self.table.job.directory.remove_earlier_results(&[&self.table.name])?;
        }
        file.persist().map_err(&unwritable)
    }

    fn interruption(&self, rows: u64, total: u64) -> Error {
        let then = if self.is_one_file {
            "No part was written, because a table of this size is written at once. Run the same command again."
        } else {
            "Run the same command again to resume."
        };
        Error::new(ErrorKind::Stopped(130), format!("interrupted after {rows} of {total} rows. {then}"))
    }
}
