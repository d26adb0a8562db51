//! `[friction]`, the angle and the spin: what they need, and what excludes them.

use super::Scenario;
use crate::error::Error;

/// Keys of an oblique impact.
const OBLIQUE: [&str; 2] = ["impact.angle", "sphere.spin"];
/// What they need.
const COEFFICIENT: &str = "friction.coefficient";

/// What an angle and a spin are not computed with, and the way out.
const APART: [(&str, &str); 4] = [
    ("gravity", "gravity acts along the normal here: leave [gravity] out, and give the speed at first touch"),
    ("damping", "codes differ on whether friction counts the damping force too: leave [damping] out"),
    ("repeat", "the impacts of [repeat] are straight: leave this key or [repeat] out"),
    (
        "calibrate",
        "the impacts of [calibrate] are straight: leave this key out, and give the speed normal to the surface",
    ),
];

impl Scenario {
    /// Refuses an angle or a spin without friction, and beside what they are not computed with.
    pub(super) fn check_friction(&self) -> Result<(), Error> {
        let Some(key) = OBLIQUE.into_iter().find(|path| self.gives(path)) else { return Ok(()) };
        let refuse = |message: &str| Err(self.document.refuse(key, message));
        if !self.gives(COEFFICIENT) {
            return refuse("needs friction: add [friction] with coefficient = 0.1, or coefficient = 0 for none");
        }
        if self.gives("sphere.mass") && !self.gives("sphere.moment_of_inertia") {
            return refuse("needs sphere.moment_of_inertia beside sphere.mass, as the body is no plain sphere");
        }
        let is_there = |table: &str| {
            let inner = format!("{table}.");
            self.has(table) || self.tables.varied().iter().any(|path| path.starts_with(&inner))
        };
        APART.into_iter().find(|(table, _)| is_there(table)).map_or(Ok(()), |(_, message)| refuse(message))
    }
}
