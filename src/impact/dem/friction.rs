//! Friction as a force for codes that move the sphere themselves (DEM): one spring for the whole contact.
//!
//! This is the most that a contact of a DEM code can store. LAMMPS has it as `mindlin_rescale/force` (Thornton, Cummins and Cleary
//! 2013, Powder Technology 233, 30-46, Eq. 18). [`crate::impact::oblique`] has a more accurate contact, which needs the whole impact.

use super::force::Memory;
use super::step::ContactHistory;
use crate::impact::problem::contact::Contact;

/// A contact after a time step, and its motion in this step. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrictionStep {
    /// δ at the last step \[m\]; 0 in the first one.
    pub previous_indentation: f64,
    /// δ after this step \[m\].
    pub indentation: f64,
    /// The result of [`Contact::force`] after this step \[N\].
    pub force: f64,
    /// Slip of the contact point along the surface in this step \[m\].
    pub slip: [f64; 3],
}

impl Contact {
    /// Radii of the contact \[m\] for the friction at these indentations, after [`Contact::force`] gave this memory. During loading a
    /// radius is that of Hertz with the force and the elastic approach of the law; during unloading it is proportional to the
    /// stiffness.
    fn friction_radii<const N: usize>(&self, indentations: [f64; N], memory: &Memory) -> [f64; N] {
        let Self { scales, law, .. } = self;
        let Some(peak) = memory.to_state(scales.units.length, scales.units.force) else {
            // an elastic contact follows Hertz
            return indentations.map(|indentation| (self.pair().radius * indentation.max(0.0)).sqrt());
        };
        let at_peak = peak.force / peak.elastic_approach;
        // by rounding, what is recovered at the peak may be less than its elastic approach
        let is_at_peak = |indentation: f64| indentation >= memory.indentation;
        if indentations.into_iter().all(is_at_peak) {
            return [scales.units.contact_radius * at_peak; N];
        }
        let unloading = law.unload(peak);
        indentations.map(|indentation| {
            let recovered = indentation / scales.units.length - peak.residual();
            let ratio = if is_at_peak(indentation) { at_peak } else { unloading.radius_ratio(recovered) };
            scales.units.contact_radius * ratio
        })
    }

    /// Friction on the sphere \[N\], which is also the history of the contact; zero for a fresh one.
    ///
    /// ```text
    /// T_new = T min(1, a/a_old) − 8 G* a Δs,   |T_new| ≤ μ F
    /// ```
    ///
    /// Its torque about the centre is the torque of T at the contact point. A step should be short compared with the contact time.
    ///
    /// Returns false and does not change the history if the coefficient is negative, if a number is NaN or infinite, or if the memory
    /// is not possible for a contact.
    #[must_use]
    pub fn friction(&self, coefficient: f64, step: &FrictionStep, memory: &Memory, history: &mut [f64; 3]) -> bool {
        let numbers = [coefficient, step.previous_indentation, step.force].into_iter().chain(step.slip).chain(*history);
        if !numbers.into_iter().all(f64::is_finite) || coefficient < 0.0 || !memory.is_valid_at(step.indentation) {
            return false;
        }
        // the radius rises with the indentation
        let (radius, share) = if step.indentation < step.previous_indentation {
            let [old, radius] = self.friction_radii([step.previous_indentation, step.indentation], memory);
            (radius, share_left(radius, old))
        } else {
            let [radius] = self.friction_radii([step.indentation], memory);
            (radius, 1.0)
        };
        update_friction(coefficient * step.force.max(0.0), self.friction_modulus * radius, share, &step.slip, history)
    }

    /// [`Contact::friction`] after [`Contact::step`] changed the history `before` into `after`. `friction` is the friction on the
    /// sphere, and changes.
    #[must_use]
    #[inline]
    pub fn friction_after_step(
        &self,
        coefficient: f64,
        before: &ContactHistory,
        after: &ContactHistory,
        slip: &[f64; 3],
        friction: &mut [f64; 3],
    ) -> bool {
        match self.friction_stiffness(before, after) {
            Some([stiffness, share]) if (0.0..f64::INFINITY).contains(&coefficient) => {
                update_friction(coefficient * after.force.max(0.0), stiffness, share, slip, friction)
            }
            Some(_) => false,
            None => {
                let (previous_indentation, indentation, force) = (before.indentation, after.indentation, after.force);
                let step = FrictionStep { previous_indentation, indentation, force, slip: *slip };
                self.friction(coefficient, &step, &after.memory, friction)
            }
        }
    }
}

/// Friction after a slip, at most `most`: `share` of it is left of a contact that has become smaller. Returns false and changes nothing
/// if a number is NaN or infinite.
#[inline]
fn update_friction(most: f64, stiffness: f64, share: f64, slip: &[f64; 3], history: &mut [f64; 3]) -> bool {
    let (mut after, mut sum) = (*history, 0.0);
    for (force, slip) in after.iter_mut().zip(*slip) {
        *force = *force * share - stiffness * slip;
        sum += *force * *force;
    }
    if sum > most * most {
        let share = most / sum.sqrt();
        for force in &mut after {
            *force *= share;
        }
    }
    // a limit is NaN where the force is
    let is_finite = sum.is_finite() && !most.is_nan();
    if is_finite {
        *history = after;
    }
    is_finite
}

/// The share of the friction that is left of a contact that has become smaller.
fn share_left(radius: f64, old: f64) -> f64 {
    if radius < old { radius / old } else { 1.0 }
}
