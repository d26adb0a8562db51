//! Gravity, damping and plate in the units of an impact, and where they let a sphere come to rest.

use super::forces::Damping;
use super::scales::ACCELERATION;
use crate::integrate::{Drag, Rest};
use crate::law::unloading::GRAZING;
use crate::law::{Law, Unloading};

/// What acts on a sphere beside the law, in the units of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScaledForces {
    /// w = m g/Φ; 0 without gravity.
    pub weight: f64,
    /// χ in units of 1/V, or ζ.
    pub damping: Option<Damping>,
    /// y = Y Φ/V of a plate; 0 without one.
    pub plate: f64,
}

impl ScaledForces {
    /// The law alone.
    pub const NONE: Self = Self { weight: 0.0, damping: None, plate: 0.0 };

    /// Whether the impact is that of the law alone.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.weight == 0.0 && self.damping.is_none() && self.plate == 0.0
    }

    /// The same without damping and plate.
    pub(crate) fn without_drag(&self) -> Self {
        Self { weight: self.weight, ..Self::NONE }
    }

    /// Whether there is no damping and no plate, so that only the dent takes energy.
    pub(crate) fn is_conservative(&self) -> bool {
        self.drag() == Drag::NONE
    }

    /// Without damping: whether a sphere that came at q = v/V stays in its dent.
    pub fn captures(&self, unloading: &Unloading, q: f64) -> bool {
        let held = (unloading.exponent + 1.0) * self.weight;
        // an elastic contact gives back what it took, but for rounding
        let held = if unloading.peak.residual() > 0.0 { held } else { held * (1.0 - GRAZING) };
        self.weight > 0.0 && (q == 0.0 || unloading.peak.force <= held)
    }

    /// Elastic approach at which the unloading branch carries the weight; at most that of the peak.
    pub(crate) fn static_approach(&self, unloading: &Unloading) -> f64 {
        unloading.recovered_at(self.weight)
    }

    /// Tangent stiffness of the branch there, at the elastic approach `at_rest`.
    pub(crate) fn static_slope(&self, unloading: &Unloading, at_rest: f64) -> f64 {
        if unloading.is_power() { unloading.exponent * self.weight / at_rest } else { unloading.slope_of(at_rest) }
    }

    /// x at which the contact carries the weight: on the unloading branch, or on the loading curve where the sphere has
    /// not yet come so far.
    pub fn static_indentation(&self, law: &Law, unloading: &Unloading) -> f64 {
        if unloading.peak.force < self.weight {
            equilibrium(law, self.weight).0
        } else {
            law.dent(&unloading.peak).residual() + self.static_approach(unloading)
        }
    }

    /// The resistance, as integrators know it. A plate gives way by y f' u.
    pub fn drag(&self) -> Drag {
        Drag { theta: self.plate / ACCELERATION, ..self.damping.map_or(Drag::NONE, Damping::drag) }
    }
}

/// An overdamped sphere that is nearer to its static indentation than this share of the static depth counts as captured.
const NEAR: f64 = 1e-3;
/// The same for a sphere that the rule for creep did not stop. The integrator itself applies it.
const NEARER: f64 = 1e-7;

/// Creep to a static indentation: an overdamped sphere approaches it and never passes it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Creep {
    /// How far from the static indentation the run ends.
    pub(super) within: f64,
    /// The largest speed at which it ends there: the fast one of the two rates of decay times that distance.
    pub(super) below: f64,
}

impl ScaledForces {
    /// The creep to a static point at `distance` from where its branch begins, of tangent stiffness `slope`; `None` where
    /// the sphere swings through it.
    pub(super) fn creep(&self, distance: f64, slope: f64) -> Option<Creep> {
        let omega = (ACCELERATION * slope).sqrt();
        let of_damping = self.damping.map_or(0.0, |damping| damping.fraction_of_critical(self.weight, omega));
        let zeta = of_damping + 0.5 * self.drag().theta * omega;
        let within = NEAR * distance;
        // from ζ = 0.9 on every swing is less than e^(−πζ/√(1−ζ²)) = 0.2 % of the one before: too small to be resolved
        let fast = zeta + (zeta * zeta - 1.0).max(0.0).sqrt();
        (self.weight > 0.0 && zeta >= 0.9).then_some(Creep { within, below: fast * omega * within })
    }
}

impl Creep {
    /// The rule by which the integrator itself ends a leg at rest.
    pub(super) fn rest(self, distance: f64) -> Rest {
        let nearer = NEARER / NEAR;
        Rest { distance, within: nearer * self.within, below: nearer * self.below }
    }
}

/// x at which the loading curve carries the weight, and its piece.
pub(super) fn equilibrium(law: &Law, weight: f64) -> (f64, usize) {
    let pieces = law.loading.pieces();
    let index = pieces.partition_point(|piece| piece.force <= weight).saturating_sub(1);
    let piece = &pieces[index];
    (piece.indentation_at_force(weight), index)
}
