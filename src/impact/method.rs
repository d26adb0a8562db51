//! How an impact is computed: the methods, what controls their error, and one dimensionless impact by any of them.

use super::course::{self, Recorder};
use super::outcome::Outcome;
use crate::integrate::exact::Exact;
use crate::integrate::ode_solvers::{self, OdeSolvers};
use crate::integrate::rk8::Rk8;
use crate::integrate::{IntegrationError, Integrator, Work};
use crate::law::Law;

/// How an impact is computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Method {
    /// The cheapest that is exact for the scene: closed form for results, rk8 for a trace. With damping, and under gravity on
    /// a law that is neither powers nor straight lines, there is no closed form that it takes: rk8 for all.
    Auto,
    /// Our adaptive Runge-Kutta-Nyström of order 8.
    Rk8,
    /// `ode_solvers` Dormand-Prince 5(4).
    Dopri5,
    /// `ode_solvers` Dormand-Prince 8(5,3).
    Dop853,
    /// Velocity Verlet with a fixed step, as DEM codes do.
    Verlet,
    /// Energy balance and exact times, no stepping.
    ClosedForm,
}

impl Method {
    /// Every method, with its name in scenarios and reports.
    pub const ALL: [(&'static str, Self); 6] = [
        ("auto", Self::Auto),
        ("rk8", Self::Rk8),
        ("dopri5", Self::Dopri5),
        ("dop853", Self::Dop853),
        ("verlet", Self::Verlet),
        ("closed_form", Self::ClosedForm),
    ];

    /// The method of this name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().find(|(known, _)| *known == name).map(|(_, method)| *method)
    }

    /// Its name in scenarios and reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, method)| *method == self).map_or("", |(name, _)| name)
    }
}

/// Method and what controls its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver {
    /// Which integrator.
    pub method: Method,
    /// Relative, on the dimensionless state; the fixed-step method does not use it.
    pub tolerance: f64,
    /// Steps of the fixed-step method over the exact contact time, ≥ 1; the others do not use it.
    pub steps_per_contact: u32,
}

impl Default for Solver {
    fn default() -> Self {
        Self { method: Method::Rk8, tolerance: 1e-10, steps_per_contact: 50 }
    }
}

/// One impact at q = v/V by any method, with its cost; `exact` is its closed form.
///
/// # Errors
/// [`IntegrationError`] of the method.
pub fn run(
    law: &Law,
    q: f64,
    exact: &Outcome,
    solver: &Solver,
    recorder: Option<&mut Recorder>,
) -> Result<(Outcome, Work), IntegrationError> {
    fn with<I: Integrator>(
        mut integrator: I,
        law: &Law,
        q: f64,
        recorder: Option<&mut Recorder>,
    ) -> Result<(Outcome, Work), IntegrationError> {
        let outcome = course::integrate(law, q, &mut integrator, recorder)?;
        Ok((outcome, integrator.work()))
    }
    let tolerance = solver.tolerance;
    match solver.method {
        Method::ClosedForm | Method::Auto if recorder.is_none() => Ok((*exact, Work::default())),
        Method::ClosedForm => with(Exact, law, q, recorder),
        Method::Rk8 | Method::Auto => with(Rk8::new(tolerance), law, q, recorder),
        Method::Dopri5 => with(OdeSolvers::new(ode_solvers::Method::Dopri5, tolerance), law, q, recorder),
        Method::Dop853 => with(OdeSolvers::new(ode_solvers::Method::Dop853, tolerance), law, q, recorder),
        Method::Verlet => {
            let mut work = Work::default();
            let step = exact.contact_time / f64::from(solver.steps_per_contact.max(1));
            // no contact lasts longer than a few times the exact one, however coarse the step
            let most = 10 * u64::from(solver.steps_per_contact.max(1)) + 10;
            let outcome = course::march_verlet(law, q, step, most, &mut work, recorder)?;
            Ok((outcome, work))
        }
    }
}
