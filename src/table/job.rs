//! Writes a table: as one file, or in parts, from which the same command resumes.

use std::fs::{self, File};
use std::io::{Seek as _, SeekFrom, Write as _};
use std::path::PathBuf;

use super::format::csv::CsvEncoder;
use super::format::{Format, TableEncoder};
use super::missing_parts::MissingParts;
use super::parts::{MAX_JOINED_ROWS, MAX_PARTS_OF_ONE_FILE, TableIdentity};
use super::table_files::{TableJob, TableWriter};
use super::{PartLayout, Tally, unwritable_table_error};
use crate::error::Error;
use crate::files::parts_folder::{PARTS_FOLDER, file_error};
use crate::files::{AtomicFile, remove, remove_stale};

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
        let table = TableWriter { job: self, form, layout: self.layout, name: format!("table.{}", self.format.name()) };
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

impl<F: TableEncoder> TableWriter<'_, F> {
    fn write(&self, identity: &TableIdentity) -> Result<FinishedTable, Error> {
        let Self { job, layout, .. } = *self;
        let (table, folder) = (self.path(&self.name), self.path(PARTS_FOLDER));
        job.directory.check_replaceable(&self.name, |path| self.form.is_own(path))?;
        remove_stale(&table).map_err(file_error("cannot be written", &table))?;
        let is_begun = identity.matches_parts_in(job.directory)?;
        if !is_begun && job.shard.is_none() && layout.n_parts() <= MAX_PARTS_OF_ONE_FILE {
            let (tally, found) = self.complete(PartLayout { rows_per_part: layout.rows.max(1), ..layout }, true)?;
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
        let (tally, found) = self.complete(layout, false)?;
        if job.shard.is_some() || !is_joined {
            return Ok(FinishedTable { table: folder, tally, resumed_rows: found });
        }
        self.join_parts()?;
        Ok(FinishedTable { table, tally, resumed_rows: found })
    }

    /// Joins the parts to one file, and removes them.
    fn join_parts(&self) -> Result<(), Error> {
        let (table, header) = (self.path(&self.name), self.form.header());
        let unwritable = unwritable_table_error(&table);
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

    /// Completes the parts of this table or shard. Returns the counts of all rows, and the number of resumed rows.
    fn complete(&self, layout: PartLayout, is_one_file: bool) -> Result<(Tally, u64), Error> {
        MissingParts { table: self, layout, is_one_file }.complete()
    }
}
