//! A loading curve as a list of smooth pieces: power (Hertz) and straight, with force and work in closed form, and any other
//! smooth force by its formula.
//!
//! Everything here is dimensionless: indentation x = δ/L, force f = F/Φ, work w = W/(Φ L), where L and Φ are the yield
//! indentation and force (or, for an elastic impact, the Hertz peak).

use crate::math::functions::{exp_m1, ln_1p, pow};
use crate::math::power::{power, work_share};
use crate::math::smooth::Smooth;

/// How the force goes on from the start of a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// f = k d^n with d = x − x_i measured from the start of the piece, where the force vanishes; Hertz is n = 3/2.
    Power {
        /// k > 0.
        stiffness: f64,
        /// n > 1.
        exponent: f64,
    },
    /// f = f_i + s d from the start (x_i, f_i) of the piece.
    Straight {
        /// s > 0.
        slope: f64,
        /// 1/√s, which every time on the piece needs.
        inverse_root: f64,
    },
    /// Anything else that is smooth and increases.
    Smooth(Smooth),
    /// f = k (d + l)^n: a power law that is entered beyond its zero, as by a reload that goes on along the loading curve.
    LatePower {
        /// k > 0.
        stiffness: f64,
        /// n > 1.
        exponent: f64,
        /// l > 0: how far the zero of the force lies before the start of the piece.
        lead: f64,
    },
}

impl Shape {
    /// l: how far the zero of a power law lies before the start of its piece.
    #[inline]
    pub fn lead(&self) -> f64 {
        match *self {
            Self::LatePower { lead, .. } => lead,
            Self::Power { .. } | Self::Straight { .. } | Self::Smooth(_) => 0.0,
        }
    }
}

/// One smooth piece; it holds from `start` to the start of the next one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// x_i where the piece begins.
    pub start: f64,
    /// f(x_i).
    pub force: f64,
    /// w(x_i), the work from first touch to here.
    pub work: f64,
    /// How it goes on.
    pub shape: Shape,
}

impl Piece {
    /// Force at x.
    #[inline(always)]
    pub fn force_at(&self, x: f64) -> f64 {
        let d = x - self.start;
        match self.shape {
            Shape::Power { stiffness, exponent } => stiffness * power(d, exponent),
            Shape::Straight { slope, .. } => self.force + slope * d,
            Shape::Smooth(smooth) => smooth.value(self.start, d),
            Shape::LatePower { stiffness, exponent, lead } => stiffness * power(d + lead, exponent),
        }
    }

    /// df/dx at x, the tangent stiffness.
    pub fn slope_at(&self, x: f64) -> f64 {
        self.slope_beyond(x - self.start)
    }

    /// The same at a distance from the start of the piece.
    pub(crate) fn slope_beyond(&self, distance: f64) -> f64 {
        match self.shape {
            Shape::Power { stiffness, exponent } => stiffness * exponent * power(distance, exponent - 1.0),
            Shape::Straight { slope, .. } => slope,
            Shape::Smooth(smooth) => smooth.slope(self.start, distance),
            Shape::LatePower { stiffness, exponent, lead } => {
                stiffness * exponent * power(distance + lead, exponent - 1.0)
            }
        }
    }

    /// Work from first touch to x.
    #[inline]
    pub fn work_at(&self, x: f64) -> f64 {
        let d = x - self.start;
        match self.shape {
            Shape::Power { stiffness, exponent } => {
                self.work + stiffness * power(d, exponent) * d * work_share(exponent)
            }
            Shape::Straight { slope, .. } => self.work + d * (self.force + 0.5 * slope * d),
            Shape::Smooth(smooth) => self.work + smooth.work(self.start, 0.0, d),
            Shape::LatePower { stiffness, exponent, lead } => {
                let from_zero = |d: f64| power(d, exponent) * d;
                self.work + stiffness * (from_zero(d + lead) - from_zero(lead)) / (exponent + 1.0)
            }
        }
    }

    /// The x at which the force is `force` (≥ the force at the start): the inverse of [`Piece::force_at`].
    pub(crate) fn indentation_at_force(&self, force: f64) -> f64 {
        self.start
            + match self.shape {
                Shape::Power { stiffness, exponent } => pow(force / stiffness, 1.0 / exponent),
                Shape::Straight { slope, .. } => (force - self.force) / slope,
                Shape::LatePower { stiffness, exponent, lead } => pow(force / stiffness, 1.0 / exponent) - lead,
                Shape::Smooth(smooth) => smooth.distance_at_force(self.start, force),
            }
    }

    /// The x at which the work reaches `work` (≥ the work at the start): the inverse of [`Piece::work_at`].
    #[inline]
    pub fn indentation_at_work(&self, work: f64) -> f64 {
        self.start + self.distance_at_work(work)
    }

