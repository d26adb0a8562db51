//! The text of a scenario with its overrides: it is read and merged, and messages point into it.

use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::Path;

use super::explain::missing;
use super::overrides::choose_law;
use super::place::Place;
use crate::error::{Details, Error, ErrorKind};
use crate::scene::read::Fault;
use crate::scene::written::{Node, Table, Value};

/// Largest scenario \[MiB\]: room for 50 000 values. Reading takes a hundred times the memory of the text.
pub const LARGEST_SCENARIO: u64 = 1;

/// Largest file of measurements \[MiB\].
pub const LARGEST_DATA: u64 = 64;

/// Reads a text file of at most so many MiB, so that an endless device does not fill the memory.
pub fn read_text(path: &Path, largest: u64) -> Result<String, Error> {
    text_of(path, File::open(path).map_err(unreadable(path))?, largest)
}

fn unreadable(path: &Path) -> impl Fn(std::io::Error) -> Error {
    Error::of_file(ErrorKind::Input, path, "cannot be read", "")
}

/// The same of what is already open; `path` stands for it in messages.
pub fn text_of(path: &Path, from: impl Read, largest: u64) -> Result<String, Error> {
    let most = largest << 20;
    let mut bytes = Vec::new();
    from.take(most + 1).read_to_end(&mut bytes).map_err(unreadable(path))?;
    let file = path.display().to_string();
    if bytes.len() as u64 > most {
        let reason = format!(
            "is larger than {largest} MiB, the most that is read; write long lists as linspace or logspace, or split the file"
        );
        return Err(Error::in_file(ErrorKind::Input, &file, reason));
    }
    String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let line = 1 + String::from_utf8_lossy(&error.as_bytes()[..good]).matches('\n').count();
        let text = format!("{file}:{line}: is not a text file (not UTF-8)");
        Error::input(text).with(Details { file: Some(file), line: Some(line as u64), ..Details::default() })
    })
}

/// The most refusals that are told at once.
const MOST_REFUSALS: usize = 10;

/// `key=value` from the command line.
#[derive(Debug, Clone)]
struct Override {
    /// As given.
    text: String,
    /// As TOML.
    toml: String,
    /// Where its places begin: behind those of the file and of the overrides before it. So a place tells its text.
    start: usize,
}

impl Override {
    fn parse(text: &str, start: usize) -> Result<(Self, Table), Error> {
        let refuse = |problem: String| {
            let (key, value) = text.split_once('=').unwrap_or((text, ""));
            let [key, value] = [key, value].map(|part| Some(part.to_owned()).filter(|part| !part.is_empty()));
            let told = Error::input(format!("--set {text}: {problem}"));
            told.with(Details { message: Some(problem), key, value, ..Details::default() })
        };
        let (key, value) = text
            .split_once('=')
            .filter(|(key, value)| !key.trim().is_empty() && !value.trim().is_empty())
            .ok_or_else(|| refuse("write key=value, such as impact.speed=\"1 m/s\"".to_owned()))?;
        if text.contains(|c: char| c.is_control() && c != '\t') {
            return Err(refuse(
                "a line break or another control character is in it; write --set anew for every key".to_owned(),
            ));
        }
        let (toml, table) = if let Ok(table) = Table::parse(text, start) {
            (text.to_owned(), Ok(table))
        } else {
            // a bare word, whose quotes the shell has removed
            let toml = format!("{key}={}", toml::Value::from(value.trim()));
            let table = Table::parse(&toml, start);
            (toml, table)
        };
        let table = table.map_err(|error| refuse(error.message().trim_end().to_owned()))?;
        Ok((Self { text: text.to_owned(), toml, start }, table))
    }
}

/// A scenario as text: the file and what the command line changes in it.
#[derive(Debug, Clone)]
pub struct Document {
    name: String,
    text: String,
    overrides: Vec<Override>,
    /// The tables of the file, with those of the overrides.
    pub(super) root: Node,
}

