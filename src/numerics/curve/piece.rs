//! One smooth piece of a loading curve: a power law (Hertz), a straight line, a polynomial that stands for any other formula,
//! or an unloading branch that is no power. Each function is written once for each shape, of the distance from the start of the
//! piece: close to a start far from zero this distance has digits that x has lost.

use std::sync::Arc;

use super::polynomial::Poly;
use super::unloading_curve::Branch;
use crate::numerics::functions::{exp_m1, ln_1p, pow};
use crate::numerics::power::{power, power_turn, work_share};
use crate::numerics::root::fallen_from;

/// How the force continues from the start of a piece.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// f = k (d + l)^n with d = x − x_i from the start of the piece; Hertz is n = 3/2.
    Power {
        /// k > 0.
        stiffness: f64,
        /// n ≥ 1.
        exponent: f64,
        /// l ≥ 0: how far the zero of the force lies before the start of the piece. It is 0 where the piece begins without
        /// force, and positive where the piece continues other pieces or begins in a dent.
        offset: f64,
    },
    /// f = f_i + s d from the start (x_i, f_i) of the piece.
    Straight {
        /// s > 0.
        slope: f64,
        /// 1/√s, for the times on the piece.
        inverse_root: f64,
    },
    /// Anything else that is smooth and increases, on a stretch.
    Polynomial(Arc<Poly>),
    /// An unloading branch, from its zero on.
    Branch(Branch),
}

impl Shape {
    /// f = k d^n.
    pub const fn power(stiffness: f64, exponent: f64) -> Self {
        Self::Power { stiffness, exponent, offset: 0.0 }
    }

    /// f = f_i + s d.
    #[inline]
    pub(super) fn straight(slope: f64) -> Self {
        Self::Straight { slope, inverse_root: 1.0 / slope.sqrt() }
    }

    /// Returns this force on a piece that starts so much later; a branch is not cut, as it begins at first touch.
    pub(crate) fn later(&self, by: f64) -> Self {
        match self {
            Self::Power { stiffness, exponent, offset } => {
                Self::Power { stiffness: *stiffness, exponent: *exponent, offset: offset + by }
            }
            Self::Polynomial(poly) => Self::Polynomial(Arc::new(poly.later(by))),
            same @ (Self::Straight { .. } | Self::Branch(_)) => same.clone(),
        }
    }

    /// l: how far the zero of a power law lies before the start of its piece.
    #[inline]
    pub fn offset(&self) -> f64 {
        if let Self::Power { offset, .. } = self { *offset } else { 0.0 }
    }
}

/// Force and work on a straight line, at a distance from where they are these.
#[inline(always)]
pub(super) fn along(slope: f64, [force, work]: [f64; 2], distance: f64) -> [f64; 2] {
    [force + slope * distance, work + distance * (force + 0.5 * slope * distance)]
}

/// One smooth piece; it holds from `start` to the start of the next one.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// x_i where the piece begins.
    pub start: f64,
    /// f(x_i).
    pub force: f64,
    /// w(x_i), the work from first touch to here.
    pub work: f64,
    /// True if the formula of the piece before continues here, so that the start is no knot of the law.
    pub is_joint: bool,
    pub shape: Shape,
}

impl Piece {
    #[inline]
    pub fn force_at(&self, x: f64) -> f64 {
        self.force_beyond(x - self.start)
    }

    /// The force at a distance from the start of the piece.
    #[inline(always)]
    pub fn force_beyond(&self, distance: f64) -> f64 {
        match &self.shape {
            Shape::Power { stiffness, exponent, offset } => stiffness * power(distance + offset, *exponent),
            Shape::Straight { slope, .. } => along(*slope, [self.force, self.work], distance)[0],
            Shape::Polynomial(poly) => poly.force(distance),
            Shape::Branch(branch) => branch.at(distance).0[0],
        }
    }

    /// f, df/dx and d²f/dx² at a distance from the start of the piece.
    #[inline]
    pub fn jet(&self, distance: f64) -> [f64; 3] {
        match &self.shape {
            Shape::Power { exponent: n, offset, .. } => {
                let (force, from_zero) = (self.force_beyond(distance), distance + offset);
                [force, n * force / from_zero, n * (n - 1.0) * force / from_zero / from_zero]
            }
            Shape::Straight { slope, .. } => [self.force_beyond(distance), *slope, 0.0],
            Shape::Polynomial(poly) => poly.jet(distance),
            Shape::Branch(branch) => branch.at(distance).0,
        }
    }

