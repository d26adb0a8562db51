//! Closed form of the motion along a linear piece during loading, with linear drag below critical: d'' = −(a + b d) − c d'
//! (see [`DampedLinearEquation`]).
//!
//! With y = d + a/b, β = c/2 and ω² = b − β² > 0, from y_0 and u_0 = y_0':
//!
//! ```text
//! y(t) = e^(−βt) (y_0 cos ωt + (u_0 + β y_0) sin(ωt)/ω)
//! u(t) = e^(−βt) (u_0 cos ωt − (b y_0 + β u_0) sin(ωt)/ω)
//! ```

use super::equations::linear::DampedLinearEquation;
use super::{DenseOutput, Leg, LegEnd, LegProblem, LegResult, MotionState};
use crate::numerics::functions::{atan2, exp, sin_cos};
use crate::numerics::power::nan_max;
use crate::numerics::root::newton_bisection;

#[derive(Debug, Clone, Copy)]
pub(super) struct DampedOscillator {
    start: MotionState,
    /// y_0.
    y: f64,
    /// b.
    slope: f64,
    /// β.
    decay: f64,
    /// ω.
    frequency: f64,
    /// The part of c that is in the contact.
    in_contact: f64,
}

impl DampedOscillator {
    /// `None` where the motion is another one.
    pub fn try_new(piece: &DampedLinearEquation, leg: Leg, start: MotionState) -> Option<Self> {
        let DampedLinearEquation { a, b: slope, chi, c, in_contact, pull } = *piece;
        let (y, decay) = (start.distance + a / slope, 0.5 * c);
        let square = slope - decay * decay;
        let is_this = matches!(leg, Leg::Loading(_)) && chi == 0.0 && pull == 0.0 && square > 0.0;
        (is_this && start.speed > 0.0).then(|| Self { start, y, slope, decay, frequency: square.sqrt(), in_contact })
    }

    /// (y, u) after the time t.
    fn displacement_and_speed(&self, time: f64) -> (f64, f64) {
        let (sine, cosine) = sin_cos(self.frequency * time);
        let (sine, damping, u) = (sine / self.frequency, exp(-self.decay * time), self.start.speed);
        let y = damping * (self.y * cosine + (u + self.decay * self.y) * sine);
        (y, damping * (u * cosine - (self.slope * self.y + self.decay * u) * sine))
    }

    /// The first time at which `of_speed` u + `of_place` y vanishes, which is positive at first.
    fn first_zero(&self, of_speed: f64, of_place: f64) -> f64 {
        let (y, u) = (self.y, self.start.speed);
        let falls = of_speed * (self.slope * y + self.decay * u) - of_place * (u + self.decay * y);
        atan2(self.frequency * (of_speed * u + of_place * y), falls) / self.frequency
    }

    /// The state after the time t. `place` is its distance, if this is known exactly. The loss follows from the energy balance.
    fn state(&self, time: f64, place: Option<f64>) -> MotionState {
        let (y, speed) = self.displacement_and_speed(time);
        let travelled = place.map_or(y - self.y, |distance| distance - self.start.distance);
        let kinetic = 0.5 * (self.start.speed - speed) * (self.start.speed + speed);
        let loss = self.start.loss + kinetic - self.slope * (self.y + 0.5 * travelled) * travelled;
        let distance = place.unwrap_or(self.start.distance + travelled);
        MotionState { time: self.start.time + time, distance, speed, loss }
    }

