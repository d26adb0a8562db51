//! The text of a scenario with its overrides: it is read and merged, and messages point into it.

use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::ScenarioError;
use super::entries::Entries;
use super::explain::{missing, span_of};
use super::overrides::choose_law;
use super::place::{Place, Refusal};
use super::values::Refused;
use crate::scene::taken::Taken;

/// Largest scenario \[MiB\]: room for 50 000 values. Reading takes a hundred times the memory of the text.
pub const LARGEST_SCENARIO: u64 = 1;

/// Reads a text file of at most so many MiB, so that an endless device does not fill the memory.
pub fn read_text(path: &Path, largest: u64) -> Result<String, ScenarioError> {
    let file = File::open(path).map_err(|reason| ScenarioError::Unreadable { path: path.to_owned(), reason })?;
    text_of(path, file, largest)
}

/// The same of what is already open; `path` stands for it in messages.
pub fn text_of(path: &Path, from: impl Read, largest: u64) -> Result<String, ScenarioError> {
    let unreadable = |reason| ScenarioError::Unreadable { path: path.to_owned(), reason };
    let most = largest << 20;
    let mut bytes = Vec::new();
    from.take(most + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > most {
        return Err(ScenarioError::TooLarge { path: path.to_owned(), largest });
    }
    String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let line = 1 + String::from_utf8_lossy(&error.as_bytes()[..good]).matches('\n').count();
        ScenarioError::NotText { path: path.to_owned(), line }
    })
}

/// `key=value` from the command line.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Override {
    /// As given.
    text: String,
    /// As TOML.
    toml: String,
    /// Where its places begin: behind those of the file and of the overrides before it. So a place tells its text.
    start: usize,
}

impl Override {
    fn parse(text: &str, start: usize) -> Result<Self, ScenarioError> {
        let refuse = |problem: String| ScenarioError::Override { text: text.to_owned(), problem };
        let (key, value) = text
            .split_once('=')
            .filter(|(key, value)| !key.trim().is_empty() && !value.trim().is_empty())
            .ok_or_else(|| refuse("write key=value, such as impact.speed=\"1 m/s\"".to_owned()))?;
        if text.contains(|c: char| c.is_control() && c != '\t') {
            return Err(refuse(
                "a line break or another control character is in it; write --set anew for every key".to_owned(),
            ));
        }
        let toml = match DeTable::parse(text) {
            Ok(_) => text.to_owned(),
            // a bare word, whose quotes the shell has removed
            Err(_) => format!("{key}={}", toml::Value::from(value.trim())),
        };
        DeTable::parse(&toml).map_err(|error| refuse(error.message().trim_end().to_owned()))?;
        Ok(Self { text: text.to_owned(), toml, start })
    }
}

/// A scenario as text: the file and what the command line changes in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Document {
    name: String,
    text: String,
    overrides: Vec<Override>,
}

