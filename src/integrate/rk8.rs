//! Our own stepper: adaptive Runge-Kutta-Nyström of order 8 on regularised variables, landed on the end of every piece.
//!
//! **Variables.** On a power law d'' = −k d^n the force is not smooth at d = 0, which costs any method its order. With
//! s = √d and dσ = dt/(2 s)
//!
//! ```text
//! s' = u,   u' = −2 k s^(2n+1),   t' = 2 s        (' = d/dσ; u is the speed d' = dd/dt)
//! ```
//!
//! which for n = 3/2 is a polynomial and again of the form y'' = g(y). On a straight piece y = d and σ = t.
//!
//! **Landing.** Before a step its landing is predicted: energy gives the speed where the leg will end, and the two-point
//! Taylor formula Δy = h/2 (u_1 + u_2) + h²/10 (g_1 − g_2) + h³/120 (j_1 + j_2), exact to h⁷, gives the h that ends there.
//! If that is no longer than the controlled step, it is the last one. What it misses, order h⁷, is mended by the Taylor
//! series at the end: no root finder, no step thrown away, and the distance (or the speed, at a turning point) of the
//! landed state is exact. Prediction is all energy is used for; the state comes from the integration.
//!
//! **Step size.** An error estimate of order h⁷ held at `tolerance`^(7/8) keeps h proportional to `tolerance`^(1/8), so the
//! error of the propagated order 8 falls in proportion to the tolerance.

use super::dense::sample;
use super::field::{Field, Hertz, Power, Straight};
use super::landing::Target;
use super::nystrom::{self, EVALUATIONS};
use super::{IntegrationError, Integrator, Landing, Leg, Path, Restoring, Sampler, State, Work};

/// The stepper.
#[derive(Debug, Clone)]
pub struct Rk8 {
    tolerance: f64,
    /// What the error estimate is held at: tolerance^(7/8).
    estimate_limit: f64,
    /// First step in units of 1/ω.
    first_step: f64,
    work: Work,
}

/// A state on a piece in its own variables.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node {
    pub(super) y: f64,
    pub(super) u: f64,
    /// g(y).
    pub(super) g: f64,
    pub(super) t: f64,
}

/// FIRST_STEP × tolerance^(1/8) / ω is about the step that the error control settles on for an oscillator of frequency ω.
const FIRST_STEP: f64 = 4.0;

impl Rk8 {
    /// A stepper with this relative tolerance.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        Self {
            tolerance,
            estimate_limit: tolerance.powf(0.875),
            first_step: FIRST_STEP * tolerance.powf(0.125),
            work: Work::default(),
        }
    }

    fn traverse_field<F: Field>(
        &mut self,
        field: F,
        path: &Path,
        state: &mut State,
        mut samples: Option<&mut Sampler>,
    ) -> Result<Landing, IntegrationError> {
        const MOST_STEPS: u64 = 100_000;
        let y = field.y_at(state.distance);
        let mut now = Node { y, u: state.speed, g: field.g(y), t: state.time };
        self.work.force_evaluations += 1;
        let target = Target::predict(field, path.leg, &now);
        let size = field.y_at(path.sizes.distance);
        let inverse_y = 1.0 / (self.estimate_limit * size);
        let inverse_u = 1.0 / (self.estimate_limit * path.sizes.speed);
        // −g' is largest at the far end outward, at the start on the way back
        let fastest = if path.leg == Leg::Back { now.y } else { target.node.y };
        let mut h = self.first_step / (-field.derivatives(fastest).0).sqrt();
        for _ in 0..MOST_STEPS {
            let (this, is_last) = target.limit(field, &now, h);
            let square = this * this;
            let scaled = field.scaled(square);
            let step = nystrom::step(now.y, this * now.u, square * now.g, |y| scaled.g(y));
            let inverse_step = 1.0 / this;
            self.work.force_evaluations += EVALUATIONS;
            let error =
                (step.position_error.abs() * inverse_y).max((step.velocity_error * inverse_step).abs() * inverse_u);
            if error > 1.0 {
                self.work.rejected += 1;
                h = this * growth(error).max(0.2);
                continue;
            }
            if error.is_nan() {
                return Err(IntegrationError::NotFinite { time: now.t });
            }
            self.work.steps += 1;
            let duration = if F::IS_TIME { this } else { 2.0 * this * step.mean };
            let mut next = Node {
                y: step.position,
                u: step.velocity * inverse_step,
                g: step.acceleration * (inverse_step * inverse_step),
                t: now.t + duration,
            };
            let mut length = this;
            let landing =
                if is_last { target.land(field, &mut next, &mut length, self.tolerance * size) } else { None };
            if let Some(samples) = samples.as_deref_mut() {
                sample(field, samples, &now, &next, length);
            }
            now = next;
            if let Some(landing) = landing {
                let distance = match (landing, path.leg) {
                    (Landing::End, Leg::Outward(end)) => end,
                    (Landing::End, Leg::Back) => 0.0,
                    (Landing::Turning, _) => field.distance_at(now.y),
                };
                *state = State { time: now.t, distance, speed: now.u };
                return Ok(landing);
            }
            h = this.abs() * growth(error).min(5.0);
        }
        Err(IntegrationError::TooManySteps { steps: MOST_STEPS })
    }
}

/// Step-size factor for an error relative to its limit: 0.9 error^(−1/8), to 4 %. The exponent bits of a double are its
/// logarithm to base 2 and the rest of the bits interpolates it, so the power is a shift and a subtraction; the next step
/// waits for it, and `powf` takes as long as three stages.
#[inline(always)]
pub(super) fn growth(error: f64) -> f64 {
    /// (1 + 1/8) (1023 − 0.04) 2⁵²; 0.04 centres the interpolation error.
    const OFFSET: u64 = 0x47ed_47ae_147a_e000;
    0.9 * f64::from_bits(OFFSET - (error.to_bits() >> 3))
}

impl Integrator for Rk8 {
    fn traverse(
        &mut self,
        path: &Path,
        state: &mut State,
        samples: Option<&mut Sampler>,
    ) -> Result<Landing, IntegrationError> {
        match path.restoring {
            Restoring::Straight { at_start: a, slope: b } => {
                self.traverse_field(Straight { a, b }, path, state, samples)
            }
            Restoring::Power { coefficient, exponent: 1.5 } => {
                self.traverse_field(Hertz { c: 2.0 * coefficient }, path, state, samples)
            }
            Restoring::Power { coefficient, exponent } => {
                let field = Power { c: 2.0 * coefficient, p: 2.0 * exponent + 1.0 };
                self.traverse_field(field, path, state, samples)
            }
        }
    }

    fn work(&self) -> Work {
        self.work
    }
}
