//! Events of a leg, located on the continuous solution of a step: what ends the leg, and the largest contact force on it.

use super::dop853::ContinuousExtension;
use super::equations::{DampedEquation, DampedState};
use super::{DampingCoefficients, LegEnd, LegProblem};
use crate::numerics::root::{illinois, newton_bisection};

/// The event that ends a leg within a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct LocatedEnd {
    pub landing: LegEnd,
    /// Where in the step, 0 ≤ θ ≤ 1.
    pub theta: f64,
    /// The state there, exactly at the end of the leg or without speed.
    pub node: DampedState,
}

/// A step with its continuous solution, on a leg with its piece.
pub(super) struct DenseStep<'a> {
    pub path: &'a LegProblem<'a>,
    /// y where the leg ends.
    pub end: f64,
    pub solution: ContinuousExtension,
}

impl DenseStep<'_> {
    /// The event that ends the leg within the step; `None` if none does.
    pub fn locate_end<P: DampedEquation>(&self) -> Option<LocatedEnd> {
        let (landing, theta) = self.first_event::<P>()?;
        let mut node = self.solution.state_at(theta);
        match landing {
            LegEnd::PieceEnd => node[0] = self.end,
            LegEnd::Turning => node[1] = 0.0,
            LegEnd::LiftOff | LegEnd::Rest => {}
        }
        Some(LocatedEnd { landing, theta, node })
    }

    /// Where in the step (0 ≤ θ ≤ 1) the leg ends, and how; `None` if it does not.
    fn first_event<P: DampedEquation>(&self) -> Option<(LegEnd, f64)> {
        let sign = self.path.leg.direction();
        let mut first = None;
        let mut limit = 1.0;
        if sign * self.solution.value(1, 1.0) <= 0.0 {
            limit = self.falling_zero(1, sign, 0.0, 1.0);
            first = Some((LegEnd::Turning, limit));
        }
        if sign * (self.end - self.solution.value(0, limit)) <= 0.0 {
            limit = self.falling_zero(0, -sign, self.end, limit);
            first = Some((LegEnd::PieceEnd, limit));
        }
        if let Some(rest) = self.path.rest {
            let excess = |theta| {
                let (y, u) = self.position_and_speed(theta);
                rest.excess(P::distance_at(y), u)
            };
            if excess(limit) <= 0.0 {
                limit = illinois((0.0, limit), excess);
                first = Some((LegEnd::Rest, limit));
            }
        }
        if self.path.can_lift_off() {
            let pressed = |theta| self.scaled_contact_force::<P>(theta);
            let gone = if pressed(limit) <= 0.0 { Some(limit) } else { self.force_loss::<P>(limit) };
            if let Some(gone) = gone {
                first = Some((LegEnd::LiftOff, illinois((0.0, gone), pressed)));
            }
        }
        first
    }

    /// Position and speed at θ.
    fn position_and_speed(&self, theta: f64) -> (f64, f64) {
        (self.solution.value(0, theta), self.solution.value(1, theta))
    }

    /// Where `sign` (part − `level`) falls through zero before `limit`.
    fn falling_zero(&self, part: usize, sign: f64, level: f64, limit: f64) -> f64 {
        let at = |theta| {
            let (value, slope) = self.solution.component(part, theta);
            (sign * (value - level), sign * slope)
        };
        let is_near = |last: f64, next: f64| (next - last).abs() <= f64::EPSILON;
        newton_bisection((0.0, limit), limit, is_near, at)
    }

    /// The contact force over √g', or over g' in a viscoelastic contact, which is not steep near the zero of g. Beyond that zero there
    /// is no contact.
    fn scaled_contact_force<P: DampedEquation>(&self, theta: f64) -> f64 {
        let (y, u) = self.position_and_speed(theta);
        let distance = P::distance_at(y);
        let force = self.path.restoring_acceleration(distance.abs());
        let root = self.path.sqrt_slope(distance.abs());
        let DampingCoefficients { hunt_crossley: chi, viscous, viscoelastic, .. } = self.path.drag;
        let size = if viscoelastic == 0.0 { root } else { root * root };
        let of_law = if size > 0.0 { force / size } else { 0.0 };
        of_law * if y > 0.0 { 1.0 + chi * u } else { -1.0 } + (viscous + viscoelastic) * u
    }

    fn contact_force_rate<P: DampedEquation>(&self, theta: f64) -> f64 {
        let (y, u) = self.position_and_speed(theta);
        self.path.contact_force_rate(P::distance_at(y), u)
    }

    /// Where the contact force is gone, if it vanishes and comes again before `limit`: under gravity a sphere that hardly lifts
    /// off falls back.
    fn force_loss<P: DampedEquation>(&self, limit: f64) -> Option<f64> {
        let growth = |theta| self.contact_force_rate::<P>(theta);
        let dips = self.path.constant_acceleration > 0.0 && growth(0.0) < 0.0 && growth(limit) > 0.0;
        let least = dips.then(|| illinois((0.0, limit), |theta| -growth(theta)))?;
        (self.scaled_contact_force::<P>(least) <= 0.0).then_some(least)
    }

    /// The largest contact force inside the part of the step up to `limit`, where it rises at first and falls at last.
    pub fn max_contact_force<P: DampedEquation>(&self, limit: f64) -> f64 {
        let top = illinois((0.0, limit), |theta| self.contact_force_rate::<P>(theta));
        let (y, u) = self.position_and_speed(top);
        self.path.contact_force(P::distance_at(y), u)
    }
}

/// True if the contact force no longer rises at a node.
pub(super) fn is_past_force_maximum<P: DampedEquation>(path: &LegProblem, node: &DampedState) -> bool {
    path.contact_force_rate(P::distance_at(node[0]), node[1]) <= 0.0
}
