//! A material put into a scene.

use super::key::Key;
use super::taken::{Body, Taken};
use super::{LawChoice, Scene};
use crate::materials::Property;
use crate::strength::flow::FlowCurve;

impl Scene {
    /// Puts all that a body takes from a material into the scene, in place of another material.
    pub fn put_material(&mut self, taken: &Taken) {
        if taken.left.contains(&Property::Hardness) {
            match taken.body {
                Body::Sphere => self.sphere.yield_strength = None,
                Body::HalfSpace => (self.half_space.yield_strength, self.hardness) = (None, None),
            }
        }
        if taken.left.contains(&Property::HardeningExponent)
            && let LawChoice::Plm(plm) = &mut self.law
        {
            let exponent = taken.material.of(Property::HardeningExponent);
            plm.flow = exponent.map(|known| FlowCurve::Power { exponent: known.taken.value });
        }
        for (path, known) in taken.values() {
            if let Some(key) = Key::find(path) {
                (key.set)(self, taken.value(known));
            }
        }
    }
}
