//! One time step of a contact in one call, for codes that move the spheres themselves (DEM).
//!
//! [`Contact::force`], [`Contact::energy`] and [`Contact::friction`] each find the unloading branch anew from the memory. A contact
//! that keeps a [`ContactHistory`] finds the branch once for each largest indentation. On the branch a step then costs one power:
//!
//! ```text
//! F = F_m (d/δ_e)^n,  d = δ − δ_r          the force
//! a ∝ F/d                                  the radius of the contact for friction, f_m/ε (d/δ_e)^(n−1)
//! W = F d/(n + 1)                          the stored energy
//! ```

use super::force::Memory;
use crate::contact::law::Surface;
use crate::impact::problem::contact::Contact;
use crate::numerics::power::{power, work_factor};

/// The state of a contact between two time steps. All numbers are zero for a fresh contact.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactHistory {
    pub memory: Memory,
    /// n of the unloading branch of the memory. It is 0 as long as no step needed the branch, and −1 for a branch that is no power
    /// law of the memory.
    pub exponent: f64,
    /// δ after the last step \[m\].
    pub indentation: f64,
    /// Force after the last step \[N\].
    pub force: f64,
    /// Plastic work of the dent \[J\], valid if the exponent is not 0.
    pub plastic_work: f64,
}

/// The exponent of a branch that is no power law of the memory.
const NO_POWER: f64 = -1.0;

impl ContactHistory {
    /// d = δ − δ_r at the last step; at the largest indentation the recovered part itself, which has more digits.
    #[inline]
    fn recovered(&self) -> f64 {
        if self.indentation == self.memory.indentation {
            self.memory.elastic_approach
        } else {
            self.indentation - self.memory.dent_depth()
        }
    }

    /// F and d after the last step, at most those of the largest indentation. The radius for friction is proportional to F/d.
    #[inline]
    fn force_and_recovered(&self) -> [f64; 2] {
        match self.recovered() {
            _ if self.indentation >= self.memory.indentation => [self.memory.force, self.memory.elastic_approach],
            recovered if recovered > 0.0 => [self.force, recovered],
            _ => [0.0, 1.0],
        }
    }
}

impl Contact {
    /// Moves a contact to an indentation δ \[m\]. The force is then `history.force`, the same as the result of [`Contact::force`] up
    /// to rounding.
    ///
    /// Returns false and does not change the history if [`Contact::force`] would return NaN.
    #[must_use]
    #[inline]
    pub fn step(&self, indentation: f64, history: &mut ContactHistory) -> bool {
        let before = *history;
        if !before.memory.is_valid_at(indentation) {
            return false;
        }
        // a step that is requested twice has the same bits, so that a restarted run continues unchanged
        if indentation == before.indentation && before.force > 0.0 {
            return true;
        }
        let mut after = ContactHistory { indentation, ..before };
        let is_on_branch = before.memory.indentation > 0.0 && indentation <= before.memory.indentation;
        if is_on_branch {
            self.find_branch(&mut after);
        }
        after.force = if is_on_branch && after.exponent > 0.0 {
            let ContactHistory { memory, exponent, .. } = after;
            match after.recovered() / memory.elastic_approach {
                share if share <= 0.0 => 0.0,
                share => memory.force * power(share, exponent),
            }
        } else {
            self.force(indentation, &mut after.memory)
        };
        if after.memory.indentation != before.memory.indentation {
            after.exponent = 0.0;
        }
        if after.force.is_finite() {
            *history = after;
        }
        after.force.is_finite()
    }

    /// The energy that unloading recovers after [`Contact::step`] \[J\]. The plastic work of the history is valid afterwards.
    pub fn stored_energy(&self, history: &mut ContactHistory) -> f64 {
        self.find_branch(history);
        match history.exponent {
            exponent if exponent > 0.0 => history.force * history.recovered().max(0.0) * work_factor(exponent),
            _ => self.energy(history.indentation, history.force, &history.memory).stored,
        }
    }

    /// Exponent and plastic work of the branch, if they are not known yet.
    #[inline]
    fn find_branch(&self, history: &mut ContactHistory) {
        if history.exponent == 0.0 {
            self.find_new_branch(history);
        }
    }

    #[inline(never)]
    fn find_new_branch(&self, history: &mut ContactHistory) {
        let Self { scales, law, .. } = self;
        let Some(peak) = history.memory.to_state(scales.units.length, scales.units.force) else { return };
        let unloading = law.unload(peak);
        history.exponent = if unloading.is_power_from(&peak) { unloading.exponent } else { NO_POWER };
        history.plastic_work = Surface::from(law).plastic_work(&unloading) * scales.units.energy();
    }

    /// 8 G* a \[N/m\] after [`Contact::step`], and the share of the friction that the change of a leaves, as [`Contact::friction`] has
    /// them. `None` for a branch that is no power law.
    #[inline]
    pub(super) fn friction_stiffness(&self, before: &ContactHistory, after: &ContactHistory) -> Option<[f64; 2]> {
        let is_smaller = after.indentation < before.indentation;
        if after.memory.indentation == 0.0 {
            let radius = (self.pair().radius * after.indentation.max(0.0)).sqrt();
            let share = if is_smaller { (after.indentation.max(0.0) / before.indentation).sqrt() } else { 1.0 };
            return Some([self.friction_modulus * radius, share]);
        }
        if after.exponent < 0.0 {
            return None;
        }
        let units = &self.scales.units;
        let ([force, recovered], [old_force, old_recovered]) =
            (after.force_and_recovered(), before.force_and_recovered());
        // one division for both
        let per_approach = force / recovered;
        let stiffness = self.friction_modulus * (units.contact_radius * units.length / units.force) * per_approach;
        let share = if is_smaller && old_force > 0.0 { per_approach * (old_recovered / old_force) } else { 1.0 };
        Some([stiffness, share.min(1.0)])
    }
}
