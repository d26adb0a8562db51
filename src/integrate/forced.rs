//! Motion under a pull and with drag beside the restoring force: d'' = γ − g(d) − drag(d, d').
//!
//! The seam of the integrators for scenes that name gravity or damping. What ends a leg is more than without them: the
//! contact force may vanish before the piece does, and a sphere may stay where it is.

use super::{IntegrationError, Path, Restoring, Sampler, State, Work};
use crate::power::{max_or_nan, power};

/// How the contact resists motion, beside the restoring force g(d).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drag {
    /// Not at all.
    None,
    /// g(d) χ d'.
    OfForce(f64),
    /// η √g'(d) d', with η twice the fraction of critical damping.
    OfStiffness(f64),
}

impl Drag {
    /// Whether the contact force can vanish before the restoring force does.
    #[must_use]
    pub fn lifts_off(self) -> bool {
        matches!(self, Self::OfStiffness(eta) if eta > 0.0)
    }

    /// (χ, η), the one that is not given 0.
    #[must_use]
    pub fn coefficients(self) -> (f64, f64) {
        match self {
            Self::None => (0.0, 0.0),
            Self::OfForce(chi) => (chi, 0.0),
            Self::OfStiffness(eta) => (0.0, eta),
        }
    }
}

/// A place where a damped motion may come to rest, and how near to it counts as rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest {
    /// Its distance along the piece.
    pub distance: f64,
    /// Near in distance,
    pub within: f64,
    /// and in speed.
    pub below: f64,
}

/// One smooth piece, what acts along it, and the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForcedPath {
    /// Restoring force, leg, sizes. [`super::Leg::Back`] is from rest to `back_to`.
    pub path: Path,
    /// γ ≥ 0.
    pub pull: f64,
    /// Resistance.
    pub drag: Drag,
    /// Distance that the way back ends at.
    pub back_to: f64,
    /// Where the motion may end without an event.
    pub rest: Option<Rest>,
}

impl ForcedPath {
    /// What the drag takes from the speed, drag(d, u).
    #[inline]
    #[must_use]
    pub fn drag(&self, distance: f64, speed: f64) -> f64 {
        match self.drag {
            Drag::None => 0.0,
            Drag::OfForce(chi) => self.path.restoring.at(distance) * chi * speed,
            Drag::OfStiffness(eta) => eta * root_slope(&self.path.restoring, distance) * speed,
        }
    }

    /// What the contact takes from the speed, g(d) + drag(d, u).
    #[inline]
    #[must_use]
    pub fn contact(&self, distance: f64, speed: f64) -> f64 {
        self.path.restoring.at(distance) + self.drag(distance, speed)
    }

    /// Whether the contact force can vanish before the restoring force does.
    #[must_use]
    pub fn can_lift_off(&self) -> bool {
        self.drag.lifts_off()
    }

    /// Whether this state counts as rest.
    #[must_use]
    pub fn is_at_rest(&self, distance: f64, speed: f64) -> bool {
        self.rest.is_some_and(|rest| (distance - rest.distance).abs() <= rest.within && speed.abs() <= rest.below)
    }
}

/// √g'(d).
fn root_slope(restoring: &Restoring, distance: f64) -> f64 {
    match *restoring {
        Restoring::Power { coefficient, exponent: 1.5 } => (1.5 * coefficient).sqrt() * distance.abs().sqrt().sqrt(),
        Restoring::Power { coefficient, exponent } => {
            (coefficient * exponent).sqrt() * power(distance.abs(), 0.5 * (exponent - 1.0))
        }
        Restoring::Straight { slope, .. } => slope.sqrt(),
        Restoring::Smooth { force, start, factor } => max_or_nan(factor * force.slope(start, distance), 0.0).sqrt(),
    }
}

/// Where a leg ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForcedLanding {
    /// At the end of the piece, exactly.
    End,
    /// At speed zero, exactly.
    Turning,
    /// Where the contact force vanishes on the way back, before the restoring force does.
    LiftOff,
    /// As near to rest as the path says.
    Rest,
}

/// A state and what the drag has taken so far, ∫ drag d' dt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForcedState {
    /// Time, distance, speed.
    pub state: State,
    /// In units of speed².
    pub loss: f64,
}

/// Carries a state along smooth pieces under pull and drag.
pub trait ForcedIntegrator {
    /// From `state` to where the path ends.
    ///
    /// # Errors
    /// [`IntegrationError`] if the step underflows, the steps run out, or the state is not finite.
    fn traverse(
        &mut self,
        path: &ForcedPath,
        state: &mut ForcedState,
        samples: Option<&mut Sampler>,
    ) -> Result<ForcedLanding, IntegrationError>;

    /// Cost so far.
    fn work(&self) -> Work;
}
