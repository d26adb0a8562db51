//! The steps of a leg, whichever stepper makes them: each step is searched for the event that ends the leg and for the largest
//! contact force, and recorded for the trace.
//!
//! If a step has passed an event, the event is located on the dense output of the step. If the event is near the end of the step,
//! its state is taken from the dense output, whose error vanishes at both ends of the step with the square of the distance. If the
//! event is well inside, the step is repeated with an end a little beyond the event.

use super::dop853::ContinuousExtension;
use super::equations::{DampedEquation, DampedState};
use super::event::{DenseStep, LocatedEnd, is_past_force_maximum};
use super::{DenseOutput, LegEnd, LegProblem, LegResult, MotionState};
use crate::numerics::root::newton_bisection;

/// A step to the predicted end of a leg is longer by this factor.
const OVERSHOOT: f64 = 1.005;
/// Below this θ (0 ≤ θ ≤ 1) the dense output may have a larger error than the step.
const RESTEP_BELOW_THETA: f64 = 0.98;
/// The maximum number of repetitions of the step to an event.
const MAX_REPEATS: u32 = 3;

/// The consequence of a step for its leg.
pub(super) enum StepOutcome {
    /// The leg continues from the end of the step.
    Continues,
    /// The event that ends the leg is well inside of the step: the step is to be repeated with this fraction of its length.
    Overshoots { share: f64 },
    /// The step ends with a speed of the wrong sign because its error exceeds a slow creep. A shorter step is needed.
    TurnsFalsely,
    /// The step ends the leg.
    Ends(LegResult),
}

/// The accepted steps of a leg.
pub(super) struct LegSteps<'a> {
    path: &'a LegProblem<'a>,
    /// y where the leg ends.
    end: f64,
    /// The state at the start of the leg, and at its end when it has ended.
    state: &'a mut MotionState,
    track: Option<&'a mut Vec<DenseOutput>>,
    /// The largest contact force inside of the leg so far.
    largest_force: f64,
    is_past_maximum: bool,
    repeats: u32,
    /// Number of steps whose dense output was needed for events.
    pub dense_steps: u64,
}

impl<'a> LegSteps<'a> {
    /// A leg that begins at this node.
    pub fn begin<P: DampedEquation>(
        path: &'a LegProblem<'a>,
        node: &DampedState,
        state: &'a mut MotionState,
        track: Option<&'a mut Vec<DenseOutput>>,
    ) -> Self {
        // without drag in the contact, its force is largest at an end of the leg
        let is_past_maximum =
            path.leg.direction() < 0.0 || !path.drag.acts_in_contact() || is_past_force_maximum::<P>(path, node);
        let (end, largest_force) = (P::y_at(path.leg.end()), f64::NEG_INFINITY);
        Self { path, end, state, track, largest_force, is_past_maximum, repeats: 0, dense_steps: 0 }
    }

    /// True if the next step repeats one that overshot.
    pub fn is_repeating(&self) -> bool {
        self.repeats > 0
    }

    /// Searches the step between these nodes for events, and says how to continue. `solve` gives its dense output.
    pub fn judge_step<P: DampedEquation>(
        &mut self,
        motion: P,
        [from, to]: [&DampedState; 2],
        solve: impl Fn() -> ContinuousExtension,
    ) -> StepOutcome {
        let (path, end) = (self.path, self.end);
        let mut dense = None;
        let mut landed = None;
        if may_contain_event::<P>(path, end, from, to) {
            self.dense_steps += 1;
            landed = DenseStep { path, end, solution: *dense.get_or_insert_with(&solve) }.locate_end::<P>();
        }
        if let Some(landed) = &landed {
            if landed.theta < RESTEP_BELOW_THETA && self.repeats < MAX_REPEATS {
                self.repeats += 1;
                return StepOutcome::Overshoots { share: overshooting_step(landed.theta) };
            }
            if is_spurious_turning_point(motion, path, landed) {
                return StepOutcome::TurnsFalsely;
            }
        }
        self.repeats = 0;
        let node = landed.map_or(*to, |landed| landed.node);
        if !self.is_past_maximum && is_past_force_maximum::<P>(path, &node) {
            self.is_past_maximum = true;
            self.dense_steps += u64::from(dense.is_none());
            let step = DenseStep { path, end, solution: *dense.get_or_insert_with(&solve) };
            self.largest_force = step.max_contact_force::<P>(landed.map_or(1.0, |landed| landed.theta));
        }
        if let Some(track) = &mut self.track {
            track.push(dense_output(dense.unwrap_or_else(solve), node[2], P::distance_at));
        }
        let Some(LocatedEnd { landing, .. }) = landed else { return StepOutcome::Continues };
        let at = MotionState { time: node[2], distance: P::distance_at(node[0]), speed: node[1], loss: node[3] };
        StepOutcome::Ends(path.finish(landing, at, self.state, self.largest_force))
    }
}

/// A step that ends a little behind this one.
pub(super) fn overshooting_step(step: f64) -> f64 {
    OVERSHOOT * step
}

/// True if a sphere at rest at this state would be pushed on in the direction of the leg. Under strong drag the creep may be
/// slower than the error of a loose tolerance, so that a step ends with a speed of the wrong sign.
fn is_spurious_turning_point<P: DampedEquation>(motion: P, path: &LegProblem, landed: &LocatedEnd) -> bool {
    let (LocatedEnd { landing, node, .. }, sign) = (landed, path.leg.direction());
    let is_turn = *landing == LegEnd::Turning || *landing == LegEnd::PieceEnd && sign * node[1] <= 0.0;
    is_turn && sign * motion.rates(node[0], 0.0)[1] > 0.0
}

/// True if a step to this node may have passed an event.
#[inline]
pub(super) fn may_contain_event<P: DampedEquation>(
    path: &LegProblem,
    end: f64,
    from: &DampedState,
    to: &DampedState,
) -> bool {
    let sign = path.leg.direction();
    if sign * to[1] <= 0.0 || sign * (end - to[0]) <= 0.0 || path.is_at_rest(P::distance_at(to[0]), to[1]) {
        return true;
    }
    // under a pull the force may vanish and come again within the step
    let growth = |node: &DampedState| path.contact_force_rate(P::distance_at(node[0]), node[1]);
    let may_dip = || path.constant_acceleration > 0.0 && growth(from) < 0.0 && growth(to) > 0.0;
    path.can_lift_off() && (path.contact_force(P::distance_at(to[0]), to[1]) <= 0.0 || may_dip())
}

/// The continuous solution of a step as a function of the time.
fn dense_output(solution: ContinuousExtension, end: f64, distance_at: fn(f64) -> f64) -> DenseOutput {
    DenseOutput::new(end, move |time| {
        let miss = |theta| {
            let (at, rate) = solution.component(2, theta);
            (time - at, -rate)
        };
        let is_near = |last: f64, next: f64| (next - last).abs() <= f64::EPSILON;
        let theta = newton_bisection((0.0, 1.0), 1.0, is_near, miss);
        let [y, speed, _, loss] = solution.state_at(theta);
        MotionState { time, distance: distance_at(y), speed, loss }
    })
}
