//! Pieces without drag that are neither powers nor straight lines.

use super::Field;
use crate::numerics::curve::polynomial::Poly;
use crate::numerics::curve::unloading_curve::Branch;

/// A polynomial: y = d and g = −c f.
#[derive(Debug, Clone, Copy)]
pub struct Polynomial {
    pub force: Poly,
    pub c: f64,
}

impl Field for Polynomial {
    const IS_TIME: bool = true;
    const IS_POLYNOMIAL: bool = false;
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        -self.c * self.force.force(y)
    }
    fn derivatives(self, y: f64) -> (f64, f64) {
        let [_, slope, curvature] = self.force.jet(y);
        (-self.c * slope, -self.c * curvature)
    }
    fn potential(self, y: f64) -> f64 {
        self.c * self.force.work(y)
    }
    fn at_potential(self, potential: f64) -> f64 {
        self.force.turn(potential / self.c, 0.0)
    }
}

/// An unloading branch, smooth in y = √d: g = −c |y| f, with c twice its factor.
#[derive(Debug, Clone, Copy)]
pub struct Root {
    pub branch: Branch,
    pub c: f64,
}

impl Field for Root {
    const IS_TIME: bool = false;
    const IS_POLYNOMIAL: bool = true;
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    fn g(self, y: f64) -> f64 {
        -self.c * y.abs() * self.branch.at(y * y).0[0]
    }
    fn derivatives(self, y: f64) -> (f64, f64) {
        let ([f, slope, curvature], square) = (self.branch.at(y * y).0, y * y);
        if square == 0.0 {
            return (0.0, 0.0);
        }
        (
            -self.c * (f + 2.0 * square * slope) * y.signum(),
            -self.c * y.abs() * (6.0 * slope + 4.0 * square * curvature),
        )
    }
    fn potential(self, y: f64) -> f64 {
        0.5 * self.c * self.branch.at(y * y).1
    }
    fn at_potential(self, potential: f64) -> f64 {
        self.branch.turn(2.0 * potential / self.c, 0.0).sqrt()
    }
}
