//! The stepper of rk8 for motions with drag: Dormand-Prince 8(5,3) on regularised variables, landed on every event. Straight
//! pieces need no steps during loading if the drag is linear: see `damped_oscillator.rs`.
//!
//! **Landing.** Speed and acceleration at the start of a step predict the end of the leg. A step that would reach it is made a little
//! longer. If a step has passed an event, the event is located on the dense output of the step, which costs three evaluations.
//! If the event is near the end of the step, its state is taken from the dense output, whose error vanishes at both ends of the
//! step with the square of the distance. If the event is well inside, the step is repeated with an end a little beyond the event.

use super::damped_oscillator::DampedOscillator;
use super::dop853::{self, ContinuousExtension, DENSE_OUTPUT_EVALUATIONS, EVALUATIONS};
use super::equations::linear::DampedLinearEquation;
use super::equations::power::DampedHertzEquation;
use super::equations::{DampedEquation, DampedPieceEquation, DampedState};
use super::event::{DenseStep, LocatedEnd, is_past_force_maximum};
use super::{
    DampingCoefficients, DenseOutput, IntegrationError, Integrator, LegEnd, LegProblem, LegResult, MAX_STEPS,
    MotionState, SolverStats,
};
use crate::numerics::curve::piece::Shape;
use crate::numerics::functions::pow;
use crate::numerics::root::newton_bisection;

/// The fraction of the tolerance that is the error limit of one step. The energy error of a whole impact is then at most ten times
/// the tolerance.
const STEP_TOLERANCE_SHARE: f64 = 0.05;

/// The first step on a leg is this times tolerance^(1/8) in units of 1/ω.
const FIRST_STEP: f64 = 2.0;

/// The longest step of the rebound under gravity, in units of 1/ω: half an oscillation takes π.
const MAX_STEP: f64 = 2.0;

/// A step to the predicted end of a leg is longer by this factor.
const OVERSHOOT: f64 = 1.005;
/// Below this θ (0 ≤ θ ≤ 1) the dense output may have a larger error than the step.
pub(super) const RESTEP_BELOW_THETA: f64 = 0.98;
/// The maximum number of repetitions of the step to an event.
pub(super) const MAX_RESTEPS: u32 = 3;

/// The least share of the error of order 5 that counts as the error of a step.
///
/// The pair estimates the error by e5²/e3, which assumes that both errors have the same leading terms. Near r = 0 this does
/// not hold: a weak pull or drag enters with a low power of r, which order 3 misses, and the force with the ninth power,
/// which both miss. This share goes with the square of the step, as e5²/e3 does on a smooth motion, so that the steps
/// of smooth motions stay as they are.
fn min_error_share(tolerance: f64) -> f64 {
    2.0 * (STEP_TOLERANCE_SHARE * tolerance).sqrt().sqrt()
}

#[derive(Debug, Clone)]
pub struct DampedStepper {
    tolerance: f64,
    work: SolverStats,
}

