//! The impacts of a contact: results of one, rows of tables.

use std::sync::LazyLock;

use super::case::Case;
use super::contact::Contact;
use super::error::ImpactError;
use super::essentials::Essentials;
use super::oblique::{Approach, Inclined};
use super::outcome::{Computed, Outcome};
use super::record::Recorder;
use super::result::Impact;
use super::solve::{Method, Solver, run};
use super::{closed_form, validity};
use crate::law::{ElasticApproach, Law};

impl Case<'_> {
    fn exact(&self) -> Option<Outcome> {
        closed_form::solve_with(self.law, self.q, &self.forces)
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

    /// What a table holds of an impact by [`Method::Auto`], without the rest of an [`Impact`]: of the closed form, or by
    /// rk8 at the default tolerance where there is none, and with damping.
    ///
    /// # Errors
    /// [`ImpactError`] where the result leaves double precision, the law has no answer, or the integrator gives up.
    #[inline]
    pub fn essentials(&self, approach: impl Into<Approach>) -> Result<Essentials, ImpactError> {
        let approach = approach.into();
        if self.forces().is_none() {
            return self.essentials_of_law(approach);
        }
        self.essentials_by(approach, &Solver { method: Method::Auto, ..Solver::default() })
    }

    /// What a table holds of an impact by this solver.
    ///
    /// # Errors
    /// [`ImpactError`] where the result leaves double precision, the law has no answer, the integrator gives up, or the
    /// method does not fit.
    pub fn essentials_by(&self, approach: impl Into<Approach>, solver: &Solver) -> Result<Essentials, ImpactError> {
        let approach = approach.into();
        if self.forces().is_none() && matches!(solver.method, Method::Auto | Method::ClosedForm) {
            return self.essentials_of_law(approach);
        }
        let case = self.case(None, approach.components()[0])?;
        // the closed form is the result, or its duration is what the fixed step divides
        let needs_exact = match solver.method {
            Method::Auto => case.forces.is_conservative(),
            method => matches!(method, Method::ClosedForm | Method::Verlet),
        };
        let exact = if needs_exact { case.exact() } else { None };
        if exact.is_none() && solver.method == Method::ClosedForm {
            return Err(ImpactError::NoClosedForm);
        }
        let Computed { outcome, .. } = run(case.law, case.q, &case.forces, exact.as_ref(), solver, None)?;
        self.essentials_of(approach, &case, &outcome)
    }

    /// e alone, with the same bits as from [`Contact::essentials`]. Without gravity and damping no times are computed, which
    /// takes half as long; a contact time outside double precision is then no error.
    ///
    /// # Errors
    /// As there.
    pub fn restitution(&self, approach: impl Into<Approach>) -> Result<f64, ImpactError> {
        let [speed, _] = approach.into().components();
        if !self.forces().is_none() {
            return Ok(self.essentials(speed)?.restitution);
        }
        let case = self.case(None, speed)?;
        let (unloading, restitution) = closed_form::energy_balance(case.law, case.q);
        case.law.accept(&unloading.peak)?;
        Ok(restitution)
    }

    #[inline]
    fn essentials_of_law(&self, approach: Approach) -> Result<Essentials, ImpactError> {
        // in its own scales every elastic impact is the same
        static ELASTIC: LazyLock<Outcome> = LazyLock::new(|| closed_form::solve(&Law::hertz(), 1.0));
        let case = self.case(None, approach.components()[0])?;
        let outcome = match case.law.elastic {
            ElasticApproach::All if case.q == 1.0 => *ELASTIC,
            _ => closed_form::solve(case.law, case.q),
        };
        self.essentials_of(approach, &case, &outcome)
    }

    /// What a table holds of this outcome.
    #[inline]
    fn essentials_of(&self, approach: Approach, case: &Case, outcome: &Outcome) -> Result<Essentials, ImpactError> {
        case.law.accept(&outcome.unloading.peak)?;
        let mut essentials = Essentials::new(self, approach.components()[0], case, outcome)?;
        if let Some(inclined) = Inclined::new(self, case, outcome, approach) {
            essentials.rebound = Some(inclined.rebound(inclined.ratio()?)?);
        }
        Ok(essentials)
    }

    /// Whether [`Method::Auto`] integrates rows of tables: with damping, on a plate, and under gravity where the law is
    /// neither powers nor straight lines. Elsewhere it takes the closed form.
    pub(crate) fn auto_integrates(&self) -> bool {
        let is_open = || self.yielding.as_ref().is_some_and(|(_, law)| !closed_form::closes(law));
        self.forces().have_drag() || self.forces().gravity.is_some() && is_open()
    }

    /// Checks that double precision holds the results of an impact at a speed \[m/s\]. With damping or on a plate, the impact
    /// without is checked instead, which is deeper.
    ///
    /// # Errors
    /// [`ImpactError`], see [`Contact::scaled`].
    pub fn holds(&self, approach: impl Into<Approach>) -> Result<(), ImpactError> {
        let speed = approach.into().components()[0];
        let case = self.case(None, speed)?;
        let is_damped = self.forces().have_drag();
        let forces = case.forces.without_drag();
        if let Some(outcome) = closed_form::solve_with(case.law, case.q, &forces) {
            match self.essentials_of(speed.into(), &case, &outcome) {
                // with damping the peak is shallower, and the law may have an answer there
                Err(ImpactError::Law(_)) if is_damped => {}
                row => drop(row?),
            }
        }
        Ok(())
    }

    /// Integrates one impact at a speed \[m/s\], or an [`Approach`]; with `samples`, records a trace of that many evenly
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
        let approach = approach.into();
        let speed = approach.components()[0];
        let case = self.case(None, speed)?;
        let (mut impact, outcome) = self.impact_of(&case, speed, solver, samples)?;
        if let Some(inclined) = Inclined::new(self, &case, &outcome, approach) {
            impact.add_friction(&inclined, approach)?;
            impact.warnings.extend(validity::of_oblique(self, &impact, approach));
        }
        Ok(impact)
    }

    /// The same of a case at that speed, with its dimensionless outcome.
    pub(super) fn impact_of(
        &self,
        case: &Case,
        speed: f64,
        solver: &Solver,
        samples: Option<usize>,
    ) -> Result<(Impact, Outcome), ImpactError> {
        let Case { law, q, forces, .. } = case;
        let exact = case.exact();
        let method = solver.method.chosen(forces, exact.is_some(), samples.is_some());
        let solver = Solver { method, ..*solver };
        if method == Method::ClosedForm && (exact.is_none() || samples.is_some() && !forces.is_none()) {
            return Err(ImpactError::NoClosedForm);
        }
        if let Some(exact) = exact.as_ref().filter(|_| forces.is_none()) {
            law.accept(&exact.unloading.peak)?;
        }
        let duration = exact.as_ref().filter(|_| forces.is_none()).map(|exact| exact.contact_time);
        let mut recorder = samples.map(|samples| Recorder::new(samples, duration));
        let computed = run(law, *q, forces, exact.as_ref(), &solver, recorder.as_mut())?;
        let peak = &computed.outcome.unloading.peak;
        if !forces.is_none() {
            law.accept(peak)?;
        }
        let points = recorder.map_or_else(Vec::new, |recorder| recorder.points);
        let mut impact = Impact::new(self, speed, case, method, &computed, exact.as_ref(), &points)?;
        impact.warnings = validity::warnings(self, &impact, law, peak, &solver);
        Ok((impact, computed.outcome))
    }
}
