//! The law as a force of its own, for codes that move the sphere themselves (DEM): indentation and memory in, force out.

use super::contact::Contact;
use crate::contact::law::{ContactState, Ground};

/// The largest indentation of a contact so far, with its force. It is the whole memory of the contact. A fresh contact has zeros,
/// and so has a contact without a yield strength.
///
/// A code that moves spheres sets it back to zero when the sphere has left the original surface (δ ≤ 0). It must not do so
/// earlier, where the force ends at the depth of the dent. A sphere that comes back to the same spot keeps its memory.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Memory {
    /// δ_m \[m\].
    pub indentation: f64,
    /// F_m \[N\].
    pub force: f64,
    /// The part of δ_m that is recovered on unloading \[m\].
    pub elastic_approach: f64,
}

impl Memory {
    /// Depth of the dent δ_r = δ_m − δ_e \[m\].
    pub fn dent(&self) -> f64 {
        self.indentation - self.elastic_approach
    }

    /// True if this memory, and an indentation beside it, are numbers that a contact can have. What is recovered may be
    /// larger than δ_m by rounding.
    pub(super) fn is_possible_at(&self, indentation: f64) -> bool {
        let Self { indentation: largest, force, elastic_approach } = *self;
        [indentation, largest, force, elastic_approach].into_iter().all(f64::is_finite)
            && force >= 0.0
            && 0.0 <= elastic_approach
            && elastic_approach <= largest * (1.0 + 1e-9)
    }

    pub(super) fn peak(&self, length: f64, force: f64) -> Option<ContactState> {
        (self.indentation > 0.0).then(|| ContactState {
            indentation: self.indentation / length,
            force: self.force / force,
            elastic_approach: self.elastic_approach / length,
        })
    }
}

/// How the work done on a contact is divided.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactEnergy {
    /// The energy that unloading from here gives back \[J\].
    pub stored: f64,
    /// The energy spent on the dent \[J\].
    pub plastic: f64,
}

impl Contact {
    /// Force \[N\] at an indentation δ \[m\], by the law alone. A new largest state is put into `memory`.
    ///
    /// Below the largest indentation so far the force is that of the unloading branch, beyond it that of the loading curve.
    /// It is 0 for δ ≤ 0. If δ is NaN or infinite, or the force would be, or no contact can have this memory (a number that is
    /// negative, NaN or infinite, or more recovered than δ_m), the force is NaN and the memory stays as it was.
    pub fn force(&self, indentation: f64, memory: &mut Memory) -> f64 {
        if !memory.is_possible_at(indentation) {
            return f64::NAN;
        }
        let Self { scales, law, .. } = self;
        // a force that is asked for twice is the same to the last bit, so that a restarted run goes on as it was
        if indentation == memory.indentation && indentation > 0.0 {
            return memory.force;
        }
        let before = memory.peak(scales.length, scales.force);
        let (force, after) = law.respond(indentation / scales.length, before);
        if let Some(peak) = after.filter(|_| after != before) {
            let reached = Memory {
                indentation,
                force: peak.force * scales.force,
                elastic_approach: peak.elastic_approach * scales.length,
            };
            if !reached.is_possible_at(indentation) {
                return f64::NAN;
            }
            // what stays elastic comes back the way it went
            if self.pair().yield_point.is_some() {
                *memory = reached;
            }
        }
        force * scales.force
    }

    /// How the work is divided after [`Contact::force`] gave this `force` at this indentation and memory.
    pub fn energy(&self, indentation: f64, force: f64, memory: &Memory) -> ContactEnergy {
        if !memory.is_possible_at(indentation) {
            return ContactEnergy { stored: f64::NAN, plastic: f64::NAN };
        }
        let Self { scales, law, .. } = self;
        let Some(peak) = memory.peak(scales.length, scales.force) else {
            // Hertz's, of an elastic contact
            return ContactEnergy { stored: 0.4 * indentation.max(0.0) * force, plastic: 0.0 };
        };
        let unloading = law.unloading(peak);
        let stored = unloading.stored_of(indentation / scales.length - peak.residual());
        ContactEnergy {
            stored: stored * scales.energy(),
            plastic: Ground::from(law).plastic(&unloading) * scales.energy(),
        }
    }

    /// dF/dδ \[N/m\] there, the tangent stiffness: of the unloading branch below the largest indentation so far and at it, of
    /// the loading curve beyond.
    pub fn stiffness(&self, indentation: f64, memory: &Memory) -> f64 {
        if !memory.is_possible_at(indentation) {
            return f64::NAN;
        }
        let Self { scales, law, .. } = self;
        let x = indentation / scales.length;
        let slope = match memory.peak(scales.length, scales.force) {
            Some(peak) if x <= peak.residual() => 0.0,
            Some(peak) if x <= peak.indentation => law.unloading(peak).slope_of(x - peak.residual()),
            None if x <= 0.0 => 0.0,
            _ => law.loading.pieces()[law.loading.index_at(x)].slope_at(x),
        };
        slope * (scales.force / scales.length)
    }
}
