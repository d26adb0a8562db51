//! The request, for which code and at which speeds, and the input lines in the form of each code.

use std::fmt::Write as _;

use super::exported_contact::ExportedContact;
use super::springs::{
    MAX_RESTITUTION_ERROR, constant_restitution_range, damped_spring, non_cohesive_spring, steps_per_contact,
};
use crate::error::Error;
use crate::files::PROGRAM;
use crate::impact::flight::free_flight::FreeFlight;
use crate::impact::{Impact, ImpactRow, STANDARD_GRAVITY, StrainRateResult};
use crate::numerics::functions::{atan, pow};
use crate::scenario::Scenario;
use crate::strings::named_enum;
use crate::units::{Dimension, format_four_digits, format_input};

named_enum! {
    /// Which code the lines are for.
    pub enum TargetCode {
        /// LAMMPS, `fix wall/gran`; for two spheres `pair_style granular`.
        Lammps = "lammps",
        /// LIGGGHTS, `fix wall/gran model hooke`; for two spheres `pair_style gran`.
        Liggghts = "liggghts",
        /// Yade, `ViscElMat`.
        Yade = "yade",
        /// MercuryDPM, a species with e and contact time.
        Mercury = "mercury",
        /// Drake, point contact.
        Drake = "drake",
        /// `MuJoCo`, `solref` with stiffness and damping.
        Mujoco = "mujoco",
        /// Chrono, smooth contact of the model Hertz.
        Chrono = "chrono",
        /// A table e(v) as CSV.
        Csv = "csv",
    }
}

impl TargetCode {
    /// The note above lines that no test of this program runs in the other code.
    fn untested_note(self) -> Option<&'static str> {
        match self {
            Self::Lammps | Self::Csv => None,
            Self::Liggghts | Self::Yade => {
                Some("not tested automatically; verified once (ball on a wall, e within 1 %). Check one rebound first.")
            }
            Self::Drake | Self::Mujoco | Self::Chrono => Some(
                "tested with the equation of that code, e within 1 %; not run in that code. Check one rebound first.",
            ),
            Self::Mercury => None,
        }
    }

    /// True if the lines have a tangential spring.
    fn has_tangential_spring(self) -> bool {
        matches!(self, Self::Lammps | Self::Liggghts | Self::Yade | Self::Mercury)
    }

    /// True if the code reads a table e(v).
    pub(super) fn accepts_table(self) -> bool {
        self == Self::Csv
    }
}

/// The request of a user.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ExportRequest {
    pub target: TargetCode,
    /// Impact speed \[m/s\]; `None` for the speed of the scenario.
    pub speed: Option<f64>,
    /// First and last speed of a table \[m/s\]; `None` for a tenth to ten times the impact speed.
    pub speeds: Option<(f64, f64)>,
}

/// Stiffness of a tangential spring over that of the normal one: both swing alike for a solid sphere.
const TANGENTIAL_STIFFNESS_RATIO: f64 = 2.0 / 7.0;

/// The data that the lines of all codes are made from.
pub(super) struct Exporter<'a> {
    pub scenario: &'a Scenario,
    pub contact: &'a ExportedContact,
    pub impact: &'a Impact,
    /// The restitution that belongs into the code: with elastic waves, if the half-space has a density and is no plate.
    pub e: f64,
    pub command: &'a str,
}

