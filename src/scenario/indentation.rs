//! `[indentation]`: loads and indentations that a sphere goes through slowly, on one half-space or on several.

use std::collections::HashSet;
use std::sync::Arc;

use serde::Deserialize;

use super::file::{HalfSpaceTable, PlmTable, ScenarioFile};
use super::law::LawTable;
use super::values::{Depth, Load, Modulus, PoissonsRatio, Strength};
use super::{Kind, Scenario, ScenarioError, unused};
use crate::impact::Warning;
use crate::indentation::{Indenter, Specimen, Target};
use crate::law::{PlmCoefficients, UnloadingExponent};
use crate::material::Material;
use crate::units::{Dimension, human};

/// Rows of a trace that are held until they are written: some hundred megabytes.
const MOST_ROWS: usize = 1_000_000;

/// `[indentation]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct IndentationTable {
    /// In their order.
    pub steps: Vec<StepTable>,
    /// `[[indentation.half_space]]`: several half-spaces, or one whose numbers are uncertain, in place of `[half_space]`.
    pub half_space: Option<Vec<SpecimenTable>>,
}

/// One of `steps`.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a step such as { load = \"200 N\" } or { indentation = \"12 um\" }")]
pub struct StepTable {
    /// Load to reach, or
    pub load: Option<Load>,
    /// indentation to reach: exactly one of the two.
    pub indentation: Option<Depth>,
}

/// `[[indentation.half_space]]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct SpecimenTable {
    /// In tables and pictures.
    pub name: String,
    /// Young's modulus.
    pub youngs_modulus: Modulus,
    /// Its uncertainty, ±.
    pub youngs_modulus_uncertainty: Option<Modulus>,
    /// Poisson's ratio.
    pub poissons_ratio: PoissonsRatio,
    /// Yield strength; without it the half-space is elastic.
    pub yield_strength: Option<Strength>,
    /// Its uncertainty, ±.
    pub yield_strength_uncertainty: Option<Strength>,
}

/// What an `[indentation]` comes to. Plain numbers in SI, all of them checked.
#[derive(Debug, Clone, PartialEq)]
pub struct IndentationScene {
    /// The sphere.
    pub indenter: Indenter,
    /// What it is pressed into; at least one.
    pub specimens: Vec<Specimen>,
    /// Exponent of the unloading branch.
    pub exponent: UnloadingExponent,
    /// Coefficients of the PLM.
    pub coefficients: Arc<PlmCoefficients>,
    /// Where the steps end; at least one.
    pub targets: Vec<Target>,
    /// Evenly spaced rows of the trace in each step.
    pub samples: usize,
    /// What of the scenario has no effect.
    pub warnings: Vec<Warning>,
}

const STEPS: &str = "indentation.steps";
const SPECIMENS: &str = "indentation.half_space";

impl Scenario {
    /// The scene of an indentation.
    ///
    /// # Errors
    /// [`ScenarioError`] where keys contradict each other, something is missing, or the file of coefficients is bad.
    pub fn indentation(&self) -> Result<IndentationScene, ScenarioError> {
        let ScenarioFile { sphere, half_space, indentation, law, .. } = &self.file;
        self.refuse_columns("an indentation")?;
        let table = indentation.as_ref().ok_or_else(|| self.document.missing("", "indentation"))?;
        let plm = match law {
            None => PlmTable::default(),
            Some(LawTable::Plm(plm)) => plm.clone(),
            Some(_) => {
                let message = "an indentation is computed under the PLM: leave this law out";
                return Err(self.document.refuse("law", message.to_owned()));
            }
        };
        let specimens = self.specimens(half_space.as_ref(), table.half_space.as_deref())?;
        let is_elastic = specimens.iter().all(|specimen| specimen.half_space.yield_strength.is_none());
        let targets = self.targets(&table.steps)?;
        let samples = self.samples();
        let rows = samples.saturating_mul(targets.len()).saturating_mul(specimens.len());
        if rows > MOST_ROWS {
            let message = format!("{samples} rows a step make {rows} rows, more than {MOST_ROWS}; take fewer");
            return Err(self.document.refuse("output.samples", message));
        }
        Ok(IndentationScene {
            indenter: Indenter {
                radius: self.radius(sphere)?,
                material: Material { youngs_modulus: sphere.youngs_modulus.0, poissons_ratio: sphere.poissons_ratio.0 },
                yield_strength: sphere.yield_strength.map(|strength| strength.0),
            },
            specimens,
            exponent: plm.unloading_exponent.map(|exponent| exponent.0).unwrap_or_default(),
            coefficients: self.coefficients(&plm)?,
            targets,
            samples,
            warnings: unused(law.as_ref(), is_elastic)
                .into_iter()
                .chain(Kind::Indentation.idle_keys(&self.file))
                .collect(),
        })
    }

