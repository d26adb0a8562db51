//! Lines for codes of the discrete element method that ask for e, Young's modulus and Poisson's ratio, and compute spring and damping
//! themselves: EDEM, Rocky, MFiX, Lethe, Kratos.
//!
//! | code | equation of a contact, S = 2 E* √(R x), β = −ln e/√(π² + ln² e) | source |
//! |---|---|---|
//! | EDEM | (2/3) S x + 2 √(5/6) β √(S m) x' | Altair, EDEM, "Hertz-Mindlin (no slip)" |
//! | Lethe | the same | documentation of Lethe, "Discrete Element Method (DEM)"; source: e is the harmonic mean of both bodies |
//! | MFiX | (2/3) S x + 2 β √((2/3) S m) x' | source of MFiX, `check_solids_dem` and `calc_collision_wall` |
//! | Kratos | (2/3) S x + 2 γ √(S m) x', never below 0; γ from e by a fit (Thornton) | source of Kratos, `DEM_D_Hertz_viscous_Coulomb_CL`, `GammaForHertzThornton` |
//! | Rocky | hysteretic linear springs, without damping (Walton and Braun) | Ansys, Rocky DEM technical manual, 2.1.1.1 |
//!
//! If the equation holds until the overlap ends, the first equation has exactly the e of β, at every speed (Antypov and Elliott 2011).
//! The second equation is the first one with √(4/5) of its damping.

use super::exporter::Exporter;
use super::one_contact::{damped_hertz_contact, damping_ratio, restitution_of_ratio};
use super::springs::steps_per_contact;
use crate::contact::body::Material;
use crate::error::Error;
use crate::numerics::functions::pow;

/// The damping of MFiX over that of the equation with the e of β.
const MFIX_DAMPING: f64 = 0.894_427_190_999_915_9; // √(4/5)
/// Contact time of an elastic impact over largest indentation/impact speed: √π Γ(2/5)/Γ(9/10) · 4/5 (Hertz).
const HERTZ_TIME: f64 = 2.943_275;

/// The e that MFiX must be given for its equation to have this e. 0 if none is small enough.
fn mfix_restitution(e: f64) -> f64 {
    let ratio = damping_ratio(e) / MFIX_DAMPING;
    if ratio < 1.0 { restitution_of_ratio(ratio) } else { 0.0 }
}

/// The two bodies as a code asks for them: material, density \[kg/m³\].
struct Bodies {
    sphere: (Material, f64),
    /// The density of a wall may be unknown.
    other: (Material, Option<f64>),
}

