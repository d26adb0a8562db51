//! A table as Parquet: batches of rows become Arrow data, which Arrow's writer encodes.

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;
use std::sync::Arc;

use arrow_array::cast::AsArray as _;
use arrow_array::types::Float64Type;
use arrow_array::{Array as _, ArrayRef, Float64Array, Int64Array, RecordBatch, StringArray};
use arrow_schema::{ArrowError, Schema, SchemaRef};
use parquet::arrow::ProjectionMask;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::arrow::arrow_writer::{ArrowWriter, ArrowWriterOptions};
use parquet::errors::ParquetError;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::schema::types::ColumnPath;

use super::TableEncoder;
use super::arrow;
use super::column::{TableColumn, table_columns};
use crate::files::{AtomicFile, PROGRAM};
use crate::scenario::plan::Plan;
use crate::table::Rows;
use crate::table::tally::{RowOutcome, parse_outcome};

/// Rows encoded at a time, and of a page: few enough for the cache.
const BATCH: usize = 4096;
/// The most rows of a row group, which the writer keeps in memory.
const ROW_GROUP: usize = 65_536;
/// Bytes written to the file at a time.
const WRITE_BYTES: usize = 1 << 18;

/// Writes rows as Parquet.
#[derive(Debug)]
pub(in crate::table) struct ParquetEncoder {
    columns: Vec<TableColumn>,
    words: Vec<Option<Arc<StringArray>>>,
    schema: SchemaRef,
    /// The names of the columns with statistics.
    with_statistics: Vec<&'static str>,
}

impl ParquetEncoder {
    pub(in crate::table) fn new(plan: &Plan) -> Result<Self, ParquetError> {
        let columns = table_columns(plan);
        let words = columns.iter().map(|column| Some(Arc::new(StringArray::from(column.categories()?)))).collect();
        let with_statistics = plan.statistics_columns().into_iter().map(|column| column.name).collect();
        let mut parquet = Self { columns, words, schema: Arc::new(Schema::empty()), with_statistics };
        // the types are those of the arrays
        let fields = |arrays: Vec<ArrayRef>| {
            let names = plan.column_names().into_iter().zip(arrays).zip(&parquet.columns);
            let fields = names.map(|((name, array), column)| (name, array, matches!(column, TableColumn::Result(_))));
            RecordBatch::try_from_iter_with_nullable(fields)
        };
        let empty = parquet.arrays(&Rows::default()).and_then(fields)?;
        parquet.schema = empty.schema();
        Ok(parquet)
    }

    /// Numbers hardly repeat, so only words have dictionaries. A page holds the rows of one batch.
    fn properties(&self) -> WriterProperties {
        let mut builder = WriterProperties::builder()
            .set_created_by(PROGRAM.to_owned())
            .set_write_batch_size(BATCH)
            .set_data_page_row_count_limit(BATCH)
            .set_max_row_group_row_count(Some(ROW_GROUP))
            .set_dictionary_enabled(false)
            .set_statistics_enabled(EnabledStatistics::Chunk);
        for (field, _) in self.schema.fields().iter().zip(&self.words).filter(|(_, words)| words.is_some()) {
            builder = builder.set_column_dictionary_enabled(ColumnPath::from(field.name().as_str()), true);
        }
        builder.build()
    }

    /// Rows as Arrow data, column by column.
    #[allow(clippy::cast_possible_wrap)] // cases < 2^63
    fn arrays(&self, rows: &Rows) -> Result<Vec<ArrayRef>, ArrowError> {
        let array = |(column, words): (&TableColumn, &Option<Arc<StringArray>>)| match (column, words) {
            (TableColumn::Case, _) => {
                Ok(Arc::new(rows.cases.iter().map(|case| *case as i64).collect::<Int64Array>()) as ArrayRef)
            }
            (_, Some(words)) => arrow::word_array(&column.values(rows), words),
            (_, None) => Ok(arrow::number_array(column.values(rows))),
        };
        self.columns.iter().zip(&self.words).map(array).collect()
    }
}

/// Counts the rows of a file; true if there are `rows` of them, and all are whole. `names` are the columns with statistics.
fn count_rows(file: File, names: &[&str], rows: u64, count: &mut dyn FnMut(RowOutcome)) -> Result<bool, ParquetError> {
    let reader = ParquetRecordBatchReaderBuilder::try_new(file)?;
    if u64::try_from(reader.metadata().file_metadata().num_rows()).ok() != Some(rows) {
        return Ok(false);
    }
    let mask = ProjectionMask::columns(reader.parquet_schema(), names.iter().copied().chain(["status"]));
    for batch in reader.with_projection(mask).build()? {
        let batch = batch?;
        let numbers = |name: &&str| batch.column_by_name(name)?.as_primitive_opt::<Float64Type>();
        let columns: Option<Vec<_>> = names.iter().map(numbers).collect();
        let states = batch.column_by_name("status").and_then(|column| column.as_string_opt::<i32>());
        let Some((columns, states)) = columns.zip(states) else { return Ok(false) };
        for (row, state) in states.iter().enumerate() {
            let value = |column: &&Float64Array| if column.is_valid(row) { column.value(row) } else { f64::NAN };
            let Some(one) = parse_outcome(state.unwrap_or_default(), columns.iter().map(value).collect()) else {
                return Ok(false);
            };
            count(one);
        }
    }
    Ok(true)
}

impl TableEncoder for ParquetEncoder {
    type Chunk = RecordBatch;
    type Writer = ArrowWriter<BufWriter<AtomicFile>>;

    const BATCH_ROWS: u64 = BATCH as u64;

    fn header(&self) -> &[u8] {
        b"PAR1"
    }

    fn is_own(&self, path: &Path) -> io::Result<bool> {
        // a file that is no Parquet is of another program too
        let reader = ParquetRecordBatchReaderBuilder::try_new(File::open(path)?);
        let program = |name: &str| name.split(' ').next().map(str::to_owned);
        let writer = reader.ok().and_then(|reader| program(reader.metadata().file_metadata().created_by()?));
        Ok(writer.is_some() && writer == program(PROGRAM))
    }

    fn encode(&self, rows: &Rows) -> io::Result<RecordBatch> {
        let arrays = self.arrays(rows).map_err(io::Error::other)?;
        RecordBatch::try_new(self.schema.clone(), arrays).map_err(io::Error::other)
    }

    fn begin(&self, file: AtomicFile) -> io::Result<Self::Writer> {
        // the columns of words are plain strings to those who read the file
        let options = ArrowWriterOptions::new().with_properties(self.properties()).with_skip_arrow_metadata(true);
        let file = BufWriter::with_capacity(WRITE_BYTES, file);
        ArrowWriter::try_new_with_options(file, self.schema.clone(), options).map_err(io_error)
    }

    fn append(&self, writer: &mut Self::Writer, piece: &RecordBatch) -> io::Result<()> {
        writer.write(piece).map_err(io_error)
    }

    fn finish(&self, writer: Self::Writer) -> io::Result<AtomicFile> {
        writer.into_inner().map_err(io_error)?.into_inner().map_err(io::IntoInnerError::into_error)
    }

    fn read(&self, path: &Path, rows: u64, count: &mut dyn FnMut(RowOutcome)) -> io::Result<bool> {
        // a file that is no Parquet is torn too
        Ok(count_rows(File::open(path)?, &self.with_statistics, rows, count).unwrap_or(false))
    }
}

/// The error of the file system in an error of the writer, if there is one.
fn io_error(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(source) => match source.downcast::<io::Error>() {
            Ok(source) => *source,
            Err(source) => io::Error::other(source),
        },
        other => io::Error::other(other),
    }
}
