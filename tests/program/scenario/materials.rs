//! The materials: their numbers against published values, and the command that lists them.

use std::collections::BTreeSet;

use plm_impact::materials::read;
use plm_impact::scenario::keys::quantity::{
    DENSITY, HARDENING_EXPONENT, HARDNESS, MODULUS, POISSONS_RATIO, Quantity, RATE_SENSITIVITY,
};

use serde_json::json;

use crate::common::prelude::*;

fn quantity(property: Property) -> &'static Quantity {
    match property {
        Property::Density => &DENSITY,
        Property::YoungsModulus => &MODULUS,
        Property::PoissonsRatio => &POISSONS_RATIO,
        Property::Hardness => &HARDNESS,
        Property::HardeningExponent => &HARDENING_EXPONENT,
        Property::RateSensitivity => &RATE_SENSITIVITY,
    }
}

#[test]
fn values_are_valid_and_have_two_sources() {
    let mut names = BTreeSet::new();
    for entry in all_materials() {
        let name = &entry.name;
        assert!(names.insert(name), "{name} is there twice");
        assert!(name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || "-.".contains(c)), "{name}");
        assert!(!entry.title.is_empty());
        for needed in [Property::Density, Property::YoungsModulus, Property::PoissonsRatio] {
            assert!(entry.get(needed).is_some(), "{name}: {}", needed.name());
        }
        assert!(entry.is_metal() || entry.get(Property::HardeningExponent).is_none(), "{name}");
        for known in &entry.properties {
            let place = format!("{name}.{}", known.property.name());
            let [low, high] = &known.range;
            for written in [&known.value, low, high] {
                assert_eq!(quantity(known.property).parse(&written.text), Ok(written.value), "{place}");
            }
            assert!(low.value <= known.value.value && known.value.value <= high.value, "{place}");
            let sources: BTreeSet<_> = known.sources.iter().map(|[source, _]| source).collect();
            assert!(sources.len() >= 2 && !known.basis.is_empty(), "{place}");
            assert!(known.sources.iter().all(|[source, says]| !source.is_empty() && !says.is_empty()), "{place}");
        }
    }
    assert_eq!(names.len(), 40);
}

fn value(name: &str, property: Property) -> f64 {
    find(name).and_then(|entry| entry.get(property)).map_or(f64::NAN, |known| known.value.value)
}

#[test]
fn values_are_those_that_are_published() {
    let rows: Vec<(String, String, String, f64, String)> = records(include_str!("materials_published.csv"));
    assert_eq!(rows.len(), 20);
    for (name, property, published, tolerance, source) in rows {
        let known = &find(&name).unwrap().properties;
        let known = known.iter().find(|known| known.property.name() == property).unwrap();
        let published = quantity(known.property).parse(&published).unwrap();
        assert!(relative_error(known.value.value, published) <= tolerance, "{name}.{property} of {source}");
    }
}

#[test]
fn tension_data_and_hardness_give_equal_strength() {
    // K [MPa] and n of stress = K strain^n, measured in tension (Kalpakjian and Schmid; Callister). At the plastic
    // strain of a hardness test this stress has to agree with the stress of the hardness, which is accurate to 10 %. n
    // varies from batch to batch; the farthest is 304 with 24 %
    let measured = [
        ("steel-304-annealed", 1275.0, 0.45),
        ("steel-304-annealed", 1400.0, 0.44),
        ("copper-annealed", 530.0, 0.44),
        ("aluminium-2024-t3", 780.0, 0.17),
        ("aluminium-6061-t6", 410.0, 0.05),
        ("brass-cuzn30-annealed", 895.0, 0.49),
    ];
    for (name, strength, exponent) in measured {
        let tension = 1e6 * strength * f64::powf(0.08, exponent);
        assert_relative_eq!(flow_stress(name), tension, max_relative = 0.245);
    }
    // the 0.2 % proof stress of annealed 304 (AK Steel: 290 MPa) is far below the flow stress of its hardness
    assert!(290e6 < 0.6 * flow_stress("steel-304-annealed"));
}

/// The flow stress of the hardness of a metal.
fn flow_stress(name: &str) -> f64 {
    let metal = all_materials().iter().find(|entry| entry.name == name).unwrap();
    metal.flow_stress(value(name, Property::Hardness))
}

/// σ_Y (1 + E ε/σ_Y)^N.
fn power(start: f64, modulus: f64, exponent: f64, strain: f64) -> f64 {
    start * (1.0 + modulus * strain / start).powf(exponent)
}

