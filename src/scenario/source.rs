//! A scenario as texts, to be hashed, and to be read again on another machine.

use std::fmt::Write as _;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::document::{LARGEST_SCENARIO, read_text};
use super::law::COEFFICIENTS;
use super::{Scenario, ScenarioError};

/// All that a result depends on, as text.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// Of the scenario file.
    pub text: String,
    /// `key=value` of the command line, in its order.
    pub overrides: Vec<String>,
    /// Of the file of coefficients, if the scenario names one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coefficients: Option<String>,
}

impl Source {
    /// SHA-256 of these texts, in hexadecimal.
    #[must_use]
    pub fn sha256(&self) -> String {
        let mut hasher = Sha256::new();
        hasher.update(&self.text);
        for given in &self.overrides {
            // a zero byte is in no TOML text, so that text and overrides cannot be mistaken for each other
            hasher.update([0]);
            hasher.update(given);
        }
        if let Some(coefficients) = &self.coefficients {
            hasher.update([0, 0]);
            hasher.update(coefficients);
        }
        hasher.finalize().iter().fold(String::with_capacity(64), |mut hex, byte| {
            let _ = write!(hex, "{byte:02x}");
            hex
        })
    }
}

impl Scenario {
    /// Its texts.
    ///
    /// # Errors
    /// [`ScenarioError`] if the file of coefficients cannot be read.
    pub fn source(&self) -> Result<Source, ScenarioError> {
        Ok(Source {
            text: self.document.text().to_owned(),
            overrides: self.document.overrides(),
            coefficients: self.coefficients_text()?,
        })
    }

    /// Reads a scenario from its texts; `name` stands for the file in messages.
    ///
    /// # Errors
    /// [`ScenarioError`], naming line, value, allowed range.
    pub fn from_source(name: &str, source: &Source) -> Result<Self, ScenarioError> {
        let scenario = Self::from_text(name, &source.text, &source.overrides)?;
        Ok(Self { coefficients: source.coefficients.clone(), ..scenario })
    }

    /// SHA-256 of all that a result depends on: text, overrides, and the file of coefficients if one is named.
    ///
    /// # Errors
    /// [`ScenarioError`] if that file cannot be read.
    pub fn sha256(&self) -> Result<String, ScenarioError> {
        Ok(self.source()?.sha256())
    }

    /// The text of the file of coefficients, if the scenario names one.
    pub(super) fn coefficients_text(&self) -> Result<Option<String>, ScenarioError> {
        match (self.entries.text(COEFFICIENTS), &self.coefficients) {
            (None, _) => Ok(None),
            (Some(_), Some(text)) => Ok(Some(text.clone())),
            (Some(path), None) => read_text(&self.directory.join(path), LARGEST_SCENARIO).map(Some),
        }
    }
}
