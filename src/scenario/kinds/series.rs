//! `[series]`: bouncing under gravity, or repeated shots without it.

use crate::error::Error;
use crate::impact::series::{ImpactSeries, MAX_IMPACTS, SeriesMode, SpotMode};
use crate::scenario::Scenario;
use crate::scenario::input::Input;
use crate::scenario::keys::key;

const SPOT_TEXT: &str =
    "write \"same\" (the dent is what the sphere meets next) or \"fresh\" (every impact on new surface)";

const NEEDS_IMPACTS_TEXT: &str = "the key `impacts` is missing: the most impacts there may be, such as impacts = 20";

impl Scenario {
    /// The speeds of a list of shots, if the scenario has one.
    pub(in crate::scenario) fn shot_speeds(&self) -> Option<&[f64]> {
        self.input.number_list(key!("repeat.speeds"))
    }

    /// Refuses an empty list of shots, and a list that is too long.
    pub(in crate::scenario) fn check_speeds(&self) -> Result<(), Error> {
        let refuse = |message: String| Err(self.document.refusal("repeat.speeds", message));
        match self.shot_speeds().map(<[f64]>::len) {
            Some(0) => refuse("is empty: write the speed of every shot, such as [\"1 m/s\", \"2 m/s\"]".to_owned()),
            Some(count) if count as u64 > MAX_IMPACTS => refuse(format!("has {count} speeds, more than {MAX_IMPACTS}")),
            _ => Ok(()),
        }
    }

    /// The series of `[series]`; `first` is the input of the first impact.
    pub fn series(&self, first: &Input) -> Result<ImpactSeries, Error> {
        let input = &self.input;
        let refuse = |key: &str, message: &str| Err(self.document.refusal(key, message));
        let Some(place) = input.word(key!("repeat.spot")) else {
            return refuse("repeat", &format!("the key `spot` is missing: {SPOT_TEXT}"));
        };
        let place = SpotMode::ALL[place];
        if first.incidence().is_some() && place == SpotMode::Same {
            return refuse(
                "repeat.spot",
                "a ball that comes at an angle or spins hops along, and does not meet its dent again: write \"fresh\"",
            );
        }
        let drop_height = input.number(key!("impact.drop_height"));
        if drop_height.is_some() && first.incidence().is_some_and(|incidence| incidence.angle != 0.0) {
            return refuse(
                "impact.drop_height",
                "a fall from rest has no angle: give impact.speed at first touch in its place, or leave impact.angle out",
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
