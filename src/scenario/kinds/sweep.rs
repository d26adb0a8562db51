//! `[sweep]` and `[monte_carlo]`: keys of the scenario with many values, and the plan that follows.

use crate::error::Error;
use crate::impact::{ImpactError, Method};
use crate::results::{PEENING_MEANS, RESTITUTION, ResultColumn, result_columns};
use crate::scenario::keys::{KeyId, OTHER, key};
use crate::scenario::plan::read_axes::{METHOD_KEY, RandomKeys};
use crate::scenario::plan::{Cases, MAX_CASES, MAX_TRACES, Plan};
use crate::scenario::{Kind, Scenario};

impl Scenario {
    /// The table that the scenario asks for.
    ///
    /// # Errors
    /// [`Error`] for a scenario that is no table, an axis that changes nothing, two that change the same, or more than 2⁶³ cases.
    pub fn plan(&self) -> Result<Plan, Error> {
        if !self.kind()?.is_table() {
            return Err(Error::input("the scenario has neither [sweep] nor [monte_carlo]"));
        }
        let mut input = self.resolve()?;
        // a table has no trace, so the closed form is enough
        input.set_default_method(Method::Auto);
        let refuse = |path: &str, message: String| Err(self.refusal_where_varied(path, message));
        let cases = if let Some(RandomKeys { samples, seed, variables, .. }) = self.variation.monte_carlo.clone() {
            Cases::MonteCarlo { samples, seed, variables }
        } else {
            let axes = self.variation.sweep.clone().unwrap_or_default();
            self.refuse_mixed_classes(&axes)?;
            Cases::Grid(axes)
        };
        let mut plan = Plan::new(&input, cases);
        plan.warnings = self.unused_key_warnings(&plan.inputs_of_word_axes(), Kind::Impact);
        self.select_columns(&mut plan)?;
        plan.has_traces = self.asks_for_traces(&plan)?;
        plan.pictures = self.selected_results("output.picture", key!("output.picture"), &plan)?;
        if let (Some(columns), Some(pictures)) = (&mut plan.columns, &plan.pictures)
            && matches!(plan.cases, Cases::MonteCarlo { .. })
        {
            // a resumed run reads the values of a histogram back
            columns.extend(pictures);
        }
        if let Some(columns) = &mut plan.columns
            && plan.input.peening().is_some()
            && matches!(plan.cases, Cases::MonteCarlo { .. })
        {
            // the coverage by random shots follows from the means of these columns
            columns.extend(PEENING_MEANS);
        }
        if let Some((path, problem)) = plan.unused_axis() {
            return refuse(path, problem);
        }
        if plan.lacks_closed_form() {
            return refuse(METHOD_KEY, ImpactError::NoClosedForm.to_string());
        }
        if let Cases::MonteCarlo { variables, .. } = &plan.cases
            && let Some(variable) =
                variables.iter().find(|variable| variable.probability_in_range() < MIN_PROBABILITY_IN_RANGE)
        {
            let allowed = variable.key.quantity().allowed_range();
            let message = format!(
                "less than {MIN_PROBABILITY_IN_RANGE} of the distribution lies in the allowed range, {allowed}. Change the distribution."
            );
            return refuse(variable.key.path(), message);
        }
        if plan.n_cases() > MAX_CASES {
            return refuse(
                if plan.is_monte_carlo() { "monte_carlo" } else { "sweep" },
                "has more than 2^63 cases. Use fewer.".to_owned(),
            );
        }
        Ok(plan)
    }

    /// True if the scenario asks for the traces of its rows.
    ///
    /// # Errors
    /// [`Error`] for too many rows, and for random cases.
    fn asks_for_traces(&self, plan: &Plan) -> Result<bool, Error> {
        if !self.input.flag(key!("output.traces")) {
            return Ok(false);
        }
        let rows = plan.n_cases();
        let message = if plan.is_monte_carlo() {
            "applies to [sweep] only, because random cases are too many for one picture. Remove this key, or replace [monte_carlo] by [sweep].".to_owned()
        } else if rows > MAX_TRACES {
            format!(
                "this table has {rows} rows, and at most {MAX_TRACES} traces can be told apart in one picture. Use fewer values on the axes, or remove this key."
            )
        } else {
            return Ok(true);
        };
        Err(self.document.refusal("output.traces", message))
    }

    /// Leaves in the table of a plan only the results that the scenario names, if it names any.
    pub(in crate::scenario) fn select_columns(&self, plan: &mut Plan) -> Result<(), Error> {
        let chosen = self.selected_results("output.columns", key!("output.columns"), plan)?;
        plan.columns = chosen.map(|chosen| [chosen, vec![RESTITUTION]].concat());
        Ok(())
    }

    /// The results that this key names, in the order of the columns; `None` where it is not given.
    fn selected_results(&self, key: &str, at: KeyId<OTHER>, plan: &Plan) -> Result<Option<Vec<&'static str>>, Error> {
        let Some(names) = self.input.word_list(at) else { return Ok(None) };
        let mut chosen = Vec::new();
        for ResultColumn { name, needs, .. } in result_columns() {
            let count = names.iter().filter(|given| *given == name).count();
            if count > 0
                && let Some(reason) = plan.column_refusal(needs)
            {
                return Err(self.document.refusal(key, format!("\"{name}\" is not available: {reason}.")));
            }
            if count > 1 {
                return Err(self.document.refusal(key, format!("\"{name}\" is named twice")));
            }
            chosen.extend((count > 0).then_some(name));
        }
        Ok(Some(chosen))
    }

    /// Refuses columns for a scenario that is computed as no table.
    pub(crate) fn refuse_columns(&self) -> Result<(), Error> {
        let given = [("output.columns", key!("output.columns")), ("output.picture", key!("output.picture"))];
        let named = given.into_iter().find(|(_, at)| self.input.word_list(*at).is_some()).map(|(key, _)| key);
        let traces = Some("output.traces").filter(|_| self.input.flag(key!("output.traces")));
        let Some(key) = named.or(traces) else { return Ok(()) };
        // of a table only the first case may be asked for, which is one impact
        let kind = Some(self.kind()?).filter(|kind| !kind.is_table()).unwrap_or(Kind::Impact);
        let message = format!(
            "applies to {} only, and this scenario is {}. Remove this key, or add a [sweep].",
            if named.is_some() { "[sweep] and [monte_carlo]" } else { "[sweep]" },
            kind.description()
        );
        Err(self.document.refusal(key, message))
    }
}

/// A distribution with a smaller share in the allowed range is taken for a mistake.
const MIN_PROBABILITY_IN_RANGE: f64 = 1e-3;
