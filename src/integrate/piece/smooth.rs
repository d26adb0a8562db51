//! Pieces that are neither powers nor straight lines: a formula that is smooth in d, or in √d.

use super::{Dragged, Field, Motion, Quad, Variables};
use crate::integrate::{Drag, Path, root_of};
use crate::math::functions::powi;
use crate::math::smooth::{Jet, Smooth};

/// A formula of d without drag, y = d: g = −c f(start + y).
#[derive(Debug, Clone, Copy)]
pub(in crate::integrate) struct OfDistance {
    pub(in crate::integrate) force: Smooth,
    pub(in crate::integrate) start: f64,
    pub(in crate::integrate) c: f64,
}

impl Field<f64> for OfDistance {
    const IS_TIME: bool = true;
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    fn g(self, y: f64) -> f64 {
        -self.c * self.force.at_variable(self.start + y)
    }
    fn derivatives(self, y: f64) -> (f64, f64) {
        let Jet { slope, curvature, .. } = self.force.jet(self.start + y);
        (-self.c * slope, -self.c * curvature)
    }
}

impl Variables for OfDistance {
    const IS_POLYNOMIAL: bool = false;
    fn potential(self, y: f64) -> f64 {
        self.c * self.force.work(self.start, 0.0, y)
    }
    fn at_potential(self, potential: f64) -> f64 {
        // the force so far is about that of a straight line from x = 0
        let before = 0.5 * self.start * self.force.at_variable(self.start);
        self.force.distance_at_work(self.start, before, potential / self.c)
    }
}

/// A formula of √d without drag, which is odd: g = −c y f(y), y = √d, with c twice its factor.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrate) struct OfRoot {
    pub(in crate::integrate) force: Smooth,
    pub(in crate::integrate) c: f64,
}

impl Field<f64> for OfRoot {
    const IS_TIME: bool = false;
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    fn g(self, y: f64) -> f64 {
        -self.c * y * self.force.at_variable(y)
    }
    fn derivatives(self, y: f64) -> (f64, f64) {
        let Jet { value, slope, curvature } = self.force.jet(y);
        (-self.c * (value + y * slope), -self.c * (2.0 * slope + y * curvature))
    }
}

impl Variables for OfRoot {
    const IS_POLYNOMIAL: bool = true;
    fn potential(self, y: f64) -> f64 {
        0.5 * self.c * self.force.work(0.0, 0.0, y * y)
    }
    fn at_potential(self, potential: f64) -> f64 {
        self.force.distance_at_work(0.0, 0.0, 2.0 * potential / self.c).sqrt()
    }
}

/// A formula with drag and pull: d'' = γ − f − drag, f = factor × formula.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrate) struct Curve {
    force: Smooth,
    start: f64,
    factor: f64,
    drag: Drag,
    pull: f64,
}

impl Curve {
    /// The formula with the pull and the drag of a path.
    pub(in crate::integrate) fn along(force: Smooth, start: f64, factor: f64, path: &Path) -> Self {
        Self { force, start, factor, drag: path.drag, pull: path.pull }
    }

    /// γ − f − drag, and drag × u, where the force is f and its slope in d is `slope`.
    fn pulls(&self, f: f64, slope: impl FnOnce() -> f64, u: f64) -> (f64, f64) {
        let drag = self.drag.at(f, slope) * u;
        (self.pull - f - drag, drag * u)
    }

    /// Contact force f + η √s u and its derivative along a way on which f, s and u change at these rates.
    fn contact(&self, f: [f64; 2], s: [f64; 2], u: [f64; 2]) -> (f64, f64) {
        let root = root_of(s[0]);
        let of_root = if root > 0.0 { 0.5 * s[1] / root } else { 0.0 };
        let eta = self.drag.eta;
        (f[0] + eta * root * u[0], f[1] + eta * (root * u[1] + of_root * u[0]))
    }
}

/// A curve that is smooth in d: y = d, σ = t.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrate) struct DraggedOfDistance(pub(in crate::integrate) Curve);

impl Motion<f64> for DraggedOfDistance {
    fn rates(&self, y: f64, u: f64) -> Quad {
        let Curve { force, start, factor, .. } = self.0;
        let (rate, loss) = self.0.pulls(factor * force.value(start, y), || factor * force.slope(start, y), u);
        [u, rate, 1.0, loss]
    }
}

impl Dragged for DraggedOfDistance {
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

/// A curve that is smooth in √d: d = r^m, m = 4 where the drag goes with √f', that is with d^¼.
#[derive(Debug, Clone, Copy)]
pub(in crate::integrate) struct DraggedOfRoot<const M: u8>(pub(in crate::integrate) Curve);

impl<const M: u8> DraggedOfRoot<M> {
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

impl<const M: u8> Motion<f64> for DraggedOfRoot<M> {
    fn rates(&self, y: f64, u: f64) -> Quad {
        let clock = f64::from(M) * powi(y, i32::from(M) - 1);
        let root = Self::root(y.abs());
        let [f, s, _] = if self.0.drag.eta == 0.0 {
            [self.0.factor * self.0.force.at_variable(root), 0.0, 0.0]
        } else {
            self.derivatives(root)
        };
        let (rate, loss) = self.0.pulls(f, || s, u);
        [u, clock * rate, clock, clock * loss]
    }
}

impl<const M: u8> Dragged for DraggedOfRoot<M> {
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
