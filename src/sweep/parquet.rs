//! A table as Parquet: row groups encoded in parallel, each in memory, appended in order.

mod columns;
mod group;

use std::collections::HashMap;
use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;
use std::sync::{Arc, Mutex};

use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::record::Field;
use parquet::schema::types::{SchemaDescriptor, Type};

use self::columns::{BATCH, properties, schema};
use self::group::{Chunk, Encoder};
use super::SweepError;
use super::column::{OK, columns};
use super::count::Count;
use super::evaluator::{Evaluator, Failure};
use super::job::{Job, Progress};
use super::ordered::fill;
use super::pace::Pace;
use super::sidecar::Tally;
use crate::output::NewFile;
use crate::plan::Plan;

/// Rows of a row group, at most: a few megabytes, so that two groups a thread stay far below the memory of any machine.
const ROW_GROUP: u64 = 65_536;

/// Bytes written to the file at a time.
const WRITE: usize = 1 << 18;

/// Short tables have smaller row groups, so that there is one for every thread.
fn row_group(total: u64) -> u64 {
    (total / 16).next_multiple_of(BATCH as u64).clamp(BATCH as u64, ROW_GROUP)
}

/// Writes the table of a job; it appears when it is complete. A Parquet file ends with its table of contents, so an
/// unfinished one cannot be resumed; one that is complete is kept when its summary is not there yet.
pub(super) fn write(job: &Job, table: &Path, total: u64) -> Result<Tally, SweepError> {
    let unwritable = SweepError::file("cannot be written", table);
    let failed = |error: ParquetError| unwritable(io::Error::other(error));
    let columns = columns(job.plan);
    let schema = schema(job.plan, &columns).map_err(failed)?;
    let descriptor = SchemaDescriptor::new(schema.clone());
    let properties = properties(&columns, &descriptor);
    let file = NewFile::create(table).map_err(&unwritable)?;
    let file = BufWriter::with_capacity(WRITE, file);
    let mut writer = SerializedFileWriter::new(file, schema, properties.clone()).map_err(failed)?;

    let report = |rows| (job.progress)(Progress { rows, total, resumed: 0 });
    let encoder = Encoder {
        pace: Pace::new(job.is_cancelled, &report),
        evaluator: Evaluator::new(job.plan),
        columns: &columns,
        descriptor: &descriptor,
        properties: &properties,
        uniform: Mutex::new(HashMap::new()),
    };
    let mut tally = Tally::of(job.plan);
    let make = |rows| encoder.group(rows).map_err(|error| Some(failed(error)))?.ok_or(None);
    fill(
        &mut tally,
        total,
        || row_group(total),
        make,
        |group: Vec<Chunk>| append(&mut writer, &group).map_err(failed),
    )?;
    if tally.rows < total {
        return Err(SweepError::Dropped);
    }
    let file = writer.into_inner().map_err(failed)?.into_inner();
    job.directory.put_table(file.map_err(|error| unwritable(error.into_error()))?)?;
    Ok(tally)
}

/// Counts the rows of a complete table.
pub(super) fn count(table: &Path, plan: &Plan) -> Result<Tally, SweepError> {
    let unreadable = SweepError::file("cannot be read", table);
    let failed = |error: ParquetError| unreadable(io::Error::other(error));
    let reader = SerializedFileReader::new(File::open(table).map_err(&unreadable)?).map_err(failed)?;
    let fields = reader.metadata().file_metadata().schema().get_fields().iter();
    let wanted = fields.filter(|field| ["restitution", "status"].contains(&field.name())).map(Arc::clone).collect();
    let projection = Type::group_type_builder("table").with_fields(wanted).build().map_err(failed)?;
    let mut tally = Tally::of(plan);
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
    Ok(tally)
}

fn append(writer: &mut SerializedFileWriter<BufWriter<NewFile>>, group: &[Chunk]) -> Result<(), ParquetError> {
    let mut row_group = writer.next_row_group()?;
    for (bytes, close) in group {
        row_group.append_column(bytes, close.clone())?;
    }
    row_group.close().map(|_| ())
}