impl DampedStepper {
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, work: SolverStats::default() }
    }

    /// Along a piece in its own variables.
    pub(super) fn integrate_piece<P: DampedEquation>(
        &mut self,
        piece: P,
        path: &LegProblem,
        state: &mut MotionState,
        mut track: Option<&mut Vec<DenseOutput>>,
    ) -> Result<LegResult, IntegrationError> {
        let sign = path.leg.direction();
        let end = P::y_at(path.leg.end());
        let begun = *state;
        self.work.force_evaluations += 1;
        if let Some(arrival) = path.immediate_turn(state) {
            return Ok(arrival);
        }
        let size = P::y_at(path.error_scales.distance);
        let speed = path.error_scales.speed;
        let inverse_sizes =
            [size, speed, speed * speed].map(|size| 1.0 / (STEP_TOLERANCE_SHARE * self.tolerance * size));
        let least = min_error_share(self.tolerance);
        let mut node = [P::y_at(begun.distance), begun.speed, begun.time, begun.loss];
        let mut rates = piece.rates(node[0], node[1]);
        // the error control may still shrink the first step; on a short leg the force may be too weak to limit it
        let far = if sign > 0.0 { end.min(size.max(node[0])) } else { node[0] };
        let mut h = FIRST_STEP * pow(self.tolerance, 0.125) / P::frequency(path, far);
        if node[1] > 0.0 && far > node[0] && end.is_infinite() {
            h = h.min((far - node[0]) / node[1]);
        }
        // where the pull nearly balances the force, a swing may be smaller than the error of a step, and no step may pass it whole
        let longest = if path.constant_acceleration > 0.0 && sign < 0.0 {
            MAX_STEP / P::frequency(path, node[0])
        } else {
            f64::INFINITY
        };
        let mut largest = f64::NEG_INFINITY;
        // without drag in the contact, its force is largest at an end of the leg
        let mut is_falling = sign < 0.0 || !path.drag.acts_in_contact() || is_past_force_maximum::<P>(path, &node);
        let most = self.work.steps + self.work.rejected + MAX_STEPS;
        let mut rounds = 0;
        loop {
            if self.work.steps + self.work.rejected >= most {
                return Err(too_many_steps_error(path));
            }
            let last = step_to_distance(sign * (end - node[0]), sign * rates[0], sign * rates[1]);
            // no tiny step for the end
            let is_half = h < last && 2.0 * h > last && rounds == 0;
            h = if is_half { 0.5 * last } else { h.min(last) };
            let next = dop853::step(piece, &node, &rates, h, &inverse_sizes);
            self.work.force_evaluations += EVALUATIONS;
            let error = next.error(h, least);
            let pace = 0.9 * pow(error, -0.125);
            // NaN where a stage left the range of a formula: a shorter step may stay inside
            if error > 1.0 || error.is_nan() {
                h = self.reject_step(h * pace.max(0.2), &node, &rates)?;
                continue;
            }
            let mut solved: Option<ContinuousExtension> = None;
            let solve = || next.dense_output(piece, &node, h);
            let mut landed = None;
            if may_contain_event::<P>(path, end, &node, &next.node) {
                let solution = *solved.get_or_insert_with(solve);
                landed = DenseStep { path, end, solution }.locate_end::<P>();
            }
            // an event well inside of the step is located again, on a step that ends a little behind it
            if let Some(LocatedEnd { theta, .. }) = landed
                && theta < RESTEP_BELOW_THETA
                && rounds < MAX_RESTEPS
            {
                rounds += 1;
                self.work.force_evaluations += DENSE_OUTPUT_EVALUATIONS;
                h = overshooting_step(h * theta);
                continue;
            }
            if landed.is_some_and(|landed| is_spurious_turning_point(piece, path, &landed)) {
                self.work.force_evaluations += DENSE_OUTPUT_EVALUATIONS;
                self.work.rejected += 1;
                h *= 0.5;
                continue;
            }
            (self.work.steps, rounds) = (self.work.steps + 1, 0);
            let to = landed.map_or(next.node, |landed| landed.node);
            if !is_falling && is_past_force_maximum::<P>(path, &to) {
                is_falling = true;
                let limit = landed.map_or(1.0, |landed| landed.theta);
                let solution = *solved.get_or_insert_with(solve);
                largest = DenseStep { path, end, solution }.max_contact_force::<P>(limit);
            }
            self.work.force_evaluations += if solved.is_some() { DENSE_OUTPUT_EVALUATIONS } else { 0 };
            if let Some(track) = track.as_deref_mut() {
                track.push(dense_output(solved.unwrap_or_else(solve), to[2], P::distance_at));
            }
            if let Some(LocatedEnd { landing, .. }) = landed {
                let at = MotionState { time: to[2], distance: P::distance_at(to[0]), speed: to[1], loss: to[3] };
                return Ok(path.finish(landing, at, state, largest));
            }
            (node, rates) = (next.node, next.rates);
            h = (h * pace.min(5.0)).min(longest);
        }
    }

    /// Notes a rejected step; `h` is the length of the next one, which has to move something.
    fn reject_step(&mut self, h: f64, node: &DampedState, rates: &DampedState) -> Result<f64, IntegrationError> {
        self.work.rejected += 1;
        let time = node[2];
        match () {
            () if !rates.iter().all(|rate| rate.is_finite()) => Err(IntegrationError::NotFinite { time }),
            () if node.iter().zip(rates).all(|(part, rate)| part + h * rate == *part) => {
                Err(IntegrationError::StepUnderflow { time, step: h })
            }
            () => Ok(h),
        }
    }

    /// Along any piece. On curves that begin without force r = d^(1/M): M = 4 where the drag goes with the stiffness, else 2.
    fn with_regularised_variable<const M: u8>(
        &mut self,
        path: &LegProblem,
        state: &mut MotionState,
        track: Option<&mut Vec<DenseOutput>>,
    ) -> Result<LegResult, IntegrationError> {
        let c = path.factor;
        match path.piece.shape {
            Shape::Linear { slope, .. } => {
                let piece = DampedLinearEquation::from_leg(c * path.piece.force, c * slope, path);
                let Some(closed) = DampedOscillator::try_new(&piece, path.leg, *state) else {
                    return self.integrate_piece(piece, path, state, track);
                };
                self.work = self.work + SolverStats { steps: 1, rejected: 0, force_evaluations: 1 };
                Ok(closed.finish_leg(path, state, track))
            }
            Shape::Power { stiffness, exponent: 1.5, .. } => {
                self.integrate_piece(DampedHertzEquation::<M>::from_leg(c * stiffness, path), path, state, track)
            }
            Shape::Polynomial(_) => self.integrate_piece(DampedPieceEquation::<1>(*path), path, state, track),
            Shape::Power { .. } | Shape::Unloading(_) => {
                self.integrate_piece(DampedPieceEquation::<M>(*path), path, state, track)
            }
        }
    }
}

