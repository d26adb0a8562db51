//! The law as a force of its own, for codes that move the sphere themselves (DEM): indentation and memory in, force out.

use super::contact::Contact;
use crate::law::Peak;
use crate::math::power::power;

/// The largest state that a contact has seen, all that it remembers: zero for a fresh one.
///
/// A code that moves spheres sets it back to zero where the sphere has left the surface that it knows (δ ≤ 0), and not yet
/// where the force ends, at the depth of the dent. A sphere that comes back to the same spot keeps its memory.
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
    #[must_use]
    pub fn dent(&self) -> f64 {
        self.indentation - self.elastic_approach
    }

    fn peak(&self, length: f64, force: f64) -> Option<Peak> {
        (self.indentation > 0.0).then(|| Peak {
            indentation: self.indentation / length,
            force: self.force / force,
            elastic_approach: self.elastic_approach / length,
        })
    }
}

/// Where the work of a contact is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactEnergy {
    /// What unloading from here gives back \[J\].
    pub stored: f64,
    /// What the dent has taken \[J\].
    pub plastic: f64,
}

impl Contact {
    /// Force \[N\] at an indentation δ \[m\], by the law alone, and in `memory` what the contact knows afterwards.
    ///
    /// Below the largest indentation so far it is the unloading branch, beyond it the loading curve. The force is 0 for
    /// δ ≤ 0 and not a number for a δ or a memory that is none.
    pub fn force(&self, indentation: f64, memory: &mut Memory) -> f64 {
        let Some((scales, law)) = &self.yielding else {
            return self.hertz(indentation, 1.5);
        };
        // a force that is asked for twice is the same to the last bit, so that a restarted run goes on as it was
        if indentation == memory.indentation && indentation > 0.0 {
            return memory.force;
        }
        let before = memory.peak(scales.length, scales.force);
        let (force, after) = law.respond(indentation / scales.length, before);
        if let Some(peak) = after.filter(|_| after != before) {
            *memory = Memory {
                indentation,
                force: peak.force * scales.force,
                elastic_approach: peak.elastic_approach * scales.length,
            };
        }
        force * scales.force
    }

    /// Where the work of the contact is after [`Contact::force`] gave this `force` at this indentation and memory.
    #[must_use]
    pub fn energy(&self, indentation: f64, force: f64, memory: &Memory) -> ContactEnergy {
        let Some((scales, law)) = &self.yielding else {
            return ContactEnergy { stored: 0.4 * indentation.max(0.0) * force, plastic: 0.0 };
        };
        let Some(peak) = memory.peak(scales.length, scales.force) else {
            return ContactEnergy { stored: 0.0 * force, plastic: 0.0 };
        };
        let unloading = law.unloading(peak);
        let recovered = indentation / scales.length - peak.residual();
        let stored =
            if recovered > 0.0 { unloading.stored_after(recovered, force / scales.force) } else { 0.0 * force };
        let taken = law.loading.work(peak.indentation) - unloading.capacity();
        ContactEnergy { stored: stored * scales.energy(), plastic: taken * scales.energy() }
    }

    /// dF/dδ \[N/m\] there, the tangent stiffness: of the unloading branch below the largest indentation so far and at it, of
    /// the loading curve beyond.
    #[must_use]
    pub fn stiffness(&self, indentation: f64, memory: &Memory) -> f64 {
        let Some((scales, law)) = &self.yielding else {
            return self.hertz(indentation, 0.5);
        };
        let x = indentation / scales.length;
        let slope = match memory.peak(scales.length, scales.force) {
            Some(peak) if x <= peak.indentation => match x - peak.residual() {
                recovered if recovered <= 0.0 => 0.0,
                recovered => law.unloading(peak).slope_after(recovered),
            },
            None if x <= 0.0 => 0.0,
            _ => law.loading.pieces()[law.loading.index_at(x)].slope_at(x),
        };
        slope * (scales.force / scales.length)
    }

