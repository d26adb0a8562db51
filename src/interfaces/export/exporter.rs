//! The request, for which code and at which speeds, and the input lines in the form of each code.

use std::fmt::Write as _;

use super::exported_contact::ExportedContact;
use super::springs::{MAX_RESTITUTION_ERROR, constant_restitution_range, steps_per_contact};
use crate::error::Error;
use crate::files::PROGRAM;
use crate::impact::flight::free_flight::FreeFlight;
use crate::impact::{Impact, ImpactRow, STANDARD_GRAVITY, StrainRateResult};
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
        /// EDEM, values for the model Hertz-Mindlin.
        Edem = "edem",
        /// Rocky, values for the hysteretic linear spring.
        Rocky = "rocky",
        /// `MFiX`, keys of `mfix.dat` for the Hertz model.
        Mfix = "mfix",
        /// Lethe, subsections of a parameter file.
        Lethe = "lethe",
        /// Kratos, `MaterialsDEM.json`.
        Kratos = "kratos",
        /// A table e(v) as CSV.
        Csv = "csv",
    }
}

impl TargetCode {
    /// The note above lines that no test of this program runs in the other code.
    fn untested_note(self) -> Option<&'static str> {
        match self {
            // the lines of MercuryDPM say it first
            Self::Lammps | Self::Csv | Self::Mercury => None,
            Self::Liggghts | Self::Yade => {
                Some("not tested automatically; verified once (ball on a wall, e within 1 %). Check one rebound first.")
            }
            Self::Drake | Self::Mujoco | Self::Chrono | Self::Edem | Self::Mfix | Self::Lethe | Self::Kratos => Some(
                "tested with the equation of that code, e within 1 %; not run in that code. Check one rebound first.",
            ),
            Self::Rocky => Some("not tested: the equation of that code was not read in full. Check one rebound first."),
        }
    }

    /// True if the lines have a tangential spring.
    fn has_tangential_spring(self) -> bool {
        matches!(self, Self::Lammps | Self::Liggghts | Self::Yade | Self::Mercury)
    }

    /// True if the code takes e and the elastic constants of both bodies, and computes spring and damping itself.
    fn takes_materials(self) -> bool {
        matches!(self, Self::Edem | Self::Rocky | Self::Mfix | Self::Lethe | Self::Kratos)
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

/// The data that the lines of all codes are made from.
pub(super) struct Exporter<'a> {
    pub scenario: &'a Scenario,
    pub contact: &'a ExportedContact,
    pub impact: &'a Impact,
    /// The restitution that belongs into the code: with elastic waves, if the half-space has a density and is neither a plate nor a rod.
    pub e: f64,
    pub command: &'a str,
}

impl Exporter<'_> {
    /// All lines for a code; `table` holds the impacts of a table e(v).
    pub fn lines(&self, request: &ExportRequest, table: &[Impact]) -> Result<String, Error> {
        let mut text = String::new();
        for line in self.header_lines(request) {
            let _ = match request.target {
                TargetCode::Mercury | TargetCode::Chrono | TargetCode::Kratos => writeln!(text, "// {line}"),
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
            TargetCode::Edem => self.edem()?,
            TargetCode::Rocky => self.rocky()?,
            TargetCode::Mfix => self.mfix()?,
            TargetCode::Lethe => self.lethe()?,
            TargetCode::Kratos => self.kratos()?,
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
                "the strength depends on the strain rate of each speed: here {} 1/s, strength {} times the strength of the slow test",
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
            about.push(format!(
                "this e is used at all speeds; the e of the law differs from it by less than {percent} % {range}"
            ));
            about.extend(self.model_lines(request.target));
        }
        if self.contact.friction.is_some() && request.target.has_tangential_spring() {
            about.push(
                "friction: Coulomb's, with a tangential spring of 2/7 of the normal one; plots/validate has what springs cost".to_owned(),
            );
        }
        about.extend(request.target.untested_note().map(str::to_owned));
        about
    }

    /// Time step, bodies, and what the contact of the code has in common with the law.
    fn model_lines(&self, target: TargetCode) -> Vec<String> {
        let steps = steps_per_contact(self.e);
        let bodies = format!("sphere of {}", self.bodies());
        if target.takes_materials() {
            let spring = "the code computes the spring from Young's moduli: e is the e of the law; contact time, force and dent are not. A smaller modulus allows a longer time step and leaves e";
            return vec![bodies, spring.to_owned()];
        }
        let step = self.time_step();
        let model = match target {
            TargetCode::Drake => "spring with the damping of Hunt and Crossley",
            TargetCode::Chrono => "damped Hertz contact",
            _ => "damped linear spring",
        };
        vec![
            format!("time step {step:.3e} s or less: {steps} steps per contact, error of e below 1 %"),
            bodies,
            format!("{model} with e and contact time of the law; its peak force differs from the law"),
        ]
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
        if let Some(guide) = contact.forces().waveguide {
            let (name, size) = (guide.kind().name(), format_input(guide.size(), Dimension::Length));
            return format!("e includes the energy that a {name} of {size} absorbs{damped}");
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
}

/// A table e(v) as CSV.
fn table_csv(table: &[Impact]) -> String {
    let mut text = "speed_m_per_s,restitution\n".to_owned();
    for impact in table {
        let _ = writeln!(text, "{:e},{:.9}", impact.speed, impact.row.measured_restitution());
    }
    text
}
