//! The impacts of a contact: results of a single one, and rows of tables.

use std::sync::LazyLock;

use super::oblique::{Approach, ObliqueImpact};
use super::problem::contact::Contact;
use super::problem::error::ImpactError;
use super::result::impact::Impact;
use super::result::row::ImpactRow;
use super::scaled_impact::{ScaledImpact, hertz_law};
use super::solve::closed_form;
use super::solve::outcome::{ScaledResult, Solution};
use super::solve::{Method, Solver, TRACE_TOLERANCE, solve};
use crate::contact::law::UnloadingRule;
use crate::numerics::ode::IntegrationError;

impl ScaledImpact<'_> {
    /// The outcome by the energy balance, if it has a closed form; its times under gravity have this tolerance.
    #[inline]
    fn closed_form_outcome(&self, tolerance: f64) -> Result<Option<ScaledResult>, IntegrationError> {
        // in these scales all elastic impacts are equal
        static ELASTIC: LazyLock<ScaledResult> = LazyLock::new(|| closed_form::solve(hertz_law(), 1.0));
        match self.ground.law.unloading_rule {
            UnloadingRule::Hertz if self.q == 1.0 && self.forces.is_none() => Ok(Some(*ELASTIC)),
            _ => closed_form::solve_conservative(self.ground, self.q, &self.forces, tolerance),
        }
    }

    /// The closed form, if there is one, and the solution by the method of the solver.
    ///
    /// # Errors
    /// [`ImpactError`] if the integrator fails, or the law has no answer at this peak.
    pub(super) fn solve(
        &self,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<(Option<ScaledResult>, Solution), ImpactError> {
        let tolerance = if solver.method == Method::ClosedForm { solver.tolerance } else { TRACE_TOLERANCE };
        let exact = self.closed_form_outcome(tolerance)?;
        let solution = solve(self.ground, self.q, &self.forces, exact.as_ref(), solver, samples)?;
        self.ground.check(&solution.outcome.unloading)?;
        Ok((exact, solution))
    }
}

impl Contact {
    /// The exact outcome of an impact, without integration; under gravity its times are accurate to 1e-13.
    ///
    /// # Errors
    /// [`ImpactError::Range`], see [`Contact::scaling`]; [`ImpactError::NoClosedForm`] under damping, and on a plate or rod.
    pub fn closed_form(&self, speed: f64) -> Result<Impact, ImpactError> {
        self.impact(
            speed,
            &Solver { method: Method::ClosedForm, tolerance: TRACE_TOLERANCE, ..Solver::default() },
            None,
        )
    }

    /// The results of an impact for a row of a table, computed by this solver.
    ///
    /// # Errors
    /// [`ImpactError`] if the result leaves double precision, the law has no answer, the integrator fails, or the method is not
    /// possible.
    #[inline]
    pub fn row(&self, approach: impl Into<Approach>, solver: &Solver) -> Result<ImpactRow, ImpactError> {
        let approach = approach.into();
        match self.contact_at_speed(approach.normal)? {
            None => self.row_at(approach, solver),
            Some(rated) => rated.row_at(approach, solver),
        }
    }

    #[inline]
    fn row_at(&self, approach: Approach, solver: &Solver) -> Result<ImpactRow, ImpactError> {
        let case = self.scaled_impact(None, approach.normal)?;
        let outcome = match self.resolve_solver(solver, false)?.method {
            Method::ClosedForm => case.closed_form_outcome(solver.tolerance)?,
            _ => None,
        };
        let outcome = match outcome {
            Some(outcome) => outcome,
            None => solve(case.ground, case.q, &case.forces, None, solver, None)?.outcome,
        };
        case.ground.check(&outcome.unloading)?;
        let mut row = ImpactRow::new(self, approach.normal, &case, &outcome)?;
        if let Some(inclined) = ObliqueImpact::new(self, &case, &outcome, approach)? {
            row.rebound = Some(inclined.rebound(&inclined.slip_result(false)?)?);
        }
        Ok(row)
    }

    /// The solver with the method that computes an impact of this contact.
    #[inline]
    pub(super) fn resolve_solver(&self, solver: &Solver, has_trace: bool) -> Result<Solver, ImpactError> {
        let method = solver.method.resolve(self.forces(), has_trace).ok_or(ImpactError::NoClosedForm)?;
        Ok(Solver { method, ..*solver })
    }

    /// Computes one impact at a speed \[m/s\], or an [`Approach`]; with `samples`, with a trace of that many evenly
    /// spaced rows (first contact and separation among them) and a row for every other event.
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
        let rated = self.contact_at_speed(approach.normal)?;
        rated.as_ref().unwrap_or(self).impact_on_surface(None, approach, solver, samples).map(|(impact, ..)| impact)
    }
}
