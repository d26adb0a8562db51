//! The outcome of a scenario of any kind.

use serde_json::{Map, Value};

use crate::contact::law::LawChoice;
use crate::error::Error;
use crate::files::{LawProvenance, OutputFile, Progress, Provenance, SUMMARY_FILE};
use crate::impact::Warning;
use crate::report::chart::PictureFormat;
use crate::report::text::files::summary_json;
use crate::report::text::inputs::Inputs;
use crate::report::text::{Block, Detail, to_text};
use crate::scenario::Scenario;

/// The options of a run, besides its scenario.
#[derive(Debug, Clone, Copy)]
pub struct RunOptions<'a> {
    /// The command line, for the provenance.
    pub command: &'a str,
    /// How much the blocks say of an impact.
    pub detail: Detail,
    pub pictures: PictureFormat,
    /// Counts how far the run is.
    pub progress: &'a Progress,
}

/// The outcome of a scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Warnings about scene, model or run.
    pub warnings: Vec<String>,
    /// Notes for the user on the strength and on the exponent behind the results; the blocks have them too.
    pub notes: Vec<String>,
    /// The results for people.
    pub blocks: Vec<Block>,
    /// The files for the output directory; empty for a check.
    pub files: Vec<OutputFile>,
    /// Why measurements contradict the law, where they do: all is written, and the exit code is 3.
    pub contradiction: Option<String>,
    /// A check as data; empty for a run, whose summary has more.
    pub checked: Map<String, Value>,
}

impl Outcome {
    pub(super) fn from_check(warnings: Vec<String>, blocks: Vec<Block>, checked: Map<String, Value>) -> Self {
        Self { checked, ..Self::from_run(warnings, blocks, Vec::new()) }
    }

    pub(super) fn from_run(warnings: Vec<String>, blocks: Vec<Block>, files: Vec<OutputFile>) -> Self {
        Self { warnings, notes: Vec::new(), blocks, files, contradiction: None, checked: Map::new() }
    }

    pub fn terminal_text(&self) -> String {
        to_text(&self.blocks)
    }
}

/// Warnings as they are shown.
pub fn warning_texts(warnings: &[Warning]) -> Vec<String> {
    warnings.iter().map(ToString::to_string).collect()
}

/// Puts the notes behind the results, if there are any.
pub(super) fn put_notes(results: &mut Map<String, Value>, notes: &[String]) {
    if !notes.is_empty() {
        results.insert("notes".to_owned(), notes.into());
    }
}

pub(super) fn output_file(name: &str, bytes: impl Into<Vec<u8>>) -> OutputFile {
    OutputFile { name: name.to_owned(), bytes: bytes.into() }
}

/// All files: the summary with these results and inputs, which lists the others, and these.
pub(super) fn with_summary(
    files: Vec<OutputFile>,
    mut provenance: Provenance,
    results: Map<String, Value>,
    inputs: &Inputs,
) -> Result<Vec<OutputFile>, Error> {
    provenance.files.extend(files.iter().map(|file| file.name.clone()));
    let mut all = vec![output_file(SUMMARY_FILE, summary_json(results, inputs, &provenance)?)];
    all.extend(files);
    Ok(all)
}

/// The provenance of results of a scenario under one law. The law of elastic bodies is that of Hertz.
pub(super) fn provenance(scenario: &Scenario, law: &LawChoice, can_yield: bool, command: &str) -> Provenance {
    let coefficients = match law {
        LawChoice::Plm(plm) if can_yield => Some(&plm.coefficients.provenance),
        _ => None,
    };
    let law = LawProvenance {
        law: if can_yield { law.name() } else { "hertz".to_owned() },
        law_source: (can_yield && coefficients.is_none()).then(|| law.source()),
        coefficients: coefficients.map(|table| table.name.clone()),
        coefficients_source: coefficients.map(|table| table.source.clone()),
    };
    Provenance { law: Some(law), ..scenario.provenance(command) }
}
