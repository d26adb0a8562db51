//! `[repeat]`: bouncing under gravity, or repeated shots without it.

use serde::de::{Deserialize, Deserializer, Error};

use super::quantity::{Bound, Quantity, SPEED, number};
use super::values::{Impacts, ShotSpeed, Speed};
use super::{Scenario, ScenarioError, Scene};
use crate::nearest::nearest;
use crate::repeat::{Drive, MOST_IMPACTS, Place, Repeat};

/// `[repeat]`
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct RepeatTable {
    /// Most impacts.
    pub impacts: Option<Impacts>,
    /// Where they hit.
    pub spot: Option<PlaceName>,
    /// What ends bouncing earlier.
    pub until: Option<UntilTable>,
    /// The speed of every shot.
    pub speeds: Option<Vec<ShotSpeed>>,
}

/// `until`
#[derive(Debug, Clone, PartialEq, serde::Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table such as { speed = \"1 mm/s\" }")]
pub struct UntilTable {
    /// The next impact would be slower than this.
    pub speed: Speed,
}

/// The speed of one shot of a list.
pub const SHOT_SPEED: Quantity =
    Quantity { hint: "a shot without speed does not touch: leave it out", is_hint_low: true, ..SPEED };
/// Repeated impacts: as many as a table of some hundred megabytes has rows.
pub const IMPACTS: Quantity = number("a number of impacts", Bound::Closed(1.0), Bound::Closed(1e6), "20");

/// "same" or "fresh".
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PlaceName(pub Place);

impl<'de> Deserialize<'de> for PlaceName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Place::ALL.iter().find(|place| place.name() == name).map(|place| Self(*place)).ok_or_else(|| {
            let guess = nearest(&name, Place::ALL.iter().map(|place| place.name()));
            let guess = guess.map_or_else(String::new, |near| format!(", did you mean \"{near}\"?"));
            D::Error::custom(format!("unknown spot \"{name}\"{guess}; {SPOTS}"))
        })
    }
}

const SPOTS: &str =
    "write \"same\" (the dent is what the sphere meets next) or \"fresh\" (every impact on new surface)";

const NEEDS_IMPACTS: &str = "the key `impacts` is missing: the most impacts there may be, such as impacts = 20";

impl Scenario {
    /// The speed of the first shot of a list \[m/s\], if the scenario has one.
    pub(super) fn first_of_speeds(&self) -> Result<Option<f64>, ScenarioError> {
        let Some(speeds) = self.file.repeat.as_ref().and_then(|table| table.speeds.as_ref()) else { return Ok(None) };
        if self.file.impact.is_some() {
            let message = "repeat.speeds gives the speed of every shot; leave [impact] out, or the list";
            return Err(self.document.refuse("impact", message.to_owned()));
        }
        let refuse = |message: String| Err(self.document.refuse("repeat.speeds", message));
        match speeds.first() {
            None => refuse("is empty: write the speed of every shot, such as [\"1 m/s\", \"2 m/s\"]".to_owned()),
            Some(_) if speeds.len() as u64 > MOST_IMPACTS => {
                refuse(format!("has {} speeds, more than {MOST_IMPACTS}", speeds.len()))
            }
            Some(first) => Ok(Some(first.0)),
        }
    }

    /// What `[repeat]` asks for, if the scenario has it.
    ///
    /// # Errors
    /// [`ScenarioError`] where keys are missing or contradict each other.
    pub fn repeat(&self, scene: &Scene) -> Result<Option<Repeat>, ScenarioError> {
        let Some(table) = &self.file.repeat else { return Ok(None) };
        let refuse = |key: &str, message: &str| Err(self.document.refuse(key, message.to_owned()));
        let Some(PlaceName(place)) = table.spot else {
            return refuse("repeat", &format!("the key `spot` is missing: {SPOTS}"));
        };
        let most = table.impacts.map(|impacts| impacts.0);
        let drive = match (scene.forces.gravity, &table.speeds, most) {
            (Some(_), Some(_), _) => {
                return refuse(
                    "repeat.speeds",
                    "gives every shot a speed, but under [gravity] the sphere bounces: leave one of the two out",
                );
            }
            (None, Some(_), Some(_)) => {
                return refuse("repeat.impacts", "`speeds` is given too: it has as many impacts as speeds");
            }
            (_, None, None) => return refuse("repeat", NEEDS_IMPACTS),
            (Some(gravity), None, Some(most)) => {
                let until = table.until.as_ref().map(|until| until.speed.0);
                Drive::Bouncing { gravity, drop_height: scene.drop_height, speed: scene.speed, most, until }
            }
            (None, Some(speeds), None) => Drive::Shots(speeds.iter().map(|speed| speed.0).collect()),
            (None, None, Some(most)) => Drive::Shots(vec![scene.speed; usize::try_from(most).unwrap_or(usize::MAX)]),
        };
        if table.until.is_some() && scene.forces.gravity.is_none() {
            return refuse(
                "repeat.until",
                "is for bouncing: without [gravity] every shot has its given speed; leave it out",
            );
        }
        Ok(Some(Repeat { place, drive }))
    }
}