/// Why a leg did not end.
pub(super) fn too_many_steps_error(path: &LegProblem) -> IntegrationError {
    let steps = MAX_STEPS;
    if path.drag == DampingCoefficients::NONE {
        IntegrationError::TooManySteps { steps }
    } else {
        IntegrationError::Creeping { steps }
    }
}

/// A step that ends a little behind this one.
pub(super) fn overshooting_step(step: f64) -> f64 {
    OVERSHOOT * step
}

/// True if a sphere at rest at this state would be pushed on in the direction of the leg. Under strong drag the creep may be
/// slower than the error of a loose tolerance, so that a step ends with a speed of the wrong sign.
pub(super) fn is_spurious_turning_point<P: DampedEquation>(motion: P, path: &LegProblem, landed: &LocatedEnd) -> bool {
    let (LocatedEnd { landing, node, .. }, sign) = (landed, path.leg.direction());
    let is_turn = *landing == LegEnd::Turning || *landing == LegEnd::PieceEnd && sign * node[1] <= 0.0;
    is_turn && sign * motion.rates(node[0], 0.0)[1] > 0.0
}

/// The step that goes a little beyond this distance, for a speed and its rate of change; infinite if they do not lead there.
pub(super) fn step_to_distance(distance: f64, speed: f64, rate: f64) -> f64 {
    let square = speed * speed + 2.0 * rate * distance;
    let pace = speed + square.sqrt();
    if distance > 0.0 && distance.is_finite() && square >= 0.0 && pace > 0.0 {
        overshooting_step(2.0 * distance / pace)
    } else {
        f64::INFINITY
    }
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
pub(super) fn dense_output(solution: ContinuousExtension, end: f64, distance_at: fn(f64) -> f64) -> DenseOutput {
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

impl Integrator for DampedStepper {
    fn integrate_leg(
        &mut self,
        path: &LegProblem,
        state: &mut MotionState,
        track: Option<&mut Vec<DenseOutput>>,
    ) -> Result<LegResult, IntegrationError> {
        if path.drag.viscous == 0.0 {
            self.with_regularised_variable::<2>(path, state, track)
        } else {
            self.with_regularised_variable::<4>(path, state, track)
        }
    }

    fn stats(&self) -> SolverStats {
        self.work
    }
}
