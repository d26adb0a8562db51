//! The motion along one smooth piece, and the forces there: the restoring force g = c f of the piece, drag in the contact and on
//! the motion, and a pull.

use crate::numerics::curve::piece::{Piece, Shape};
use crate::numerics::power::{nan_max, power};

/// A state on the way along a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionState {
    /// Time since first contact.
    pub time: f64,
    /// d, from the zero of a power law, or from the start of any other piece.
    pub distance: f64,
    /// d'; negative during the rebound.
    pub speed: f64,
    /// ∫ drag d' dt: the energy that drag has taken so far, in units of speed².
    pub loss: f64,
}

/// The way along one piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Leg {
    /// Outward with positive speed, until the turning point or this distance, where the piece ends (infinite for the last
    /// one).
    Loading(f64),
    /// Back from rest to this distance.
    Unloading(f64),
}

impl Leg {
    /// Where it ends at the latest.
    pub(crate) fn end(self) -> f64 {
        let (Self::Loading(end) | Self::Unloading(end)) = self;
        end
    }

    /// +1 outward, −1 back.
    pub(super) fn direction(self) -> f64 {
        if matches!(self, Self::Loading(_)) { 1.0 } else { -1.0 }
    }
}

/// Scales of the variables. An error is divided by its scale, so one relative tolerance applies to all variables.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ErrorScales {
    pub distance: f64,
    pub speed: f64,
}

/// The drag, a force against the motion in addition to the restoring force g: drag = (χ g + η √g' + κ g') d' + θ g' d'.
///
/// The first three terms are a part of the contact force, so they count where this force vanishes and where it is largest. The last term
/// acts on the motion alone: a plate gives way at a speed that is proportional to the force. In the motion κ and θ are the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DampingCoefficients {
    /// χ: drag in proportion to the force.
    pub hunt_crossley: f64,
    /// η: drag in proportion to the root of the stiffness; twice the fraction of critical damping.
    pub viscous: f64,
    /// κ: drag in proportion to the stiffness, a time. A contact has either η or κ.
    pub viscoelastic: f64,
    /// θ: drag in proportion to the stiffness, which is no part of the contact force.
    pub plate: f64,
}

impl DampingCoefficients {
    pub const NONE: Self = Self { hunt_crossley: 0.0, viscous: 0.0, viscoelastic: 0.0, plate: 0.0 };

    /// True if any part of the drag is a part of the contact force.
    pub(crate) fn acts_in_contact(self) -> bool {
        self.hunt_crossley != 0.0 || self.acts_with_slope()
    }

    /// True if a part of the contact force depends on the stiffness g'. This part jumps where the stiffness does.
    pub(crate) fn acts_with_slope(self) -> bool {
        self.viscous != 0.0 || self.viscoelastic != 0.0
    }

    /// True if the contact force can vanish before the restoring force does.
    pub(crate) fn can_lift_off(self) -> bool {
        self.viscous > 0.0 || self.viscoelastic > 0.0
    }

    /// κ + θ: all drag in proportion to the stiffness.
    pub(crate) fn per_slope(self) -> f64 {
        self.viscoelastic + self.plate
    }

    /// True if the drag depends on the stiffness g'.
    pub(super) fn needs_slope(self) -> bool {
        self.acts_with_slope() || self.plate != 0.0
    }

    /// Drag over speed in the contact, and on the motion, at this force. `slope` is called only if a coefficient needs the slope of
    /// the force.
    #[inline]
    pub fn rates_at_force(self, force: f64, slope: impl FnOnce() -> f64) -> (f64, f64) {
        self.per_speed(force, if self.needs_slope() { sqrt_slope(slope()) } else { 0.0 })
    }

