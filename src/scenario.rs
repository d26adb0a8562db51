//! Scenarios: a TOML file with units, checked while it is read, and the scene it resolves to.
//!
//! ```
//! use plm_impact::scenario::Scenario;
//!
//! let text = r#"
//!     [sphere]
//!     radius = "5 mm"
//!     youngs_modulus = "210 GPa"
//!     poissons_ratio = 0.3
//!     density = "7850 kg/m^3"
//!     [half_space]
//!     youngs_modulus = "210 GPa"
//!     poissons_ratio = 0.3
//!     yield_strength = "345 MPa"
//!     [impact]
//!     speed = "3 m/s"
//! "#;
//! let scene = Scenario::from_text("steel", text, &["impact.speed=1 m/s".to_owned()])?.resolve()?;
//! assert_eq!(scene.speed, 1.0);
//! # Ok::<(), plm_impact::scenario::ScenarioError>(())
//! ```

mod columns;
pub mod compare;
mod document;
mod explain;
mod extreme;
pub mod file;
pub mod forces;
pub mod indentation;
pub mod keys;
mod kind;
pub mod law;
pub mod overview;
mod place;
pub mod quantity;
mod reader;
pub mod repeat;
pub mod resolved;
mod source;
pub mod sweep;
mod swept;
pub mod values;
mod words;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use thiserror::Error;

use crate::impact::{Contact, Forces, ImpactError, Solver, Warning};
use crate::law::{LawChoice, PlmCoefficients, UnloadingExponent};
use crate::material::{HalfSpace, Material, Sphere};
pub use document::{Document, LARGEST_SCENARIO, read_text};
use file::{PlmTable, ScenarioFile, SphereTable};
pub use keys::{KEYS, Key};
pub use kind::Kind;
use law::LawTable;
pub use place::{Place, Refusal};
pub use source::Source;

/// Evenly spaced rows of a trace where the scenario names no other number.
pub const DEFAULT_SAMPLES: usize = 400;

/// Why a scenario is refused.
#[derive(Debug, Error)]
pub enum ScenarioError {
    /// The file system says no.
    #[error("{}: cannot be read: {reason}", .path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: std::io::Error,
    },
    /// Larger than what is read.
    #[error("{}: is larger than {largest} MiB, the most that is read; write long lists as linspace or logspace, or split the file", .path.display())]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// In MiB.
        largest: u64,
    },
    /// Not UTF-8.
    #[error("{}:{line}: is not a text file (not UTF-8)", .path.display())]
    NotText {
        /// The file.
        path: PathBuf,
        /// Of the first byte that is no text.
        line: usize,
    },
    /// A `--set` that is no `key=value`.
    #[error("--set {text}: {problem}")]
    Override {
        /// As given.
        text: String,
        /// What is wrong.
        problem: String,
    },
    /// A key or a value.
    #[error("{0}")]
    Refused(Box<Refusal>),
}

/// What a scenario comes to: bodies, speed, law, solver. Plain numbers in SI, all of them checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The sphere.
    pub sphere: Sphere,
    /// The half-space.
    pub half_space: HalfSpace,
    /// Impact speed \[m/s\].
    pub speed: f64,
    /// The law; of the PLM, exponent and coefficients are those below.
    pub law: LawChoice,
    /// Height of the fall \[m\] that gives the speed, if the scene names one.
    pub drop_height: Option<f64>,
    /// Gravity and damping.
    pub forces: Forces,
    /// Exponent of the unloading branch.
    pub exponent: UnloadingExponent,
    /// Coefficients of the PLM.
    pub coefficients: Arc<PlmCoefficients>,
    /// Method and tolerance.
    pub solver: Solver,
    /// Evenly spaced rows of the trace.
    pub samples: usize,
    /// What of the scenario has no effect.
    pub warnings: Vec<Warning>,
}

impl Scene {
    /// The bodies paired under the law.
    ///
    /// # Errors
    /// [`ImpactError`] where a constant of the pair over- or underflows, and for a law that lacks a half.
    pub fn contact(&self) -> Result<Contact, ImpactError> {
        let contact = match &self.law {
            LawChoice::Plm(_) => Contact::try_new(self.sphere, self.half_space, &self.coefficients, self.exponent)?,
            law => Contact::with_law(self.sphere, self.half_space, law.get())?,
        };
        Ok(contact.with_forces(self.forces))
    }
}

/// A scenario file, read and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Scenario {
    /// Its text, and where a value stands in it.
    pub document: Document,
    /// Its tables.
    pub file: ScenarioFile,
    /// Files that it names are relative to this.
    directory: PathBuf,
    /// The text of the file of coefficients, where that is known without the file.
    coefficients: Option<String>,
}

impl Scenario {
    /// Reads a scenario file, with `key=value` overrides.
    ///
    /// # Errors
    /// [`ScenarioError`], naming file, line, value, allowed range.
    pub fn load(path: &Path, overrides: &[String]) -> Result<Self, ScenarioError> {
        let text = document::read_text(path, LARGEST_SCENARIO)?;
        let directory = path.parent().unwrap_or(Path::new("")).to_owned();
        Self::new(path.display().to_string(), text, overrides, directory)
    }

