//! The text of a scenario with its overrides: both are parsed and merged, and messages point to positions in them.

pub mod edit;
pub(in crate::scenario) mod excerpt;

use std::collections::BTreeMap;
use std::fs::File;
use std::io::Read;
use std::ops::Range;
use std::path::Path;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::input::read_input::is_at_or_below;
use super::input::reader::ValueError;
use super::key_docs::{allowed_value, missing_message};
use super::syntax::syntax_message;
use super::toml_node::{TomlValue, collect_spans};
use crate::error::{Details, Error, ErrorKind};
use edit::Change;
use excerpt::{Excerpt, elide_middle};

/// Largest scenario \[MiB\], which holds 50 000 values. Parsing takes a hundred times the memory of the text.
pub const MAX_SCENARIO_MIB: u64 = 1;

/// Largest file of measurements \[MiB\].
pub const MAX_DATA_MIB: u64 = 64;

/// Reads a text file of at most `largest` MiB, so that an endless device does not fill the memory.
pub fn read_text(path: &Path, largest: u64) -> Result<String, Error> {
    read_open_file(path, File::open(path).map_err(unreadable_error(path))?, largest)
}

fn unreadable_error(path: &Path) -> impl Fn(std::io::Error) -> Error {
    Error::from_io(ErrorKind::Input, path, "cannot be read", "")
}

/// Reads an open file; messages name it by `path`.
pub fn read_open_file(path: &Path, from: impl Read, largest: u64) -> Result<String, Error> {
    let most = largest << 20;
    let mut bytes = Vec::new();
    from.take(most + 1).read_to_end(&mut bytes).map_err(unreadable_error(path))?;
    let file = path.display().to_string();
    if bytes.len() as u64 > most {
        // data have no short form
        let is_scenario = path.extension().is_none_or(|end| end == "toml");
        let way_out = if is_scenario { "Write long lists as linspace or logspace." } else { "Split the file." };
        let reason = format!("is larger than {largest} MiB, the limit. {way_out}");
        return Err(Error::for_file(ErrorKind::Input, &file, reason));
    }
    String::from_utf8(bytes).map_err(|error| {
        let good = error.utf8_error().valid_up_to();
        let line = 1 + String::from_utf8_lossy(&error.as_bytes()[..good]).matches('\n').count();
        let text = format!("{file}:{line}: is not a text file (not UTF-8)");
        Error::input(text).with_details(Details { file: Some(file), line: Some(line as u64), ..Details::default() })
    })
}

/// Longer keys and messages quote a generated value; their middle is omitted.
const MAX_KEY_LENGTH: usize = 200;
const MAX_MESSAGE_LENGTH: usize = 1800;

/// A key that the command line changes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Override {
    /// `key=value`, as after --set.
    text: String,
    /// The option that gave it, if it is another one than --set, such as `--speed`.
    option: Option<&'static str>,
}

impl Override {
    /// The key that an option of the command line stands for.
    pub fn of_option(option: &'static str, key: &str, value: &str) -> Self {
        Self { text: format!("{key}={value}"), option: Some(option) }
    }

    /// Overrides by their texts, `key=value`.
    pub fn list(texts: &[impl AsRef<str>]) -> Vec<Self> {
        texts.iter().map(|text| text.as_ref().into()).collect()
    }

    /// The change of the text.
    fn to_change(&self) -> Result<Change, Error> {
        let text = &self.text;
        let refuse = |problem: String| {
            let (key, value) = text.split_once('=').unwrap_or((text, ""));
            let [key, value] = [key, value].map(|part| Some(part.to_owned()).filter(|part| !part.is_empty()));
            let error_at = Error::input(format!("{}: {problem}", self.as_given()));
            error_at.with_details(Details { message: Some(problem), key, value, ..Details::default() })
        };
        let (key, value) = text
            .split_once('=')
            .filter(|(key, value)| !key.trim().is_empty() && !value.trim().is_empty())
            .ok_or_else(|| refuse("write key=value, such as impact.speed=\"1 m/s\"".to_owned()))?;
        if text.contains(|c: char| c.is_control() && c != '\t') {
            return Err(refuse(
                "contains a line break or another control character. Write one --set for each key.".to_owned(),
            ));
        }
        Change::parse(key, value).map_err(|error| refuse(error.message().trim_end().to_owned()))
    }

    fn value(&self) -> Option<&str> {
        self.text.split_once('=').map(|(_, value)| value)
    }

