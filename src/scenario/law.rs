//! `[law]`: one table, named by its law, with that law's own keys.

use std::sync::Arc;

use super::{Scenario, ScenarioError};
use crate::impact::Method;
use crate::law::Combined;
use crate::law::catalogue::jackson_green::Hardness;
use crate::law::jumps::Jumps;
use crate::law::{LawChoice, Plm, PlmCoefficients};
use crate::scene::{KEYS, Scene};

impl Scenario {
    /// The name of the law that the scenario has a table of.
    pub(super) fn law_name(&self) -> Option<&'static str> {
        let names = LawChoice::names().into_iter().chain([COMBINED]);
        names.into_iter().find(|name| self.entries.has(&format!("law.{name}")))
    }

    /// The law that the scenario names, PLM if it names none. Its numeric parameters are not set yet.
    pub(super) fn law(&self) -> Result<LawChoice, ScenarioError> {
        let mut choice = match self.law_name() {
            Some(COMBINED) => LawChoice::Combined(Combined {
                loading: Box::new(self.half("loading")?),
                unloading: Box::new(self.half("unloading")?),
            }),
            name => name.and_then(LawChoice::from_name).unwrap_or_default(),
        };
        if !choice.has_loading() {
            let name = choice.name();
            let message = format!(
                "{name} is a law of unloading only; write [law.combined] with loading = \"jackson_green\" (or another) and unloading = \"{name}\""
            );
            return Err(self.document.refuse(&format!("law.{name}"), message));
        }
        let is = |path: &str, word: &str| self.entries.text(path) == Some(word);
        let jumps =
            |law: &str| if is(&format!("law.{law}.jumps"), "crossed") { Jumps::Crossed } else { Jumps::Printed };
        match &mut choice {
            LawChoice::Plm(plm) => {
                plm.coefficients = self.coefficients()?;
                plm.flow = self.flow()?;
            }
            LawChoice::JacksonGreen(law) => {
                law.jumps = jumps("jackson_green");
                if is("law.jackson_green.hardness", "cosine") {
                    law.hardness = Hardness::Cosine;
                }
            }
            LawChoice::KogutEtsion(law) => law.jumps = jumps("kogut_etsion"),
            LawChoice::KogutKomvopoulos(law) => law.jumps = jumps("kogut_komvopoulos"),
            _ => {}
        }
        Ok(choice)
    }

    /// The law with its numeric parameters.
    pub(super) fn whole_law(&self) -> Result<LawChoice, ScenarioError> {
        let mut scene = Scene::of_law(self.law()?);
        for key in KEYS.iter().filter(|key| key.path.starts_with("law.")) {
            if let Some(value) = self.entries.number(key.path) {
                (key.set)(&mut scene, value);
            }
        }
        Ok(scene.law)
    }

    fn half(&self, name: &str) -> Result<LawChoice, ScenarioError> {
        let given = self.entries.text(&format!("law.{COMBINED}.{name}"));
        given.and_then(LawChoice::from_name).ok_or_else(|| self.document.missing("law.combined", name))
    }

    fn coefficients(&self) -> Result<Arc<PlmCoefficients>, ScenarioError> {
        let Some(path) = self.entries.text(COEFFICIENTS) else { return Ok(Plm::default().coefficients) };
        let refuse = |message: String| self.document.refuse(COEFFICIENTS, message);
        let text = self.text_of_file(COEFFICIENTS).unwrap_or_default();
        let table = PlmCoefficients::from_toml(text).map_err(|error| {
            refuse(format!("{}: {}", self.directory.join(path).display(), error.to_string().trim_end()))
        })?;
        Ok(Arc::new(table))
    }

    /// The method that the scenario names.
    pub(super) fn method(&self) -> Option<Method> {
        self.entries.text("solver.method").and_then(Method::from_name)
    }

    /// Whether the scenario names its method.
    pub fn names_method(&self) -> bool {
        self.method().is_some()
    }
}

/// The law of two halves.
const COMBINED: &str = "combined";
/// The key of the file of coefficients.
pub(super) const COEFFICIENTS: &str = "law.plm.coefficients";
