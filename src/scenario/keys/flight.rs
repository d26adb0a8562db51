//! Warnings about the flight of a sphere: a height beyond laboratory tests, and air that the scenario omits.

use super::key;
use crate::impact::flight::free_flight::{FreeFlight, Medium};
use crate::impact::{Warning, WarningKind};
use crate::scenario::input::Input;
use crate::units::{Dimension, format_percent, format_result};

/// Air that slows a ball by a smaller fraction may be omitted without a warning.
const MAX_SLOWING: f64 = 0.005;

impl Input {
    /// The height of the fall \[m\]; `None` without a drop height.
    pub fn drop_height(&self) -> Option<f64> {
        self.number(key!("impact.drop_height"))
    }

    /// Warnings about the flight before the impact: a height beyond laboratory tests, and the effect of the air.
    pub fn flight_warnings(&self) -> impl Iterator<Item = Warning> {
        [self.height_warning(), self.doubts_of_air()].into_iter().flatten()
    }

    /// Warns of a drop height far above the range of a test, and asks for its unit.
    pub fn height_warning(&self) -> Option<Warning> {
        const MAX_USUAL: f64 = 100.0;
        let height = self.drop_height().filter(|height| *height > MAX_USUAL)?;
        let text = format!(
            "The impact speed may be far too high: the drop height is {}, and a drop test has less than 100 m. Check the unit: a number without a unit is in m, and a column drop_height_mm is in mm.",
            format_result(height, Dimension::Length)
        );
        Some(Warning::new(WarningKind::HighDrop, height, text))
    }

    /// Warns of a fall without air that air would slow, and of a ball that is so light that the air that moves with it counts.
    pub fn doubts_of_air(&self) -> Option<Warning> {
        if self.air().is_some() {
            return self.added_mass_warning();
        }
        let slower = self.slowing_by_air(self.drop_height()?)?;
        (slower > MAX_SLOWING).then(|| {
            let text = format!(
                "The impact speed is too high, because air drag is not included: air would slow the ball by {}. Add [air] with density = \"1.2 kg/m^3\" and drag = 0.5.",
                format_percent(slower)
            );
            Warning::new(WarningKind::InAir, slower, text)
        })
    }

    /// Warns of a key that is found from heights or intervals without `[air]`: the loss in the air, before the impact and after it,
    /// then counts as a loss of the impact. `risen` is the height that the ball rises to, if it is measured by one or by an
    /// interval. With `[air]` it warns of a ball that is so light that the air that moves with it counts.
    pub fn measured_air_warning(&self, risen: Option<f64>) -> Option<Warning> {
        if self.air().is_some() {
            return self.added_mass_of_measured();
        }
        let Some(risen) = risen else { return self.doubts_of_air() };
        let fallen = self.drop_height();
        let ways: Vec<f64> =
            [fallen, Some(risen)].into_iter().flatten().filter_map(|height| self.slowing_by_air(height)).collect();
        let slower = 1.0 - ways.iter().map(|slower| 1.0 - slower).product::<f64>();
        (slower > MAX_SLOWING * ways.len() as f64).then(|| {
            let text = format!(
                "The fitted keys are wrong, because e from the measurements is {} too low: without [air] the loss in the air counts as a loss of the impact. Add [air] with density = \"1.2 kg/m^3\" and drag = 0.5.",
                format_percent(slower)
            );
            Warning::new(WarningKind::InAir, slower, text)
        })
    }

    /// The mass of the air that moves with the ball, as a share of the mass of the ball, if there is air.
    fn added_mass(&self) -> Option<f64> {
        let (air, radius, mass) = (self.air()?, self.radius()?, self.mass()?);
        Some(0.5 * FreeFlight::buoyancy_ratio(air.density, radius, mass))
    }

    /// Heights and times change by the whole share of the added mass.
    fn added_mass_warning(&self) -> Option<Warning> {
        let added = self.added_mass().filter(|added| *added > 0.003)?;
        let text = format!(
            "Heights and times have an error of up to {}: the added mass of the air is this fraction of the mass of the ball, and is neglected.",
            format_percent(added)
        );
        Some(Warning::new(WarningKind::InAir, added, text))
    }

    /// The added mass cancels in the ratio of two heights or of two intervals. In the speed of a fall from a measured height,
    /// and in e from this height and an interval, half of its share is left.
    fn added_mass_of_measured(&self) -> Option<Warning> {
        let added = self.added_mass().filter(|added| 0.5 * added > MAX_SLOWING)?;
        let text = format!(
            "Speeds of falls, and e from a height and an interval, deviate by {}: the added mass of the air is {} of the mass of the ball, and is neglected.",
            format_percent(0.5 * added),
            format_percent(added)
        );
        Some(Warning::new(WarningKind::InAir, added, text))
    }

    /// The fraction by which room air slows a ball at the end of a fall from this height; `None` for a body with a tip, which falls in a
    /// guide.
    fn slowing_by_air(&self, height: f64) -> Option<f64> {
        /// Room air, and the drag of a smooth sphere.
        const USUAL: Medium = Medium { density: 1.2, drag: Some(0.47), viscosity: f64::NAN };
        let (radius, mass) = (self.radius()?, self.mass()?);
        let is_ball = self.number(key!("sphere.mass")).is_none();
        let gravity = self.drop_gravity();
        let [in_air, in_vacuum] = [FreeFlight::in_air(gravity, &USUAL, radius, mass), FreeFlight::in_vacuum(gravity)];
        let slower = 1.0 - in_air.landing_speed(height) / in_vacuum.landing_speed(height);
        (is_ball && height > 0.0).then_some(slower)
    }
}
