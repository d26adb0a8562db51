//! From what is written to the scene of an impact: the only place where a mass becomes a density, a hardness a strength, and
//! a height a speed.

use std::f64::consts::PI;

use super::at::at;
use super::input::Input;
use super::keys::Key;
use super::taken::{Body, Taken};
use super::{DEFAULT_SAMPLES, Scene};
use crate::impact::{
    Approach, Contact, Damping, Forces, ImpactError, Incidence, Method, Named, Plate, PlateTheory, STANDARD_GRAVITY,
    Solver, drop_speed,
};
use crate::law::LawChoice;
use crate::material::{HalfSpace, Material, Sphere};
use crate::materials::all;
use crate::strength::hardness::strength_of_hardness;

impl Input {
    /// The scene. A number that is missing is not a number there; the scenario asks before whether all are given.
    pub fn resolve(&self) -> Scene {
        let law = self.hardening_law();
        let (sphere, half_space) = self.bodies(&law);
        Scene {
            input: self.clone(),
            sphere,
            half_space,
            speed: self.speed(),
            incidence: self.incidence(),
            law,
            forces: self.forces(),
            solver: self.solver(),
            samples: self.count(at!("output.samples")).and_then(|rows| rows.try_into().ok()).unwrap_or(DEFAULT_SAMPLES),
            materials: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// The bodies. With a flow curve, which the law has, a hardness is another yield strength.
    pub fn bodies(&self, law: &LawChoice) -> (Sphere, HalfSpace) {
        let radius = self.radius().unwrap_or(f64::NAN);
        let of_mass = |mass: f64| mass / (4.0 / 3.0 * PI * radius * radius * radius);
        let number = |at| self.number(at);
        let modulus = number(at!("half_space.youngs_modulus")).unwrap_or(f64::NAN);
        let strength = match number(at!("half_space.hardness")) {
            Some(mean_pressure) => Some(strength_of_hardness(mean_pressure, law.flow(), modulus)),
            None => number(at!("half_space.yield_strength")),
        };
        let material = |youngs_modulus, poissons_ratio: Option<f64>| Material {
            youngs_modulus,
            poissons_ratio: poissons_ratio.unwrap_or(f64::NAN),
        };
        let density = number(at!("sphere.density")).unwrap_or(f64::NAN);
        let density = number(at!("sphere.mass")).map_or(density, of_mass);
        let of_sphere = number(at!("sphere.youngs_modulus")).unwrap_or(f64::NAN);
        let of_sphere = material(of_sphere, number(at!("sphere.poissons_ratio")));
        let of_half_space = material(modulus, number(at!("half_space.poissons_ratio")));
        let yield_strength = number(at!("sphere.yield_strength"));
        (
            Sphere { radius, material: of_sphere, density, yield_strength },
            HalfSpace { material: of_half_space, yield_strength: strength, density: number(at!("half_space.density")) },
        )
    }

    /// Gravity, damping and the plate.
    fn forces(&self) -> Forces {
        let number = |at| self.number(at);
        let viscous = || number(at!("damping.viscous")).map(Damping::Viscous);
        let damping = number(at!("damping.hunt_crossley")).map(Damping::HuntCrossley).or_else(viscous);
        let plate = number(at!("half_space.thickness")).map(|thickness| Plate {
            thickness,
            edge_distance: number(at!("half_space.edge_distance")),
            theory: self
                .word(at!("half_space.plate"))
                .map_or_else(PlateTheory::default, |place| PlateTheory::ALL[place]),
        });
        Forces { gravity: number(at!("gravity.acceleration")), damping, plate }
    }

    /// These bodies paired under this law.
    ///
    /// # Errors
    /// [`ImpactError`] where a constant of the pair over- or underflows, and for a law that lacks a half.
    pub fn contact(&self, sphere: Sphere, half_space: HalfSpace, law: &LawChoice) -> Result<Contact, ImpactError> {
        let contact = Contact::try_new(sphere, half_space, law.get())?;
        let contact = if self.number(at!("sphere.mass")).is_some() { contact.of_a_body() } else { contact };
        let contact = match self.number(at!("sphere.moment_of_inertia")) {
            Some(moment) => contact.with_moment_of_inertia(moment),
            None => contact,
        };
        let [sphere, half_space] =
            Body::ALL.map(|body| self.word(body.material_key()).and_then(|place| all().get(place)));
        let is_by_hardness = self.number(at!("half_space.hardness")).is_some() && law.flow().is_none();
        let named = Named { sphere, half_space, is_by_hardness };
        Ok(contact.with_forces(self.forces()).of_materials(named))
    }

    /// The impact speed \[m/s\]: that of the fall where a height is given.
    pub fn speed(&self) -> f64 {
        let fallen = self.number(at!("impact.drop_height")).map(|height| drop_speed(self.falling_gravity(), height));
        fallen.or(self.number(at!("impact.speed"))).unwrap_or(f64::NAN)
    }

    /// The gravity of falls and of rebounds to a height \[m/s²\]. Without `[gravity]` a height is only another way to say
    /// a speed.
    pub fn falling_gravity(&self) -> f64 {
        self.number(at!("gravity.acceleration")).unwrap_or(STANDARD_GRAVITY)
    }

    /// How the sphere comes in, if an angle or a spin is given.
    #[inline]
    fn incidence(&self) -> Option<Incidence> {
        let (angle, spin) = (self.number(at!("impact.angle")), self.number(at!("sphere.spin")));
        (angle.is_some() || spin.is_some()).then(|| Incidence {
            angle: angle.unwrap_or(0.0),
            spin: spin.unwrap_or(0.0),
            friction: self.number(at!("friction.coefficient")).unwrap_or(0.0),
        })
    }

    /// Speed, angle and spin at first touch.
    #[inline]
    pub fn approach(&self) -> Approach {
        Approach { speed: self.speed(), incidence: self.incidence() }
    }

    /// Method and tolerance.
    pub fn solver(&self) -> Solver {
        let defaults = Solver::default();
        let steps = self.count(at!("solver.steps_per_contact")).and_then(|steps| steps.try_into().ok());
        Solver {
            method: self.word(at!("solver.method")).map_or(defaults.method, |place| Method::ALL[place]),
            tolerance: self.number(at!("solver.tolerance")).unwrap_or(defaults.tolerance),
            steps_per_contact: steps.unwrap_or(defaults.steps_per_contact),
        }
    }

    /// Takes this method, unless one is named.
    pub fn choose_method(&mut self, method: Method) {
        if self.word(at!("solver.method")).is_none() {
            self.choose(at!("solver.method"), Method::ALL.iter().position(|known| *known == method));
        }
    }

    /// The sphere's radius \[m\], by its radius or its diameter.
    pub fn radius(&self) -> Option<f64> {
        let of_diameter = || Some(0.5 * self.number(at!("sphere.diameter"))?);
        self.number(at!("sphere.radius")).or_else(of_diameter)
    }

    /// Puts what a body takes from its material in the place of what it took from another.
    pub fn take(&mut self, taken: &Taken) {
        self.choose(taken.body.material_key(), all().iter().position(|known| known.name == taken.material.name));
        for property in &taken.left {
            if let Some(key) = taken.body.path(*property).and_then(Key::find) {
                key.set(self, taken.material.of(*property).map(|known| taken.value(known)));
            }
        }
    }
}
