//! A loading curve as a list of smooth pieces: power (Hertz) and straight, each with force and work in closed form.
//!
//! Everything here is dimensionless: indentation x = δ/L, force f = F/Φ, work w = W/(Φ L), where L and Φ are the yield
//! indentation and force (or, for an elastic impact, the Hertz peak).

use crate::power::power;

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
        }
    }

    /// df/dx at x, the tangent stiffness.
    #[must_use]
    pub fn slope_at(&self, x: f64) -> f64 {
        match self.shape {
            Shape::Power { stiffness, exponent } => stiffness * exponent * power(x - self.start, exponent - 1.0),
            Shape::Straight { slope, .. } => slope,
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
        }
    }

    /// The x at which the force is `force` (≥ the force at the start): the inverse of [`Piece::force_at`].
    #[must_use]
    pub fn indentation_at_force(&self, force: f64) -> f64 {
        self.start
            + match self.shape {
                Shape::Power { stiffness, exponent } => (force / stiffness).powf(1.0 / exponent),
                Shape::Straight { slope, .. } => (force - self.force) / slope,
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
            }
    }
}

/// A continuous, increasing loading curve from (0, 0) on; its last piece has no end.
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

    /// The same curve, going on from `start` (beyond all starts so far) as a straight line.
    #[must_use]
    pub fn then_straight(mut self, start: f64, slope: f64) -> Self {
        let (force, work) = self.pieces.last().map_or((0.0, 0.0), |last| (last.force_at(start), last.work_at(start)));
        self.pieces.push(Piece {
            start,
            force,
            work,
            shape: Shape::Straight { slope, inverse_root: 1.0 / slope.sqrt() },
        });
        self
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

    /// The x at which the force is `force` ≥ 0.
    #[must_use]
    pub fn indentation_at_force(&self, force: f64) -> f64 {
        let index = self.pieces.partition_point(|piece| piece.force <= force).saturating_sub(1);
        let x = self.pieces[index].indentation_at_force(force);
        // no further than the piece goes
        self.pieces.get(index + 1).map_or(x, |next| x.min(next.start))
    }

    /// Work from first touch to x.
    #[must_use]
    pub fn work(&self, x: f64) -> f64 {
        self.pieces[self.index_at(x)].work_at(x)
    }
}
