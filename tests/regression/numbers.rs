//! Reads all numbers of a run from all files that it writes, column by column.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use tempfile::TempDir;

use super::runs::Run;

/// The columns whose words are results, which are compared too. All other texts are messages, names of files, versions,
/// command lines and sources. They are ignored, and so is a column that has only such texts. Today only such texts
/// depend on the machine; a number that does (a time, a number of threads) would have to be left out here.
const WORDS: [&str; 11] = [
    "branch",
    "distribution",
    "ended_by",
    "event",
    "law",
    "method",
    "origin",
    "outcome",
    "solver_method",
    "spot",
    "status",
];

/// Parts of a summary that say again what was asked.
const NOT_RESULTS: [&str; 3] = ["inputs", "provenance", "format_version"];

/// One value of a column.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum Cell {
    Number(f64),
    Word(String),
    Empty,
}

/// The word in place of a text that is not compared.
const TEXT: &str = "(text)";

impl Cell {
    pub fn number(&self) -> Option<f64> {
        match self {
            Self::Number(number) => Some(*number),
            _ => None,
        }
    }
}

/// The place of a column: the file, and the name of the column. In JSON and TOML the name is the path of the keys, and
/// all entries of a list are one column.
pub type Place = (String, String);

/// The values of all columns of a run.
pub type Columns = BTreeMap<Place, Vec<Cell>>;

/// Runs the program in a directory of its own and reads all its files.
pub fn columns(program: &Path, run: &Run) -> Columns {
    let desk = TempDir::new().unwrap();
    fs::create_dir(desk.path().join("out")).unwrap();
    let output = Command::new(program).current_dir(desk.path()).args(&run.arguments).output().unwrap();
    let mut columns = Columns::new();
    for entry in fs::read_dir(desk.path().join("out")).unwrap() {
        let path = entry.unwrap().path();
        let file = path.file_name().unwrap().to_string_lossy().into_owned();
        if file.starts_with('.') {
            // the list of files that the program wrote, with their lengths
            continue;
        }
        let read = || fs::read_to_string(&path).unwrap();
        let mut add = |name: &str, cell| columns.entry((file.clone(), name.to_owned())).or_default().push(cell);
        match path.extension().and_then(|extension| extension.to_str()) {
            Some("csv") => table(&read(), &mut add),
            Some("json") => json_numbers("", &serde_json::from_str(&read()).unwrap(), &mut add),
            Some("toml") => json_numbers("", &toml::from_str(&read()).unwrap(), &mut add),
            _ => {}
        }
    }
    columns.retain(|_, cells| cells.iter().any(|cell| *cell != Cell::Word(TEXT.to_owned())));
    // a variant that is refused writes nothing
    let code = if columns.is_empty() { 2 } else { 0 };
    assert_eq!(output.status.code(), Some(code), "{}: {}", run.name, String::from_utf8_lossy(&output.stderr));
    columns
}

fn table(text: &str, add: &mut impl FnMut(&str, Cell)) {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let headers = reader.headers().unwrap().clone();
    for record in reader.records() {
        for (name, value) in headers.iter().zip(&record.unwrap()) {
            let cell = match value.parse() {
                Ok(number) => finite(number),
                Err(_) if value.is_empty() => Cell::Empty,
                Err(_) => word(name, value),
            };
            add(name, cell);
        }
    }
}

/// The number of entries of a list is a number too.
fn json_numbers(path: &str, value: &Value, add: &mut impl FnMut(&str, Cell)) {
    match value {
        Value::Object(keys) => {
            for (key, value) in keys.iter().filter(|(key, _)| !NOT_RESULTS.contains(&key.as_str())) {
                json_numbers(&join_path(path, key), value, add);
            }
        }
        Value::Array(entries) => {
            add(&join_path(path, "length"), Cell::Number(u32::try_from(entries.len()).unwrap().into()));
            for entry in entries {
                json_numbers(&format!("{path}[]"), entry, add);
            }
        }
        Value::Number(number) => add(path, finite(number.as_f64().unwrap())),
        Value::String(text) => add(path, word(path, text)),
        Value::Bool(truth) => add(path, Cell::Word(truth.to_string())),
        Value::Null => add(path, Cell::Empty),
    }
}

/// NaN and infinity are words.
fn finite(number: f64) -> Cell {
    if number.is_finite() { Cell::Number(number) } else { Cell::Word(number.to_string()) }
}

fn join_path(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

fn word(name: &str, value: &str) -> Cell {
    let key = name.rsplit('.').next().unwrap_or_default();
    Cell::Word(if WORDS.contains(&key) { value } else { TEXT }.to_owned())
}
