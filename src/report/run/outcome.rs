//! The outcome of a scenario of any kind.

use serde_json::{Map, Value};

use crate::contact::law::{LawChoice, LawError};
use crate::error::{Error, ErrorKind};
use crate::files::{LawProvenance, OutputFile, Progress, Provenance, SUMMARY_FILE};
use crate::impact::{ImpactError, Warning};
use crate::numerics::ode::IntegrationError;
use crate::report::chart::PictureFormat;
use crate::report::text::Detail;
use crate::report::text::files::summary_json;
use crate::report::text::inputs::Inputs;
use crate::scenario::Scenario;
use crate::scenario::input::{Body, NUMERIC_KEYS, NumericKey};
use crate::scenario::keys::Part;

/// The options of a run, besides its scenario.
#[derive(Debug, Clone, Copy)]
pub struct RunOptions<'a> {
    /// The command line, for the provenance.
    pub command: &'a str,
    /// How much the text says of an impact.
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
    /// Notes for the user on the strength and on the exponent behind the results; the text has them too.
    pub notes: Vec<String>,
    pub text: String,
    /// The files for the output directory; empty for a check.
    pub files: Vec<OutputFile>,
    /// Why measurements contradict the law, where they do: all is written, and the exit code is 3.
    pub contradiction: Option<String>,
    /// A check as data; empty for a run, whose summary has more.
    pub checked: Map<String, Value>,
}

impl Outcome {
    pub(super) fn from_check(warnings: Vec<String>, text: String, checked: Map<String, Value>) -> Self {
        Self { checked, ..Self::from_run(warnings, text, Vec::new()) }
    }

    pub(super) fn from_run(warnings: Vec<String>, text: String, files: Vec<OutputFile>) -> Self {
        Self { warnings, notes: Vec::new(), text, files, contradiction: None, checked: Map::new() }
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

/// The error of a scenario without a result. If one key is the reason, the error points at it.
pub fn no_result_error(scenario: &Scenario, reason: &ImpactError) -> Error {
    let speeds = ["impact.speed", "impact.drop_height", "repeat.speeds"];
    let curves = Body::ALL.map(Body::flow_stress);
    let key = match reason {
        ImpactError::Law(LawError::BothFlow { .. }) => {
            curves.into_iter().find(|key| scenario.document.contains(key)).unwrap_or("law")
        }
        ImpactError::Law(LawError::Exponent { .. }) => "law.plm.unloading_exponent",
        ImpactError::Law(_) => "law",
        ImpactError::Plate(_) | ImpactError::SmallInertia { least: None, .. } => "half_space.thickness",
        ImpactError::Hollow(_) => "half_space.radius",
        ImpactError::FreeUnderGravity | ImpactError::NoBall => "half_space.mass",
        ImpactError::NoClosedForm => "solver.method",
        ImpactError::SmallInertia { .. } => "sphere.moment_of_inertia",
        ImpactError::TooDeep { .. } => {
            speeds.into_iter().find(|key| scenario.document.contains(key)).unwrap_or(speeds[0])
        }
        ImpactError::Range(_) | ImpactError::Invalid(_) | ImpactError::Integration(_) => "",
    };
    let document = &scenario.document;
    if document.contains(key) {
        return document.refusal(key, reason.to_string());
    }
    match reason {
        ImpactError::Integration(IntegrationError::StepUnderflow { .. } | IntegrationError::NotFinite { .. }) => {
            let is_of_motion = |key: &&NumericKey| {
                matches!(key.part, Part::Motion | Part::Forces | Part::Approach | Part::Solver)
                    || ["sphere.radius", "sphere.diameter"].contains(&key.path)
            };
            let given =
                NUMERIC_KEYS.iter().filter(is_of_motion).map(|key| key.path).filter(|path| document.contains(path));
            let given: Vec<&str> = given.collect();
            let text = format!("{reason} Probably one of these values has a wrong unit: {}.", given.join(", "));
            Error::for_file(ErrorKind::Input, document.name(), text)
        }
        ImpactError::Integration(_) => Error::for_file(ErrorKind::Failed, document.name(), reason),
        _ => Error::for_file(ErrorKind::Input, document.name(), reason),
    }
}
