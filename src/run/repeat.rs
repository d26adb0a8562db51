//! Repeated impacts from a scenario to their output files.

use super::{can_be_traced, held, provenance};
use crate::error::Error;
use crate::impact::{Contact, Method};
use crate::output::OutputFile;
use crate::plot;
use crate::repeat::{Repeat, Sequence};
use crate::report::resolved::of_scene;
use crate::report::{self, inputs::Inputs};
use crate::scenario::Scenario;
use crate::scene::Scene;

/// A scenario with `[repeat]` that was run.
#[derive(Debug, Clone, PartialEq)]
pub struct RepeatRun {
    /// What came of it.
    pub sequence: Sequence,
    /// Doubts about scene and impacts, for a person.
    pub warnings: Vec<String>,
    /// For the terminal.
    pub table: String,
    /// For the output directory.
    pub files: Vec<OutputFile>,
}

/// A series without what is written about it.
#[derive(Debug, Clone)]
pub struct Computed {
    /// The scene.
    pub scene: Scene,
    /// Its contact.
    pub contact: Contact,
    /// What was to be run.
    pub repeat: Repeat,
    /// What came of it.
    pub sequence: Sequence,
    /// Doubts about scene and impacts, for a person.
    pub warnings: Vec<String>,
}

/// What is to be run: scene, contact, series.
///
/// # Errors
/// [`Error`] with exit code 2.
pub fn prepare_repeat(scenario: &Scenario) -> Result<(Scene, Contact, Repeat), Error> {
    let (mut scene, contact) = held(scenario)?;
    let repeat = scenario.repeat(&scene)?.ok_or_else(|| Error::Option("the scenario has no [repeat]".to_owned()))?;
    if !scenario.names_method() {
        // a series needs no steps where there is a closed form
        scene.solver.method = Method::Auto;
    }
    Ok((scene, contact, repeat))
}

/// Scene, contact, series and what came of it, with all warnings, for a person.
///
/// # Errors
/// [`Error`]: a bad scenario, a result beyond double precision, an integrator that gives up.
pub fn compute(scenario: &Scenario) -> Result<Computed, Error> {
    let (scene, contact, repeat) = prepare_repeat(scenario)?;
    can_be_traced(scenario, &scene)?;
    let sequence =
        repeat.run(&contact, &scene.solver, scene.samples).map_err(|reason| Error::impact(scenario, reason))?;
    let of_impacts = sequence.warnings.iter().map(|(number, warning)| format!("impact {number}: {warning}"));
    let warnings = of_impacts.chain(scene.warnings.iter().map(ToString::to_string)).collect();
    Ok(Computed { scene, contact, repeat, sequence, warnings })
}

/// Runs a scenario with `[repeat]`; `command` is the command line, for the provenance.
///
/// # Errors
/// As [`compute`], and a picture that cannot be drawn.
pub fn run_repeat(scenario: &Scenario, command: &str) -> Result<RepeatRun, Error> {
    let Computed { scene, contact, repeat, sequence, warnings } = compute(scenario)?;
    let inputs = Inputs(of_scene(&scene));
    let provenance = provenance(scenario, &scene, sequence.method, command)?;
    let summary = report::repeat_summary::summary(&contact, &repeat, &sequence, &warnings, &inputs, &provenance)?;
    let file = |name: &str, bytes| OutputFile { name: name.to_owned(), bytes };
    let mut files = vec![
        file("summary.json", summary.into_bytes()),
        file("impacts.csv", report::repeat::impacts(&sequence)?),
        file("trace.csv", report::repeat::trace(&sequence, scene.samples)?),
        file("force_indentation.png", plot::repeat::loops(&repeat, &sequence)?),
        file("impacts.png", plot::repeat::impacts(&repeat, &sequence)?),
    ];
    if let Some(picture) = plot::repeat::height(&repeat, &sequence) {
        files.push(file("height.png", picture?));
    }
    let table = report::repeat::table(&repeat, &sequence);
    Ok(RepeatRun { sequence, warnings, table, files })
}
