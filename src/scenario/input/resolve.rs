//! From written values to bodies, contact and motion. Only here a mass becomes a density, a hardness a strength, and a height a
//! speed. A missing number is NaN here; the scenario checks before that all numbers are given.

use std::sync::Arc;

use super::{Body, BodyMaterial, Input, NumericKey, OBLIQUE_KEYS, SPIN_KEYS, Value};
use crate::contact::body::{HalfSpace, Sphere, Support, sphere_volume};
use crate::contact::law::LawChoice;
use crate::contact::pair::{Pair, YieldPartition};
use crate::contact::strength::kind::StrengthKind;
use crate::impact::flight::free_flight::{FreeFlight, Medium};
use crate::impact::{
    Approach, Contact, CrossMotion, Damping, Forces, ImpactError, MaterialNames, Method, Peening, Plate, PlateTheory,
    PulseRequest, Rod, STANDARD_GRAVITY, Solver, Waveguide,
};
use crate::materials::{MaterialEntry, all_materials};
use crate::numerics::comparison::is_below;
use crate::results::SUBSURFACE_COLUMNS;
use crate::scenario::keys::{Part, body_key, key};

/// Evenly spaced rows of a trace, unless the scenario gives another number.
pub const DEFAULT_SAMPLES: usize = 400;

impl Input {
    /// The bodies. With a flow curve in the law, a hardness gives another yield strength.
    pub fn bodies(&self, law: &LawChoice) -> (Sphere, HalfSpace) {
        let radius = self.radius().unwrap_or(f64::NAN);
        let of_mass = |mass: f64| mass / sphere_volume(radius);
        let number = |at| self.number(at);
        let [of_sphere, of_half_space] = law.flow_curves();
        let yield_strength = self.yield_strength(Body::Sphere, of_sphere);
        let strength = self.yield_strength(Body::HalfSpace, of_half_space);
        let density = number(key!("sphere.density")).unwrap_or(f64::NAN);
        let density = number(key!("sphere.mass")).map_or(density, of_mass);
        (
            Sphere { radius, material: self.material(Body::Sphere), density, yield_strength },
            HalfSpace {
                density: number(key!("half_space.density")),
                radius: number(key!("half_space.radius")),
                support: match number(key!("half_space.mass")) {
                    None => Support::Fixed,
                    Some(f64::INFINITY) => Support::Ball,
                    Some(mass) => Support::Free(mass),
                },
                ..HalfSpace::flat(self.material(Body::HalfSpace), strength)
            },
        )
    }

    /// How the yielding is divided between the bodies, if one of them yields.
    pub fn yield_partition(&self) -> Option<YieldPartition> {
        let (sphere, half_space) = self.bodies(&self.law());
        Some(Pair::try_new(&sphere, &half_space).ok()?.yield_point?.yield_partition)
    }

    /// True if only the other body yields: this one is stronger by at least the factor `least`, and the other body does not harden.
    pub fn is_harder(&self, body: Body, least: f64) -> bool {
        let law = self.law();
        self.yield_partition().is_some_and(|partition| {
            partition.for_softer(Body::ALL) != body
                && !is_below(partition.ratio, least)
                && partition.for_softer(law.flow_curves()).is_none()
        })
    }

    pub fn sphere(&self) -> Sphere {
        self.bodies(&self.law()).0
    }

    pub fn half_space(&self) -> HalfSpace {
        self.bodies(&self.law()).1
    }

    /// True if more than a yield strength describes the flow stress of a body, or if the law does not use it.
    pub fn has_flow(&self, body: Body) -> bool {
        let law = self.law();
        let is_hard = self.number(body_key!(body, "hardness")).is_some();
        is_hard || body.select(law.flow_curves()).is_some() || matches!(law, LawChoice::Hertz(_))
    }