impl Document {
    /// The text of a scenario called `name` (in messages), with `key=value` overrides.
    pub fn new(name: String, text: String, overrides: &[String]) -> Result<Self, ScenarioError> {
        let mut start = text.len() + 1;
        let mut document = Self { name, text, overrides: Vec::new() };
        for given in overrides {
            let given = Override::parse(given, start)?;
            start += given.toml.len() + 1;
            document.overrides.push(given);
        }
        document.root()?;
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

    /// Reads every key of the merged tables, and what is taken from materials.
    pub(super) fn entries(&self) -> Result<(Entries, Vec<Taken>), ScenarioError> {
        let root = self.root()?;
        let read = Entries::read(&root).and_then(|mut entries| {
            let taken = entries.take_materials()?;
            Ok((entries, taken))
        });
        read.map_err(|Refused { key, fault }| self.refusal(Some(fault.span), key, fault.message))
    }

    /// A refusal of the value at `key`, pointing at it.
    pub fn refuse(&self, key: &str, message: impl Into<String>) -> ScenarioError {
        let span = self.root().ok().and_then(|root| span_of(&root, key));
        self.refusal(span, key.to_owned(), message.into())
    }

    /// Whether the scenario, or the command line, gives the key itself.
    pub fn has(&self, key: &str) -> bool {
        self.root().is_ok_and(|root| span_of(&root, key).is_some())
    }

    /// The refusal of a scenario without `key` in `table` (empty: without the table of that name).
    pub fn missing(&self, table: &str, key: &str) -> ScenarioError {
        self.refuse(table, missing(key, table))
    }

    /// The refusal where one of these keys is needed; `way_out` says what else can be done.
    pub(super) fn missing_one_of(&self, table: &str, keys: &[&str], way_out: &str) -> ScenarioError {
        let mut names = keys.iter().map(|path| path.rsplit('.').next().unwrap_or(path));
        let first = missing(names.next().unwrap_or_default(), table);
        let others: Vec<String> = names.map(|name| format!("`{name}`")).collect();
        let or_others = if others.is_empty() { String::new() } else { format!("; or {}", others.join(", ")) };
        self.refuse(table, first + &or_others + way_out)
    }

    /// The refusal of a key that is given beside another key which it stands in place of.
    pub(super) fn one_key(&self, first: &str, second: &str) -> ScenarioError {
        let [one, other] = [first, second].map(|path| path.rsplit('.').next().unwrap_or(path));
        self.refuse(second, format!("`{one}` is given too; write only one of `{one}` and `{other}`"))
    }

    /// The refusal of a table or a key that is given beside a table which it stands in place of.
    pub(super) fn one_table(&self, first: &str, second: &str) -> ScenarioError {
        self.refuse(second, format!("[{first}] is given too; write only one of the two"))
    }

    fn refusal(&self, span: Option<Range<usize>>, key: String, message: String) -> ScenarioError {
        let place = match span {
            None => Place::File { name: self.name.clone() },
            Some(span) => match self.overrides.iter().rfind(|given| given.start <= span.start) {
                Some(given) => Place::Override { text: given.text.clone() },
                None => Place::in_text(&self.name, &self.text, &span),
            },
        };
        ScenarioError::Refused(Box::new(Refusal { place, key, message }))
    }

    fn root(&self) -> Result<DeTable<'_>, ScenarioError> {
        let parse = |toml, start| match DeTable::parse(toml) {
            Ok(table) => Ok(moved(table.into_inner(), start)),
            Err(error) => {
                Err(self.refusal(error.span(), String::new(), error.message().trim_end().replace('\n', "; ")))
            }
        };
        let mut root = parse(&self.text, 0)?;
        for given in &self.overrides {
            let mut changes = parse(&given.toml, given.start)?;
            choose_law(&mut root, &mut changes);
            merge(&mut root, changes);
        }
        Ok(root)
    }
}

/// A table whose places begin at `start`.
fn moved(table: DeTable<'_>, start: usize) -> DeTable<'_> {
    if start == 0 {
        return table;
    }
    table.into_iter().map(|(key, value)| (further(key, start), moved_value(value, start))).collect()
}

fn moved_value(value: Spanned<DeValue<'_>>, start: usize) -> Spanned<DeValue<'_>> {
    let mut value = further(value, start);
    match value.get_mut() {
        DeValue::Table(table) => *table = moved(std::mem::take(table), start),
        DeValue::Array(items) => {
            for item in items.iter_mut() {
                *item = moved_value(item.clone(), start);
            }
        }
        _ => {}
    }
    value
}

fn further<T>(place: Spanned<T>, by: usize) -> Spanned<T> {
    let span = place.span();
    Spanned::new(span.start + by..span.end + by, place.into_inner())
}

fn merge<'a>(into: &mut DeTable<'a>, from: DeTable<'a>) {
    for (key, value) in from {
        match (into.get_mut(key.get_ref().as_ref()).map(Spanned::get_mut), value.get_ref()) {
            (Some(DeValue::Table(old)), DeValue::Table(_)) => {
                if let DeValue::Table(new) = value.into_inner() {
                    merge(old, new);
                }
            }
            _ => {
                into.insert(key, value);
            }
        }
    }
}
