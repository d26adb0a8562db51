//! The scene of an impact in plain numbers, and the tables of a scenario that give these numbers.

mod effect;
pub(crate) mod field;
pub mod input;
pub mod key;
pub mod keys;
pub mod laws;
pub mod measured;
pub mod quantity;
pub(crate) mod read;
mod resolve;
pub(crate) mod results;
pub(crate) mod table;
pub(crate) mod taken;
pub mod words;
pub(crate) mod written;

use crate::impact::{Approach, Contact, Forces, ImpactError, Incidence, PlateTheory, Solver, Warning};
use crate::law::LawChoice;
use crate::material::{HalfSpace, Sphere};
pub use effect::{Use, without_effect};
pub use input::Input;
pub use keys::{EITHER, KEYS, Key};
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
    /// Moment of inertia \[kg m²\], if it is not that of a solid sphere.
    pub moment_of_inertia: Option<f64>,
    /// Impact speed \[m/s\].
    pub speed: f64,
    /// Angle and spin, if the scene names one of them.
    pub incidence: Option<Incidence>,
    /// Coefficient of friction, if the scene names one.
    pub friction: Option<f64>,
    /// The law with its parameters.
    pub law: LawChoice,
    /// Height of the fall \[m\] that gives the speed, if the scene names one.
    pub drop_height: Option<f64>,
    /// Gravity and damping.
    pub forces: Forces,
    /// How a plate gives way, if one is hit.
    pub plate_theory: PlateTheory,
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
        let contact = Contact::try_new(self.sphere, self.half_space, self.law.get())?;
        let contact = if self.mass.is_some() { contact.of_a_body() } else { contact };
        let contact = match self.moment_of_inertia {
            Some(moment) => contact.with_moment_of_inertia(moment),
            None => contact,
        };
        Ok(contact.with_forces(self.forces))
    }

    /// How the sphere comes in at a speed.
    pub fn approach_at(&self, speed: f64) -> Approach {
        Approach { speed, incidence: self.incidence }
    }

    /// Whether more than a yield strength describes the flow stress, or the law does not use it.
    pub fn has_flow(&self) -> bool {
        self.hardness.is_some() || self.law.flow().is_some() || matches!(self.law, LawChoice::Hertz(_))
    }
}