impl Document {
    /// The text of a scenario called `name` (in messages), with `key=value` overrides.
    pub fn new(name: String, text: String, overrides: &[String]) -> Result<Self, Error> {
        let whole = |table| Node { span: 0..0, value: Value::Table(table) };
        let parsed = Table::parse(&text, 0);
        let mut document = Self { name, text, overrides: Vec::new(), root: whole(Table::default()) };
        let mut root = parsed.map_err(|error| {
            let message = error.message().trim_end().replace('\n', "; ");
            document.refusal(error.span(), "", &message)
        })?;
        let mut start = document.text.len() + 1;
        for given in overrides {
            let (given, mut changes) = Override::parse(given, start)?;
            start += given.toml.len() + 1;
            choose_law(&mut root, &mut changes);
            root.merge(changes);
            document.overrides.push(given);
        }
        document.root = whole(root);
        Ok(document)
    }

    /// What the scenario is called in messages: its file.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The text of the file.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// `key=value` of the command line, as given.
    pub fn overrides(&self) -> Vec<String> {
        self.overrides.iter().map(|given| given.text.clone()).collect()
    }

    /// The same as TOML.
    pub fn settings(&self) -> impl Iterator<Item = &str> {
        self.overrides.iter().map(|given| &*given.toml)
    }

    /// The refusal of the keys that were refused while they were read, in the order of the file.
    pub(super) fn refused(&self, mut refused: Vec<(String, Fault)>) -> Option<Error> {
        refused.sort_by_key(|(_, fault)| fault.span.start);
        let refusals = refused.into_iter().take(MOST_REFUSALS);
        let refusals = refusals.map(|(key, Fault { span, message })| self.refusal(Some(span), &key, &message));
        refusals.reduce(|all, other| all.and(&other))
    }

    /// A refusal of the value at `key`, pointing at it.
    pub fn refuse(&self, key: &str, message: impl AsRef<str>) -> Error {
        self.refusal(self.root().span_of(key), key, message.as_ref())
    }

    /// Whether the scenario, or the command line, gives the key itself.
    pub fn has(&self, key: &str) -> bool {
        self.root().span_of(key).is_some()
    }

    /// The refusal of a scenario without `key` in `table` (empty: without the table of that name).
    pub fn missing(&self, table: &str, key: &str) -> Error {
        self.refuse(table, missing(key, table))
    }

    /// The refusal where one of these keys is needed; `way_out` says what else can be done.
    pub(super) fn missing_one_of(&self, table: &str, keys: &[&str], way_out: &str) -> Error {
        let mut names = keys.iter().map(|path| path.rsplit('.').next().unwrap_or(path));
        let first = missing(names.next().unwrap_or_default(), table);
        let others: Vec<String> = names.map(|name| format!("`{name}`")).collect();
        let or_others = if others.is_empty() { String::new() } else { format!("; or {}", others.join(", ")) };
        self.refuse(table, first + &or_others + way_out)
    }

    /// The refusal of a key that is given beside another key which it stands in place of.
    pub(super) fn one_key(&self, first: &str, second: &str) -> Error {
        let [one, other] = [first, second].map(|path| path.rsplit('.').next().unwrap_or(path));
        self.refuse(second, format!("`{one}` is given too; write only one of `{one}` and `{other}`"))
    }

    /// The refusal of a table or a key that is given beside a table which it stands in place of.
    pub(super) fn one_table(&self, first: &str, second: &str) -> Error {
        self.refuse(second, format!("[{first}] is given too; write only one of the two"))
    }

    fn refusal(&self, span: Option<Range<usize>>, key: &str, message: &str) -> Error {
        let place = match span {
            None => Place::file(&self.name),
            Some(span) => match self.overrides.iter().rfind(|given| given.start <= span.start) {
                Some(given) => Place::setting(&given.text),
                None => Place::in_text(&self.name, &self.text, &span),
            },
        };
        place.refuse(key, message)
    }

    fn root(&self) -> &Table {
        static NONE: Table = Table(Vec::new());
        if let Value::Table(table) = &self.root.value { table } else { &NONE }
    }
}
