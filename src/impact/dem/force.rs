//! The law as a force for codes that move the sphere themselves (DEM): they pass in the indentation and the memory.

use crate::contact::law::{ContactState, Surface};
use crate::impact::problem::contact::Contact;

/// The largest indentation of a contact so far, with its force: the whole memory of the contact. All numbers are zero for a fresh
/// contact, and for a contact without a yield strength.
///
/// A code that moves spheres resets it to zero when the sphere has left the original surface (δ ≤ 0). It must not reset it earlier,
/// where the force ends at the depth of the dent. A sphere that returns to the same spot keeps its memory.
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
    pub fn dent_depth(&self) -> f64 {
        self.indentation - self.elastic_approach
    }

    /// True if a contact can have this memory and this indentation. By rounding, the recovered part may be larger than δ_m.
    #[inline]
    pub(in crate::impact) fn is_valid_at(&self, indentation: f64) -> bool {
        let Self { indentation: largest, force, elastic_approach } = *self;
        // the largest indentation is finite too, or the sum is not
        (indentation + largest + force).is_finite()
            && force >= 0.0
            && 0.0 <= elastic_approach
            && elastic_approach <= largest * (1.0 + 1e-9)
    }

    pub(in crate::impact) fn to_state(self, length: f64, force: f64) -> Option<ContactState> {
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
    /// The energy that unloading from here recovers \[J\].
    pub stored: f64,
    /// The plastic work \[J\].
    pub plastic: f64,
}

impl Contact {
    /// Force \[N\] at an indentation δ \[m\], by the law alone. A new largest state is stored in `memory`.
    ///
    /// Below the largest indentation so far the force follows the unloading branch, above it the loading curve. The force is 0 for
    /// δ ≤ 0. The force is NaN, and the memory does not change, if δ or the force would be NaN or infinite, or if the memory is not
    /// possible for a contact (a number is negative, NaN or infinite, or more is recovered than δ_m).
    pub fn force(&self, indentation: f64, memory: &mut Memory) -> f64 {
        if !memory.is_valid_at(indentation) {
            return f64::NAN;
        }
        let Self { scales, law, .. } = self;
        // a force that is requested twice is the same to the last bit, so that a restarted run continues unchanged
        if indentation == memory.indentation && indentation > 0.0 {
            return memory.force;
        }
        let before = memory.to_state(scales.units.length, scales.units.force);
        let (force, after) = law.force_and_memory(indentation / scales.units.length, before);
        if let Some(peak) = after.filter(|_| after != before) {
            let reached = Memory {
                indentation,
                force: peak.force * scales.units.force,
                elastic_approach: peak.elastic_approach * scales.units.length,
            };
            if !reached.is_valid_at(indentation) {
                return f64::NAN;
            }
            // an elastic contact unloads along its loading curve
            if self.pair().yield_point.is_some() {
                *memory = reached;
            }
        }
        force * scales.units.force
    }

    /// True if a path of this contact leads to this memory: it lies on the loading curve, within the rounding of a text file with
    /// seven digits, or it is that of a fresh contact. [`Contact::force`] checks signs alone, which costs nothing in every step.
    pub fn accepts(&self, memory: &Memory) -> bool {
        const ROUNDING: f64 = 1e-6;
        if *memory == Memory::default() {
            return true;
        }
        let mut reached = Memory::default();
        self.force(memory.indentation, &mut reached);
        let is_near = |got: f64, want: f64| (got - want).abs() <= ROUNDING * want;
        reached.indentation > 0.0
            && is_near(memory.force, reached.force)
            && is_near(memory.elastic_approach, reached.elastic_approach)
    }

    /// The division of the work, for the result `force` of [`Contact::force`] at this indentation and memory.
    pub fn energy(&self, indentation: f64, force: f64, memory: &Memory) -> ContactEnergy {
        if !memory.is_valid_at(indentation) {
            return ContactEnergy { stored: f64::NAN, plastic: f64::NAN };
        }
        let Self { scales, law, .. } = self;
        let Some(peak) = memory.to_state(scales.units.length, scales.units.force) else {
            // an elastic contact follows Hertz
            return ContactEnergy { stored: 0.4 * indentation.max(0.0) * force, plastic: 0.0 };
        };
        let unloading = law.unload(peak);
        // a metal that relaxes has a deeper dent than its memory
        let stored = unloading.stored_energy_at(indentation / scales.units.length - unloading.peak.residual());
        ContactEnergy {
            stored: stored * scales.units.energy(),
            plastic: Surface::from(law).plastic_work(&unloading) * scales.units.energy(),
        }
    }

    /// dF/dδ \[N/m\] at this indentation, the tangent stiffness: of the unloading branch up to the largest indentation so far, of the
    /// loading curve beyond it.
    pub fn stiffness(&self, indentation: f64, memory: &Memory) -> f64 {
        if !memory.is_valid_at(indentation) {
            return f64::NAN;
        }
        let Self { scales, law, .. } = self;
        let x = indentation / scales.units.length;
        let slope = match memory.to_state(scales.units.length, scales.units.force) {
            Some(peak) if x <= peak.indentation => {
                let unloading = law.unload(peak);
                let recovered = x - unloading.peak.residual();
                if recovered <= 0.0 { 0.0 } else { unloading.slope_at(recovered) }
            }
            None if x <= 0.0 => 0.0,
            _ => law.loading.pieces()[law.loading.index_at(x)].slope_at(x),
        };
        slope * (scales.units.force / scales.units.length)
    }
}
