//! The details of an error for programs: its place, the value there, and what is allowed.

use std::path::Path;

use serde::Serialize;

use super::Error;
use crate::calibrate::CalibrateError;
use crate::fit::FitError;
use crate::output::OutputError;
use crate::scenario::{Place, Refusal, ScenarioError};
use crate::scene::key::Form;
use crate::scene::keys::{every_key, varied};
use crate::scene::reference::written;
use crate::sweep::SweepError;
use crate::units::csv_text::TableError;
use crate::validation::ValidationError;

/// What is known of an error besides its text.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Details {
    /// What is wrong, and the way out, without the place.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// The file.
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
}

impl Error {
    /// The details of this error.
    pub fn details(&self) -> Details {
        match self {
            Self::Scenario(error)
            | Self::Calibrate(CalibrateError::Scenario(error))
            | Self::Fit(FitError::Unreadable(error))
            | Self::Validation(ValidationError::Unreadable(error)) => of_scenario(error),
            Self::Calibrate(CalibrateError::Data(TableError { name, line, message }))
            | Self::Fit(FitError::Curve(TableError { name, line, message }))
            | Self::Validation(ValidationError::Experiment(TableError { name, line, message })) => {
                Details { message: Some(message.clone()), line: *line, ..in_file(name) }
            }
            Self::Impact { scenario, .. }
            | Self::Indentation { scenario, .. }
            | Self::Contradicted { scenario, .. }
            | Self::Strict { scenario, .. }
            | Self::Calibrate(CalibrateError::NoAnswer { name: scenario, .. })
            | Self::Validation(ValidationError::Coefficients { file: scenario, .. }) => in_file(scenario),
            Self::Output(error) | Self::Sweep(SweepError::Output(error)) => match error {
                OutputError::Unwritable { path, .. }
                | OutputError::Busy { path, .. }
                | OutputError::Foreign { path }
                | OutputError::Taken { path, .. } => at(path),
            },
            Self::FailedCases { table: path, .. }
            | Self::Missed { table: path, .. }
            | Self::Sweep(
                SweepError::File { path, .. }
                | SweepError::Damaged { path, .. }
                | SweepError::Changed { table: path, .. }
                | SweepError::Version { sidecar: path, .. }
                | SweepError::Place { path, .. },
            ) => at(path),
            _ => Details::default(),
        }
    }
}

fn in_file(name: &str) -> Details {
    Details { file: Some(name.to_owned()), ..Details::default() }
}

fn at(path: &Path) -> Details {
    in_file(&path.display().to_string())
}

fn of_scenario(error: &ScenarioError) -> Details {
    match error {
        ScenarioError::Unreadable { path, .. } | ScenarioError::TooLarge { path, .. } => at(path),
        ScenarioError::NotText { path, line } => Details { line: Some(*line as u64), ..at(path) },
        ScenarioError::Override { text, problem } => {
            let (key, value) = text.split_once('=').unwrap_or((text, ""));
            let [key, value] = [key, value].map(|part| Some(part.to_owned()).filter(|part| !part.is_empty()));
            Details { message: Some(problem.clone()), key, value, ..Details::default() }
        }
        ScenarioError::Refused(refusal) => of_value(refusal),
    }
}

fn of_value(Refusal { place, key, message }: &Refusal) -> Details {
    let name = key.rsplit('.').next().unwrap_or(key);
    // where the key itself is refused, the mark is under the key, and there is no value
    let value = |text: &str| Some(text.to_owned()).filter(|text| text != name && !text.starts_with('['));
    let placed = match place {
        Place::File { name } => in_file(name),
        Place::Text { name, line, column, excerpt, indent, width } => {
            let marked: String = excerpt.chars().skip(*indent).take(*width).collect();
            Details { line: Some(*line as u64), column: Some(*column as u64), value: value(&marked), ..in_file(name) }
        }
        Place::Override { text } => {
            Details { value: text.split_once('=').map(|(_, text)| text.to_owned()), ..Details::default() }
        }
    };
    let key = Some(key.clone()).filter(|key| !key.is_empty());
    Details { message: Some(message.clone()), allowed: key.as_deref().and_then(allowed), key, ..placed }
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
