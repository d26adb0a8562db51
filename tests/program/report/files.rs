//! The files of an impact agree with the computed impact: keys, values, rows.

use plm_impact::files::provenance::FORMAT_VERSION;
use plm_impact::numerics::ode::SolverStats;

use serde_json::json;

use crate::common::prelude::*;

const SAMPLES: usize = 40;

/// The contact, the impact, and what a run writes of it.
struct Ran {
    contact: Contact,
    impact: Impact,
    summary: Value,
    trace: String,
}

fn ran(set: &[&str]) -> Ran {
    let scenario = read(STEEL, &[&["output.samples=40"], set].concat());
    let (_, contact, impact) = run::impact::compute(&scenario, Some(SAMPLES)).unwrap();
    let outcome = outcome(&scenario);
    let summary = serde_json::from_str(&text_of_file(&outcome, "summary.json")).unwrap();
    Ran { contact, impact, summary, trace: text_of_file(&outcome, "trace.csv") }
}

/// Those that `tests/program/scenario/results.toml` has no reference for.
#[test]
fn summary_numbers_read_back_to_same_bits() {
    let Ran { contact, impact, summary, .. } = ran(&[]);
    for (key, value) in [
        ("/peak_contact_radius_m", impact.row.peak_contact_radius),
        ("/contact_radius_over_R", impact.row.peak_contact_radius / contact.sphere().radius),
        ("/peak_mean_pressure_Pa", impact.peak_mean_pressure),
        ("/residual_radius_m", impact.residual_radius.unwrap()),
        ("/dent_diameter_m", 2.0 * impact.dent_radius.unwrap()),
        ("/energy/balance_error", impact.energy.balance_error),
        ("/accuracy/closed_form_restitution", impact.accuracy.closed_form_restitution),
        ("/accuracy/restitution_error", impact.accuracy.restitution_error),
        ("/accuracy/contact_time_error", impact.accuracy.contact_time_error),
    ] {
        assert_eq!(summary.pointer(key).and_then(Value::as_f64), Some(value), "{key}");
    }
    let SolverStats { steps, rejected, force_evaluations } = impact.stats;
    assert_eq!(
        summary["work"],
        json!({ "steps": steps, "rejected": rejected, "force_evaluations": force_evaluations })
    );
    assert_eq!(summary["provenance"]["format_version"], FORMAT_VERSION);
}

/// A half-space without a yield strength says nothing plastic.
#[test]
fn elastic_scene_reports_no_plastic_results() {
    let desk = Sandbox::with(STEEL.replace("yield_strength = \"345 MPa\"\n", ""));
    let (table, _) = desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
    let text = table + &desk.read("out/summary.json");
    for word in ["yield", "residual", "dent_", "dent ", "plastic", "unloading_radius"] {
        assert!(!text.contains(word), "{word} in\n{text}");
    }
}

#[test]
fn trace_has_samples_and_events_as_exact_rows() {
    let Ran { impact, trace, .. } = ran(&[]);
    let of = |name: &str| numbers(&trace, name);
    let columns =
        ["time_s", "indentation_m", "sphere_indentation_m", "half_space_indentation_m", "speed_m_per_s", "force_N"];
    assert_eq!(trace.lines().next().unwrap(), columns.join(",") + ",branch,event");
    for (row, want) in impact.trace.iter().enumerate() {
        let want =
            [want.time, want.indentation, want.sphere_indentation, want.half_space_indentation, want.speed, want.force];
        assert_eq!(columns.map(|name| of(name)[row]), want, "row {row}");
    }
    let branches: Vec<&str> = impact.trace.iter().map(|row| row.branch.name()).collect();
    assert_eq!(column(&trace, "branch"), branches);
    // first touch and separation are samples; the events between them are additional rows: first yield, the knots at
    // 20 knots from x = 1.7 to 100 of the built-in law, as this impact reaches x = 129, and the peak
    let events = column(&trace, "event");
    assert_eq!(events.len(), SAMPLES + 22);
    let named = |name: &str| (0..events.len()).filter(|row| events[*row] == name).collect::<Vec<_>>();
    assert_eq!((named("touch"), named("separation")), (vec![0], vec![events.len() - 1]));
    assert_eq!((named("yield").len(), named("knot").len(), named("peak").len()), (1, 20, 1));
    let peak = named("peak")[0];
    assert_eq!((of("speed_m_per_s")[peak], of("force_N")[peak]), (0.0, impact.row.peak_force));
    let end = events.len() - 1;
    assert_eq!((of("time_s")[end], of("force_N")[end]), (impact.row.contact_time, 0.0));
    assert_relative_eq!(of("indentation_m")[end], impact.row.residual_indentation, max_relative = 1e-12);
}

