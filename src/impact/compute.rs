//! The impacts of a contact: results of a single one, and rows of tables.

use std::sync::LazyLock;

use super::oblique::{Approach, ObliqueImpact};
use super::problem::contact::Contact;
use super::problem::error::ImpactError;
use super::result::impact::Impact;
use super::result::row::Essentials;
use super::scaled_impact::{Case, hertz};
use super::solve::closed_form;
use super::solve::outcome::Outcome;
use super::solve::{FINEST, Method, Solver, run};
use super::warnings;
use crate::contact::law::{LoadingHistory, Surface, Unloading, UnloadingRule};
use crate::numerics::ode::IntegrationError;

impl Case<'_> {
    /// The outcome by the energy balance, if it has a closed form; its times under gravity have this tolerance.
    #[inline]
    fn exact(&self, tolerance: f64) -> Result<Option<Outcome>, IntegrationError> {
        // in these scales all elastic impacts are equal
        static ELASTIC: LazyLock<Outcome> = LazyLock::new(|| closed_form::solve(hertz(), 1.0));
        match self.ground.law.unloading_rule {
            UnloadingRule::Hertz if self.q == 1.0 && self.forces.is_none() => Ok(Some(*ELASTIC)),
            _ => closed_form::solve_with(self.ground, self.q, &self.forces, tolerance),
        }
    }
}

impl Contact {
    /// The exact outcome of an impact, without integration; under gravity its times are accurate to 1e-13.
    ///
    /// # Errors
    /// [`ImpactError::Range`], see [`Contact::scaled`]; [`ImpactError::NoClosedForm`] under damping and on a plate.
    pub fn closed_form(&self, speed: f64) -> Result<Impact, ImpactError> {
        self.impact(speed, &Solver { method: Method::ClosedForm, tolerance: FINEST, ..Solver::default() }, None)
    }

    /// The results of an impact for a row of a table, computed by this solver.
    ///
    /// # Errors
    /// [`ImpactError`] if the result leaves double precision, the law has no answer, the integrator fails, or the method is not
    /// possible.
    #[inline]
    pub fn row(&self, approach: impl Into<Approach>, solver: &Solver) -> Result<Essentials, ImpactError> {
        let approach = approach.into();
        let [speed, _] = approach.components();
        match self.rated_at(speed)? {
            None => self.row_of(approach, speed, solver),
            Some(rated) => rated.row_of(approach, speed, solver),
        }
    }

    #[inline]
    fn row_of(&self, approach: Approach, speed: f64, solver: &Solver) -> Result<Essentials, ImpactError> {
        let case = self.case(None, speed)?;
        let outcome = match self.chosen(solver.method, false)? {
            Method::ClosedForm => case.exact(solver.tolerance)?,
            _ => None,
        };
        let outcome = match outcome {
            Some(outcome) => outcome,
            None => run(case.ground, case.q, &case.forces, None, solver, None)?.outcome,
        };
        case.ground.check(&outcome.unloading)?;
        let mut essentials = Essentials::new(self, speed, &case, &outcome)?;
        if let Some(inclined) = ObliqueImpact::new(self, &case, &outcome, approach)? {
            essentials.rebound = Some(inclined.rebound(&inclined.slip(false)?)?);
        }
        Ok(essentials)
    }

    #[inline]
    fn chosen(&self, method: Method, has_trace: bool) -> Result<Method, ImpactError> {
        method.chosen(self.forces(), has_trace).ok_or(ImpactError::NoClosedForm)
    }

    /// Computes one impact at a speed \[m/s\], or an [`Approach`]; with `samples`, with a trace of that many evenly
    /// spaced rows (first touch and separation among them) and a row for every other event.
    ///
    /// # Errors
    /// [`ImpactError`] if the result leaves double precision or the integrator fails.
    pub fn impact(
        &self,
        approach: impl Into<Approach>,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<Impact, ImpactError> {
        let approach = approach.into();
        let [speed, _] = approach.components();
        let rated = self.rated_at(speed)?;
        rated.as_ref().unwrap_or(self).impact_under(None, approach, solver, samples).map(|(impact, ..)| impact)
    }

    /// The impact with its ground and unloading branch, on fresh surface or in a dent.
    pub(super) fn impact_under<'a>(
        &'a self,
        dent: Option<&'a LoadingHistory>,
        approach: Approach,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<(Impact, Surface<'a>, Unloading), ImpactError> {
        let [speed, _] = approach.components();
        let case = self.case(dent, speed)?;
        let Case { ground, q, forces, .. } = case;
        let method = self.chosen(solver.method, samples.is_some())?;
        let exact = case.exact(if method == Method::ClosedForm { solver.tolerance } else { FINEST })?;
        let solver = Solver { method, ..*solver };
        let computed = run(ground, q, &forces, exact.as_ref(), &solver, samples)?;
        let unloading = computed.outcome.unloading;
        ground.check(&unloading)?;
        let mut impact = Impact::new(self, speed, &case, method, &computed, exact.as_ref())?;
        impact.warnings = warnings::warnings(self, &impact, ground, &unloading, &solver);
        if let Some(inclined) = ObliqueImpact::new(self, &case, &computed.outcome, approach)? {
            impact.add_friction(&inclined, approach)?;
            impact.warnings.extend(warnings::of_oblique(self, &impact, approach));
        }
        Ok((impact, ground, unloading))
    }
}
