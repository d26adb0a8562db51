//! From what is written to the scene of an impact: the only place where a mass becomes a density, a hardness a strength, and
//! a height a speed.

use std::f64::consts::PI;

use super::input::{
    DampingInput, FlowInput, FrictionInput, GravityInput, HalfSpaceInput, ImpactInput, Input, LinearInput, OutputInput,
    PowerInput, SolverInput, SphereInput, VoceInput,
};
use super::keys::Key;
use super::taken::Taken;
use super::{DEFAULT_SAMPLES, Scene};
use crate::impact::{Approach, Damping, Forces, Incidence, Plate, Solver, drop_speed};
use crate::law::LawChoice;
use crate::material::{HalfSpace, Material, Sphere};
use crate::strength::flow::FlowCurve;
use crate::strength::hardness::strength_of_hardness;

impl Input {
    /// The scene. A number that is missing is not a number there; the scenario asks before whether all are given.
    pub fn resolve(&self) -> Scene {
        let mut law = self.law.clone();
        if let LawChoice::Plm(plm) = &mut law {
            plm.flow = self.half_space.flow_stress.curve();
        }
        self.resolve_under(law)
    }

    /// The same, under a law that was made of these keys before. Tables save a copy of the law for every row.
    pub fn resolve_under(&self, law: LawChoice) -> Scene {
        let Self { sphere, half_space, damping, .. } = self;
        let radius = self.radius().unwrap_or(f64::NAN);
        let mass = sphere.mass;
        let of_mass = |mass: f64| mass / (4.0 / 3.0 * PI * radius * radius * radius);
        let modulus = half_space.youngs_modulus.unwrap_or(f64::NAN);
        let hardness = half_space.hardness;
        let strength = match hardness {
            Some(mean_pressure) => Some(strength_of_hardness(mean_pressure, law.flow(), modulus)),
            None => half_space.yield_strength,
        };
        let hunt_crossley = damping.hunt_crossley.map(Damping::HuntCrossley);
        let viscous = || damping.viscous.map(Damping::Viscous);
        let &HalfSpaceInput { thickness, edge_distance, .. } = half_space;
        let theory = half_space.plate.unwrap_or_default();
        let plate = thickness.map(|thickness| Plate { thickness, edge_distance, theory });
        Scene {
            sphere: Sphere {
                radius,
                material: Material {
                    youngs_modulus: sphere.youngs_modulus.unwrap_or(f64::NAN),
                    poissons_ratio: sphere.poissons_ratio.unwrap_or(f64::NAN),
                },
                density: mass.map_or_else(|| sphere.density.unwrap_or(f64::NAN), of_mass),
                yield_strength: sphere.yield_strength,
            },
            half_space: HalfSpace {
                material: Material {
                    youngs_modulus: modulus,
                    poissons_ratio: half_space.poissons_ratio.unwrap_or(f64::NAN),
                },
                yield_strength: strength,
                density: half_space.density,
            },
            mass,
            moment_of_inertia: sphere.moment_of_inertia,
            hardness,
            speed: self.speed(),
            incidence: self.incidence(),
            friction: self.friction.coefficient,
            law,
            drop_height: self.impact.drop_height,
            forces: Forces { gravity: self.gravity.acceleration, damping: hunt_crossley.or_else(viscous), plate },
            plate_theory: theory,
            solver: self.solver(),
            samples: self.output.samples.and_then(|rows| rows.try_into().ok()).unwrap_or(DEFAULT_SAMPLES),
            materials: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// The impact speed \[m/s\]: that of the fall where a height is given.
    pub fn speed(&self) -> f64 {
        match (self.impact.drop_height, self.gravity.acceleration) {
            (Some(height), Some(gravity)) => drop_speed(gravity, height),
            _ => self.impact.speed.unwrap_or(f64::NAN),
        }
    }

    /// How the sphere comes in, if an angle or a spin is given.
    #[inline]
    fn incidence(&self) -> Option<Incidence> {
        let (angle, spin) = (self.impact.angle, self.sphere.spin);
        (angle.is_some() || spin.is_some()).then(|| Incidence {
            angle: angle.unwrap_or(0.0),
            spin: spin.unwrap_or(0.0),
            friction: self.friction.coefficient.unwrap_or(0.0),
        })
    }

    /// Speed, angle and spin at first touch.
    #[inline]
    pub fn approach(&self) -> Approach {
        Approach { speed: self.speed(), incidence: self.incidence() }
    }

    /// Method and tolerance.
    pub fn solver(&self) -> Solver {
        let SolverInput { tolerance, method, steps_per_contact } = self.solver;
        let defaults = Solver::default();
        let steps = steps_per_contact.and_then(|steps| steps.try_into().ok());
        Solver {
            method: method.unwrap_or(defaults.method),
            tolerance: tolerance.unwrap_or(defaults.tolerance),
            steps_per_contact: steps.unwrap_or(defaults.steps_per_contact),
        }
    }

    /// The sphere's radius \[m\], by its radius or its diameter.
    pub fn radius(&self) -> Option<f64> {
        self.sphere.radius.or(self.sphere.diameter.map(|diameter| 0.5 * diameter))
    }

    /// Puts what a body takes from its material in the place of what it took from another.
    pub fn take(&mut self, taken: &Taken) {
        for property in &taken.left {
            if let Some(key) = taken.body.path(*property).and_then(Key::find) {
                (key.set)(self, taken.material.of(*property).map(|known| taken.value(known)));
            }
        }
    }

    /// An input that resolves to this scene and gives every number that the scene has; the diameter would repeat the radius.
    pub fn of(scene: &Scene) -> Self {
        let Scene { sphere, half_space, forces, solver, .. } = scene;
        let [of_sphere, of_half_space] = [sphere.material, half_space.material];
        let (hunt_crossley, viscous) = match forces.damping {
            Some(Damping::HuntCrossley(chi)) => (Some(chi), None),
            Some(Damping::Viscous(share)) => (None, Some(share)),
            None => (None, None),
        };
        Self {
            sphere: SphereInput {
                radius: Some(sphere.radius),
                youngs_modulus: Some(of_sphere.youngs_modulus),
                poissons_ratio: Some(of_sphere.poissons_ratio),
                density: Some(sphere.density).filter(|_| scene.mass.is_none()),
                mass: scene.mass,
                moment_of_inertia: scene.moment_of_inertia,
                spin: scene.incidence.map(|incidence| incidence.spin),
                yield_strength: sphere.yield_strength,
                ..SphereInput::default()
            },
            half_space: HalfSpaceInput {
                youngs_modulus: Some(of_half_space.youngs_modulus),
                poissons_ratio: Some(of_half_space.poissons_ratio),
                yield_strength: half_space.yield_strength,
                hardness: scene.hardness,
                density: half_space.density,
                thickness: forces.plate.map(|plate| plate.thickness),
                edge_distance: forces.plate.and_then(|plate| plate.edge_distance),
                plate: Some(scene.plate_theory),
                flow_stress: scene.law.flow().map(FlowInput::of).unwrap_or_default(),
                material: None,
            },
            impact: ImpactInput {
                speed: Some(scene.speed),
                drop_height: scene.drop_height,
                angle: scene.incidence.map(|incidence| incidence.angle),
            },
            friction: FrictionInput { coefficient: scene.friction },
            gravity: GravityInput { acceleration: forces.gravity },
            damping: DampingInput { hunt_crossley, viscous },
            law: scene.law.clone(),
            solver: SolverInput {
                tolerance: Some(solver.tolerance),
                method: Some(solver.method),
                steps_per_contact: Some(solver.steps_per_contact.into()),
            },
            output: OutputInput { samples: Some(scene.samples as u64), columns: None },
        }
    }
}

impl FlowInput {
    /// The numbers of a curve.
    fn of(curve: &FlowCurve) -> Self {
        let mut input = Self::default();
        match *curve {
            FlowCurve::Power { exponent } => input.power = Some(PowerInput { exponent: Some(exponent) }),
            FlowCurve::Voce { saturation, rate } => {
                input.voce = Some(VoceInput { saturation: Some(saturation), rate: Some(rate) });
            }
            FlowCurve::Linear { slope } => input.linear = Some(LinearInput { slope: Some(slope) }),
            FlowCurve::Points(_) => input.points = Some(curve.clone()),
        }
        input
    }
}
