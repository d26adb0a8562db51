//! What acts on a sphere beside the law, in the units of an impact, and where that lets it come to rest.

use crate::impact::forces::Damping;
use crate::impact::scales::ACCELERATION;
use crate::integrate::forced::{Drag, Rest};
use crate::law::reloading::GRAZING;
use crate::law::{Law, Unloading};

/// Gravity and damping in the units of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// w = m g/Φ; 0 without gravity.
    pub weight: f64,
    /// χ in units of 1/V, or ζ.
    pub damping: Option<Damping>,
}

impl Load {
    /// Whether nothing takes energy but the dent.
    #[must_use]
    pub fn is_conservative(&self) -> bool {
        matches!(self.damping, None | Some(Damping::HuntCrossley(0.0) | Damping::Viscous(0.0)))
    }

    /// Without damping: whether a sphere that came at q = v/V stays in its dent.
    #[must_use]
    pub fn captures(&self, unloading: &Unloading, q: f64) -> bool {
        let held = (unloading.exponent + 1.0) * self.weight;
        // an elastic contact gives back what it took, to rounding
        let held = if unloading.peak.residual() > 0.0 { held } else { held * (1.0 - GRAZING) };
        self.weight > 0.0 && (q == 0.0 || unloading.peak.force <= held)
    }

    /// Elastic approach at which the unloading branch carries the weight; at most that of the peak.
    #[must_use]
    pub fn static_approach(&self, unloading: &Unloading) -> f64 {
        unloading.recovered_at(self.weight)
    }

    /// Tangent stiffness of the branch there, at the elastic approach `at_rest`.
    #[must_use]
    pub fn static_slope(&self, unloading: &Unloading, at_rest: f64) -> f64 {
        if unloading.is_power() { unloading.exponent * self.weight / at_rest } else { unloading.slope_after(at_rest) }
    }

    /// x at which the contact carries the weight: on the unloading branch, or on the loading curve where the sphere has
    /// not yet come so far.
    #[must_use]
    pub fn static_indentation(&self, law: &Law, unloading: &Unloading) -> f64 {
        if unloading.peak.force < self.weight {
            equilibrium(law, self.weight).0
        } else {
            law.dent(&unloading.peak).residual() + self.static_approach(unloading)
        }
    }

    /// The resistance, as integrators know it.
    #[must_use]
    pub fn drag(&self) -> Drag {
        match self.damping {
            None | Some(Damping::HuntCrossley(0.0) | Damping::Viscous(0.0)) => Drag::None,
            Some(Damping::HuntCrossley(chi)) => Drag::OfForce(chi),
            Some(Damping::Viscous(zeta)) => Drag::OfStiffness(2.0 * zeta),
        }
    }
}

/// How near to its static indentation an overdamped sphere counts as captured there.
const NEAR: f64 = 1e-3;
/// How near a sphere is that the linear theory of the creep has missed: rounding ends its run.
const NEARER: f64 = 1e-7;

/// Creep to a static indentation: overdamped, a sphere comes near it and never passes.
#[derive(Debug, Clone, Copy)]
pub(in crate::impact) struct Creep {
    /// How far from the static indentation the run ends,
    pub(in crate::impact) within: f64,
    /// at speeds up to this: less than the fast one of the two rates of decay times that distance.
    pub(in crate::impact) below: f64,
}

impl Load {
    /// The creep to a static point at `distance` from where its branch begins, of tangent stiffness `slope`; `None` where
    /// the sphere swings through it.
    pub(in crate::impact) fn creep(&self, distance: f64, slope: f64) -> Option<Creep> {
        let omega = (ACCELERATION * slope).sqrt();
        let zeta = match self.damping? {
            Damping::HuntCrossley(chi) => 0.5 * ACCELERATION * self.weight * chi / omega,
            Damping::Viscous(zeta) => zeta,
        };
        let within = NEAR * distance;
        // next to critical a swing is e^(−πζ/√(1−ζ²)) of the one before: too small to be seen
        let fast = zeta + (zeta * zeta - 1.0).max(0.0).sqrt();
        (self.weight > 0.0 && zeta >= 0.9).then_some(Creep { within, below: fast * omega * within })
    }
}

impl Creep {
    /// What the integrator itself takes for rest.
    pub(in crate::impact) fn rest(self, distance: f64) -> Rest {
        let nearer = NEARER / NEAR;
        Rest { distance, within: nearer * self.within, below: nearer * self.below }
    }
}

/// x at which the loading curve carries the weight, and its piece.
pub(in crate::impact) fn equilibrium(law: &Law, weight: f64) -> (f64, usize) {
    let pieces = law.loading.pieces();
    let index = pieces.partition_point(|piece| piece.force <= weight).saturating_sub(1);
    let piece = &pieces[index];
    (piece.indentation_at_force(weight), index)
}
