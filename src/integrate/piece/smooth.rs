//! Pieces that are neither powers nor straight lines: a formula that is smooth in d, or in √d.

use super::{Dragged, Field, Motion, Quad, Variables};
use crate::integrate::{Drag, Path};
use crate::math::functions::powi;
use crate::math::smooth::{Jet, Smooth};

/// A formula without drag. One of d has y = d and g = −c f(start + y). One of √d is odd; it has y = √d and g = −c y f(y),
/// with c twice its factor.
#[derive(Debug, Clone, Copy)]
pub struct Curve<const ROOT: bool> {
    pub force: Smooth,
    pub start: f64,
    pub c: f64,
}

impl<const ROOT: bool> Field for Curve<ROOT> {
    const IS_TIME: bool = !ROOT;
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    fn g(self, y: f64) -> f64 {
        if ROOT { -self.c * y * self.force.at_variable(y) } else { -self.c * self.force.at_variable(self.start + y) }
    }
    fn derivatives(self, y: f64) -> (f64, f64) {
        let Jet { value, slope, curvature } = self.force.jet(if ROOT { y } else { self.start + y });
        let (first, second) = if ROOT { (value + y * slope, 2.0 * slope + y * curvature) } else { (slope, curvature) };
        (-self.c * first, -self.c * second)
    }
}

impl<const ROOT: bool> Variables for Curve<ROOT> {
    const IS_POLYNOMIAL: bool = ROOT;
    fn potential(self, y: f64) -> f64 {
        if ROOT {
            0.5 * self.c * self.force.work(0.0, 0.0, y * y)
        } else {
            self.c * self.force.work(self.start, 0.0, y)
        }
    }
    fn at_potential(self, potential: f64) -> f64 {
        if ROOT {
            return self.force.distance_at_work(0.0, 0.0, 2.0 * potential / self.c).sqrt();
        }
        // the force so far is about that of a straight line from x = 0
        let before = 0.5 * self.start * self.force.at_variable(self.start);
        self.force.distance_at_work(self.start, before, potential / self.c)
    }
}

/// A formula with drag, d = r^m: m = 1 for a formula of d; for one of √d m = 2, or 4 where the drag goes with √f', that is
/// with d^¼.
#[derive(Debug, Clone, Copy)]
pub struct DraggedCurve<const M: u8> {
    force: Smooth,
    start: f64,
    factor: f64,
    drag: Drag,
    pull: f64,
}

impl<const M: u8> DraggedCurve<M> {
    /// The formula with the pull and the drag of a path.
    pub fn along(force: Smooth, start: f64, factor: f64, path: &Path) -> Self {
        Self { force, start, factor, drag: path.drag, pull: path.pull }
    }

    /// The argument of the formula at r.
    fn argument(&self, r: f64) -> f64 {
        match M {
            1 => self.start + r,
            2 => r.abs(),
            _ => r * r,
        }
    }

    /// dd/dr = m r^(m−1), which is also dt/dσ.
    fn clock(r: f64) -> f64 {
        f64::from(M) * powi(r, i32::from(M) - 1)
    }

    /// The force and its first two derivatives in d at r.
    fn derivatives(&self, r: f64) -> [f64; 3] {
        let root = self.argument(r);
        let jet = self.force.jet(root);
        let [f, s, k] = [jet.value, jet.slope, jet.curvature].map(|part| self.factor * part);
        match M {
            1 => [f, s, k],
            _ if root > 0.0 => [f, s / (2.0 * root), (k - s / root) / (4.0 * root * root)],
            _ => [f, 0.5 * k, 0.0],
        }
    }
}

impl<const M: u8> Motion for DraggedCurve<M> {
    fn rates(&self, y: f64, u: f64) -> Quad {
        let [of_jet, s, _] = if self.drag.needs_slope() { self.derivatives(y) } else { [0.0; 3] };
        let f = match M {
            2.. if self.drag.needs_slope() => of_jet,
            _ => self.factor * self.force.at_variable(self.argument(y)),
        };
        let (in_contact, on_motion) = self.drag.at(f, || s);
        let (clock, drag) = (Self::clock(y), (in_contact + on_motion) * u);
        [u, clock * (self.pull - f - drag), clock, clock * (drag * u)]
    }
}

impl<const M: u8> Dragged for DraggedCurve<M> {
    const ROOT: i32 = M as i32;
    fn frequency(&self, y: f64) -> f64 {
        let m = f64::from(M);
        let [f, s, _] = self.derivatives(y);
        // √ of about −du'/dr
        let square = match M {
            1 => s,
            _ => m * powi(y, i32::from(M) - 2) * ((m - 1.0) * f + m * powi(y, i32::from(M)) * s),
        };
        square.max(f64::MIN_POSITIVE).sqrt()
    }
}
