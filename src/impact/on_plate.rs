//! What an impact on a plate has besides: the equations are in [`super::plate`].

use super::case::Case;
use super::contact::Contact;
use super::outcome::{Fate, Outcome};
use super::scaled_forces::ScaledForces;

/// What an impact on a plate has besides. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OnPlate {
    /// λ \[1\].
    pub inelasticity: f64,
    /// X \[1\]: plate thicknesses that a wave travels in the contact time on a half-space.
    pub thinness: f64,
    /// Energy in the plate \[J\] at separation, or at the end of the run of a captured sphere.
    pub energy: f64,
    /// How far the plate has moved by then \[m\].
    pub displacement: f64,
    /// 2 √(c t_c) \[m\]: a nearer edge sends bending waves back in time; infinite for a captured sphere.
    pub reach: f64,
}

impl OnPlate {
    /// Of an outcome; `contact_time` \[s\] may be infinite.
    pub(super) fn of(contact: &Contact, case: &Case, outcome: &Outcome, contact_time: f64) -> Option<Self> {
        let (under, scaled) = contact.on_plate().zip(case.plate)?;
        let Case { scales, law, q, forces: ScaledForces { weight, plate: y, .. }, .. } = *case;
        let Outcome { unloading, end_indentation, end_speed: u, .. } = outcome;
        // a captured sphere is followed to where the contact still has a force
        let f = match outcome.fate {
            Fate::Separated => 0.0,
            Fate::Captured => unloading.force_of(end_indentation - law.dent(&unloading.peak).residual()),
        };
        let moved = y * (weight * outcome.contact_time + 0.8 * (q - u - y * f));
        let energy = outcome.loss - 0.8 * y * f * u - 0.4 * y * y * f * f + weight * moved;
        Some(Self {
            inelasticity: scaled.inelasticity,
            thinness: scaled.thinness,
            energy: energy * scales.energy(),
            displacement: moved * scales.length,
            reach: under.reach(contact_time).ok()?,
        })
    }
}
