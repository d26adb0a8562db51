//! The values that the bodies of a scene take from named materials, if the scenario does not give them itself.

use crate::materials::{MaterialEntry, Property, PropertyValue};
use crate::scenario::keys::{KeyId, NUMBER, body_key};

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
    pub fn select<T>(self, [sphere, half_space]: [T; 2]) -> T {
        match self {
            Self::Sphere => sphere,
            Self::HalfSpace => half_space,
        }
    }

    pub fn table_name(self) -> &'static str {
        self.select(["sphere", "half_space"])
    }

    /// The key that names its material.
    pub fn material(self) -> &'static str {
        self.select(["sphere.material", "half_space.material"])
    }

    /// The body whose material a key names.
    pub fn from_material_key(path: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|body| body.material() == path)
    }

    /// The keys for which the material of the body has values, each with the property that gives the value.
    pub fn material_keys(self) -> [(KeyId<NUMBER>, Property); 6] {
        [
            (body_key!(self, "density"), Property::Density),
            (body_key!(self, "youngs_modulus"), Property::YoungsModulus),
            (body_key!(self, "poissons_ratio"), Property::PoissonsRatio),
            (body_key!(self, "hardness"), Property::Hardness),
            (body_key!(self, "flow_stress.power.exponent"), Property::HardeningExponent),
            (body_key!(self, "rate.johnson_cook.c"), Property::RateSensitivity),
        ]
    }
}

/// A body and the material that it takes numbers from.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyMaterial {
    pub body: Body,
    pub material: &'static MaterialEntry,
    /// The keys that the scenario leaves to the material.
    pub defaults: Vec<(KeyId<NUMBER>, Property)>,
}

impl BodyMaterial {
    /// The keys that take a value, each with the property of the material.
    pub fn known_values(&self) -> impl Iterator<Item = (&'static str, &'static PropertyValue)> {
        let material = self.material;
        self.defaults.iter().filter_map(move |(key, property)| Some((key.path(), material.get(*property)?)))
    }

    /// The values taken from the material, for a summary, each with its name: the value as written, its range, and the kind of number.
    pub fn value_notes(&self) -> impl Iterator<Item = (String, String)> {
        self.known_values().map(|(_, PropertyValue { property, value: used, range: [low, high], basis, .. })| {
            let name = format!("{}_{}", self.body.material(), property.name());
            (name, format!("{} ({} to {}); {basis}", used.text, low.text, high.text))
        })
    }
}
