//! Pieces that are neither powers nor straight lines, with drag.

use super::Piece;
use crate::functions::powi;
use crate::integrate::dop853::{Motion, Quad};
use crate::power::max_or_nan;
use crate::smooth::Smooth;

/// d'' = γ − f (1 + χ u) − η √f' u with f = factor × formula.
#[derive(Debug, Clone, Copy)]
pub(super) struct Curve {
    pub(super) force: Smooth,
    pub(super) start: f64,
    pub(super) factor: f64,
    pub(super) chi: f64,
    /// η.
    pub(super) eta: f64,
    pub(super) pull: f64,
}

impl Curve {
    /// γ − f − drag, and drag × u, where the force is f and its slope in d is s.
    fn pulls(&self, f: f64, s: f64, u: f64) -> (f64, f64) {
        let drag = (f * self.chi + self.eta * max_or_nan(s, 0.0).sqrt()) * u;
        (self.pull - f - drag, drag * u)
    }

    /// Contact force f + η √s u and its derivative along a way on which f, s and u change at these rates.
    fn contact(&self, f: [f64; 2], s: [f64; 2], u: [f64; 2]) -> (f64, f64) {
        let root = max_or_nan(s[0], 0.0).sqrt();
        let of_root = if root > 0.0 { 0.5 * s[1] / root } else { 0.0 };
        (f[0] + self.eta * root * u[0], f[1] + self.eta * (root * u[1] + of_root * u[0]))
    }
}

/// A curve that is smooth in d: y = d, σ = t.
#[derive(Debug, Clone, Copy)]
pub(super) struct Plain(pub(super) Curve);

impl Motion<f64> for Plain {
    fn rates(&self, y: f64, u: f64) -> Quad {
        let curve = &self.0;
        // without drag of stiffness no slope
        let slope = if curve.eta == 0.0 { 0.0 } else { curve.factor * curve.force.slope(curve.start, y) };
        let (rate, loss) = curve.pulls(curve.factor * curve.force.value(curve.start, y), slope, u);
        [u, rate, 1.0, loss]
    }
}

impl Piece for Plain {
    const ROOT: i32 = 1;
    fn contact(&self, node: &Quad, rates: &Quad) -> (f64, f64) {
        let curve = &self.0;
        let jet = curve.force.jet(curve.start + node[0]);
        let [f, s, k] = [jet.value, jet.slope, jet.curvature].map(|part| curve.factor * part);
        curve.contact([f, s * rates[0]], [s, k * rates[0]], [node[1], rates[1]])
    }
    fn frequency(&self, y: f64) -> f64 {
        (self.0.factor * self.0.force.slope(self.0.start, y)).max(f64::MIN_POSITIVE).sqrt()
    }
}

/// A curve that is smooth in √d: d = r^m, dσ = dt/(m r^(m−1)); m = 4 where the drag goes with √f', that is with d^¼.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rooted<const M: u8>(pub(super) Curve);

impl<const M: u8> Rooted<M> {
    /// √d.
    fn root(r: f64) -> f64 {
        if M == 2 { r } else { r * r }
    }

    /// f and its first two derivatives in d at √d.
    fn derivatives(&self, root: f64) -> [f64; 3] {
        let jet = self.0.force.jet(root);
        let [f, s, k] = [jet.value, jet.slope, jet.curvature].map(|part| self.0.factor * part);
        let in_d = if root > 0.0 { [s / (2.0 * root), (k - s / root) / (4.0 * root * root)] } else { [0.5 * k, 0.0] };
        [f, in_d[0], in_d[1]]
    }
}

impl<const M: u8> Motion<f64> for Rooted<M> {
    fn rates(&self, y: f64, u: f64) -> Quad {
        let clock = f64::from(M) * powi(y, i32::from(M) - 1);
        let root = Self::root(y.abs());
        let [f, s, _] = if self.0.eta == 0.0 {
            [self.0.factor * self.0.force.at_variable(root), 0.0, 0.0]
        } else {
            self.derivatives(root)
        };
        let (rate, loss) = self.0.pulls(f, s, u);
        [u, clock * rate, clock, clock * loss]
    }
}

impl<const M: u8> Piece for Rooted<M> {
    const ROOT: i32 = M as i32;
    fn contact(&self, node: &Quad, rates: &Quad) -> (f64, f64) {
        let [f, s, k] = self.derivatives(Self::root(node[0].abs()));
        // along σ the distance changes by u times the clock
        let moved = rates[0] * f64::from(M) * powi(node[0], i32::from(M) - 1);
        self.0.contact([f, s * moved], [s, k * moved], [node[1], rates[1]])
    }
    fn frequency(&self, y: f64) -> f64 {
        let m = f64::from(M);
        let [f, s, _] = self.derivatives(Self::root(y));
        // √ of about −du'/dr
        (m * powi(y, i32::from(M) - 2) * ((m - 1.0) * f + m * powi(y, i32::from(M)) * s)).max(f64::MIN_POSITIVE).sqrt()
    }
}
