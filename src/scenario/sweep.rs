//! `[sweep]` and `[monte_carlo]`: keys of the scenario with many values, and the plan that follows.

use super::axes::{METHOD, RandomKeys};
use super::{Kind, Scenario};
use crate::error::Error;
use crate::impact::{ImpactError, Method};
use crate::plan::{Cases, MOST_CASES, Plan};
use crate::scene::Use;
use crate::scene::at::at;
use crate::scene::results::columns;

impl Scenario {
    /// The sweep that the scenario asks for, if it does.
    ///
    /// # Errors
    /// [`Error`] for an axis that changes nothing, two that change the same, or more than 2⁶³ cases.
    pub fn plan(&self) -> Result<Option<Plan>, Error> {
        if !matches!(self.kind()?, Kind::Sweep | Kind::MonteCarlo) {
            return Ok(None);
        }
        let mut input = self.resolve()?;
        // a table has no trace, so the closed form is enough
        input.choose_method(Method::Auto);
        let refuse = |path: &str, message: String| Err(self.refuse_varied(path, message));
        let cases = match (&self.varied.sweep, &self.varied.monte_carlo) {
            (None, None) => return Ok(None),
            (Some(axes), _) => {
                self.refuse_mixture(axes)?;
                Cases::Grid(axes.clone())
            }
            (None, Some(RandomKeys { samples, seed, variables, .. })) => {
                Cases::MonteCarlo { samples: *samples, seed: *seed, variables: variables.clone() }
            }
        };
        let mut plan = Plan::new(&input, cases);
        plan.warnings = self.without_effect(&plan.worded(), Use::Impact);
        self.choose_columns(&mut plan)?;
        self.choose_pictures(&mut plan)?;
        if let Some((path, problem)) = plan.unused() {
            return refuse(path, problem);
        }
        if plan.lacks_closed_form() {
            return refuse(METHOD, ImpactError::NoClosedForm.to_string());
        }
        if let Cases::MonteCarlo { variables, .. } = &plan.cases
            && let Some(variable) = variables.iter().find(|variable| variable.kept() < LEAST_KEPT)
        {
            let allowed = variable.key.quantity.allowed();
            let message = format!("almost nothing of its distribution is in the allowed range, {allowed}");
            return refuse(variable.key.path, message);
        }
        if plan.count() > MOST_CASES {
            return refuse(
                if plan.is_monte_carlo() { "monte_carlo" } else { "sweep" },
                "has more than 2^63 cases; take fewer".to_owned(),
            );
        }
        Ok(Some(plan))
    }

    /// Draws the results that the scenario names, if it names any.
    fn choose_pictures(&self, plan: &mut Plan) -> Result<(), Error> {
        let Some(names) = self.input.words(at!("output.picture")) else { return Ok(()) };
        if plan.is_monte_carlo() {
            let message = "random cases have a histogram of the restitution: leave the key out, or draw the columns of the table with another tool";
            return Err(self.document.refuse("output.picture", message));
        }
        let all = columns();
        let mut chosen = Vec::new();
        for name in names {
            let Some(column) = all.iter().find(|column| column.name == name) else { continue };
            if let Some(reason) = plan.missing(column.needs) {
                return Err(self.document.refuse("output.picture", format!("\"{name}\" is not there: {reason}")));
            }
            chosen.push(*column);
        }
        (plan.pictures, plan.has_chosen_pictures) = (chosen, true);
        Ok(())
    }

    /// Leaves in the table of a plan only the results that the scenario names, if it names any.
    pub(super) fn choose_columns(&self, plan: &mut Plan) -> Result<(), Error> {
        let Some(names) = self.input.words(at!("output.columns")) else {
            return Ok(());
        };
        let refuse = |message: String| Err(self.document.refuse("output.columns", message));
        let mut chosen = vec![RESTITUTION];
        for column in columns().iter().filter(|column| names.iter().any(|name| name == column.name)) {
            let name = column.name;
            if let Some(reason) = plan.missing(column.needs) {
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
        let given = [("output.columns", at!("output.columns")), ("output.picture", at!("output.picture"))];
        let Some((key, _)) = given.into_iter().find(|(_, at)| self.input.words(*at).is_some()) else { return Ok(()) };
        let message = format!("is for tables, and this scenario is {scene}: leave it out, or give an impact a [sweep]");
        Err(self.document.refuse(key, message))
    }
}

/// A distribution with a smaller share in the allowed range is taken for a mistake.
const LEAST_KEPT: f64 = 1e-3;

/// A table always has this result: a resumed run reads it back.
const RESTITUTION: &str = "restitution";
