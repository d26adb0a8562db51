//! Dense output of rk8: the polynomial of degree 9 with the right y and first four derivatives at both ends of a step.
//!
//! On a smooth piece these derivatives are known from g, so the interpolant costs no evaluation, and its error, of order
//! h¹⁰/2¹⁰ × the tenth derivative / 10!, stays below that of the step itself. A power that is no polynomial lacks these
//! derivatives at y = 0, and a formula of x may be curved too sharply just behind its zero. On such pieces every sample is
//! the end of a shorter step of its own.

use super::equations::NystromEquation;
use super::landing::NystromState;
use super::{DenseOutput, MotionState, nystrom};
use crate::numerics::root::newton_bisection;

const N_COEFFICIENTS: usize = 5;

/// P(θ) on 0 ≤ θ ≤ 1: Taylor series at 0 and a remainder θ⁵ Q(θ − 1).
#[derive(Debug, Clone, Copy)]
struct Hermite {
    at_start: [f64; N_COEFFICIENTS],
    remainder: [f64; N_COEFFICIENTS],
}

impl Hermite {
    /// From the Taylor coefficients (in θ) at both ends.
    fn new(at_start: [f64; N_COEFFICIENTS], at_end: [f64; N_COEFFICIENTS]) -> Self {
        /// Taylor coefficients of θ⁻⁵ at 1.
        const INVERSE: [f64; N_COEFFICIENTS] = [1.0, -5.0, 15.0, -35.0, 70.0];
        const BINOMIAL: [[f64; N_COEFFICIENTS]; N_COEFFICIENTS] = [
            [1.0, 1.0, 1.0, 1.0, 1.0],
            [0.0, 1.0, 2.0, 3.0, 4.0],
            [0.0, 0.0, 1.0, 3.0, 6.0],
            [0.0, 0.0, 0.0, 1.0, 4.0],
            [0.0, 0.0, 0.0, 0.0, 1.0],
        ];
        let mut missing = at_end;
        for (k, missing) in missing.iter_mut().enumerate() {
            for (i, a) in at_start.iter().enumerate() {
                *missing -= BINOMIAL[k][i] * a;
            }
        }
        let mut remainder = [0.0; N_COEFFICIENTS];
        for (k, coefficient) in remainder.iter_mut().enumerate() {
            for i in 0..=k {
                *coefficient += missing[k - i] * INVERSE[i];
            }
        }
        Self { at_start, remainder }
    }

    /// P and its slope at θ.
    fn value_and_slope(&self, theta: f64) -> (f64, f64) {
        let horner = |c: &[f64; N_COEFFICIENTS], x: f64| {
            c.iter().rev().fold((0.0, 0.0), |(value, slope), c| (value * x + c, slope * x + value))
        };
        let (start, start_slope) = horner(&self.at_start, theta);
        let (rest, rest_slope) = horner(&self.remainder, theta - 1.0);
        let fourth = theta * theta * theta * theta;
        (start + fourth * theta * rest, start_slope + fourth * (5.0 * rest + theta * rest_slope))
    }
}

/// y and u after a step of length h from a node.
fn partial_step<F: NystromEquation>(field: F, from: &NystromState, h: f64) -> (f64, f64) {
    let square = h * h;
    let step = nystrom::step(from.y, h * from.u, square * from.g, field.scale_by(square));
    (step.position, if h > 0.0 { step.velocity / h } else { from.u })
}

/// The continuous solution of the step of `length` (in σ) from `from` to `to`; drag has taken `loss` before it.
pub(super) fn dense_output<F: NystromEquation>(
    field: F,
    from: NystromState,
    to: NystromState,
    length: f64,
    loss: f64,
) -> DenseOutput {
    let derivatives = |node: &NystromState| {
        let (slope, curvature) = field.derivatives(node.y);
        [node.y, node.u, node.g, slope * node.u, curvature * node.u * node.u + slope * node.g]
    };
    let taylor = |[a, b, c, d, e]: [f64; N_COEFFICIENTS]| {
        let (h, h2) = (length, length * length);
        [a, b * h, c * h2 / 2.0, d * h2 * h / 6.0, e * h2 * h2 / 24.0]
    };
    let (start, end) = (derivatives(&from), derivatives(&to));
    let position = Hermite::new(taylor(start), taylor(end));
    // t' = 2 y on a regularised piece
    let times = |node: &NystromState, [y, u, g, j, _]: [f64; N_COEFFICIENTS]| {
        taylor([node.t - from.t, 2.0 * y, 2.0 * u, 2.0 * g, 2.0 * j])
    };
    let clock = Hermite::new(times(&from, start), times(&to, end));
    DenseOutput::new(to.t, move |time| {
        let wanted = time - from.t;
        let mut theta = wanted / (to.t - from.t);
        if !F::USES_PLAIN_VARIABLES {
            // the clock rises
            let is_near = |last: f64, next: f64| (next - last).abs() <= 1e-16;
            theta = newton_bisection((0.0, 1.0), theta, is_near, |theta| {
                let (value, slope) = clock.value_and_slope(theta);
                (wanted - value, -slope)
            });
        }
        let (y, speed) = if F::IS_SMOOTH_AT_ZERO {
            let (y, slope) = position.value_and_slope(theta);
            (y, slope / length)
        } else {
            partial_step(field, &from, theta * length)
        };
        MotionState { time, distance: field.distance_at(y), speed, loss }
    })
}
