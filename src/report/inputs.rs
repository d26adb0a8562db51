//! The values of all keys of a scene, defaults included: `check` prints them, and a summary lists them as `inputs`, in SI, with
//! the unit in every name.

use serde::ser::{Serialize, Serializer};

use crate::impact::{Method, PlateTheory};
use crate::plan::axis::{Axis, Word};
use crate::plan::{Plan, YIELD_STRENGTH};
use crate::scene::at::at;
use crate::scene::input::Held;
use crate::scene::taken::Body;
use crate::scene::{Input, Scene};

/// Keys and values in the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs(pub Vec<Held>);

impl Serialize for Inputs {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|held| (held.column(), &held.value)))
    }
}

impl Inputs {
    /// Those of a scene, as far as it has them.
    pub fn of(scene: &Scene) -> Self {
        let can_yield = scene.half_space.yield_strength.is_some();
        let is_used = |held: &Held| match held.path.as_str() {
            "solver.steps_per_contact" => scene.solver.method == Method::Verlet,
            "solver.tolerance" | "output.samples" => true,
            // an elastic half-space does not use the keys of the law
            path => (can_yield || !path.starts_with("law")) && !held.value.is_null(),
        };
        let mut entries: Vec<Held> = complete(scene).held().into_iter().filter(is_used).collect();
        if scene.input.number(at!("half_space.hardness")).is_some() {
            let rule = if scene.law.flow().is_some() {
                "hardness and flow_stress: at a plastic strain of 0.08 the flow stress is the mean pressure over 2.9"
            } else {
                "hardness: mean pressure over 2.9"
            };
            entries.push(Held::word("half_space.yield_strength_from", rule));
        }
        for taken in &scene.materials {
            entries.push(Held::word(taken.body.material(), taken.material.name.as_str()));
            entries.extend(taken.notes().map(|(path, note)| Held::word(&path, note)));
        }
        Self(entries)
    }

    /// Those of them whose keys begin so.
    #[must_use]
    pub fn beginning_with(mut self, begins: &[&str]) -> Self {
        self.0.retain(|entry| begins.iter().any(|begin| entry.path.starts_with(begin)));
        self
    }

    /// The inputs that all rows of a table share, and the parameters of every law on its axes.
    pub fn of_plan(plan: &Plan) -> Self {
        let Self(mut entries) = Self::of(&plan.scene);
        for input in plan.worded() {
            let Self(mut new) = Self::of(&input.resolve());
            new.retain(|entry| entries.iter().all(|old| old.path != entry.path));
            entries.extend(new);
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
                plan.scene.input.number(at!("impact.drop_height")).is_none()
                    || !varies("impact.drop_height") && !varies("gravity.acceleration")
            }
            // a table has no trace
            "output.samples" => false,
            _ => true,
        };
        entries.retain(|entry| !varies(&entry.path) && is_shared(&entry.path));
        Self(entries)
    }
}

/// The keys of a scene, with defaults and with what follows from other keys.
fn complete(scene: &Scene) -> Input {
    let mut input = scene.input.clone();
    input.law.clone_from(&scene.law);
    input.fill_law();
    input.set(at!("sphere.radius"), Some(scene.sphere.radius));
    input.set(at!("sphere.diameter"), None);
    input.choose(at!("sphere.material"), None);
    input.choose(at!("half_space.material"), None);
    input.set(at!("sphere.spin"), scene.incidence.map(|incidence| incidence.spin));
    input.set(at!("half_space.yield_strength"), scene.half_space.yield_strength);
    let theory = scene.forces.plate.map(|plate| plate.theory);
    let place = theory.and_then(|theory| PlateTheory::ALL.iter().position(|known| *known == theory));
    input.choose(at!("half_space.plate"), place);
    if let Some(curve) = input.value(at!("half_space.flow_stress.table")).cloned() {
        input.put_value(at!("half_space.flow_stress.points"), Some(curve));
        input.put_value(at!("half_space.flow_stress.table"), None);
    }
    input.set(at!("impact.angle"), scene.incidence.map(|incidence| incidence.angle));
    input.set(at!("impact.speed"), Some(scene.speed).filter(|speed| !speed.is_nan()));
    input.set(at!("solver.tolerance"), Some(scene.solver.tolerance));
    input.choose(at!("solver.method"), Method::ALL.iter().position(|known| *known == scene.solver.method));
    input.set_count(at!("solver.steps_per_contact"), scene.solver.steps_per_contact.into());
    input.set_count(at!("output.samples"), scene.samples as u64);
    input
}
