//! A straight piece: g = a + b d.

use super::{Dragged, DraggedState, Field};
use crate::numerics::ode::{Drag, Path};

/// Without drag: g = −(a + b y), y = d. A pull is part of a, which may then be negative.
#[derive(Debug, Clone, Copy)]
pub struct Straight<const PULLED: bool> {
    pub a: f64,
    pub b: f64,
}

impl<const PULLED: bool> Straight<PULLED> {
    #[inline(always)]
    pub fn new(at_start: f64, slope: f64, pull: f64) -> Self {
        Self { a: at_start - pull, b: slope }
    }
}

impl<const PULLED: bool> Field for Straight<PULLED> {
    const IS_TIME: bool = true;
    const IS_POLYNOMIAL: bool = true;
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
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
    fn at_potential(self, potential: f64) -> f64 {
        let root = (self.a * self.a + 2.0 * self.b * potential).max(0.0).sqrt();
        if PULLED && self.a <= 0.0 { (root - self.a) / self.b } else { 2.0 * potential / (self.a + root) }
    }
}

/// With drag: d'' = γ − (a + b d)(1 + χ u) − c u, where c = η √b + θ b.
#[derive(Debug, Clone, Copy)]
pub struct DraggedStraight {
    pub a: f64,
    pub b: f64,
    pub chi: f64,
    pub c: f64,
    /// η √b, the part of c that is in the contact.
    pub in_contact: f64,
    pub pull: f64,
}

impl DraggedStraight {
    /// The piece a + b d with the pull and the drag of a path.
    pub fn along(a: f64, b: f64, path: &Path) -> Self {
        let Drag { chi, eta, theta } = path.drag;
        let in_contact = eta * b.sqrt();
        Self { a, b, chi, c: in_contact + theta * b, in_contact, pull: path.pull }
    }
}

impl Dragged for DraggedStraight {
    const ROOT: i32 = 1;
    #[inline(always)]
    fn rates(&self, y: f64, u: f64) -> DraggedState {
        let force = self.a + self.b * y;
        let drag = (force * self.chi + self.c) * u;
        [u, self.pull - force - drag, 1.0, drag * u]
    }
}