    /// χ g + η √g' + κ g' and θ g': drag over speed in the contact, and on the motion.
    #[inline(always)]
    pub fn per_speed(self, force: f64, root_of_slope: f64) -> (f64, f64) {
        let of_slope = self.viscoelastic * root_of_slope * root_of_slope;
        let in_contact = force * self.hunt_crossley + self.viscous * root_of_slope + of_slope;
        (in_contact, self.plate * root_of_slope * root_of_slope)
    }
}

/// √g' for a slope g'. By rounding, a formula may give a slope below 0 where it should be 0; it counts as 0.
#[inline]
fn sqrt_slope(slope: f64) -> f64 {
    nan_max(slope, 0.0).sqrt()
}

/// A distance at which a damped motion may come to rest. The motion is at rest if both its distance from there and its speed are
/// small enough.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestCriterion {
    /// Its distance along the piece.
    pub distance: f64,
    /// The largest difference from this distance that counts as rest.
    pub tolerance: f64,
    /// The largest speed that counts as rest.
    pub largest_speed: f64,
}

impl RestCriterion {
    /// How much of the distance or of the speed is left until a state counts as rest; 0 or less where it does.
    pub(crate) fn excess(&self, distance: f64, speed: f64) -> f64 {
        nan_max((distance - self.distance).abs() / self.tolerance, speed.abs() / self.largest_speed) - 1.0
    }
}

/// One smooth piece, the way along it, and what acts there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegProblem<'a> {
    /// The force f of the piece.
    pub piece: &'a Piece,
    /// c: the deceleration is g = c f.
    pub factor: f64,
    pub leg: Leg,
    /// The sizes that errors are measured against.
    pub error_scales: ErrorScales,
    /// γ ≥ 0: a constant acceleration outward.
    pub constant_acceleration: f64,
    pub drag: DampingCoefficients,
    /// Where the motion may end without an event.
    pub rest: Option<RestCriterion>,
}

