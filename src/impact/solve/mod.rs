//! The methods that compute an impact, their error control, and one dimensionless impact by any of them.

pub mod closed_form;
pub mod fixed_steps;
pub mod motion;
pub mod outcome;
pub mod recorder;
mod verlet;

use super::problem::forces::{Forces, ScaledForces};
use outcome::{ScaledResult, Solution};
use recorder::{TraceRecorder, sample_times};

use crate::contact::law::Surface;
use crate::numerics::ode::ode_solvers::{OdeSolvers, Scheme};
use crate::numerics::ode::rk8::Rk8;
use crate::numerics::ode::{DampingCoefficients, IntegrationError, Integrator, SolverStats};
use crate::strings::names::named_enum;

named_enum! {
    #[derive(Hash)]
    pub enum Method {
        /// The cheapest exact method for the scene, see [`Method::resolve`].
        Auto = "auto",
        /// Our adaptive Runge-Kutta-Nyström of order 8.
        Rk8 = "rk8",
        /// `ode_solvers` Dormand-Prince 5(4), at a hundredth of the tolerance.
        Dopri5 = "dopri5",
        /// `ode_solvers` Dormand-Prince 8(5,3), at a 25th of the tolerance.
        Dop853 = "dop853",
        /// Velocity Verlet with a fixed step, as DEM codes do.
        Verlet = "verlet",
        /// Energy balance and exact times, no integration. Its trace is computed by rk8 at a tolerance of 1e-13, and under gravity its
        /// times by rk8 at the tolerance of the solver.
        ClosedForm = "closed_form",
    }
}

impl Method {
    /// The method that computes an impact under these forces. [`Method::Auto`] stands for the closed form if nothing damps the motion
    /// and no trace is requested, and otherwise for rk8. Every other method stands for itself. `None` for [`Method::ClosedForm`] if
    /// there is no closed form.
    pub fn resolve(self, forces: &Forces, has_trace: bool) -> Option<Self> {
        match self {
            Self::Auto if has_trace || forces.has_dissipation() => Some(Self::Rk8),
            Self::Auto => Some(Self::ClosedForm),
            Self::ClosedForm if forces.has_dissipation() => None,
            method => Some(method),
        }
    }
}

/// Method and error control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solver {
    pub method: Method,
    /// Relative, on the dimensionless state at the end; the fixed-step method does not use it.
    pub tolerance: f64,
    /// Steps of the fixed-step method over the contact time without damping, ≥ 1; other methods do not use it.
    pub steps_per_contact: u32,
}

impl Solver {
    /// The method that [`Method::Auto`] chooses, at the usual tolerance.
    pub const AUTO: Self = Self { method: Method::Auto, tolerance: 1e-10, steps_per_contact: 50 };
}

impl Default for Solver {
    fn default() -> Self {
        Self { method: Method::Rk8, ..Self::AUTO }
    }
}

/// Tolerance of the run that computes the trace of a closed form, or its times under gravity.
pub(super) const TRACE_TOLERANCE: f64 = 1e-13;

/// The contact time of an impact at q = v/V without damping, plate and rod.
pub(super) fn undamped_contact_time(ground: Surface, q: f64, forces: &ScaledForces) -> Result<f64, IntegrationError> {
    let exact = closed_form::solve_conservative(
        ground,
        q,
        &ScaledForces { damping: DampingCoefficients::NONE, ..*forces },
        Solver::AUTO.tolerance,
    )?;
    Ok(exact.map_or(f64::NAN, |exact| exact.contact_time))
}

/// The tolerance that a stepper gets if its error is to be below `tolerance`. The error of a stepper is up to `delivers` times its
/// own tolerance: 100 (dopri5) and 24 (dop853) in impacts with all forces, at tolerances from 1e-2 to 1e-11. rk8 needs no such
/// factor. Below 1e-14 rounding decides.
fn internal_tolerance(tolerance: f64, delivers: f64) -> f64 {
    (tolerance / delivers).max(1e-14)
}

/// An impact leg by leg. `trace` holds the number of samples over the contact time, and this time if it is known.
fn integrate_and_record<I: Integrator>(
    case: (Surface, f64, &ScaledForces),
    trace: Option<(usize, Option<f64>)>,
    mut integrator: I,
) -> Result<Solution, IntegrationError> {
    let (ground, q, forces) = case;
    let mut recorder = trace.map(|_| TraceRecorder::default());
    let outcome = motion::integrate(ground, q, forces, &mut integrator, recorder.as_mut())?;
    let mut solution = Solution::new(outcome, integrator.stats());
    if let (Some(recorder), Some((samples, duration))) = (recorder, trace) {
        let times = sample_times(samples, duration.unwrap_or(outcome.contact_time));
        solution.trace_points = recorder.into_points(ground, &outcome.unloading, forces.damping, times);
    }
    Ok(solution)
}

/// One impact at q = v/V by any method, with its cost; `exact` is its closed form, if it exists. [`Method::Auto`] means rk8 here, and
/// [`Method::ClosedForm`] means rk8 if there is no closed form. With `samples` the result has a trace of this number of points evenly
/// spaced over the contact, including first contact and separation, and a point for every other event.
pub fn solve<'a>(
    ground: impl Into<Surface<'a>>,
    q: f64,
    forces: &ScaledForces,
    exact: Option<&ScaledResult>,
    solver: &Solver,
    samples: Option<usize>,
) -> Result<Solution, IntegrationError> {
    let ground = ground.into();
    // equal times for every method, if the contact time is known
    let duration = exact.filter(|_| forces.is_none()).map(|exact| exact.contact_time);
    let (case, trace) = ((ground, q, forces), samples.map(|samples| (samples, duration)));
    let tolerance = solver.tolerance;
    match (solver.method, exact) {
        (Method::ClosedForm, Some(exact)) if samples.is_none() => Ok(Solution::new(*exact, SolverStats::default())),
        (Method::ClosedForm, Some(_)) => Ok(Solution {
            stats: SolverStats::default(),
            ..integrate_and_record(case, trace, Rk8::new(TRACE_TOLERANCE))?
        }),
        (Method::Rk8 | Method::Auto | Method::ClosedForm, _) => integrate_and_record(case, trace, Rk8::new(tolerance)),
        (Method::Dopri5, _) => {
            integrate_and_record(case, trace, OdeSolvers::new(Scheme::Dopri5, internal_tolerance(tolerance, 100.0)))
        }
        (Method::Dop853, _) => {
            integrate_and_record(case, trace, OdeSolvers::new(Scheme::Dop853, internal_tolerance(tolerance, 25.0)))
        }
        (Method::Verlet, _) => {
            let steps = solver.steps_per_contact.max(1);
            let step = undamped_contact_time(ground, q, forces)? / f64::from(steps);
            // even with a coarse step a contact lasts at most a few times the exact time, unless gravity or damping holds it
            let most = if forces.is_none() { 10 } else { 100 } * u64::from(steps) + 10;
            fixed_steps::integrate_fixed_steps(ground, q, forces, step, most, trace)
        }
    }
}
