//! Why a scenario is refused.

use std::path::PathBuf;

use super::file::every_key;
use super::place::{Place, Refusal};
use super::reference::written;
use crate::error::{Details, Error, ErrorKind};
use crate::scene::key::Form;
use crate::scene::keys::varied;

/// Why a scenario is refused.
#[derive(Debug, thiserror::Error)]
pub enum ScenarioError {
    /// The file system says no.
    #[error("{}: cannot be read: {reason}", .path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: std::io::Error,
    },
    /// Larger than what is read.
    #[error("{}: is larger than {largest} MiB, the most that is read; write long lists as linspace or logspace, or split the file", .path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// In MiB.
        largest: u64,
    },
    /// Not UTF-8.
    #[error("{}:{line}: is not a text file (not UTF-8)", .path.display())]
    NotText {
        /// The file.
        path: PathBuf,
        /// Of the first byte that is no text.
        line: usize,
    },
    /// A `--set` that is no `key=value`.
    #[error("--set {text}: {problem}")]
    Override {
        /// As given.
        text: String,
        /// What is wrong.
        problem: String,
    },
    /// A key or a value.
    #[error("{0}")]
    Refused(Box<Refusal>),
}

impl From<ScenarioError> for Error {
    fn from(error: ScenarioError) -> Self {
        let input = Self::of(ErrorKind::Input, &error);
        match error {
            ScenarioError::Unreadable { path, .. } | ScenarioError::TooLarge { path, .. } => {
                input.about(path.display())
            }
            ScenarioError::NotText { path, line } => {
                let file = Some(path.display().to_string());
                input.with(Details { file, line: Some(line as u64), ..Details::default() })
            }
            ScenarioError::Override { text, problem } => {
                let (key, value) = text.split_once('=').unwrap_or((&text, ""));
                let [key, value] = [key, value].map(|part| Some(part.to_owned()).filter(|part| !part.is_empty()));
                input.with(Details { message: Some(problem), key, value, ..Details::default() })
            }
            ScenarioError::Refused(refusal) => input.with(of_value(*refusal)),
        }
    }
}

/// What programs are told of a value that is refused.
fn of_value(Refusal { place, key, message, .. }: Refusal) -> Details {
    let name = key.rsplit('.').next().unwrap_or(&key);
    // where the key itself is refused, the mark is under the key, and there is no value
    let value = |text: String| Some(text).filter(|text| text != name && !text.starts_with('['));
    let placed = match place {
        Place::File { name } => Details { file: Some(name), ..Details::default() },
        Place::Text { name, line, column, excerpt, indent, width } => Details {
            file: Some(name),
            line: Some(line as u64),
            column: Some(column as u64),
            value: value(excerpt.chars().skip(indent).take(width).collect()),
            ..Details::default()
        },
        Place::Override { text } => {
            Details { value: text.split_once('=').map(|(_, text)| text.to_owned()), ..Details::default() }
        }
    };
    let key = Some(key).filter(|key| !key.is_empty());
    Details { message: Some(message), allowed: key.as_deref().and_then(allowed), key, ..placed }
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
