//! Where a result comes from, in enough detail to repeat it.

use std::fmt::Write as _;

use serde::Serialize;

/// Version of the program.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Name of the program, as pictures have it.
pub const PROGRAM_NAME: &str = env!("CARGO_PKG_NAME");

/// Program and version, as they are written into files.
pub const PROGRAM: &str = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));

/// Version of the form of all outputs. Raise it when a key or a column is renamed, removed or put elsewhere, or changes its
/// unit or meaning; a new key beside the others needs no new version.
pub const FORMAT_VERSION: u64 = 3;

/// Version of the numbers in tables. Raise it when any number of a table changes, even in its last digit, or when rows are
/// dealt out to shards in another way: rows of different versions are not put into one table.
pub const RESULTS_VERSION: u64 = 10;

/// A hash in hexadecimal.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::with_capacity(2 * bytes.len()), |mut hex, byte| {
        let _ = write!(hex, "{byte:02x}");
        hex
    })
}

/// Where a result comes from.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Provenance {
    /// Version of the form of the output: [`FORMAT_VERSION`].
    pub format_version: u64,
    /// Version of the program.
    pub version: &'static str,
    /// Version of the numbers in tables: [`RESULTS_VERSION`].
    pub numbers_version: u64,
    /// The scenario as the command line names it.
    pub scenario_file: String,
    /// Relative path of that file from the folder of the results. By it a later run recognises its own results; `None` without
    /// file or folder.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scenario_path: Option<String>,
    /// SHA-256 of the scenario's text, its overrides and the coefficients that it names, hexadecimal.
    pub scenario_sha256: String,
    /// SHA-256 of the overrides of the command line alone. A later run recognises results with the same overrides by it; `None` without
    /// overrides.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub overrides_sha256: Option<String>,
    pub command: String,
    /// The files beside the summary.
    pub files: Vec<String>,
    /// How the motion was computed; `None` without a motion, or if the method varies.
    #[serde(flatten)]
    pub method: Option<MethodProvenance>,
    /// The law of the results; `None` if laws vary.
    #[serde(flatten)]
    pub law: Option<LawProvenance>,
}

/// How a motion was computed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MethodProvenance {
    /// The integration method, as a scenario spells it.
    pub method: &'static str,
    /// Relative tolerance on the dimensionless state.
    pub tolerance: f64,
}

/// A law and its sources.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LawProvenance {
    /// The law, as a scenario spells it.
    pub law: String,
    /// Where it was published; `None` for the PLM, whose coefficients say it, and for an elastic contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub law_source: Option<String>,
    /// Name of its table of coefficients; `None` for a law without one.
    pub coefficients: Option<String>,
    /// The data from which those coefficients were determined.
    pub coefficients_source: Option<String>,
}
