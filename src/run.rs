//! One scene from a scenario to its output files.

pub mod compare;
pub mod indentation;
pub mod repeat;
pub mod table;

use crate::error::Error;
use crate::impact::{Contact, Impact, ImpactError, Method};
use crate::law::LawChoice;
use crate::output::OutputFile;
use crate::plot;
use crate::report::inputs::Inputs;
use crate::report::resolved::of_scene;
use crate::report::{self, Provenance};
use crate::scenario::Scenario;
use crate::scene::Scene;

/// A scenario that was run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// The scene.
    pub scene: Scene,
    /// What came of it, with the warnings of scene and impact.
    pub impact: Impact,
    /// For the terminal.
    pub table: String,
    /// For the output directory.
    pub files: Vec<OutputFile>,
}

/// The scene of a scenario, its contact and the impact with all warnings; `samples` are the rows of the trace, if there is
/// to be one.
///
/// # Errors
/// [`Error`]: a bad scenario, a result beyond double precision, an integrator that gives up.
pub fn compute(scenario: &Scenario, samples: Option<usize>) -> Result<(Scene, Contact, Impact), Error> {
    let (scene, contact) = prepare(scenario)?;
    let impact = contact.impact(scene.speed, &scene.solver, samples);
    let mut impact = impact.map_err(|reason| Error::impact(scenario, reason))?;
    impact.warnings.extend(&scene.warnings);
    Ok((scene, contact, impact))
}

/// The scene of a scenario and its contact, neither of which leaves double precision, for a run with a trace.
///
/// # Errors
/// [`Error`] with exit code 2.
pub fn prepare(scenario: &Scenario) -> Result<(Scene, Contact), Error> {
    let (scene, contact) = held(scenario)?;
    can_be_traced(scenario, &scene)?;
    Ok((scene, contact))
}

/// Whether the method gives a trace, which a run writes.
///
/// # Errors
/// [`Error`] with exit code 2.
pub fn can_be_traced(scenario: &Scenario, scene: &Scene) -> Result<(), Error> {
    if scene.solver.method == Method::ClosedForm && !scene.forces.is_none() {
        return Err(Error::impact(scenario, ImpactError::NoClosedForm));
    }
    Ok(())
}

/// Scene and contact, which double precision holds.
fn held(scenario: &Scenario) -> Result<(Scene, Contact), Error> {
    scenario.refuse_columns("one impact")?;
    let scene = scenario.resolve()?;
    let contact = scene.contact().map_err(|error| Error::impact(scenario, error))?;
    // what the closed form cannot hold no integration can
    contact.holds(scene.speed).map_err(|reason| Error::impact(scenario, reason))?;
    Ok((scene, contact))
}

/// Runs a scenario; `command` is the command line, for the provenance.
///
/// # Errors
/// [`Error`]: a bad scenario, a result beyond double precision, an integrator that gives up, a picture that cannot be drawn.
pub fn run(scenario: &Scenario, command: &str) -> Result<Run, Error> {
    let (scene, contact, impact) = compute(scenario, Some(scenario.samples()))?;
    let provenance = provenance(scenario, &scene, impact.method, command)?;
    let file = |name: &str, bytes| OutputFile { name: name.to_owned(), bytes };
    let files = vec![
        file("summary.json", report::summary(&contact, &impact, &Inputs(of_scene(&scene)), &provenance)?.into_bytes()),
        file("trace.csv", report::trace(&impact)?),
        file("force_indentation.png", plot::force_indentation(&impact)?),
        file("history.png", plot::history(&impact)?),
    ];
    let table = report::table(&contact, &impact);
    Ok(Run { scene, impact, table, files })
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

fn provenance(scenario: &Scenario, scene: &Scene, method: Method, command: &str) -> Result<Provenance, Error> {
    let can_yield = scene.half_space.yield_strength.is_some();
    let coefficients = match &scene.law {
        LawChoice::Plm(plm) if can_yield => Some(&plm.coefficients.provenance),
        _ => None,
    };
    Ok(Provenance {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scenario_file: scenario.document.name().to_owned(),
        scenario_sha256: scenario.sha256()?,
        command: command.to_owned(),
        method: method.name().to_owned(),
        tolerance: scene.solver.tolerance,
        law: if can_yield { scene.law.name() } else { "hertz".to_owned() },
        law_source: (can_yield && coefficients.is_none()).then(|| scene.law.source()),
        coefficients: coefficients.map(|table| table.name.clone()),
        coefficients_source: coefficients.map(|table| table.source.clone()),
    })
}