    /// Reads a scenario from a text; `name` stands for the file in messages.
    ///
    /// # Errors
    /// [`ScenarioError`], naming line, value, allowed range.
    pub fn from_text(name: &str, text: &str, overrides: &[String]) -> Result<Self, ScenarioError> {
        Self::new(name.to_owned(), text.to_owned(), overrides, PathBuf::new())
    }

    fn new(name: String, text: String, overrides: &[String], directory: PathBuf) -> Result<Self, ScenarioError> {
        let document = Document::new(name, text, overrides)?;
        let file = document.read()?;
        Ok(Self { document, file, directory, coefficients: None })
    }

    /// The scene of an impact: defaults filled in, files read.
    ///
    /// # Errors
    /// [`ScenarioError`] where keys contradict each other, what an impact needs is missing, or the file of coefficients is
    /// bad.
    pub fn resolve(&self) -> Result<Scene, ScenarioError> {
        let ScenarioFile { sphere, half_space, law, solver, .. } = &self.file;
        let plm = self.plm_table();
        let defaults = Solver::default();
        let half_space = half_space.as_ref().ok_or_else(|| self.document.missing("", "half_space"))?.resolve();
        let density = sphere.density.ok_or_else(|| self.document.missing("sphere", "density"))?;
        let forces = self.forces()?;
        self.refuse_waves(&half_space, &forces)?;
        let (speed, drop_height) = self.speed(&forces)?;
        let sphere = Sphere {
            radius: self.radius(sphere)?,
            material: Material { youngs_modulus: sphere.youngs_modulus.0, poissons_ratio: sphere.poissons_ratio.0 },
            density: density.0,
            yield_strength: sphere.yield_strength.map(|strength| strength.0),
        };
        Ok(Scene {
            sphere,
            half_space,
            speed,
            drop_height,
            forces,
            law: self.law()?,
            exponent: plm.unloading_exponent.map(|exponent| exponent.0).unwrap_or_default(),
            coefficients: self.coefficients(&plm)?,
            solver: Solver {
                method: solver.method.map_or(defaults.method, |method| method.0),
                tolerance: solver.tolerance.map_or(defaults.tolerance, |tolerance| tolerance.0),
                steps_per_contact: solver.steps_per_contact.map_or(defaults.steps_per_contact, |steps| steps.0),
            },
            samples: self.samples(),
            warnings: unused(law.as_ref(), half_space.yield_strength.is_none()),
        })
    }

    /// Evenly spaced rows of a trace.
    #[must_use]
    pub fn samples(&self) -> usize {
        self.file.output.samples.map_or(DEFAULT_SAMPLES, |samples| samples.0)
    }

    fn radius(&self, sphere: &SphereTable) -> Result<f64, ScenarioError> {
        match (sphere.radius, sphere.diameter) {
            (Some(radius), None) => Ok(radius.0),
            (None, Some(diameter)) => Ok(0.5 * diameter.0),
            (None, None) => {
                let message = "the key `radius` is missing: a length such as radius = \"5 mm\"; or `diameter`";
                Err(self.document.refuse("sphere", message.to_owned()))
            }
            (Some(_), Some(_)) => {
                let message = "`radius` is given too; write only one of `radius` and `diameter`";
                Err(self.document.refuse("sphere.diameter", message.to_owned()))
            }
        }
    }

    fn coefficients(&self, plm: &PlmTable) -> Result<Arc<PlmCoefficients>, ScenarioError> {
        let Some(path) = &plm.coefficients else {
            return Ok(Arc::new(PlmCoefficients::built_in().clone()));
        };
        let refuse = |message: String| self.document.refuse("law.plm.coefficients", message);
        let text = self.coefficients_text().map_err(|error| refuse(error.to_string()))?.unwrap_or_default();
        let table = PlmCoefficients::from_toml(&text).map_err(|error| {
            refuse(format!("{}: {}", self.directory.join(path).display(), error.to_string().trim_end()))
        })?;
        Ok(Arc::new(table))
    }
}

/// Why a law has no use.
const ELASTIC: &str =
    "the half-space has no yield_strength, so the contact stays elastic; give it one, or leave the key out";

/// Keys of a law that an elastic half-space does not need.
fn unused(law: Option<&LawTable>, is_elastic: bool) -> Vec<Warning> {
    let keys: Vec<(&'static str, bool)> = match law {
        None | Some(LawTable::Hertz(_)) => Vec::new(),
        Some(LawTable::Plm(plm)) => vec![
            ("law.plm.unloading_exponent", plm.unloading_exponent.is_some()),
            ("law.plm.coefficients", plm.coefficients.is_some()),
        ],
        Some(_) => vec![("law", true)],
    };
    keys.into_iter()
        .filter(|(_, is_given)| *is_given && is_elastic)
        .map(|(key, _)| Warning::UnusedKey { key, reason: ELASTIC })
        .collect()
}
