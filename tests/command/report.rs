//! The files of an impact agree with the computed impact: keys, values, rows.

use plm_impact::impact::{Contact, Event, Impact, Solver};
use plm_impact::law::Plm;
use plm_impact::material::{HalfSpace, Material, Sphere};
use plm_impact::provenance::{FORMAT, LawOf, MethodOf, Provenance, VERSION};
use plm_impact::report;
use plm_impact::report::inputs::Inputs;
use plm_impact::scenario::Scenario;
use plm_impact::scene::Scene;
use serde_json::Value;

use crate::common::STEEL;

const SAMPLES: usize = 40;

fn contact(sphere_modulus: f64, yield_strength: Option<f64>) -> Contact {
    let material = |youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 };
    let sphere = Sphere { radius: 5e-3, material: material(sphere_modulus), density: 7850.0, yield_strength: None };
    let half_space = HalfSpace { material: material(210e9), yield_strength, density: None };
    Contact::try_new(sphere, half_space, &Plm::default()).unwrap()
}

fn impact(contact: &Contact, speed: f64) -> Impact {
    contact.impact(speed, &Solver::default(), Some(SAMPLES)).unwrap()
}

/// The inputs of the scene of a contact.
fn inputs(contact: &Contact, speed: f64) -> Inputs {
    let scene = Scenario::from_text("steel", STEEL, &[]).unwrap().resolve().unwrap();
    Inputs::of(&Scene { sphere: *contact.sphere(), half_space: *contact.half_space(), speed, ..scene })
}

fn provenance() -> Provenance {
    Provenance {
        scenario_file: "scenarios/steel.toml".into(),
        method: Some(MethodOf { method: "dop853", tolerance: 1e-10 }),
        law: Some(LawOf {
            law: "plm".into(),
            law_source: None,
            coefficients: Some("built-in".into()),
            coefficients_source: Some("finite elements".into()),
        }),
        format_version: FORMAT,
        version: VERSION,
        scenario_sha256: "00ff".into(),
        command: "plm-impact run scenarios/steel.toml".into(),
    }
}

fn summary(contact: &Contact, impact: &Impact) -> Value {
    serde_json::from_str(&report::summary(contact, impact, &inputs(contact, impact.speed), &provenance()).unwrap())
        .unwrap()
}

#[test]
fn every_number_of_the_summary_reads_back_to_the_same_bits() {
    let contact = contact(210e9, Some(345e6));
    let impact = impact(&contact, 3.0);
    let summary = summary(&contact, &impact);
    let point = contact.pair().yield_point.unwrap();
    let expected = [
        ("/restitution", impact.restitution),
        ("/rebound_speed_m_per_s", impact.rebound_speed),
        ("/contact_time_s", impact.contact_time),
        ("/loading_time_s", impact.loading_time),
        ("/peak_force_N", impact.peak_force),
        ("/peak_indentation_m", impact.peak_indentation),
        ("/peak_sphere_indentation_m", impact.peak_sphere_indentation),
        ("/peak_contact_radius_m", impact.peak_contact_radius),
        ("/peak_mean_pressure_Pa", impact.peak_mean_pressure),
        ("/elastic_approach_m", impact.elastic_approach),
        ("/residual_indentation_m", impact.residual_indentation),
        ("/unloading_radius_m", impact.unloading_radius),
        ("/residual_radius_m", impact.residual_radius.unwrap()),
        ("/dent_radius_m", impact.dent_radius.unwrap()),
        ("/yield_speed_m_per_s", contact.yield_speed().unwrap()),
        ("/yield_indentation_m", point.indentation),
        ("/yield_force_N", point.force),
        ("/energy/kinetic_in_J", impact.energy.kinetic_in),
        ("/energy/recovered_J", impact.energy.recovered),
        ("/energy/plastic_J", impact.energy.plastic.unwrap()),
        ("/energy/drift", impact.energy.drift),
        ("/accuracy/closed_form_restitution", impact.accuracy.closed_form_restitution),
        ("/accuracy/restitution_error", impact.accuracy.restitution_error),
        ("/accuracy/contact_time_error", impact.accuracy.contact_time_error),
        ("/effective_modulus_Pa", contact.pair().effective_modulus),
        ("/sphere_compliance", contact.pair().sphere_compliance),
        ("/sphere_mass_kg", contact.mass()),
        ("/unloading_exponent", 1.5),
        ("/inputs/sphere_radius_m", 5e-3),
        ("/inputs/sphere_youngs_modulus_Pa", 210e9),
        ("/inputs/sphere_poissons_ratio", 0.3),
        ("/inputs/sphere_density_kg_per_m3", 7850.0),
        ("/inputs/half_space_youngs_modulus_Pa", 210e9),
        ("/inputs/half_space_poissons_ratio", 0.3),
        ("/inputs/half_space_yield_strength_Pa", 345e6),
        ("/inputs/impact_speed_m_per_s", 3.0),
        ("/provenance/tolerance", 1e-10),
    ];
    for (key, value) in expected {
        assert_eq!(summary.pointer(key).and_then(Value::as_f64), Some(value), "{key}");
    }
    assert_eq!(summary["work"]["steps"], impact.work.steps);
    assert_eq!(summary["work"]["rejected"], impact.work.rejected);
    assert_eq!(summary["work"]["force_evaluations"], impact.work.force_evaluations);
    assert_eq!(summary["warnings"], Value::Array(vec![]));
    assert_eq!(summary["provenance"]["scenario_sha256"], "00ff");
    assert_eq!(summary["provenance"]["method"], "dop853");
    assert_eq!(summary["provenance"]["format_version"], FORMAT);
}

