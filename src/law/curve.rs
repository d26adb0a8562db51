//! A loading curve as a list of smooth pieces: power (Hertz) and straight, with force and work in closed form, and any other
//! smooth force by its formula.
//!
//! Everything here is dimensionless: indentation x = δ/L, force f = F/Φ, work w = W/(Φ L), where L and Φ are the yield
//! indentation and force (or, for an elastic impact, the Hertz peak).

use crate::power::power;
use crate::smooth::Smooth;

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
    #[inline]
    #[must_use]
    pub fn force_at(&self, x: f64) -> f64 {
        let d = x - self.start;
        match self.shape {
            Shape::Power { stiffness, exponent } => stiffness * power(d, exponent),
            Shape::Straight { slope, .. } => self.force + slope * d,
            Shape::Smooth(smooth) => smooth.value(self.start, d),
        }
    }

    /// df/dx at x, the tangent stiffness.
    #[must_use]
    pub fn slope_at(&self, x: f64) -> f64 {
        match self.shape {
            Shape::Power { stiffness, exponent } => stiffness * exponent * power(x - self.start, exponent - 1.0),
            Shape::Straight { slope, .. } => slope,
            Shape::Smooth(smooth) => smooth.slope(self.start, x - self.start),
        }
    }

    /// Work from first touch to x.
    #[inline]
    #[must_use]
    pub fn work_at(&self, x: f64) -> f64 {
        let d = x - self.start;
        match self.shape {
            Shape::Power { stiffness, exponent } => self.work + stiffness * power(d, exponent) * d / (exponent + 1.0),
            Shape::Straight { slope, .. } => self.work + d * (self.force + 0.5 * slope * d),
            Shape::Smooth(smooth) => self.work + smooth.work(self.start, 0.0, d),
        }
    }

    /// The x at which the work reaches `work` (≥ the work at the start): the inverse of [`Piece::work_at`].
    #[inline]
    #[must_use]
    pub fn indentation_at_work(&self, work: f64) -> f64 {
        let rest = work - self.work;
        self.start
            + match self.shape {
                Shape::Power { stiffness, exponent } => {
                    ((exponent + 1.0) / stiffness * rest).powf(1.0 / (exponent + 1.0))
                }
                // the root of ½ s d² + f_i d = rest, in the form that does not cancel
                Shape::Straight { slope, .. } => {
                    2.0 * rest / (self.force + (self.force * self.force + 2.0 * slope * rest).sqrt())
                }
                Shape::Smooth(smooth) => smooth.distance_at_work(self.start, self.work, rest),
            }
    }
}

/// An increasing loading curve from (0, 0) on; its last piece has no end. Where a published law jumps, the next piece begins
/// with another force; the work is continuous.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pieces: Vec<Piece>,
}

impl Curve {
    /// f = x^1.5 without end (Hertz in units of any point of the curve).
    #[must_use]
    pub fn hertz() -> Self {
        let shape = Shape::Power { stiffness: 1.0, exponent: 1.5 };
        Self { pieces: vec![Piece { start: 0.0, force: 0.0, work: 0.0, shape }] }
    }

    /// f = s x without end.
    #[must_use]
    pub fn straight(slope: f64) -> Self {
        Self { pieces: Vec::with_capacity(1) }.then_straight(0.0, slope)
    }

    /// The same curve, going on from `start` (beyond all starts so far) as a straight line.
    #[must_use]
    pub fn then_straight(self, start: f64, slope: f64) -> Self {
        let force = self.pieces.last().map_or(0.0, |last| last.force_at(start));
        self.then_straight_from(start, force, slope)
    }

    /// The same curve, going on from (`start`, `force`) as a straight line.
    #[must_use]
    pub fn then_straight_from(mut self, start: f64, force: f64, slope: f64) -> Self {
        let work = self.pieces.last().map_or(0.0, |last| last.work_at(start));
        self.pieces.push(Piece {
            start,
            force,
            work,
            shape: Shape::Straight { slope, inverse_root: 1.0 / slope.sqrt() },
        });
        self
    }

    /// The same curve, going on from `start` as a formula says; the force may jump there.
    #[must_use]
    pub fn then_smooth(mut self, start: f64, smooth: Smooth) -> Self {
        let work = self.pieces.last().map_or(0.0, |last| last.work_at(start));
        self.pieces.push(Piece { start, force: smooth.value(start, 0.0), work, shape: Shape::Smooth(smooth) });
        self
    }

    /// The same curve, going on from `start` along its tangent there.
    #[must_use]
    pub fn then_tangent(self, start: f64) -> Self {
        let slope = self.pieces.last().map_or(1.0, |last| last.slope_at(start));
        self.then_straight(start, slope)
    }

    /// The pieces in order; never empty.
    #[must_use]
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Index of the piece that holds at x (at a knot: the one that begins there).
    #[must_use]
    pub fn index_at(&self, x: f64) -> usize {
        self.pieces.partition_point(|piece| piece.start <= x).saturating_sub(1)
    }

    /// Force at x.
    #[must_use]
    pub fn force(&self, x: f64) -> f64 {
        self.pieces[self.index_at(x)].force_at(x)
    }

    /// Work from first touch to x.
    #[must_use]
    pub fn work(&self, x: f64) -> f64 {
        self.pieces[self.index_at(x)].work_at(x)
    }
}
