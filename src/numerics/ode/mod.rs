//! Integrators for one smooth piece of motion, d'' = γ − g(d) − drag(d, d'), landed on its end.
//!
//! Nothing here knows bodies, laws or units. Of contact mechanics only this is used: a force grows along a piece, and drag
//! depends on that force or on its slope. A piece is a power law g = k d^n measured from its zero, a straight line, or any
//! other smooth force. A [`LegProblem`] is the way along a piece, with the pull γ and the drag that act there. An [`Integrator`]
//! carries a state to the end of the path: to a given distance, to zero speed, to zero contact force, or near to rest. The
//! state lands *on* the end, so that no step crosses a kink.

mod damped_oscillator;
pub mod damped_stepper;
mod dense_output;
mod dop853;
mod equations;
mod event;
mod landing;
mod leg;
mod leg_steps;
mod nystrom;
pub mod ode_solvers;
pub mod rk8;

use thiserror::Error;

pub use leg::{DampingCoefficients, ErrorScales, Leg, LegEnd, LegProblem, LegResult, MotionState, RestCriterion};

/// The cost of an integration.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SolverStats {
    pub steps: u64,
    pub rejected: u64,
    pub force_evaluations: u64,
}

impl std::ops::Add for SolverStats {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            steps: self.steps + other.steps,
            rejected: self.rejected + other.rejected,
            force_evaluations: self.force_evaluations + other.force_evaluations,
        }
    }
}

/// The maximum number of steps of a leg, accepted and rejected. More steps are needed only if the drag is hundreds of times the critical
/// drag. Explicit steps are then limited by the fast decay, and the creep lasts as long as the slow decay. The ratio of the two
/// times grows with the square of the drag.
pub(crate) const MAX_STEPS: u64 = 100_000;

/// Why an integration stopped. Times and steps are dimensionless.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum IntegrationError {
    /// The step became too small to advance.
    #[error("the integration failed (step size underflow). Increase solver.tolerance or use another method.")]
    StepUnderflow { time: f64, step: f64 },
    /// More steps than any impact needs.
    #[error(
        "the contact does not end within {steps} steps. Increase solver.tolerance, or use method = \"auto\" (closed form where there is one)."
    )]
    TooManySteps { steps: u64 },
    /// More steps of fixed length than any impact needs.
    #[error(
        "the contact does not end within {steps} fixed steps, because it lasts much longer than without damping. Use method = \"rk8\"."
    )]
    TooManyFixedSteps { steps: u64 },
    /// Fixed steps that are too long to follow the contact.
    #[error(
        "the fixed steps are too long for this contact: verlet needs only {steps} steps and finds a restitution of {restitution:.3}. Increase solver.steps_per_contact, or use another method than verlet."
    )]
    CoarseSteps {
        /// Steps in contact.
        steps: u64,
        /// e of the run.
        restitution: f64,
    },
    /// A strain rate that does not settle.
    #[error(
        "strain rate and strength do not converge within {rounds} iterations, because the strength rises too steeply with the strain rate. Reduce the strain-rate sensitivity."
    )]
    UnsettledRate { rounds: u64 },
    /// More steps of friction than any impact needs.
    #[error(
        "friction needs more than {steps} steps in this contact. Reduce the coefficient of friction, or remove angle and spin."
    )]
    TooManyFrictionSteps { steps: u64 },
    /// The damping is far above critical: the motion creeps, or its fast decay allows only tiny steps.
    #[error(
        "the contact does not end within {steps} steps, because the damping is too strong. Reduce the damping; check its unit."
    )]
    Creeping { steps: u64 },
    #[error("the state became infinite or not a number.")]
    NotFinite { time: f64 },
}

/// One step with its continuous solution: the state at any time of the step. Times are absolute, and distances are measured along the
/// leg.
pub struct DenseOutput {
    pub end: f64,
    at: Box<dyn Fn(f64) -> MotionState + Send + Sync>,
}

impl DenseOutput {
    pub(crate) fn new(end: f64, at: impl Fn(f64) -> MotionState + Send + Sync + 'static) -> Self {
        Self { end, at: Box::new(at) }
    }

    /// The state at a time of the step.
    pub fn state_at(&self, time: f64) -> MotionState {
        (self.at)(time)
    }
}

impl std::fmt::Debug for DenseOutput {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("DenseOutput").field("end", &self.end).finish_non_exhaustive()
    }
}

/// Carries a state along smooth pieces.
pub trait Integrator {
    /// Integrates from `state` to the end of the leg. `state` is then exactly at the end: its distance is the end, or its speed is zero.
    /// The dense output is appended to `track`. Dense output changes neither the steps nor the [`SolverStats`].
    ///
    /// # Errors
    /// [`IntegrationError`] if the step underflows, the steps run out, or the state is not finite.
    fn integrate_leg(
        &mut self,
        path: &LegProblem,
        state: &mut MotionState,
        track: Option<&mut Vec<DenseOutput>>,
    ) -> Result<LegResult, IntegrationError>;

    fn stats(&self) -> SolverStats;
}
