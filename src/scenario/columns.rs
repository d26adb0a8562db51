//! `[output] columns`: which results a table has.

use super::{Scenario, ScenarioError};
use crate::nearest::nearest;
use crate::sweep::plan::Plan;
use crate::sweep::table::RESULT_COLUMNS;

/// A table always has it: what the case came to, and what a resumed run reads back.
const RESTITUTION: &str = "restitution";

impl Scenario {
    /// Leaves in the table of a plan only the results that the scenario names, if it names any.
    pub(super) fn choose_columns(&self, plan: &mut Plan) -> Result<(), ScenarioError> {
        let Some(names) = &self.file.output.columns else {
            return Ok(());
        };
        let refuse = |message: String| Err(self.document.refuse("output.columns", message));
        let mut chosen = vec![RESTITUTION];
        for name in names {
            let Some(column) = RESULT_COLUMNS.iter().find(|column| column.name == name) else {
                let known: Vec<_> = RESULT_COLUMNS.iter().map(|column| column.name).collect();
                let guess = nearest(name, known.iter().copied());
                let hint = guess.map_or_else(String::new, |near| format!(", did you mean \"{near}\"?"));
                return refuse(format!("\"{name}\" is no result of a table{hint}; results are {}", known.join(", ")));
            };
            if let Some(reason) = column.missing(plan) {
                return refuse(format!("\"{name}\" is not there: {reason}"));
            }
            if names.iter().filter(|other| *other == name).count() > 1 {
                return refuse(format!("\"{name}\" is named twice"));
            }
            chosen.push(column.name);
        }
        plan.columns = Some(chosen);
        Ok(())
    }

    /// Refuses columns for `scene`, which is no table.
    pub(crate) fn refuse_columns(&self, scene: &str) -> Result<(), ScenarioError> {
        if self.file.output.columns.is_none() {
            return Ok(());
        }
        let message = format!("is for tables, and this scenario is {scene}: leave it out, or give an impact a [sweep]");
        Err(self.document.refuse("output.columns", message))
    }
}
