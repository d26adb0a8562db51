//! A sweep from plan to table: checks what an earlier run left, then computes the missing rows and appends them.

use std::io::Write;
use std::ops::Range;
use std::path::Path;

use super::SweepError;
use super::count::Count;
use super::evaluator::{Evaluator, Rows};
use super::job::{Job, Written};
use super::ordered::{Made, fill};
use super::pace::Pace;
use super::seal::Sealed;
use super::shard::{Layout, Shard};
use super::sidecar::{OTHER_MACHINE, Read, Sidecar, Tally, part_path, read_rows, sidecar_path};
use super::table::{Format, TextTable};
use crate::output::{NewFile, OutputError, remove, remove_stale, sync_folder};

impl Job<'_> {
    /// Runs the sweep, or continues where an earlier run stopped.
    ///
    /// # Errors
    /// [`SweepError`]; rows written so far as csv or json stay and can be resumed.
    pub fn run(&self) -> Result<Written, SweepError> {
        let name = self.name();
        let table = self.directory.path().join(&name);
        let lock = self.directory.lock(Path::new(&name))?;
        for place in [&table, &sidecar_path(&table)] {
            remove_stale(place).map_err(SweepError::file("cannot be written", place))?;
        }
        let is_whole = self.shard.is_none();
        let written = |tally, resumed| Written { table: table.clone(), tally, resumed, is_whole, _lock: lock };
        let shard = self.shard.unwrap_or(Shard::WHOLE);
        let sidecar = Sidecar::new(self.plan, self.source, self.format, shard);
        if self.format == Format::Parquet {
            let (tally, resumed) = self.run_parquet(&table, &sidecar)?;
            return Ok(written(tally, resumed));
        }
        let layout = Layout::new(self.plan.count(), shard);
        let text = TextTable::new(self.plan, self.format);
        let part = part_path(&table);
        let old = Sidecar::read(&table)?;
        let same = old.clone().filter(|old| old.is_of_same(&sidecar));
        let mut read = Read::of(self.plan);
        match same {
            None => {
                self.may_begin(old.as_ref(), &sidecar, &table, &part)?;
                // the old sidecar is removed first: no sidecar may lie beside the table of another run
                let path = sidecar_path(&table);
                remove(&path).map_err(SweepError::file("cannot be removed", &path))?;
            }
            Some(_) if part.exists() => read = read_rows(&part, &text, &layout, self.plan)?,
            // a finished table is kept: a scheduler may start a shard twice, and a run may have been stopped while it
            // drew its pictures
            Some(old) if self.is_complete(&name, &table) => {
                if let Some(tally) = self.kept(&table, &text, &layout, old)? {
                    let resumed = tally.rows;
                    return Ok(written(tally, resumed));
                }
            }
            Some(_) => {}
        }
        let Read { mut tally, sum, .. } = read;
        let (resumed, end) = (tally.rows, sum.seal().bytes);
        let unwritable = SweepError::file("cannot be written", &part);
        let file = NewFile::resume(&table, part.clone(), end).map_err(OutputError::at(&part))?;
        sync_folder(self.directory.path()).map_err(&unwritable)?;
        sidecar.write(&table)?;
        let mut file = Sealed::new(file, sum);
        if end == 0 {
            file.write_all(&text.header()).map_err(&unwritable)?;
        }
        self.append(&mut file, &part, &text, &layout, &mut tally)?;
        file.write_all(text.footer()).map_err(&unwritable)?;
        let finished = Some(file.seal());
        self.directory.put_table(vec![file.into_inner()])?;
        if self.shard.is_some() {
            Sidecar { finished, ..sidecar }.write(&table)?;
        }
        Ok(written(tally, resumed))
    }

    /// Whether the table is finished and belongs to this sidecar. A shard that exists always does; an undivided table
    /// does if the directory lists it as its own file.
    fn is_complete(&self, name: &str, table: &Path) -> bool {
        table.exists() && (self.shard.is_some() || self.directory.has_own(name))
    }

    /// Refuses to begin if rows of another sweep would be lost.
    fn may_begin(&self, old: Option<&Sidecar>, new: &Sidecar, table: &Path, part: &Path) -> Result<(), SweepError> {
        let what = if part.symlink_metadata().is_ok_and(|data| data.len() > 0) {
            "unfinished rows"
        } else if self.shard.is_some() && table.exists() {
            "a shard"
        } else {
            return Ok(());
        };
        if let Some(old) = old {
            let is_of_machine = old.powers_of_machine != new.powers_of_machine && old.scenario == new.scenario;
            let of = if is_of_machine { OTHER_MACHINE } else { "another scenario or division" };
            Err(SweepError::Changed { sidecar: sidecar_path(table), table: table.to_owned(), what, of })
        } else {
            let problem = format!("holds {what} without a sidecar that says of what; move or delete it to start over");
            let path = if what == "a shard" { table } else { part };
            Err(SweepError::Damaged { path: path.to_owned(), problem })
        }
    }

    /// The rows of a finished table, if the file is unchanged since it was written. If the run was stopped before it
    /// wrote the seal into the sidecar, only the rows are checked, and the seal is written now.
    fn kept(
        &self,
        table: &Path,
        text: &TextTable,
        layout: &Layout,
        sidecar: Sidecar,
    ) -> Result<Option<Tally>, SweepError> {
        let Read { tally, finished: Some(seal), .. } = (match read_rows(table, text, layout, self.plan) {
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
        let (total, resumed) = (layout.rows(), tally.rows);
        let report = |rows| (self.progress)(resumed + rows, total);
        let pace = Pace::new(self.is_cancelled, &report);
        let make = |rows: Range<u64>| {
            let is_end = rows.end == total;
            let asked = rows.end - rows.start;
            let computed = compute(&evaluator, layout, rows, &pace);
            // numbers take up to 24 characters
            let mut lines = Vec::with_capacity(computed.cases.len() * 192);
            text.write(&computed, is_end && computed.cases.len() as u64 == asked, &mut lines);
            Ok(Made { output: lines, counts: computed.results.iter().map(Count::of).collect() })
        };
        let unwritable = SweepError::file("cannot be written (free space, then the same command goes on)", part);
        fill(tally, total, || pace.piece(), make, |lines: Vec<u8>| file.write_all(&lines).map_err(&unwritable))?;
        if tally.rows < total {
            return Err(SweepError::Interrupted { rows: tally.rows, total, part: part.to_owned() });
        }
        Ok(())
    }

    #[cfg(feature = "parquet")]
    fn run_parquet(&self, table: &Path, sidecar: &Sidecar) -> Result<(Tally, u64), SweepError> {
        if self.shard.is_some() {
            return Err(SweepError::Unsupported(
                "shards are written as csv or json; Parquet files are neither resumed nor merged",
            ));
        }
        let files = self.files();
        if Sidecar::read(table)?.as_ref() == Some(sidecar) && files.iter().all(|file| self.directory.has_own(file)) {
            let mut tally = Tally::of(self.plan);
            let mut count = |file| super::parquet::count(&self.directory.path().join(file), &mut tally);
            files.iter().try_for_each(&mut count)?;
            let resumed = tally.rows;
            return Ok((tally, resumed));
        }
        sidecar.write(table)?;
        let written = super::parquet::write(self, table);
        if written.is_err() {
            let path = sidecar_path(table);
            remove(&path).map_err(SweepError::file("cannot be removed", &path))?;
        }
        Ok((written?, 0))
    }

    #[cfg(not(feature = "parquet"))]
    #[allow(clippy::unused_self)] // the signature is that of the function above
    fn run_parquet(&self, _table: &Path, _sidecar: &Sidecar) -> Result<(Tally, u64), SweepError> {
        Err(SweepError::Unsupported(
            "this build writes csv and json; for Parquet build with `cargo build --release --features parquet`",
        ))
    }
}

/// The rows of this range as numbers. If the run is cancelled, only the first of them.
pub fn compute(evaluator: &Evaluator, layout: &Layout, rows: Range<u64>, pace: &Pace) -> Rows {
    let mut computed = Rows::with_capacity(rows.end - rows.start, evaluator.n_swept());
    pace.walk(rows, |piece| {
        for cases in layout.cases(piece) {
            evaluator.rows(cases, &mut computed);
        }
    });
    computed
}
