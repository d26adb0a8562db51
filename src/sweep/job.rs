//! The request for a table, and how it is fulfilled: parts that are there are read, the others computed.

use std::fs::{self, File};
use std::io::{self, Seek as _, SeekFrom, Write as _};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use super::SweepError;
use super::count::{Count, Tally};
use super::csv::Csv;
use super::evaluator::{Evaluator, Rows};
use super::form::{Form, Format, Found};
use super::ordered::in_order;
use super::parts::{self, IDENTITY, Identity, JOINED, Layout, ONE_FILE, folder_in};
use super::shard::Shard;
use crate::output::{NewFile, OutputDirectory, remove, remove_folder, remove_stale};
use crate::plan::{Plan, Source};

/// A sweep to be run.
pub struct Job<'a> {
    /// The cases of the table.
    pub plan: &'a Plan,
    /// The shard to compute; `None` for the whole table.
    pub shard: Option<Shard>,
    /// The format of the table.
    pub format: Format,
    /// Rows of a part, for tests of small tables; `None`: as [`parts::rows_per_part`] says.
    pub rows_per_part: Option<u64>,
    /// The directory that the table is written to.
    pub directory: &'a OutputDirectory,
    /// The scenario that the plan was read from.
    pub source: &'a Source,
    /// Called with the number of rows computed or found, and the number of all rows of this table or shard.
    pub progress: &'a (dyn Fn(u64, u64) + Sync),
    /// Set to stop within a fraction of a second, unless a single row takes longer.
    pub is_cancelled: &'a AtomicBool,
}

/// A finished table or shard.
#[derive(Debug)]
pub struct Written {
    /// The file, or the folder of the parts.
    pub table: PathBuf,
    /// Counts of rows and failures, and the distribution of e.
    pub tally: Tally,
    /// Rows that an earlier run had written, or another process.
    pub found: u64,
}

/// What is to be done for a table.
enum Task {
    /// Read a part that is there.
    Read(u64),
    /// Compute some rows of a part that is missing.
    Compute(Range<u64>),
}

/// Some rows of a part, encoded; without a piece if they are in a file already.
struct Made<T> {
    cases: Range<u64>,
    piece: Option<T>,
    counts: Vec<Count>,
}

/// Where the files of a table are.
struct Places {
    layout: Layout,
    /// The one file; `None` for a folder of parts.
    file: Option<PathBuf>,
    folder: PathBuf,
    format: Format,
}

impl Places {
    fn of(&self, part: u64) -> PathBuf {
        self.file.clone().unwrap_or_else(|| self.folder.join(parts::name(part, self.format)))
    }

    /// Puts the parts together, and removes them.
    fn join(&self, form: &impl Form, table: &Path) -> Result<(), SweepError> {
        let unwritable = SweepError::file("cannot be written (free space, then give the same command)", table);
        let header = form.header();
        let mut whole = NewFile::create(table).map_err(&unwritable)?;
        whole.write_all(header).map_err(&unwritable)?;
        for part in 0..self.layout.parts() {
            let path = self.of(part);
            let mut part = File::open(&path).map_err(SweepError::file("cannot be read", &path))?;
            part.seek(SeekFrom::Start(header.len() as u64)).map_err(SweepError::file("cannot be read", &path))?;
            io::copy(&mut part, whole.inner()).map_err(&unwritable)?;
        }
        whole.sync().and_then(|()| whole.put()).map_err(&unwritable)?;
        remove_folder(&self.folder).map_err(SweepError::file("cannot be removed", &self.folder))
    }
}