impl Exporter<'_> {
    /// The bodies, if the code can compute a contact from them.
    fn bodies_for(&self, code: &str) -> Result<Bodies, Error> {
        let (sphere, half_space) = (self.contact.contact.sphere(), self.contact.contact.half_space());
        if !sphere.material.youngs_modulus.is_finite() {
            let message = format!(
                "--to {code}: this code needs Young's modulus of both bodies, and the sphere is rigid. Give sphere.youngs_modulus."
            );
            return Err(Error::input(message));
        }
        self.require_rebound(code)?;
        Ok(Bodies { sphere: (sphere.material, sphere.density), other: (half_space.material, half_space.density) })
    }

    /// Time step of the elastic contact of these bodies, which lasts less than the contact of the law \[s\].
    pub(super) fn hertz_time_step(&self) -> f64 {
        let contact = &self.contact.contact;
        let (mass, speed, pair) = (contact.reduced_mass(), self.impact.speed, contact.pair());
        let depth = pow(1.25 * mass * speed * speed / pair.hertz_stiffness(), 0.4);
        HERTZ_TIME * depth / speed / steps_per_contact(self.e)
    }

    /// The other body in words.
    fn other_body(&self) -> &'static str {
        if self.contact.ball.is_some() { "second sphere" } else { "wall" }
    }

    /// Values for the fields of the program, which has no input file in text.
    pub(super) fn edem(&self) -> Result<String, Error> {
        let bodies = self.bodies_for("edem")?;
        let friction = self.contact.friction.unwrap_or(0.0);
        let material = |title: &str, material: &Material, density: Option<f64>| {
            let Material { youngs_modulus, poissons_ratio } = material;
            let shear = youngs_modulus / (2.0 * (1.0 + poissons_ratio));
            let density = density.map_or_else(String::new, |density| format!(", solids density {density:.9e} kg/m^3"));
            format!(
                "material of the {title}: Young's modulus {youngs_modulus:.9e} Pa (shear modulus {shear:.9e} Pa), Poisson's ratio {poissons_ratio}{density}\n"
            )
        };
        Ok(format!(
            "# e of Hertz-Mindlin (no slip) is the e that you enter, at every speed, size and Young's modulus (Altair, EDEM, \"Hertz-Mindlin (no slip)\").\n\
             # No verified source: whether EDEM cuts off the attraction at the end of a contact; if EDEM does, e is {:.4}.\n\
             {}{}interaction: coefficient of restitution {:.9}, coefficient of static friction {friction:?}\n\
             physics: Hertz-Mindlin (no slip); time step {:.3e} s\n",
            self.e_without_attraction(),
            material("sphere", &bodies.sphere.0, Some(bodies.sphere.1)),
            material(self.other_body(), &bodies.other.0, bodies.other.1),
            self.e,
            self.hertz_time_step()
        ))
    }

    /// Values for the fields of the program.
    pub(super) fn rocky(&self) -> Result<String, Error> {
        let bodies = self.bodies_for("rocky")?;
        let friction = self.contact.friction.unwrap_or(0.0);
        let material = |title: &str, material: &Material, density: Option<f64>| {
            let Material { youngs_modulus, poissons_ratio } = material;
            let density = density.map_or_else(String::new, |density| format!(", density {density:.9e} kg/m^3"));
            format!(
                "material of the {title}: Young's modulus {youngs_modulus:.9e} Pa, Poisson's ratio {poissons_ratio}{density}\n"
            )
        };
        Ok(format!(
            "# The hysteretic linear spring loses energy by two stiffnesses and not by damping: e is the same at every speed (Ansys, Rocky DEM technical manual, 2.1.1.1).\n\
             # No verified source: that e is the root of the ratio of these stiffnesses, and the names of the fields.\n\
             {}{}interaction: restitution coefficient {:.9}, friction coefficient {friction:?}\n\
             normal force: hysteretic linear spring\n",
            material("sphere", &bodies.sphere.0, Some(bodies.sphere.1)),
            material(self.other_body(), &bodies.other.0, bodies.other.1),
            self.e,
        ))
    }

    /// Keys of `mfix.dat`, in SI. The arrays of pairs are the upper triangle: 11, 12, 22.
    pub(super) fn mfix(&self) -> Result<String, Error> {
        let bodies = self.bodies_for("mfix")?;
        let friction = self.contact.friction.unwrap_or(0.0);
        let given = mfix_restitution(self.e);
        let phase = |number: usize, radius: f64, material: &Material, density: f64| {
            format!(
                "D_P0({number}) = {:.9e}\nRO_S0({number}) = {density:.9e}\nE_YOUNG({number}) = {:.9e}\nV_POISSON({number}) = {}\n",
                2.0 * radius,
                material.youngs_modulus,
                material.poissons_ratio
            )
        };
        let sphere = phase(1, self.contact.contact.sphere().radius, &bodies.sphere.0, bodies.sphere.1);
        let (other, suffix, place) = match self.contact.ball {
            None => (
                format!(
                    "EW_YOUNG = {:.9e}\nVW_POISSON = {}\n",
                    bodies.other.0.youngs_modulus, bodies.other.0.poissons_ratio
                ),
                ("_WALL", "_W"),
                1,
            ),
            Some(radius) => (phase(2, radius, &bodies.other.0, bodies.other.1.unwrap_or(bodies.sphere.1)), ("", ""), 2),
        };
        Ok(format!(
            "# MFiX damps sqrt(4/5) as much as the e of its input needs (source of MFiX, check_solids_dem): e = {given:.9} in the input gives e = {:.6}, at every speed, size and Young's modulus.\n\
             # 1 for the tangential restitution is no tangential damping. Pairs of other phases need values of their own.\n\
             DES_COLL_MODEL = 'HERTZIAN'\n{sphere}{other}\
             DES_EN{}_INPUT({place}) = {given:.9}\nDES_ET{}_INPUT({place}) = 1.0\nMEW{} = {friction:?}\n\
             # MFiX chooses the time step itself: {:.3e} s or less is needed\n",
            self.e,
            suffix.0,
            suffix.0,
            suffix.1,
            self.hertz_time_step()
        ))
    }

    /// Subsections of a parameter file. e of a pair is the harmonic mean of the values of both bodies, so both get the e of the pair.
    pub(super) fn lethe(&self) -> Result<String, Error> {
        let bodies = self.bodies_for("lethe")?;
        let friction = self.contact.friction.unwrap_or(0.0);
        let e = self.e;
        let values = |indent: &str, body: &str, material: &Material| {
            let Material { youngs_modulus, poissons_ratio } = material;
            format!(
                "{indent}set young modulus {body} = {youngs_modulus:.9e}\n{indent}set poisson ratio {body} = {poissons_ratio}\n\
                 {indent}set restitution coefficient {body} = {e:.9}\n{indent}set friction coefficient {body} = {friction:?}\n"
            )
        };
        let particle = |number: usize, radius: f64, density: f64, material: &Material| {
            format!(
                "  subsection particle type {number}\n    set diameter = {:.9e}\n    set density particles = {density:.9e}\n{}  end\n",
                2.0 * radius,
                values("    ", "particles", material)
            )
        };
        let sphere = particle(0, self.contact.contact.sphere().radius, bodies.sphere.1, &bodies.sphere.0);
        let (count, other) = match self.contact.ball {
            None => (1, values("  ", "wall", &bodies.other.0)),
            Some(radius) => (2, particle(1, radius, bodies.other.1.unwrap_or(bodies.sphere.1), &bodies.other.0)),
        };
        Ok(format!(
            "# e of a pair is the harmonic mean of both bodies, and e of the nonlinear model is this e at every speed, size and Young's modulus (documentation and source of Lethe).\n\
             subsection lagrangian physical properties\n  set number of particle types = {count}\n{sphere}{other}end\n\
             subsection model parameters\n  set particle particle contact force method = hertz_mindlin_limit_overlap\n  \
             set particle wall contact force method = nonlinear\nend\n\
             subsection simulation control\n  set time step = {:.3e}\nend\n",
            self.hertz_time_step()
        ))
    }

    /// Parts of `MaterialsDEM.json`.
    pub(super) fn kratos(&self) -> Result<String, Error> {
        let bodies = self.bodies_for("kratos")?;
        let friction = self.contact.friction.unwrap_or(0.0);
        let material = |name: &str, number: usize, material: &Material, density: Option<f64>| {
            let Material { youngs_modulus, poissons_ratio } = material;
            let density = density.map_or_else(String::new, |density| format!("\"PARTICLE_DENSITY\": {density:.9e}, "));
            format!(
                "    {{\"material_name\": \"{name}\", \"material_id\": {number},\n     \"Variables\": {{{density}\"YOUNG_MODULUS\": {youngs_modulus:.9e}, \"POISSON_RATIO\": {poissons_ratio}}}}}"
            )
        };
        let other = if self.contact.ball.is_some() { "second_sphere" } else { "wall" };
        Ok(format!(
            "// e of this law is the e that you enter, at every speed, size and Young's modulus; a fit gives the damping (source of Kratos, DEM_D_Hertz_viscous_Coulomb).\n\
             // Parts of MaterialsDEM.json: delete these comments, because JSON has none. The time step is {:.3e} s or less.\n\
             {{\n  \"materials\": [\n{},\n{}\n  ],\n  \"material_relations\": [\n    {{\"material_names_list\": [\"sphere\", \"{other}\"], \"material_ids_list\": [1, 2],\n     \
             \"Variables\": {{\"COEFFICIENT_OF_RESTITUTION\": {:.9}, \"STATIC_FRICTION\": {friction:?}, \"DYNAMIC_FRICTION\": {friction:?}, \"FRICTION_DECAY\": 500.0,\n                   \
             \"DEM_DISCONTINUUM_CONSTITUTIVE_LAW_NAME\": \"DEM_D_Hertz_viscous_Coulomb\"}}}}\n  ]\n}}\n",
            self.hertz_time_step(),
            material("sphere", 1, &bodies.sphere.0, Some(bodies.sphere.1)),
            material(other, 2, &bodies.other.0, bodies.other.1),
            self.e
        ))
    }

    /// e of a contact with the damping of this e, if the force is cut off where it would attract.
    fn e_without_attraction(&self) -> f64 {
        damped_hertz_contact(damping_ratio(self.e)).0
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::numerics::functions::exp;

    /// The equation of MFiX has √(4/5) of the damping of an equation whose e is known exactly: e = exp(−π β/√(1 − β²)).
    #[test]
    fn mfix_is_given_less_restitution() {
        for e in [0.1, 0.5, 0.9] {
            let ratio = MFIX_DAMPING * damping_ratio(mfix_restitution(e));
            assert!((exp(-PI * ratio / (1.0 - ratio * ratio).sqrt()) / e - 1.0).abs() < 1e-12);
            assert!(mfix_restitution(e) < e);
        }
    }
}