    fn targets(&self, steps: &[StepTable]) -> Result<Vec<Target>, ScenarioError> {
        const EXAMPLE: &str = "steps = [{ load = \"200 N\" }, { load = \"0 N\" }]";
        if steps.is_empty() {
            return Err(self.document.refuse(STEPS, format!("there is no step; give one at least, as in {EXAMPLE}")));
        }
        let target = |(number, step): (usize, &StepTable)| match (step.load, step.indentation) {
            (Some(load), None) => Ok(Target::Load(load.0)),
            (None, Some(indentation)) => Ok(Target::Indentation(indentation.0)),
            (both, _) => {
                let what = if both.is_some() { "`load` and `indentation` are both given" } else { "has no target" };
                let message = format!("step {number}: {what}; write exactly one of the two, as in {EXAMPLE}");
                Err(self.document.refuse(STEPS, message))
            }
        };
        (1..).zip(steps).map(target).collect()
    }

    fn specimens(
        &self,
        one: Option<&HalfSpaceTable>,
        several: Option<&[SpecimenTable]>,
    ) -> Result<Vec<Specimen>, ScenarioError> {
        let refuse = |message: String| Err(self.document.refuse(SPECIMENS, message));
        let tables = match (one, several) {
            (Some(_), Some(_)) => {
                return refuse("[half_space] is given too; write only one of the two".to_owned());
            }
            (Some(table), None) => {
                let half_space = table.resolve();
                let known = Specimen { name: None, half_space, modulus_uncertainty: None, strength_uncertainty: None };
                return Ok(vec![known]);
            }
            (None, tables) => tables.unwrap_or_default(),
        };
        if tables.is_empty() {
            return Err(self.document.missing("", "half_space"));
        }
        let mut names = HashSet::new();
        for (i, table) in tables.iter().enumerate() {
            if let Some(problem) = problem_of_name(&table.name) {
                return refuse(format!("number {} {problem}", i + 1));
            }
            if !names.insert(&table.name) {
                return refuse(format!("two are called \"{}\"; give each its own name", table.name));
            }
            self.check_uncertainties(table)?;
        }
        Ok(tables.iter().map(specimen).collect())
    }

    /// An interval that reaches zero has no stiffness or strength at its lower end.
    fn check_uncertainties(&self, table: &SpecimenTable) -> Result<(), ScenarioError> {
        let strength = table.yield_strength.map(|strength| strength.0);
        let pairs = [
            ("youngs_modulus", Some(table.youngs_modulus.0), table.youngs_modulus_uncertainty.map(|by| by.0)),
            ("yield_strength", strength, table.yield_strength_uncertainty.map(|by| by.0)),
        ];
        for (key, value, uncertainty) in pairs {
            let Some(uncertainty) = uncertainty.filter(|by| value.is_none_or(|value| *by >= value)) else { continue };
            let written = human(uncertainty, Dimension::Pressure);
            let problem = match value {
                Some(value) => format!("must be smaller than {key}, {}", human(value, Dimension::Pressure)),
                None => format!("needs {key}, which is missing"),
            };
            let message = format!("\"{}\": {key}_uncertainty = {written} {problem}", table.name);
            return Err(self.document.refuse(SPECIMENS, message));
        }
        Ok(())
    }
}

/// What keeps a name out of tables: a control character moves the terminal that shows it, and a spreadsheet takes a text
/// with one of these signs in front for a formula.
fn problem_of_name(name: &str) -> Option<String> {
    match name.trim_start().chars().next() {
        None => Some("has an empty name; call it by its material".to_owned()),
        Some('=' | '+' | '-' | '@') => Some(format!(
            "is called \"{name}\"; a spreadsheet would take a name that begins with = + - or @ for a formula: begin with a letter or a digit"
        )),
        Some(_) => name
            .contains(char::is_control)
            .then(|| format!("is called \"{}\"; leave the control character out", name.escape_debug())),
    }
}

fn specimen(table: &SpecimenTable) -> Specimen {
    let half_space = HalfSpaceTable {
        youngs_modulus: table.youngs_modulus,
        poissons_ratio: table.poissons_ratio,
        yield_strength: table.yield_strength,
        density: None,
    };
    Specimen {
        name: Some(table.name.clone()),
        half_space: half_space.resolve(),
        modulus_uncertainty: table.youngs_modulus_uncertainty.map(|by| by.0),
        strength_uncertainty: table.yield_strength_uncertainty.map(|by| by.0),
    }
}
