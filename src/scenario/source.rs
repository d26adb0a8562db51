//! A scenario as texts, and read from texts.

use std::path::PathBuf;

use super::document::{LARGEST_SCENARIO, read_text};
use super::law::COEFFICIENTS;
use super::{Scenario, ScenarioError};
use crate::plan::{Plan, Source};

/// The plan of a table, from the texts of its scenario; `name` stands for the file in messages.
///
/// # Errors
/// What is wrong with the texts.
pub fn plan_of(name: &str, source: &Source) -> Result<Plan, String> {
    let plan = Scenario::from_source(name, source).and_then(|scenario| scenario.plan());
    plan.map_err(|error| error.to_string())?.ok_or_else(|| "its scenario has no table".to_owned())
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
            flow_table: self.flow_text()?,
        })
    }

    /// Reads a scenario from its texts; `name` stands for the file in messages.
    ///
    /// # Errors
    /// [`ScenarioError`], naming line, value, allowed range.
    pub fn from_source(name: &str, source: &Source) -> Result<Self, ScenarioError> {
        let scenario = Self::from_text(name, &source.text, &source.overrides)?;
        Ok(Self { coefficients: source.coefficients.clone(), flow_table: source.flow_table.clone(), ..scenario })
    }

    /// SHA-256 of all that a result depends on: text, overrides, and the file of coefficients if one is named.
    ///
    /// # Errors
    /// [`ScenarioError`] if that file cannot be read.
    pub fn sha256(&self) -> Result<String, ScenarioError> {
        Ok(self.source()?.sha256())
    }

    /// The keys that name files, and these files.
    pub fn files(&self) -> impl Iterator<Item = (&'static str, PathBuf)> {
        let keys = [COEFFICIENTS, "half_space.flow_stress.table"].into_iter();
        keys.filter_map(|key| Some((key, self.directory.join(self.entries.text(key)?))))
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
