//! Landing of an rk8 step on the end of a leg: predicted before the step, mended after it.

use super::field::Field;
use super::rk8::Node;
use super::{Landing, Leg};

/// Where a leg will end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Target {
    /// End of the piece in y: infinite for the last one.
    end: f64,
    /// The predicted end of the leg; its time is not known.
    pub(super) node: Node,
    /// Third derivative of y there.
    jerk: f64,
    /// +1 outward, −1 back.
    direction: f64,
}

impl Target {
    /// Energy says whether an outward leg reaches its end, and how fast.
    #[inline(always)]
    pub(super) fn predict<F: Field>(field: F, leg: Leg, start: &Node) -> Self {
        let energy = 0.5 * start.u * start.u + field.potential(start.y);
        let (end, direction) = match leg {
            Leg::Outward(end) => (field.y_at(end), 1.0),
            Leg::Back => (0.0, -1.0),
        };
        let left = if end.is_finite() { energy - field.potential(end) } else { -1.0 };
        let (y, u) =
            if left > 0.0 { (end, direction * (2.0 * left).sqrt()) } else { (field.at_potential(energy), 0.0) };
        Self { end, node: Node { y, u, g: field.g(y), t: f64::NAN }, jerk: field.derivatives(y).0 * u, direction }
    }

    /// The step to take where the error control allows `h`, and whether it should land: the way to the target if that is
    /// no longer; half of it if `h` would leave a tiny step for the end; else `h`.
    #[inline(always)]
    pub(super) fn limit<F: Field>(&self, field: F, now: &Node, h: f64) -> (f64, bool) {
        // the speed never rises above these two, so this much is far from the end without predicting it
        if 2.0 * h * now.u.abs().max(self.node.u.abs()) < (self.node.y - now.y).abs() {
            return (h, false);
        }
        let last = self.step_from(field, now);
        if last <= h {
            (last, true)
        } else if last < 2.0 * h {
            (0.5 * last, false)
        } else {
            (h, false)
        }
    }

    /// The step that leads from `now` to the target, by the two-point Taylor formula (error of order h⁷); negative if the
    /// target lies behind.
    #[inline(always)]
    fn step_from<F: Field>(&self, field: F, now: &Node) -> f64 {
        let slope = field.derivatives(now.y).0;
        if self.node.u == 0.0 {
            // close to the turning point distances vanish before speeds do
            let turn = -now.u / now.g;
            if turn * turn * slope.abs() < 2.5e-3 {
                return turn;
            }
        }
        let sign = self.direction;
        let gap = sign * (self.node.y - now.y);
        let mean = 0.5 * sign * (now.u + self.node.u);
        let difference = 0.1 * sign * (now.g - self.node.g);
        let jerks = sign * (slope * now.u + self.jerk) / 120.0;
        // the cubic without its last term and with the weight of Simpson's rule, then a Newton step
        let root = (mean * mean + (10.0 / 3.0) * difference * gap).max(0.0).sqrt();
        let h = 2.0 * gap / (mean + root);
        let value = ((jerks * h + difference) * h + mean) * h - gap;
        h - value / ((3.0 * jerks * h + 2.0 * difference) * h + mean)
    }

    /// Moves `node`, the result of a step that should have landed, onto the end by the Taylor series there, and lengthens
    /// `length` by what that took. `None` if the miss is too large for the series: then the step counts as an ordinary one.
    #[inline(always)]
    pub(super) fn land<F: Field>(&self, field: F, node: &mut Node, length: &mut f64, allowed: f64) -> Option<Landing> {
        let (slope, curvature) = field.derivatives(node.y);
        let Node { y, u, g, .. } = *node;
        let j = slope * u;
        let k = curvature * u * u + slope * g;
        let position = |d: f64| y + d * (u + d * (0.5 * g + d * (j / 6.0 + d * k / 24.0)));
        let velocity = |d: f64| u + d * (g + d * (0.5 * j + d * k / 6.0));
        let gap = self.end - y;
        let mut d;
        let landing;
        let speed;
        if self.direction > 0.0 && u * u < 4.0 * (g * gap).abs() {
            // the turning point is about as near as the end: find it first
            d = -u / g;
            for _ in 0..2 {
                d -= velocity(d) / (g + d * (j + 0.5 * d * k));
            }
            let beyond = position(d) - self.end;
            if beyond > 0.0 {
                // y_t − y = ½ |g| τ² (1 + g' τ²/12), τ before the turning point
                let g_turn = -(g + d * (j + 0.5 * d * k));
                let square = 2.0 * beyond / g_turn;
                let tau = (square * (1.0 - slope * square / 12.0)).sqrt();
                d -= tau;
                speed = g_turn * tau * (1.0 + slope * tau * tau / 6.0);
                landing = Landing::End;
            } else {
                speed = 0.0;
                landing = Landing::Turning;
            }
        } else {
            d = gap / u;
            for _ in 0..2 {
                d -= (position(d) - self.end) / velocity(d);
            }
            speed = velocity(d);
            landing = Landing::End;
        }
        // the first term left out: the fifth derivative, about ω times the fourth, times d⁵/120
        let square = d * d;
        let left_out = (k * square * square * d).abs() * slope.abs().sqrt() / 120.0;
        if left_out > 0.1 * allowed || d.is_nan() {
            return None;
        }
        node.t += if F::IS_TIME { d } else { 2.0 * d * (y + d * (0.5 * u + d * (g / 6.0 + d * j / 24.0))) };
        node.y = if landing == Landing::End { self.end } else { position(d) };
        node.u = speed;
        node.g = field.g(node.y);
        *length += d;
        Some(landing)
    }
}
