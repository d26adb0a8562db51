//! A force over a distance as a list of smooth [`Piece`]s, without any mechanics: force, work, and the ways and times of a
//! motion that only this force acts on.
//!
//! Everything here is dimensionless. For a contact law x = δ/L is the indentation, f = F/Φ the force and w = W/(Φ L) the work,
//! where L and Φ are the yield indentation and force (or, for an elastic impact, the Hertz peak).

pub mod piece;
pub mod polynomial;
pub(crate) mod transit;
pub mod unloading_curve;

use std::sync::{Arc, OnceLock};

use crate::numerics::functions::{ln, pow};
use crate::numerics::power::power;
use piece::{Piece, Shape, linear_force_and_work};
use polynomial::FittedPolynomial;
use transit::{Transit, TransitSeries};

/// An increasing and continuous loading curve from (0, 0) on; its last piece has no end.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadingCurve {
    pub(crate) pieces: Vec<Piece>,
    /// Knots with a series for the time to them; none but on a curve of many pieces. They are made when the first closed form asks
    /// for them; a contact that is integrated needs none.
    transit_series: Option<Cached<TransitSeries>>,
}

/// A value that follows from the other fields of its struct. It is computed when it is first needed.
#[derive(Debug, Clone)]
pub struct Cached<T>(pub(crate) OnceLock<T>);

impl<T> Default for Cached<T> {
    fn default() -> Self {
        Self(OnceLock::new())
    }
}

impl<T> PartialEq for Cached<T> {
    /// It makes no difference whether it is made already.
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl LoadingCurve {
    /// f = x^1.5 without end (Hertz in units of any point of the curve).
    pub fn hertz() -> Self {
        Self::new(Vec::new()).push_piece(0.0, 0.0, Shape::power(1.0, 1.5))
    }

    /// f = s x without end.
    pub fn linear(slope: f64) -> Self {
        Self::new(Vec::new()).then_line(0.0, slope)
    }

    pub(crate) fn new(pieces: Vec<Piece>) -> Self {
        Self { pieces, transit_series: None }
    }

    /// Lets the curve go on from `start` (beyond all starts so far) as a straight line.
    pub fn then_line(self, start: f64, slope: f64) -> Self {
        self.then_lines([(start, slope)].into_iter())
    }

    /// Lets the curve go on as straight lines, each from its start on with its slope.
    pub fn then_lines(mut self, lines: impl Iterator<Item = (f64, f64)>) -> Self {
        self.pieces.reserve(lines.size_hint().0);
        let [mut force, mut work, mut from] = [0.0; 3];
        let mut before = None;
        for (start, slope) in lines {
            let distance = start - from;
            [force, work] = match (before, self.pieces.last()) {
                (Some(slope), _) => linear_force_and_work(slope, [force, work], distance),
                (None, Some(last)) => [last.force_at(start), last.work_at(start)],
                (None, None) => [0.0; 2],
            };
            self.pieces.push(Piece { start, force, work, is_subdivision: false, shape: Shape::linear(slope) });
            (before, from) = (Some(slope), start);
        }
        self
    }

    /// Lets the curve go on from a point (x, f) in straight lines through others.
    pub fn then_points(self, [mut start, mut force]: [f64; 2], points: impl Iterator<Item = [f64; 2]>) -> Self {
        self.then_lines(points.map(|[x, to]| {
            let line = (start, (to - force) / (x - start));
            [start, force] = [x, to];
            line
        }))
    }

    /// Lets the curve go on from `start` as k x^n.
    pub fn then_power(self, start: f64, stiffness: f64, exponent: f64) -> Self {
        self.push_piece(start, stiffness * power(start, exponent), Shape::power(stiffness, exponent).with_shift(start))
    }

    /// Continues the curve from `start` to `end` by a formula, as one polynomial for every octave of the distance from `pole`. The
    /// nearest singular point of the formula is `pole` < `start`. The formula is evaluated up to 3 % of that distance outside of
    /// `start` and `end`.
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few octaves
    pub fn then_fitted(mut self, start: f64, end: f64, pole: f64, formula: impl Fn(f64) -> f64) -> Self {
        let whole = (end - pole) / (start - pole);
        let count = (ln(whole) / std::f64::consts::LN_2).ceil().clamp(1.0, 2048.0);
        let ratio = pow(whole, 1.0 / count);
        let mut from = start;
        for number in 1..=count as usize {
            let to = if number == count as usize { end } else { pole + (from - pole) * ratio };
            let poly = FittedPolynomial::fit(&formula, from, to, pole);
            self = self.push_piece(from, poly.force(0.0), Shape::Polynomial(Arc::new(poly)));
            if let Some(piece) = self.pieces.last_mut() {
                piece.is_subdivision = number > 1;
            }
            from = to;
        }
        self
    }

    /// Gives the curve series for the time to its knots (see [`transit`]).
    pub(crate) fn with_transit_series(mut self) -> Self {
        self.transit_series = Some(Cached::default());
        self
    }

    /// True if some pieces are polynomials, fitted to a formula.
    pub(crate) fn has_polynomial_pieces(&self) -> bool {
        self.pieces.iter().any(|piece| matches!(piece.shape, Shape::Polynomial(_)))
    }

    fn push_piece(mut self, start: f64, force: f64, shape: Shape) -> Self {
        let work = self.pieces.last().map_or(0.0, |last| last.work_at(start));
        self.pieces.push(Piece { start, force, work, is_subdivision: false, shape });
        self
    }

    /// Lets the curve go on from `start` along its tangent there.
    pub fn then_tangent(self, start: f64) -> Self {
        let slope = self.pieces.last().map_or(1.0, |last| last.slope_at(start));
        self.then_line(start, slope)
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

    pub fn force(&self, x: f64) -> f64 {
        self.pieces[self.index_at(x)].force_at(x)
    }

    /// The x at which the force is `force` ≥ 0.
    pub(crate) fn indentation_at_force(&self, force: f64) -> f64 {
        let index = self.pieces.partition_point(|piece| piece.force <= force).saturating_sub(1);
        self.pieces[index].indentation_at_force(force)
    }

    /// Work from first contact to x.
    pub fn work(&self, x: f64) -> f64 {
        self.pieces[self.index_at(x)].work_at(x)
    }

    /// Time and work at the last knot whose series converges for a sphere of this kinetic energy and speed. Without such a knot, the
    /// start of the curve.
    #[inline(always)]
    pub(crate) fn transit(&self, kinetic: f64, speed: f64) -> Transit {
        let start = Transit { piece: 0, work: 0.0, time: 0.0 };
        let Some(Cached(series)) = &self.transit_series else { return start };
        let crossings = series.get_or_init(|| TransitSeries::new(&self.pieces));
        crossings.last_knot(&self.pieces, kinetic).map_or(start, |knot| knot.transit(kinetic, speed))
    }
}
