//! Friction as a force for codes that move the sphere themselves (DEM): one spring for the whole contact.
//!
//! This is the most that a contact of a DEM code can store. LAMMPS has it as `mindlin_rescale/force` (Thornton, Cummins and Cleary
//! 2013, Powder Technology 233, 30-46, Eq. 18). [`crate::impact::oblique`] has a more accurate contact, which needs the whole impact.

use super::force::Memory;
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
        let recovered = indentations.map(|indentation| indentation / scales.units.length - peak.residual());
        let is_at_peak = |recovered: f64| recovered >= peak.elastic_approach;
        if recovered.into_iter().all(is_at_peak) {
            return [scales.units.contact_radius * at_peak; N];
        }
        let unloading = law.unload(peak);
        recovered.map(|recovered| {
            scales.units.contact_radius
                * if is_at_peak(recovered) { at_peak } else { unloading.radius_ratio(recovered) }
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
    pub fn friction(&self, coefficient: f64, rub: &FrictionStep, memory: &Memory, history: &mut [f64; 3]) -> bool {
        let numbers = [coefficient, rub.previous_indentation, rub.force].into_iter().chain(rub.slip).chain(*history);
        if !numbers.into_iter().all(f64::is_finite) || coefficient < 0.0 || !memory.is_valid_at(rub.indentation) {
            return false;
        }
        // the radius rises with the indentation
        let (radius, share) = if rub.indentation < rub.previous_indentation {
            let [old, radius] = self.friction_radii([rub.previous_indentation, rub.indentation], memory);
            (radius, if radius < old { radius / old } else { 1.0 })
        } else {
            let [radius] = self.friction_radii([rub.indentation], memory);
            (radius, 1.0)
        };
        let stiffness = 8.0 * self.shear_ratio() * self.pair().effective_modulus * radius;
        let (mut after, mut sum) = (*history, 0.0);
        for (force, slip) in after.iter_mut().zip(rub.slip) {
            *force = *force * share - stiffness * slip;
            sum += *force * *force;
        }
        let (size, most) = (sum.sqrt(), coefficient * rub.force.max(0.0));
        if size > most {
            for force in &mut after {
                *force *= most / size;
            }
        }
        // the size of a force may be infinite where its components are not
        let is_finite = sum.is_finite() && after.iter().all(|force| force.is_finite());
        if is_finite {
            *history = after;
        }
        is_finite
    }
}
