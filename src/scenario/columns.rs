//! `[output] columns`: which results a table has.

use super::Scenario;
use crate::error::Error;
use crate::plan::Plan;
use crate::scene::results::columns;

/// A table always has this result: a resumed run reads it back.
const RESTITUTION: &str = "restitution";

impl Scenario {
    /// Leaves in the table of a plan only the results that the scenario names, if it names any.
    pub(super) fn choose_columns(&self, plan: &mut Plan) -> Result<(), Error> {
        let Some(names) = &self.tables.output.columns else {
            return Ok(());
        };
        let refuse = |message: String| Err(self.document.refuse("output.columns", message));
        let mut chosen = vec![RESTITUTION];
        for column in columns().iter().filter(|column| names.iter().any(|name| name == column.name)) {
            let name = column.name;
            if let Some(reason) = column.missing(&plan.scene) {
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
    pub(crate) fn refuse_columns(&self, scene: &str) -> Result<(), Error> {
        if self.tables.output.columns.is_none() {
            return Ok(());
        }
        let message = format!("is for tables, and this scenario is {scene}: leave it out, or give an impact a [sweep]");
        Err(self.document.refuse("output.columns", message))
    }
}
