//! A scenario as texts, and read from texts.

use std::path::PathBuf;

use super::document::{LARGEST_SCENARIO, read_text};
use super::flow::TABLE;
use super::law::COEFFICIENTS;
use super::{Scenario, ScenarioError};
use crate::plan::{Plan, Source};

/// The plan of a table, from the texts of its scenario; `name` stands for the file in messages.
pub fn plan_of(name: &str, source: &Source) -> Result<Plan, String> {
    let plan = Scenario::from_source(name, source).and_then(|scenario| scenario.plan());
    plan.map_err(|error| error.to_string())?.ok_or_else(|| "its scenario has no table".to_owned())
}

impl Scenario {
    /// Its texts.
    pub fn source(&self) -> Result<Source, ScenarioError> {
        Ok(Source {
            text: self.document.text().to_owned(),
            overrides: self.document.overrides(),
            coefficients: self.text_of_file(COEFFICIENTS)?,
            flow_table: self.text_of_file(TABLE)?,
        })
    }

    /// Reads a scenario from its texts; `name` stands for the file in messages.
    ///
    /// # Errors
    /// [`ScenarioError`], naming line, value, allowed range.
    pub fn from_source(name: &str, source: &Source) -> Result<Self, ScenarioError> {
        let scenario = Self::from_text(name, &source.text, &source.overrides)?;
        let texts = [(COEFFICIENTS, &source.coefficients), (TABLE, &source.flow_table)];
        let texts = texts.into_iter().filter_map(|(key, text)| Some((key, text.clone()?)));
        Ok(Self { texts: texts.collect(), ..scenario })
    }

    /// SHA-256 of all that a result depends on: text, overrides, and the file of coefficients if one is named.
    pub fn sha256(&self) -> Result<String, ScenarioError> {
        Ok(self.source()?.sha256())
    }

    /// The keys that name files, and these files.
    pub fn files(&self) -> impl Iterator<Item = (&'static str, PathBuf)> {
        [COEFFICIENTS, TABLE].into_iter().filter_map(|key| Some((key, self.directory.join(self.entries.text(key)?))))
    }

    /// The text of the file that this key names, if the scenario gives the key.
    pub(super) fn text_of_file(&self, key: &'static str) -> Result<Option<String>, ScenarioError> {
        let Some(path) = self.entries.text(key) else { return Ok(None) };
        if let Some(text) = self.texts.get(key) {
            return Ok(Some(text.clone()));
        }
        let text = read_text(&self.directory.join(path), LARGEST_SCENARIO);
        text.map(Some).map_err(|error| self.document.refuse(key, error.to_string()))
    }
}
