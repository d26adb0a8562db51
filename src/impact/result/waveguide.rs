//! The additional results of an impact on a plate or a rod.

use crate::impact::problem::forces::ScaledForces;
use crate::impact::problem::rod::Rod;
use crate::impact::problem::scales::{FORCE_FACTOR, kinetic_energy};
use crate::impact::problem::waveguide::{ScaledWaveguide, WaveguideKind};
use crate::impact::scaled_impact::ScaledImpact;
use crate::impact::solve::outcome::{ImpactEnd, ScaledResult};

/// The additional results of an impact on a waveguide; [`crate::impact::problem::waveguide`] has the equations. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaveguideResult {
    pub kind: WaveguideKind,
    /// Cross section of a rod \[m²\].
    pub rod_cross_section: Option<f64>,
    /// λ \[1\].
    pub zener_number: f64,
    /// X \[1\]: number of plate thicknesses or rod diameters that a wave travels in the contact time on a half-space.
    pub wave_transits: f64,
    /// Energy in the waveguide \[J\] at separation, or at the end of the run of a captured sphere.
    pub energy: f64,
    /// Displacement of the waveguide at that time \[m\].
    pub displacement: f64,
    /// The distance of an edge of the plate, or the length of the rod \[m\], below which waves return in time; infinite for a captured
    /// sphere.
    pub wave_reach: f64,
}

impl WaveguideResult {
    /// The results from an outcome; `contact_time` \[s\] may be infinite.
    pub(in crate::impact) fn from_scaled(
        case: &ScaledImpact,
        outcome: &ScaledResult,
        contact_time: f64,
    ) -> Option<Self> {
        let ScaledWaveguide { target, mobility: y, zener_number, wave_transits } = case.waveguide?;
        let ScaledImpact { scales, ground, q, forces: ScaledForces { weight, .. }, .. } = *case;
        let ScaledResult { unloading, end_indentation, end_speed: u, .. } = outcome;
        // the run of a captured sphere ends where the contact still has a force
        let f = match outcome.end {
            ImpactEnd::Separated => 0.0,
            ImpactEnd::Captured => {
                unloading.force_at_elastic_approach(end_indentation - ground.deepest_state(&unloading.peak).residual())
            }
        };
        let moved = y * (weight * outcome.contact_time + (q - u - y * f) / FORCE_FACTOR);
        let energy = outcome.loss - y * f * u / FORCE_FACTOR - kinetic_energy(y * f) + weight * moved;
        Some(Self {
            kind: target.guide.kind(),
            rod_cross_section: target.guide.rod().map(Rod::cross_section),
            zener_number,
            wave_transits,
            energy: energy * scales.units.energy(),
            displacement: moved * scales.units.length,
            wave_reach: target.wave_reach(contact_time),
        })
    }

    /// The distance below which waves return in time, unless the sphere is captured.
    pub fn finite_wave_reach(&self) -> Option<f64> {
        Some(self.wave_reach).filter(|reach| reach.is_finite())
    }
}
