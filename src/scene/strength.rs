//! What a scene says in other words: the sphere's mass in place of its density, and the strength of the half-space by a
//! hardness. Whatever is put into the scene last, the numbers that follow are made anew.

use std::f64::consts::PI;

use super::Scene;
use crate::law::LawChoice;
use crate::strength::flow::FlowCurve;
use crate::strength::hardness::strength_of_hardness;

impl Scene {
    /// Puts a radius \[m\] into the scene; a given mass then has another density.
    pub fn set_radius(&mut self, radius: f64) {
        self.sphere.radius = radius;
        if let Some(mass) = self.mass {
            self.set_mass(mass);
        }
    }

    /// Puts a mass \[kg\] into the scene, of all that moves with the sphere; its density is that of a sphere with this mass.
    pub fn set_mass(&mut self, mass: f64) {
        let radius = self.sphere.radius;
        self.mass = Some(mass);
        self.sphere.density = mass / (4.0 / 3.0 * PI * radius * radius * radius);
    }

    /// Puts a density \[kg/m³\] into the scene, in place of a mass if there was one.
    pub fn set_density(&mut self, density: f64) {
        (self.sphere.density, self.mass) = (density, None);
    }

    /// Puts a yield strength \[Pa\] of the half-space into the scene, in place of a hardness if there was one.
    pub fn set_yield_strength(&mut self, strength: f64) {
        (self.half_space.yield_strength, self.hardness) = (Some(strength), None);
    }

    /// Puts a hardness into the scene, as a mean pressure \[Pa\]; the yield strength follows.
    pub fn set_hardness(&mut self, mean_pressure: f64) {
        self.hardness = Some(mean_pressure);
        self.soften_or_harden();
    }

    /// Puts Young's modulus \[Pa\] of the half-space into the scene; a strength from a hardness may depend on it.
    pub fn set_half_space_modulus(&mut self, modulus: f64) {
        self.half_space.material.youngs_modulus = modulus;
        self.soften_or_harden();
    }

    /// Whether the scene says more of how the metal flows than a yield strength, or the law has no use for it.
    pub fn has_flow(&self) -> bool {
        self.hardness.is_some() || self.law.flow().is_some() || matches!(self.law, LawChoice::Hertz(_))
    }

    /// A number of the flow curve, if the curve has it.
    pub fn flow_number(&self, number: NumberOf) -> Option<f64> {
        number(&mut self.law.flow()?.clone()).copied()
    }

    /// Changes a number of the flow curve; a strength from a hardness follows.
    pub fn set_flow_number(&mut self, number: NumberOf, value: f64) {
        if let LawChoice::Plm(plm) = &mut self.law
            && let Some(place) = plm.flow.as_mut().and_then(number)
        {
            *place = value;
        }
        self.soften_or_harden();
    }

    /// Makes the yield strength that follows from a given hardness.
    fn soften_or_harden(&mut self) {
        if let Some(mean_pressure) = self.hardness {
            let modulus = self.half_space.material.youngs_modulus;
            self.half_space.yield_strength = Some(strength_of_hardness(mean_pressure, self.law.flow(), modulus));
        }
    }
}

/// A number of a flow curve of one form.
pub type NumberOf = fn(&mut FlowCurve) -> Option<&mut f64>;

/// The functions that give the numbers of flow curves.
macro_rules! numbers {
    ($($form:ident: $number:ident;)+) => {$(
        pub(super) fn $number(flow: &mut FlowCurve) -> Option<&mut f64> {
            match flow {
                FlowCurve::$form { $number, .. } => Some($number),
                _ => None,
            }
        }
    )+};
}
numbers! { Power: exponent; Voce: saturation; Voce: rate; Linear: slope; }
