//! The numbers of an impact that a table holds, without the rest of an [`Impact`].

use super::ImpactError;
use super::outcome::{Impact, Outcome};
use super::scales::Scales;
use crate::law::Law;
use crate::material::normal;

/// What a row of a table holds of an impact. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Essentials {
    /// e \[1\].
    pub restitution: f64,
    /// First touch to separation \[s\].
    pub contact_time: f64,
    /// F_m \[N\].
    pub peak_force: f64,
    /// δ_m \[m\].
    pub peak_indentation: f64,
    /// δ_r \[m\]: depth of the dent; 0 without one.
    pub residual_indentation: f64,
    /// a_m \[m\] (± 3 %): with a dent, the radius of its rim.
    pub peak_contact_radius: f64,
    /// ½ m v² \[J\].
    pub kinetic_in: f64,
    /// (W(δ_m) − F_m δ_e/(n + 1))/(½ m v²) \[1\]: share spent on the dent; 0 without one.
    pub plastic_fraction: f64,
}

impl Essentials {
    /// In SI units; `mass` is the sphere's \[kg\].
    ///
    /// # Errors
    /// [`OutOfFloatRange`](crate::material::OutOfFloatRange) where energy, force or time leave double precision.
    pub(super) fn new(
        mass: f64,
        speed: f64,
        scales: &Scales,
        law: &Law,
        outcome: &Outcome,
    ) -> Result<Self, ImpactError> {
        let peak = outcome.unloading.peak;
        let residual = peak.residual();
        let kinetic_in = normal("kinetic energy (J)", 0.5 * mass * speed * speed)?;
        let lost = law.loading.work(peak.indentation) - outcome.unloading.stored(peak.indentation);
        Ok(Self {
            restitution: outcome.restitution,
            contact_time: normal("contact time (s)", outcome.contact_time * scales.time())?,
            peak_force: normal("peak force (N)", peak.force * scales.force)?,
            peak_indentation: peak.indentation * scales.length,
            residual_indentation: residual * scales.length,
            peak_contact_radius: scales.contact_radius * law.contact_radius(&peak),
            kinetic_in,
            plastic_fraction: if residual > 0.0 { lost * scales.energy() / kinetic_in } else { 0.0 },
        })
    }

    /// Whether the impact left a dent.
    #[must_use]
    pub fn has_dent(&self) -> bool {
        self.residual_indentation > 0.0
    }

    /// (e v)²/v² \[1\]: share of the kinetic energy that comes back.
    #[must_use]
    pub fn recovered_fraction(&self) -> f64 {
        self.restitution * self.restitution
    }
}

impl From<&Impact> for Essentials {
    fn from(impact: &Impact) -> Self {
        let kinetic_in = impact.energy.kinetic_in;
        Self {
            restitution: impact.restitution,
            contact_time: impact.contact_time,
            peak_force: impact.peak_force,
            peak_indentation: impact.peak_indentation,
            residual_indentation: impact.residual_indentation,
            peak_contact_radius: impact.peak_contact_radius,
            kinetic_in,
            plastic_fraction: impact.energy.plastic.unwrap_or(0.0) / kinetic_in,
        }
    }
}
