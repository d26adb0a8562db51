//! `[repeat]`: bouncing under gravity, or repeated shots without it.

use crate::error::Error;
use crate::impact::series::{ImpactSeries, MAX_IMPACTS, SeriesMode, SpotMode};
use crate::scenario::Scenario;
use crate::scenario::input::Input;
use crate::scenario::keys::key;

const SPOT_TEXT: &str =
    "write \"same\" (every impact hits the dent of the impact before) or \"fresh\" (every impact hits a new surface)";

const NEEDS_IMPACTS_TEXT: &str = "the key `impacts` is missing: the maximum number of impacts, such as impacts = 20";

impl Scenario {
    /// The speeds of a list of shots, if the scenario has one.
    pub(in crate::scenario) fn shot_speeds(&self) -> Option<&[f64]> {
        self.input.number_list(key!("repeat.speeds"))
    }

    /// Refuses an empty list of shots, and a list that is too long.
    pub(in crate::scenario) fn check_speeds(&self) -> Result<(), Error> {
        let refuse = |message: String| Err(self.document.refusal("repeat.speeds", message));
        match self.shot_speeds().map(<[f64]>::len) {
            Some(0) => refuse("is empty. Write the speed of every impact, such as [\"1 m/s\", \"2 m/s\"]".to_owned()),
            Some(count) if count as u64 > MAX_IMPACTS => refuse(format!("has {count} speeds, more than {MAX_IMPACTS}")),
            _ => Ok(()),
        }
    }

    /// The series of `[repeat]`; `first` is the input of the first impact.
    pub fn series(&self, first: &Input) -> Result<ImpactSeries, Error> {
        let input = &self.input;
        let refuse = |key: &str, message: &str| Err(self.document.refusal(key, message));
        let Some(place) = input.word(key!("repeat.spot")) else {
            return refuse("repeat", &format!("the key `spot` is missing: {SPOT_TEXT}"));
        };
        let place = SpotMode::ALL[place];
        if first.is_oblique() && place == SpotMode::Same {
            return refuse(
                "repeat.spot",
                "oblique or spinning impacts never hit the same spot. Write spot = \"fresh\".",
            );
        }
        let drop_height = input.number(key!("impact.drop_height"));
        if drop_height.is_some() && first.angle() != 0.0 {
            return refuse(
                "impact.drop_height",
                "a drop has no impact angle. Give impact.speed instead, or remove impact.angle.",
            );
        }
        let until = input.number(key!("repeat.until.speed"));
        let drive = match (self.shot_speeds(), input.count(key!("repeat.impacts")), first.forces().gravity) {
            (Some(speeds), ..) => SeriesMode::Shots(speeds.to_vec()),
            (None, None, _) => return refuse("repeat", NEEDS_IMPACTS_TEXT),
            (None, Some(most), Some(gravity)) => {
                SeriesMode::Bouncing { gravity, drop_height, approach: first.approach(), most, until }
            }
            (None, Some(most), None) => {
                SeriesMode::Shots(vec![first.speed(); usize::try_from(most).unwrap_or(usize::MAX)])
            }
        };
        Ok(ImpactSeries { spot_mode: place, mode: drive })
    }
}