/// The numbers of a check are those of the run, with all digits, in every kind of scene.
#[test]
fn json_check_has_inputs_and_contact_of_run() {
    let desk = Sandbox::with_results(STEEL);
    let summary = desk.summary();
    let checked: Value = serde_json::from_str(&desk.run_expecting(&["check", "s.toml", "--json"], 0).0).unwrap();
    assert_eq!((&checked["kind"], &checked["inputs"]), (&json!("impact"), &summary["inputs"]));
    assert_eq!(checked["warnings"], summary["warnings"]);
    let contact = checked["contact"].as_object().unwrap();
    for name in ["sphere_mass_kg", "effective_modulus_Pa", "sphere_compliance", "yield_indentation_m", "yield_force_N"]
    {
        assert_eq!(contact[name], summary[name], "{name}");
    }
    assert_eq!(contact["yield_speed_m_per_s"], summary["yield_speed_m_per_s"]);
    // Hertz: a^2 = R delta
    let [radius, indentation] =
        ["yield_contact_radius_m", "yield_indentation_m"].map(|name| contact[name].as_f64().unwrap());
    let sphere = contact["effective_radius_m"].as_f64().unwrap();
    assert!((radius * radius / (sphere * indentation) - 1.0).abs() < 1e-14, "{radius} {indentation} {sphere}");

    for (kind, holds) in
        [("sweep", "cases"), ("repeat", "contact"), ("indentation", "half_spaces"), ("calibrate", "keys")]
    {
        let file = format!("{kind}.toml");
        desk.run_expecting(&["init", kind, "--out", &file], 0);
        let checked: Value = serde_json::from_str(&desk.run_expecting(&["check", &file, "--json"], 0).0).unwrap();
        assert_eq!(checked["kind"], kind);
        assert!(!checked[holds].is_null() && checked["inputs"].is_object(), "{checked}");
    }
}

/// Which results and columns an angle adds is in `tests/program/scenario/results.toml`, their numbers are in tests/regression (oblique.toml), and the balances
/// of energy and momentum in tests/core.
#[test]
fn e_of_oblique_impact_uses_normal_speed() {
    let angle = STEEL.replace("3 m/s\"", "3 m/s\"\nangle = \"20 deg\"") + "[friction]\ncoefficient = 0.15\n";
    for (scene, speed) in [(STEEL.to_owned(), 3.0), (angle, 3.0 * 20_f64.to_radians().cos())] {
        let summary = Sandbox::with_results(scene).summary();
        let number = |name: &str| summary[name].as_f64().unwrap();
        assert!(relative_error(number("rebound_speed_m_per_s"), number("restitution") * speed) < 1e-12, "{summary}");
    }
}

/// The line on the closed form in the table of an impact, and the warnings. The line on energy always says how far the balance is off.
fn closed_form_and_warnings(scenario: &Scenario) -> (String, Vec<String>) {
    let run = outcome(scenario);
    let text = run.terminal_text();
    let line = |name: &str| text.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
    assert!(line("energy").contains(", energy balance error "), "{text}");
    (line("closed form"), run.warnings)
}

#[test]
fn energy_balance_replaces_missing_closed_form() {
    let (line, _) = closed_form_and_warnings(&read(STEEL, &["law=jackson_green", "damping.viscous=0.1"]));
    assert!(line.ends_with("  none"), "{line}");
    // with an exponent of 1.4 near yield, unloading gives back no more than the work of loading, also without closed
    // form
    let soft = ["law.plm.unloading_exponent=1.4", "damping.hunt_crossley=1e-6", "impact.drop_height=6 um"];
    let (line, warnings) =
        closed_form_and_warnings(&read(STEEL, &[&soft[..], &["gravity.acceleration=9.81"]].concat()));
    assert!(line.ends_with("  none"), "{line}");
    assert!(
        matches!(&warnings[..], [warning] if warning.contains("the unloading exponent was raised from 1.4")),
        "{warnings:?}"
    );
}
