//! The values of all keys of a scene, defaults included: `check` prints them, and a summary lists them as `inputs`, in SI, with
//! the unit in every name.

use serde_json::{Map, Value};

use crate::contact::law::plm::hardness_test::flow_stress_of_hardness;
use crate::impact::Method;
use crate::scenario::input::{Body, Input, KeyValue, alternatives_to};
use crate::scenario::keys::quantity::FACTOR;
use crate::scenario::keys::{Part, body_key};
use crate::scenario::plan::{AxisWord, Plan, SweepAxis};

/// Keys and values in the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct Inputs(pub Vec<KeyValue>);

impl Inputs {
    /// As they stand in a summary.
    pub fn to_json(&self) -> Map<String, Value> {
        self.0.iter().map(|entry| (entry.column(), entry.value.clone())).collect()
    }

    /// Keys and values of an input, with its defaults and with what follows from other keys.
    pub fn new(input: &Input) -> Self {
        let (can_yield, is_verlet) = (input.can_yield(), input.solver().method == Method::Verlet);
        let is_used = |key_values: &KeyValue| match key_values.part {
            // an elastic half-space does not use the keys of the law
            Part::Law => can_yield && !key_values.value.is_null(),
            Part::Solver if key_values.path == "solver.steps_per_contact" => is_verlet,
            _ => !key_values.value.is_null(),
        };
        let mut entries: Vec<KeyValue> = input.with_derived_values().key_values().into_iter().filter(is_used).collect();
        for body in Body::ALL {
            let Some(mean_pressure) = input.number(body_key!(body, "hardness")) else { continue };
            let rule = if input.flow_curve(body).is_some() { "hardness and flow_stress" } else { "hardness" };
            entries.push(KeyValue::from_word(&strength_source_name(body), Part::Flow, rule));
            let ratio = mean_pressure / flow_stress_of_hardness(mean_pressure, &input.material(body));
            let (path, quantity) = (constraint_factor_name(body), Some(&FACTOR));
            entries.push(KeyValue { path, part: Part::Flow, quantity, value: ratio.into() });
        }
        for choice in input.materials() {
            let part = if choice.body == Body::Sphere { Part::Sphere } else { Part::HalfSpace };
            entries.push(KeyValue::from_word(choice.body.material(), part, choice.material.name.as_str()));
            entries.extend(choice.value_notes().map(|(path, note)| KeyValue::from_word(&path, part, note)));
        }
        Self(entries)
    }

    /// The inputs that all rows of a table share, and the parameters of every law on its axes.
    pub fn from_plan(plan: &Plan) -> Self {
        let Self(mut entries) = Self::new(&plan.input);
        for input in plan.inputs_of_word_axes() {
            let Self(mut new) = Self::new(&input);
            new.retain(|entry| entries.iter().all(|old| old.path != entry.path));
            entries.extend(new);
        }
        let mut varied = plan.varied_paths();
        for word in plan.axes().iter().flat_map(SweepAxis::word_values) {
            if let AxisWord::Material(choice) = word {
                varied.extend(choice.known_values().map(|(path, _)| path));
            }
        }
        let varies = |key: &str| varied.contains(&key);
        // what follows from anything that varies, as the speed of a fall in air from the radius
        let others: Vec<Self> = plan.with_other_values().iter().map(Self::new).collect();
        let is_another = |own: &KeyValue, other: &KeyValue| own.path == other.path && own.value != other.value;
        let is_shared = |own: &KeyValue| !others.iter().flat_map(|other| &other.0).any(|other| is_another(own, other));
        // what follows from a material or a hardness that varies
        let follows = |path: &str| {
            Body::ALL.into_iter().any(|body| {
                let material = body.material();
                varies(material) && (path.starts_with(material) || path == strength_source_name(body))
                    || plan.derives_strength(body)
                        && (path == body.yield_strength() || path == constraint_factor_name(body))
            })
        };
        entries.retain(|entry @ KeyValue { path, part, .. }| {
            let is_given_by_rows = varies(path) || alternatives_to(path).any(varies) || follows(path);
            // a table has no trace
            *part != Part::Output && !is_given_by_rows && is_shared(entry)
        });
        Self(entries)
    }
}

/// The mean pressure of the hardness of a body over its flow stress at a plastic strain of 0.08.
pub(super) fn constraint_factor_name(body: Body) -> String {
    format!("{}_over_flow_stress", body.hardness())
}

/// The name under which a summary says where the yield strength of a body comes from.
fn strength_source_name(body: Body) -> String {
    format!("{}_from", body.yield_strength())
}
