//! The crate `ode_solvers` (Dormand-Prince 5(4) and 8(5,3)) behind [`Integrator`]: it takes every step of every leg, in plain
//! variables.
//!
//! The crate stops after the accepted step that passed an event, which is located as in `leg_steps.rs`. The crate does not expose its
//! stages. So the continuous solution of a step, for events and traces, uses the stages of our own Dormand-Prince 8(5,3), and
//! passes through both ends of the step of the crate.
//!
//! The crate takes one absolute tolerance for all components, so its variables are scaled to size one. In release 0.6.2 the
//! twelfth node of Dop853 is 0 instead of 1: the row sums of its tableau are right, but with an explicit independent variable
//! the order drops to 3. So nothing here depends on the independent variable explicitly.

use nalgebra::Vector3;
use ode_solvers::dop_shared::{IntegrationError as Failure, OutputType};
use ode_solvers::{Dop853, Dopri5, System};

use super::damped_stepper::{step_to_distance, too_many_steps_error};
use super::dop853::{self, ContinuousExtension};
use super::equations::{DampedEquation, DampedPieceEquation, DampedState};
use super::leg_steps::{LegSteps, StepOutcome, may_contain_event};
use super::{
    DenseOutput, ErrorScales, IntegrationError, Integrator, LegProblem, LegResult, MAX_STEPS, MotionState, SolverStats,
};

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
pub struct OdeSolvers {
    scheme: Scheme,
    tolerance: f64,
    work: SolverStats,
}

/// A piece in plain variables: y = d, u = d'.
type PlainVariables<'a> = DampedPieceEquation<'a, 1>;

/// The equations in variables of size one, y = (d, u, loss), up to the first step that passes an event.
struct LegSystem<'a> {
    path: &'a LegProblem<'a>,
    /// The node at which they begin, and those of the steps from there.
    nodes: &'a mut Vec<DampedState>,
}

impl System<f64, Vector3<f64>> for LegSystem<'_> {
    fn system(&self, _time: f64, y: &Vector3<f64>, dy: &mut Vector3<f64>) {
        let ErrorScales { distance, speed } = self.path.error_scales;
        let [_, acceleration, _, loss] = DampedPieceEquation::<1>(*self.path).rates(y[0] * distance, y[1] * speed);
        let unit = distance / (speed * speed);
        *dy = Vector3::new(y[1], acceleration * unit, loss * unit / speed);
    }

    fn solout(&mut self, time: f64, y: &Vector3<f64>, _dy: &Vector3<f64>) -> bool {
        let (begun, from) = match self.nodes.as_slice() {
            [begun, .., from] => (begun, from),
            [begun] => (begun, begun),
            [] => return true,
        };
        if time <= 0.0 {
            return false;
        }
        let ErrorScales { distance, speed } = self.path.error_scales;
        let to = [y[0] * distance, y[1] * speed, begun[2] + time * distance / speed, y[2] * speed * speed];
        let may_end = may_contain_event::<PlainVariables>(self.path, self.path.leg.end(), from, &to);
        self.nodes.push(to);
        may_end
    }
}

/// The time to a little behind the end of a short leg; `None` if it is long or the motion does not seem to lead there.
fn time_to_end(path: &LegProblem, from: &DampedState) -> Option<f64> {
    /// In units of size one. A longer step may be accepted by mistake where the force begins with a root.
    const SHORT_LEG: f64 = 0.1;
    let sign = path.leg.direction();
    let rate = DampedPieceEquation::<1>(*path).rates(from[0], from[1])[1];
    let time = step_to_distance(sign * (path.leg.end() - from[0]), sign * from[1], sign * rate);
    (time * path.error_scales.speed < SHORT_LEG * path.error_scales.distance).then_some(time)
}

/// The continuous solution of the step between two nodes.
fn dense_output_between(path: &LegProblem, from: &DampedState, to: &DampedState) -> ContinuousExtension {
    let motion = DampedPieceEquation::<1>(*path);
    let h = to[2] - from[2];
    let step = dop853::step(motion, from, &motion.rates(from[0], from[1]), h, &[1.0; 3]);
    step.with_end(*to, motion.rates(to[0], to[1])).dense_output(motion, from, h)
}

