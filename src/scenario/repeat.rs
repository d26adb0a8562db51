//! `[repeat]`: bouncing under gravity, or repeated shots without it.

use super::Scenario;
use crate::error::Error;
use crate::repeat::{Drive, MOST_IMPACTS, Repeat};
use crate::scene::Scene;

const SPOTS: &str =
    "write \"same\" (the dent is what the sphere meets next) or \"fresh\" (every impact on new surface)";

const NEEDS_IMPACTS: &str = "the key `impacts` is missing: the most impacts there may be, such as impacts = 20";

impl Scenario {
    /// The speed of the first shot of a list \[m/s\], if the scenario has one.
    pub(super) fn first_of_speeds(&self) -> Result<Option<f64>, Error> {
        let Some(speeds) = self.tables.repeat.as_ref().and_then(|repeat| repeat.speeds.as_ref()) else {
            return Ok(None);
        };
        let refuse = |message: String| Err(self.document.refuse("repeat.speeds", message));
        match speeds.first() {
            None => refuse("is empty: write the speed of every shot, such as [\"1 m/s\", \"2 m/s\"]".to_owned()),
            Some(_) if speeds.len() as u64 > MOST_IMPACTS => {
                refuse(format!("has {} speeds, more than {MOST_IMPACTS}", speeds.len()))
            }
            Some(first) => Ok(Some(*first)),
        }
    }

    /// What `[repeat]` asks for, if the scenario has it.
    ///
    /// # Errors
    /// [`Error`] where keys are missing or contradict each other.
    pub fn repeat(&self, scene: &Scene) -> Result<Option<Repeat>, Error> {
        let Some(given) = &self.tables.repeat else { return Ok(None) };
        let refuse = |key: &str, message: &str| Err(self.document.refuse(key, message));
        let Some(place) = given.spot else {
            return refuse("repeat", &format!("the key `spot` is missing: {SPOTS}"));
        };
        let until = given.until.as_ref().and_then(|until| until.speed);
        let drive = match (&given.speeds, given.impacts, scene.forces.gravity) {
            (Some(speeds), ..) => Drive::Shots(speeds.clone()),
            (None, None, _) => return refuse("repeat", NEEDS_IMPACTS),
            (None, Some(most), Some(gravity)) => Drive::Bouncing {
                gravity,
                drop_height: scene.input.impact.drop_height,
                speed: scene.speed,
                most,
                until,
            },
            (None, Some(most), None) => Drive::Shots(vec![scene.speed; usize::try_from(most).unwrap_or(usize::MAX)]),
        };
        Ok(Some(Repeat { place, drive }))
    }
}
