//! What was understood of a scenario, for a person: every value in SI and in a unit that fits, and what follows from them
//! before anything is run.

use std::fmt::Write as _;

use super::{KEYS, Scene};
use crate::impact::{Contact, Method};
use crate::units::{Dimension, describe, number};

/// A few aligned lines.
#[must_use]
pub fn overview(scene: &Scene, contact: &Contact) -> String {
    let mut rows = given(scene);
    rows.push((String::new(), String::new()));
    rows.extend(derived(contact));
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
    let is_plm = matches!(scene.law, crate::law::LawChoice::Plm(_));
    if can_yield && !is_plm {
        let about = scene.law.about();
        row("law", format!("{} ({})", scene.law.name(), scene.law.source()));
        row("law.validity", about.validity.to_owned());
        row("law.confidence", about.confidence.to_owned());
    }
    if can_yield && is_plm {
        if scene.exponent == crate::law::UnloadingExponent::PressureShape {
            row("law.plm.unloading_exponent", "pressure-shape".to_owned());
        }
        let provenance = &scene.coefficients.provenance;
        row("law.plm.coefficients", format!("{} ({})", provenance.name, provenance.source));
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
    let mut rows = Vec::new();
    let mut row = |name: &str, value: String| rows.push((name.to_owned(), value));
    row("sphere mass", describe(contact.mass(), Dimension::Mass));
    row("effective modulus E*", describe(pair.effective_modulus, Dimension::Pressure));
    row("share of the sphere kappa", number(pair.sphere_compliance));
    match pair.yield_point {
        Some(point) => {
            row("yield indentation delta_Y", describe(point.indentation, Dimension::Length));
            row("yield force F_Y", describe(point.force, Dimension::Force));
            row("yield contact radius a_Y", describe(point.contact_radius, Dimension::Length));
            row(
                "yield speed v_Y",
                contact.yield_speed().map_or_else(String::new, |speed| describe(speed, Dimension::Speed)),
            );
        }
        None => row("yield point", "none: the half-space has no yield_strength and stays elastic".to_owned()),
    }
    rows
}
