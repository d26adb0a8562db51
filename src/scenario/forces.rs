//! `[gravity]` and `[damping]`, and the impact speed, which gravity may give.

use serde::Deserialize;

use super::quantity::{Bound, Quantity, not_negative, number, positive};
use super::values::{Acceleration, HuntCrossley, ViscousFraction};
use super::{Scenario, ScenarioError, Scene};
use crate::impact::{Damping, Forces, drop_speed};
use crate::material::HalfSpace;
use crate::units::Dimension;

/// Gravity.
pub const ACCELERATION: Quantity = Quantity {
    hint: "to do without gravity leave the table out",
    is_hint_low: true,
    ..positive("an acceleration", Dimension::Acceleration, "\"9.81 m/s^2\"")
};
/// A height that the sphere falls from.
pub const DROP_HEIGHT: Quantity = not_negative("a drop height", Dimension::Length, "\"0.5 m\"");
/// χ of Hunt and Crossley.
pub const HUNT_CROSSLEY: Quantity = not_negative("a Hunt-Crossley coefficient", Dimension::InverseSpeed, "\"0.1 s/m\"");
/// Fraction of critical damping.
///
/// A contact is damped by a few hundredths to a few tenths of critical. Beyond a thousand times critical it only creeps, and
/// the number of steps that follow a creep goes with the square of this fraction: more than any run takes.
pub const VISCOUS: Quantity = Quantity {
    hint: "beyond that a contact only creeps",
    ..number("a fraction of critical damping", Bound::Closed(0.0), Bound::Closed(1000.0), "0.05")
};

/// `[gravity]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct GravityTable {
    /// Towards the half-space.
    pub acceleration: Acceleration,
}

/// `[damping]`: exactly one key, named by its law.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct DampingTable {
    /// χ of F (1 + χ δ'), or
    pub hunt_crossley: Option<HuntCrossley>,
    /// fraction ζ of critical damping.
    pub viscous: Option<ViscousFraction>,
}

/// A key and what is wrong with it.
type Problem = (&'static str, &'static str);

impl Scenario {
    /// Forces beside the contact law.
    pub(super) fn forces(&self) -> Result<Forces, ScenarioError> {
        let gravity = self.file.gravity.as_ref().map(|table| table.acceleration.0);
        let damping = match &self.file.damping {
            None => None,
            Some(DampingTable { hunt_crossley: Some(chi), viscous: None }) => Some(Damping::HuntCrossley(chi.0)),
            Some(DampingTable { hunt_crossley: None, viscous: Some(zeta) }) => Some(Damping::Viscous(zeta.0)),
            Some(DampingTable { hunt_crossley: None, viscous: None }) => {
                let message =
                    "a key is missing: hunt_crossley = \"0.1 s/m\", or viscous = 0.05; or leave the table out";
                return Err(self.document.refuse("damping", message.to_owned()));
            }
            Some(DampingTable { hunt_crossley: Some(_), viscous: Some(_) }) => {
                let message = "`hunt_crossley` is given too; write only one of the two";
                return Err(self.document.refuse("damping.viscous", message.to_owned()));
            }
        };
        Ok(Forces { gravity, damping })
    }

    /// Waves are those of the impact by the law alone.
    pub(super) fn refuse_waves(&self, half_space: &HalfSpace, forces: &Forces) -> Result<(), ScenarioError> {
        let beside = if self.file.repeat.is_some() {
            "[repeat]"
        } else if forces.damping.is_some() {
            "[damping]"
        } else if forces.gravity.is_some() {
            "[gravity]"
        } else {
            return Ok(());
        };
        if half_space.density.is_none() {
            return Ok(());
        }
        let message =
            format!("elastic waves are computed for one impact by the law alone: leave out this key, or {beside}");
        Err(self.document.refuse("half_space.density", message))
    }

    /// Impact speed \[m/s\] and the drop height that gives it, if one does \[m\].
    pub(super) fn speed(&self, forces: &Forces) -> Result<(f64, Option<f64>), ScenarioError> {
        if let Some(speed) = self.first_of_speeds()? {
            return Ok((speed, None));
        }
        let impact = self.file.impact.as_ref().ok_or_else(|| self.document.missing("", "impact"))?;
        let (key, message) = match (impact.speed, impact.drop_height, forces.gravity) {
            (Some(speed), None, _) => return Ok((speed.0, None)),
            (None, Some(height), Some(gravity)) => return Ok((drop_speed(gravity, height.0), Some(height.0))),
            (None, Some(_), None) => ("impact.drop_height", NEEDS_GRAVITY),
            (None, None, _) => (
                "impact",
                "the key `speed` is missing: a speed such as speed = \"3 m/s\"; or `drop_height`, with [gravity]",
            ),
            (Some(_), Some(_), _) => {
                ("impact.drop_height", "`speed` is given too; write only one of `speed` and `drop_height`")
            }
        };
        Err(self.document.refuse(key, message.to_owned()))
    }

    /// A key that cannot be swept, because the scene already says the same in another way.
    pub(super) fn contradicted(&self, swept: &[&str]) -> Option<Problem> {
        let damping = self.file.damping.as_ref();
        let height = self.file.impact.as_ref().and_then(|impact| impact.drop_height);
        let speed = self.file.impact.as_ref().and_then(|impact| impact.speed);
        let has = |path: &str| match path {
            "impact.drop_height" => height.is_some(),
            "impact.speed" => speed.is_some(),
            "damping.hunt_crossley" => damping.is_some_and(|table| table.hunt_crossley.is_some()),
            "damping.viscous" => damping.is_some_and(|table| table.viscous.is_some()),
            _ => false,
        };
        EITHER
            .iter()
            .copied()
            .find(|(key, other, _)| swept.contains(key) && has(other))
            .map(|(key, _, text)| (key, text))
    }
}

/// A key, one that says the same in another way, and what to do about the pair.
const EITHER: [(&str, &str, &str); 4] = [
    (
        "impact.speed",
        "impact.drop_height",
        "says the same as impact.drop_height, which the scenario gives: leave one of the two out",
    ),
    (
        "impact.drop_height",
        "impact.speed",
        "says the same as impact.speed, which the scenario gives: leave one of the two out",
    ),
    ("damping.hunt_crossley", "damping.viscous", "is a second damping beside damping.viscous; keep one of the two"),
    (
        "damping.viscous",
        "damping.hunt_crossley",
        "is a second damping beside damping.hunt_crossley; keep one of the two",
    ),
];

/// What a drop height without gravity is told.
const NEEDS_GRAVITY: &str =
    "a drop height needs gravity: add [gravity] with acceleration = \"9.81 m/s^2\", or give `speed` instead";

impl Scene {
    /// Puts gravity \[m/s²\] into the scene; a drop height then gives another speed.
    pub fn set_gravity(&mut self, acceleration: f64) {
        self.forces.gravity = Some(acceleration);
        if let Some(height) = self.drop_height {
            self.speed = drop_speed(acceleration, height);
        }
    }

    /// Puts a drop height \[m\] into the scene; the speed follows if there is gravity.
    pub fn set_drop_height(&mut self, height: f64) {
        self.drop_height = Some(height);
        if let Some(gravity) = self.forces.gravity {
            self.speed = drop_speed(gravity, height);
        }
    }

    /// Puts an impact speed \[m/s\] into the scene, in place of a drop height if there was one.
    pub fn set_speed(&mut self, speed: f64) {
        (self.speed, self.drop_height) = (speed, None);
    }
}