#[test]
fn an_elastic_scene_says_nothing_plastic() {
    let contact = contact(210e9, None);
    let impact = impact(&contact, 3.0);
    let text = report::summary(&contact, &impact, &inputs(&contact, impact.speed), &provenance()).unwrap()
        + &report::table(&contact, &impact);
    for word in ["yield", "residual", "dent_", "dent ", "plastic", "unloading_radius"] {
        assert!(!text.contains(word), "{word} in\n{text}");
    }
}

#[test]
fn an_impact_below_the_yield_speed_has_no_dent() {
    let contact = contact(210e9, Some(345e6));
    let summary = summary(&contact, &impact(&contact, 1e-3)); // v_Y is 9.7 mm/s
    assert_eq!(summary["residual_indentation_m"], 0.0);
    assert!(summary["residual_radius_m"].is_null() && summary.get("residual_radius_m").is_some());
    assert!(summary["dent_radius_m"].is_null() && summary.get("dent_radius_m").is_some());
    assert_eq!(summary["energy"]["plastic_J"], 0.0);
}

#[test]
fn a_rigid_sphere_is_named_so() {
    let contact = contact(f64::INFINITY, Some(345e6));
    let summary = summary(&contact, &impact(&contact, 3.0));
    assert_eq!(summary["inputs"]["sphere_youngs_modulus_Pa"], "rigid");
    assert_eq!(summary["peak_sphere_indentation_m"], 0.0);
}

#[test]
fn warnings_reach_the_summary() {
    let contact = contact(210e9, Some(345e6));
    let impact = impact(&contact, 300.0); // a/R beyond 0.45
    assert!(!impact.warnings.is_empty());
    assert_eq!(summary(&contact, &impact)["warnings"][0], impact.warnings[0].to_string());
}

#[test]
fn the_trace_has_every_sample_and_every_event_as_exact_rows() {
    let contact = contact(210e9, Some(345e6));
    let impact = impact(&contact, 3.0);
    let bytes = report::trace(&impact).unwrap();
    let mut reader = csv::Reader::from_reader(bytes.as_slice());
    assert_eq!(
        reader.headers().unwrap().iter().collect::<Vec<_>>(),
        [
            "time_s",
            "indentation_m",
            "sphere_indentation_m",
            "half_space_indentation_m",
            "speed_m_per_s",
            "force_N",
            "branch",
            "event"
        ]
    );
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let number = |row: &csv::StringRecord, column: usize| row[column].parse::<f64>().unwrap();
    let inner =
        impact.trace.iter().filter(|row| matches!(row.event, Some(Event::Yield | Event::Knot | Event::Peak))).count();
    // first touch and separation are samples; the events between them are additional rows
    assert_eq!(rows.len(), SAMPLES + inner);
    for (row, expected) in rows.iter().zip(&impact.trace) {
        let got: Vec<f64> = (0..6).map(|column| number(row, column)).collect();
        let want = [
            expected.time,
            expected.indentation,
            expected.sphere_indentation,
            expected.half_space_indentation,
            expected.speed,
            expected.force,
        ];
        assert_eq!(got, want);
        assert_eq!(&row[6], expected.branch.name());
    }
    let named = |name: &str| rows.iter().filter(|row| &row[7] == name).collect::<Vec<_>>();
    for name in ["touch", "yield", "peak", "separation"] {
        assert_eq!(named(name).len(), 1, "{name}");
    }
    // the built-in law has knots at x = 1.7, 2.4, 3.4, 5, 9, 18, 36, 80; this impact reaches x = 136
    assert_eq!(named("knot").len(), 8);
    let (peak, separation) = (named("peak")[0], named("separation")[0]);
    assert_eq!((number(peak, 4), number(peak, 5)), (0.0, impact.peak_force));
    assert_eq!((number(separation, 0), number(separation, 5)), (impact.contact_time, 0.0));
    approx::assert_relative_eq!(number(separation, 1), impact.residual_indentation, max_relative = 1e-12);
    assert_eq!(&rows[0][7], "touch");
    assert_eq!(&rows[rows.len() - 1][7], "separation");
}

#[test]
fn the_table_is_short_and_in_engineering_units() {
    let contact = contact(210e9, Some(345e6));
    let table = report::table(&contact, &impact(&contact, 3.0));
    // src/reference/oracle.csv, this scene: e = 0.49246, F_m = 1105.7 N, δ_m = 36.948 µm, T = 28.86 µs
    for text in ["0.4925", "1.106 kN", "36.95 µm", "28.86 µs", "24.25 % recovered, 75.75 % into the dent"] {
        assert!(table.contains(text), "{text} not in\n{table}");
    }
    assert!(table.lines().all(|line| !line.ends_with(' ')));
}
