//! A table as Parquet: row groups encoded in parallel, each in memory, appended in order.

use std::fs::{self, File};
use std::io;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::Ordering;

use bytes::Bytes;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::writer::{ColumnCloseResult, ColumnWriter, get_column_writer};
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::properties::{EnabledStatistics, WriterProperties, WriterPropertiesPtr};
use parquet::file::writer::{SerializedFileWriter, SerializedPageWriter, TrackedWrite};
use parquet::schema::types::{ColumnDescPtr, SchemaDescriptor, Type, TypePtr};
use rayon::prelude::*;

use super::SweepError;
use super::axis::{Axis, Setting};
use super::driver::{Job, Progress, compute};
use super::plan::{Cases, Evaluator, Plan, Rows};
use super::shard::{Layout, Shard};
use super::sidecar::{Tally, part_path};
use super::table::{ResultColumn, column_names, result_columns};

/// Rows of a row group: a few megabytes, so that two groups a thread stay far below the memory of any machine.
const ROW_GROUP: u64 = 65_536;

/// Values handed over at a time: few enough to stay in the cache.
const BATCH: usize = 4096;

/// Where the values of a column come from.
enum Column {
    Case,
    /// Random numbers, by their place in a row.
    Random(usize),
    /// Numbers of an axis.
    Number(usize, Axis),
    /// Names of an axis of methods.
    Name(usize, Vec<ByteArray>),
    Result(ResultColumn),
    Status,
}

/// A row group ready to be appended.
struct Group {
    columns: Vec<(Bytes, ColumnCloseResult)>,
    restitution: Vec<Option<f64>>,
}

fn columns(plan: &Plan) -> Vec<Column> {
    let swept: Vec<Column> = match &plan.cases {
        Cases::MonteCarlo { variables, .. } => (0..variables.len()).map(Column::Random).collect(),
        Cases::Grid(axes) => (0..)
            .zip(axes)
            .map(|(place, axis)| match &axis.setting {
                Setting::Number { .. } => Column::Number(place, axis.clone()),
                Setting::Method(methods) => {
                    Column::Name(place, methods.iter().map(|method| ByteArray::from(method.name())).collect())
                }
            })
            .collect(),
    };
    let results = result_columns(plan).into_iter().map(Column::Result);
    std::iter::once(Column::Case).chain(swept).chain(results).chain([Column::Status]).collect()
}

fn schema(plan: &Plan, columns: &[Column]) -> Result<TypePtr, ParquetError> {
    let fields = column_names(plan).into_iter().zip(columns).map(|(name, column)| {
        let (physical, repetition, logical) = match column {
            Column::Case => (Physical::INT64, Repetition::REQUIRED, None),
            Column::Random(_) | Column::Number(..) => (Physical::DOUBLE, Repetition::REQUIRED, None),
            Column::Result(_) => (Physical::DOUBLE, Repetition::OPTIONAL, None),
            Column::Name(..) | Column::Status => {
                (Physical::BYTE_ARRAY, Repetition::REQUIRED, Some(LogicalType::String))
            }
        };
        let field = Type::primitive_type_builder(&name, physical);
        field.with_repetition(repetition).with_logical_type(logical).build().map(Arc::new)
    });
    let fields = fields.collect::<Result<_, _>>()?;
    Type::group_type_builder("table").with_fields(fields).build().map(Arc::new)
}

