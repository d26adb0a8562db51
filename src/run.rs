//! From a scenario to what is written and said about it: one way for every kind of scene.

pub mod compare;
pub mod impact;
pub mod indentation;
pub mod repeat;
pub mod table;

use crate::error::Error;
use crate::law::LawChoice;
use crate::output::OutputFile;
use crate::provenance::{LawOf, Provenance};
use crate::scenario::{Kind, Scenario};

/// What came of a scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Where scene, model or run are doubtful.
    pub warnings: Vec<String>,
    /// What the terminal shows.
    pub text: String,
    /// What goes into the output directory; empty for a check.
    pub files: Vec<OutputFile>,
}

impl Outcome {
    /// What a check says: nothing is written.
    fn checked(warnings: Vec<String>, text: String) -> Self {
        Self { warnings, text, files: Vec::new() }
    }
}

/// How scenarios of one kind are done.
#[derive(Debug, Clone, Copy)]
pub struct Way {
    /// Finds out what there is to be said before anything is written.
    pub check: fn(&Scenario) -> Result<Outcome, Error>,
    /// Does it.
    pub run: Run,
}

/// How a run of one kind is done.
#[derive(Debug, Clone, Copy)]
pub enum Run {
    /// At once: all files together.
    Once {
        /// What the scenario is, for messages: "one impact".
        what: &'static str,
        /// Runs a scenario; the second argument is the command line, for the provenance.
        run: fn(&Scenario, &str) -> Result<Outcome, Error>,
    },
    /// Row after row, by [`crate::sweep::Job`].
    Table,
}

/// How scenarios of this kind are done.
#[must_use]
pub fn way(kind: Kind) -> Way {
    let once = |check, what, run| Way { check, run: Run::Once { what, run } };
    match kind {
        Kind::Impact => once(impact::check, "one impact", impact::run),
        Kind::Sweep | Kind::MonteCarlo => Way { check: table::check, run: Run::Table },
        Kind::Repeat => once(repeat::check, "impacts one after the other", repeat::run),
        Kind::Compare => once(compare::check, "a comparison of laws", compare::run),
        Kind::Indentation => once(indentation::check, "an indentation", indentation::run),
    }
}

/// What there is to be said of a scenario before it is run; nothing is written.
///
/// # Errors
/// [`Error`]: a bad scenario, a result beyond double precision, an integrator that gives up.
pub fn check(scenario: &Scenario) -> Result<Outcome, Error> {
    (way(scenario.kind()?).check)(scenario)
}

/// Whether warnings keep a scenario from being done: with `is_strict`, one is enough.
///
/// # Errors
/// [`Error::Strict`].
pub fn heed(scenario: &Scenario, warnings: usize, is_strict: bool) -> Result<(), Error> {
    if is_strict && warnings > 0 {
        return Err(Error::Strict { scenario: scenario.document.name().to_owned(), count: warnings });
    }
    Ok(())
}

fn file(name: &str, bytes: impl Into<Vec<u8>>) -> OutputFile {
    OutputFile { name: name.to_owned(), bytes: bytes.into() }
}

/// Where results of a scenario under one law come from; elastic bodies are under that of Hertz.
fn provenance(scenario: &Scenario, law: &LawChoice, can_yield: bool, command: &str) -> Result<Provenance, Error> {
    let coefficients = match law {
        LawChoice::Plm(plm) if can_yield => Some(&plm.coefficients.provenance),
        _ => None,
    };
    let law = LawOf {
        law: if can_yield { law.name() } else { "hertz".to_owned() },
        law_source: (can_yield && coefficients.is_none()).then(|| law.source()),
        coefficients: coefficients.map(|table| table.name.clone()),
        coefficients_source: coefficients.map(|table| table.source.clone()),
    };
    let scenario_file = Some(scenario.document.name().to_owned());
    Ok(Provenance { scenario_file, law: Some(law), ..Provenance::new(scenario.sha256()?, command) })
}
