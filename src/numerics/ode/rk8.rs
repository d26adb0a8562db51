//! Our own integrator. Without drag: adaptive Runge-Kutta-Nyström of order 8 on regularised variables, landed on the end of
//! every piece. The stepper of [`super::damped_stepper`], with the same variables and error control, does the other legs: legs with
//! drag, legs under gravity on curves other than powers and straight lines, and rebound legs that do not end at the zero of
//! the force.
//!
//! **Landing.** Before a step its landing is predicted: energy gives the speed where the leg will end, and the two-point
//! Taylor formula Δy = h/2 (u_1 + u_2) + h²/12 (g_1 − g_2), exact to h⁵, gives the h that ends there. If that is no longer
//! than the controlled step, it is the last one. The miss, of order h⁵, is corrected by the Taylor series at the end. This
//! needs no root finder and repeats no step, and the distance (or the speed, at a turning point) of the landed state is
//! exact. Energy is used only to predict; the state comes from the integration.
//!
//! **Step size.** An error estimate of order h⁷ held at `tolerance`^(7/8) keeps h proportional to `tolerance`^(1/8), so the
//! error of the propagated order 8 falls in proportion to the tolerance.
//!
//! **Why it is fast.** On every piece the motion without drag is a Nyström problem, y'' = g(y). In s = √δ and
//! dσ = dt/(2s) Hertz's law becomes s'' = −2k s⁴, a polynomial. So a step of the Nyström pair (see `nystrom.rs`) takes eight
//! evaluations and one stage sum, where Dormand-Prince 8(5,3) takes twelve and three. No stage divides. Traces use a
//! polynomial of degree 9 through derivatives that are known, at no extra evaluation.
//!
//! **Choices.** The last step has no Hénon device (a switch of the independent variable), which costs a division in every
//! stage, and no Newton step on the prediction, because the correction suffices. The step control takes 8th roots by a shift of
//! the bits of the exponent, which is exact to 4 %. Every piece begins with a step from the frequency of the piece, which is
//! rejected less often than the step of the piece before. Impacts do not share SIMD lanes: tables of undamped impacts have
//! closed forms, and damped impacts would gain less than a factor of two.

use super::damped_stepper::DampedStepper;
use super::dense_output::dense_output;
use super::equations::NystromEquation;
use super::equations::general::{PolynomialEquation, SqrtBranchEquation};
use super::equations::linear::LinearEquation;
use super::equations::power::PowerEquation;
use super::landing::{NystromState, PredictedEnd};
use super::nystrom::{self, EVALUATIONS};
use super::{
    DampingCoefficients, DenseOutput, IntegrationError, Integrator, Leg, LegEnd, LegProblem, LegResult, MAX_STEPS,
    MotionState, SolverStats,
};
use crate::numerics::curve::piece::Shape;
use crate::numerics::functions::pow;

#[derive(Debug, Clone)]
pub struct Rk8 {
    tolerance: f64,
    /// The limit of the error estimate: tolerance^(7/8).
    estimate_limit: f64,
    /// First step in units of 1/ω.
    first_step: f64,
    work: SolverStats,
    damped: DampedStepper,
}

/// FIRST_STEP × tolerance^(1/8) / ω is about the step that the error control settles on for an oscillator of frequency ω.
const FIRST_STEP: f64 = 4.0;

