//! The record, with a line for every column of every run.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::numbers::{Cell, Columns, Place};

/// The summary of a column. Numbers have the shortest digits that give the same bits.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Summary {
    /// Number of values in the column.
    rows: usize,
    /// The first value. If the column has only one value, the rest of the line is empty.
    first: String,
    last: String,
    /// Sum of all numbers, in their order.
    sum: String,
    /// Digest of the bits of all values in their order: 16 hexadecimal digits.
    digest: String,
}

/// A line of the file. Run and file are left out if they are the same as in the line above.
#[derive(Serialize, Deserialize)]
struct Line {
    run: String,
    file: String,
    column: String,
    rows: usize,
    first: String,
    last: String,
    sum: String,
    digest: String,
}

/// The summaries of all columns, by the name of the run.
pub type Record = BTreeMap<String, BTreeMap<Place, Summary>>;

/// The summaries of the columns of a run.
pub fn summaries(columns: &Columns) -> BTreeMap<Place, Summary> {
    columns.iter().map(|(place, cells)| (place.clone(), Summary::of(cells))).collect()
}

impl Summary {
    fn of(cells: &[Cell]) -> Self {
        let first = cells.first().map(written).unwrap_or_default();
        if cells.len() < 2 {
            return Self { rows: cells.len(), first, last: String::new(), sum: String::new(), digest: String::new() };
        }
        let mut hash = Sha256::new();
        let mut sum = 0.0;
        for cell in cells {
            match cell {
                Cell::Number(number) => {
                    sum += number;
                    hash.update([1]);
                    hash.update(number.to_bits().to_le_bytes());
                }
                Cell::Word(word) => {
                    hash.update([2]);
                    hash.update(word.len().to_le_bytes());
                    hash.update(word);
                }
                Cell::Text => hash.update([3]),
                Cell::Empty => hash.update([4]),
            }
        }
        let digest = u64::from_be_bytes(hash.finalize()[..8].try_into().unwrap());
        let last = cells.last().map(written).unwrap_or_default();
        Self { rows: cells.len(), first, last, sum: format!("{sum:?}"), digest: format!("{digest:016x}") }
    }
}

fn written(cell: &Cell) -> String {
    match cell {
        Cell::Number(number) => format!("{number:?}"),
        Cell::Word(word) => word.clone(),
        Cell::Text => "(text)".to_owned(),
        Cell::Empty => String::new(),
    }
}

/// The differences from the record, with a line for each column. A column that is not in the record is ignored.
pub fn differences(record: &Record, now: &Record) -> Vec<String> {
    let mut differences = Vec::new();
    for (run, recorded) in record {
        let Some(columns) = now.get(run) else {
            differences.push(format!("{run}: this run is in the record, but there is no such scenario or variant"));
            continue;
        };
        for ((file, name), before) in recorded {
            let place = [run, file, name].map(String::as_str).join(" · ");
            match columns.get(&(file.clone(), name.clone())) {
                None => differences.push(format!("{place}: is missing")),
                Some(after) if after != before => differences.push(format!("{place}: {}", moved(before, after))),
                Some(_) => {}
            }
        }
    }
    let unknown = now.keys().filter(|run| !record.contains_key(*run));
    differences.extend(unknown.map(|run| format!("{run}: this run is not in the record; write the record anew")));
    differences
}

/// Describes how much the values of a column changed, as far as the record shows it.
fn moved(before: &Summary, after: &Summary) -> String {
    let mut parts = Vec::new();
    if before.rows != after.rows {
        parts.push(format!("{} rows instead of {}", after.rows, before.rows));
    }
    for (what, was, is) in
        [("first", &before.first, &after.first), ("last", &before.last, &after.last), ("sum", &before.sum, &after.sum)]
    {
        if was != is {
            let relative = match (was.parse::<f64>(), is.parse::<f64>()) {
                (Ok(was), Ok(is)) => format!(" (relative {:+.1e})", is / was - 1.0),
                _ => String::new(),
            };
            parts.push(format!("{what} \"{is}\" instead of \"{was}\"{relative}"));
        }
    }
    if parts.is_empty() { "other values between the first and the last".to_owned() } else { parts.join(", ") }
}

/// Reads the record.
pub fn read(path: &Path) -> Record {
    let mut record = Record::new();
    let (mut latest_run, mut latest_file) = (String::new(), String::new());
    for line in csv::Reader::from_path(path).unwrap().deserialize() {
        let Line { run, file, column, rows, first, last, sum, digest } = line.unwrap();
        if !run.is_empty() {
            latest_run = run;
        }
        if !file.is_empty() {
            latest_file = file;
        }
        let place = (latest_file.clone(), column);
        let summary = Summary { rows, first, last, sum, digest };
        record.entry(latest_run.clone()).or_default().insert(place, summary);
    }
    record
}

/// Writes the record.
pub fn write(path: &Path, record: &Record) {
    let mut writer = csv::Writer::from_path(path).unwrap();
    for (run, columns) in record {
        let mut above = None;
        for ((file, column), Summary { rows, first, last, sum, digest }) in columns {
            let line = Line {
                run: if above.is_none() { run.clone() } else { String::new() },
                file: if above == Some(file) { String::new() } else { file.clone() },
                column: column.clone(),
                rows: *rows,
                first: first.clone(),
                last: last.clone(),
                sum: sum.clone(),
                digest: digest.clone(),
            };
            writer.serialize(line).unwrap();
            above = Some(file);
        }
    }
    writer.flush().unwrap();
}
