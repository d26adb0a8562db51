//! The impacts of a contact: results of one, rows of tables.

use std::sync::LazyLock;

use super::case::{Case, hertz};
use super::contact::Contact;
use super::error::ImpactError;
use super::essentials::Essentials;
use super::oblique::{Approach, Inclined};
use super::outcome::Outcome;
use super::result::Impact;
use super::solve::{Method, Solver, run};
use super::{closed_form, validity};
use crate::law::{Law, Peak, Rule};

impl Case<'_> {
    /// The exact outcome, where there is one.
    #[inline]
    fn exact(&self) -> Option<Outcome> {
        // in its own scales every elastic impact is the same
        static ELASTIC: LazyLock<Outcome> = LazyLock::new(|| closed_form::solve(hertz(), 1.0));
        match self.law.rule {
            Rule::Elastic if self.q == 1.0 && self.forces.is_none() => Some(*ELASTIC),
            _ => closed_form::solve_with(self.law, self.q, &self.forces),
        }
    }
}

impl Contact {
    /// The exact outcome of an impact, without stepping.
    ///
    /// # Errors
    /// [`ImpactError::Range`], see [`Contact::scaled`]; [`ImpactError::NoClosedForm`] where damping leaves none.
    pub fn closed_form(&self, speed: f64) -> Result<Impact, ImpactError> {
        self.impact(speed, &Solver { method: Method::ClosedForm, ..Solver::default() }, None)
    }

    /// What a table holds of an impact by this solver, without the rest of an [`Impact`].
    ///
    /// # Errors
    /// [`ImpactError`] where the result leaves double precision, the law has no answer, the integrator gives up, or the
    /// method does not fit.
    #[inline]
    pub fn essentials(&self, approach: impl Into<Approach>, solver: &Solver) -> Result<Essentials, ImpactError> {
        let approach = approach.into();
        let [speed, _] = approach.components();
        let case = self.case(None, speed)?;
        // the closed form is the result, or its duration is what the fixed step divides
        let exact = match solver.method {
            Method::Auto if self.forces().have_drag() => None,
            Method::Auto | Method::ClosedForm | Method::Verlet => case.exact(),
            _ => None,
        };
        let method = self.chosen(solver.method, exact.as_ref(), false)?;
        let outcome = match exact {
            Some(exact) if method == Method::ClosedForm => exact,
            _ => run(case.law, case.q, &case.forces, exact.as_ref(), solver, None)?.outcome,
        };
        case.law.accept(&outcome.unloading.peak)?;
        let mut essentials = Essentials::new(self, speed, &case, &outcome)?;
        if let Some(inclined) = Inclined::new(self, &case, &outcome, approach) {
            essentials.rebound = Some(inclined.rebound(&inclined.slip(false)?)?);
        }
        Ok(essentials)
    }

    /// What computes an impact of which this is the closed form, if it has one.
    #[inline]
    fn chosen(&self, method: Method, exact: Option<&Outcome>, has_trace: bool) -> Result<Method, ImpactError> {
        method.chosen(self.forces(), || exact.is_some(), has_trace).ok_or(ImpactError::NoClosedForm)
    }

    /// e alone, with the same bits as from [`Contact::essentials`]. Without gravity and damping no times are computed, which
    /// takes half as long; a contact time outside double precision is then no error.
    pub fn restitution(&self, approach: impl Into<Approach>) -> Result<f64, ImpactError> {
        let [speed, _] = approach.into().components();
        if !self.forces().is_none() {
            return Ok(self.essentials(speed, &Solver::AUTO)?.restitution);
        }
        let case = self.case(None, speed)?;
        let (unloading, restitution) = closed_form::energy_balance(case.law, case.q);
        case.law.accept(&unloading.peak)?;
        Ok(restitution)
    }

    /// Whether an impact that yields has a closed form also under gravity or damping, as [`Method::chosen`] asks.
    pub(crate) fn closes(&self) -> bool {
        closed_form::closes(&self.law)
    }

    /// Computes one impact at a speed \[m/s\], or an [`Approach`]; with `samples`, with a trace of that many evenly
    /// spaced rows (first touch and separation among them) and a row for every other event.
    ///
    /// # Errors
    /// [`ImpactError`] where the result leaves double precision or the integrator gives up.
    pub fn impact(
        &self,
        approach: impl Into<Approach>,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<Impact, ImpactError> {
        self.impact_under(None, approach.into(), solver, samples).map(|(impact, ..)| impact)
    }

    /// The same with its law and peak. `spot` is the law of a spot that was loaded before.
    pub(super) fn impact_under<'a>(
        &'a self,
        spot: Option<&'a Law>,
        approach: Approach,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<(Impact, &'a Law, Peak), ImpactError> {
        let [speed, _] = approach.components();
        let case = self.case(spot, speed)?;
        let Case { law, q, forces, .. } = &case;
        let exact = case.exact();
        let method = self.chosen(solver.method, exact.as_ref(), samples.is_some())?;
        let solver = Solver { method, ..*solver };
        let computed = run(law, *q, forces, exact.as_ref(), &solver, samples)?;
        let peak = computed.outcome.unloading.peak;
        law.accept(&peak)?;
        let mut impact = Impact::new(self, speed, &case, method, &computed, exact.as_ref())?;
        impact.warnings = validity::warnings(self, &impact, law, &peak, &solver);
        if let Some(inclined) = Inclined::new(self, &case, &computed.outcome, approach) {
            impact.add_friction(&inclined, approach)?;
            impact.warnings.extend(validity::of_oblique(self, &impact, approach));
        }
        Ok((impact, law, peak))
    }
}
