//! The values of the keys as the file is read into them: each knows the quantity it is checked against.

use serde::de::{Deserialize, Deserializer, Error};

use super::forces::{ACCELERATION, DROP_HEIGHT, HUNT_CROSSLEY, VISCOUS};
use super::quantity::{
    AREA_FACTOR, DENSITY, DEPTH_RATIO, ENERGY, EXPONENT, FACTOR, FORCE, INDENTATION, LENGTH, LOAD, MODULUS,
    POISSONS_RATIO, SAMPLES, SHARE, SPEED, SPHERE_MODULUS, STEPS, STRENGTH, TOLERANCE, TRANSITION_RATIO,
};
use super::reader::{OrWord, Reader, whole};
use super::repeat::{IMPACTS, SHOT_SPEED};
use crate::impact::Method;
use crate::law::UnloadingExponent;
use crate::nearest::nearest;

macro_rules! checked {
    ($($(#[$doc:meta])* $name:ident: $quantity:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $name(
            /// In SI.
            pub f64,
        );

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(Reader(&$quantity)).map(Self)
            }
        }
    )*};
}

checked! {
    /// A radius or diameter.
    Length: LENGTH;
    /// A Young's modulus.
    Modulus: MODULUS;
    /// A yield strength.
    Strength: STRENGTH;
    /// A density.
    Density: DENSITY;
    /// A speed.
    Speed: SPEED;
    /// The speed of a shot.
    ShotSpeed: SHOT_SPEED;
    /// Gravity.
    Acceleration: ACCELERATION;
    /// A drop height.
    DropHeight: DROP_HEIGHT;
    /// χ of Hunt and Crossley.
    HuntCrossley: HUNT_CROSSLEY;
    /// Fraction of critical damping.
    ViscousFraction: VISCOUS;
    /// A load.
    Load: LOAD;
    /// An indentation.
    Depth: INDENTATION;
    /// A Poisson's ratio.
    PoissonsRatio: POISSONS_RATIO;
    /// A relative tolerance.
    Tolerance: TOLERANCE;
    /// A factor of a published law.
    Factor: FACTOR;
    /// An area factor.
    AreaFactor: AREA_FACTOR;
    /// A transition ratio.
    TransitionRatio: TRANSITION_RATIO;
    /// Indentation over that at yield.
    DepthRatio: DEPTH_RATIO;
    /// A force.
    Force: FORCE;
    /// An energy.
    Energy: ENERGY;
    /// A ratio of at most 1.
    Share: SHARE;
}

/// The sphere's Young's modulus; infinite if "rigid".
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphereModulus(
    /// In Pa.
    pub f64,
);

impl<'de> Deserialize<'de> for SphereModulus {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let visitor = OrWord { quantity: &SPHERE_MODULUS, words: &[("rigid", f64::INFINITY)] };
        deserializer.deserialize_any(visitor).map(Self)
    }
}

/// The exponent of the unloading branch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exponent(pub UnloadingExponent);

impl From<f64> for Exponent {
    fn from(value: f64) -> Self {
        Self(match value {
            1.5 => UnloadingExponent::Paper,
            _ if value.is_infinite() => UnloadingExponent::PressureShape,
            _ => UnloadingExponent::Fixed(value),
        })
    }
}

impl<'de> Deserialize<'de> for Exponent {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        // infinity, which no number of the range is, stands for the word between reader and type
        let visitor = OrWord { quantity: &EXPONENT, words: &[("pressure-shape", f64::INFINITY)] };
        deserializer.deserialize_any(visitor).map(Self::from)
    }
}

macro_rules! counted {
    ($($(#[$doc:meta])* $name:ident($number:ty): $quantity:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub struct $name(pub $number);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a whole number within the range
                whole(deserializer, &$quantity).map(|count| Self(count as $number))
            }
        }
    )*};
}

counted! {
    /// Rows of a trace.
    Samples(usize): SAMPLES;
    /// Steps of the fixed-step method.
    Steps(u32): STEPS;
    /// Repeated impacts.
    Impacts(u64): IMPACTS;
}

/// A method by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MethodName(pub Method);

impl<'de> Deserialize<'de> for MethodName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Method::ALL.iter().find(|(known, _)| *known == name).map(|(_, method)| Self(*method)).ok_or_else(|| {
            let names = || Method::ALL.iter().map(|(name, _)| *name);
            let guess = nearest(&name, names()).map_or_else(String::new, |near| format!(", did you mean \"{near}\"?"));
            let known: Vec<_> = names().map(|name| format!("\"{name}\"")).collect();
            D::Error::custom(format!("unknown method \"{name}\"{guess}; methods are {}", known.join(", ")))
        })
    }
}