impl Exporter<'_> {
    /// All lines for a code; `table` holds the impacts of a table e(v).
    pub fn lines(&self, request: &ExportRequest, table: &[Impact]) -> Result<String, Error> {
        let mut text = String::new();
        for line in self.header_lines(request) {
            let _ = match request.target {
                TargetCode::Mercury | TargetCode::Chrono => writeln!(text, "// {line}"),
                // a comment of XML holds no two hyphens
                TargetCode::Mujoco => writeln!(text, "<!-- {} -->", line.replace("--", "- -")),
                _ => writeln!(text, "# {line}"),
            };
        }
        text += &match request.target {
            TargetCode::Lammps => self.lammps(),
            TargetCode::Liggghts => self.liggghts()?,
            TargetCode::Yade => self.yade()?,
            TargetCode::Mercury => self.mercury(),
            TargetCode::Drake => self.drake()?,
            TargetCode::Mujoco => self.mujoco()?,
            TargetCode::Chrono => self.chrono()?,
            TargetCode::Csv => table_csv(table),
        };
        Ok(text)
    }

    /// Where the numbers come from, and in which range they hold.
    fn header_lines(&self, request: &ExportRequest) -> Vec<String> {
        let speed = self.impact.speed;
        let (restitution, ImpactRow { contact_time, peak_force, .. }) = (self.e, self.impact.row);
        let mut about = Vec::new();
        if request.target == TargetCode::Mercury {
            about.push(
                "untested template: these lines were never run in MercuryDPM. Check one rebound first.".to_owned(),
            );
        }
        about.extend(self.impact.warnings.iter().map(|warning| format!("warning: {warning}")));
        about.extend([
            format!("{PROGRAM}: {}", self.command),
            format!("scenario {}, SHA-256 {}", self.scenario.document.name(), self.scenario.sha256()),
            format!(
                "impact at {speed} m/s: e {restitution:.6}, contact time {contact_time:.6e} s, peak force {peak_force:.6e} N"
            ),
        ]);
        about.extend(self.drop_test_line());
        if let Some(StrainRateResult { strain_rate, factor, .. }) = self.impact.row.strain_rate_result {
            about.push(format!(
                "the strength is that of the strain rate of each speed; at this one {} 1/s, where it is {} times that of the test",
                format_four_digits(strain_rate),
                format_four_digits(factor)
            ));
        }
        about.extend(self.contact.omitted.iter().cloned());
        about.push(self.restitution_note());
        if request.target.accepts_table() {
            about.push("all units are SI; linear between the speeds".to_owned());
        } else {
            let [from, to] = constant_restitution_range(&self.contact.contact, speed, restitution)
                .map(|end| end.map(format_four_digits));
            let percent = 100.0 * MAX_RESTITUTION_ERROR;
            let range = match (from, to) {
                (Some(from), Some(to)) => format!("from {from} to {to} m/s"),
                (None, Some(to)) => format!("up to {to} m/s"),
                (Some(from), None) => format!("from {from} m/s on"),
                (None, None) => "at all speeds near this one".to_owned(),
            };
            about
                .push(format!("e is constant here; the e of the law differs from it by less than {percent} % {range}"));
            let (step, steps) = (self.time_step(), steps_per_contact(restitution));
            about.push(format!("time step {step:.3e} s or less: {steps} steps per contact, error of e below 1 %"));
            about.push(format!("sphere of {}", self.bodies()));
            let model = match request.target {
                TargetCode::Drake => "spring with the damping of Hunt and Crossley",
                TargetCode::Chrono => "damped Hertz contact",
                _ => "damped linear spring",
            };
            about.push(format!("{model}: e and contact time are those of the law, the peak force is not"));
        }
        if self.contact.friction.is_some() && request.target.has_tangential_spring() {
            about.push(
                "friction: Coulomb's, with a tangential spring of 2/7 of the normal one; plots/validate has what springs cost".to_owned(),
            );
        }
        about.extend(request.target.untested_note().map(str::to_owned));
        about
    }

    /// Dent, and heights of a fall in vacuum: numbers that a test measures.
    fn drop_test_line(&self) -> Option<String> {
        let impact = &self.impact;
        if !impact.row.has_dent() || impact.row.has_flat() || self.contact.contact.target_mass().is_some() {
            return None;
        }
        let flight = FreeFlight::in_vacuum(STANDARD_GRAVITY);
        let [from, to] = [impact.speed, self.e * impact.speed].map(|speed| flight.rise_height(speed));
        let dent = 2.0 * impact.row.peak_contact_radius;
        Some(format!("dent diameter {dent:.6e} m, rebound height {to:.6e} m after a fall of {from:.6e} m"))
    }

    /// The spheres that these lines are for.
    fn bodies(&self) -> String {
        let contact = &self.contact.contact;
        let sphere = format!("radius {} m and mass {:.6e} kg", contact.sphere().radius, contact.mass());
        match (self.contact.ball, contact.target_mass()) {
            (Some(radius), Some(mass)) => {
                format!(
                    "{sphere} on another of radius {radius} m and mass {mass:.6e} kg; the speed is the closing speed"
                )
            }
            _ => format!("{sphere} on a wall"),
        }
    }

    /// Which of the numbers that are called e these lines have.
    fn restitution_note(&self) -> String {
        let contact = &self.contact.contact;
        let damped = if contact.forces().damping.is_some() { " and [damping]" } else { "" };
        if let Some(plate) = contact.forces().plate {
            let thickness = format_input(plate.thickness, Dimension::Length);
            return format!("e includes the energy that a plate of {thickness} absorbs{damped}");
        }
        if self.impact.row.restitution_with_waves().is_some() {
            let alone = self.impact.row.restitution;
            return format!("e includes radiated waves (thick wall); without them e is {alone:.6}");
        }
        if self.contact.ball.is_some() && damped.is_empty() {
            return "e is the ratio of the relative speeds of two spheres, without elastic waves".to_owned();
        }
        if !damped.is_empty() {
            return "e includes [damping] of the scenario. Do not add other damping in the simulation".to_owned();
        }
        "e is without elastic waves. Set half_space.density for a thick wall, and half_space.thickness for a plate."
            .to_owned()
    }

    /// Time step with which a damped spring is accurate enough \[s\].
    pub(super) fn time_step(&self) -> f64 {
        self.impact.row.contact_time / steps_per_contact(self.e)
    }

    /// Stiffness of the damped linear spring \[N/m\].
    fn stiffness(&self) -> f64 {
        damped_spring(self.contact.contact.reduced_mass(), self.e, self.impact.row.contact_time)
    }

    fn lammps(&self) -> String {
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
    fn liggghts(&self) -> Result<String, Error> {
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
    fn yade(&self) -> Result<String, Error> {
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

    fn mercury(&self) -> String {
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

/// A table e(v) as CSV.
fn table_csv(table: &[Impact]) -> String {
    let mut text = "speed_m_per_s,restitution\n".to_owned();
    for impact in table {
        let _ = writeln!(text, "{:e},{:.9}", impact.speed, impact.row.measured_restitution());
    }
    text
}
