//! Pieces that are neither powers nor straight lines: a formula that is smooth in d, or in √d, without drag.

use super::{Field, Variables};
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
            self.force.distance_at_work(0.0, 2.0 * potential / self.c, 0.0).sqrt()
        } else {
            self.force.distance_at_work(self.start, potential / self.c, 0.0)
        }
    }
}
