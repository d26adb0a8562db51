//! `[gravity]` and `[damping]`: the keys that need them, and those that exclude them.

use super::{Scenario, ScenarioError};
use crate::scene::{EITHER, Scene};

impl Scenario {
    /// Refuses elastic waves beside gravity, damping or repeated impacts.
    pub(super) fn refuse_waves(&self, scene: &Scene) -> Result<(), ScenarioError> {
        let beside = if self.has("repeat") {
            "[repeat]"
        } else if scene.forces.damping.is_some() {
            "[damping]"
        } else if scene.forces.gravity.is_some() {
            "[gravity]"
        } else {
            return Ok(());
        };
        if scene.half_space.density.is_none() {
            return Ok(());
        }
        let message =
            format!("elastic waves are computed for one impact by the law alone: leave out this key, or {beside}");
        Err(self.document.refuse("half_space.density", message))
    }

    /// Refuses a drop height without gravity.
    pub(super) fn needs_gravity(&self) -> Result<(), ScenarioError> {
        let (height, gravity) = ("impact.drop_height", "gravity.acceleration");
        if !self.has(height) || self.has(gravity) || self.varies(gravity) {
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
