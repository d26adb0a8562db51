//! A table as Parquet: row groups encoded in parallel, each in memory, appended in order.

mod columns;
mod group;

use std::collections::HashMap;
use std::fs::{self, File};
use std::io::{self, BufWriter};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::Ordering;

use parquet::errors::ParquetError;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::SchemaDescriptor;

use self::columns::{columns, properties, schema};
use self::group::{Encoder, Group};
use super::SweepError;
use super::driver::{Job, Progress};
use super::ordered::in_order;
use super::plan::Evaluator;
use super::sidecar::{Tally, part_path};

/// Rows computed and encoded at a time: few enough to stay in the cache.
const BATCH: usize = 4096;

/// Rows of a row group, at most: a few megabytes, so that two groups a thread stay far below the memory of any machine.
const ROW_GROUP: u64 = 65_536;

/// Bytes written to the file at a time.
const WRITE: usize = 1 << 18;

/// Short tables have smaller row groups, so that there is one for every thread.
fn row_group(total: u64) -> u64 {
    (total / 16).next_multiple_of(BATCH as u64).clamp(BATCH as u64, ROW_GROUP)
}

/// Writes the table of a job; it appears when it is complete. A Parquet file ends with its table of contents, so an
/// unfinished one cannot be resumed.
pub(super) fn write(job: &Job, table: &Path, total: u64) -> Result<Tally, SweepError> {
    let part = part_path(table);
    let unwritable = SweepError::file("cannot be written", &part);
    let failed = |error: ParquetError| unwritable(io::Error::other(error));
    let columns = columns(job.plan);
    let schema = schema(job.plan, &columns).map_err(failed)?;
    let descriptor = SchemaDescriptor::new(schema.clone());
    let properties = properties(&columns, &descriptor);
    let file = File::create(&part).map_err(&unwritable)?;
    let file = BufWriter::with_capacity(WRITE, file);
    let mut writer = SerializedFileWriter::new(file, schema, properties.clone()).map_err(failed)?;

    let encoder = Encoder {
        evaluator: Evaluator::new(job.plan),
        columns: &columns,
        descriptor: &descriptor,
        properties: &properties,
        is_monte_carlo: job.plan.is_monte_carlo(),
        uniform: Mutex::new(HashMap::new()),
    };
    let length = row_group(total);
    let mut tally = Tally::default();
    let is_cancelled = || job.is_cancelled.load(Ordering::Relaxed);
    let written = in_order(
        total.div_ceil(length),
        |index| {
            if is_cancelled() {
                return Err(interrupted());
            }
            encoder.group(index * length..total.min((index + 1) * length)).map_err(failed)
        },
        |group: Group| {
            append(&mut writer, &group).map_err(failed)?;
            tally.add(&group.tally);
            for value in group.restitutions {
                tally.statistics.push(value);
            }
            (job.progress)(Progress { rows: tally.rows, total, resumed: 0 });
            Ok(())
        },
    );
    if let Err(error) = written {
        if is_cancelled() {
            drop(writer);
            fs::remove_file(&part).map_err(SweepError::file("cannot be removed", &part))?;
        }
        return Err(error);
    }
    let file = writer.into_inner().map_err(failed)?.into_inner();
    let file = file.map_err(|error| unwritable(error.into_error()))?;
    file.sync_all().map_err(&unwritable)?;
    fs::rename(&part, table).map_err(SweepError::file("cannot be renamed", &part))?;
    Ok(tally)
}

fn interrupted() -> SweepError {
    SweepError::Unsupported("interrupted; a Parquet table starts over, csv and json can be resumed")
}

fn append(writer: &mut SerializedFileWriter<BufWriter<File>>, group: &Group) -> Result<(), ParquetError> {
    let mut row_group = writer.next_row_group()?;
    for (bytes, close) in &group.columns {
        row_group.append_column(bytes, close.clone())?;
    }
    row_group.close().map(|_| ())
}
