//! `[law]`: which laws may be named alone.

use super::Scenario;
use crate::error::Error;
use crate::law::LawChoice;
use crate::scene::laws::COMBINED;

impl Scenario {
    /// The name of the law that the scenario has a table of.
    pub(super) fn law_name(&self) -> Option<&'static str> {
        let names = LawChoice::names().into_iter().chain([COMBINED]);
        names.into_iter().find(|name| self.document.has(&format!("law.{name}")))
    }

    /// Refuses a law that does not load, and a combined law that lacks a half.
    pub(super) fn check_law(&self) -> Result<(), Error> {
        let law = &self.tables.law;
        if let Some(halves) = &law.halves {
            let missing = |half| Err(self.document.missing("law.combined", half));
            if halves.loading.is_none() {
                return missing("loading");
            }
            return if halves.unloading.is_none() { missing("unloading") } else { Ok(()) };
        }
        if law.choice.has_loading() {
            return Ok(());
        }
        let name = law.choice.name();
        let message = format!(
            "{name} is a law of unloading only; write [law.combined] with loading = \"jackson_green\" (or another) and unloading = \"{name}\""
        );
        Err(self.document.refuse(&format!("law.{name}"), message))
    }

    /// Whether the scenario names its method.
    pub fn names_method(&self) -> bool {
        self.input.solver.method.is_some()
    }
}
