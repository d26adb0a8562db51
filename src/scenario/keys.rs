//! The numeric keys of a scenario: what they hold, and how to read and change them in a resolved scene. Checks, sweeps and
//! `check` share this one table.

use super::Scene;
use super::quantity::{
    DENSITY, EXPONENT, Exponent, LENGTH, MODULUS, POISSONS_RATIO, Quantity, SPEED, SPHERE_MODULUS, STRENGTH, TOLERANCE,
};
use crate::law::UnloadingExponent;

/// A numeric key.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// As in the file, with dots: `impact.speed`.
    pub path: &'static str,
    /// Dimension and allowed range.
    pub quantity: &'static Quantity,
    /// Its value in a scene, SI; `None` where the scene has none.
    pub get: fn(&Scene) -> Option<f64>,
    /// Puts a checked value, SI, into a scene.
    pub set: fn(&mut Scene, f64),
}

impl Key {
    /// The key of that path.
    #[must_use]
    pub fn find(path: &str) -> Option<&'static Self> {
        KEYS.iter().find(|key| key.path == path)
    }

    /// The name of its column in tables, with its unit: `impact_speed_m_per_s`.
    #[must_use]
    pub fn column(&self) -> String {
        format!("{}{}", self.path.replace('.', "_"), self.quantity.dimension.suffix())
    }
}

/// All numeric keys, in the order of the file.
pub const KEYS: &[Key] = &[
    Key {
        path: "sphere.radius",
        quantity: &LENGTH,
        get: |scene| Some(scene.sphere.radius),
        set: |scene, value| scene.sphere.radius = value,
    },
    Key {
        path: "sphere.diameter",
        quantity: &LENGTH,
        get: |scene| Some(2.0 * scene.sphere.radius),
        set: |scene, value| scene.sphere.radius = 0.5 * value,
    },
    Key {
        path: "sphere.youngs_modulus",
        quantity: &SPHERE_MODULUS,
        get: |scene| Some(scene.sphere.material.youngs_modulus),
        set: |scene, value| scene.sphere.material.youngs_modulus = value,
    },
    Key {
        path: "sphere.poissons_ratio",
        quantity: &POISSONS_RATIO,
        get: |scene| Some(scene.sphere.material.poissons_ratio),
        set: |scene, value| scene.sphere.material.poissons_ratio = value,
    },
    Key {
        path: "sphere.density",
        quantity: &DENSITY,
        get: |scene| Some(scene.sphere.density),
        set: |scene, value| scene.sphere.density = value,
    },
    Key {
        path: "sphere.yield_strength",
        quantity: &STRENGTH,
        get: |scene| scene.sphere.yield_strength,
        set: |scene, value| scene.sphere.yield_strength = Some(value),
    },
    Key {
        path: "half_space.youngs_modulus",
        quantity: &MODULUS,
        get: |scene| Some(scene.half_space.material.youngs_modulus),
        set: |scene, value| scene.half_space.material.youngs_modulus = value,
    },
    Key {
        path: "half_space.poissons_ratio",
        quantity: &POISSONS_RATIO,
        get: |scene| Some(scene.half_space.material.poissons_ratio),
        set: |scene, value| scene.half_space.material.poissons_ratio = value,
    },
    Key {
        path: "half_space.yield_strength",
        quantity: &STRENGTH,
        get: |scene| scene.half_space.yield_strength,
        set: |scene, value| scene.half_space.yield_strength = Some(value),
    },
    Key {
        path: "half_space.density",
        quantity: &DENSITY,
        get: |scene| scene.half_space.density,
        set: |scene, value| scene.half_space.density = Some(value),
    },
    Key {
        path: "impact.speed",
        quantity: &SPEED,
        get: |scene| Some(scene.speed),
        set: |scene, value| scene.speed = value,
    },
    Key {
        path: "law.plm.unloading_exponent",
        quantity: &EXPONENT,
        get: |scene| match scene.exponent {
            UnloadingExponent::Paper => Some(1.5),
            UnloadingExponent::Fixed(value) => Some(value),
            UnloadingExponent::PressureShape => None,
        },
        set: |scene, value| scene.exponent = Exponent::from(value).0,
    },
    Key {
        path: "solver.tolerance",
        quantity: &TOLERANCE,
        get: |scene| Some(scene.solver.tolerance),
        set: |scene, value| scene.solver.tolerance = value,
    },
];
