//! The values that the bodies of a scene take from named materials.

use super::at::{At, WORD, at};
use crate::materials::{Entry, Known, Property};

/// A body that may name its material.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Body {
    /// The sphere.
    Sphere,
    /// The half-space.
    HalfSpace,
}

impl Body {
    /// Both of them.
    pub const ALL: [Self; 2] = [Self::Sphere, Self::HalfSpace];

    /// The key that names its material.
    pub fn material(self) -> &'static str {
        match self {
            Self::Sphere => "sphere.material",
            Self::HalfSpace => "half_space.material",
        }
    }

    /// That key in an input.
    pub fn material_key(self) -> At<WORD> {
        match self {
            Self::Sphere => at!("sphere.material"),
            Self::HalfSpace => at!("half_space.material"),
        }
    }

    /// The body whose material a key names.
    pub fn of_key(path: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|body| body.material() == path)
    }

    /// The key that takes its value from this property, if the body uses the property.
    pub fn path(self, property: Property) -> Option<&'static str> {
        match (self, property) {
            (Self::Sphere, Property::Density) => Some("sphere.density"),
            (Self::Sphere, Property::YoungsModulus) => Some("sphere.youngs_modulus"),
            (Self::Sphere, Property::PoissonsRatio) => Some("sphere.poissons_ratio"),
            // the sphere has a yield strength only, and that only serves to warn
            (Self::Sphere, Property::Hardness) => Some("sphere.yield_strength"),
            (Self::Sphere, Property::HardeningExponent) => None,
            (Self::HalfSpace, Property::Density) => Some("half_space.density"),
            (Self::HalfSpace, Property::YoungsModulus) => Some("half_space.youngs_modulus"),
            (Self::HalfSpace, Property::PoissonsRatio) => Some("half_space.poissons_ratio"),
            (Self::HalfSpace, Property::Hardness) => Some("half_space.hardness"),
            (Self::HalfSpace, Property::HardeningExponent) => Some("half_space.flow_stress.power.exponent"),
        }
    }
}

/// A body and the material that it takes numbers from.
#[derive(Debug, Clone, PartialEq)]
pub struct Taken {
    /// Which body.
    pub body: Body,
    /// Its material.
    pub material: &'static Entry,
    /// The properties that the scenario does not give itself.
    pub left: Vec<Property>,
}

impl Taken {
    /// The keys that take a value, each with what is known of the property.
    pub fn values(&self) -> impl Iterator<Item = (&'static str, &'static Known)> {
        let material = self.material;
        self.left.iter().filter_map(move |property| Some((self.body.path(*property)?, material.of(*property)?)))
    }

    /// The value of such a key, in SI.
    pub fn value(&self, known: &Known) -> f64 {
        self.in_key(known.property, known.taken.value)
    }

    /// Both ends of its range, in SI.
    pub fn range(&self, known: &Known) -> [f64; 2] {
        [&known.range[0], &known.range[1]].map(|end| self.in_key(known.property, end.value))
    }

    /// The taken values for a summary, each with its name: the value as it is written, its range, and the kind of number.
    pub fn notes(&self) -> impl Iterator<Item = (String, String)> {
        self.values().map(|(_, Known { property, taken, range: [low, high], basis, .. })| {
            let name = format!("{}_{}", self.body.material(), property.name());
            (name, format!("{} ({} to {}); {basis}", taken.text, low.text, high.text))
        })
    }

    /// The value of the key. From a hardness the sphere takes the yield strength.
    fn in_key(&self, property: Property, value: f64) -> f64 {
        match (self.body, property) {
            (Body::Sphere, Property::Hardness) => self.material.strength(value),
            _ => value,
        }
    }
}