    /// As the command line has it, for messages.
    fn as_given(&self) -> String {
        match self.option {
            Some(option) => format!("{option} {}", self.value().unwrap_or_default()),
            None => format!("--set {}", self.text),
        }
    }
}

impl From<&str> for Override {
    fn from(text: &str) -> Self {
        Self { text: text.to_owned(), option: None }
    }
}

impl From<String> for Override {
    fn from(text: String) -> Self {
        Self { text, option: None }
    }
}

/// The spans of the values of a text, by their keys.
type ValueSpans = BTreeMap<String, Range<usize>>;

fn value_spans(text: &str) -> Result<ValueSpans, toml::de::Error> {
    let mut places = ValueSpans::new();
    let root = DeTable::parse(text)?;
    collect_spans("", &Spanned::new(0..0, DeValue::Table(root.into_inner())), &mut places);
    Ok(places)
}

/// A scenario as text: the file and what the command line changes in it.
#[derive(Debug, Clone)]
pub struct Document {
    name: String,
    text: String,
    overrides: Vec<Override>,
    /// The keys of the overrides.
    overridden: Vec<String>,
    /// The text with the changes of the command line, which is parsed.
    edited: String,
    spans: ValueSpans,
    /// The spans in the text of the file.
    file_spans: ValueSpans,
}

impl Document {
    /// Parses the text of a scenario called `name` (in messages), with `key=value` overrides.
    pub fn new(name: String, text: String, overrides: &[Override]) -> Result<Self, Error> {
        let changes: Vec<Change> = overrides.iter().map(Override::to_change).collect::<Result<_, _>>()?;
        let mut document = Self {
            name,
            edited: text.clone(),
            text,
            overrides: overrides.to_vec(),
            overridden: changes.iter().map(Change::key).collect(),
            spans: ValueSpans::new(),
            file_spans: ValueSpans::new(),
        };
        let refuse = |span: Option<Range<usize>>, message: &str| {
            let message = syntax_message(&document.text, span.as_ref(), message);
            document.error_at(span.map(Location::File), "", &message)
        };
        let in_file = value_spans(&document.text).map_err(|error| refuse(error.span(), error.message()))?;
        if changes.is_empty() {
            document.spans.clone_from(&in_file);
        } else {
            let edited =
                edit::with_changes(&document.text, &changes).map_err(|error| refuse(error.span(), error.message()))?;
            document.spans = value_spans(&edited).map_err(|error| refuse(None, error.message()))?;
            document.edited = edited;
        }
        document.file_spans = in_file;
        Ok(document)
    }

