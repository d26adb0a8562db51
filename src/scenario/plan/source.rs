//! The texts that a plan is read from: hashed, and kept beside tables so that another machine reads the same plan again.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::files::provenance::hex;

/// All that a result depends on, as text.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Source {
    /// The text of the scenario file.
    pub text: String,
    /// `key=value` of the command line, in its order.
    pub overrides: Vec<String>,
    /// The texts of the files that the scenario names, by the keys that name them.
    pub files: BTreeMap<String, String>,
}

impl Source {
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
