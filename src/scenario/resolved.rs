//! All that a scenario came to, its defaults included: what `check` prints and what a summary lists as `inputs`.

use super::file::SphereTable;
use super::indentation::IndentationScene;
use super::{KEYS, Scenario, ScenarioError, Scene};
use crate::compare::Comparison;
use crate::impact::Method;
use crate::law::jackson_green::{Hardness, Jumps};
use crate::law::{LawChoice, PlmCoefficients, UnloadingExponent};
use crate::material::Material;
use crate::units::{Dimension, describe};

/// What a key came to.
#[derive(Debug, Clone, PartialEq)]
pub enum Given {
    /// A number in SI; an infinite one is the modulus of a rigid sphere.
    Number(f64, Dimension),
    /// A count.
    Count(u64),
    /// A word.
    Word(String),
}

/// A key and what it came to.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// As in the file, with dots.
    pub key: &'static str,
    /// Its value.
    pub value: Given,
}

/// An infinite modulus in words.
pub const RIGID: &str = "rigid";

impl Entry {
    fn number(key: &'static str, value: f64, dimension: Dimension) -> Self {
        Self { key, value: Given::Number(value, dimension) }
    }

    fn word(key: &'static str, word: impl Into<String>) -> Self {
        Self { key, value: Given::Word(word.into()) }
    }

    fn count(key: &'static str, count: usize) -> Self {
        Self { key, value: Given::Count(count as u64) }
    }

    /// Its name in summaries, with the unit: `impact_speed_m_per_s`.
    #[must_use]
    pub fn column(&self) -> String {
        let name = self.key.replace('.', "_");
        match self.value {
            Given::Number(_, dimension) => name + dimension.suffix(),
            Given::Count(_) | Given::Word(_) => name,
        }
    }

    /// Its value for a person.
    #[must_use]
    pub fn text(&self) -> String {
        match &self.value {
            Given::Number(value, _) if value.is_infinite() => RIGID.to_owned(),
            Given::Number(value, dimension) => describe(*value, *dimension),
            Given::Count(count) => count.to_string(),
            Given::Word(word) => word.clone(),
        }
    }
}

/// What a scene of impacts came to: numbers in the order of the file, then law, solver and output.
#[must_use]
pub fn of_scene(scene: &Scene) -> Vec<Entry> {
    let can_yield = scene.half_space.yield_strength.is_some();
    // the diameter is the radius said otherwise, and an elastic half-space has no use for the law's keys
    let keys = KEYS.iter().filter(|key| key.path != "sphere.diameter" && (can_yield || !key.path.starts_with("law.")));
    let mut entries: Vec<Entry> =
        keys.filter_map(|key| Some(Entry::number(key.path, (key.get)(scene)?, key.quantity.dimension))).collect();
    if can_yield {
        entries.push(Entry::word("law", scene.law.name()));
        entries.extend(words_of_law(scene));
    }
    entries.push(Entry::word("solver.method", scene.solver.method.name()));
    if scene.solver.method == Method::Verlet {
        entries.push(Entry::count("solver.steps_per_contact", scene.solver.steps_per_contact as usize));
    }
    entries.push(Entry::count("output.samples", scene.samples));
    entries
}

/// The keys of a law that are no numbers.
fn words_of_law(scene: &Scene) -> Vec<Entry> {
    let jumps = |key, jumps| {
        Entry::word(
            key,
            match jumps {
                Jumps::Printed => "printed",
                Jumps::Crossed => "crossed",
            },
        )
    };
    match &scene.law {
        LawChoice::Plm(_) => {
            // an exponent that is a number is among the numbers
            let shape = (scene.exponent == UnloadingExponent::PressureShape).then(|| exponent(scene.exponent));
            shape.into_iter().chain([coefficients(&scene.coefficients)]).collect()
        }
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

fn exponent(exponent: UnloadingExponent) -> Entry {
    let key = "law.plm.unloading_exponent";
    match exponent {
        UnloadingExponent::Paper => Entry::number(key, 1.5, Dimension::Ratio),
        UnloadingExponent::Fixed(value) => Entry::number(key, value, Dimension::Ratio),
        UnloadingExponent::PressureShape => Entry::word(key, "pressure-shape"),
    }
}

fn coefficients(coefficients: &PlmCoefficients) -> Entry {
    let provenance = &coefficients.provenance;
    Entry::word("law.plm.coefficients", format!("{} ({})", provenance.name, provenance.source))
}

fn sphere(radius: f64, material: Material, yield_strength: Option<f64>) -> Vec<Entry> {
    let mut entries = vec![
        Entry::number("sphere.radius", radius, Dimension::Length),
        Entry::number("sphere.youngs_modulus", material.youngs_modulus, Dimension::Pressure),
        Entry::number("sphere.poissons_ratio", material.poissons_ratio, Dimension::Ratio),
    ];
    entries
        .extend(yield_strength.map(|strength| Entry::number("sphere.yield_strength", strength, Dimension::Pressure)));
    entries
}

/// What an indentation came to, but for its steps and half-spaces.
#[must_use]
pub fn of_indentation(scene: &IndentationScene) -> Vec<Entry> {
    let indenter = &scene.indenter;
    let mut entries = sphere(indenter.radius, indenter.material, indenter.yield_strength);
    if scene.specimens.iter().any(|specimen| specimen.half_space.yield_strength.is_some()) {
        entries.extend([exponent(scene.exponent), coefficients(&scene.coefficients)]);
    }
    entries.push(Entry::count("output.samples", scene.samples));
    entries
}

/// What a comparison came to, but for its peak and its laws.
///
/// # Errors
/// [`ScenarioError`] as from [`Scenario::comparison`].
pub fn of_comparison(scenario: &Scenario, comparison: &Comparison) -> Result<Vec<Entry>, ScenarioError> {
    let SphereTable { youngs_modulus, poissons_ratio, .. } = &scenario.file.sphere;
    let material = Material { youngs_modulus: youngs_modulus.0, poissons_ratio: poissons_ratio.0 };
    let half_space = scenario.file.half_space.as_ref().ok_or_else(|| scenario.document.missing("", "half_space"))?;
    let mut entries = sphere(comparison.bodies.pair.radius, material, None);
    entries.extend([
        Entry::number("half_space.youngs_modulus", half_space.youngs_modulus.0, Dimension::Pressure),
        Entry::number("half_space.poissons_ratio", half_space.poissons_ratio.0, Dimension::Ratio),
        Entry::number("half_space.yield_strength", comparison.bodies.yield_strength, Dimension::Pressure),
    ]);
    for law in &comparison.laws {
        if let LawChoice::Plm(plm) = law {
            entries.extend([exponent(plm.exponent), coefficients(&plm.coefficients)]);
        }
    }
    Ok(entries)
}
