//! Where a refused value stands: shown to a person with its line and a mark under it, and told to programs.

use std::borrow::Cow;
use std::ops::Range;

use super::file::every_key;
use super::reference::written;
use crate::error::{Details, Error};
use crate::scene::key::Form;
use crate::scene::keys::varied;

/// Characters of a long line that are shown.
const WIDTH: usize = 120;

/// Longer keys and messages quote a value that nobody wrote by hand; the middle of it is left out.
const LONGEST_KEY: usize = 200;
const LONGEST_MESSAGE: usize = 1800;

/// A place in a scenario.
pub(super) struct Place {
    /// How messages about it begin: `scenario.toml:3:10`.
    begin: String,
    /// Its line with a mark under the value, where it stands in a text.
    excerpt: String,
    /// What is known of it.
    details: Details,
}

impl Place {
    /// The file as a whole.
    pub fn file(name: &str) -> Self {
        let details = Details { file: Some(name.to_owned()), ..Details::default() };
        Self { begin: name.to_owned(), excerpt: String::new(), details }
    }

    /// A `--set` of the command line.
    pub fn setting(text: &str) -> Self {
        let value = text.split_once('=').map(|(_, value)| value.to_owned());
        let details = Details { value, ..Details::default() };
        Self { begin: format!("--set {text}"), excerpt: String::new(), details }
    }

    /// The place of `span` (bytes) in the text of a file.
    pub fn in_text(name: &str, text: &str, span: &Range<usize>) -> Self {
        let mut start = span.start.min(text.len());
        while !text.is_char_boundary(start) {
            start -= 1;
        }
        let before = &text[..start];
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let (line, column) = (1 + before.matches('\n').count(), before[line_start..].chars().count());
        let content = text[line_start..].split(['\n', '\r']).next().unwrap_or_default();
        let skipped = if column < WIDTH / 2 { 0 } else { column - WIDTH / 4 };
        // control characters would move the mark, or the terminal
        let visible = |c: char| if c.is_control() { ' ' } else { c };
        let shown: String = content.chars().skip(skipped).take(WIDTH).map(visible).collect();
        let indent = column - skipped;
        let marked =
            text.get(start..span.end).map_or(1, |marked| marked.lines().next().unwrap_or_default().chars().count());
        let width = marked.min(shown.chars().count().saturating_sub(indent)).max(1);
        let (gutter, mark) = (line.to_string().len(), "^".repeat(width));
        Self {
            begin: format!("{name}:{line}:{}", column + 1),
            excerpt: format!("\n{:gutter$} |\n{line} | {shown}\n{:gutter$} | {:indent$}{mark}", "", "", ""),
            details: Details {
                line: Some(line as u64),
                column: Some(column as u64 + 1),
                value: Some(shown.chars().skip(indent).take(width).collect()),
                ..Self::file(name).details
            },
        }
    }

    /// The error of what stands here. The key is empty for the whole file.
    pub fn refuse(self, key: &str, message: &str) -> Error {
        let Self { begin, excerpt, mut details } = self;
        let said = if key.is_empty() { String::new() } else { format!("{}: ", shortened(key, LONGEST_KEY)) };
        let text = format!("{begin}: {said}{}{excerpt}", shortened(message, LONGEST_MESSAGE));
        if details.line.is_some() {
            // where the key itself is refused, the mark is under the key, and there is no value
            let name = key.rsplit('.').next().unwrap_or(key);
            details.value = details.value.filter(|text| text != name && !text.starts_with('['));
        }
        details.allowed = allowed(key);
        details.key = Some(key.to_owned()).filter(|key| !key.is_empty());
        details.message = Some(message.to_owned());
        Error::input(text).with(details)
    }
}

/// What the registry says of a key; that of an axis, of a distribution or of a range is the key that varies.
fn allowed(key: &str) -> Option<String> {
    let key = varied(key);
    // an item of a list has the keys of all its items
    let pattern: String =
        key.split('[').map(|part| part.trim_start_matches(|c: char| c.is_ascii_digit())).collect::<Vec<_>>().join("[");
    match every_key().find(|key| key.path == pattern)?.form {
        Form::Axes | Form::Variables | Form::Free => None,
        Form::Word(words) => Some((words.known)().join(", ")),
        form => Some(written(&form).replace('`', "")),
    }
}

/// At most about `longest` characters of a text: its beginning and its end, where the way out stands.
fn shortened(text: &str, longest: usize) -> Cow<'_, str> {
    let count = text.chars().count();
    if count <= longest {
        return Cow::Borrowed(text);
    }
    let head: String = text.chars().take(longest / 10).collect();
    let tail: String = text.chars().skip(count - longest / 2).collect();
    Cow::Owned(format!("{head} [...] {tail}"))
}