    /// Gravity, damping, and the plate or rod.
    pub fn forces(&self) -> Forces {
        let number = |at| self.number(at);
        let viscous = || number(key!("damping.viscous")).map(Damping::Viscous);
        let viscoelastic = || number(key!("damping.viscoelastic_time")).map(Damping::Viscoelastic);
        let hunt_crossley = number(key!("damping.hunt_crossley")).map(Damping::HuntCrossley);
        let damping = hunt_crossley.or_else(viscous).or_else(viscoelastic);
        let plate = number(key!("half_space.thickness")).map(|thickness| {
            let theory = self.word(key!("half_space.plate"));
            let theory = theory.map_or_else(PlateTheory::default, |place| PlateTheory::ALL[place]);
            Waveguide::Plate(Plate { thickness, edge_distance: number(key!("half_space.edge_distance")), theory })
        });
        let rod = || {
            let diameter = number(key!("half_space.rod_diameter"))?;
            Some(Waveguide::Rod(Rod { diameter, length: number(key!("half_space.rod_length")) }))
        };
        let waveguide = plate.or_else(rod);
        Forces { gravity: number(key!("gravity.acceleration")), damping, waveguide, flight: self.free_flight() }
    }

    /// The flight of the sphere, if there is gravity or a height.
    pub fn free_flight(&self) -> Option<FreeFlight> {
        let falls = self.number(key!("gravity.acceleration")).or(self.number(key!("impact.drop_height"))).is_some();
        let gravity = self.drop_gravity();
        let in_vacuum = FreeFlight::in_vacuum(gravity);
        let in_air = || {
            let medium = self.air()?;
            Some(FreeFlight::in_air(gravity, &medium, self.radius()?, self.mass()?))
        };
        falls.then(|| in_air().unwrap_or(in_vacuum))
    }

    /// The air of the scenario.
    pub fn air(&self) -> Option<Medium> {
        let density = self.number(key!("air.density"))?;
        let drag = self.number(key!("air.drag")).filter(|drag| drag.is_finite());
        Some(Medium { density, drag, viscosity: self.number(key!("air.viscosity")).unwrap_or(f64::NAN) })
    }

    /// The moving mass \[kg\], given directly or by the density of the sphere.
    pub fn mass(&self) -> Option<f64> {
        let of_density = || Some(self.number(key!("sphere.density"))? * sphere_volume(self.radius()?));
        self.number(key!("sphere.mass")).or_else(of_density)
    }

    /// The pair of the bodies for the law.
    ///
    /// # Errors
    /// [`ImpactError`] if a constant of the pair over- or underflows, and for a law that lacks a loading or an unloading rule.
    pub fn contact(&self) -> Result<Contact, ImpactError> {
        let law = self.law();
        let (sphere, half_space) = self.bodies(&law);
        self.contact_of(sphere, half_space, &law)
    }

    /// Pairs these bodies under this law.
    pub fn contact_of(&self, sphere: Sphere, half_space: HalfSpace, law: &LawChoice) -> Result<Contact, ImpactError> {
        let mut contact = Contact::try_new(sphere, half_space, law.as_contact_law())?.with_forces(self.forces());
        if self.number(key!("sphere.mass")).is_some() {
            contact = contact.with_attached_mass();
        }
        if let Some(moment) = self.number(key!("sphere.moment_of_inertia")) {
            contact = contact.with_moment_of_inertia(moment);
        }
        let [sphere, half_space] = Body::ALL.map(|body| self.named_material(body));
        let flow = law.flow_curves();
        let is_by_hardness =
            Body::ALL.map(|body| self.number(body_key!(body, "hardness")).is_some() && body.select(flow).is_none());
        let is_of_impact = Body::ALL.map(|body| self.strength_kind(body) == Some(StrengthKind::Flow));
        let is_by_hardness = [0, 1].map(|place| is_by_hardness[place] && !is_of_impact[place]);
        let contact = contact.with_peening(self.peening()).with_subsurface(self.asks_for_subsurface());
        let contact = contact.with_adhesion(self.number(key!("adhesion.work")));
        let named = MaterialNames { sphere, half_space, is_by_hardness, is_of_impact };
        Ok(contact.with_materials(named).with_rate_dependence(self.rates(), law))
    }

