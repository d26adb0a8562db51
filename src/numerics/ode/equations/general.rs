//! Pieces without drag that are neither powers nor straight lines.

use super::NystromEquation;
use crate::numerics::curve::polynomial::FittedPolynomial;
use crate::numerics::curve::unloading_curve::UnloadingCurve;

/// A polynomial: y = d and g = −c f.
#[derive(Debug, Clone, Copy)]
pub struct PolynomialEquation {
    pub force: FittedPolynomial,
    pub c: f64,
}

impl NystromEquation for PolynomialEquation {
    const USES_PLAIN_VARIABLES: bool = true;
    const IS_SMOOTH_AT_ZERO: bool = false;
    #[inline(always)]
    fn scale_by(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        -self.c * self.force.force(y)
    }
    fn derivatives(self, y: f64) -> (f64, f64) {
        let [_, slope, curvature] = self.force.derivatives(y);
        (-self.c * slope, -self.c * curvature)
    }
    fn potential(self, y: f64) -> f64 {
        self.c * self.force.work(y)
    }
    fn y_at_potential(self, potential: f64) -> f64 {
        self.force.turning_distance(potential / self.c, 0.0)
    }
}

/// An unloading branch, smooth in y = √d: g = −c |y| f, with c twice its factor.
#[derive(Debug, Clone, Copy)]
pub struct SqrtBranchEquation {
    pub branch: UnloadingCurve,
    pub c: f64,
}

impl NystromEquation for SqrtBranchEquation {
    const USES_PLAIN_VARIABLES: bool = false;
    const IS_SMOOTH_AT_ZERO: bool = true;
    fn scale_by(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    fn g(self, y: f64) -> f64 {
        -self.c * y.abs() * self.branch.derivatives_and_work(y * y).0[0]
    }
    fn derivatives(self, y: f64) -> (f64, f64) {
        let ([f, slope, curvature], square) = (self.branch.derivatives_and_work(y * y).0, y * y);
        if square == 0.0 {
            return (0.0, 0.0);
        }
        (
            -self.c * (f + 2.0 * square * slope) * y.signum(),
            -self.c * y.abs() * (6.0 * slope + 4.0 * square * curvature),
        )
    }
    fn potential(self, y: f64) -> f64 {
        0.5 * self.c * self.branch.derivatives_and_work(y * y).1
    }
    fn y_at_potential(self, potential: f64) -> f64 {
        self.branch.turning_distance(2.0 * potential / self.c, 0.0).sqrt()
    }
}
