//! From a scenario to its files and to the results for people: one way for every kind of scene.

mod calibrate;
pub mod find;
pub mod impact;
pub mod indentation;
mod outcome;
pub mod series;
pub mod table;

use crate::error::{Error, ErrorKind};
use crate::impact::{Contact, Forces, WaveguideKind};
use crate::scenario::input::{Input, OBLIQUE_KEYS};
use crate::scenario::keys::key;
pub use crate::scenario::no_result_error;
use crate::scenario::{Kind, Scenario};
pub use outcome::{Outcome, RunOptions, warning_texts};

/// The outcome of a scenario: with options it has all files, and without options it has the blocks of `check`. `None` for a table, which
/// is made row after row by [`crate::table::TableJob`].
pub fn run(scenario: &Scenario, options: Option<&RunOptions>) -> Result<Option<Outcome>, Error> {
    let outcome = match scenario.kind()? {
        Kind::Sweep | Kind::MonteCarlo => return Ok(None),
        Kind::Impact => impact::run,
        Kind::Repeat => series::run,
        Kind::Calibrate => calibrate::run,
        Kind::Indentation => indentation::run,
    };
    outcome(scenario, options).map(Some)
}

/// Checks a scenario; nothing is written.
pub fn check(scenario: &Scenario) -> Result<Outcome, Error> {
    run(scenario, None)?.map_or_else(|| table::check(scenario), Ok)
}

/// The remedy for a key that describes the motion of the sphere and not its contact.
const SPHERE_MOTION_ADVICE: &str = "The simulation has path and spin of every sphere.";

/// The bodies of a scenario and the contact between them, for codes that add all other forces themselves.
///
/// # Errors
/// [`Error`]: a bad scenario, one with gravity, damping, a plate or a rod, and one of another kind than an impact.
pub fn bare_contact(scenario: &Scenario) -> Result<(Input, Contact), Error> {
    let kind = scenario.kind()?;
    if kind != Kind::Impact {
        let message = "is not supported in a DEM contact. Remove this table.";
        return Err(scenario.document.refusal(kind.name(), message));
    }
    let (input, contact) = scenario.resolve_bodies()?;
    let Forces { gravity, damping, waveguide, .. } = input.forces();
    let is_on = |kind: WaveguideKind| (kind.size_key(), waveguide.is_some_and(|guide| guide.kind() == kind));
    let [(thickness, is_on_plate), (diameter, is_on_rod)] = [WaveguideKind::Plate, WaveguideKind::Rod].map(is_on);
    let table = "The simulation adds this force itself.";
    let keys = [
        ("gravity", gravity.is_some(), table),
        ("damping", damping.is_some(), table),
        ("air", scenario.document.contains("air"), table),
        ("peening", scenario.document.contains("peening"), "A coverage belongs to an impact and not to a contact."),
        (thickness, is_on_plate, "The simulation moves the plate itself."),
        (diameter, is_on_rod, "The simulation moves the rod itself."),
        (
            "half_space.mass",
            input.number(key!("half_space.mass")).is_some_and(f64::is_finite),
            "The simulation has the mass of every body. For two balls give mass = \"ball\".",
        ),
    ];
    let of_motion = OBLIQUE_KEYS.map(|key| (key.path(), scenario.document.contains(key.path()), SPHERE_MOTION_ADVICE));
    if let Some((key, _, way_out)) = keys.into_iter().chain(of_motion).find(|(_, is_there, _)| *is_there) {
        let message = format!("is not supported in a DEM contact. {way_out} Remove this part.");
        return Err(scenario.document.refusal(key, message));
    }
    let failed = |reason| Error::for_file(ErrorKind::Input, scenario.document.name(), reason);
    Ok((input, contact.map_err(failed)?))
}

/// Input and contact of [`bare_contact`], with the strength at the speed of the scenario, for codes that ask for forces one after
/// the other.
///
/// # Errors
/// [`Error`] as of [`bare_contact`], and where a strength depends on a speed that the scenario does not give.
pub fn contact_at_scenario_speed(scenario: &Scenario) -> Result<(Input, Contact), Error> {
    let (input, contact) = bare_contact(scenario)?;
    let own = rate_dependent_contact(scenario, &input, &contact)?;
    Ok((input, own.unwrap_or(contact)))
}

/// The contact with the strength of the speed of the scenario; `None` where it does not depend on a speed.
pub fn rate_dependent_contact(scenario: &Scenario, input: &Input, contact: &Contact) -> Result<Option<Contact>, Error> {
    if !contact.has_rate() {
        return Ok(None);
    }
    let speed = input.speed();
    if !speed.is_finite() {
        let table = if scenario.document.contains("half_space.rate") { "half_space.rate" } else { "sphere.rate" };
        let message = "strain-rate keys require impact.speed, because the contact law is evaluated for that speed. Add impact.speed.";
        return Err(scenario.document.refusal(table, message));
    }
    contact.at_speed(speed).map(|rated| Some(rated.into_owned())).map_err(|reason| no_result_error(scenario, &reason))
}

/// Refuses a scenario with warnings, if `is_strict`.
pub fn refuse_warnings(scenario: &Scenario, warnings: usize, is_strict: bool) -> Result<(), Error> {
    if is_strict && warnings > 0 {
        let text = format!("warnings: {warnings}. With --strict a warning is an error. No files were written.");
        return Err(Error::for_file(ErrorKind::Failed, scenario.document.name(), text));
    }
    Ok(())
}
