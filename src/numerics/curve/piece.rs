//! One smooth piece of a loading curve: a power law (Hertz), a straight line, a polynomial that stands for any other formula,
//! or an unloading branch that is no power. Each function is written once for each shape, of the distance from the start of the
//! piece: close to a start far from zero this distance has digits that x has lost.

use std::sync::Arc;

use super::polynomial::FittedPolynomial;
use super::unloading_curve::UnloadingCurve;
use crate::numerics::functions::{exp_m1, ln_1p, pow};
use crate::numerics::power::{power, power_turning_distance, work_factor};
use crate::numerics::root::newton_convex;

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
    Linear {
        /// s > 0.
        slope: f64,
        /// 1/√s, for the times on the piece.
        inverse_root: f64,
    },
    /// Any other smooth and increasing force, on an interval.
    Polynomial(Arc<FittedPolynomial>),
    /// An unloading branch, from its zero on.
    Unloading(UnloadingCurve),
}

impl Shape {
    /// f = k d^n.
    pub const fn power(stiffness: f64, exponent: f64) -> Self {
        Self::Power { stiffness, exponent, offset: 0.0 }
    }

    /// f = f_i + s d.
    #[inline]
    pub(super) fn linear(slope: f64) -> Self {
        Self::Linear { slope, inverse_root: 1.0 / slope.sqrt() }
    }

    /// Returns this force on a piece whose start is moved by the distance `by`. An unloading branch always starts at its zero and does
    /// not change.
    pub(crate) fn with_shift(&self, by: f64) -> Self {
        match self {
            Self::Power { stiffness, exponent, offset } => {
                Self::Power { stiffness: *stiffness, exponent: *exponent, offset: offset + by }
            }
            Self::Polynomial(poly) => Self::Polynomial(Arc::new(poly.with_shift(by))),
            same @ (Self::Linear { .. } | Self::Unloading(_)) => same.clone(),
        }
    }

    /// l: how far the zero of a power law lies before the start of its piece.
    #[inline]
    pub fn zero_offset(&self) -> f64 {
        if let Self::Power { offset, .. } = self { *offset } else { 0.0 }
    }
}

/// Force and work on a straight line, at a distance from where they are these.
#[inline(always)]
pub(super) fn linear_force_and_work(slope: f64, [force, work]: [f64; 2], distance: f64) -> [f64; 2] {
    [force + slope * distance, work + distance * (force + 0.5 * slope * distance)]
}

/// One smooth piece; it holds from `start` to the start of the next one.
#[derive(Debug, Clone, PartialEq)]
pub struct Piece {
    /// x_i where the piece begins.
    pub start: f64,
    /// f(x_i).
    pub force: f64,
    /// w(x_i), the work from first contact to here.
    pub work: f64,
    /// True if the formula of the piece before continues here, so that the start is no knot of the law.
    pub is_subdivision: bool,
    pub shape: Shape,
}

impl Piece {
    #[inline]
    pub fn force_at(&self, x: f64) -> f64 {
        self.force_at_distance(x - self.start)
    }

    /// The force at a distance from the start of the piece.
    #[inline(always)]
    pub fn force_at_distance(&self, distance: f64) -> f64 {
        match &self.shape {
            Shape::Power { stiffness, exponent, offset } => stiffness * power(distance + offset, *exponent),
            Shape::Linear { slope, .. } => linear_force_and_work(*slope, [self.force, self.work], distance)[0],
            Shape::Polynomial(poly) => poly.force(distance),
            Shape::Unloading(branch) => branch.derivatives_and_work(distance).0[0],
        }
    }

    /// f, df/dx and d²f/dx² at a distance from the start of the piece.
    #[inline]
    pub fn derivatives(&self, distance: f64) -> [f64; 3] {
        match &self.shape {
            Shape::Power { exponent: n, offset, .. } => {
                let (force, from_zero) = (self.force_at_distance(distance), distance + offset);
                [force, n * force / from_zero, n * (n - 1.0) * force / from_zero / from_zero]
            }
            Shape::Linear { slope, .. } => [self.force_at_distance(distance), *slope, 0.0],
            Shape::Polynomial(poly) => poly.derivatives(distance),
            Shape::Unloading(branch) => branch.derivatives_and_work(distance).0,
        }
    }

