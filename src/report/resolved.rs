//! The values of all keys of a scenario, defaults included: `check` prints them, and a summary lists them as `inputs`.

use std::borrow::Cow;

use serde_json::Value;

use crate::impact::Method;
use crate::law::catalogue::jackson_green::Hardness;
use crate::law::jumps::Jumps;
use crate::law::{LawChoice, Plm};
use crate::plan::HARDNESS;
use crate::scenario::Scenario;
use crate::scene::taken::Taken;
use crate::scene::{Given, Input, KEYS, Key, Scene};
use crate::strength::flow::{FlowCurve, FlowPoint};
use crate::units::{Dimension, describe, human, number};

/// A key and its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// As in the file, with dots.
    pub key: Cow<'static, str>,
    /// Its name in summaries, with the unit: `impact_speed_m_per_s`.
    pub column: String,
    /// In SI, or a word.
    pub value: Value,
    /// The value as text, for the terminal.
    pub text: String,
}

impl Entry {
    /// A number, or the word that stands in its place.
    pub(super) fn of(key: &Key, given: Given) -> Self {
        let entry = match given {
            Given::Word => Self::word(key.path, key.word.unwrap_or_default()),
            Given::Number(value) => {
                Self { value: value.into(), ..Self::word(key.path, describe(value, key.quantity.dimension)) }
            }
        };
        Self { column: key.column(), ..entry }
    }

    pub(super) fn word(key: impl Into<Cow<'static, str>>, word: impl Into<String>) -> Self {
        let (key, text) = (key.into(), word.into());
        Self { column: key.replace('.', "_"), key, value: text.clone().into(), text }
    }

    pub(super) fn count(key: &'static str, count: usize) -> Self {
        Self { value: count.into(), ..Self::word(key, count.to_string()) }
    }

    /// Whether the scene has no number for the key.
    pub fn is_nan(&self) -> bool {
        self.value.is_null()
    }
}

/// The entries of a scene of impacts: numbers in the order of the file, then law, solver and output.
pub fn of_scene(scene: &Scene) -> Vec<Entry> {
    let can_yield = scene.half_space.yield_strength.is_some();
    // the diameter would repeat the radius, and an elastic half-space does not use the keys of the law
    let keys = KEYS.iter().filter(|key| key.path != "sphere.diameter" && (can_yield || !key.path.starts_with("law.")));
    let input = Input::of(scene);
    let mut entries: Vec<Entry> = keys.filter_map(|key| Some(Entry::of(key, (key.get)(&input)?))).collect();
    entries.extend(words_of_strength(scene.hardness, scene.law.flow()));
    if can_yield {
        entries.push(Entry::word("law", scene.law.name()));
        entries.extend(words_of_law(&scene.law));
    }
    entries.extend(of_materials(&scene.materials));
    entries.push(Entry::word("solver.method", scene.solver.method.name()));
    if scene.solver.method == Method::Verlet {
        entries.push(Entry::count("solver.steps_per_contact", scene.solver.steps_per_contact as usize));
    }
    entries.push(Entry::count("output.samples", scene.samples));
    entries
}

/// How a yield strength that is not given was found, and the points of a measured flow curve.
pub(super) fn words_of_strength(hardness: Option<f64>, flow: Option<&FlowCurve>) -> Vec<Entry> {
    let mut entries = Vec::new();
    if hardness.is_some() {
        let rule = if flow.is_some() {
            "hardness and flow_stress: at a plastic strain of 0.08 the flow stress is the mean pressure over 2.9"
        } else {
            "hardness: mean pressure over 2.9"
        };
        entries.push(Entry::word("half_space.yield_strength_from", rule));
    }
    if let Some(FlowCurve::Points(points)) = flow {
        let pair =
            |point: &FlowPoint| format!("{}: {}", number(point.strain), human(point.stress, Dimension::Pressure));
        let pairs: Vec<String> = points.iter().map(pair).collect();
        entries.push(Entry::word("half_space.flow_stress.points", pairs.join(", ")));
    }
    entries
}

/// The materials that the scenario names, and the values taken from each.
pub(super) fn of_materials(materials: &[Taken]) -> Vec<Entry> {
    let of = |taken: &Taken| {
        let name = Entry::word(taken.body.material(), taken.material.name.clone());
        let notes = taken.notes().map(|(key, note)| Entry::word(key, note));
        std::iter::once(name).chain(notes).collect::<Vec<_>>()
    };
    materials.iter().flat_map(of).collect()
}

/// The keys of a law that are not numbers.
fn words_of_law(law: &LawChoice) -> Vec<Entry> {
    let jumps = |key, jumps| {
        Entry::word(
            key,
            match jumps {
                Jumps::Printed => "printed",
                Jumps::Crossed => "crossed",
            },
        )
    };
    match law {
        LawChoice::Plm(plm) => vec![coefficients(plm)],
        LawChoice::JacksonGreen(law) => {
            let hardness = match law.hardness {
                Hardness::Exponential => "exponential",
                Hardness::Cosine => "cosine",
            };
            vec![Entry::word("law.jackson_green.hardness", hardness), jumps("law.jackson_green.jumps", law.jumps)]
        }
        LawChoice::KogutEtsion(law) => vec![jumps("law.kogut_etsion.jumps", law.jumps)],
        LawChoice::KogutKomvopoulos(law) => vec![jumps("law.kogut_komvopoulos.jumps", law.jumps)],
        _ => Vec::new(),
    }
}

/// The law of a scene without an impact.
pub(super) fn of_law(law: &LawChoice) -> Vec<Entry> {
    let input = Input { law: law.clone(), ..Input::default() };
    let numbers = KEYS.iter().filter(|key| key.path.starts_with("law."));
    numbers.filter_map(|key| Some(Entry::of(key, (key.get)(&input)?))).chain(words_of_law(law)).collect()
}

fn coefficients(plm: &Plm) -> Entry {
    let provenance = &plm.coefficients.provenance;
    Entry::word("law.plm.coefficients", format!("{} ({})", provenance.name, provenance.source))
}

/// The numeric keys that a scenario without an impact gives. A diameter counts as the radius.
pub(super) fn given(scenario: &Scenario, paths: &[&str]) -> Vec<Entry> {
    let value = |path: &str| match path {
        "sphere.radius" => scenario.sphere_radius().map(Given::Number),
        path => scenario.given(path),
    };
    let keys = KEYS.iter().filter(|key| paths.contains(&key.path));
    keys.filter_map(|key| Some(Entry::of(key, value(key.path)?))).collect()
}

pub(super) const SPHERE: [&str; 3] = ["sphere.radius", "sphere.youngs_modulus", "sphere.poissons_ratio"];

/// The keys of the strength of a half-space, besides its yield strength.
pub(super) const STRENGTH: [&str; 5] = [
    HARDNESS,
    "half_space.flow_stress.power.exponent",
    "half_space.flow_stress.voce.saturation",
    "half_space.flow_stress.voce.rate",
    "half_space.flow_stress.linear.slope",
];