#[test]
fn named_power_law_keeps_proof_stress() {
    // least and largest usual 0.2 % proof stress: EN 10088-3 (1.4301, minimum) and AK Steel; ASM for C11000 annealed and
    // Callister; ASM (2024-T3 sheet, minimum) and MatWeb
    let usual = [
        ("steel-304-annealed", [190e6, 290e6]),
        ("copper-annealed", [33e6, 69e6]),
        ("aluminium-2024-t3", [290e6, 345e6]),
    ];
    let mut compared = 0;
    for entry in all_materials() {
        let Some(exponent) = entry.get(Property::HardeningExponent) else { continue };
        let [hardness, modulus] =
            [Property::Hardness, Property::YoungsModulus].map(|property| value(&entry.name, property));
        let (start, exponent) = (entry.strength(hardness), exponent.value.value);
        // the curve goes through the flow stress of the hardness
        assert_relative_eq!(power(start, modulus, exponent, 0.08), flow_stress(&entry.name), max_relative = 1e-9);
        let proof = power(start, modulus, exponent, 0.002);
        let of_name = usual.iter().find(|(name, _)| *name == entry.name);
        let (_, [low, high]) = of_name.unwrap_or_else(|| panic!("{}: what is its usual proof stress?", entry.name));
        assert!((*low..=1.01 * *high).contains(&proof), "{}: {proof}", entry.name);
        compared += 1;
    }
    assert_eq!(compared, usual.len());
    // two curves of annealed 304 by points, of a usual proof stress: e by name is 1 to 8 % above them (0.45 gave 4 to
    // 18 % too little), as good as the hardness
    let curves = [
        ("205 MPa", "[[0.0, \"205 MPa\"], [0.002, \"240 MPa\"], [0.08, \"529 MPa\"]]"),
        (
            "200 MPa",
            "[[0.0, \"200 MPa\"], [0.002, \"235 MPa\"], [0.01, \"275 MPa\"], [0.03, \"345 MPa\"], [0.08, \"470 MPa\"]]",
        ),
    ];
    let e = |half_space: &str, speed: f64| {
        let text = format!(
            "[sphere]\nradius = \"5 mm\"\nmaterial = \"steel-52100-hardened\"\n[half_space]\nmaterial = \"steel-304-annealed\"\n{half_space}\n\
             [law.plm]\nunloading_exponent = \"pressure-shape\"\n[impact]\nspeed = {speed}\n"
        );
        let scene = Scenario::from_text("s.toml", &text, &[]).unwrap().resolve().unwrap();
        scene.contact().unwrap().closed_form(speed).unwrap().row.restitution
    };
    for (strength, points) in curves {
        let curve = format!("yield_strength = \"{strength}\"\nflow_stress.points = {points}");
        for speed in [0.1, 0.3, 1.0, 3.0, 5.0] {
            let off = e("", speed) / e(&curve, speed) - 1.0;
            assert!((0.0..0.08).contains(&off), "{strength} at {speed} m/s: {off}");
        }
    }
}

#[test]
fn bad_material_file_is_refused_with_position() {
    let file = |value: &str, source: &str| {
        format!(
            "[basis]\n[sources]\nme = \"A book\"\n[[material]]\nname = \"x\"\ntitle = \"X\"\nclass = \"metal\"\n\
             hardness = {{ value = \"{value}\", range = [\"1 HV\", \"2 HV\"], says = {{ {source} = \"1\" }} }}\n"
        )
    };
    let message = |text: &str| read(text).map_err(|error: Error| error.to_string());
    assert!(message(&file("1 HV", "me")).is_ok());
    assert_eq!(message(&file("1 HV", "you")), Err("x.hardness: no source is called \"you\"".to_owned()));
    let outside = message(&file("1 HB", "me"));
    assert!(outside.as_ref().is_err_and(|message| message.starts_with("x.hardness: ")), "{outside:?}");
    assert!(message(&file("1 HV", "me").replace("title", "titel")).is_err());
}

fn materials(arguments: &[&str]) -> String {
    Sandbox::with("").run_expecting(&[&["materials"], arguments].concat(), 0).0
}

#[test]
fn the_command_lists_all_and_prints_one() {
    let list = materials(&[]);
    for entry in all_materials() {
        assert!(
            list.lines().any(|line| line.starts_with(&entry.name) && line.ends_with(&entry.title)),
            "{}",
            entry.name
        );
        let one = materials(&[&entry.name]);
        for known in &entry.properties {
            assert!(one.contains(&format!("{} = \"{}\"\n", known.property.name(), known.value.text)), "{one}");
            for [source, says] in &known.sources {
                assert!(one.contains(&format!("  {source}: {says}\n")), "{one}");
            }
        }
        assert_eq!(one.contains("no strength"), !entry.has_strength(), "{one}");
    }
    let steel = materials(&["steel-304-annealed"]);
    // the strength of 145 HV by another program; the power law of N = 0.25 that has it at a strain of 0.08 begins at 175 MPa
    let flow = "flow stress 539.2 MPa (mean pressure / 2.844); initial yield strength of the power law 175.6 MPa";
    assert!(steel.contains(flow), "{steel}");
}

#[test]
fn the_beginning_of_names_lists_those() {
    let steels = materials(&["steel"]);
    let every = materials(&[]);
    let count = |list: &str, begin: &str| list.lines().filter(|line| line.starts_with(begin)).count();
    assert!(count(&steels, "steel-") > 5 && count(&steels, "steel-") == count(&every, "steel-"), "{steels}");
    assert_eq!((count(&steels, "lead"), count(&every, "lead")), (0, 1));
}

/// Every value lies in its range. The density of the alloy is that of the data sheets, 2700 kg/m^3.
#[test]
fn json_of_materials_has_si_values_and_ranges() {
    let desk = Sandbox::with("");
    let json = |arguments: &[&str]| -> Value { serde_json::from_str(&desk.run_expecting(arguments, 0).0).unwrap() };
    let whole = json(&["materials", "--json"]);
    assert_eq!(whole.as_array().unwrap().len(), all_materials().len());
    for property in whole.as_array().unwrap().iter().flat_map(|one| one["properties"].as_object().unwrap().values()) {
        let [low, value, high] = ["low", "value", "high"].map(|name| property[name].as_f64().unwrap());
        assert!(low <= value && value <= high && property["sources"].is_array(), "{property}");
    }
    // a whole name finds one material alone
    let one = json(&["materials", "aluminium-6061-t6", "--json"]);
    assert_eq!((one.as_array().unwrap().len(), &one[0]["name"]), (1, &json!("aluminium-6061-t6")));
    assert_eq!(one[0]["properties"]["density_kg_per_m3"]["value"], 2700.0);
    assert_eq!(json(&["materials", "1.4301", "--json"])[0]["class"], "metal");
}
