//! A table as CSV, written directly into a buffer. No field needs quotes: all are numbers or names without commas.

use std::fs::File;
use std::io::{self, BufRead as _, BufReader, Write as _};
use std::path::Path;

use super::TableEncoder;
use super::column::{TableColumn, table_columns};
use crate::files::{AtomicFile, begins_like};
use crate::results::ResultColumn;
use crate::scenario::plan::{AxisValues, Plan};
use crate::table::Rows;
use crate::table::tally::{RowOutcome, parse_outcome, status_word};

/// Writes rows as lines of text.
#[derive(Debug)]
pub struct CsvEncoder {
    header: Vec<u8>,
    /// The columns; those of an axis with its values as text, so that they are converted once.
    fields: Vec<(TableColumn, Vec<Vec<u8>>)>,
    /// The places of the columns with statistics among the fields.
    with_statistics: Vec<usize>,
}

/// An axis with up to this number of values is converted to text before the first row, which takes some milliseconds.
const MAX_PRERENDERED: usize = 1 << 15;

/// The values of an axis as text; empty for a long axis.
fn render_axis_values(column: &TableColumn) -> Vec<Vec<u8>> {
    let render = |value: &f64| zmij::Buffer::new().format(*value).as_bytes().to_vec();
    match column {
        TableColumn::AxisWord(_, names) => names.iter().map(|name| name.clone().into_bytes()).collect(),
        TableColumn::AxisValue(_, AxisValues::List(values)) if values.len() <= MAX_PRERENDERED => {
            values.iter().map(render).collect()
        }
        _ => Vec::new(),
    }
}

impl CsvEncoder {
    pub fn new(plan: &Plan) -> Self {
        let names = plan.column_names();
        let place = |column: &ResultColumn| names.iter().position(|name| name == column.name);
        let with_statistics = plan.statistics_columns().iter().filter_map(place).collect();
        let fields = table_columns(plan).into_iter().map(|column| (render_axis_values(&column), column));
        let fields = fields.map(|(texts, column)| (column, texts)).collect();
        Self { header: (names.join(",") + "\n").into_bytes(), fields, with_statistics }
    }

    /// Formats rows as lines of CSV.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // places on an axis are whole numbers
    pub fn rows_as_lines(&self, rows: &Rows) -> Vec<u8> {
        // numbers take up to 24 characters
        let mut text = Vec::with_capacity(rows.cases.len() * 192);
        let n_swept = if rows.cases.is_empty() { 0 } else { rows.axis_values.len() / rows.cases.len() };
        let mut integers = itoa::Buffer::new();
        let mut floats = zmij::Buffer::new();
        for (row, (case, result)) in rows.cases.iter().zip(&rows.results).enumerate() {
            let swept = &rows.axis_values[row * n_swept..];
            for (place, (column, texts)) in self.fields.iter().enumerate() {
                if place > 0 {
                    text.push(b',');
                }
                let number = match column {
                    TableColumn::AxisWord(place, _) | TableColumn::AxisValue(place, _) if !texts.is_empty() => {
                        text.extend_from_slice(&texts[swept[*place] as usize]);
                        continue;
                    }
                    TableColumn::Case => {
                        text.extend_from_slice(integers.format(*case).as_bytes());
                        continue;
                    }
                    TableColumn::AxisWord(..) | TableColumn::Status => {
                        text.extend_from_slice(status_word(result).as_bytes());
                        continue;
                    }
                    TableColumn::Result(column) => result.as_ref().ok().and_then(column.value),
                    TableColumn::AxisValue(place, values) => Some(values.value_at(swept[*place] as u64)),
                    TableColumn::Value(place) => Some(swept[*place]).filter(|number| !number.is_nan()),
                };
                if let Some(number) = number {
                    text.extend_from_slice(floats.format(number).as_bytes());
                }
            }
            text.push(b'\n');
        }
        text
    }

    /// The outcome of a row; `None` if the line is not complete.
    fn parse_line(&self, line: &[u8]) -> Option<RowOutcome> {
        let line = std::str::from_utf8(line).ok()?;
        let (before, status) = line.rsplit_once(',')?;
        if self.with_statistics.is_empty() {
            return parse_outcome(status, Vec::new());
        }
        let fields: Vec<&str> = before.split(',').collect();
        let value = |place: &usize| match *fields.get(*place)? {
            "" => Some(f64::NAN),
            field => field.parse().ok(),
        };
        parse_outcome(status, self.with_statistics.iter().map(value).collect::<Option<_>>()?)
    }
}

impl TableEncoder for CsvEncoder {
    type Chunk = Vec<u8>;
    type Writer = AtomicFile;

    /// This number of rows fits into the cache. Its text is shorter than 128 KiB, from which on `malloc` uses `mmap`: such memory returns
    /// to the system when it is freed, and a new allocation costs a quarter of the time of a row.
    const BATCH_ROWS: u64 = 256;

    fn header(&self) -> &[u8] {
        &self.header
    }

    fn is_own(&self, path: &Path) -> io::Result<bool> {
        begins_like(path, &self.header)
    }

    fn encode(&self, rows: &Rows) -> io::Result<Vec<u8>> {
        Ok(self.rows_as_lines(rows))
    }

    fn begin(&self, mut file: AtomicFile) -> io::Result<AtomicFile> {
        file.write_all(&self.header)?;
        Ok(file)
    }

    fn append(&self, writer: &mut AtomicFile, piece: &Vec<u8>) -> io::Result<()> {
        writer.write_all(piece)
    }

    fn finish(&self, writer: AtomicFile) -> io::Result<AtomicFile> {
        Ok(writer)
    }

    fn read(&self, path: &Path, rows: u64, count: &mut dyn FnMut(RowOutcome)) -> io::Result<bool> {
        let mut reader = BufReader::with_capacity(1 << 18, File::open(path)?);
        let (mut line, mut read) = (Vec::new(), 0);
        reader.read_until(b'\n', &mut line)?;
        if line != self.header {
            return Ok(false);
        }
        line.clear();
        while reader.read_until(b'\n', &mut line)? > 0 {
            let Some(one) = line.strip_suffix(b"\n").and_then(|line| self.parse_line(line)) else { return Ok(false) };
            count(one);
            read += 1;
            line.clear();
        }
        Ok(read == rows)
    }
}