impl Rk8 {
    pub fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            estimate_limit: pow(tolerance, 0.875),
            first_step: FIRST_STEP * pow(tolerance, 0.125),
            work: SolverStats::default(),
            damped: DampedStepper::new(tolerance),
        }
    }

    /// Integrates a leg without drag, with or without a pull; `None` if the leg is left to the stepper with drag.
    #[inline(always)]
    fn integrate_undamped<const PULLED: bool>(
        &mut self,
        path: &LegProblem,
        state: &mut MotionState,
        track: Option<&mut Vec<DenseOutput>>,
    ) -> Option<Result<LegResult, IntegrationError>> {
        macro_rules! traverse {
            ($field:expr) => {{
                let field = $field;
                (!PULLED || returns_to_zero_force(field, path, state))
                    .then(|| self.integrate_equation(field, path, state, track))
            }};
        }
        let c = path.factor;
        match &path.piece.shape {
            Shape::Linear { slope, .. } => {
                traverse!(LinearEquation::<PULLED>::new(c * path.piece.force, c * slope, path.constant_acceleration))
            }
            Shape::Power { stiffness, exponent: 1.5, .. } => {
                traverse!(PowerEquation::<true, PULLED>::new(c * stiffness, 1.5, path.constant_acceleration))
            }
            Shape::Power { stiffness, exponent, .. } => {
                traverse!(PowerEquation::<false, PULLED>::new(c * stiffness, *exponent, path.constant_acceleration))
            }
            Shape::Polynomial(_) | Shape::Unloading(_) if PULLED => None,
            Shape::Polynomial(poly) => traverse!(PolynomialEquation { force: **poly, c }),
            Shape::Unloading(branch) => traverse!(SqrtBranchEquation { branch: *branch, c: 2.0 * c }),
        }
    }

    fn integrate_equation<F: NystromEquation>(
        &mut self,
        field: F,
        path: &LegProblem,
        state: &mut MotionState,
        mut track: Option<&mut Vec<DenseOutput>>,
    ) -> Result<LegResult, IntegrationError> {
        let (leg, mut now, mut h) = self.start_leg(field, path, state);
        self.work.force_evaluations += 1;
        for _ in 0..MAX_STEPS {
            let is_far = leg.target.max_advance(&now, h) < (leg.target.y - now.y).abs();
            let (this, last) = if is_far { (h, f64::INFINITY) } else { leg.target.controlled_step(&now, h) };
            let (mut next, error) = leg.step(field, &now, this);
            self.work.force_evaluations += EVALUATIONS;
            // NaN where a stage left the range of a formula: a shorter step may stay inside
            if error > 1.0 || error.is_nan() {
                self.work.rejected += 1;
                h = if error.is_nan() { 0.5 * this.abs() } else { next_step_size(this, error) };
                if !(now.u.is_finite() && now.g.is_finite() && h.is_finite()) {
                    return Err(IntegrationError::NotFinite { time: now.t });
                }
                if now.y + h * now.u == now.y && now.u + h * now.g == now.u {
                    return Err(IntegrationError::StepUnderflow { time: now.t, step: h });
                }
                continue;
            }
            self.work.steps += 1;
            let mut length = this;
            let mut landing = None;
            if last <= h {
                let landed = leg.target.land(field, &next);
                // while the net force still speeds the sphere up, a zero of the speed nearby lies in the past
                let is_turn = landed.landing == LegEnd::Turning;
                let is_behind = path.constant_acceleration > 0.0 && is_turn && next.g * leg.target.direction > 0.0;
                if landed.left_out_squared < leg.left_out_squared && !is_behind {
                    length += landed.correction;
                    next = NystromState { g: field.g(landed.node.y), ..landed.node };
                    landing = Some(landed.landing);
                }
            }
            if let Some(track) = track.as_deref_mut() {
                track.push(dense_output(field, now, next, length, state.loss));
            }
            now = next;
            if let Some(landing) = landing {
                let at = MotionState { time: now.t, distance: field.distance_at(now.y), speed: now.u, ..*state };
                return Ok(path.finish(landing, at, state, f64::NEG_INFINITY));
            }
            h = next_step_size(this, error);
        }
        Err(IntegrationError::TooManySteps { steps: MAX_STEPS })
    }

    /// The constants of a leg, its first node and its first step.
    #[inline(always)]
    fn start_leg<F: NystromEquation>(
        &self,
        field: F,
        path: &LegProblem,
        state: &MotionState,
    ) -> (LegConstants, NystromState, f64) {
        let y = field.y_at(state.distance);
        let node = NystromState { y, u: state.speed, g: field.g(y), t: state.time };
        let target = PredictedEnd::predict(field, path.leg, y, state.speed);
        let size = field.y_at(path.error_scales.distance);
        let inverse_y = 1.0 / (self.estimate_limit * size);
        let inverse_u = 1.0 / (self.estimate_limit * path.error_scales.speed);
        // −g' is largest at the far end during loading, at the start during the rebound
        let fastest = if matches!(path.leg, Leg::Unloading(_)) { y } else { target.y };
        let h = self.first_step / field.stiffness(fastest).sqrt();
        let left_out = 0.1 * self.tolerance * size;
        (LegConstants { target, inverse_y, inverse_u, left_out_squared: left_out * left_out }, node, h)
    }
}

