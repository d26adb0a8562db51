//! `[gravity]` and `[damping]`: what they go with, and what not.

use super::{Scenario, ScenarioError};
use crate::scene::{EITHER, Scene};

impl Scenario {
    /// Waves are those of the impact by the law alone.
    pub(super) fn refuse_waves(&self, scene: &Scene) -> Result<(), ScenarioError> {
        let beside = if self.entries.has("repeat") {
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

    /// A drop height is no speed without gravity.
    pub(super) fn needs_gravity(&self) -> Result<(), ScenarioError> {
        let (height, gravity) = ("impact.drop_height", "gravity.acceleration");
        if !self.entries.has(height) || self.entries.has(gravity) || self.entries.varies(gravity) {
            return Ok(());
        }
        let message =
            "a drop height needs gravity: add [gravity] with acceleration = \"9.81 m/s^2\", or give `speed` instead";
        Err(self.document.refuse(height, message))
    }

    /// A key that cannot be swept, because the scene already says the same in another way.
    pub(super) fn contradicted(&self, swept: &[&'static str]) -> Option<(&'static str, String)> {
        // a radius in the file is only the first of a swept diameter
        let pairs = EITHER.into_iter().skip(1).flat_map(|[one, other]| [(one, other), (other, one)]);
        let (key, other) = pairs.into_iter().find(|(key, other)| swept.contains(key) && self.entries.has(other))?;
        Some((key, format!("stands in place of {other}, which the scenario gives; keep one of the two")))
    }
}
