//! What was understood of a scenario, for a person: every value in SI and in a unit that fits, and what follows from them
//! before anything is run.

use std::fmt::Write as _;

use super::indentation::IndentationScene;
use super::{KEYS, Scene};
use crate::compare::Comparison;
use crate::impact::{Contact, Method};
use crate::indentation::{StaticContact, Target};
use crate::law::{LawChoice, PlmCoefficients, UnloadingExponent};
use crate::material::Pair;
use crate::units::{Dimension, describe, human, number};

/// A few aligned lines.
#[must_use]
pub fn overview(scene: &Scene, contact: &Contact) -> String {
    let mut rows = given(scene);
    rows.push((String::new(), String::new()));
    rows.extend(derived(contact));
    aligned(&rows)
}

/// The same for an indentation, with the contact of every half-space.
#[must_use]
pub fn of_indentation(scene: &IndentationScene, contacts: &[StaticContact]) -> String {
    let mut rows = Vec::new();
    let mut row = |name: &str, value: String| rows.push((name.to_owned(), value));
    let indenter = &scene.indenter;
    let modulus = indenter.material.youngs_modulus;
    row("sphere.radius", describe(indenter.radius, Dimension::Length));
    let rigid = || "rigid".to_owned();
    row("sphere.youngs_modulus", if modulus.is_finite() { describe(modulus, Dimension::Pressure) } else { rigid() });
    row("sphere.poissons_ratio", number(indenter.material.poissons_ratio));
    if let Some(strength) = indenter.yield_strength {
        row("sphere.yield_strength", describe(strength, Dimension::Pressure));
    }
    for (i, target) in (1..).zip(&scene.targets) {
        let (what, value) = match *target {
            Target::Load(load) => ("load", describe(load, Dimension::Force)),
            Target::Indentation(indentation) => ("indentation", describe(indentation, Dimension::Length)),
        };
        row(&format!("step {i}"), format!("{what} {value}"));
    }
    if scene.specimens.iter().any(|specimen| specimen.half_space.yield_strength.is_some()) {
        row("law.plm.unloading_exponent", exponent(scene.exponent));
        row("law.plm.coefficients", provenance(&scene.coefficients));
    }
    row("output.samples", scene.samples.to_string());
    for (specimen, contact) in scene.specimens.iter().zip(contacts) {
        let (half_space, pair) = (&specimen.half_space, contact.pair());
        row("", String::new());
        row("half-space", specimen.name.clone().unwrap_or_default());
        let pressure = |value: f64, uncertainty: Option<f64>| match uncertainty {
            Some(by) => format!("{} ± {}", describe(value, Dimension::Pressure), human(by, Dimension::Pressure)),
            None => describe(value, Dimension::Pressure),
        };
        row("youngs_modulus", pressure(half_space.material.youngs_modulus, specimen.modulus_uncertainty));
        row("poissons_ratio", number(half_space.material.poissons_ratio));
        if let Some(strength) = half_space.yield_strength {
            row("yield_strength", pressure(strength, specimen.strength_uncertainty));
        }
        for (name, value) in paired(pair) {
            row(&name, value);
        }
    }
    aligned(&rows)
}

/// The same for a comparison of unloading laws.
#[must_use]
pub fn of_comparison(comparison: &Comparison) -> String {
    let mut rows = Vec::new();
    let mut row = |name: &str, value: String| rows.push((name.to_owned(), value));
    let bodies = &comparison.bodies;
    let modulus = comparison.sphere_modulus;
    row("sphere.radius", describe(bodies.pair.radius, Dimension::Length));
    row(
        "sphere.youngs_modulus",
        if modulus.is_finite() { describe(modulus, Dimension::Pressure) } else { "rigid".to_owned() },
    );
    row("half_space.poissons_ratio", number(bodies.poissons_ratio));
    row("half_space.yield_strength", describe(bodies.yield_strength, Dimension::Pressure));
    for law in &comparison.laws {
        if let LawChoice::Plm(plm) = law {
            row("law.plm.unloading_exponent", exponent(plm.exponent));
            row("law.plm.coefficients", provenance(&plm.coefficients));
        }
    }
    let names: Vec<String> = comparison.laws.iter().map(LawChoice::name).collect();
    row("laws", names.join(", "));
    rows.push((String::new(), String::new()));
    rows.extend(paired(&bodies.pair));
    aligned(&rows)
}

