//! Writes input lines for other codes, so that they give the same rebound as the contact law here. The lines hold a
//! constant e at one speed, a spring with this e and the contact time of the law, or a table e(v).
//!
//! | model | parameters from e and contact time t of the impact at v |
//! |---|---|
//! | damped linear spring | k = m (π² + ln² e)/t², damping from e: the overlap lasts t, and e is the same at every speed |
//! | damped spring that never pulls (Schwager and Pöschel 2007) | tan φ (π − 2φ) = −ln e, ω = (π − 2φ)/(t cos φ), k = m ω², c = 2 m ω sin φ: the force lasts t; for e > exp(−2) |
//!
//! The peak force of the damped spring follows from these parameters. It differs from the peak force of the law.

mod lines;
mod request;
mod springs;

use crate::error::{Error, ErrorKind};
use crate::math::functions::pow;
use crate::run::contact_alone;
use crate::scenario::Scenario;
use crate::scene::at::at;
pub use request::{Request, Target};
pub use springs::{E_WITHIN, damped_spring, range_of_constant, spring_without_pull, steps_per_contact};

/// Rows of a table e(v).
const POINTS: u32 = 41;

/// The lines for another code. `command` is the command line, which the lines name as their origin.
///
/// # Errors
/// [`Error`] for a bad scenario, a scenario with gravity or damping, a missing speed, or a speed without a result.
pub fn export(scenario: &Scenario, request: &Request, command: &str) -> Result<String, Error> {
    let (input, contact) = contact_alone(scenario)?;
    let speed = request.speed.or(Some(input.speed()).filter(|speed| speed.is_finite())).ok_or_else(|| {
        Error::input("the scenario has no impact.speed: give --speed, such as --speed \"3 m/s\"".to_owned())
    })?;
    let at = |speed: f64| {
        let failed = |reason| Error::in_file(ErrorKind::Input, scenario.document.name(), reason);
        contact.closed_form(speed).map_err(failed)
    };
    let impact = at(speed)?;
    let mut table = Vec::new();
    if request.target.takes_table() {
        let (from, to) = request.speeds.unwrap_or((speed / 10.0, 10.0 * speed));
        for i in 0..POINTS {
            let share = f64::from(i) / f64::from(POINTS - 1);
            // the ends are those that were asked for, to the last digit
            let ends = [(0, from), (POINTS - 1, to)].into_iter().find(|(end, _)| *end == i);
            table.push(at(ends.map_or_else(|| from * pow(to / from, share), |(_, speed)| speed))?);
        }
    } else if request.speeds.is_some() {
        let message = "--speeds: this code takes one constant e; give --speed, or --to csv";
        return Err(Error::input(message.to_owned()));
    }
    let head = lines::Head {
        scenario,
        contact: &contact,
        impact: &impact,
        friction: input.number(at!("friction.coefficient")),
        command,
    };
    head.lines(request, &table)
}
