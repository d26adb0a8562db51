//! A row group: its rows are computed and encoded batch after batch, every column into a buffer of its own.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

use bytes::Bytes;
use parquet::column::writer::{ColumnCloseResult, ColumnWriter, get_column_writer};
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::properties::WriterPropertiesPtr;
use parquet::file::writer::{SerializedPageWriter, TrackedWrite};
use parquet::schema::types::SchemaDescriptor;

use super::columns::{BATCH, is_words};
use crate::plan::axis::Values;
use crate::sweep::column::{Column, status};
use crate::sweep::count::Count;
use crate::sweep::evaluator::{Evaluator, Rows};
use crate::sweep::ordered::Made;
use crate::sweep::pace::Pace;
use crate::sweep::shard::Layout;

/// An encoded column of a row group.
pub(super) type Chunk = (Bytes, ColumnCloseResult);

/// Encodes row groups.
pub(super) struct Encoder<'a> {
    pub(super) pace: Pace<'a>,
    pub(super) evaluator: Evaluator<'a>,
    pub(super) columns: &'a [Column],
    pub(super) descriptor: &'a SchemaDescriptor,
    pub(super) properties: &'a WriterPropertiesPtr,
    /// Columns that hold only one word, already encoded, by column, word and number of rows. Most row groups share
    /// them.
    pub(super) uniform: Mutex<HashMap<(usize, &'a str, usize), Chunk>>,
}

/// A column while it fills.
enum Filling<'w, 'a> {
    Numbers(Box<ColumnWriter<'w>>),
    Words(Runs<'a>),
}

/// Runs of equal words: each word, and how many times it follows itself.
type Runs<'a> = Vec<(&'a str, usize)>;

/// Buffers for the values of a batch.
#[derive(Default)]
struct Batch {
    cases: Vec<i64>,
    numbers: Vec<f64>,
    /// For each row, 1 if it has a number, else 0.
    levels: Vec<i16>,
}

impl<'a> Encoder<'a> {
    /// Computes and encodes the group of these rows of a file; `None` if the run was cancelled.
    pub(super) fn group(
        &self,
        layout: &Layout,
        rows_of_file: Range<u64>,
    ) -> Result<Option<Made<Vec<Chunk>>>, ParquetError> {
        let count = usize::try_from(rows_of_file.end - rows_of_file.start).unwrap_or(0);
        // eight bytes for each number, and 128 bytes for the header of each page
        let sink = || TrackedWrite::new(Vec::with_capacity(count * 8 + (count / BATCH + 1) * 128));
        let mut sinks: Vec<Option<TrackedWrite<Vec<u8>>>> =
            self.columns.iter().map(|column| (!is_words(column)).then(sink)).collect();
        let mut fillings: Vec<Filling> = (0..)
            .zip(&mut sinks)
            .map(|(i, sink)| match sink {
                Some(sink) => Filling::Numbers(Box::new(self.writer(i, sink))),
                None => Filling::Words(Runs::new()),
            })
            .collect();
        let mut counts = Vec::with_capacity(count);
        let (mut rows, mut batch) = (Rows::default(), Batch::default());
        for start in rows_of_file.clone().step_by(BATCH) {
            forget(&mut rows);
            let batch_rows = start..rows_of_file.end.min(start + BATCH as u64);
            let compute =
                |piece| layout.cases(piece).into_iter().for_each(|cases| self.evaluator.rows(cases, &mut rows));
            if !self.pace.walk(batch_rows, compute) {
                return Ok(None);
            }
            for (column, filling) in self.columns.iter().zip(&mut fillings) {
                match filling {
                    Filling::Numbers(writer) => self.numbers(column, &rows, &mut batch, writer)?,
                    Filling::Words(runs) => self.words(column, &rows, runs),
                }
            }
            counts.extend(rows.results.iter().map(Count::of));
        }
        let mut closed = Vec::with_capacity(fillings.len());
        for (i, filling) in fillings.into_iter().enumerate() {
            closed.push(match filling {
                Filling::Numbers(writer) => Ok(writer.close()?),
                Filling::Words(runs) => Err(self.word_chunk(i, &runs)?),
            });
        }
        let chunks = closed.into_iter().zip(sinks).map(|(closed, sink)| match (closed, sink) {
            (Ok(close), Some(sink)) => Ok((Bytes::from(sink.into_inner()?), close)),
            (Ok(_), None) => Err(mismatch()),
            (Err(chunk), _) => Ok(chunk),
        });
        Ok(Some(Made { output: chunks.collect::<Result<_, _>>()?, counts }))
    }