impl Job<'_> {
    /// Writes the table, or what is missing of it.
    ///
    /// # Errors
    /// [`SweepError`]; parts written so far stay.
    pub fn run(&self) -> Result<Written, SweepError> {
        let identity = Identity::new(self.plan, self.source, self.format, self.layout());
        match self.format {
            Format::Csv => self.run_as(&Csv::new(self.plan), &identity),
            #[cfg(feature = "parquet")]
            Format::Parquet => self.run_as(&super::parquet::Parquet::new(self.plan, identity.hash()), &identity),
            #[cfg(not(feature = "parquet"))]
            Format::Parquet => Err(SweepError::Unsupported(
                "this build writes csv; for Parquet build with `cargo build --release --features parquet`",
            )),
        }
    }

    /// The parts of the table.
    fn layout(&self) -> Layout {
        let rows_per_part = self.rows_per_part.unwrap_or_else(|| parts::rows_per_part(self.plan));
        Layout { rows: self.plan.count(), rows_per_part }
    }

    /// The name of the table as one file.
    fn name(&self) -> String {
        format!("table.{}", self.format.name())
    }

    /// Whether the table is written in parts, with which the same command goes on: a shard, a large table, or one that was
    /// begun so.
    pub fn is_in_parts(&self) -> bool {
        self.shard.is_some() || self.layout().parts() > ONE_FILE || self.directory.path().join(IDENTITY).exists()
    }

    fn run_as<F: Form>(&self, form: &F, identity: &Identity) -> Result<Written, SweepError> {
        let evaluator = Evaluator::new(self.plan);
        let mut tries = 0;
        loop {
            match self.attempt(form, identity, &evaluator) {
                // another run has put the parts together and removed them: then the table is there
                Err(error) if error.is_not_found() && tries < 3 => tries += 1,
                result => return result,
            }
        }
    }

    fn attempt<F: Form>(&self, form: &F, identity: &Identity, evaluator: &Evaluator) -> Result<Written, SweepError> {
        let (directory, layout) = (self.directory, self.layout());
        let (table, folder) = (directory.path().join(self.name()), folder_in(directory.path()));
        directory.may_replace(&self.name(), form.header())?;
        remove_stale(&table).map_err(SweepError::file("cannot be written", &table))?;
        let is_begun = self.is_begun(identity, &folder)?;
        if !is_begun && self.shard.is_none() && layout.parts() <= ONE_FILE {
            let one = Layout { rows: layout.rows, rows_per_part: layout.rows.max(1) };
            let places = Places { layout: one, file: Some(table.clone()), folder, format: self.format };
            let (tally, found) = self.fill(form, evaluator, &places)?;
            return Ok(Written { table, tally, found });
        }
        if !is_begun {
            directory.remove_older(&[])?;
            remove(&table).map_err(SweepError::file("cannot be removed", &table))?;
            identity.create(directory.path())?;
        } else if self.is_joined() && table.exists() {
            // the table was finished, perhaps by another run; without its parts it is as good
            let mut tally = Tally::of(self.plan);
            let found = read(form, evaluator, &table, 0..layout.rows, &mut |count| tally.push(count))?;
            if found == Found::Whole {
                remove_folder(&folder).map_err(SweepError::file("cannot be removed", &folder))?;
                return Ok(Written { table, found: tally.rows, tally });
            }
        }
        fs::create_dir_all(&folder).map_err(SweepError::file("cannot be made", &folder))?;
        let places = Places { layout, file: None, folder, format: self.format };
        let (tally, found) = self.fill(form, evaluator, &places)?;
        if self.shard.is_none() && self.is_joined() {
            places.join(form, &table)?;
            return Ok(Written { table, tally, found });
        }
        Ok(Written { table: places.folder, tally, found })
    }

    /// Whether the parts become one file in the end.
    fn is_joined(&self) -> bool {
        self.format == Format::Csv && self.plan.count() <= JOINED
    }

    /// Whether the table was begun in parts. Parts of another table are refused, or removed by force.
    fn is_begun(&self, identity: &Identity, folder: &Path) -> Result<bool, SweepError> {
        let directory = self.directory.path();
        let there = match Identity::read(directory) {
            Err(SweepError::Damaged { .. }) if self.directory.is_forced() => None,
            there => there?,
        };
        if there.as_ref() == Some(identity) {
            return Ok(true);
        }
        if parts::are_in(folder).map_err(SweepError::file("cannot be read", folder))? {
            match there {
                _ if self.directory.is_forced() => {}
                Some(there) => return Err(identity.refuse(&there, directory)),
                None => {
                    let problem = format!(
                        "holds parts, and no {IDENTITY} says of which table; move or delete them, or start over with --force"
                    );
                    return Err(SweepError::Damaged { path: folder.to_owned(), problem });
                }
            }
            remove_folder(folder).map_err(SweepError::file("cannot be removed", folder))?;
        }
        let path = directory.join(IDENTITY);
        remove(&path).map_err(SweepError::file("cannot be removed", &path))?;
        Ok(false)
    }

    /// Reads the parts of this table or shard that are there, and computes the others. Returns the counts of all rows, and how
    /// many were there.
    fn fill<F: Form>(&self, form: &F, evaluator: &Evaluator, places: &Places) -> Result<(Tally, u64), SweepError> {
        let layout = places.layout;
        // rows may be slow, and a signal has to be heard between two pieces
        let step = F::BATCH.min(self.layout().rows_per_part / 64).max(1);
        let pieces = |part: u64| {
            let cases = layout.cases(part);
            let count = (cases.end - cases.start).div_ceil(step);
            (0..count).map(move |k| cases.start + k * step..cases.end.min(cases.start + (k + 1) * step))
        };
        let is_mine = |part: &u64| self.shard.is_none_or(|shard| shard.has(*part));
        let total =
            (0..layout.parts()).filter(is_mine).map(|part| layout.cases(part)).map(|of| of.end - of.start).sum();
        let tasks = (0..layout.parts()).filter(is_mine).flat_map(|part| -> Box<dyn Iterator<Item = Task> + Send> {
            // looked for when its turn comes: another process may have written it in the meantime
            if places.file.is_none() && places.of(part).exists() {
                Box::new(std::iter::once(Task::Read(part)))
            } else {
                Box::new(pieces(part).map(Task::Compute))
            }
        });
        let interrupted = |rows| SweepError::Interrupted { rows, total, is_in_parts: places.file.is_none() };
        let compute = |cases: Range<u64>| {
            if self.is_cancelled.load(Ordering::Relaxed) {
                return Err(interrupted(0));
            }
            let mut rows = Rows::with_capacity(cases.end - cases.start, evaluator.n_swept());
            evaluator.rows(cases.clone(), &mut rows);
            let piece = form.encode(&rows).map_err(SweepError::file("cannot be encoded", &places.folder))?;
            Ok(Made { cases, piece: Some(piece), counts: rows.results.iter().map(Count::of).collect() })
        };
        let make = |task| -> Result<Vec<Made<F::Piece>>, SweepError> {
            let part = match task {
                Task::Compute(cases) => return Ok(vec![compute(cases)?]),
                Task::Read(part) => part,
            };
            let (cases, mut counts) = (layout.cases(part), Vec::new());
            match read(form, evaluator, &places.of(part), cases.clone(), &mut |count| counts.push(count))? {
                Found::Whole => Ok(vec![Made { cases, piece: None, counts }]),
                Found::Torn => pieces(part).collect::<Vec<_>>().into_par_iter().map(compute).collect(),
                Found::Foreign => {
                    let problem = "is no part of this table, as its first row is another; move it away, and the same command computes that part";
                    Err(SweepError::Damaged { path: places.of(part), problem: problem.to_owned() })
                }
            }
        };
        let (mut tally, mut found, mut open) = (Tally::of(self.plan), 0, None);
        let take = |many: Vec<Made<F::Piece>>| {
            for Made { cases, piece, counts } in many {
                let rows = cases.end - cases.start;
                match piece {
                    Some(piece) => self.append(form, places, &cases, &piece, &mut open)?,
                    None => found += rows,
                }
                for count in counts {
                    tally.push(count);
                }
                (self.progress)(tally.rows, total);
            }
            Ok(())
        };
        let result = in_order(tasks, make, take);
        match result {
            Err(SweepError::Interrupted { .. }) => Err(interrupted(tally.rows)),
            result => result.map(|()| (tally, found)),
        }
    }

    /// Appends rows to the file of their part; with the last of them the file is put in its place.
    fn append<F: Form>(
        &self,
        form: &F,
        places: &Places,
        cases: &Range<u64>,
        piece: &F::Piece,
        open: &mut Option<F::Writer>,
    ) -> Result<(), SweepError> {
        let part = cases.start / places.layout.rows_per_part;
        let (of_part, path) = (places.layout.cases(part), places.of(part));
        let unwritable = SweepError::file("cannot be written (free space, then give the same command)", &path);
        let mut writer = match open.take() {
            Some(writer) => writer,
            None => NewFile::create(&path).and_then(|file| form.begin(file, of_part.start)).map_err(&unwritable)?,
        };
        form.append(&mut writer, piece).map_err(&unwritable)?;
        if cases.end < of_part.end {
            *open = Some(writer);
            return Ok(());
        }
        let file = form.end(writer).and_then(|file| file.sync().map(|()| file)).map_err(&unwritable)?;
        if places.file.is_some() {
            self.directory.remove_older(&[&self.name()])?;
        }
        file.put().map_err(&unwritable)
    }
}

/// Reads a file that ought to hold these cases.
fn read(
    form: &impl Form,
    evaluator: &Evaluator,
    path: &Path,
    cases: Range<u64>,
    count: &mut dyn FnMut(Count),
) -> Result<Found, SweepError> {
    let mut ends = Rows::default();
    evaluator.rows(cases.start..cases.start + 1, &mut ends);
    if cases.end > cases.start + 1 {
        evaluator.rows(cases.end - 1..cases.end, &mut ends);
    }
    let read = form.read(path, &ends, cases.end - cases.start, count);
    read.map_err(SweepError::file("cannot be read", path))
}