/// Digits of results hardly repeat: plain numbers, and dictionaries for names alone.
fn properties(columns: &[Column], schema: &SchemaDescriptor) -> WriterPropertiesPtr {
    let mut builder = WriterProperties::builder()
        .set_created_by(format!("plm-impact {}", env!("CARGO_PKG_VERSION")))
        .set_dictionary_enabled(false)
        .set_statistics_enabled(EnabledStatistics::Chunk);
    for (column, description) in columns.iter().zip(schema.columns()) {
        if matches!(column, Column::Name(..) | Column::Status) {
            builder = builder.set_column_dictionary_enabled(description.path().clone(), true);
        }
    }
    Arc::new(builder.build())
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_possible_wrap)] // places, cases < 2^63
fn encode(
    column: &Column,
    n_swept: usize,
    rows: &Rows,
    description: &ColumnDescPtr,
    properties: &WriterPropertiesPtr,
) -> Result<(Bytes, ColumnCloseResult), ParquetError> {
    let mut sink = TrackedWrite::new(Vec::new());
    let pages = Box::new(SerializedPageWriter::new(&mut sink));
    let mut writer = get_column_writer(description.clone(), properties.clone(), pages);
    let swept = |place: usize| rows.swept.iter().skip(place).step_by(n_swept);
    match (&mut writer, column) {
        (ColumnWriter::Int64ColumnWriter(writer), Column::Case) => {
            let values: Vec<i64> = rows.cases.iter().map(|case| *case as i64).collect();
            writer.write_batch(&values, None, None)?;
        }
        (ColumnWriter::DoubleColumnWriter(writer), Column::Random(place)) => {
            let values: Vec<f64> = swept(*place).copied().collect();
            writer.write_batch(&values, None, None)?;
        }
        (ColumnWriter::DoubleColumnWriter(writer), Column::Number(place, axis)) => {
            let values: Vec<f64> = swept(*place).map(|place| axis.number(*place as u64)).collect();
            writer.write_batch(&values, None, None)?;
        }
        (ColumnWriter::DoubleColumnWriter(writer), Column::Result(column)) => {
            let (mut values, mut levels) = (Vec::with_capacity(BATCH), Vec::with_capacity(BATCH));
            for batch in rows.results.chunks(BATCH) {
                values.clear();
                levels.clear();
                for row in batch {
                    let value = row.as_ref().ok().and_then(column.value);
                    values.extend(value);
                    levels.push(i16::from(value.is_some()));
                }
                writer.write_batch(&values, Some(&levels), None)?;
            }
        }
        (ColumnWriter::ByteArrayColumnWriter(writer), Column::Name(place, names)) => {
            let values: Vec<ByteArray> = swept(*place).map(|place| names[*place as usize].clone()).collect();
            writer.write_batch(&values, None, None)?;
        }
        (ColumnWriter::ByteArrayColumnWriter(writer), Column::Status) => {
            let status = |row: &Result<_, super::plan::Failure>| row.as_ref().map_or_else(|f| f.name(), |_| "ok");
            let of = |row| ByteArray::from(Bytes::from_static(status(row).as_bytes()));
            let values: Vec<ByteArray> = rows.results.iter().map(of).collect();
            writer.write_batch(&values, None, None)?;
        }
        _ => return Err(ParquetError::General("a column is not of its schema's type".to_owned())),
    }
    let close = writer.close()?;
    Ok((Bytes::from(sink.into_inner()?), close))
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
    let mut writer = SerializedFileWriter::new(file, schema, properties.clone()).map_err(failed)?;

    let evaluator = Evaluator::new(job.plan);
    let layout = Layout::new(total, Shard::WHOLE);
    let n_swept = evaluator.n_swept();
    let encode_group = |start: u64| -> Result<Group, ParquetError> {
        let rows = compute(&evaluator, &layout, start..total.min(start + ROW_GROUP));
        let encoded = columns
            .iter()
            .zip(descriptor.columns())
            .map(|(column, description)| encode(column, n_swept, &rows, description, &properties));
        let columns = encoded.collect::<Result<_, _>>()?;
        let restitution = rows.results.iter().map(|row| row.as_ref().ok().map(|row| row.restitution)).collect();
        Ok(Group { columns, restitution })
    };
    let mut tally = Tally::default();
    let mut ready: Vec<Group> = Vec::new();
    let mut next = 0;
    loop {
        if job.is_cancelled.load(Ordering::Relaxed) {
            drop(writer);
            fs::remove_file(&part).map_err(SweepError::file("cannot be removed", &part))?;
            return Err(SweepError::Unsupported(
                "interrupted; a Parquet table starts over, csv and json can be resumed",
            ));
        }
        let mut starts = Vec::new();
        while next < total && starts.len() < rayon::current_num_threads() {
            starts.push(next);
            next = total.min(next.saturating_add(ROW_GROUP));
        }
        let (appended, encoded) = rayon::join(
            || ready.iter().try_for_each(|group| append(&mut writer, group)),
            || starts.into_par_iter().map(encode_group).collect::<Result<Vec<_>, _>>(),
        );
        appended.map_err(failed)?;
        for restitution in ready.iter().flat_map(|group| &group.restitution) {
            tally.push(*restitution, job.plan.is_monte_carlo());
        }
        (job.progress)(Progress { rows: tally.rows, total, resumed: 0 });
        ready = encoded.map_err(failed)?;
        if ready.is_empty() {
            break;
        }
    }
    let file = writer.into_inner().map_err(failed)?;
    file.sync_all().map_err(&unwritable)?;
    fs::rename(&part, table).map_err(SweepError::file("cannot be renamed", &part))?;
    Ok(tally)
}

fn append(writer: &mut SerializedFileWriter<File>, group: &Group) -> Result<(), ParquetError> {
    let mut row_group = writer.next_row_group()?;
    for (bytes, close) in &group.columns {
        row_group.append_column(bytes, close.clone())?;
    }
    row_group.close().map(|_| ())
}
