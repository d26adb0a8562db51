//! The text of a scenario with its overrides: it is read and merged, and messages point into it.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::mark::{Mark, shortened};
use super::reference::{allowed, missing};
use crate::error::{Details, Error, ErrorKind};
use crate::scene::read::Fault;
use crate::scene::written::{Node, choose_law, merge};

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

/// Longer keys and messages quote a value that nobody wrote by hand; the middle of it is left out.
const LONGEST_KEY: usize = 200;
const LONGEST_MESSAGE: usize = 1800;

/// `key=value` from the command line.
#[derive(Debug, Clone)]
struct Override {
    /// As given.
    text: String,
    /// As TOML, behind so many blanks that places in it are behind those of the file and of the overrides before it. So a
    /// place tells its text.
    toml: String,
    /// How many blanks.
    start: usize,
}

impl Override {
    fn parse(text: &str, start: usize) -> Result<Self, Error> {
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
        let blanks = " ".repeat(start);
        let mut toml = blanks.clone() + text;
        if DeTable::parse(&toml).is_err() {
            // a bare word, whose quotes the shell has removed
            toml = format!("{blanks}{key}={}", toml::Value::from(value.trim()));
            DeTable::parse(&toml).map_err(|error| refuse(error.message().trim_end().to_owned()))?;
        }
        Ok(Self { text: text.to_owned(), toml, start })
    }
}

/// A scenario as text: the file and what the command line changes in it.
#[derive(Debug, Clone)]
pub struct Document {
    name: String,
    text: String,
    overrides: Vec<Override>,
    /// Where the values are, by their keys.
    pub(super) places: BTreeMap<String, Range<usize>>,
}

impl Document {
    /// The text of a scenario called `name` (in messages), with `key=value` overrides.
    pub fn new(name: String, text: String, overrides: &[String]) -> Result<Self, Error> {
        let mut start = text.len() + 1;
        let mut document = Self { name, text, overrides: Vec::new(), places: BTreeMap::new() };
        for given in overrides {
            let given = Override::parse(given, start)?;
            start = given.toml.len() + 1;
            document.overrides.push(given);
        }
        Ok(document)
    }

    /// The tables of the file, with those of the overrides.
    pub(super) fn tables(&self) -> Result<Node<'_>, Error> {
        let refuse = |error: toml::de::Error| {
            let message = error.message().trim_end().replace('\n', "; ");
            self.refusal(error.span(), "", &message)
        };
        let mut root = DeTable::parse(&self.text).map_err(refuse)?.into_inner();
        for given in &self.overrides {
            let mut changes = DeTable::parse(&given.toml).map_err(refuse)?.into_inner();
            choose_law(&mut root, &mut changes);
            // the keys to find are one value, which takes the place of that of the file
            if given.text.split('=').next().is_some_and(|key| key.trim() == "calibrate.free")
                && let Some(DeValue::Table(calibrate)) = root.get_mut("calibrate").map(Spanned::get_mut)
            {
                calibrate.remove("free");
            }
            merge(&mut root, changes);
        }
        Ok(Spanned::new(0..0, DeValue::Table(root)))
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
        self.overrides.iter().map(|given| given.toml.trim_start())
    }

    /// The refusals of the keys that were refused while they were read, in the order of the file.
    pub(super) fn refused(&self, mut refused: Vec<(String, Fault)>) -> Vec<Error> {
        refused.sort_by_key(|(_, fault)| fault.span.start);
        let refusal = |(key, Fault { span, message }): (String, Fault)| self.refusal(Some(span), &key, &message);
        refused.into_iter().map(refusal).collect()
    }

    /// A refusal of the value at `key`, pointing at it.
    pub fn refuse(&self, key: &str, message: impl AsRef<str>) -> Error {
        self.refusal(self.places.get(key).cloned(), key, message.as_ref())
    }

    /// Whether the scenario, or the command line, gives the key itself.
    pub fn has(&self, key: &str) -> bool {
        self.places.contains_key(key)
    }

    /// The keys that are given below this beginning, and tables without any key.
    pub(super) fn inside(&self, begin: &str) -> Vec<&str> {
        let keys = self.places.range(begin.to_owned()..).map(|(key, _)| key.as_str());
        let keys: Vec<&str> = keys.take_while(|key| key.starts_with(begin)).collect();
        let is_inner = |key: &str, other: &&str| other.strip_prefix(key).is_some_and(|rest| rest.starts_with('.'));
        keys.iter().copied().filter(|key| !keys.iter().any(|other| is_inner(key, other))).collect()
    }

    /// The refusal of a scenario without `key` in `table` (empty: without the table of that name).
    pub fn missing(&self, table: &str, key: &str) -> Error {
        let needed = format!("{table}.{key}");
        self.refuse(table, missing(key, table)).needing(Some(needed.as_str()).filter(|_| !table.is_empty()))
    }

    /// The refusal where one of these keys is needed; `way_out` says what else can be done.
    pub(super) fn missing_one_of(&self, table: &str, keys: &[&str], way_out: &str) -> Error {
        let mut names = keys.iter().map(|path| path.rsplit('.').next().unwrap_or(path));
        let first = missing(names.next().unwrap_or_default(), table);
        let others: Vec<String> = names.map(|name| format!("`{name}`")).collect();
        let or_others = if others.is_empty() { String::new() } else { format!("; or {}", others.join(", ")) };
        self.refuse(table, first + &or_others + way_out).needing(keys.first().copied())
    }

    /// The refusal of a key that is given beside another key which it stands in place of.
    pub(super) fn one_key(&self, first: &str, second: &str) -> Error {
        let [one, other] = [first, second].map(|path| path.rsplit('.').next().unwrap_or(path));
        self.refuse(second, format!("`{one}` is given too; write only one of `{one}` and `{other}`"))
    }

    fn refusal(&self, span: Option<Range<usize>>, key: &str, message: &str) -> Error {
        let (mut begin, mut excerpt) = (self.name.clone(), String::new());
        let mut details = Details {
            file: Some(self.name.clone()),
            key: Some(key.to_owned()).filter(|key| !key.is_empty()),
            allowed: allowed(key),
            message: Some(message.to_owned()),
            ..Details::default()
        };
        if let Some(span) = span {
            if let Some(Override { text, .. }) = self.overrides.iter().rfind(|given| given.start <= span.start) {
                begin = format!("--set {text}");
                details.file = None;
                details.value = text.split_once('=').map(|(_, value)| value.to_owned());
            } else {
                let Mark { line, column, value, excerpt: marked } = Mark::of(&self.text, &span);
                begin = format!("{begin}:{line}:{column}");
                excerpt = marked;
                (details.line, details.column) = (Some(line as u64), Some(column as u64));
                // where the key itself is refused, the mark is under the key, and there is no value
                let name = key.rsplit('.').next().unwrap_or(key);
                details.value = Some(value).filter(|text| text != name && !text.starts_with('['));
            }
        }
        let said = if key.is_empty() { String::new() } else { format!("{}: ", shortened(key, LONGEST_KEY)) };
        let text = format!("{begin}: {said}{}{excerpt}", shortened(message, LONGEST_MESSAGE));
        Error::input(text).with(details)
    }
}