    /// The same measured from the start of the piece: near a start far from zero it has digits that x has lost.
    #[inline(always)]
    pub(crate) fn distance_at_work(&self, work: f64) -> f64 {
        let rest = work - self.work;
        match self.shape {
            Shape::Power { stiffness, exponent } => pow((exponent + 1.0) / stiffness * rest, work_share(exponent)),
            // the root of ½ s d² + f_i d = rest, in the form that does not cancel
            Shape::Straight { slope, .. } => {
                2.0 * rest / (self.force + (self.force * self.force + 2.0 * slope * rest).sqrt())
            }
            Shape::Smooth(smooth) => smooth.distance_at_work(self.start, self.work, rest),
            // (d/l + 1)^(n+1) = 1 + rest over the work from the zero to the start, in the form that does not cancel
            Shape::LatePower { stiffness, exponent, lead } => {
                let before = stiffness * power(lead, exponent) * lead / (exponent + 1.0);
                lead * exp_m1(ln_1p(rest / before) / (exponent + 1.0))
            }
        }
    }
}

/// An increasing loading curve from (0, 0) on; its last piece has no end. Where a published law jumps, the next piece begins
/// with another force; the work is continuous.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub(super) pieces: Vec<Piece>,
}

impl Curve {
    /// f = x^1.5 without end (Hertz in units of any point of the curve).
    pub fn hertz() -> Self {
        Self { pieces: Vec::new() }.then(0.0, 0.0, Shape::Power { stiffness: 1.0, exponent: 1.5 })
    }

    /// f = s x without end.
    pub fn straight(slope: f64) -> Self {
        Self { pieces: Vec::new() }.then_straight(0.0, slope)
    }

    /// The same curve, going on from `start` (beyond all starts so far) as a straight line.
    #[must_use]
    pub fn then_straight(self, start: f64, slope: f64) -> Self {
        let force = self.pieces.last().map_or(0.0, |last| last.force_at(start));
        self.then_straight_from(start, force, slope)
    }

    /// The same curve, going on from (`start`, `force`) as a straight line.
    #[must_use]
    pub fn then_straight_from(self, start: f64, force: f64, slope: f64) -> Self {
        self.then(start, force, Shape::Straight { slope, inverse_root: 1.0 / slope.sqrt() })
    }

    /// The same curve, going on from `start` as a formula says; the force may jump there.
    #[must_use]
    pub fn then_smooth(self, start: f64, smooth: Smooth) -> Self {
        self.then(start, smooth.value(start, 0.0), Shape::Smooth(smooth))
    }

    fn then(mut self, start: f64, force: f64, shape: Shape) -> Self {
        let work = self.pieces.last().map_or(0.0, |last| last.work_at(start));
        self.pieces.push(Piece { start, force, work, shape });
        self
    }

    /// The same curve, going on from `start` along its tangent there.
    #[must_use]
    pub fn then_tangent(self, start: f64) -> Self {
        let slope = self.pieces.last().map_or(1.0, |last| last.slope_at(start));
        self.then_straight(start, slope)
    }

    /// x of the first jump of the force on the way to x; `None` if the force is continuous so far.
    pub(crate) fn jump_before(&self, x: f64) -> Option<f64> {
        /// Pieces that meet do so to rounding, or to the accuracy of a crossing that was searched for.
        const MEETS: f64 = 1e-9;
        let jumps = |pair: &&[Piece]| (pair[0].force_at(pair[1].start) - pair[1].force).abs() > MEETS * pair[1].force;
        self.pieces[..=self.index_at(x)].windows(2).find(jumps).map(|pair| pair[1].start)
    }

    /// The pieces in order; never empty.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Index of the piece that holds at x (at a knot: the one that begins there).
    pub fn index_at(&self, x: f64) -> usize {
        self.pieces.partition_point(|piece| piece.start <= x).saturating_sub(1)
    }

    /// Index of the piece on which the work reaches `work`.
    #[inline(always)]
    pub fn index_at_work(&self, work: f64) -> usize {
        self.pieces.partition_point(|piece| piece.work <= work).saturating_sub(1)
    }

    /// Force at x.
    pub fn force(&self, x: f64) -> f64 {
        self.pieces[self.index_at(x)].force_at(x)
    }

    /// The x at which the force is `force` ≥ 0.
    pub(crate) fn indentation_at_force(&self, force: f64) -> f64 {
        let index = self.pieces.partition_point(|piece| piece.force <= force).saturating_sub(1);
        let x = self.pieces[index].indentation_at_force(force);
        // no further than the piece goes
        self.pieces.get(index + 1).map_or(x, |next| x.min(next.start))
    }

    /// Work from first touch to x.
    pub fn work(&self, x: f64) -> f64 {
        self.pieces[self.index_at(x)].work_at(x)
    }
}