    /// df/dx at x, the tangent stiffness.
    pub fn slope_at(&self, x: f64) -> f64 {
        self.slope_at_distance(x - self.start)
    }

    /// df/dx at a distance from the start of the piece.
    #[inline]
    pub fn slope_at_distance(&self, distance: f64) -> f64 {
        match &self.shape {
            Shape::Power { stiffness, exponent, offset } => {
                stiffness * exponent * power(distance + offset, exponent - 1.0)
            }
            Shape::Linear { slope, .. } => *slope,
            Shape::Polynomial(_) | Shape::Unloading(_) => self.derivatives(distance)[1],
        }
    }

    /// Work from first contact to x.
    #[inline]
    pub fn work_at(&self, x: f64) -> f64 {
        self.work_at_distance(x - self.start)
    }

    /// Work from first contact to a distance from the start of the piece.
    #[inline]
    pub fn work_at_distance(&self, distance: f64) -> f64 {
        match &self.shape {
            Shape::Power { stiffness, exponent, offset } => {
                let from_zero = |d: f64| stiffness * power(d, *exponent) * d * work_factor(*exponent);
                let before = if *offset == 0.0 { 0.0 } else { from_zero(*offset) };
                self.work + (from_zero(distance + offset) - before)
            }
            Shape::Linear { slope, .. } => linear_force_and_work(*slope, [self.force, self.work], distance)[1],
            Shape::Polynomial(poly) => self.work + poly.work(distance),
            Shape::Unloading(branch) => self.work + branch.derivatives_and_work(distance).1,
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
            Shape::Linear { slope, .. } => (force - self.force) / slope,
            Shape::Polynomial(poly) => poly.distance_at_force(force),
            Shape::Unloading(branch) => branch.distance_at_force(force),
        }
    }

    /// The x at which the work reaches `work` (≥ the work at the start): the inverse of [`Piece::work_at`].
    #[inline]
    pub fn indentation_at_work(&self, work: f64) -> f64 {
        self.start + self.turning_distance(work - self.work, 0.0)
    }

    /// The distance from the start of the piece to the turning point of a motion. The motion begins at the start with the kinetic
    /// energy `rest` ≥ 0, and a constant force `pull` ≥ 0 acts on it.
    #[inline(always)]
    pub(crate) fn turning_distance(&self, rest: f64, pull: f64) -> f64 {
        match &self.shape {
            Shape::Power { stiffness, exponent, offset: 0.0 } => {
                power_turning_distance(*stiffness, *exponent, rest, pull)
            }
            // the root of ½ s d² + (f_i − w) d = rest, in the form that does not cancel
            Shape::Linear { slope, .. } => {
                let net = self.force - pull;
                let root = (net * net + 2.0 * slope * rest).sqrt();
                if net > 0.0 || pull == 0.0 { 2.0 * rest / (net + root) } else { (root - net) / slope }
            }
            Shape::Polynomial(poly) => poly.turning_distance(rest, pull),
            Shape::Unloading(branch) => branch.turning_distance(rest, pull),
            Shape::Power { stiffness, exponent, offset } => {
                offset_power_turning_distance(*stiffness, *exponent, *offset, rest, pull)
            }
        }
    }
}

/// [`Piece::turning_distance`] of a power law whose zero lies `offset` before the start.
#[cold]
fn offset_power_turning_distance(stiffness: f64, exponent: f64, offset: f64, rest: f64, pull: f64) -> f64 {
    let p = exponent + 1.0;
    let before = stiffness * power(offset, exponent) * offset / p;
    if pull == 0.0 {
        // (d/l + 1)^(n+1) = 1 + rest over the work from the zero to the start, in the form that does not cancel
        return offset * exp_m1(ln_1p(rest / before) / p);
    }
    let from_zero = rest + before - pull * offset;
    // where the pull far exceeds the force at the start of the piece, this has lost digits, which Newton's method mends
    let above = power_turning_distance(stiffness, exponent, from_zero.max(0.0), pull);
    let d = newton_convex(above, |d| {
        let force = stiffness * power(d, exponent);
        (force * d / p - from_zero - pull * d) / (force - pull)
    });
    (d - offset).max(0.0)
}
