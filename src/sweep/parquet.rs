//! Writes a table as Parquet, in one file or in one file for every value of an axis. Row groups are encoded in memory,
//! in parallel, and appended in order.

mod columns;
mod group;

use std::collections::HashMap;
use std::fs::{self, File};
use std::io::{self, BufWriter};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::record::Field;
use parquet::schema::types::{SchemaDescriptor, Type};

use self::columns::{BATCH, named, properties, schema};
use self::group::{Chunk, Encoder};
use super::SweepError;
use super::column::OK;
use super::count::Count;
use super::evaluator::{Evaluator, Failure};
use super::job::Job;
use super::ordered::{Made, fill};
use super::pace::Pace;
use super::shard::{Layout, Shard};
use super::sidecar::Tally;
use crate::output::{NewFile, OutputDirectory, folder, remove_stale};

/// The most rows of a row group. A group takes a few megabytes, and each thread holds at most two groups.
const ROW_GROUP: u64 = 65_536;

/// Bytes written to the file at a time.
const WRITE: usize = 1 << 18;

/// Short tables have smaller row groups, so that there is one for every thread.
fn row_group(total: u64) -> u64 {
    (total / 16).next_multiple_of(BATCH as u64).clamp(BATCH as u64, ROW_GROUP)
}

/// Writes the table of a job; its files appear when all of them are complete. A Parquet file ends with its table of
/// contents, so an unfinished file cannot be resumed.
pub(super) fn write(job: &Job, table: &Path) -> Result<Tally, SweepError> {
    let total = job.plan.count();
    let unwritable = SweepError::file("cannot be written", table);
    let failed = |error: ParquetError| unwritable(io::Error::other(error));
    let (names, columns) = named(job.plan, job.partition.as_ref().map(|partition| partition.place));
    let schema = schema(&names, &columns).map_err(failed)?;
    let descriptor = SchemaDescriptor::new(schema.clone());
    let properties = properties(&columns, &descriptor);
    let _folders = folders(job)?;
    let begin = |name: &String| {
        let place = job.directory.path().join(name);
        let file = remove_stale(&place).and_then(|()| NewFile::create(&place)).map_err(&unwritable)?;
        let file = BufWriter::with_capacity(WRITE, file);
        SerializedFileWriter::new(file, schema.clone(), properties.clone()).map_err(failed)
    };
    let mut writers = job.files().iter().map(begin).collect::<Result<Vec<_>, _>>()?;
    let rows_of_file = total / writers.len() as u64;
    let layout = |index| match &job.partition {
        Some(partition) => partition.layout(total, index),
        None => Layout::new(total, Shard::WHOLE),
    };

    let report = |rows| (job.progress)(rows, total);
    let encoder = Encoder {
        pace: Pace::new(job.is_cancelled, &report),
        evaluator: Evaluator::new(job.plan),
        columns: &columns,
        descriptor: &descriptor,
        properties: &properties,
        uniform: Mutex::new(HashMap::new()),
    };
    let mut tally = Tally::of(job.plan);
    // row numbers run on from file to file
    let make = |rows: Range<u64>| {
        let index = usize::try_from(rows.start / rows_of_file).unwrap_or(0);
        let before = index as u64 * rows_of_file;
        let made = encoder.group(&layout(index), rows.start - before..rows.end - before);
        let Made { output, counts } = made.map_err(|error| Some(failed(error)))?.ok_or(None)?;
        Ok(Made { output: (index, output), counts })
    };
    let mut begun = 0;
    // a row group ends where its file ends
    let length = || {
        let length = row_group(total).min(rows_of_file - begun % rows_of_file);
        begun += length;
        length
    };
    let put = |(index, group): (usize, Vec<Chunk>)| append(&mut writers[index], &group).map_err(failed);
    fill(&mut tally, total, length, make, put)?;
    if tally.rows < total {
        return Err(SweepError::Dropped);
    }
    let end = |writer: SerializedFileWriter<BufWriter<NewFile>>| {
        let file = writer.into_inner().map_err(failed)?.into_inner();
        file.map_err(|error| unwritable(error.into_error()))
    };
    let files = writers.into_iter().map(end).collect::<Result<Vec<_>, _>>()?;
    job.directory.put_table(files)?;
    Ok(tally)
}

/// Makes the folders of a divided table that do not exist yet: those of the values, and last the one that they are in.
/// Dropping them removes those that stayed empty.
fn folders(job: &Job) -> Result<Vec<OutputDirectory>, SweepError> {
    if job.partition.is_none() {
        return Ok(Vec::new());
    }
    let table = job.directory.path().join(job.name());
    if let Some(stray) = stray(job).map_err(SweepError::file("cannot be read", &table))? {
        return Err(SweepError::Stray(stray));
    }
    let table = OutputDirectory::shared(&table)?;
    let of_value = |file: &String| OutputDirectory::shared(folder(&job.directory.path().join(file)));
    let mut folders = job.files().iter().map(of_value).collect::<Result<Vec<_>, _>>()?;
    folders.push(table);
    Ok(folders)
}

/// A file in the folder of a divided table that does not belong to it: of a value that the axis had in an earlier run,
/// or any other file.
fn stray(job: &Job) -> io::Result<Option<PathBuf>> {
    let files: Vec<PathBuf> = job.files().iter().map(|name| job.directory.path().join(name)).collect();
    let mut folders = vec![job.directory.path().join(job.name())];
    while let Some(folder) = folders.pop().filter(|folder| folder.exists()) {
        for entry in fs::read_dir(folder)? {
            let entry = entry?;
            if entry.file_type()?.is_dir() {
                folders.push(entry.path());
            } else if !entry.file_name().as_encoded_bytes().starts_with(b".") && !files.contains(&entry.path()) {
                return Ok(Some(entry.path()));
            }
        }
    }
    Ok(None)
}

/// Counts the rows of a complete file into `tally`.
pub(super) fn count(table: &Path, tally: &mut Tally) -> Result<(), SweepError> {
    let unreadable = SweepError::file("cannot be read", table);
    let failed = |error: ParquetError| unreadable(io::Error::other(error));
    let reader = SerializedFileReader::new(File::open(table).map_err(&unreadable)?).map_err(failed)?;
    let fields = reader.metadata().file_metadata().schema().get_fields().iter();
    let wanted = fields.filter(|field| ["restitution", "status"].contains(&field.name())).map(Arc::clone).collect();
    let projection = Type::group_type_builder("table").with_fields(wanted).build().map_err(failed)?;
    for row in reader.get_row_iter(Some(projection)).map_err(failed)? {
        let (mut restitution, mut is_ok, mut is_outside) = (None, false, false);
        for (_, field) in row.map_err(failed)?.get_column_iter() {
            match field {
                Field::Double(value) => restitution = Some(*value),
                Field::Str(status) => (is_ok, is_outside) = (status == OK, status == Failure::OutsideLaw.name()),
                _ => {}
            }
        }
        let count = match restitution {
            Some(value) if is_ok => Count::Restitution(value),
            None if is_ok => Count::AtRest,
            _ if is_outside => Count::OutsideLaw,
            _ => Count::Failure,
        };
        tally.push(count);
    }
    Ok(())
}

fn append(writer: &mut SerializedFileWriter<BufWriter<NewFile>>, group: &[Chunk]) -> Result<(), ParquetError> {
    let mut row_group = writer.next_row_group()?;
    for (bytes, close) in group {
        row_group.append_column(bytes, close.clone())?;
    }
    row_group.close().map(|_| ())
}
