//! Writes input lines for other codes, so that they give the same rebound as the contact law here, of a sphere from a wall or of
//! two spheres. The lines hold a constant e at one speed, a spring with this e and the contact time of the law, or a table e(v).
//! `material_codes` is for codes that take e and the elastic constants, and choose the spring themselves.
//!
//! | model | parameters from e and contact time t of the impact at v |
//! |---|---|
//! | damped linear spring | k = m (π² + ln² e)/t², damping from e: the overlap lasts t, and e is the same at every speed |
//! | damped spring that never pulls (Schwager and Pöschel 2007) | tan φ (π − 2φ) = −ln e, ω = (π − 2φ)/(t cos φ), k = m ω², c = 2 m ω sin φ: the force lasts t; for e > exp(−2) |
//! | k x (1 + d x') (Hunt and Crossley 1975) of Drake, the damped Hertz contact of Chrono | the parameters at which the equation, integrated, has e and t at v |
//!
//! The mass m is the effective mass of two spheres, and the sphere's own on a wall. The peak force of the damped spring follows from
//! these parameters. It differs from the peak force of the law.

mod dem_codes;
mod engines;
mod exported_contact;
mod exporter;
pub mod header;
mod material_codes;
mod one_contact;
mod springs;

use crate::error::{Error, ErrorKind};
use crate::impact::{Impact, Solver};
use crate::numerics::functions::pow;
use crate::scenario::Scenario;
use exported_contact::ExportedContact;
pub use exporter::{ExportRequest, TargetCode};
pub use springs::{
    MAX_RESTITUTION_ERROR, constant_restitution_range, damped_spring, non_cohesive_spring, steps_per_contact,
};

/// Rows of a table e(v).
const POINTS: u32 = 41;

/// The mass of the relative motion, and an impact of the bodies of a scenario at a speed: without the motion around the contact, which
/// another code has itself.
///
/// # Errors
/// As [`export`].
pub fn impact_without_surroundings(scenario: &Scenario, speed: f64, samples: usize) -> Result<(f64, Impact), Error> {
    let contact = ExportedContact::new(scenario)?.contact;
    let failed = |reason| Error::for_file(ErrorKind::Input, scenario.document.name(), reason);
    let impact = contact.impact(speed, &Solver::AUTO, Some(samples)).map_err(failed)?;
    Ok((contact.reduced_mass(), impact))
}

/// The lines for another code, from the bodies and the speed of any scenario of impacts. `command` is the command line, which the
/// lines name as their origin.
///
/// # Errors
/// [`Error`] for a bad scenario, one without impacts, a missing speed, or a speed without a result or a rebound.
pub fn export(scenario: &Scenario, request: &ExportRequest, command: &str) -> Result<String, Error> {
    let bare = ExportedContact::new(scenario)?;
    let speed = request.speed.or(bare.speed).or(request.speeds.map(|(from, _)| from)).ok_or_else(|| {
        Error::input("the scenario has no single impact speed. Give --speed, such as --speed \"3 m/s\".".to_owned())
    })?;
    let at = |speed: f64| {
        let failed = |reason| Error::for_file(ErrorKind::Input, scenario.document.name(), reason);
        bare.contact.impact(speed, &Solver::AUTO, None).map_err(failed)
    };
    let impact = at(speed)?;
    if impact.row.measured_restitution() <= 0.0 {
        return Err(Error::input(format!("no rebound at {speed} m/s; a spring-dashpot cannot have e = 0")));
    }
    let mut table = Vec::new();
    if request.target.accepts_table() {
        let (from, to) = request.speeds.unwrap_or((speed / 10.0, 10.0 * speed));
        for i in 0..POINTS {
            let share = f64::from(i) / f64::from(POINTS - 1);
            // the ends are those that were asked for, to the last digit
            let ends = [(0, from), (POINTS - 1, to)].into_iter().find(|(end, _)| *end == i);
            table.push(at(ends.map_or_else(|| from * pow(to / from, share), |(_, speed)| speed))?);
        }
    } else if request.speeds.is_some() {
        let message = "--speeds: this code supports a constant e only. Give --speed, or use --to csv.";
        return Err(Error::input(message.to_owned()));
    }
    exporter::Exporter { scenario, contact: &bare, impact: &impact, e: impact.row.measured_restitution(), command }
        .lines(request, &table)
}
