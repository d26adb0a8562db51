//! A scenario as texts, and read from texts.

use std::path::PathBuf;

use super::calibrate::DATA;
use super::document::{LARGEST_SCENARIO, read_text};
use super::flow::TABLE;
use super::law::COEFFICIENTS;
use super::{Scenario, ScenarioError};
use crate::plan::Source;

impl Scenario {
    /// Its texts.
    pub fn source(&self) -> Result<Source, ScenarioError> {
        Ok(Source {
            text: self.document.text().to_owned(),
            overrides: self.document.overrides(),
            coefficients: self.text_of_file(COEFFICIENTS).map(str::to_owned),
            flow_table: self.text_of_file(TABLE).map(str::to_owned),
        })
    }

    /// Reads a scenario from its texts; `name` stands for the file in messages.
    ///
    /// # Errors
    /// [`ScenarioError`], naming line, value, allowed range.
    pub fn from_source(name: &str, source: &Source) -> Result<Self, ScenarioError> {
        let texts = [(COEFFICIENTS, &source.coefficients), (TABLE, &source.flow_table)];
        let texts = texts.into_iter().filter_map(|(key, text)| Some((key, text.clone()?)));
        Self::new(name.to_owned(), source.text.clone(), &source.overrides, PathBuf::new(), texts.collect())
    }

    /// The same with measurements that are known without the file `calibrate.data`.
    #[must_use]
    pub fn with_data(mut self, csv: String) -> Self {
        self.texts.insert(DATA, csv);
        self
    }

    /// SHA-256 of all that a result depends on: text, overrides, and the file of coefficients if one is named.
    pub fn sha256(&self) -> Result<String, ScenarioError> {
        Ok(self.source()?.sha256())
    }

    /// The keys that name files, and these files.
    pub fn files(&self) -> impl Iterator<Item = (&'static str, PathBuf)> + '_ {
        [COEFFICIENTS, TABLE].into_iter().filter_map(|key| Some((key, self.directory.join(self.entries.text(key)?))))
    }

    /// Reads the files that the scenario names, each once: hash and numbers are of the same text.
    pub(super) fn read_files(&mut self) -> Result<(), ScenarioError> {
        for (key, path) in self.files().collect::<Vec<_>>() {
            if !self.texts.contains_key(key) {
                let text = read_text(&path, LARGEST_SCENARIO);
                let text = text.map_err(|error| self.document.refuse(key, error.to_string()))?;
                self.texts.insert(key, text);
            }
        }
        Ok(())
    }

    /// The text of the file that this key names, if the scenario gives the key.
    pub(super) fn text_of_file(&self, key: &'static str) -> Option<&str> {
        self.texts.get(key).map(String::as_str)
    }
}
