//! `[gravity]`, `[damping]` and the plate: the keys that need them, and those that exclude them.

use super::Scenario;
use crate::error::Error;
use crate::scene::{EITHER, Scene};

impl Scenario {
    /// Refuses elastic waves beside gravity, damping or repeated impacts.
    pub(super) fn refuse_waves(&self, scene: &Scene) -> Result<(), Error> {
        let beside = if self.has("repeat") {
            "[repeat]"
        } else if scene.forces.damping.is_some() {
            "[damping]"
        } else if scene.forces.gravity.is_some() {
            "[gravity]"
        } else {
            return Ok(());
        };
        // a plate radiates no such waves: its density is for the plate
        if scene.half_space.density.is_none() || scene.forces.plate.is_some() {
            return Ok(());
        }
        let message =
            format!("elastic waves are computed for one impact by the law alone: leave out this key, or {beside}");
        Err(self.document.refuse("half_space.density", message))
    }

    /// Refuses what a plate cannot be beside, and keys of a plate without its thickness.
    pub(super) fn check_plate(&self, scene: &Scene) -> Result<(), Error> {
        const THICKNESS: &str = "half_space.thickness";
        if scene.forces.plate.is_none() {
            // a column of measurements may give the thickness
            let has_none = |key: &&str| self.has(key) && self.tables.calibrate.is_none();
            let idle = ["half_space.edge_distance", "half_space.plate"].into_iter().find(has_none);
            let message = "is of a plate: give half_space.thickness too, or leave the key out";
            return idle.map_or(Ok(()), |key| Err(self.document.refuse(key, message)));
        }
        let Ok(contact) = scene.contact() else { return Ok(()) };
        contact.check_plate().map_err(|error| self.document.refuse(THICKNESS, error.to_string()))
    }

    /// Refuses a drop height without gravity.
    pub(super) fn needs_gravity(&self) -> Result<(), Error> {
        let (height, gravity) = ("impact.drop_height", "gravity.acceleration");
        if !self.has(height) || self.gives(gravity) {
            return Ok(());
        }
        let message =
            "a drop height needs gravity: add [gravity] with acceleration = \"9.81 m/s^2\", or give `speed` instead";
        Err(self.document.refuse(height, message))
    }

    /// A key that cannot be swept, because the scenario gives the key in place of it.
    pub(super) fn contradicted(&self, swept: &[&'static str]) -> Option<(&'static str, String)> {
        // a swept diameter replaces a radius in the file
        let pairs = EITHER.into_iter().skip(1).flat_map(|[one, other]| [(one, other), (other, one)]);
        let (key, other) = pairs.into_iter().find(|(key, other)| swept.contains(key) && self.has(other))?;
        Some((key, format!("stands in place of {other}, which the scenario gives; keep one of the two")))
    }
}
