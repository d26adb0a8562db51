//! The crate itself: one integration from one value of the independent variable to another.

use nalgebra::{DefaultAllocator, Dim, OVector, allocator::Allocator};
use ode_solvers::dop_shared::{IntegrationError as Failure, OutputType};
use ode_solvers::{Dop853, Dopri5, System};

use crate::numerics::integrate::{Effort, IntegrationError, MOST_STEPS};

/// Which of the crate's two adaptive methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scheme {
    /// Order 5(4).
    Dopri5,
    /// Order 8(5,3).
    Dop853,
}

/// `ode_solvers` with landing.
#[derive(Debug, Clone)]
pub struct Library {
    scheme: Scheme,
    pub(super) tolerance: f64,
    pub(super) work: Effort,
    /// Steps of the legs before this one.
    pub(super) taken_before_leg: u64,
}

/// A state in variables of size one: [t, d, u, loss], the time since the leg began.
pub(super) type Node = [f64; 4];

impl Library {
    /// An integrator with this relative tolerance.
    pub fn new(scheme: Scheme, tolerance: f64) -> Self {
        Self { scheme, tolerance, work: Effort::default(), taken_before_leg: 0 }
    }

    /// Carries `start` from `from` to `to`.
    pub(super) fn drive<S, D: Dim>(
        &mut self,
        equations: S,
        from: f64,
        to: f64,
        start: OVector<f64, D>,
    ) -> Result<OVector<f64, D>, IntegrationError>
    where
        S: System<f64, OVector<f64, D>>,
        DefaultAllocator: Allocator<D>,
    {
        /// Largest step in units of size one: no step may jump over a turning point (a quarter period is about 1.5).
        const LARGEST_STEP: f64 = 0.5;
        if from == to {
            return Ok(start);
        }
        // the steps of one leg, however many calls they come in
        let used = self.work.steps + self.work.rejected - self.taken_before_leg;
        let most_steps = u32::try_from(MOST_STEPS.saturating_sub(used)).unwrap_or(u32::MAX);
        if most_steps == 0 {
            return Err(IntegrationError::TooManySteps { steps: MOST_STEPS });
        }
        macro_rules! integrate {
            ($stepper:ident, $beta:expr, $shrink:expr, $grow:expr) => {{
                let mut stepper = $stepper::from_param(
                    equations,
                    from,
                    to,
                    to - from,
                    start,
                    self.tolerance,
                    self.tolerance,
                    0.9,
                    $beta,
                    $shrink,
                    $grow,
                    LARGEST_STEP,
                    0.0,
                    most_steps,
                    u32::MAX,
                    OutputType::Sparse,
                );
                (stepper.integrate(), stepper.y_out().last().cloned())
            }};
        }
        let (result, last) = match self.scheme {
            Scheme::Dopri5 => integrate!(Dopri5, 0.04, 0.2, 10.0),
            Scheme::Dop853 => integrate!(Dop853, 0.0, 0.333, 6.0),
        };
        let stats = result.map_err(|error| match error {
            Failure::MaxNumStepReached { .. } => IntegrationError::TooManySteps { steps: MOST_STEPS },
            Failure::StepSizeUnderflow { x } | Failure::StiffnessDetected { x } => {
                IntegrationError::StepUnderflow { time: x, step: 0.0 }
            }
        })?;
        self.work.force_evaluations += u64::from(stats.num_eval);
        self.work.steps += u64::from(stats.accepted_steps);
        self.work.rejected += u64::from(stats.rejected_steps);
        last.filter(|end| end.iter().all(|value| value.is_finite())).ok_or(IntegrationError::NotFinite { time: from })
    }
}
