//! Rows as text, CSV or JSON, and back.
//!
//! Digits are written straight into the block's buffer. No field needs a quote: they are numbers and snake_case names.

use serde::{Deserialize, Serialize};

use super::count::Count;
use super::evaluator::{Failure, Rows};
use crate::plan::axis::{Axis, Setting, Values};
use crate::plan::{Cases, Plan};
use crate::scene::results::Column;

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
    /// File name extension, and the word on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Parquet => "parquet",
        }
    }

    /// The format of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        [Self::Csv, Self::Json, Self::Parquet].into_iter().find(|format| format.name() == name)
    }
}

/// Writes rows as lines of text.
#[derive(Debug)]
pub struct TextTable {
    is_json: bool,
    names: Vec<String>,
    /// What stands before every field.
    before: Vec<Vec<u8>>,
    results: Vec<Column>,
    /// Place of e among the columns.
    restitution: usize,
    /// Of every axis of a grid: how its values are written.
    swept: Vec<Swept>,
}

/// Texts of so many values are rendered before the first row: some milliseconds.
const RENDERED: usize = 1 << 15;

/// How a swept value is written.
#[derive(Debug)]
enum Swept {
    /// As drawn.
    Number,
    /// By its place on the axis: texts rendered once.
    Rendered(Vec<Vec<u8>>),
    /// By its place on an axis too long for that: rendered where it changes.
    Long(Axis),
}

impl TextTable {
    /// The table of a plan; anything but [`Format::Json`] is CSV.
    #[must_use]
    pub fn new(plan: &Plan, format: Format) -> Self {
        let is_json = format == Format::Json;
        let names = plan.column_names();
        let before = (0..)
            .zip(&names)
            .map(|(i, name)| match (is_json, i) {
                (true, 0) => format!("{{\"{name}\":").into_bytes(),
                (true, _) => format!(",\"{name}\":").into_bytes(),
                (false, 0) => Vec::new(),
                (false, _) => b",".to_vec(),
            })
            .collect();
        let swept = match &plan.cases {
            Cases::MonteCarlo { variables, .. } => variables.iter().map(|_| Swept::Number).collect(),
            Cases::Grid(axes) => axes.iter().map(|axis| swept(axis, is_json)).collect(),
        };
        // it is in every table, behind the case
        let restitution = names.iter().position(|name| name == "restitution").unwrap_or(1);
        Self { is_json, names, before, results: plan.results(), restitution, swept }
    }

    /// What the file begins with, ending in a line end.
    #[must_use]
    pub fn header(&self) -> Vec<u8> {
        let mut header = if self.is_json { "[".to_owned() } else { self.names.join(",") };
        header.push('\n');
        header.into_bytes()
    }

    /// What the file ends with.
    #[must_use]
    pub fn footer(&self) -> &'static [u8] {
        if self.is_json { b"]\n" } else { b"" }
    }

    /// Appends the rows; `is_end`: the last of them is the last of the file.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // places on an axis are whole numbers
    pub fn write(&self, rows: &Rows, is_end: bool, text: &mut Vec<u8>) {
        let n_swept = self.swept.len();
        let mut integers = itoa::Buffer::new();
        let mut floats = zmij::Buffer::new();
        // places on long axes and their texts: a slow axis stays where it is for many rows
        let mut last: Vec<(u64, String)> = vec![(u64::MAX, String::new()); n_swept];
        for (row, (case, result)) in rows.cases.iter().zip(&rows.results).enumerate() {
            let mut before = self.before.iter();
            let mut next = |text: &mut Vec<u8>| text.extend_from_slice(before.next().map_or(&[], Vec::as_slice));
            next(text);
            text.extend_from_slice(integers.format(*case).as_bytes());
            for ((swept, value), last) in self.swept.iter().zip(&rows.swept[row * n_swept..]).zip(&mut last) {
                next(text);
                match swept {
                    Swept::Number => text.extend_from_slice(floats.format(*value).as_bytes()),
                    Swept::Rendered(texts) => text.extend_from_slice(&texts[*value as usize]),
                    Swept::Long(axis) => {
                        let place = *value as u64;
                        if last.0 != place {
                            last.0 = place;
                            last.1.clear();
                            last.1.push_str(floats.format(axis.number(place)));
                        }
                        text.extend_from_slice(last.1.as_bytes());
                    }
                }
            }
            for column in &self.results {
                next(text);
                match result.as_ref().ok().and_then(column.value) {
                    Some(value) => text.extend_from_slice(floats.format(value).as_bytes()),
                    None if self.is_json => text.extend_from_slice(b"null"),
                    None => {}
                }
            }
            next(text);
            let status = result.as_ref().map_or_else(|failure| failure.name(), |_| OK);
            if self.is_json {
                text.push(b'"');
                text.extend_from_slice(status.as_bytes());
                text.extend_from_slice(if is_end && row + 1 == rows.cases.len() { b"\"}\n" } else { b"\"},\n" });
            } else {
                text.extend_from_slice(status.as_bytes());
                text.push(b'\n');
            }
        }
    }
}

fn swept(axis: &Axis, is_json: bool) -> Swept {
    let render = |value: f64| zmij::Buffer::new().format(value).as_bytes().to_vec();
    match &axis.setting {
        Setting::Method(_) | Setting::Law(_) => {
            let quote = if is_json { "\"" } else { "" };
            let words = axis.words().unwrap_or_default();
            Swept::Rendered(words.iter().map(|word| format!("{quote}{word}{quote}").into()).collect())
        }
        Setting::Number { values: Values::List(values), .. } if values.len() <= RENDERED => {
            Swept::Rendered(values.iter().copied().map(render).collect())
        }
        Setting::Number { .. } => Swept::Long(axis.clone()),
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

/// What stands for the status of a row with a result.
const OK: &str = "ok";

impl TextTable {
    /// Reads a line (without its line end); `None` if it is no row of this table. `is_end`: it is the last row of the file.
    /// Checks what is cheap: that all fields are there and of plain characters, the case, e and the status.
    #[must_use]
    pub fn read(&self, line: &[u8], is_end: bool) -> Option<Line> {
        let (line, quote): (_, &[u8]) = if self.is_json {
            let object = if is_end { line } else { line.strip_suffix(b",")? };
            (object.strip_suffix(b"}")?, b"\"")
        } else {
            (line, b"")
        };
        // without an early end, so that the compiler takes many bytes at once
        let is_plain = line.iter().fold(true, |is_plain, byte| is_plain & byte.is_ascii_graphic());
        let commas: usize =
            line.chunks(255).map(|part| usize::from(part.iter().map(|b| u8::from(*b == b',')).sum::<u8>())).sum();
        if !is_plain || commas + 1 != self.before.len() {
            return None;
        }
        let mut rest = line;
        let mut field = |before: &[u8]| {
            rest = rest.strip_prefix(before)?;
            let (field, after) = rest.split_at(rest.iter().position(|byte| *byte == b',').unwrap_or(rest.len()));
            rest = after;
            std::str::from_utf8(field).ok()
        };
        let case = field(self.before.first()?)?.parse().ok()?;
        let mut restitution = "";
        for before in self.before.get(1..=self.restitution)? {
            restitution = field(before)?;
        }
        let last = rest.get(rest.iter().rposition(|byte| *byte == b',')?..)?;
        let status = last.strip_prefix(self.before.last()?.as_slice())?.strip_prefix(quote)?.strip_suffix(quote)?;
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
