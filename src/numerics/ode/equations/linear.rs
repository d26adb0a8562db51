//! A straight piece: g = a + b d.

use super::{DampedEquation, DampedState, NystromEquation};
use crate::numerics::ode::{DampingCoefficients, LegProblem};

/// Without drag: g = −(a + b y), y = d. A pull is part of a, which may then be negative.
#[derive(Debug, Clone, Copy)]
pub struct LinearEquation<const PULLED: bool> {
    pub a: f64,
    pub b: f64,
}

impl<const PULLED: bool> LinearEquation<PULLED> {
    #[inline(always)]
    pub fn new(at_start: f64, slope: f64, pull: f64) -> Self {
        Self { a: at_start - pull, b: slope }
    }
}

impl<const PULLED: bool> NystromEquation for LinearEquation<PULLED> {
    const USES_PLAIN_VARIABLES: bool = true;
    const IS_SMOOTH_AT_ZERO: bool = true;
    #[inline(always)]
    fn scale_by(self, factor: f64) -> Self {
        Self { a: self.a * factor, b: self.b * factor }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        -(self.a + self.b * y)
    }
    #[inline(always)]
    fn derivatives(self, _: f64) -> (f64, f64) {
        (-self.b, 0.0)
    }
    #[inline(always)]
    fn potential(self, y: f64) -> f64 {
        y * (self.a + 0.5 * self.b * y)
    }
    #[inline(always)]
    fn y_at_potential(self, potential: f64) -> f64 {
        let root = (self.a * self.a + 2.0 * self.b * potential).max(0.0).sqrt();
        if PULLED && self.a <= 0.0 { (root - self.a) / self.b } else { 2.0 * potential / (self.a + root) }
    }
}

/// With drag: d'' = γ − (a + b d)(1 + χ u) − c u, where c = η √b + (κ + θ) b.
#[derive(Debug, Clone, Copy)]
pub struct DampedLinearEquation {
    pub a: f64,
    pub b: f64,
    pub chi: f64,
    pub c: f64,
    /// η √b + κ b, the part of c that is in the contact.
    pub in_contact: f64,
    pub pull: f64,
}

impl DampedLinearEquation {
    /// The piece a + b d with the pull and the drag of a path.
    pub fn from_leg(a: f64, b: f64, path: &LegProblem) -> Self {
        let DampingCoefficients { hunt_crossley: chi, viscous: eta, viscoelastic: kappa, plate: theta } = path.drag;
        let in_contact = eta * b.sqrt() + kappa * b;
        Self { a, b, chi, c: in_contact + theta * b, in_contact, pull: path.constant_acceleration }
    }
}

impl DampedEquation for DampedLinearEquation {
    const VARIABLE_ROOT: i32 = 1;
    #[inline(always)]
    fn rates(&self, y: f64, u: f64) -> DampedState {
        let force = self.a + self.b * y;
        let drag = (force * self.chi + self.c) * u;
        [u, self.pull - force - drag, 1.0, drag * u]
    }
}
