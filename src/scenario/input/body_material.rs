//! The values that the bodies of a scene take from named materials, if the scenario does not give them itself.

use crate::materials::{MaterialEntry, Property, PropertyValue};
use crate::scenario::keys::{At, NUMBER, key_of};

/// A body that may name its material.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    Sphere,
    HalfSpace,
}

impl Body {
    pub const ALL: [Self; 2] = [Self::Sphere, Self::HalfSpace];

    /// Selects the item of this body from a pair of sphere and half-space.
    #[inline]
    pub fn pick<T>(self, [sphere, half_space]: [T; 2]) -> T {
        match self {
            Self::Sphere => sphere,
            Self::HalfSpace => half_space,
        }
    }

    pub fn table(self) -> &'static str {
        self.pick(["sphere", "half_space"])
    }

    /// The key that names its material.
    pub fn material(self) -> &'static str {
        self.pick(["sphere.material", "half_space.material"])
    }

    /// The body whose material a key names.
    pub fn of_key(path: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|body| body.material() == path)
    }

    /// The keys for which the material of the body has values, each with the property that gives the value.
    pub fn defaults(self) -> [(At<NUMBER>, Property); 6] {
        [
            (key_of!(self, "density"), Property::Density),
            (key_of!(self, "youngs_modulus"), Property::YoungsModulus),
            (key_of!(self, "poissons_ratio"), Property::PoissonsRatio),
            (key_of!(self, "hardness"), Property::Hardness),
            (key_of!(self, "flow_stress.power.exponent"), Property::HardeningExponent),
            (key_of!(self, "rate.johnson_cook.c"), Property::RateSensitivity),
        ]
    }
}

/// A body and the material that it takes numbers from.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyMaterial {
    pub body: Body,
    pub material: &'static MaterialEntry,
    /// The keys that the scenario leaves to the material.
    pub defaults: Vec<(At<NUMBER>, Property)>,
}

impl BodyMaterial {
    /// The keys that take a value, each with the property of the material.
    pub fn values(&self) -> impl Iterator<Item = (&'static str, &'static PropertyValue)> {
        let material = self.material;
        self.defaults.iter().filter_map(move |(key, property)| Some((key.path(), material.get(*property)?)))
    }

    /// The values taken from the material, for a summary, each with its name: the value as written, its range, and the kind of number.
    pub fn notes(&self) -> impl Iterator<Item = (String, String)> {
        self.values().map(|(_, PropertyValue { property, value: used, range: [low, high], basis, .. })| {
            let name = format!("{}_{}", self.body.material(), property.name());
            (name, format!("{} ({} to {}); {basis}", used.text, low.text, high.text))
        })
    }
}