    /// A writer that encodes column `i` into `sink`.
    fn writer<'s>(&self, i: usize, sink: &'s mut TrackedWrite<Vec<u8>>) -> ColumnWriter<'s> {
        let pages = Box::new(SerializedPageWriter::new(sink));
        get_column_writer(self.descriptor.column(i), self.properties.clone(), pages)
    }

    /// Appends the numbers of a batch of rows.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_possible_wrap)] // places, cases < 2^63
    fn numbers(
        &self,
        column: &Column,
        rows: &Rows,
        batch: &mut Batch,
        writer: &mut ColumnWriter,
    ) -> Result<(), ParquetError> {
        let swept = |place: usize| rows.swept.chunks_exact(self.evaluator.n_swept()).map(move |row| row[place]);
        batch.numbers.clear();
        let mut levels = None;
        match column {
            Column::Case => {
                batch.cases.clear();
                batch.cases.extend(rows.cases.iter().map(|case| *case as i64));
            }
            Column::Plain(place) => batch.numbers.extend(swept(*place)),
            Column::Number(place, Values::List(values)) => {
                batch.numbers.extend(swept(*place).map(|place| values[place as usize]));
            }
            Column::Number(place, values) => batch.numbers.extend(swept(*place).map(|place| values.at(place as u64))),
            Column::Result(column) => {
                batch.numbers.resize(rows.results.len(), 0.0);
                batch.levels.resize(rows.results.len(), 0);
                let mut present = 0;
                for (row, level) in rows.results.iter().zip(&mut batch.levels) {
                    let value = row.as_ref().ok().and_then(column.value);
                    // without a branch: an absent value is overwritten by the next present one
                    batch.numbers[present] = value.unwrap_or(0.0);
                    *level = i16::from(value.is_some());
                    present += usize::from(value.is_some());
                }
                batch.numbers.truncate(present);
                levels = Some(batch.levels.as_slice());
            }
            Column::Name(..) | Column::Status => return Err(mismatch()),
        }
        match writer {
            ColumnWriter::Int64ColumnWriter(writer) => writer.write_batch(&batch.cases, None, None)?,
            ColumnWriter::DoubleColumnWriter(writer) => writer.write_batch(&batch.numbers, levels, None)?,
            _ => return Err(mismatch()),
        };
        Ok(())
    }

    /// Appends the words of a batch of rows.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // places on an axis are whole numbers
    fn words(&self, column: &'a Column, rows: &Rows, runs: &mut Runs<'a>) {
        if let Column::Name(place, names) = column {
            let places = rows.swept.chunks_exact(self.evaluator.n_swept()).map(|row| row[*place] as usize);
            places.for_each(|place| push(&names[place], runs));
        } else {
            rows.results.iter().for_each(|row| push(status(row), runs));
        }
    }

    /// Encodes a column of words.
    fn word_chunk(&self, i: usize, runs: &[(&'a str, usize)]) -> Result<Chunk, ParquetError> {
        let uniform = || self.uniform.lock().unwrap_or_else(PoisonError::into_inner);
        let key = if let [(word, count)] = runs { Some((i, *word, *count)) } else { None };
        if let Some(chunk) = key.and_then(|key| uniform().get(&key).cloned()) {
            return Ok(chunk);
        }
        let mut sink = TrackedWrite::new(Vec::new());
        let mut writer = self.writer(i, &mut sink);
        let ColumnWriter::ByteArrayColumnWriter(typed) = &mut writer else { return Err(mismatch()) };
        let mut values = Vec::with_capacity(BATCH);
        for (word, count) in runs {
            let value = ByteArray::from(*word);
            for _ in 0..*count {
                values.push(value.clone());
                if values.len() == BATCH {
                    typed.write_batch(&values, None, None)?;
                    values.clear();
                }
            }
        }
        typed.write_batch(&values, None, None)?;
        let close = writer.close()?;
        let chunk = (Bytes::from(sink.into_inner()?), close);
        if let Some(key) = key {
            uniform().insert(key, chunk.clone());
        }
        Ok(chunk)
    }
}

/// Removes all rows but keeps their memory.
fn forget(rows: &mut Rows) {
    rows.cases.clear();
    rows.swept.clear();
    rows.results.clear();
}

fn push<'a>(word: &'a str, runs: &mut Runs<'a>) {
    match runs.last_mut() {
        // mostly both are the same text in memory, and the letters need no comparison
        Some((last, count)) if std::ptr::eq(*last, word) || *last == word => *count += 1,
        _ => runs.push((word, 1)),
    }
}

fn mismatch() -> ParquetError {
    ParquetError::General("a column is not of its schema's type".to_owned())
}
