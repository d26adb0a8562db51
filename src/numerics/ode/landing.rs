//! Landing of an rk8 step on the end of a leg: predicted before the step, corrected after it.

use super::equations::NystromEquation;
use super::{Leg, LegEnd};

/// A state on a piece in its own variables.
#[derive(Debug, Clone, Copy)]
pub(super) struct NystromState {
    pub(super) y: f64,
    pub(super) u: f64,
    /// g(y).
    pub(super) g: f64,
    pub(super) t: f64,
}

/// Where a leg will end.
#[derive(Debug, Clone, Copy)]
pub(super) struct PredictedEnd {
    /// End of the piece in y: infinite for the last one.
    pub(super) end: f64,
    /// y of the predicted end of the leg.
    pub(super) y: f64,
    /// y' there; 0 for a turning point.
    pub(super) u: f64,
    pub(super) g: f64,
    /// +1 outward, −1 back.
    pub(super) direction: f64,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct LandedState {
    /// The state at the end. Its g belongs to the y of the step, not to the corrected y.
    pub(super) node: NystromState,
    /// The correction that the landing added to the step.
    pub(super) correction: f64,
    /// Square of the first term left out of the series. If it is small, the landing is good.
    pub(super) left_out_squared: f64,
    /// At the end of the piece or at a turning point.
    pub(super) landing: LegEnd,
}

impl PredictedEnd {
    /// Predicts the end of a leg. The energy shows whether a loading leg reaches the end of its piece, and at which speed.
    #[inline(always)]
    pub(super) fn predict<F: NystromEquation>(field: F, leg: Leg, y: f64, u: f64) -> Self {
        let energy = 0.5 * u * u + field.potential(y);
        let (end, direction) = match leg {
            Leg::Loading(end) => (field.y_at(end), 1.0),
            // a rebound leg with another end is left to the stepper with drag
            Leg::Unloading(_) => (0.0, -1.0),
        };
        let kinetic_at_end = if end.is_finite() { energy - field.potential(end) } else { -1.0 };
        let (y, u) = if kinetic_at_end > 0.0 {
            (end, direction * (2.0 * kinetic_at_end).sqrt())
        } else {
            (field.y_at_potential(energy), 0.0)
        };
        Self { end, y, u, g: field.g(y), direction }
    }

    /// 2 h times the largest speed until the end. If this is shorter than the distance to the end, the step ends before it, and no
    /// landing is predicted.
    #[inline(always)]
    pub(super) fn max_advance(&self, now: &NystromState, h: f64) -> f64 {
        h * 2.0 * now.u.abs().max(self.u.abs())
    }

    /// The step to take, and the step that reaches the end. The step to take is the step to the end if this is at most `h`, half of
    /// it if `h` would leave a tiny last step, and otherwise `h`.
    #[inline(always)]
    pub(super) fn controlled_step(&self, now: &NystromState, h: f64) -> (f64, f64) {
        let last = self.step_to_end(now);
        let shorter = if last < h * 2.0 { last * 0.5 } else { h };
        (if h < last { shorter } else { last }, last)
    }

    /// The step that leads from `now` to the target, by the two-point Taylor formula (error of order h⁵); negative if the
    /// target lies behind.
    #[inline(always)]
    fn step_to_end(&self, now: &NystromState) -> f64 {
        let gap = self.direction * (self.y - now.y);
        let mean = self.direction * (now.u + self.u) * 0.5;
        if mean > 0.0 {
            let difference = self.direction * (now.g - self.g) * (1.0 / 12.0);
            let root = (mean * mean + difference * gap * 4.0).max(0.0).sqrt();
            gap * 2.0 / (mean + root)
        } else {
            // past a turning point already: back to it
            -now.u / now.g
        }
    }

    /// Moves `node`, the result of a step that should have landed, onto the end by its Taylor series.
    #[inline(always)]
    pub(super) fn land<F: NystromEquation>(&self, field: F, node: &NystromState) -> LandedState {
        let (slope, curvature) = field.derivatives(node.y);
        let NystromState { y, u, g, t } = *node;
        let series = TaylorSeries { y, u, g, j: slope * u, k: curvature * u * u + slope * g };
        let gap = self.end - y;
        // if the turning point of an outward leg is about as near as the end, the series goes to the turning point first
        // (with u < 0 the sphere has turned already and rebounds)
        let is_near = self.direction > 0.0 && u * u.abs() < (g * gap).abs() * 4.0;
        let (d, y_end, speed, landing) = if is_near {
            let d = -u / g;
            let d = d - series.velocity(d) / series.acceleration(d);
            let y_turn = series.position(d);
            let beyond = y_turn - self.end;
            if beyond > 0.0 {
                // a turning point beyond the end: y_t − y = ½ |g| τ² (1 + g' τ²/12), τ before it
                let pull = -series.acceleration(d);
                let square = (beyond * 2.0 / pull).max(0.0);
                let tau = (square * (1.0 - slope * square * (1.0 / 12.0))).sqrt();
                let slow = pull * tau * (1.0 + slope * tau * tau * (1.0 / 6.0));
                (d - tau, self.end, slow, LegEnd::PieceEnd)
            } else {
                (d, y_turn, 0.0, LegEnd::Turning)
            }
        } else {
            let d = gap / u;
            let d = d - (series.position(d) - self.end) / series.velocity(d);
            (d, self.end, series.velocity(d), LegEnd::PieceEnd)
        };
        let square = d * d;
        let left_out = series.k * square * square * d * (1.0 / 120.0);
        let mean = y + d * (u * 0.5 + d * (g * (1.0 / 6.0) + d * series.j * (1.0 / 24.0)));
        LandedState {
            node: NystromState { y: y_end, u: speed, g, t: t + field.duration(d, mean) },
            correction: d,
            // the fifth derivative is about ω = √−g' times the fourth
            left_out_squared: left_out * left_out * slope.abs(),
            landing,
        }
    }
}

/// The Taylor series of y at a node, to the fourth derivative.
#[derive(Clone, Copy)]
struct TaylorSeries {
    y: f64,
    u: f64,
    g: f64,
    j: f64,
    k: f64,
}

impl TaylorSeries {
    #[inline(always)]
    fn position(&self, d: f64) -> f64 {
        self.y + d * (self.u + d * (self.g * 0.5 + d * (self.j * (1.0 / 6.0) + d * self.k * (1.0 / 24.0))))
    }
    #[inline(always)]
    fn velocity(&self, d: f64) -> f64 {
        self.u + d * (self.g + d * (self.j * 0.5 + d * self.k * (1.0 / 6.0)))
    }
    #[inline(always)]
    fn acceleration(&self, d: f64) -> f64 {
        self.g + d * (self.j + d * self.k * 0.5)
    }
}
