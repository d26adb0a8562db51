//! The scene of an impact in plain numbers, and the tables of a scenario that give these numbers.

pub(crate) mod at;
mod effect;
mod gone;
pub mod input;
pub mod key;
pub mod keys;
mod laws;
pub mod list;
pub mod measured;
pub mod quantity;
pub(crate) mod read;
mod resolve;
pub(crate) mod results;
pub(crate) mod tables;
pub(crate) mod taken;
pub mod words;
pub(crate) mod written;

use crate::impact::{Approach, Contact, Forces, ImpactError, Incidence, Solver, Warning};
use crate::law::LawChoice;
use crate::material::{HalfSpace, Sphere};
use at::at;
pub use effect::{STEPS, Use, without_effect};
pub use input::Input;
pub use keys::{EITHER, KEYS, Key};
pub use list::EVERY_KEY;
use taken::Taken;

/// Evenly spaced rows of a trace, unless the scenario gives another number.
pub const DEFAULT_SAMPLES: usize = 400;

/// The scene that a scenario describes: bodies, speed, law, solver. All numbers are in SI, and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The keys that give it.
    pub input: Input,
    pub sphere: Sphere,
    pub half_space: HalfSpace,
    /// Impact speed \[m/s\].
    pub speed: f64,
    /// Angle and spin, if the scene names one of them.
    pub incidence: Option<Incidence>,
    /// The law with its parameters.
    pub law: LawChoice,
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
    /// The bodies paired under the law.
    ///
    /// # Errors
    /// [`ImpactError`] where a constant of the pair over- or underflows, and for a law that lacks a half.
    pub fn contact(&self) -> Result<Contact, ImpactError> {
        self.input.contact(self.sphere, self.half_space, &self.law)
    }

    /// How the sphere comes in at a speed.
    pub fn approach_at(&self, speed: f64) -> Approach {
        Approach { speed, incidence: self.incidence }
    }

    /// Whether more than a yield strength describes the flow stress, or the law does not use it.
    pub fn has_flow(&self) -> bool {
        self.input.number(at!("half_space.hardness")).is_some()
            || self.law.flow().is_some()
            || matches!(self.law, LawChoice::Hertz(_))
    }
}
