//! Rows as text, written directly into a buffer. No field of CSV needs quotes: all are numbers or names without commas.

use serde::{Deserialize, Serialize};

use super::column::{Column, OK, columns, status};
use super::count::Count;
use super::evaluator::{Failure, Rows};
use crate::plan::Plan;
use crate::plan::axis::Values;

/// The file format of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// Comma-separated values with one header line.
    Csv,
    /// One JSON array of objects, each object on a line of its own.
    Json,
    /// Parquet; needs the cargo feature `parquet`.
    Parquet,
}

impl Format {
    /// All formats.
    pub const ALL: [Self; 3] = [Self::Csv, Self::Json, Self::Parquet];

    /// The file name extension, which is also the word on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Parquet => "parquet",
        }
    }
}

/// Writes rows as lines of text.
#[derive(Debug)]
pub struct TextTable {
    is_json: bool,
    names: Vec<String>,
    fields: Vec<Field>,
    /// Place of e among the columns.
    restitution: usize,
}

/// A column as text.
#[derive(Debug)]
struct Field {
    /// The text before its value.
    before: Vec<u8>,
    value: FieldValue,
}

/// How the values of a column are written.
#[derive(Debug)]
enum FieldValue {
    /// Case numbers, results, plain numbers and the status: converted to text in every row.
    Plain(Column),
    /// Values of an axis, converted to text once: the place of the axis, and the texts.
    Rendered(usize, Vec<Vec<u8>>),
    /// Values of a longer axis, converted to text when they change: the place of the axis, and the values.
    Long(usize, Values),
}

/// An axis with up to this number of values is converted to text before the first row, which takes some milliseconds.
const RENDERED: usize = 1 << 15;

impl FieldValue {
    fn of(column: Column, is_json: bool) -> Self {
        let render = |value: &f64| zmij::Buffer::new().format(*value).as_bytes().to_vec();
        match column {
            Column::Name(place, names) => {
                let quote = if is_json { "\"" } else { "" };
                Self::Rendered(place, names.iter().map(|name| format!("{quote}{name}{quote}").into()).collect())
            }
            Column::Number(place, Values::List(values)) if values.len() <= RENDERED => {
                Self::Rendered(place, values.iter().map(render).collect())
            }
            Column::Number(place, values) => Self::Long(place, values),
            plain => Self::Plain(plain),
        }
    }
}

impl TextTable {
    /// The table of a plan, as JSON for [`Format::Json`], else as CSV.
    pub fn new(plan: &Plan, format: Format) -> Self {
        let is_json = format == Format::Json;
        let names = plan.column_names();
        let field = |(name, column): (&String, Column)| {
            let is_first = matches!(column, Column::Case);
            let separator = if is_first { "" } else { "," };
            let quote = if matches!(column, Column::Status) { "\"" } else { "" };
            let before = match (is_json, is_first) {
                (true, true) => format!("{{\"{name}\":"),
                (true, false) => format!(",\"{name}\":{quote}"),
                (false, _) => separator.to_owned(),
            };
            Field { before: before.into_bytes(), value: FieldValue::of(column, is_json) }
        };
        let fields = names.iter().zip(columns(plan)).map(field).collect();
        // every table has this column, after the case
        let restitution = names.iter().position(|name| name == "restitution").unwrap_or(1);
        Self { is_json, names, fields, restitution }
    }

    /// The first line of the file, with its line end.
    pub fn header(&self) -> Vec<u8> {
        let mut header = if self.is_json { "[".to_owned() } else { self.names.join(",") };
        header.push('\n');
        header.into_bytes()
    }

