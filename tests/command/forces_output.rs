//! Output of impacts under gravity and damping.

use crate::common::prelude::*;

/// The steel sphere falls from 0.5 m.
fn drop() -> String {
    STEEL.replace("speed = \"3 m/s\"", "drop_height = \"0.5 m\"") + "\n[gravity]\nacceleration = \"9.81 m/s^2\"\n"
}

fn scenario(more: &str, overrides: &[&str]) -> Scenario {
    read(&(drop() + more), overrides)
}

/// `summary.json` and the header of `trace.csv`.
fn output(scenario: &Scenario) -> (Value, String) {
    let run = outcome(scenario);
    let header = file_of(&run, "trace.csv").lines().next().unwrap().to_owned();
    (serde_json::from_str(&file_of(&run, "summary.json")).unwrap(), header)
}

/// The numbers are in tests/same_numbers, and their balance in tests/physics.
#[test]
fn keys_and_columns_are_there_only_where_the_scene_names_their_cause() {
    let keys = ["/outcome", "/energy/gravity_work_J", "/energy/damping_J", "/static_indentation_m"];
    let plain = read(STEEL, NONE);
    for (scenario, present, has_closed_form) in [
        (plain, [false; 4], true),
        (scenario("", &[]), [true, true, false, false], true),
        (scenario("[damping]\nviscous = 0.1\n", &[]), [true, true, true, false], false),
    ] {
        let (summary, header) = output(&scenario);
        assert_eq!(keys.map(|key| summary.pointer(key).is_some()), present, "{summary}");
        assert_eq!(header.contains("force_N,elastic_force_N,branch"), present[2], "{header}");
        assert_eq!(summary["accuracy"]["restitution_error"].is_number(), has_closed_form, "{summary}");
    }
    // at separation the force of the law alone is not zero, and elastic energy is left: (2/5) F (δ − δ_r) on the branch
    // of exponent 3/2
    let (_, _, impact) = run::impact::compute(&scenario("[damping]\nviscous = 0.1\n", &[]), Some(400)).unwrap();
    let last = impact.trace.last().unwrap();
    let held = 0.4 * last.elastic_force.unwrap() * (last.indentation - impact.residual_indentation);
    let stored = impact.under_forces.unwrap().stored_at_separation.unwrap();
    assert!(held > 0.0 && (stored / held - 1.0).abs() < 1e-9, "{held}");
}

#[test]
fn a_captured_sphere_has_no_contact_time_and_one_at_rest_no_restitution() {
    let (summary, _) = output(&scenario("", &["impact.drop_height=0"]));
    assert_eq!(summary["outcome"], "captured");
    assert!(summary["contact_time_s"].is_null() && summary["restitution"].is_null());
    assert!(summary["static_indentation_m"].as_f64().unwrap() > 0.0);
    let (summary, _) = output(&scenario("[damping]\nviscous = 0.5\n", &["impact.drop_height=1 nm"]));
    assert_eq!((&summary["outcome"], &summary["restitution"]), (&"captured".into(), &0.0.into()));
}

/// The line on the closed form in the table of an impact, and the warnings. The line on energy always has its drift.
fn closed_form_and_warnings(scenario: &Scenario) -> (String, Vec<String>) {
    let run = outcome(scenario);
    let line = |name: &str| run.text.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
    assert!(line("energy").contains(", drift "), "{}", run.text);
    (line("closed form"), run.warnings)
}

#[test]
fn without_a_closed_form_the_energy_ledger_stands_in_for_it() {
    let (line, _) = closed_form_and_warnings(&scenario("[law.jackson_green]\n[damping]\nviscous = 0.1\n", &[]));
    assert!(line.ends_with("  none"), "{line}");
    // with an exponent of 1.4 near yield, unloading gives back no more than the work of loading, also without closed
    // form
    let soft = "[law.plm]\nunloading_exponent = 1.4\n[damping]\nhunt_crossley = 1e-6\n";
    let (line, warnings) = closed_form_and_warnings(&scenario(soft, &["impact.drop_height=6 um"]));
    assert!(line.ends_with("  none"), "{line}");
    assert!(matches!(&warnings[..], [warning] if warning.contains("an unloading exponent of 1.4")), "{warnings:?}");
}