    /// Hertz's force (exponent 3/2) or its slope (1/2).
    fn hertz(&self, indentation: f64, exponent: f64) -> f64 {
        let factor = if exponent == 1.5 { 1.0 } else { 1.5 };
        if indentation <= 0.0 { 0.0 } else { factor * self.pair().hertz_stiffness() * power(indentation, exponent) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::{LawChoice, Plm};
    use crate::material::{HalfSpace, Material, Sphere};

    const STEEL: Material = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };

    fn bodies(yield_strength: Option<f64>) -> (Sphere, HalfSpace) {
        (
            Sphere { radius: 5e-3, material: STEEL, density: 7850.0, yield_strength: None },
            HalfSpace { material: STEEL, yield_strength, density: None },
        )
    }

    /// Energy is conserved: along loading, unloading, reloading the work done on the contact (trapezoids of the force) is
    /// what is stored and what the dent has taken; and at the peak and the end they are those of the closed form.
    #[test]
    fn the_work_of_the_force_is_stored_or_taken_by_the_dent() {
        for law in LawChoice::all() {
            let (sphere, half_space) = bodies(Some(345e6));
            let Ok(contact) = Contact::try_new(sphere, half_space, law.get()) else { continue };
            let exact = contact.closed_form(1.0).expect("an impact at 1 m/s");
            let deepest = exact.peak_indentation;
            let mut memory = Memory::default();
            let (mut work, mut last, mut plastic_so_far) = (0.0, (0.0, 0.0), 0.0);
            let turns = [0.0, 0.6 * deepest, 0.55 * deepest, deepest, 0.0];
            for (from, to) in turns.iter().zip(&turns[1..]) {
                for i in 1..=20_000 {
                    let indentation = from + (to - from) * f64::from(i) / 20_000.0;
                    let force = contact.force(indentation, &mut memory);
                    work += 0.5 * (force + last.1) * (indentation - last.0);
                    if indentation > last.0 {
                        assert_eq!(contact.force(indentation, &mut memory.clone()), force, "{law:?}: asked twice");
                    }
                    last = (indentation, force);
                }
                let ContactEnergy { stored, plastic } = contact.energy(last.0, last.1, &memory);
                let kinetic = 0.5 * contact.mass();
                assert!(
                    (stored + plastic - work).abs() < 2e-6 * kinetic,
                    "{law:?}: {stored} + {plastic} is not {work}"
                );
                assert!(plastic >= plastic_so_far * (1.0 - 1e-12), "{law:?}: the dent gives back");
                plastic_so_far = plastic;
            }
            let kinetic = 0.5 * contact.mass();
            let restitution = (1.0 - plastic_so_far / kinetic).sqrt();
            assert!((restitution - exact.restitution).abs() < 1e-9, "{law:?}: e {restitution}, {}", exact.restitution);
            assert!((memory.force / exact.peak_force - 1.0).abs() < 1e-12, "{law:?}");
            assert!((memory.dent() - exact.residual_indentation).abs() < 1e-9 * deepest, "{law:?}");
        }
    }

    /// The slope is the derivative of the force (central difference), on both branches and on Hertz's curve.
    #[test]
    fn the_stiffness_is_the_slope_of_the_force() {
        for strength in [Some(345e6), None] {
            let (sphere, half_space) = bodies(strength);
            let contact = Contact::try_new(sphere, half_space, &Plm::default()).expect("a contact");
            let mut memory = Memory::default();
            contact.force(2e-5, &mut memory);
            for (indentation, memory) in [(1e-8, Memory::default()), (3e-5, memory), (1.95e-5, memory)] {
                let step = 1e-6 * indentation;
                let force = |at: f64| contact.force(at, &mut memory.clone());
                let slope = (force(indentation + step) - force(indentation - step)) / (2.0 * step);
                let stiffness = contact.stiffness(indentation, &memory);
                assert!((stiffness / slope - 1.0).abs() < 1e-6, "{strength:?}, {indentation}: {stiffness}, {slope}");
            }
        }
    }

    #[test]
    fn no_indentation_and_no_memory_makes_it_panic() {
        let hostile = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 0.0, 5e-324, 1e-5, f64::MAX];
        for strength in [Some(345e6), None] {
            let (sphere, half_space) = bodies(strength);
            let contact = Contact::try_new(sphere, half_space, &Plm::default()).expect("a contact");
            for case in 0..hostile.len().pow(4) {
                let [indentation, a, b, c] =
                    [0, 1, 2, 3].map(|place| hostile[case / hostile.len().pow(place) % hostile.len()]);
                let mut memory = Memory { indentation: a, force: b, elastic_approach: c };
                let stiffness = contact.stiffness(indentation, &memory);
                let force = contact.force(indentation, &mut memory);
                let energy = contact.energy(indentation, force, &memory);
                if indentation.is_nan() {
                    assert!(force.is_nan() && stiffness.is_nan() && energy.stored.is_nan());
                }
            }
        }
    }
}
