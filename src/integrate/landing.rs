//! Landing of an rk8 step on the end of a leg: predicted before the step, mended after it. Branch-free, for one or many.

use super::Leg;
use super::field::{Field, Variables};
use super::lanes::Lane;

/// A state on a piece in its own variables.
#[derive(Debug, Clone, Copy)]
pub(super) struct Node<T> {
    pub(super) y: T,
    pub(super) u: T,
    /// g(y).
    pub(super) g: T,
    pub(super) t: T,
}

/// Where a leg will end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Target<T> {
    /// End of the piece in y: infinite for the last one.
    pub(super) end: T,
    /// y of the predicted end of the leg.
    pub(super) y: T,
    /// y' there; 0 for a turning point.
    pub(super) u: T,
    /// g there.
    pub(super) g: T,
    /// y''' there.
    pub(super) jerk: T,
    /// +1 outward, −1 back.
    pub(super) direction: T,
}

/// How a landing came out, in every lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Landed<T> {
    /// The landed state; g is not that of its y.
    pub(super) node: Node<T>,
    /// What the landing added to the step.
    pub(super) correction: T,
    /// The first term left out of the series: the miss is mended if this is small.
    pub(super) left_out: T,
    /// 1 at the end of the piece, 2 at a turning point.
    pub(super) kind: T,
}

/// [`Landed::kind`] of the end of a piece.
pub(super) const AT_END: f64 = 1.0;
/// [`Landed::kind`] of a turning point.
pub(super) const AT_TURNING: f64 = 2.0;

impl Target<f64> {
    /// Energy says whether an outward leg reaches its end, and how fast.
    #[inline(always)]
    pub(super) fn predict<F: Variables>(field: F, leg: Leg, y: f64, u: f64) -> Self {
        let energy = 0.5 * u * u + field.potential(y);
        let (end, direction) = match leg {
            Leg::Outward(end) => (field.y_at(end), 1.0),
            Leg::Back => (0.0, -1.0),
        };
        let left = if end.is_finite() { energy - field.potential(end) } else { -1.0 };
        let (y, u) =
            if left > 0.0 { (end, direction * (2.0 * left).sqrt()) } else { (field.at_potential(energy), 0.0) };
        Self { end, y, u, g: field.g(y), jerk: field.derivatives(y).0 * u, direction }
    }
}

impl<T: Lane> Target<T> {
    /// Where the error control allows `h`: twice the least way to go at the largest speed still ahead. Below the gap, the
    /// end is too far to matter.
    #[inline(always)]
    pub(super) fn reach(&self, now: &Node<T>, h: T) -> T {
        h * 2.0 * now.u.abs().max(self.u.abs())
    }

    /// The step to take, and the way to the target: that way if it is no longer than `h`, half of it if `h` would leave a
    /// tiny step for the end, else `h`.
    #[inline(always)]
    pub(super) fn limit<F: Field<T>>(&self, field: F, now: &Node<T>, h: T) -> (T, T) {
        let last = self.step_from(field, now);
        let shorter = last.if_less(h * 2.0, last * 0.5, h);
        (h.if_less(last, shorter, last), last)
    }

    /// The step that leads from `now` to the target, by the two-point Taylor formula (error of order h⁷); negative if the
    /// target lies behind.
    #[inline(always)]
    fn step_from<F: Field<T>>(&self, field: F, now: &Node<T>) -> T {
        let slope = field.derivatives(now.y).0;
        let gap = self.direction * (self.y - now.y);
        let mean = self.direction * (now.u + self.u) * 0.5;
        let difference = self.direction * (now.g - self.g) * 0.1;
        let jerks = self.direction * (slope * now.u + self.jerk) * (1.0 / 120.0);
        // the cubic without its last term and with the weight of Simpson's rule, then a Newton step
        let zero = gap.all(0.0);
        let root = (mean * mean + difference * gap * (10.0 / 3.0)).max(zero).sqrt();
        let h = gap * 2.0 / (mean + root);
        let value = ((jerks * h + difference) * h + mean) * h - gap;
        let h = h - value / ((jerks * h * 3.0 + difference * 2.0) * h + mean);
        // close to a turning point distances vanish before speeds do
        let turn = -now.u / now.g;
        let near = (turn * turn * slope.abs()).if_less(gap.all(2.5e-3), turn, h);
        self.u.abs().if_less(gap.all(f64::MIN_POSITIVE), near, h)
    }

    /// Moves `node`, the result of a step that should have landed, onto the end by its Taylor series.
    #[inline(always)]
    pub(super) fn land<F: Field<T>>(&self, field: F, node: &Node<T>) -> Landed<T> {
        let (slope, curvature) = field.derivatives(node.y);
        let Node { y, u, g, t } = *node;
        let zero = y.all(0.0);
        let j = slope * u;
        let k = curvature * u * u + slope * g;
        let position = |d: T| y + d * (u + d * (g * 0.5 + d * (j * (1.0 / 6.0) + d * k * (1.0 / 24.0))));
        let velocity = |d: T| u + d * (g + d * (j * 0.5 + d * k * (1.0 / 6.0)));
        let acceleration = |d: T| g + d * (j + d * k * 0.5);

        // where it turns
        let turn = -u / g;
        let turn = turn - velocity(turn) / acceleration(turn);
        let y_turn = position(turn);
        let beyond = y_turn - self.end;
        // if that is beyond the end: y_t − y = ½ |g| τ² (1 + g' τ²/12), τ before the turning point
        let pull = -acceleration(turn);
        let square = (beyond * 2.0 / pull).max(zero);
        let tau = (square * (zero.all(1.0) - slope * square * (1.0 / 12.0))).sqrt();
        let slow = pull * tau * (zero.all(1.0) + slope * tau * tau * (1.0 / 6.0));
        let turns = |then: T, otherwise: T| zero.if_less(beyond, otherwise, then);
        let near_d = turns(turn, turn - tau);
        let near_u = turns(zero, slow);
        let near_y = turns(y_turn, self.end);
        let near_kind = turns(zero.all(AT_TURNING), zero.all(AT_END));

        // where it crosses the end with some speed
        let gap = self.end - y;
        let cross = gap / u;
        let cross = cross - (position(cross) - self.end) / velocity(cross);

        // outward, and the turning point about as near as the end?
        let is_near = (u * u).if_less((g * gap).abs() * 4.0, self.direction, -self.direction.all(1.0));
        let choose = |near: T, crossing: T| zero.if_less(is_near, near, crossing);
        let d = choose(near_d, cross);
        let square = d * d;
        let mean = y + d * (u * 0.5 + d * (g * (1.0 / 6.0) + d * j * (1.0 / 24.0)));
        Landed {
            node: Node {
                y: choose(near_y, self.end),
                u: choose(near_u, velocity(d)),
                g,
                t: t + field.duration(d, mean),
            },
            correction: d,
            // the fifth derivative, about ω times the fourth, times d⁵/120
            left_out: (k * square * square * d).abs() * slope.abs().sqrt() * (1.0 / 120.0),
            kind: choose(near_kind, zero.all(AT_END)),
        }
    }
}