impl OdeSolvers {
    /// An integrator with this relative tolerance.
    pub fn new(scheme: Scheme, tolerance: f64) -> Self {
        Self { scheme, tolerance, work: SolverStats::default() }
    }

    /// The nodes from `start` on, up to the first one past an event, or for this time if it is given; `start` is the first.
    fn nodes(
        &mut self,
        path: &LegProblem,
        start: DampedState,
        time: Option<f64>,
    ) -> Result<Vec<DampedState>, IntegrationError> {
        /// Longer than [`MOST_STEPS`] of the largest steps, in units of size one.
        const MAX_TIME: f64 = 1e6;
        /// Largest step in units of size one: no step may jump over a turning point (a quarter period is about 1.5).
        const MAX_STEP: f64 = 0.5;
        /// The crate then chooses the first step.
        const AUTOMATIC_STEP: f64 = 0.0;
        let ErrorScales { distance, speed } = path.error_scales;
        let (until, first) =
            time.map_or((MAX_TIME, AUTOMATIC_STEP), |time| (time * speed / distance, time * speed / distance));
        let y = Vector3::new(start[0] / distance, start[1] / speed, start[3] / (speed * speed));
        let mut nodes = vec![start];
        macro_rules! integrate {
            ($stepper:ident, $beta:expr, $shrink:expr, $grow:expr) => {
                $stepper::from_param(
                    LegSystem { path, nodes: &mut nodes },
                    0.0,
                    until,
                    until,
                    y,
                    self.tolerance,
                    self.tolerance,
                    0.9,
                    $beta,
                    $shrink,
                    $grow,
                    MAX_STEP,
                    first,
                    u32::try_from(MAX_STEPS).unwrap_or(u32::MAX),
                    u32::MAX,
                    OutputType::Sparse,
                )
                .integrate()
            };
        }
        let result = match self.scheme {
            Scheme::Dopri5 => integrate!(Dopri5, 0.04, 0.2, 10.0),
            Scheme::Dop853 => integrate!(Dop853, 0.0, 0.333, 6.0),
        };
        let stats = result.map_err(|error| match error {
            Failure::MaxNumStepReached { .. } => too_many_steps_error(path),
            Failure::StepSizeUnderflow { x } | Failure::StiffnessDetected { x } => {
                IntegrationError::StepUnderflow { time: start[2] + x * distance / speed, step: 0.0 }
            }
        })?;
        let effort = SolverStats {
            steps: u64::from(stats.accepted_steps),
            rejected: u64::from(stats.rejected_steps),
            force_evaluations: u64::from(stats.num_eval),
        };
        self.work = self.work + effort;
        let is_finite = nodes.iter().flatten().all(|part| part.is_finite());
        if is_finite { Ok(nodes) } else { Err(IntegrationError::NotFinite { time: start[2] }) }
    }
}

impl Integrator for OdeSolvers {
    fn integrate_leg(
        &mut self,
        path: &LegProblem,
        state: &mut MotionState,
        track: Option<&mut Vec<DenseOutput>>,
    ) -> Result<LegResult, IntegrationError> {
        let begun = *state;
        if let Some(arrival) = path.immediate_turn(state) {
            return Ok(arrival);
        }
        let mut from = [begun.distance, begun.speed, begun.time, begun.loss];
        let most = self.work.steps + self.work.rejected + MAX_STEPS;
        let (mut again, motion) = (None, DampedPieceEquation::<1>(*path));
        let mut leg = LegSteps::begin::<PlainVariables>(path, &from, state, track);
        loop {
            if self.work.steps + self.work.rejected >= most {
                return Err(too_many_steps_error(path));
            }
            // a step to just behind the predicted end of a piece needs no second step
            let time = again.take().or_else(|| time_to_end(path, &from));
            for to in self.nodes(path, from, time)?.into_iter().skip(1) {
                let length = to[2] - from[2];
                match leg.judge_step(motion, [&from, &to], || dense_output_between(path, &from, &to)) {
                    StepOutcome::Continues => from = to,
                    StepOutcome::Ends(result) => return Ok(result),
                    StepOutcome::Overshoots { share } => again = Some(share * length),
                    StepOutcome::TurnsFalsely => again = Some(0.5 * length),
                }
                if again.is_some() {
                    break;
                }
            }
        }
    }

    fn stats(&self) -> SolverStats {
        self.work
    }
}
