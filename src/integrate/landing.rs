//! Landing of an rk8 step on the end of a leg: predicted before the step, corrected after it. Without branches, for one motion
//! or for lanes.

use super::Leg;
use super::lanes::Lane;
use super::piece::{Field, Variables};

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
    /// +1 outward, −1 back.
    pub(super) direction: T,
}

/// The result of a landing, in every lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Landed<T> {
    /// The landed state; its g is that of the step, not that of the corrected y.
    pub(super) node: Node<T>,
    /// What the landing added to the step.
    pub(super) correction: T,
    /// Square of the first term left out of the series. If it is small, the landing is good.
    pub(super) left_out_squared: T,
    /// 1 at the end of the piece, 2 at a turning point.
    pub(super) kind: T,
}

/// [`Landed::kind`] of the end of a piece.
pub(super) const AT_END: f64 = 1.0;
/// [`Landed::kind`] of a turning point.
pub(super) const AT_TURNING: f64 = 2.0;

impl Target<f64> {
    /// The end of a leg: energy gives whether an outward leg reaches the end of its piece, and how fast.
    #[inline(always)]
    pub(super) fn predict<F: Variables>(field: F, leg: Leg, y: f64, u: f64) -> Self {
        let energy = 0.5 * u * u + field.potential(y);
        let (end, direction) = match leg {
            Leg::Outward(end) => (field.y_at(end), 1.0),
            // other ends of a way back are left to the stepper with drag
            Leg::Back(_) => (0.0, -1.0),
        };
        let left = if end.is_finite() { energy - field.potential(end) } else { -1.0 };
        let (y, u) =
            if left > 0.0 { (end, direction * (2.0 * left).sqrt()) } else { (field.at_potential(energy), 0.0) };
        Self { end, y, u, g: field.g(y), direction }
    }
}

impl<T: Lane> Target<T> {
    /// 2 h times the largest speed still ahead. If that is shorter than the way to the target, the step ends before it and
    /// the landing need not be predicted.
    #[inline(always)]
    pub(super) fn reach(&self, now: &Node<T>, h: T) -> T {
        h * 2.0 * now.u.abs().max(self.u.abs())
    }

    /// The step to take, and the way to the target: that way if it is no longer than `h`, half of it if `h` would leave a
    /// tiny step for the end, else `h`.
    #[inline(always)]
    pub(super) fn limit(&self, now: &Node<T>, h: T) -> (T, T) {
        let last = self.step_from(now);
        let shorter = last.if_less(h * 2.0, last * 0.5, h);
        (h.if_less(last, shorter, last), last)
    }

    /// The step that leads from `now` to the target, by the two-point Taylor formula (error of order h⁵); negative if the
    /// target lies behind.
    #[inline(always)]
    fn step_from(&self, now: &Node<T>) -> T {
        let gap = self.direction * (self.y - now.y);
        let mean = self.direction * (now.u + self.u) * 0.5;
        let difference = self.direction * (now.g - self.g) * (1.0 / 12.0);
        let zero = gap.all(0.0);
        let root = (mean * mean + difference * gap * 4.0).max(zero).sqrt();
        // past a turning point already: back to it
        let way = zero.if_less(mean, gap * 2.0, -now.u);
        let pace = zero.if_less(mean, mean + root, now.g);
        way / pace
    }

    /// Moves `node`, the result of a step that should have landed, onto the end by its Taylor series.
    #[inline(always)]
    pub(super) fn land<F: Field<T>>(&self, field: F, node: &Node<T>) -> Landed<T> {
        let (slope, curvature) = field.derivatives(node.y);
        let Node { y, u, g, t } = *node;
        let zero = y.all(0.0);
        let one = y.all(1.0);
        let series = Series { y, u, g, j: slope * u, k: curvature * u * u + slope * g };

        // if the turning point of an outward leg is about as near as the end, the series goes to the turning point first
        let gap = self.end - y;
        // (with u < 0 the sphere has turned already, and is on the way back)
        let near = (u * u.abs()).if_less((g * gap).abs() * 4.0, self.direction, -one);
        let d = zero.if_less(near, -u, gap) / zero.if_less(near, g, u);
        let miss = zero.if_less(near, series.velocity(d), series.position(d) - self.end);
        let d = d - miss / zero.if_less(near, series.acceleration(d), series.velocity(d));

        // a turning point beyond the end: y_t − y = ½ |g| τ² (1 + g' τ²/12), τ before it
        let y_turn = series.position(d);
        let beyond = zero.if_less(near, y_turn - self.end, zero);
        let pull = -series.acceleration(d);
        let square = (beyond * 2.0 / pull).max(zero);
        let tau = (square * (one - slope * square * (1.0 / 12.0))).sqrt();
        let slow = pull * tau * (one + slope * tau * tau * (1.0 / 6.0));
        let d = zero.if_less(beyond, d - tau, d);

        let speed = zero.if_less(near, zero.if_less(beyond, slow, zero), series.velocity(d));
        let turns = zero.if_less(near, zero.if_less(beyond, zero, one), zero);
        let square = d * d;
        let left_out = series.k * square * square * d * (1.0 / 120.0);
        let mean = y + d * (u * 0.5 + d * (g * (1.0 / 6.0) + d * series.j * (1.0 / 24.0)));
        Landed {
            node: Node { y: zero.if_less(turns, y_turn, self.end), u: speed, g, t: t + field.duration(d, mean) },
            correction: d,
            // the fifth derivative is about ω = √−g' times the fourth
            left_out_squared: left_out * left_out * slope.abs(),
            kind: zero.if_less(turns, zero.all(AT_TURNING), zero.all(AT_END)),
        }
    }
}

/// The Taylor series of y at a node, to the fourth derivative.
#[derive(Clone, Copy)]
struct Series<T> {
    y: T,
    u: T,
    g: T,
    j: T,
    k: T,
}

impl<T: Lane> Series<T> {
    #[inline(always)]
    fn position(&self, d: T) -> T {
        self.y + d * (self.u + d * (self.g * 0.5 + d * (self.j * (1.0 / 6.0) + d * self.k * (1.0 / 24.0))))
    }
    #[inline(always)]
    fn velocity(&self, d: T) -> T {
        self.u + d * (self.g + d * (self.j * 0.5 + d * self.k * (1.0 / 6.0)))
    }
    #[inline(always)]
    fn acceleration(&self, d: T) -> T {
        self.g + d * (self.j + d * self.k * 0.5)
    }
}
