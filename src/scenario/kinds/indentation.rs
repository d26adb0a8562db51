//! `[indentation]`: quasi-static loads and indentations of a sphere, on one half-space or on several.

use crate::contact::body::Sphere;
use crate::contact::law::LawChoice;
use crate::error::Error;
use crate::impact::Warning;
use crate::impact::indentation::{SetPoint, Specimen};
use crate::scenario::input::{Input, NumericKey};
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
/// The list of [`SPECIMENS_KEY`] in the list of keys.
const SPECIMEN_LIST: &str = "indentation.half_space[]";

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
        let (names, inputs): (Vec<Option<String>>, Vec<Input>) = specimens.into_iter().unzip();
        let warnings = self.unused_key_warnings(&inputs, Kind::Indentation);
        let half_spaces = names.into_iter().zip(inputs.iter().map(Input::half_space));
        let specimens = half_spaces.map(|(name, half_space)| Specimen { name, half_space }).collect();
        Ok(IndentationRequest { sphere: self.input.sphere(), specimens, law: self.input.law(), targets, warnings })
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

    /// The half-spaces with their names. Each of several has the keys of one: those of its item in place of those of `[half_space]`.
    fn specimens(&self) -> Result<Vec<(Option<String>, Input)>, Error> {
        let refuse = |message: String| Err(self.document.refusal(SPECIMENS_KEY, message));
        if self.is_given("half_space") {
            return Ok(vec![(None, self.input.clone())]);
        }
        let several = self.input.table_list(SPECIMEN_LIST);
        let Some(several) = several.filter(|several| !several.is_empty()) else {
            return Err(self.document.missing_key("", "half_space"));
        };
        let mut specimens: Vec<(Option<String>, Input)> = Vec::new();
        for (i, item) in several.iter().enumerate() {
            let missing = |name| self.document.missing_key(&format!("{SPECIMENS_KEY}[{i}]"), name);
            let name = item.text_value(key!("indentation.half_space[].name")).ok_or_else(|| missing("name"))?;
            if let Some(problem) = name_problem(name) {
                return refuse(format!("number {} {problem}", i + 1));
            }
            if specimens.iter().any(|(other, _)| other.as_deref() == Some(name)) {
                return refuse(format!("two are called \"{name}\". Give each a different name."));
            }
            let mut input = self.input.clone();
            for (key, number) in item.numbers_of(SPECIMEN_LIST) {
                if let Some(key) = NumericKey::find(&format!("half_space.{key}")) {
                    input.set(key, Some(number));
                }
            }
            let needed = [
                ("youngs_modulus", key!("half_space.youngs_modulus")),
                ("poissons_ratio", key!("half_space.poissons_ratio")),
            ];
            if let Some((name, _)) = needed.into_iter().find(|(_, key)| input.number(*key).is_none()) {
                return Err(missing(name));
            }
            specimens.push((Some(name.to_owned()), input));
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