    /// The text after the last row.
    pub fn footer(&self) -> &'static [u8] {
        if self.is_json { b"]\n" } else { b"" }
    }

    /// Appends the rows. `is_end` says that the last of them is the last row of the file.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // places on an axis are whole numbers
    pub fn write(&self, rows: &Rows, is_end: bool, text: &mut Vec<u8>) {
        let n_swept = if rows.cases.is_empty() { 0 } else { rows.swept.len() / rows.cases.len() };
        let mut integers = itoa::Buffer::new();
        let mut floats = zmij::Buffer::new();
        // the last place and text of each long axis: the place of a slow axis stays the same for many rows
        let mut last: Vec<(u64, String)> = vec![(u64::MAX, String::new()); n_swept];
        let end: &[u8] = if self.is_json { b"\"},\n" } else { b"\n" };
        for (row, (case, result)) in rows.cases.iter().zip(&rows.results).enumerate() {
            let swept = &rows.swept[row * n_swept..];
            for field in &self.fields {
                text.extend_from_slice(&field.before);
                match &field.value {
                    FieldValue::Plain(Column::Result(column)) => match result.as_ref().ok().and_then(column.value) {
                        Some(value) => text.extend_from_slice(floats.format(value).as_bytes()),
                        None if self.is_json => text.extend_from_slice(b"null"),
                        None => {}
                    },
                    FieldValue::Rendered(place, texts) => text.extend_from_slice(&texts[swept[*place] as usize]),
                    FieldValue::Long(place, values) => {
                        let (at, last) = (swept[*place] as u64, &mut last[*place]);
                        if last.0 != at {
                            last.0 = at;
                            last.1.clear();
                            last.1.push_str(floats.format(values.at(at)));
                        }
                        text.extend_from_slice(last.1.as_bytes());
                    }
                    FieldValue::Plain(Column::Case) => text.extend_from_slice(integers.format(*case).as_bytes()),
                    FieldValue::Plain(Column::Plain(place)) => {
                        text.extend_from_slice(floats.format(swept[*place]).as_bytes());
                    }
                    FieldValue::Plain(_) => text.extend_from_slice(status(result).as_bytes()),
                }
            }
            text.extend_from_slice(end);
        }
        if is_end && self.is_json && !rows.cases.is_empty() {
            // no comma after the last row of the array
            text.truncate(text.len() - 2);
            text.push(b'\n');
        }
    }
}

impl TextTable {
    /// Reads a line without its line end: its case, and how the row counts; `None` if it is not a row of this table. `is_end` says that it is the last
    /// row of the file. Checks the number of fields, their characters, the case, e and the status, but not the other
    /// numbers.
    pub fn read(&self, line: &[u8], is_end: bool) -> Option<(u64, Count)> {
        let line = match (self.is_json, is_end) {
            (true, true) => line.strip_suffix(b"\"}")?,
            (true, false) => line.strip_suffix(b"\"},")?,
            (false, _) => line,
        };
        // no early exit, so that the compiler can check many bytes at once
        let is_plain = line.iter().fold(true, |is_plain, byte| is_plain & byte.is_ascii_graphic());
        let commas: usize =
            line.chunks(255).map(|part| usize::from(part.iter().map(|b| u8::from(*b == b',')).sum::<u8>())).sum();
        if !is_plain || commas + 1 != self.fields.len() {
            return None;
        }
        let mut rest = line;
        let mut field = |before: &[u8]| {
            rest = rest.strip_prefix(before)?;
            let (field, after) = rest.split_at(rest.iter().position(|byte| *byte == b',').unwrap_or(rest.len()));
            rest = after;
            std::str::from_utf8(field).ok()
        };
        let (case, swept) = self.fields.get(..=self.restitution)?.split_first()?;
        let case = field(&case.before)?.parse().ok()?;
        let mut restitution = "";
        for one in swept {
            restitution = field(&one.before)?;
        }
        let last = rest.get(rest.iter().rposition(|byte| *byte == b',')?..)?;
        let status = last.strip_prefix(self.fields.last()?.before.as_slice())?;
        let count = if status != OK.as_bytes() {
            Failure::from_name(status)?.into()
        } else if restitution == if self.is_json { "null" } else { "" } {
            Count::AtRest
        } else {
            Count::Restitution(restitution.parse().ok()?)
        };
        Some((case, count))
    }
}