#[derive(Debug, Clone, Copy)]
struct LegConstants {
    target: PredictedEnd,
    /// 1/(estimate limit × size of y).
    inverse_y: f64,
    inverse_u: f64,
    /// Limit of `Landed::left_out_squared`.
    left_out_squared: f64,
}

impl LegConstants {
    /// One step of length h: its end, and its error relative to the limit.
    #[inline(always)]
    fn step<F: NystromEquation>(&self, field: F, now: &NystromState, h: f64) -> (NystromState, f64) {
        let square = h * h;
        let scaled = field.scale_by(square);
        let step = nystrom::step(now.y, h * now.u, square * now.g, scaled);
        let inverse = 1.0 / h;
        let node = NystromState {
            y: step.position,
            u: step.velocity * inverse,
            g: step.acceleration * (inverse * inverse),
            t: now.t + field.duration(h, step.mean),
        };
        let of_y = step.position_error.abs() * self.inverse_y;
        let of_u = (step.velocity_error * inverse).abs() * self.inverse_u;
        (node, of_y.max(of_u))
    }
}

/// The next step after one with this error: × 0.9 error^(−1/8), at least × 0.2 and at most × 5.
#[inline(always)]
fn next_step_size(h: f64, error: f64) -> f64 {
    h.abs() * (inverse_eighth_root(error) * 0.9).clamp(0.2, 5.0)
}

/// x^(−1/8) to 4 %, x ≥ 0. The exponent bits of a double are its logarithm to base 2 and the rest of the bits interpolates
/// it, so the power is a shift and a subtraction. The next step has to wait for it, and `powf` takes as long as three stages.
#[inline(always)]
fn inverse_eighth_root(x: f64) -> f64 {
    /// (1 + 1/8) (1023 − 0.04) 2⁵²; 0.04 centres the interpolation error.
    const OFFSET: u64 = 0x47ed_47ae_147a_e000;
    f64::from_bits(OFFSET - (x.to_bits() >> 3))
}

/// True if the energy suffices for the sphere to come back to the zero of the force. Where just all of the energy is needed,
/// rounding may make this false.
fn returns_to_zero_force<F: NystromEquation>(field: F, path: &LegProblem, state: &MotionState) -> bool {
    /// A share of the depth of the potential.
    const MIN_ENERGY_SHARE: f64 = 1e-10;
    let y = field.y_at(state.distance);
    let energy = 0.5 * state.speed * state.speed + field.potential(y);
    path.leg != Leg::Unloading(0.0)
        || (state.speed == 0.0 && energy > MIN_ENERGY_SHARE * path.error_scales.speed * path.error_scales.speed)
}

impl Integrator for Rk8 {
    fn integrate_leg(
        &mut self,
        path: &LegProblem,
        state: &mut MotionState,
        mut track: Option<&mut Vec<DenseOutput>>,
    ) -> Result<LegResult, IntegrationError> {
        if path.drag == DampingCoefficients::NONE && matches!(path.leg, Leg::Loading(_) | Leg::Unloading(0.0)) {
            let landed = if path.constant_acceleration == 0.0 {
                self.integrate_undamped::<false>(path, state, track.as_deref_mut())
            } else {
                self.integrate_undamped::<true>(path, state, track.as_deref_mut())
            };
            if let Some(landed) = landed {
                return landed;
            }
        }
        self.damped.integrate_leg(path, state, track)
    }

    fn stats(&self) -> SolverStats {
        self.work + self.damped.stats()
    }
}