    /// The request of shot peening.
    pub fn peening(&self) -> Option<Peening> {
        let coverage = self.number(key!("peening.coverage"))?;
        let flow = self.number(key!("peening.mass_flow")).zip(self.number(key!("peening.area")));
        let mass_flux = flow.map(|(flow, area)| flow / area);
        Some(Peening { coverage, mass_flux, time: self.number(key!("peening.time")) })
    }

    /// True if the plastic zone and the residual stress below the dent are asked for.
    pub fn asks_for_subsurface(&self) -> bool {
        let lists = [self.word_list(key!("output.columns")), self.word_list(key!("output.picture"))];
        let mut named = lists.into_iter().flatten().flatten();
        self.number(key!("peening.coverage")).is_some() || named.any(|name| SUBSURFACE_COLUMNS.contains(&name.as_str()))
    }

    /// The impact speed \[m/s\]: the speed after the fall if a height is given.
    pub fn speed(&self) -> f64 {
        let fallen =
            self.number(key!("impact.drop_height")).and_then(|height| Some(self.free_flight()?.landing_speed(height)));
        fallen.or(self.number(key!("impact.speed"))).unwrap_or(f64::NAN)
    }

    /// The gravity of falls and of rebounds to a height \[m/s²\]. Without `[gravity]` a height only determines a speed.
    pub fn drop_gravity(&self) -> f64 {
        self.number(key!("gravity.acceleration")).unwrap_or(STANDARD_GRAVITY)
    }

    /// True if an angle or a spin is given, so that friction is computed.
    #[inline]
    pub fn is_oblique(&self) -> bool {
        OBLIQUE_KEYS.into_iter().any(|key| self.number(key).is_some())
    }

    /// The angle of the impact from the normal \[rad\].
    #[inline]
    pub fn angle(&self) -> f64 {
        self.number(key!("impact.angle")).unwrap_or(0.0)
    }

    /// The spin of the sphere about the axis across its path \[rad/s\].
    #[inline]
    fn spin(&self) -> f64 {
        self.number(key!("sphere.spin")).unwrap_or(0.0)
    }

    /// The motion out of the plane of incidence, if a spin out of this plane is given.
    #[inline]
    pub fn cross_motion(&self) -> Option<CrossMotion> {
        let [_, path, normal] = SPIN_KEYS.map(|key| self.number(key));
        path.or(normal)?;
        Some(CrossMotion { speed: 0.0, spin_about_path: path.unwrap_or(0.0), spin_about_normal: normal.unwrap_or(0.0) })
    }

    /// Speed, angle and spin at first contact.
    #[inline]
    pub fn approach(&self) -> Approach {
        self.approach_at(self.speed())
    }

    /// Replaces the speed of [`Input::approach`].
    #[inline]
    pub fn approach_at(&self, speed: f64) -> Approach {
        if !self.is_oblique() {
            return speed.into();
        }
        let friction = self.number(key!("friction.coefficient")).unwrap_or(0.0);
        let mut approach = Approach::at_angle(speed, self.angle(), self.spin(), friction);
        approach.tangential.cross = self.cross_motion();
        approach
    }

    /// Method and tolerance.
    pub fn solver(&self) -> Solver {
        let defaults = Solver::default();
        let steps = self.count(key!("solver.steps_per_contact")).and_then(|steps| steps.try_into().ok());
        Solver {
            method: self.word(key!("solver.method")).map_or(defaults.method, |place| Method::ALL[place]),
            tolerance: self.number(key!("solver.tolerance")).unwrap_or(defaults.tolerance),
            steps_per_contact: steps.unwrap_or(defaults.steps_per_contact),
        }
    }

    /// Sets this method, unless the scenario names one.
    pub fn set_default_method(&mut self, method: Method) {
        if self.word(key!("solver.method")).is_none() {
            self.set_word(key!("solver.method"), Method::ALL.iter().position(|known| *known == method));
        }
    }

