//! The numeric keys of a scenario: what they hold, and how to read and change them in a resolved scene. Checks, sweeps and
//! `check` share this one table.

use super::Scene;
use super::forces::{ACCELERATION, DROP_HEIGHT, HUNT_CROSSLEY, VISCOUS};
use super::quantity::{
    AREA_FACTOR, DENSITY, EXPONENT, FACTOR, LENGTH, MODULUS, POISSONS_RATIO, Quantity, SHARE, SPEED, SPHERE_MODULUS,
    STRENGTH, TOLERANCE, TRANSITION_RATIO,
};
use super::values::Exponent;
use crate::impact::Damping;
use crate::law::{LawChoice, UnloadingExponent};

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

/// A key that is a field of every scene.
macro_rules! of_scene {
    ($path:literal, $quantity:expr, optional $($field:ident).+) => {
        Key {
            path: $path,
            quantity: $quantity,
            get: |scene| scene.$($field).+,
            set: |scene, value| scene.$($field).+ = Some(value),
        }
    };
    ($path:literal, $quantity:expr, $($field:ident).+) => {
        Key {
            path: $path,
            quantity: $quantity,
            get: |scene| Some(scene.$($field).+),
            set: |scene, value| scene.$($field).+ = value,
        }
    };
}

/// A key of a published law: there only in a scene under that law.
macro_rules! of_law {
    ($path:literal, $quantity:expr, $law:ident, $field:ident) => {
        of_law!($path, $quantity, $law, $field, Some, std::convert::identity)
    };
    ($path:literal, $quantity:expr, $law:ident, optional $field:ident) => {
        of_law!($path, $quantity, $law, $field, std::convert::identity, Some)
    };
    ($path:literal, $quantity:expr, $law:ident, $field:ident, $get:expr, $set:expr) => {
        Key {
            path: $path,
            quantity: $quantity,
            get: |scene| match &scene.law {
                LawChoice::$law(law) => $get(law.$field),
                _ => None,
            },
            set: |scene, value| {
                if let LawChoice::$law(law) = &mut scene.law {
                    law.$field = $set(value);
                }
            },
        }
    };
}

/// All numeric keys, in the order of the file.
pub const KEYS: &[Key] = &[
    of_scene!("sphere.radius", &LENGTH, sphere.radius),
    Key {
        path: "sphere.diameter",
        quantity: &LENGTH,
        get: |scene| Some(2.0 * scene.sphere.radius),
        set: |scene, value| scene.sphere.radius = 0.5 * value,
    },
    of_scene!("sphere.youngs_modulus", &SPHERE_MODULUS, sphere.material.youngs_modulus),
    of_scene!("sphere.poissons_ratio", &POISSONS_RATIO, sphere.material.poissons_ratio),
    of_scene!("sphere.density", &DENSITY, sphere.density),
    of_scene!("sphere.yield_strength", &STRENGTH, optional sphere.yield_strength),
    of_scene!("half_space.youngs_modulus", &MODULUS, half_space.material.youngs_modulus),
    of_scene!("half_space.poissons_ratio", &POISSONS_RATIO, half_space.material.poissons_ratio),
    of_scene!("half_space.yield_strength", &STRENGTH, optional half_space.yield_strength),
    of_scene!("half_space.density", &DENSITY, optional half_space.density),
    Key { path: "impact.speed", quantity: &SPEED, get: |scene| Some(scene.speed), set: Scene::set_speed },
    Key {
        path: "impact.drop_height",
        quantity: &DROP_HEIGHT,
        get: |scene| scene.drop_height,
        set: Scene::set_drop_height,
    },
    Key {
        path: "gravity.acceleration",
        quantity: &ACCELERATION,
        get: |scene| scene.forces.gravity,
        set: Scene::set_gravity,
    },
    Key {
        path: "damping.hunt_crossley",
        quantity: &HUNT_CROSSLEY,
        get: |scene| match scene.forces.damping {
            Some(Damping::HuntCrossley(chi)) => Some(chi),
            _ => None,
        },
        set: |scene, value| scene.forces.damping = Some(Damping::HuntCrossley(value)),
    },
    Key {
        path: "damping.viscous",
        quantity: &VISCOUS,
        get: |scene| match scene.forces.damping {
            Some(Damping::Viscous(zeta)) => Some(zeta),
            _ => None,
        },
        set: |scene, value| scene.forces.damping = Some(Damping::Viscous(value)),
    },
    Key {
        path: "law.plm.unloading_exponent",
        quantity: &EXPONENT,
        get: |scene| match (&scene.law, scene.exponent) {
            (LawChoice::Plm(_), UnloadingExponent::Paper) => Some(1.5),
            (LawChoice::Plm(_), UnloadingExponent::Fixed(value)) => Some(value),
            _ => None,
        },
        set: |scene, value| scene.exponent = Exponent::from(value).0,
    },
    of_law!("law.thornton.yield_pressure", &STRENGTH, Thornton, optional yield_pressure),
    of_law!("law.stronge.yield_pressure_ratio", &FACTOR, Stronge, yield_pressure_ratio),
    of_law!("law.stronge.unloading_factor", &FACTOR, Stronge, unloading_factor),
    of_law!("law.jackson_green.yield_factor", &FACTOR, JacksonGreen, optional yield_factor),
    of_law!("law.kogut_etsion.yield_factor", &FACTOR, KogutEtsion, optional yield_factor),
    of_law!("law.yigit_christoforou.yield_factor", &FACTOR, YigitChristoforou, optional yield_factor),
    of_law!("law.ma_liu.hardness_ratio", &FACTOR, MaLiu, hardness_ratio),
    of_law!("law.ma_liu.transition_ratio", &TRANSITION_RATIO, MaLiu, transition_ratio),
    of_law!("law.mesarovic_johnson.area_factor", &AREA_FACTOR, MesarovicJohnson, area_factor),
    of_law!("law.walton_braun.loading_stiffness", &FACTOR, WaltonBraun, loading_stiffness),
    of_law!("law.walton_braun.stiffness_ratio", &SHARE, WaltonBraun, stiffness_ratio),
    of_law!("law.johnson.dynamic_pressure", &STRENGTH, Johnson, optional dynamic_pressure),
    of_scene!("solver.tolerance", &TOLERANCE, solver.tolerance),
];