    /// df/dx at x, the tangent stiffness.
    pub fn slope_at(&self, x: f64) -> f64 {
        self.slope_beyond(x - self.start)
    }

    /// df/dx at a distance from the start of the piece.
    #[inline]
    pub fn slope_beyond(&self, distance: f64) -> f64 {
        match &self.shape {
            Shape::Power { stiffness, exponent, offset } => {
                stiffness * exponent * power(distance + offset, exponent - 1.0)
            }
            Shape::Straight { slope, .. } => *slope,
            Shape::Polynomial(_) | Shape::Branch(_) => self.jet(distance)[1],
        }
    }

    /// Work from first touch to x.
    #[inline]
    pub fn work_at(&self, x: f64) -> f64 {
        self.work_beyond(x - self.start)
    }

    /// Work from first touch to a distance from the start of the piece.
    #[inline]
    pub fn work_beyond(&self, distance: f64) -> f64 {
        match &self.shape {
            Shape::Power { stiffness, exponent, offset } => {
                let from_zero = |d: f64| stiffness * power(d, *exponent) * d * work_share(*exponent);
                let before = if *offset == 0.0 { 0.0 } else { from_zero(*offset) };
                self.work + (from_zero(distance + offset) - before)
            }
            Shape::Straight { slope, .. } => along(*slope, [self.force, self.work], distance)[1],
            Shape::Polynomial(poly) => self.work + poly.work(distance),
            Shape::Branch(branch) => self.work + branch.at(distance).1,
        }
    }

    /// The x at which the force is `force` (≥ the force at the start): the inverse of [`Piece::force_at`].
    pub fn indentation_at_force(&self, force: f64) -> f64 {
        self.start + self.distance_at_force(force)
    }

    /// The distance from the start of the piece at which the force is `force` (≥ the force at the start).
    pub fn distance_at_force(&self, force: f64) -> f64 {
        match &self.shape {
            Shape::Power { stiffness, exponent, offset } => pow(force / stiffness, 1.0 / exponent) - offset,
            Shape::Straight { slope, .. } => (force - self.force) / slope,
            Shape::Polynomial(poly) => poly.distance_at_force(force),
            Shape::Branch(branch) => branch.distance_at_force(force),
        }
    }

    /// The x at which the work reaches `work` (≥ the work at the start): the inverse of [`Piece::work_at`].
    #[inline]
    pub fn indentation_at_work(&self, work: f64) -> f64 {
        self.start + self.way_to_turn(work - self.work, 0.0)
    }

    /// The distance from the start of the piece to where a motion turns that begins there with the energy `rest` ≥ 0, pulled by
    /// a constant force `pull` ≥ 0.
    #[inline(always)]
    pub(crate) fn way_to_turn(&self, rest: f64, pull: f64) -> f64 {
        match &self.shape {
            Shape::Power { stiffness, exponent, offset: 0.0 } => power_turn(*stiffness, *exponent, rest, pull),
            // the root of ½ s d² + (f_i − w) d = rest, in the form that does not cancel
            Shape::Straight { slope, .. } => {
                let net = self.force - pull;
                let root = (net * net + 2.0 * slope * rest).sqrt();
                if net > 0.0 || pull == 0.0 { 2.0 * rest / (net + root) } else { (root - net) / slope }
            }
            Shape::Polynomial(poly) => poly.turn(rest, pull),
            Shape::Branch(branch) => branch.turn(rest, pull),
            Shape::Power { stiffness, exponent, offset } => late_turn(*stiffness, *exponent, *offset, rest, pull),
        }
    }
}

/// [`Piece::way_to_turn`] of a power law whose zero lies `offset` before the start.
#[cold]
fn late_turn(stiffness: f64, exponent: f64, offset: f64, rest: f64, pull: f64) -> f64 {
    let p = exponent + 1.0;
    let before = stiffness * power(offset, exponent) * offset / p;
    if pull == 0.0 {
        // (d/l + 1)^(n+1) = 1 + rest over the work from the zero to the start, in the form that does not cancel
        return offset * exp_m1(ln_1p(rest / before) / p);
    }
    let from_zero = rest + before - pull * offset;
    // where the pull far exceeds the force at the start of the piece, this has lost digits, which Newton's method mends
    let above = power_turn(stiffness, exponent, from_zero.max(0.0), pull);
    let d = fallen_from(above, |d| {
        let force = stiffness * power(d, exponent);
        (force * d / p - from_zero - pull * d) / (force - pull)
    });
    (d - offset).max(0.0)
}
