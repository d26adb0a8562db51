//! The `inputs` of a summary: the values of all keys, defaults included, in SI, with the unit in every name.

use serde::ser::{Serialize, Serializer};

use super::resolved::{Entry, of_scene};
use crate::plan::axis::{Axis, Word};
use crate::plan::{Plan, YIELD_STRENGTH};
use crate::scene::taken::Body;

/// Keys and values in the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs(pub Vec<Entry>);

impl Serialize for Inputs {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|entry| (&entry.column, &entry.value)))
    }
}

impl Inputs {
    /// The inputs that all rows of a table share, and the parameters of every law on its axes.
    pub fn of_plan(plan: &Plan) -> Self {
        let mut entries = of_scene(&plan.scene);
        let adds_keys = |axis: &&Axis| matches!(axis.words(), [Word::Law(_) | Word::Method(_), ..]);
        for axis in plan.axes().iter().filter(adds_keys) {
            for place in 0..axis.len() {
                let mut input = plan.input.clone();
                axis.put(place, &mut input);
                let new = of_scene(&input.resolve())
                    .into_iter()
                    .filter(|entry| entries.iter().all(|old| old.key != entry.key));
                entries.extend(new.collect::<Vec<_>>());
            }
        }
        let mut varied = plan.paths();
        if varied.contains(&Body::HalfSpace.material()) {
            varied.push("half_space.yield_strength_from");
        }
        for word in plan.axes().iter().flat_map(Axis::words) {
            if let Word::Material(taken) = word {
                varied.extend(taken.values().map(|(path, _)| path));
            }
        }
        let varies = |key: &str| varied.contains(&key);
        let is_shared = |key: &str| match key {
            "sphere.radius" => !varies("sphere.diameter"),
            YIELD_STRENGTH => !plan.derives_strength(),
            "impact.speed" => {
                plan.scene.drop_height.is_none() || !varies("impact.drop_height") && !varies("gravity.acceleration")
            }
            // a table has no trace
            "output.samples" => false,
            _ => true,
        };
        entries.retain(|entry| !varies(&entry.key) && is_shared(&entry.key));
        Self(entries)
    }
}