    pub(super) fn tables(&self) -> Result<TomlValue<'_>, Error> {
        let root = DeTable::parse(&self.edited).map_err(|error| self.error_at(None, "", error.message()))?;
        Ok(Spanned::new(0..0, DeValue::Table(root.into_inner())))
    }

    /// The name of the scenario in messages: its file.
    pub fn name(&self) -> &str {
        &self.name
    }

    pub fn original_text(&self) -> &str {
        &self.text
    }

    /// `key=value` of the command line, as given.
    pub fn overrides(&self) -> Vec<String> {
        self.overrides.iter().map(|given| given.text.clone()).collect()
    }

    /// The text with the changes of the command line.
    pub fn edited_text(&self) -> &str {
        &self.edited
    }

    /// The refusals of the keys that were refused during parsing: first in the order of the file, then in the order of the
    /// command line.
    pub(super) fn refusals(&self, refused: Vec<(String, ValueError)>) -> Vec<Error> {
        let mut placed: Vec<_> =
            refused.into_iter().map(|(key, fault)| (self.locate(&key, fault.span), key, fault.message)).collect();
        placed.sort_by_key(|(place, ..)| match place {
            Some(Location::File(span)) => (0, span.start),
            Some(Location::Set(number)) => (1, *number),
            None => (2, 0),
        });
        placed.into_iter().map(|(place, key, message)| self.error_at(place, &key, &message)).collect()
    }

    /// A refusal of the value at `key`, with its position.
    pub fn refusal(&self, key: &str, message: impl AsRef<str>) -> Error {
        let place = self.spans.get(key).and_then(|span| self.locate(key, span.clone()));
        self.error_at(place, key, message.as_ref())
    }

    /// The location of a span of the parsed text that belongs to a key. It is on the command line if an override gives the key or a table
    /// that holds it; otherwise in the file; otherwise at the override that gives the first key of the table.
    fn locate(&self, key: &str, span: Range<usize>) -> Option<Location> {
        let by = |is_this: &dyn Fn(&str) -> bool| self.overridden.iter().rposition(|key| is_this(key));
        if let Some(number) = by(&|given| is_at_or_below(key, given)) {
            return Some(Location::Set(number));
        }
        if let (Some(own), Some(read)) = (self.file_spans.get(key), self.spans.get(key)) {
            let at = |byte: usize| (own.start + byte).saturating_sub(read.start);
            return Some(Location::File(at(span.start)..at(span.end)));
        }
        by(&|given| is_at_or_below(given, key)).map(Location::Set)
    }

    /// True if the scenario or the command line gives the key itself.
    pub fn contains(&self, key: &str) -> bool {
        self.spans.contains_key(key)
    }

    /// The value of a key as written, without quotes.
    pub(super) fn written_value(&self, key: &str) -> Option<&str> {
        self.edited.get(self.spans.get(key)?.clone()).map(|text| text.trim_matches(['"', '\'']))
    }

    /// The given keys whose path begins with this text, and tables without keys.
    pub(super) fn keys_below(&self, begin: &str) -> Vec<&str> {
        let keys = self.spans.range(begin.to_owned()..).map(|(key, _)| key.as_str());
        let keys: Vec<&str> = keys.take_while(|key| key.starts_with(begin)).collect();
        let is_inner = |key: &str, other: &&str| other.strip_prefix(key).is_some_and(|rest| rest.starts_with('.'));
        keys.iter().copied().filter(|key| !keys.iter().any(|other| is_inner(key, other))).collect()
    }

    /// The refusal of a scenario that lacks `key` in `table`; for an empty `table`, that lacks the table `key`.
    pub fn missing_key(&self, table: &str, key: &str) -> Error {
        let needed = format!("{table}.{key}");
        self.refusal(table, missing_message(key, table))
            .with_missing_key(Some(needed.as_str()).filter(|_| !table.is_empty()))
    }

    /// The refusal if one of these keys is needed; `way_out` names other remedies.
    pub(super) fn missing_any_key(&self, table: &str, keys: &[&str], way_out: &str) -> Error {
        let mut names = keys.iter().map(|path| path.rsplit('.').next().unwrap_or(path));
        let first = missing_message(names.next().unwrap_or_default(), table);
        let others: Vec<String> = names.map(|name| format!("`{name}`")).collect();
        let or_others = if others.is_empty() { String::new() } else { format!("; or {}", others.join(", ")) };
        self.refusal(table, first + &or_others + way_out).with_missing_key(keys.first().copied())
    }

    /// The refusal of a key that is given together with its alternative.
    pub(super) fn refuse_both(&self, first: &str, second: &str) -> Error {
        let [one, other] = [first, second].map(|path| path.rsplit('.').next().unwrap_or(path));
        self.refusal(second, format!("`{one}` and `{other}` exclude each other. Remove one of the two."))
    }

    fn error_at(&self, place: Option<Location>, key: &str, message: &str) -> Error {
        let (mut begin, mut excerpt) = (self.name.clone(), String::new());
        let mut details = Details {
            file: Some(self.name.clone()),
            key: Some(key.to_owned()).filter(|key| !key.is_empty()),
            allowed: allowed_value(key),
            message: Some(message.to_owned()),
            ..Details::default()
        };
        match place {
            Some(Location::Set(number)) => {
                begin = self.overrides[number].as_given();
                details.file = None;
                details.value = self.overrides[number].value().map(str::to_owned);
            }
            Some(Location::File(span)) => {
                let Excerpt { line, column, value, marked_line } = Excerpt::new(&self.text, &span);
                begin = format!("{begin}:{line}:{column}");
                excerpt = marked_line;
                (details.line, details.column) = (Some(line as u64), Some(column as u64));
                // if the key itself is refused, the marker is under the key, and there is no value
                let name = key.rsplit('.').next().unwrap_or(key);
                details.value = Some(value).filter(|text| text != name && !text.starts_with('['));
            }
            None => {}
        }
        let place = if key.is_empty() { String::new() } else { format!("{}: ", elide_middle(key, MAX_KEY_LENGTH)) };
        let text = format!("{begin}: {place}{}{excerpt}", elide_middle(message, MAX_MESSAGE_LENGTH));
        Error::input(text).with_details(details)
    }
}

/// The location of a message.
enum Location {
    /// A span of the text of the file, in bytes.
    File(Range<usize>),
    /// The override of the command line with this number.
    Set(usize),
}
