//! Lines for the codes of the discrete element method: LAMMPS, LIGGGHTS, Yade, MercuryDPM.

use super::exporter::Exporter;
use super::springs::{damped_spring, non_cohesive_spring};
use crate::error::Error;
use crate::numerics::functions::{atan, pow};

/// Stiffness of a tangential spring over that of the normal one: both swing alike for a solid sphere.
const TANGENTIAL_STIFFNESS_RATIO: f64 = 2.0 / 7.0;

impl Exporter<'_> {
    /// Stiffness of the damped linear spring \[N/m\].
    fn stiffness(&self) -> f64 {
        damped_spring(self.contact.contact.reduced_mass(), self.e, self.impact.row.contact_time)
    }

    pub(super) fn lammps(&self) -> String {
        let tangential = match self.contact.friction {
            None => "linear_nohistory 0.0 0.0".to_owned(),
            Some(friction) => {
                format!("linear_history {:.9e} 0.0 {friction}", TANGENTIAL_STIFFNESS_RATIO * self.stiffness())
            }
        };
        let [contact, end] = match self.contact.ball {
            None => ["fix wall all wall/gran granular", " zplane 0.0 NULL"],
            Some(_) => ["comm_modify vel yes\npair_style granular\npair_coeff * *", ""],
        };
        format!(
            "units si\n{contact} hooke {:.9e} {:.9} damping coeff_restitution tangential {tangential}{end}\ntimestep {:.3e}\n",
            self.stiffness(),
            self.e,
            self.time_step()
        )
    }

    /// LIGGGHTS computes the stiffness k of its hooke model from a modulus Y: k = (16/15) √R Y* (15 m V²/(16 √R
    /// Y*))^(1/5), with Y* = Y/(2 (1 − ν²)) for equal bodies and the characteristic velocity V.
    pub(super) fn liggghts(&self) -> Result<String, Error> {
        const POISSONS_RATIO: f64 = 0.3;
        // LIGGGHTS stops at such values
        const MIN_RESTITUTION: f64 = 0.05;
        const MIN_MODULUS: f64 = 5e6;
        if self.e <= MIN_RESTITUTION {
            return Err(Error::input(format!(
                "--to liggghts: LIGGGHTS refuses e of {MIN_RESTITUTION} or less, and e is {:.4} at {} m/s; give a lower --speed, or less damping",
                self.e, self.impact.speed
            )));
        }
        let (mass, speed) = (self.contact.contact.reduced_mass(), self.impact.speed);
        let scaled = pow(self.stiffness() / pow(mass * speed * speed, 0.2), 1.25);
        // the wall of these lines is flat
        let radius = match self.contact.ball {
            None => self.contact.contact.sphere().radius,
            Some(_) => self.contact.contact.pair().radius,
        };
        let effective = 15.0 * scaled / (16.0 * radius.sqrt());
        // without these words the tangential spring is as stiff as the normal one, and has damping
        let (friction, history) = self
            .contact
            .friction
            .map_or((0.0, "no_history"), |friction| (friction, "history tangential_damping off ktToKnUser on"));
        let modulus = 2.0 * (1.0 - POISSONS_RATIO * POISSONS_RATIO) * effective;
        let wall = match self.contact.ball {
            None => format!("fix wall all wall/gran model hooke tangential {history} primitive type 1 zplane 0.0\n"),
            Some(_) => String::new(),
        };
        let soft = if modulus < MIN_MODULUS { "soft_particles yes\n" } else { "" };
        Ok(format!(
            "{soft}hard_particles yes\nunits si\nfix young all property/global youngsModulus peratomtype {modulus:.9e}\n\
             fix poisson all property/global poissonsRatio peratomtype {POISSONS_RATIO}\n\
             fix restitution all property/global coefficientRestitution peratomtypepair 1 {:.9}\n\
             fix friction all property/global coefficientFriction peratomtypepair 1 {friction:?}\n\
             fix speed all property/global characteristicVelocity scalar {speed}\n\
             pair_style gran model hooke tangential {history}\npair_coeff * *\n\
             {wall}timestep {:.3e}\n",
            self.e,
            self.time_step()
        ))
    }

    /// Density of the second ball \[kg/m³\], where it is another one than that of the first.
    fn second_density(&self) -> Option<f64> {
        let contact = &self.contact.contact;
        let density = self.contact.ball.and(contact.half_space().density);
        density.filter(|density| *density != contact.sphere().density)
    }

    /// Yade puts the springs of the two materials in series, and its damped springs never pull.
    pub(super) fn yade(&self) -> Result<String, Error> {
        let (restitution, contact_time) = (self.e, self.impact.row.contact_time);
        let (stiffness, damping) = non_cohesive_spring(self.contact.contact.reduced_mass(), restitution, contact_time)
            .ok_or_else(|| {
                Error::input(format!(
                    "--to yade: a damped spring of Yade has e above exp(-2) = 0.135, and e is {restitution:.4}"
                ))
            })?;
        let friction = self.contact.friction.unwrap_or(0.0);
        let tangential = if friction > 0.0 { TANGENTIAL_STIFFNESS_RATIO * 2.0 * stiffness } else { 0.0 };
        let angle = atan(friction);
        let material = |name: &str, density: f64| {
            format!(
                "{name} = ViscElMat(density={density:.9e}, kn={:.9e}, cn={:.9e}, ks={tangential:?}, cs=0.0, frictionAngle={angle:?})\n\
                 O.materials.append({name})\n",
                2.0 * stiffness,
                2.0 * damping
            )
        };
        let second = self.second_density().map_or_else(String::new, |density| material("second_material", density));
        Ok(format!(
            "{}{second}functors = [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]\nO.dt = {:.3e}\n",
            material("material", self.contact.contact.sphere().density),
            self.time_step()
        ))
    }

    pub(super) fn mercury(&self) -> String {
        let (kind, friction) = match self.contact.friction {
            None => ("", String::new()),
            Some(friction) => (
                "SlidingFriction",
                format!(
                    "species.setSlidingStiffness({:.9e});\nspecies.setSlidingFrictionCoefficient({friction});\n",
                    TANGENTIAL_STIFFNESS_RATIO * self.stiffness()
                ),
            ),
        };
        // equal springs stay as they are where MercuryDPM mixes the two species
        let second = self.second_density().map_or_else(String::new, |density| {
            format!(
                "LinearViscoelastic{kind}Species second_species = species; // of the second sphere\n\
                 second_species.setDensity({density:.9e});\n"
            )
        });
        let of_mass = match self.contact.ball {
            None => "2 m: a wall has no mass",
            Some(_) => "twice the effective mass of the two spheres",
        };
        format!(
            "LinearViscoelastic{kind}Species species; // then speciesHandler.copyAndAddObject(species)\nspecies.setDensity({:.9e});\n\
             species.setCollisionTimeAndRestitutionCoefficient({:.9e}, {:.9}, 2.0*{:.9e}); // {of_mass}\n\
             {friction}{second}setTimeStep({:.3e});\n",
            self.contact.contact.sphere().density,
            self.impact.row.contact_time,
            self.e,
            self.contact.contact.reduced_mass(),
            self.time_step()
        )
    }
}
