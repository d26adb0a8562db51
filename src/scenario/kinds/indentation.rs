//! `[indentation]`: quasi-static loads and indentations of a sphere, on one half-space or on several.

use crate::contact::body::{HalfSpace, Material, Sphere};
use crate::contact::law::LawChoice;
use crate::error::Error;
use crate::impact::Warning;
use crate::impact::indentation::{SetPoint, Specimen};
use crate::scenario::input::Input;
use crate::scenario::keys::{key, key_spec};
use crate::scenario::{Kind, Scenario};

/// Maximum number of rows of a trace, which is held in memory: some hundred megabytes.
const MAX_TRACE_ROWS: usize = 1_000_000;

/// The request of `[indentation]`. All numbers are in SI, and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct IndentationRequest {
    pub sphere: Sphere,
    /// The half-spaces; at least one.
    pub specimens: Vec<Specimen>,
    pub law: LawChoice,
    /// The ends of the steps; at least one.
    pub targets: Vec<SetPoint>,
    /// Warnings about keys without effect.
    pub warnings: Vec<Warning>,
}

const STEPS_KEY: &str = "indentation.steps";
const SPECIMENS_KEY: &str = "indentation.half_space";

impl Scenario {
    pub fn indentation(&self) -> Result<IndentationRequest, Error> {
        self.refuse_columns()?;
        let specimens = self.specimens()?;
        let targets = self.set_points()?;
        let samples = self.input.samples();
        let rows = samples.saturating_mul(targets.len()).saturating_mul(specimens.len());
        if rows > MAX_TRACE_ROWS {
            let message = format!("{samples} rows a step make {rows} rows, more than {MAX_TRACE_ROWS}; use fewer");
            return Err(self.document.refusal("output.samples", message));
        }
        self.check_flow(&self.input)?;
        self.check_strength(&self.input)?;
        let inputs: Vec<Input> =
            specimens.iter().map(|specimen| self.input_for_specimen(&specimen.half_space)).collect();
        let warnings = self.unused_key_warnings(&inputs, Kind::Indentation);
        Ok(IndentationRequest { sphere: self.input.sphere(), specimens, law: self.input.law(), targets, warnings })
    }

    fn input_for_specimen(&self, &HalfSpace { material, yield_strength, .. }: &HalfSpace) -> Input {
        let mut input = self.input.clone();
        input.set(key!("half_space.youngs_modulus"), Some(material.youngs_modulus));
        input.set(key!("half_space.poissons_ratio"), Some(material.poissons_ratio));
        input.set(key!("half_space.yield_strength"), yield_strength);
        input
    }

    fn set_points(&self) -> Result<Vec<SetPoint>, Error> {
        let as_in = format!("as in {}", key_spec::STEPS_EXAMPLE);
        let Some(steps) = self.input.table_list("indentation.steps[]") else {
            let message = format!("the key `steps` is missing: a list, {as_in}");
            return Err(self.document.refusal("indentation", message));
        };
        if steps.is_empty() {
            let message = format!("there is no step. Give at least one, {as_in}.");
            return Err(self.document.refusal(STEPS_KEY, message));
        }
        let ends = |step: &Input| {
            (step.number(key!("indentation.steps[].load")), step.number(key!("indentation.steps[].indentation")))
        };
        let target = |(i, step): (usize, &Input)| match ends(step) {
            (Some(load), None) => Ok(SetPoint::Load(load)),
            (None, Some(indentation)) => Ok(SetPoint::Indentation(indentation)),
            (both, _) => {
                let problem =
                    if both.is_some() { "`load` and `indentation` exclude each other" } else { "has no target" };
                let message = format!("step {i} {problem}. Give either load or indentation, {as_in}.");
                Err(self.document.refusal(STEPS_KEY, message))
            }
        };
        (1..).zip(steps).map(target).collect()
    }

    fn specimens(&self) -> Result<Vec<Specimen>, Error> {
        let refuse = |message: String| Err(self.document.refusal(SPECIMENS_KEY, message));
        if self.origin("half_space").is_given() {
            self.check_flow(&self.input)?;
            return Ok(vec![Specimen { name: None, half_space: self.input.half_space() }]);
        }
        let several = self.input.table_list("indentation.half_space[]");
        let Some(several) = several.filter(|several| !several.is_empty()) else {
            return Err(self.document.missing_key("", "half_space"));
        };
        let mut specimens: Vec<Specimen> = Vec::new();
        for (i, one) in several.iter().enumerate() {
            let missing = |name| self.document.missing_key(&format!("{SPECIMENS_KEY}[{i}]"), name);
            let name = one.text_value(key!("indentation.half_space[].name")).ok_or_else(|| missing("name"))?;
            if let Some(problem) = name_problem(name) {
                return refuse(format!("number {} {problem}", i + 1));
            }
            if specimens.iter().any(|other| other.name.as_deref() == Some(name)) {
                return refuse(format!("two are called \"{name}\". Give each a different name."));
            }
            let modulus = one.number(key!("indentation.half_space[].youngs_modulus"));
            let ratio = one.number(key!("indentation.half_space[].poissons_ratio"));
            let material = Material {
                youngs_modulus: modulus.ok_or_else(|| missing("youngs_modulus"))?,
                poissons_ratio: ratio.ok_or_else(|| missing("poissons_ratio"))?,
            };
            let yield_strength = one.number(key!("indentation.half_space[].yield_strength"));
            let half_space = HalfSpace::flat(material, yield_strength);
            specimens.push(Specimen { name: Some(name.to_owned()), half_space });
        }
        Ok(specimens)
    }
}

/// Why a name is not allowed in tables. A control character disturbs a terminal. A spreadsheet reads a text that begins with one of
/// these signs as a formula.
fn name_problem(name: &str) -> Option<String> {
    match name.trim_start().chars().next() {
        None => Some("has an empty name. Name the material, for example.".to_owned()),
        Some('=' | '+' | '-' | '@') => Some(format!(
            "is called \"{name}\". A name must not begin with = + - or @, because a spreadsheet reads such a text as a formula. Begin with a letter or a digit."
        )),
        Some(_) => name
            .contains(char::is_control)
            .then(|| format!("is called \"{}\". Remove the control character.", name.escape_debug())),
    }
}
