//! The stepper of rk8 for motions with drag: Dormand-Prince 8(5,3) on regularised variables, landed on every event. Straight
//! pieces need no steps during loading if the drag is linear: see `damped_oscillator.rs`.
//!
//! Speed and acceleration at the start of a step predict the end of the leg. A step that would reach it is made a little
//! longer; `leg_steps.rs` then lands on the event.

use super::damped_oscillator::DampedOscillator;
use super::dop853::{self, DENSE_OUTPUT_EVALUATIONS, EVALUATIONS};
use super::equations::linear::DampedLinearEquation;
use super::equations::power::DampedHertzEquation;
use super::equations::{DampedEquation, DampedPieceEquation, DampedState};
use super::leg_steps::{LegSteps, StepOutcome, overshooting_step};
use super::{
    DampingCoefficients, DenseOutput, IntegrationError, Integrator, LegProblem, LegResult, MAX_STEPS, MotionState,
    SolverStats,
};
use crate::numerics::curve::piece::Shape;
use crate::numerics::functions::pow;

/// The fraction of the tolerance that is the error limit of one step. The energy error of a whole impact is then at most ten times
/// the tolerance.
const STEP_TOLERANCE_SHARE: f64 = 0.05;

/// The first step on a leg is this times tolerance^(1/8) in units of 1/ω.
const FIRST_STEP: f64 = 2.0;

/// The longest step of the rebound under gravity, in units of 1/ω: half an oscillation takes π.
const MAX_STEP: f64 = 2.0;

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
        track: Option<&mut Vec<DenseOutput>>,
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
        let [mut h, longest] = self.step_lengths::<P>(path, &node, size);
        let most = self.work.steps + self.work.rejected + MAX_STEPS;
        let mut leg = LegSteps::begin::<P>(path, &node, state, track);
        loop {
            if self.work.steps + self.work.rejected >= most {
                return Err(too_many_steps_error(path));
            }
            let last = step_to_distance(sign * (end - node[0]), sign * rates[0], sign * rates[1]);
            // no tiny step for the end
            let is_half = h < last && 2.0 * h > last && !leg.is_repeating();
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
            match leg.judge_step(piece, [&node, &next.node], || next.dense_output(piece, &node, h)) {
                StepOutcome::Overshoots { share } => h *= share,
                StepOutcome::TurnsFalsely => {
                    self.work.rejected += 1;
                    h *= 0.5;
                }
                StepOutcome::Continues => {
                    self.work.steps += 1;
                    (node, rates) = (next.node, next.rates);
                    h = (h * pace.min(5.0)).min(longest);
                }
                StepOutcome::Ends(result) => {
                    self.work.steps += 1;
                    self.work.force_evaluations += DENSE_OUTPUT_EVALUATIONS * leg.dense_steps;
                    return Ok(result);
                }
            }
        }
    }

    /// The first step of a leg from this node, and the longest step; `size` is the size of y.
    fn step_lengths<P: DampedEquation>(&self, path: &LegProblem, node: &DampedState, size: f64) -> [f64; 2] {
        let (is_loading, end) = (path.leg.direction() > 0.0, P::y_at(path.leg.end()));
        // the error control may still shrink the first step; on a short leg the force may be too weak to limit it
        let far = if is_loading { end.min(size.max(node[0])) } else { node[0] };
        let first = FIRST_STEP * pow(self.tolerance, 0.125) / P::frequency(path, far);
        let reaches_far = node[1] > 0.0 && far > node[0] && end.is_infinite();
        let first = if reaches_far { first.min((far - node[0]) / node[1]) } else { first };
        // where the pull nearly balances the force, a swing may be smaller than the error of a step, and no step may pass it whole
        let may_balance = path.constant_acceleration > 0.0 && !is_loading;
        [first, if may_balance { MAX_STEP / P::frequency(path, node[0]) } else { f64::INFINITY }]
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