impl LegProblem<'_> {
    /// g(d), continued smoothly a little beyond both ends of the piece.
    #[inline]
    pub(super) fn restoring_acceleration(&self, distance: f64) -> f64 {
        self.factor * self.piece.force_at_distance(distance - self.piece.shape.zero_offset())
    }

    /// g, g' and g'' at d.
    #[inline]
    pub(super) fn derivatives(&self, distance: f64) -> [f64; 3] {
        self.piece.derivatives(distance - self.piece.shape.zero_offset()).map(|part| self.factor * part)
    }

    /// √g'(d).
    #[inline]
    pub(super) fn sqrt_slope(&self, distance: f64) -> f64 {
        match self.piece.shape {
            Shape::Power { stiffness, exponent: 1.5, .. } => {
                (1.5 * (self.factor * stiffness)).sqrt() * distance.abs().sqrt().sqrt()
            }
            Shape::Power { stiffness, exponent, .. } => {
                (self.factor * stiffness * exponent).sqrt() * power(distance.abs(), 0.5 * (exponent - 1.0))
            }
            Shape::Linear { slope, .. } => (self.factor * slope).sqrt(),
            Shape::Polynomial(_) | Shape::Unloading(_) => sqrt_slope(self.derivatives(distance)[1]),
        }
    }

    /// g(d), and the drags at this speed: in the contact and on the motion.
    pub fn forces(&self, distance: f64, speed: f64) -> (f64, f64, f64) {
        let force = self.restoring_acceleration(distance);
        let root = if self.drag.needs_slope() { self.sqrt_slope(distance) } else { 0.0 };
        let (in_contact, on_motion) = self.drag.per_speed(force, root);
        (force, in_contact * speed, on_motion * speed)
    }

    /// The contact force: g and what damping adds to it.
    pub(crate) fn contact_force(&self, distance: f64, speed: f64) -> f64 {
        let (force, drag, _) = self.forces(distance, speed);
        force + drag
    }

    /// How fast the contact force grows in time:
    ///
    /// ```text
    /// g' u (1 + χ u) + χ g u' + η (√g' u' + g'' u²/(2 √g')) + κ (g' u' + g'' u²)
    /// ```
    pub(super) fn contact_force_rate(&self, distance: f64, speed: f64) -> f64 {
        let [force, slope, curvature] = self.derivatives(distance);
        let DampingCoefficients { hunt_crossley: chi, viscous: eta, viscoelastic: kappa, plate: theta } = self.drag;
        let acceleration = self.constant_acceleration - self.contact_force(distance, speed) - theta * slope * speed;
        let mut of_law = slope * speed * (1.0 + chi * speed) + chi * force * acceleration;
        if kappa != 0.0 {
            of_law += kappa * (slope * acceleration + curvature * speed * speed);
        }
        if eta == 0.0 {
            return of_law;
        }
        let root = sqrt_slope(slope);
        let of_root = if curvature == 0.0 { 0.0 } else { 0.5 * curvature * speed * speed / root };
        of_law + eta * (root * acceleration + of_root)
    }

    /// The larger one of the contact forces at both ends of a leg.
    pub(super) fn max_end_force(&self, begun: &MotionState, end: &MotionState) -> f64 {
        let at = |state: &MotionState| self.contact_force(state.distance, state.speed);
        nan_max(at(begun), at(end))
    }

    /// True if the contact force can vanish before the restoring force does.
    pub(crate) fn can_lift_off(&self) -> bool {
        matches!(self.leg, Leg::Unloading(_)) && self.drag.can_lift_off()
    }

    /// True if the sphere counts as at rest in this state.
    pub(crate) fn is_at_rest(&self, distance: f64, speed: f64) -> bool {
        self.rest.is_some_and(|rest| rest.excess(distance, speed) <= 0.0)
    }

    /// The arrival of a leg outward that begins without a speed outward: it has turned already.
    pub(super) fn immediate_turn(&self, state: &mut MotionState) -> Option<LegResult> {
        let has_turned = self.leg.direction() > 0.0 && state.speed <= 0.0;
        let at = MotionState { speed: 0.0, ..*state };
        has_turned.then(|| self.finish(LegEnd::Turning, at, state, f64::NEG_INFINITY))
    }

    /// Ends a leg in the state `at`. `largest` is the largest contact force inside of the leg.
    pub(super) fn finish(&self, landing: LegEnd, at: MotionState, state: &mut MotionState, largest: f64) -> LegResult {
        // at the end of the leg exactly, or where the motion came to
        let distance = if landing == LegEnd::PieceEnd { self.leg.end() } else { at.distance };
        let landed = MotionState { distance, ..at };
        let begun = std::mem::replace(state, landed);
        LegResult { end: landing, largest_force: nan_max(largest, self.max_end_force(&begun, state)) }
    }
}

/// How a leg went.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LegResult {
    pub end: LegEnd,
    /// The largest contact force on the leg, in units of the deceleration g.
    pub largest_force: f64,
}

/// Where a leg ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LegEnd {
    /// At the end of the piece, exactly.
    PieceEnd,
    /// At speed zero, exactly.
    Turning,
    /// Where the contact force vanishes during the rebound, before the restoring force does.
    LiftOff,
    /// Where the state begins to count as rest.
    Rest,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sqrt_slope_clamps_rounding_and_propagates_nan() {
        let both = DampingCoefficients { viscous: 0.2, plate: 3.0, ..DampingCoefficients::NONE };
        assert_eq!(both.rates_at_force(1.0, || -1e-17), (0.0, 0.0));
        assert!(both.rates_at_force(1.0, || f64::NAN).0.is_nan());
        // η √g' and θ g'
        assert_eq!(both.rates_at_force(1.0, || 2.25), (0.2 * 1.5, 3.0 * 2.25));
        let viscoelastic = DampingCoefficients { viscoelastic: 0.2, ..DampingCoefficients::NONE };
        assert_eq!(viscoelastic.rates_at_force(1.0, || 4.0), (0.2 * 4.0, 0.0));
    }
}
