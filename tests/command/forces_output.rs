//! Output of impacts under gravity and damping. Which keys are there is in `holds.toml`.

use crate::common::prelude::*;

/// The steel sphere falls from 0.5 m.
fn drop() -> String {
    STEEL.replace("speed = \"3 m/s\"", "drop_height = \"0.5 m\"") + "\n[gravity]\nacceleration = \"9.81 m/s^2\"\n"
}

fn scenario(more: &str, overrides: &[&str]) -> Scenario {
    read(&(drop() + more), overrides)
}

/// At separation the force of the law alone is not zero, and elastic energy is left: (2/5) F (δ − δ_r) on the branch of
/// exponent 3/2.
#[test]
fn a_damped_sphere_leaves_with_elastic_energy_in_the_contact() {
    let (_, _, impact) = run::impact::compute(&scenario("[damping]\nviscous = 0.1\n", &[]), Some(400)).unwrap();
    let last = impact.trace.last().unwrap();
    let held = 0.4 * last.elastic_force.unwrap() * (last.indentation - impact.residual_indentation);
    let stored = impact.under_forces.unwrap().stored_at_separation.unwrap();
    assert!(held > 0.0 && (stored / held - 1.0).abs() < 1e-9, "{held}");
}

/// The line on the closed form in the table of an impact, and the warnings. The line on energy always says how far the balance is off.
fn closed_form_and_warnings(scenario: &Scenario) -> (String, Vec<String>) {
    let run = outcome(scenario);
    let line = |name: &str| run.text.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
    assert!(line("energy").contains(", balance off by "), "{}", run.text);
    (line("closed form"), run.warnings)
}

#[test]
fn without_a_closed_form_the_balance_of_energy_stands_in_for_it() {
    let (line, _) = closed_form_and_warnings(&scenario("[law.jackson_green]\n[damping]\nviscous = 0.1\n", &[]));
    assert!(line.ends_with("  none"), "{line}");
    // with an exponent of 1.4 near yield, unloading gives back no more than the work of loading, also without closed
    // form
    let soft = "[law.plm]\nunloading_exponent = 1.4\n[damping]\nhunt_crossley = 1e-6\n";
    let (line, warnings) = closed_form_and_warnings(&scenario(soft, &["impact.drop_height=6 um"]));
    assert!(line.ends_with("  none"), "{line}");
    assert!(matches!(&warnings[..], [warning] if warning.contains("an unloading exponent of 1.4")), "{warnings:?}");
}
