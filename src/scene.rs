//! The scene of an impact in plain numbers, and the registry of the keys that give these numbers.

pub(crate) mod key;
pub mod keys;
mod material;
pub mod other_keys;
pub mod quantity;
pub mod reference;
pub(crate) mod results;
pub mod schema;
pub(crate) mod strength;
pub(crate) mod taken;
pub mod words;

use crate::impact::{Contact, Forces, ImpactError, Solver, Warning, drop_speed};
use crate::law::LawChoice;
use crate::material::{HalfSpace, Material, Sphere};
pub use key::Key;
pub use keys::{EITHER, KEYS};
use taken::Taken;

/// Evenly spaced rows of a trace, unless the scenario gives another number.
pub const DEFAULT_SAMPLES: usize = 400;

/// The scene that a scenario describes: bodies, speed, law, solver. All numbers are in SI, and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    pub sphere: Sphere,
    pub half_space: HalfSpace,
    /// Mass \[kg\] of all that moves with the sphere, if the scene names it in place of a density.
    pub mass: Option<f64>,
    /// Hardness of the half-space as a mean pressure \[Pa\], if the scene names it in place of a yield strength.
    pub hardness: Option<f64>,
    /// Impact speed \[m/s\].
    pub speed: f64,
    /// The law with its parameters.
    pub law: LawChoice,
    /// Height of the fall \[m\] that gives the speed, if the scene names one.
    pub drop_height: Option<f64>,
    /// Gravity and damping.
    pub forces: Forces,
    /// Method and tolerance.
    pub solver: Solver,
    /// Evenly spaced rows of the trace.
    pub samples: usize,
    /// The values that the bodies take from named materials.
    pub materials: Vec<Taken>,
    /// Warnings about keys without effect.
    pub warnings: Vec<Warning>,
}

impl Scene {
    /// A scene under this law. Its other numbers are not set yet.
    pub fn of_law(law: LawChoice) -> Self {
        let material = Material { youngs_modulus: f64::NAN, poissons_ratio: f64::NAN };
        Self {
            sphere: Sphere { radius: f64::NAN, material, density: f64::NAN, yield_strength: None },
            half_space: HalfSpace { material, yield_strength: None, density: None },
            mass: None,
            hardness: None,
            speed: f64::NAN,
            law,
            drop_height: None,
            forces: Forces::default(),
            solver: Solver::default(),
            samples: DEFAULT_SAMPLES,
            materials: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// The bodies paired under the law.
    ///
    /// # Errors
    /// [`ImpactError`] where a constant of the pair over- or underflows, and for a law that lacks a half.
    pub fn contact(&self) -> Result<Contact, ImpactError> {
        let contact = Contact::try_new(self.sphere, self.half_space, self.law.get())?;
        let contact = if self.mass.is_some() { contact.of_a_body() } else { contact };
        Ok(contact.with_forces(self.forces))
    }

    /// Sets gravity \[m/s²\]. The speed from a drop height follows.
    pub fn set_gravity(&mut self, acceleration: f64) {
        self.forces.gravity = Some(acceleration);
        if let Some(height) = self.drop_height {
            self.speed = drop_speed(acceleration, height);
        }
    }

    /// Sets the drop height \[m\]. The speed follows if there is gravity.
    pub fn set_drop_height(&mut self, height: f64) {
        self.drop_height = Some(height);
        if let Some(gravity) = self.forces.gravity {
            self.speed = drop_speed(gravity, height);
        }
    }

    /// Sets the impact speed \[m/s\], and removes a drop height.
    pub fn set_speed(&mut self, speed: f64) {
        (self.speed, self.drop_height) = (speed, None);
    }
}
