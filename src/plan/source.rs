//! The texts that a plan is read from: hashed, and kept beside tables so that another machine reads the same plan again.

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::provenance::hex;

/// All that a result depends on, as text.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Source {
    /// Of the scenario file.
    pub text: String,
    /// `key=value` of the command line, in its order.
    pub overrides: Vec<String>,
    /// Of the file of coefficients, if the scenario names one.
    pub coefficients: Option<String>,
    /// Of the file of a flow curve, if the scenario names one.
    pub flow_table: Option<String>,
    /// Of the file of measurements, if the scenario names one.
    pub data: Option<String>,
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
        for (zeros, file) in (2..).zip([&self.coefficients, &self.flow_table, &self.data]) {
            if let Some(text) = file {
                hasher.update(vec![0; zeros]);
                hasher.update(text);
            }
        }
        hex(&hasher.finalize())
    }
}
