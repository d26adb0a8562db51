//! A loading curve as a list of smooth [`Piece`]s.
//!
//! Everything here is dimensionless: indentation x = δ/L, force f = F/Φ, work w = W/(Φ L), where L and Φ are the yield
//! indentation and force (or, for an elastic impact, the Hertz peak).

use super::crossing::{self, Crossing};
use super::piece::{Piece, Shape};
use crate::math::power::power;
use crate::math::smooth::Smooth;

/// An increasing loading curve from (0, 0) on; its last piece has no end. Where a published law jumps, the next piece begins
/// with another force; the work is continuous.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub(super) pieces: Vec<Piece>,
    /// Knots with a series for the time to them; none but on a curve of many pieces.
    pub(super) crossings: Vec<Crossing>,
    /// The pieces whose work costs an integration, in parts over which one panel of the rule is enough.
    parts: Vec<Piece>,
}

/// Largest ratio of the ends of a part.
const PART: f64 = 4.0;

impl Curve {
    /// f = x^1.5 without end (Hertz in units of any point of the curve).
    pub fn hertz() -> Self {
        Self::of(Vec::new()).then(0.0, 0.0, Shape::power(1.0, 1.5))
    }

    /// f = s x without end.
    pub fn straight(slope: f64) -> Self {
        Self::of(Vec::new()).then_straight(0.0, slope)
    }

    /// The curve of these pieces.
    pub(super) fn of(pieces: Vec<Piece>) -> Self {
        Self { pieces, crossings: Vec::new(), parts: Vec::new() }
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

    /// The same curve, going on from `start` as k x^n; the force may jump there.
    #[must_use]
    pub fn then_power(self, start: f64, stiffness: f64, exponent: f64) -> Self {
        self.then(start, stiffness * power(start, exponent), Shape::power(stiffness, exponent).later(start))
    }

    /// The same curve, going on from `start` as a formula says; the force may jump there.
    #[must_use]
    pub fn then_smooth(self, start: f64, smooth: Smooth) -> Self {
        self.then(start, smooth.value(start, 0.0), Shape::Smooth(smooth))
    }

    /// The same curve with series for the time to its knots (see [`crossing::crossings`]).
    #[must_use]
    pub(super) fn with_crossings(mut self) -> Self {
        self.crossings = crossing::crossings(&self.pieces);
        self
    }

    /// The same curve with the work at the ends of panels, so that work further on, and the way that a work goes, cost one panel
    /// each and not one for every factor of four from the start of the piece.
    #[must_use]
    pub(super) fn with_parts(mut self) -> Self {
        for (index, piece) in self.pieces.iter().enumerate() {
            let end = self.pieces.get(index + 1).map_or(piece.start, |next| next.start);
            if !matches!(piece.shape, Shape::Smooth(smooth) if smooth.is_integrated()) {
                continue;
            }
            let mut part = *piece;
            while part.start < end {
                self.parts.push(part);
                let start = PART * part.start;
                part = Piece { start, force: part.force_at(start), work: part.work_at(start), ..part };
            }
        }
        self
    }

    /// The part of a piece, or the piece itself, on which `is_before` turns from true to false.
    fn part_of<'a>(&'a self, piece: &'a Piece, is_before: impl Fn(&Piece) -> bool) -> &'a Piece {
        let last = self.parts.partition_point(|part| part.start <= piece.start || is_before(part));
        let of_piece = |part: &&Piece| {
            matches!(piece.shape, Shape::Smooth(_)) && part.start >= piece.start && part.shape == piece.shape
        };
        last.checked_sub(1).map(|last| &self.parts[last]).filter(of_piece).unwrap_or(piece)
    }

    /// The distance from the start of a piece at which the work reaches `work`, see [`Piece::distance_at_work`].
    pub(crate) fn distance_at_work(&self, index: usize, work: f64) -> f64 {
        let piece = &self.pieces[index];
        let part = self.part_of(piece, |part| part.work <= work);
        (part.start - piece.start) + part.distance_at_work(work)
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
        /// Pieces without a jump meet with an error of rounding, or of the search for their crossing.
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
        let piece = &self.pieces[self.index_at(x)];
        self.part_of(piece, |part| part.start <= x).work_at(x)
    }

    /// The last knot that a sphere of this energy and speed reaches fast enough for its series: the index of the piece that
    /// begins there, and the time from first touch. Without such a knot, the start of the curve.
    #[inline(always)]
    pub(crate) fn crossed(&self, kinetic: f64, speed: f64) -> (usize, f64) {
        let fast = self.crossings.partition_point(|knot| knot.is_good(kinetic));
        fast.checked_sub(1).map_or((0, 0.0), |last| self.crossings[last].reached(kinetic, speed))
    }
}