fn exponent(exponent: UnloadingExponent) -> String {
    match exponent {
        UnloadingExponent::Paper => "1.5".to_owned(),
        UnloadingExponent::Fixed(value) => number(value),
        UnloadingExponent::PressureShape => "pressure-shape".to_owned(),
    }
}

fn provenance(coefficients: &PlmCoefficients) -> String {
    let provenance = &coefficients.provenance;
    format!("{} ({})", provenance.name, provenance.source)
}

/// What follows from the pair alone.
fn paired(pair: &Pair) -> Vec<(String, String)> {
    let mut rows = Vec::new();
    let mut row = |name: &str, value: String| rows.push((name.to_owned(), value));
    row("effective modulus E*", describe(pair.effective_modulus, Dimension::Pressure));
    row("share of the sphere kappa", number(pair.sphere_compliance));
    match pair.yield_point {
        Some(point) => {
            row("yield indentation delta_Y", describe(point.indentation, Dimension::Length));
            row("yield force F_Y", describe(point.force, Dimension::Force));
        }
        None => row("yield point", ELASTIC.to_owned()),
    }
    rows
}

const ELASTIC: &str = "none: the half-space has no yield_strength and stays elastic";

fn aligned(rows: &[(String, String)]) -> String {
    let width = rows.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    rows.iter().fold(String::new(), |mut text, (name, value)| {
        let _ = writeln!(text, "{}", format!("{name:<width$}  {value}").trim_end());
        text
    })
}

fn given(scene: &Scene) -> Vec<(String, String)> {
    let can_yield = scene.half_space.yield_strength.is_some();
    let mut rows: Vec<(String, String)> = KEYS
        .iter()
        // the diameter is the radius said otherwise, and an elastic half-space has no use for the law's keys
        .filter(|key| key.path != "sphere.diameter" && (can_yield || !key.path.starts_with("law.")))
        .filter_map(|key| {
            let value = (key.get)(scene)?;
            let text = if value.is_infinite() { "rigid".to_owned() } else { describe(value, key.quantity.dimension) };
            Some((key.path.to_owned(), text))
        })
        .collect();
    let mut row = |name: &str, value: String| rows.push((name.to_owned(), value));
    let is_plm = matches!(scene.law, LawChoice::Plm(_));
    if can_yield && !is_plm {
        let about = scene.law.about();
        row("law", format!("{} ({})", scene.law.name(), scene.law.source()));
        row("law.validity", about.validity.to_owned());
        row("law.confidence", about.confidence.to_owned());
    }
    if can_yield && is_plm {
        if scene.exponent == UnloadingExponent::PressureShape {
            row("law.plm.unloading_exponent", exponent(scene.exponent));
        }
        row("law.plm.coefficients", provenance(&scene.coefficients));
    }
    row("solver.method", scene.solver.method.name().to_owned());
    if scene.solver.method == Method::Verlet {
        row("solver.steps_per_contact", scene.solver.steps_per_contact.to_string());
    }
    row("output.samples", scene.samples.to_string());
    rows
}

fn derived(contact: &Contact) -> Vec<(String, String)> {
    let pair = contact.pair();
    let mut rows = vec![("sphere mass".to_owned(), describe(contact.mass(), Dimension::Mass))];
    rows.extend(paired(pair));
    if let Some(point) = pair.yield_point {
        let speed = contact.yield_speed().map_or_else(String::new, |speed| describe(speed, Dimension::Speed));
        rows.push(("yield contact radius a_Y".to_owned(), describe(point.contact_radius, Dimension::Length)));
        rows.push(("yield speed v_Y".to_owned(), speed));
    }
    rows
}
