//! Numbers of a scene that follow from others: the density from a given mass, and the yield strength from a given hardness.
//! Every setter here computes anew what depends on its value.

use std::f64::consts::PI;

use super::Scene;
use crate::law::LawChoice;
use crate::strength::flow::FlowCurve;
use crate::strength::hardness::strength_of_hardness;

impl Scene {
    /// Sets the radius \[m\]. The density from a given mass follows.
    pub fn set_radius(&mut self, radius: f64) {
        self.sphere.radius = radius;
        if let Some(mass) = self.mass {
            self.set_mass(mass);
        }
    }

    /// Sets the mass \[kg\] of all that moves with the sphere. The density becomes that of a sphere with this mass.
    pub fn set_mass(&mut self, mass: f64) {
        let radius = self.sphere.radius;
        self.mass = Some(mass);
        self.sphere.density = mass / (4.0 / 3.0 * PI * radius * radius * radius);
    }

    /// Sets the density \[kg/m³\], and removes a given mass.
    pub fn set_density(&mut self, density: f64) {
        (self.sphere.density, self.mass) = (density, None);
    }

    /// Sets the yield strength \[Pa\] of the half-space, and removes a given hardness.
    pub fn set_yield_strength(&mut self, strength: f64) {
        (self.half_space.yield_strength, self.hardness) = (Some(strength), None);
    }

    /// Sets the hardness of the half-space, as a mean pressure \[Pa\]. The yield strength follows.
    pub fn set_hardness(&mut self, mean_pressure: f64) {
        self.hardness = Some(mean_pressure);
        self.soften_or_harden();
    }

    /// Sets Young's modulus \[Pa\] of the half-space. A yield strength from a hardness may depend on it.
    pub fn set_half_space_modulus(&mut self, modulus: f64) {
        self.half_space.material.youngs_modulus = modulus;
        self.soften_or_harden();
    }

    /// Sets the law. A yield strength from a hardness depends on its flow curve.
    pub fn set_law(&mut self, law: LawChoice) {
        self.law = law;
        self.soften_or_harden();
    }

    /// Whether more than a yield strength describes the flow stress, or the law does not use it.
    pub fn has_flow(&self) -> bool {
        self.hardness.is_some() || self.law.flow().is_some() || matches!(self.law, LawChoice::Hertz(_))
    }

    /// Changes the flow curve, if there is one. A yield strength from a hardness follows.
    pub fn change_flow(&mut self, change: impl FnOnce(&mut FlowCurve)) {
        if let LawChoice::Plm(plm) = &mut self.law
            && let Some(flow) = &mut plm.flow
        {
            change(flow);
        }
        self.soften_or_harden();
    }

    /// Computes the yield strength from the hardness, if that is given.
    fn soften_or_harden(&mut self) {
        if let Some(mean_pressure) = self.hardness {
            let modulus = self.half_space.material.youngs_modulus;
            self.half_space.yield_strength = Some(strength_of_hardness(mean_pressure, self.law.flow(), modulus));
        }
    }
}
