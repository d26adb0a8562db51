//! A scenario as texts, and read from texts.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::keys::key;
use super::{DATA_KEY, Kind, Override, Scenario};
use crate::error::Error;
use crate::files::{FORMAT_VERSION, Provenance, RESULTS_VERSION, VERSION, hex};

/// All that a result depends on, as text: it is hashed, and kept beside tables so that another machine reads the same plan again.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct ScenarioSource {
    /// The text of the scenario file.
    pub text: String,
    /// `key=value` of the command line, in its order.
    pub overrides: Vec<String>,
    /// The texts of the files that the scenario names, by the keys that name them.
    pub files: BTreeMap<String, String>,
}

/// The kind of a scenario, and what tells its results from those of others.
#[derive(Debug, Clone)]
pub struct ScenarioIdentity {
    pub kind: Kind,
    /// SHA-256 of all that the results depend on.
    pub sha256: String,
    /// `key=value` of the command line.
    pub overrides: Vec<String>,
    /// SHA-256 of the overrides alone; `None` without overrides.
    pub overrides_sha256: Option<String>,
    /// The files that the scenario names.
    pub reads: Vec<PathBuf>,
}

impl ScenarioSource {
    /// SHA-256 of these texts, in hexadecimal.
    pub fn sha256(&self) -> String {
        let mut hasher = Sha256::new();
        hasher.update(&self.text);
        for given in &self.overrides {
            // a zero byte is in no TOML text, so that text and overrides cannot be mistaken for each other
            hasher.update([0]);
            hasher.update(given);
        }
        for (key, text) in &self.files {
            for part in ["\0", key, text] {
                hasher.update([0]);
                hasher.update(part);
            }
        }
        hex(&hasher.finalize())
    }
}

impl Scenario {
    /// The scenario as texts, from which it can be read again.
    pub fn source(&self) -> ScenarioSource {
        let files = self.files.iter().map(|(key, (_, text))| (key.clone(), text.clone()));
        ScenarioSource {
            text: self.document.original_text().to_owned(),
            overrides: self.document.overrides(),
            files: files.collect(),
        }
    }

    /// Reads a scenario from its texts; `name` stands for the file in messages.
    pub fn from_source(name: &str, source: &ScenarioSource) -> Result<Self, Error> {
        let overrides = Override::list(&source.overrides);
        Self::new(name.to_owned(), source.text.clone(), &overrides, PathBuf::new(), source.files.clone())
    }

    /// A scenario of one impact with these settings, which make it a table. The parts that apply to one impact alone are left out.
    pub fn to_table(&self, settings: impl IntoIterator<Item = String>) -> Result<Self, Error> {
        let mut source = self.source();
        source.overrides.extend(settings);
        if self.document.contains("output.pulse") {
            source.overrides.push("output.pulse=none".to_owned());
        }
        Self::from_source(self.document.name(), &source)
    }

    /// Takes measurements that are known without the file `calibrate.data`.
    pub fn with_data(mut self, csv: String) -> Self {
        let name = self.input.text_value(key!("calibrate.data")).unwrap_or_default();
        self.files.insert(DATA_KEY.to_owned(), (name.into(), csv));
        self
    }

    /// SHA-256 of all that a result depends on: text, overrides, and the files that are named.
    pub fn sha256(&self) -> String {
        self.source().sha256()
    }

    /// SHA-256 of the overrides, without the blanks and quotes that may be written in more than one way; `None` without overrides.
    pub fn overrides_sha256(&self) -> Option<String> {
        let written = |text: &String| text.chars().filter(|c| !c.is_whitespace() && !"\"'".contains(*c)).collect();
        let overrides: Vec<String> = self.document.overrides().iter().map(written).collect();
        let source = ScenarioSource { overrides, ..ScenarioSource::default() };
        (!source.overrides.is_empty()).then(|| source.sha256())
    }

    /// The facts of the scenario that a command needs before anything is computed.
    pub fn identity(&self) -> Result<ScenarioIdentity, Error> {
        Ok(ScenarioIdentity {
            kind: self.kind()?,
            sha256: self.sha256(),
            overrides: self.document.overrides(),
            overrides_sha256: self.overrides_sha256(),
            reads: self.files().map(|(_, path)| path.to_owned()).collect(),
        })
    }

    /// The provenance of results of this scenario, which the command made.
    pub fn provenance(&self, command: &str) -> Provenance {
        Provenance {
            format_version: FORMAT_VERSION,
            version: VERSION,
            numbers_version: RESULTS_VERSION,
            scenario_file: self.document.name().to_owned(),
            scenario_path: self.from_results.clone(),
            scenario_sha256: self.sha256(),
            overrides_sha256: self.overrides_sha256(),
            command: command.to_owned(),
            files: Vec::new(),
            method: None,
            law: None,
        }
    }

    /// The keys that name files, and these files.
    pub fn files(&self) -> impl Iterator<Item = (&str, &Path)> {
        self.files.iter().map(|(key, (path, _))| (key.as_str(), path.as_path()))
    }
}
