//! Events of a leg, located on the continuous solution of a step: what ends the leg, and the largest contact force on it.

use super::dop853::Continuous;
use super::equations::{Dragged, DraggedState};
use super::{Landing, Path};
use crate::numerics::root::{bracketed, falls_through};

/// The event that ends a leg within a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Landed {
    pub landing: Landing,
    /// Where in the step, 0 ≤ θ ≤ 1.
    pub theta: f64,
    /// The state there, exactly at the end of the leg or without speed.
    pub node: DraggedState,
}

/// A step with its continuous solution, on a leg with its piece.
pub(super) struct DenseStep<'a> {
    pub path: &'a Path<'a>,
    /// y where the leg ends.
    pub end: f64,
    pub solution: Continuous,
}

impl DenseStep<'_> {
    /// The event that ends the leg within the step; `None` if none does.
    pub fn landed<P: Dragged>(&self) -> Option<Landed> {
        let (landing, theta) = self.first_event::<P>()?;
        let mut node = self.solution.at(theta);
        match landing {
            Landing::End => node[0] = self.end,
            Landing::Turning => node[1] = 0.0,
            Landing::LiftOff | Landing::Rest => {}
        }
        Some(Landed { landing, theta, node })
    }

    /// Where in the step (0 ≤ θ ≤ 1) the leg ends, and how; `None` if it does not.
    fn first_event<P: Dragged>(&self) -> Option<(Landing, f64)> {
        let sign = self.path.leg.direction();
        let mut first = None;
        let mut limit = 1.0;
        if sign * self.solution.value(1, 1.0) <= 0.0 {
            limit = self.falls(1, sign, 0.0, 1.0);
            first = Some((Landing::Turning, limit));
        }
        if sign * (self.end - self.solution.value(0, limit)) <= 0.0 {
            limit = self.falls(0, -sign, self.end, limit);
            first = Some((Landing::End, limit));
        }
        if let Some(rest) = self.path.rest {
            let excess = |theta| {
                let (y, u) = self.moving(theta);
                rest.excess(P::distance_at(y), u)
            };
            if excess(limit) <= 0.0 {
                limit = falls_through((0.0, limit), excess);
                first = Some((Landing::Rest, limit));
            }
        }
        if self.path.can_lift_off() {
            let pressed = |theta| self.pressed::<P>(theta);
            let gone = if pressed(limit) <= 0.0 { Some(limit) } else { self.dip::<P>(limit) };
            if let Some(gone) = gone {
                first = Some((Landing::LiftOff, falls_through((0.0, gone), pressed)));
            }
        }
        first
    }

    /// Position and speed at θ.
    fn moving(&self, theta: f64) -> (f64, f64) {
        (self.solution.value(0, theta), self.solution.value(1, theta))
    }

    /// Where `sign` (part − `level`) falls through zero before `limit`.
    fn falls(&self, part: usize, sign: f64, level: f64, limit: f64) -> f64 {
        let at = |theta| {
            let (value, slope) = self.solution.part(part, theta);
            (sign * (value - level), sign * slope)
        };
        let is_near = |last: f64, next: f64| (next - last).abs() <= f64::EPSILON;
        bracketed((0.0, limit), limit, is_near, at)
    }

    /// The contact force over √g', which is not steep near the zero of g. Beyond that zero there is no contact.
    fn pressed<P: Dragged>(&self, theta: f64) -> f64 {
        let (y, u) = self.moving(theta);
        let distance = P::distance_at(y);
        let force = self.path.restoring(distance.abs());
        let root = self.path.root_of_slope(distance.abs());
        let of_law = if root > 0.0 { force / root } else { 0.0 };
        of_law * if y > 0.0 { 1.0 + self.path.drag.chi * u } else { -1.0 } + self.path.drag.eta * u
    }

    fn growth<P: Dragged>(&self, theta: f64) -> f64 {
        let (y, u) = self.moving(theta);
        self.path.growth_of_force(P::distance_at(y), u)
    }

    /// Where the contact force is gone, if it vanishes and comes again before `limit`: under gravity a sphere that hardly lifts
    /// off falls back.
    fn dip<P: Dragged>(&self, limit: f64) -> Option<f64> {
        let growth = |theta| self.growth::<P>(theta);
        let dips = self.path.pull > 0.0 && growth(0.0) < 0.0 && growth(limit) > 0.0;
        let least = dips.then(|| falls_through((0.0, limit), |theta| -growth(theta)))?;
        (self.pressed::<P>(least) <= 0.0).then_some(least)
    }

    /// The largest contact force inside the part of the step up to `limit`, where it rises at first and falls at last.
    pub fn crest<P: Dragged>(&self, limit: f64) -> f64 {
        let top = falls_through((0.0, limit), |theta| self.growth::<P>(theta));
        let (y, u) = self.moving(top);
        self.path.contact_force(P::distance_at(y), u)
    }
}

/// True if the contact force no longer rises at a node.
pub(super) fn has_crested<P: Dragged>(path: &Path, node: &DraggedState) -> bool {
    path.growth_of_force(P::distance_at(node[0]), node[1]) <= 0.0
}
