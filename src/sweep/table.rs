//! Rows as text, written straight into a buffer. No field needs a quote in CSV: all are numbers and snake_case names.

use serde::{Deserialize, Serialize};

use super::column::{Column, OK, columns, status};
use super::count::Count;
use super::evaluator::{Failure, Rows};
use crate::plan::Plan;
use crate::plan::axis::Values;

/// What a table is written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// Comma-separated, one header line.
    Csv,
    /// One JSON array of objects, an object a line.
    Json,
    /// Parquet, with the cargo feature `parquet`.
    Parquet,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Csv, Self::Json, Self::Parquet];

    /// File name extension, and the word on the command line.
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
    /// What stands before its value.
    before: Vec<u8>,
    value: FieldValue,
}

/// How the values of a column are written.
#[derive(Debug)]
enum FieldValue {
    /// Case numbers, results, plain numbers, names of a status: written in every row.
    Plain(Column),
    /// By the place on the axis: texts that were rendered once.
    Rendered(usize, Vec<Vec<u8>>),
    /// By the place on an axis that is too long for that: rendered where it changes.
    Long(usize, Values),
}

/// Texts of so many values are rendered before the first row: some milliseconds.
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
    /// The table of a plan; anything but [`Format::Json`] is CSV.
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
        // it is in every table, behind the case
        let restitution = names.iter().position(|name| name == "restitution").unwrap_or(1);
        Self { is_json, names, fields, restitution }
    }

    /// What the file begins with, ending in a line end.
    pub fn header(&self) -> Vec<u8> {
        let mut header = if self.is_json { "[".to_owned() } else { self.names.join(",") };
        header.push('\n');
        header.into_bytes()
    }

    /// What the file ends with.
    pub fn footer(&self) -> &'static [u8] {
        if self.is_json { b"]\n" } else { b"" }
    }

    /// Appends the rows; `is_end`: the last of them is the last of the file.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // places on an axis are whole numbers
    pub fn write(&self, rows: &Rows, is_end: bool, text: &mut Vec<u8>) {
        let n_swept = if rows.cases.is_empty() { 0 } else { rows.swept.len() / rows.cases.len() };
        let mut integers = itoa::Buffer::new();
        let mut floats = zmij::Buffer::new();
        // places on long axes and their texts: a slow axis stays where it is for many rows
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
            // behind the last row of the array stands no comma
            text.truncate(text.len() - 2);
            text.push(b'\n');
        }
    }
}

/// What a complete line says, as far as resuming and merging need it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Case number.
    pub case: u64,
    /// e, or why there is none.
    pub count: Count,
}

impl TextTable {
    /// Reads a line (without its line end); `None` if it is no row of this table. `is_end`: it is the last row of the file.
    /// Checks what is cheap: that all fields are there and of plain characters, the case, e and the status.
    pub fn read(&self, line: &[u8], is_end: bool) -> Option<Line> {
        let line = match (self.is_json, is_end) {
            (true, true) => line.strip_suffix(b"\"}")?,
            (true, false) => line.strip_suffix(b"\"},")?,
            (false, _) => line,
        };
        // without an early end, so that the compiler takes many bytes at once
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
        Some(Line { case, count })
    }
}
