//! `[sweep]` and `[monte_carlo]`: keys of the scenario with many values, and the plan that follows.

use super::axes::{LAW, RandomKeys};
use super::{Kind, Scenario};
use crate::error::Error;
use crate::impact::{ImpactError, Method, Warning};
use crate::law::LawChoice;
use crate::plan::axis::{Axis, Word};
use crate::plan::{Cases, MOST_CASES, Plan};
use crate::scene::Use;
use crate::scene::taken::Taken;

impl Scenario {
    /// The sweep that the scenario asks for, if it does.
    ///
    /// # Errors
    /// [`Error`] for an axis that changes nothing, two that change the same, or more than 2⁶³ cases.
    pub fn plan(&self) -> Result<Option<Plan>, Error> {
        if !matches!(self.kind()?, Kind::Sweep | Kind::MonteCarlo) {
            return Ok(None);
        }
        let mut input = self.first_impact()?;
        if input.solver.method.is_none() {
            // a table has no trace, so the closed form is enough
            input.solver.method = Some(Method::Auto);
        }
        let own_law = input.law.clone();
        let refuse = |path: &str, message: String| Err(self.document.refuse(path, message));
        let (cases, table) = match (&self.tables.sweep, &self.tables.monte_carlo) {
            (None, None) => return Ok(None),
            (Some(axes), _) => {
                let mut axes = axes.clone();
                for word in axes.iter_mut().flat_map(Axis::words_mut) {
                    // the law of the scenario keeps the parameters that the scenario gives
                    if let Word::Law(law) = word
                        && law.name() == own_law.name()
                    {
                        law.clone_from(&own_law);
                    }
                }
                self.refuse_mixture(&axes)?;
                (Cases::Grid(axes), "sweep")
            }
            (None, Some(RandomKeys { samples, seed, variables, .. })) => {
                (Cases::MonteCarlo { samples: *samples, seed: *seed, variables: variables.clone() }, "monte_carlo")
            }
        };
        let mut plan = Plan::new(input, cases);
        let is_varied = |taken: &&Taken| plan.axes().iter().any(|axis| axis.path() == taken.body.material());
        plan.scene.materials = self.taken.iter().filter(|taken| !is_varied(taken)).cloned().collect();
        // a key that varies may give the half-space its yield strength
        let is_elastic = plan.scene.half_space.yield_strength.is_none();
        plan.scene.warnings = self.without_effect(&plan.input, Use::Impact, is_elastic);
        let unused_law = self.unused_law(&own_law, plan.axes());
        plan.scene.warnings.extend(unused_law);
        self.choose_columns(&mut plan)?;
        if let Some((path, problem)) = self.contradicted(&plan.paths()).or_else(|| plan.unused()) {
            return refuse(&format!("{table}.{path}"), problem);
        }
        if plan.lacks_closed_form() {
            let is_swept = plan.paths().contains(&"solver.method");
            let key = if is_swept { format!("{table}.solver.method") } else { "solver.method".to_owned() };
            return refuse(&key, ImpactError::NoClosedForm.to_string());
        }
        if let Cases::MonteCarlo { variables, .. } = &plan.cases
            && let Some(variable) = variables.iter().find(|variable| variable.kept() < LEAST_KEPT)
        {
            let allowed = variable.key.quantity.allowed();
            let message = format!("almost nothing of its distribution is in the allowed range, {allowed}");
            return refuse(&format!("{table}.{}", variable.key.path), message);
        }
        if plan.count() > MOST_CASES {
            return refuse(table, "has more than 2^63 cases; take fewer".to_owned());
        }
        Ok(Some(plan))
    }

    /// The warning about the table of a law that is not on the axis of laws.
    fn unused_law(&self, own: &LawChoice, axes: &[Axis]) -> Option<Warning> {
        self.law_name()?;
        let laws = axes.iter().find(|axis| axis.path() == LAW)?.words();
        let is_used = laws.iter().any(|law| law.name() == own.name());
        let reason = "no case is under that law; name it in \"law\" of [sweep], or leave its table out";
        (!is_used).then(|| Warning::unused(&format!("law.{}", own.about().name), reason))
    }
}

/// A distribution with a smaller share in the allowed range is taken for a mistake.
const LEAST_KEPT: f64 = 1e-3;