    /// True if a row of a table, or at least its times, are integrated.
    pub fn is_integrated(&self) -> bool {
        let forces = self.forces();
        let method = self.solver().method.resolve(&forces, false);
        forces.gravity.is_some() || method.is_some_and(|method| method != Method::ClosedForm)
    }

    /// The request of a pulse, if there is one.
    pub fn pulse(&self) -> Option<PulseRequest> {
        let step = self.number(key!("output.pulse.step"))?;
        Some(PulseRequest { step, padding: self.count(key!("output.pulse.padding")) })
    }

    /// Evenly spaced rows of the trace.
    pub fn samples(&self) -> usize {
        self.count(key!("output.samples")).and_then(|rows| rows.try_into().ok()).unwrap_or(DEFAULT_SAMPLES)
    }

    /// The sphere's radius \[m\], by its radius or its diameter.
    pub fn radius(&self) -> Option<f64> {
        let of_diameter = || Some(0.5 * self.number(key!("sphere.diameter"))?);
        self.number(key!("sphere.radius")).or_else(of_diameter)
    }

    pub fn named_material(&self, body: Body) -> Option<&'static MaterialEntry> {
        // the file of materials is read only for a body that names one
        self.word(body_key!(body, "material")).and_then(|place| all_materials().get(place))
    }

    /// Replaces the values that a body took from another material by the values of its material.
    pub fn apply_material(&mut self, choice: &BodyMaterial) {
        self.set_word(
            body_key!(choice.body, "material"),
            all_materials().iter().position(|known| known.name == choice.material.name),
        );
        if !self.materials().contains(choice) {
            let others = self.materials().iter().filter(|other| other.body != choice.body);
            self.set_materials(others.chain([choice]).cloned().collect());
        }
        for &(at, property) in &choice.defaults {
            self.set(at, choice.material.get(property).map(|known| known.value.value));
        }
    }

    /// The input with the values that follow from others, and with the defaults of the used keys, for reports.
    pub fn with_derived_values(&self) -> Self {
        let mut input = self.clone();
        input.set(key!("sphere.radius"), self.radius());
        input.set(key!("sphere.diameter"), None);
        for body in Body::ALL {
            input.set_word(body_key!(body, "material"), None);
        }
        let (sphere, half_space) = self.bodies(&self.law());
        input.replace_strength(Body::Sphere, sphere.yield_strength);
        input.replace_strength(Body::HalfSpace, half_space.yield_strength);
        input.set(key!("impact.speed"), Some(self.speed()));
        if self.is_oblique() {
            input.set(key!("impact.angle"), Some(self.angle()));
            input.set(key!("sphere.spin"), Some(self.spin()));
            if let Some(cross) = self.cross_motion() {
                input.set(key!("sphere.spin_about_path"), Some(cross.spin_about_path));
                input.set(key!("sphere.spin_about_normal"), Some(cross.spin_about_normal));
            }
        }
        input.set_default_method(self.solver().method);
        let is_on_plate = self.number(key!("half_space.thickness")).is_some();
        let rates = self.rates();
        let is_raised = |path: &str| {
            Body::ALL.iter().zip(rates).any(|(body, rate)| path.starts_with(body.rate_table()) && rate.is_some())
        };
        let has_reference = |path: &str| {
            !path.ends_with(".reference")
                || NumericKey::find(&path.replace("reference", "c")).is_some_and(|c| self.number(c).is_some())
        };
        input.fill_defaults(|key| match key.part {
            Part::Rate => is_raised(key.path) && has_reference(key.path),
            Part::Law => self.is_law_key(key.path),
            Part::Motion => is_on_plate,
            part => matches!(part, Part::Solver | Part::Output),
        });
        let coefficients = key!("law.plm.coefficients");
        if let (LawChoice::Plm(law), None) = (&self.named_law, self.value(coefficients)) {
            input.set_value(coefficients, Some(Value::Coefficients(Arc::clone(&law.coefficients))));
        }
        input
    }
}
