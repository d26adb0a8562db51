//! From a scenario to its files and its text on the terminal: one way for every kind of scene.

mod calibrate;
pub mod impact;
pub mod indentation;
mod outcome;
pub mod repeat;
pub mod single;
pub mod table;

use crate::error::{Error, ErrorKind};
use crate::impact::{Contact, Forces};
use crate::scenario::{Kind, Scenario};
use crate::scene::Input;
pub use outcome::{Order, Outcome, no_result, texts};

/// How scenarios of one kind are checked and run.
#[derive(Debug, Clone, Copy)]
pub enum Way {
    /// At once: all files together.
    Once {
        /// What the scenario is, for messages: "one impact".
        what: &'static str,
        /// Checks a scenario; writes nothing.
        check: fn(&Scenario) -> Result<Outcome, Error>,
        run: fn(&Scenario, &Order) -> Result<Outcome, Error>,
    },
    /// Row after row, by [`crate::sweep::Job`].
    Table,
}

/// How scenarios of this kind are checked and run.
pub fn way(kind: Kind) -> Way {
    let once = |check, what, run| Way::Once { what, check, run };
    match kind {
        Kind::Impact => once(impact::check, "one impact", impact::run),
        Kind::Sweep | Kind::MonteCarlo => Way::Table,
        Kind::Repeat => once(repeat::check, "impacts one after the other", repeat::run),
        Kind::Calibrate => once(calibrate::check, "a calibration", calibrate::run),
        Kind::Indentation => once(indentation::check, "an indentation", indentation::run),
    }
}

/// Checks a scenario; nothing is written.
pub fn check(scenario: &Scenario) -> Result<Outcome, Error> {
    match way(scenario.kind()?) {
        Way::Once { check, .. } => check(scenario),
        Way::Table => table::check(scenario),
    }
}

/// What is of a sphere that moves, and not of its contact.
const OF_THE_SPHERE: &str = "leave this key out; the simulation has path and spin of every sphere";

/// The bodies of a scenario and the contact between them, for codes that add all other forces themselves.
///
/// # Errors
/// [`Error`]: a bad scenario, one with gravity, damping or a plate, and one of another kind than an impact.
pub fn contact_alone(scenario: &Scenario) -> Result<(Input, Contact), Error> {
    let kind = scenario.kind()?;
    if kind != Kind::Impact {
        let message = "is not a part of a contact of two bodies: leave this table out";
        return Err(scenario.document.refuse(kind.name(), message));
    }
    let input = scenario.resolve_bodies()?;
    let Forces { gravity, damping, plate } = input.forces();
    let table = "leave this table out, and let the simulation add the force";
    let keys = [
        ("gravity", gravity.is_some(), table),
        ("damping", damping.is_some(), table),
        ("half_space.thickness", plate.is_some(), "leave this key out, and let the simulation move the plate"),
        ("impact.angle", scenario.document.has("impact.angle"), OF_THE_SPHERE),
        ("sphere.spin", scenario.document.has("sphere.spin"), OF_THE_SPHERE),
    ];
    if let Some((key, _, way_out)) = keys.into_iter().find(|(_, is_there, _)| *is_there) {
        let message = format!("is not a part of the contact law: {way_out}");
        return Err(scenario.document.refuse(key, message));
    }
    let failed = |reason| Error::in_file(ErrorKind::Input, scenario.document.name(), reason);
    let contact = input.contact().map_err(failed)?;
    Ok((input, contact))
}

/// Refuses a scenario with warnings, if `is_strict`.
pub fn heed(scenario: &Scenario, warnings: usize, is_strict: bool) -> Result<(), Error> {
    if is_strict && warnings > 0 {
        let text = format!("{warnings} warning(s), which --strict makes errors; nothing was written");
        return Err(Error::in_file(ErrorKind::Failed, scenario.document.name(), text));
    }
    Ok(())
}
