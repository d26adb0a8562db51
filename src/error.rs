//! Why a command failed: one type for every failure. Its kind is the exit code. Its text states the mistake, its position, the
//! value and the remedy, and its details state the same for programs.

use std::error::Error as Cause;
use std::fmt::Display;
use std::io;
use std::path::Path;

use serde::Serialize;
use thiserror::Error;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorKind {
    /// A run failed.
    Failed,
    /// The input has to change.
    Input,
    /// Measurements contradict the law.
    Mismatch,
    /// A signal stopped the command: the exit code that a shell gives then.
    Stopped(u8),
}

/// The maximum number of mistakes that are printed after the first one. Programs get all of them.
const MAX_SHOWN_ERRORS: usize = 19;

/// Why a command failed.
#[derive(Debug, Error)]
#[error("{}", self.full_text())]
pub struct Error {
    pub kind: ErrorKind,
    text: String,
    /// The texts of other mistakes that were found with it.
    other_errors: Vec<String>,
    pub details: Box<Details>,
    /// The error of the file system, where that is the reason.
    pub io_error: Option<io::Error>,
}

/// An error in parts, for programs.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Details {
    /// The mistake and the remedy, without the position.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The line, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<u64>,
    /// The column, from 1, in characters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<u64>,
    /// The key, with dots.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub key: Option<String>,
    /// The value, as it is written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<String>,
    /// The allowed values.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub allowed: Option<String>,
    /// The key that has to be given too, with dots.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub missing_key: Option<String>,
    /// The other mistakes that were found with this one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub more_errors: Vec<Details>,
}

impl Error {
    pub fn new(kind: ErrorKind, text: impl Into<String>) -> Self {
        Self { kind, text: text.into(), other_errors: Vec::new(), details: Box::default(), io_error: None }
    }

    /// An option, an argument or a scenario is wrong.
    pub fn input(text: impl Into<String>) -> Self {
        Self::new(ErrorKind::Input, text)
    }

    /// A failure that has nothing to do with the input: of a thread, a signal, standard output.
    pub fn failed(text: impl Into<String>) -> Self {
        Self::new(ErrorKind::Failed, text)
    }

    /// An error of a part of the program, with its causes.
    pub fn caused_by(kind: ErrorKind, error: &dyn Cause) -> Self {
        let causes = std::iter::successors(error.source(), |&cause| cause.source());
        Self::new(kind, causes.fold(error.to_string(), |text, cause| format!("{text}: {cause}")))
    }

    /// Something is wrong with a file as a whole.
    pub fn for_file(kind: ErrorKind, file: &str, reason: impl Display) -> Self {
        Self::new(kind, format!("{file}: {reason}")).with_file(file)
    }

    /// A path on the command line is wrong: it has to change.
    pub fn for_path(path: &Path, reason: impl Display) -> Self {
        Self::for_file(ErrorKind::Input, &path.display().to_string(), reason)
    }

    /// The file system refuses a file; for `map_err`. The problem is such as `cannot be read`. The remedy may be empty.
    pub fn from_io(kind: ErrorKind, path: &Path, problem: &str, way_out: &str) -> impl Fn(io::Error) -> Self {
        let begin = format!("{}: {problem}", path.display());
        move |reason| {
            let separator = if way_out.is_empty() { "" } else { "; " };
            let error = Self::new(kind, format!("{begin}: {reason}{separator}{way_out}")).with_file(path.display());
            Self { io_error: Some(reason), ..error }
        }
    }

    pub fn is_not_found(&self) -> bool {
        self.io_error.as_ref().is_some_and(|reason| reason.kind() == io::ErrorKind::NotFound)
    }

    /// One error that tells all these mistakes; `None` of none.
    pub fn combine(mistakes: Vec<Self>) -> Option<Self> {
        mistakes.into_iter().reduce(|mut all, other| {
            all.other_errors.push(other.text);
            all.other_errors.extend(other.other_errors);
            all.details.more_errors.push(*other.details);
            all
        })
    }

    /// Its text, and those of the other mistakes; of very many it says how many there are.
    fn full_text(&self) -> String {
        let others = self.other_errors.iter().take(MAX_SHOWN_ERRORS).map(|text| format!("\n{text}"));
        let text = others.fold(self.text.clone(), |all, other| all + &other);
        match self.other_errors.len().saturating_sub(MAX_SHOWN_ERRORS) {
            0 => text,
            1 => text + "\nand 1 more mistake",
            more => format!("{text}\nand {more} more mistakes"),
        }
    }

    /// Returns the error with another text for each mistake that `text` gives one for: it is asked with the details of the
    /// mistake and its text.
    #[must_use]
    pub fn with_texts(mut self, text: impl Fn(&Details, &str) -> Option<String>) -> Self {
        if let Some(text) = text(&self.details, &self.text) {
            self.text = text;
        }
        for (also, details) in self.other_errors.iter_mut().zip(&self.details.more_errors) {
            if let Some(text) = text(details, also) {
                *also = text;
            }
        }
        self
    }

    /// Returns the error with the file that it is about.
    pub fn with_file(self, file: impl Display) -> Self {
        self.with_details(Details { file: Some(file.to_string()), ..Details::default() })
    }
    pub fn with_details(self, details: Details) -> Self {
        Self { details: details.into(), ..self }
    }

    /// Adds the key that has to be given too, if there is one.
    pub fn with_missing_key(mut self, key: Option<&str>) -> Self {
        self.details.missing_key = key.map(str::to_owned);
        self
    }

    /// 2 where the input has to change, 1 where a run failed, 3 where measurements contradict the law, 130 and 143
    /// after a signal.
    pub fn exit_code(&self) -> u8 {
        match self.kind {
            ErrorKind::Failed => 1,
            ErrorKind::Input => 2,
            ErrorKind::Mismatch => 3,
            ErrorKind::Stopped(code) => code,
        }
    }
}

impl From<serde_json::Error> for Error {
    fn from(error: serde_json::Error) -> Self {
        Self::failed(format!("JSON: {error}"))
    }
}

impl From<csv::Error> for Error {
    fn from(error: csv::Error) -> Self {
        Self::failed(format!("CSV: {error}"))
    }
}
