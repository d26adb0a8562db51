//! `[indentation]`: quasi-static loads and indentations of a sphere, on one half-space or on several.

use crate::contact::law::LawChoice;
use crate::contact::pair::{HalfSpace, Material, Sphere};
use crate::error::Error;
use crate::impact::Warning;
use crate::impact::indentation::{SetPoint, Specimen};
use crate::scenario::Scenario;
use crate::scenario::input::{Input, Purpose};
use crate::scenario::keys::{at, key};

/// Maximum number of rows of a trace, which is held in memory: some hundred megabytes.
const MOST_ROWS: usize = 1_000_000;

/// The request of `[indentation]`. All numbers are in SI, and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct IndentationScene {
    pub sphere: Sphere,
    /// The half-spaces; at least one.
    pub specimens: Vec<Specimen>,
    pub law: LawChoice,
    /// The ends of the steps; at least one.
    pub targets: Vec<SetPoint>,
    /// Warnings about keys without effect.
    pub warnings: Vec<Warning>,
}

const STEPS: &str = "indentation.steps";
const SPECIMENS: &str = "indentation.half_space";

impl Scenario {
    pub fn indentation(&self) -> Result<IndentationScene, Error> {
        self.refuse_columns()?;
        let specimens = self.specimens()?;
        let targets = self.targets()?;
        let samples = self.input.samples();
        let rows = samples.saturating_mul(targets.len()).saturating_mul(specimens.len());
        if rows > MOST_ROWS {
            let message = format!("{samples} rows a step make {rows} rows, more than {MOST_ROWS}; take fewer");
            return Err(self.document.refuse("output.samples", message));
        }
        self.check_flow(&self.input)?;
        self.check_strength(&self.input)?;
        let inputs: Vec<Input> = specimens.iter().map(|specimen| self.input_on(&specimen.half_space)).collect();
        let warnings = self.without_effect(&inputs, Purpose::Indentation);
        Ok(IndentationScene { sphere: self.input.sphere(), specimens, law: self.input.law(), targets, warnings })
    }

    fn input_on(&self, &HalfSpace { material, yield_strength, .. }: &HalfSpace) -> Input {
        let mut input = self.input.clone();
        input.set(at!("half_space.youngs_modulus"), Some(material.youngs_modulus));
        input.set(at!("half_space.poissons_ratio"), Some(material.poissons_ratio));
        input.set(at!("half_space.yield_strength"), yield_strength);
        input
    }

    fn targets(&self) -> Result<Vec<SetPoint>, Error> {
        let as_in = format!("as in {}", key::STEPS);
        let Some(steps) = self.input.items("indentation.steps[]") else {
            let message = format!("the key `steps` is missing: a list, {as_in}");
            return Err(self.document.refuse("indentation", message));
        };
        if steps.is_empty() {
            let message = format!("there is no step; give one at least, {as_in}");
            return Err(self.document.refuse(STEPS, message));
        }
        let ends = |step: &Input| {
            (step.number(at!("indentation.steps[].load")), step.number(at!("indentation.steps[].indentation")))
        };
        let target = |(i, step): (usize, &Input)| match ends(step) {
            (Some(load), None) => Ok(SetPoint::Load(load)),
            (None, Some(indentation)) => Ok(SetPoint::Indentation(indentation)),
            (both, _) => {
                let problem = if both.is_some() { "`load` and `indentation` are both given" } else { "has no target" };
                let message = format!("step {i}: {problem}; write exactly one of the two, {as_in}");
                Err(self.document.refuse(STEPS, message))
            }
        };
        (1..).zip(steps).map(target).collect()
    }

    fn specimens(&self) -> Result<Vec<Specimen>, Error> {
        let refuse = |message: String| Err(self.document.refuse(SPECIMENS, message));
        if self.has("half_space") {
            self.check_flow(&self.input)?;
            return Ok(vec![Specimen { name: None, half_space: self.input.half_space() }]);
        }
        let several = self.input.items("indentation.half_space[]");
        let Some(several) = several.filter(|several| !several.is_empty()) else {
            return Err(self.document.missing("", "half_space"));
        };
        let mut specimens: Vec<Specimen> = Vec::new();
        for (i, one) in several.iter().enumerate() {
            let missing = |name| self.document.missing(&format!("{SPECIMENS}[{i}]"), name);
            let name = one.text(at!("indentation.half_space[].name")).ok_or_else(|| missing("name"))?;
            if let Some(problem) = problem_of_name(name) {
                return refuse(format!("number {} {problem}", i + 1));
            }
            if specimens.iter().any(|other| other.name.as_deref() == Some(name)) {
                return refuse(format!("two are called \"{name}\"; give each its own name"));
            }
            let modulus = one.number(at!("indentation.half_space[].youngs_modulus"));
            let ratio = one.number(at!("indentation.half_space[].poissons_ratio"));
            let material = Material {
                youngs_modulus: modulus.ok_or_else(|| missing("youngs_modulus"))?,
                poissons_ratio: ratio.ok_or_else(|| missing("poissons_ratio"))?,
            };
            let yield_strength = one.number(at!("indentation.half_space[].yield_strength"));
            let half_space = HalfSpace::flat(material, yield_strength);
            specimens.push(Specimen { name: Some(name.to_owned()), half_space });
        }
        Ok(specimens)
    }
}

/// Why a name is not allowed in tables. A control character disturbs a terminal. A spreadsheet reads a text that begins with one of
/// these signs as a formula.
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