    /// Carries the state to the end of the leg, or to its turning point.
    pub fn finish_leg(
        self,
        path: &LegProblem,
        state: &mut MotionState,
        track: Option<&mut Vec<DenseOutput>>,
    ) -> LegResult {
        let end = path.leg.end();
        let turning = self.first_zero(1.0, 0.0);
        let turned = self.state(turning, None);
        let (landing, time) = if turned.distance < end {
            *state = MotionState { speed: 0.0, ..turned };
            (LegEnd::Turning, turning)
        } else {
            let ahead = |time| {
                let (y, u) = self.displacement_and_speed(time);
                (end - self.start.distance - (y - self.y), -u)
            };
            let travelled = end - self.start.distance;
            let first = (travelled / self.start.speed).min(turning);
            let is_near = |last: f64, next: f64| (next - last).abs() <= f64::EPSILON * next;
            let time = newton_bisection((0.0, turning), first, is_near, ahead);
            *state = self.state(time, Some(end));
            (LegEnd::PieceEnd, time)
        };
        // damping adds c_contact u to the contact force, which then grows at the rate (b − c c_contact) u − c_contact b y
        let (of_speed, of_place) = (self.slope - 2.0 * self.decay * self.in_contact, -self.in_contact * self.slope);
        let crests = self.in_contact > 0.0 && of_speed * self.start.speed + of_place * self.y > 0.0;
        let crest = crests.then(|| self.first_zero(of_speed, of_place)).filter(|crest| *crest < time);
        let mut largest_force = path.max_end_force(&self.start, state);
        if let Some(crest) = crest {
            let (y, u) = self.displacement_and_speed(crest);
            largest_force = nan_max(largest_force, self.slope * y + self.in_contact * u);
        }
        if let Some(track) = track {
            track.push(DenseOutput::new(state.time, move |time| self.state(time - self.start.time, None)));
        }
        LegResult { end: landing, largest_force }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::curve::LoadingCurve;
    use crate::numerics::ode::DampingCoefficients;
    use crate::numerics::ode::damped_stepper::DampedStepper;
    use crate::numerics::ode::leg::ErrorScales;
    use approx::assert_abs_diff_eq;

    /// The closed form is compared with steps at a tolerance of 1e-13, to the end of the piece and to the turning point.
    #[test]
    fn steps_lead_to_the_same_state() {
        for (end, eta, kappa, theta) in [
            (0.3, 0.2, 0.0, 0.0),
            (9.0, 0.2, 0.0, 0.0),
            (0.3, 1.5, 0.0, 0.1),
            (9.0, 1.0, 0.0, 0.3),
            (9.0, 0.0, 0.0, 0.4),
            (0.3, 0.0, 0.1, 0.0),
            (9.0, 0.0, 0.8, 0.0),
        ] {
            let curve = LoadingCurve::linear(2.0).then_line(0.25, 2.0);
            let path = LegProblem {
                piece: &curve.pieces()[1],
                factor: 1.0,
                leg: Leg::Loading(end),
                error_scales: ErrorScales { distance: 1.0, speed: 1.3 },
                constant_acceleration: 0.0,
                drag: DampingCoefficients {
                    viscous: eta,
                    viscoelastic: kappa,
                    plate: theta,
                    ..DampingCoefficients::NONE
                },
                rest: None,
            };
            let start = MotionState { time: 0.7, distance: 0.1, speed: 1.3, loss: 0.05 };
            let (mut exact, mut stepped) = (start, start);
            let mut track = Vec::new();
            let piece = DampedLinearEquation::from_leg(0.5, 2.0, &path);
            let closed = DampedOscillator::try_new(&piece, path.leg, start).unwrap().finish_leg(
                &path,
                &mut exact,
                Some(&mut track),
            );
            let steps = DampedStepper::new(1e-13).integrate_piece(piece, &path, &mut stepped, None).unwrap();
            assert_eq!(closed.end, steps.end);
            assert_abs_diff_eq!(closed.largest_force, steps.largest_force, epsilon = 2e-12);
            let parts = |state: MotionState| [state.time, state.distance, state.speed, state.loss];
            for (exact, stepped) in parts(exact).into_iter().zip(parts(stepped)) {
                assert_abs_diff_eq!(exact, stepped, epsilon = 2e-12);
            }
            let [first, last] = [start.time, exact.time].map(|time| track[0].state_at(time));
            assert_abs_diff_eq!(first.distance, start.distance, epsilon = 1e-15);
            assert_abs_diff_eq!(last.distance, exact.distance, epsilon = 1e-14);
        }
    }
}
