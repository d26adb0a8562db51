//! The list of materials, and the page about one of them, for the terminal.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use crate::materials::{MaterialEntry, Property, PropertyValue, all_materials};
use crate::strings::align_columns;
use crate::units::{Dimension, format_four_digits, format_result};

/// True if the name or the description of a material has this text, in capitals or not: "304", "100Cr6", "1.4301".
pub fn is_match(entry: &MaterialEntry, text: &str) -> bool {
    let text = text.to_lowercase();
    [&entry.name, &entry.title].into_iter().chain(&entry.aliases).any(|words| words.to_lowercase().contains(&text))
}

/// A head, and a row for every material whose name or description has this text.
pub fn material_rows(text: &str) -> Vec<[String; 7]> {
    let heads = ["name", "density", "E", "nu", "hardness", "n", "what it is"];
    let mut rows = vec![heads.map(ToOwned::to_owned)];
    rows.extend(all_materials().iter().filter(|entry| is_match(entry, text)).map(|entry| {
        let text = |property| entry.get(property).map_or_else(|| "-".to_owned(), |known| known.value.text.clone());
        let [density, modulus, ratio, hardness, exponent, _] = Property::ALL.map(text);
        [entry.name.clone(), density, modulus, ratio, hardness, exponent, entry.title.clone()]
    }));
    rows
}

/// The materials whose name or description has this text, one per line.
pub fn materials_text(text: &str) -> String {
    let table = align_columns(&material_rows(text), |column| column == 0 || column == 6);
    format!(
        "Materials for `material = \"NAME\"` in [sphere] and [half_space]. Keys next to `material` override its values.\n\
         `plm-impact materials NAME` prints ranges and sources. Materials without hardness are elastic.\n\n{table}"
    )
}

/// These materials as JSON, with all values in SI.
pub fn materials_json(entries: &[&MaterialEntry]) -> Value {
    let property = |known: &PropertyValue| {
        let PropertyValue { property, value: used, range: [low, high], basis, sources } = known;
        let sources = sources.iter().map(|[source, says]| json!({ "source": source, "says": says }));
        let about = json!({
            "written": used.text, "value": used.value, "low": low.value, "high": high.value,
            "basis": basis, "sources": sources.collect::<Vec<_>>(),
        });
        (property.name().to_owned() + property.dimension().suffix(), about)
    };
    let entry = |entry: &&MaterialEntry| {
        json!({
            "name": entry.name, "aliases": entry.aliases, "title": entry.title, "class": entry.class.name(), "note": entry.note,
            "properties": entry.properties.iter().map(property).collect::<Map<_, _>>(),
        })
    };
    entries.iter().map(entry).collect()
}

/// The page about one material: values, ranges, the kind of each number, and its sources.
pub fn material_page(entry: &MaterialEntry) -> String {
    let mut text = format!("{}\n  {} ({})\n", entry.name, entry.title, entry.class.name());
    if !entry.aliases.is_empty() {
        let _ = writeln!(text, "  also called {}", entry.aliases.join(", "));
    }
    if let Some(note) = &entry.note {
        let _ = writeln!(text, "  {note}");
    }
    for PropertyValue { property, value: used, range: [low, high], basis, sources } in &entry.properties {
        let _ = writeln!(text, "\n{} = \"{}\"", property.name(), used.text);
        let _ = writeln!(text, "  from {} to {}; {basis}", low.text, high.text);
        if *property == Property::Hardness {
            let _ = writeln!(text, "  {}", strength_text(entry, used.value));
        }
        for [source, says] in sources {
            let _ = writeln!(text, "  {source}: {says}");
        }
    }
    if !entry.has_strength() {
        let _ = writeln!(
            text,
            "\nno strength: a half-space of this material is elastic. Set yield_strength or hardness to model a dent."
        );
    }
    text
}

/// Poisson's ratio of most metals.
const USUAL_POISSONS_RATIO: f64 = 0.3;
/// The share of the flow stress from which on the page states the part of Poisson's ratio.
const NOTABLE: f64 = 0.015;

/// The flow stress and the yield strength that follow from a hardness.
fn strength_text(entry: &MaterialEntry, mean_pressure: f64) -> String {
    let stress = entry.flow_stress(mean_pressure);
    let at_usual_ratio = entry.flow_stress_at_poissons_ratio(mean_pressure, USUAL_POISSONS_RATIO);
    let by_ratio = if (stress / at_usual_ratio - 1.0).abs() > NOTABLE {
        format!("; / {} with nu = {USUAL_POISSONS_RATIO}", format_four_digits(mean_pressure / at_usual_ratio))
    } else {
        String::new()
    };
    let flow = format!(
        "flow stress {} (mean pressure / {}{by_ratio})",
        format_result(stress, Dimension::Pressure),
        format_four_digits(mean_pressure / stress)
    );
    if !entry.has_hardening() {
        return flow;
    }
    format!(
        "{flow}; initial yield strength of the power law {}",
        format_result(entry.strength(mean_pressure), Dimension::Pressure)
    )
}
