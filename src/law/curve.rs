//! A loading curve as a list of smooth [`Piece`]s.
//!
//! Everything here is dimensionless: indentation x = δ/L, force f = F/Φ, work w = W/(Φ L), where L and Φ are the yield
//! indentation and force (or, for an elastic impact, the Hertz peak).

use super::crossing::{self, Crossing, Reached};
use super::panel::{self, Panel, panels};
use super::piece::{Piece, Shape};
use crate::math::power::power;
use crate::math::smooth::Smooth;

/// An increasing and continuous loading curve from (0, 0) on; its last piece has no end.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    pub(super) pieces: Vec<Piece>,
    /// Knots with a series for the time to them; none but on a curve of many pieces.
    pub(super) crossings: Vec<Crossing>,
    /// The pieces that are formulas, as polynomials.
    panels: Vec<Panel>,
}

impl Curve {
    /// f = x^1.5 without end (Hertz in units of any point of the curve).
    pub fn hertz() -> Self {
        Self::of(Vec::new()).then(0.0, 0.0, Shape::power(1.0, 1.5))
    }

    /// f = s x without end.
    pub fn straight(slope: f64) -> Self {
        Self::of(Vec::new()).then_straight(0.0, slope)
    }

    pub(super) fn of(pieces: Vec<Piece>) -> Self {
        Self { pieces, crossings: Vec::new(), panels: Vec::new() }
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

    /// The same curve, going on from `start` as k x^n.
    #[must_use]
    pub fn then_power(self, start: f64, stiffness: f64, exponent: f64) -> Self {
        self.then(start, stiffness * power(start, exponent), Shape::power(stiffness, exponent).later(start))
    }

    /// The same curve, going on from `start` to `end` as a formula says that is singular at `pole`.
    #[must_use]
    pub fn then_smooth(self, start: f64, smooth: Smooth, end: f64, pole: f64) -> Self {
        let mut curve = self.then(start, smooth.value(start, 0.0), Shape::Smooth(smooth));
        if let Some(last) = curve.pieces.last() {
            curve.panels.extend(panels(curve.pieces.len() - 1, last, end, pole));
        }
        curve
    }

    /// The same curve with series for the time to its knots (see [`crossing::crossings`]).
    #[must_use]
    pub(super) fn with_crossings(mut self) -> Self {
        self.crossings = crossing::crossings(&self.pieces, &self.panels);
        self
    }

    #[must_use]
    pub(super) fn with_crossings_of_panels(self) -> Self {
        if self.panels.is_empty() { self } else { self.with_crossings() }
    }

    /// The panels of a piece; none but on a formula.
    fn panels_of(&self, index: usize) -> &[Panel] {
        let from = self.panels.partition_point(|panel| panel.piece < index);
        let until = self.panels.partition_point(|panel| panel.piece <= index);
        &self.panels[from..until]
    }

    /// The distance from the start of a piece at which the work reaches `work`, see [`Piece::distance_at_work`].
    #[inline(always)]
    pub(crate) fn distance_at_work(&self, index: usize, work: f64) -> f64 {
        let piece = &self.pieces[index];
        if self.panels.is_empty() {
            return piece.distance_at_work(work);
        }
        let panels = self.panels_of(index);
        let before = panels.partition_point(|panel| panel.work <= work);
        let panel = before.checked_sub(1).map(|last| &panels[last]);
        panel.map_or_else(
            || piece.distance_at_work(work),
            |panel| (panel.start - piece.start) + panel.distance_at_work(work - panel.work),
        )
    }

    /// The time of a motion d'' = −c f on the panels of a piece, from x = `from` to a distance from the start of the piece,
    /// where the speed is `exit`; `None` on one without panels.
    pub(crate) fn time_on_panels(&self, index: usize, from: f64, distance: f64, exit: f64, c: f64) -> Option<f64> {
        let panels = self.panels_of(index);
        let start = panels.first()?.start;
        let x = start + distance;
        let last = panels.partition_point(|panel| panel.start <= x).saturating_sub(1);
        let first = panels.partition_point(|panel| panel.start <= from).saturating_sub(1).min(last);
        Some(panel::time(&panels[first..=last], from, distance - (panels[last].start - start), exit, c))
    }

    fn then(mut self, start: f64, force: f64, shape: Shape) -> Self {
        let work = match self.pieces.last() {
            None => 0.0,
            Some(last) if self.panels.is_empty() => last.work_at(start),
            Some(_) => self.work(start),
        };
        self.pieces.push(Piece { start, force, work, shape });
        self
    }

    /// The same curve, going on from `start` along its tangent there.
    #[must_use]
    pub fn then_tangent(self, start: f64) -> Self {
        let slope = self.pieces.last().map_or(1.0, |last| last.slope_at(start));
        self.then_straight(start, slope)
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

    /// Work from first touch to x.
    pub fn work(&self, x: f64) -> f64 {
        let index = self.index_at(x);
        let panels: &[Panel] = if self.panels.is_empty() { &[] } else { self.panels_of(index) };
        match panels.partition_point(|panel| panel.start <= x) {
            0 => self.pieces[index].work_at(x),
            before => panels[before - 1].work + panels[before - 1].work_beyond(x - panels[before - 1].start),
        }
    }

    /// The last place that a sphere of this energy and speed reaches fast enough for its series. Without one, the start of
    /// the curve.
    #[inline(always)]
    pub(crate) fn crossed(&self, kinetic: f64, speed: f64) -> Reached {
        let fast = self.crossings.partition_point(|knot| knot.is_good(kinetic));
        let start = self.pieces[0].start;
        fast.checked_sub(1).map_or(Reached { piece: 0, start, work: 0.0, time: 0.0 }, |last| {
            self.crossings[last].reached(kinetic, speed)
        })
    }
}
