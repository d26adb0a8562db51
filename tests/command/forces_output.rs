//! Output of impacts under gravity and damping, and of their tables.

use plm_impact::impact::{Method, Solver};
use plm_impact::plot::Pictures;
use plm_impact::progress::Counter;
use plm_impact::run::{Order, Outcome, Run, impact, way};
use plm_impact::scenario::{Kind, Scenario};
use plm_impact::sweep::evaluator::{Evaluator, Rows};
use serde_json::Value;

use crate::common::STEEL;

/// The steel sphere falls from 0.5 m.
fn drop() -> String {
    STEEL.replace("speed = \"3 m/s\"", "drop_height = \"0.5 m\"") + "\n[gravity]\nacceleration = \"9.81 m/s^2\"\n"
}

fn scenario(more: &str, overrides: &[&str]) -> Scenario {
    let overrides: Vec<String> = overrides.iter().map(ToString::to_string).collect();
    Scenario::from_text("drop.toml", &(drop() + more), &overrides).unwrap()
}

/// Runs one impact.
fn run(scenario: &Scenario) -> Outcome {
    let Run::Once { run, .. } = way(Kind::Impact).run else { panic!("one impact is no table") };
    run(scenario, &Order { command: "test", pictures: Pictures::None, progress: &Counter::default() }).unwrap()
}

/// `summary.json` and the header of `trace.csv`.
fn output(scenario: &Scenario) -> (Value, String) {
    let run = run(scenario);
    let bytes = |name: &str| run.files.iter().find(|file| file.name == name).unwrap().bytes.clone();
    let trace = String::from_utf8(bytes("trace.csv")).unwrap();
    (serde_json::from_slice(&bytes("summary.json")).unwrap(), trace.lines().next().unwrap().to_owned())
}

#[test]
fn keys_and_columns_are_there_only_where_the_scene_names_their_cause() {
    let keys = ["/outcome", "/energy/gravity_work_J", "/energy/damping_J", "/static_indentation_m"];
    let present = |summary: &Value| keys.map(|key| summary.pointer(key).is_some());
    let plain = Scenario::from_text("plain.toml", STEEL, &[]).unwrap();
    let (summary, header) = output(&plain);
    assert_eq!(present(&summary), [false; 4]);
    assert!(!header.contains("elastic_force"));

    let (summary, header) = output(&scenario("", &[]));
    assert_eq!(present(&summary), [true, true, false, false]);
    assert_eq!(summary["outcome"], "separated");
    assert_eq!(summary["inputs"]["gravity_acceleration_m_per_s2"], 9.81);
    assert!(!header.contains("elastic_force"));
    assert!(summary["accuracy"]["restitution_error"].as_f64().unwrap() < 1e-9);

    let (summary, header) = output(&scenario("[damping]\nviscous = 0.1\n", &[]));
    assert_eq!(present(&summary), [true, true, true, false]);
    assert!(header.contains("force_N,elastic_force_N,branch"));
    assert!(summary["accuracy"]["restitution_error"].is_null(), "no closed form");
    // ½ m v² + m g δ = recovered + plastic + damping at separation
    let energy = |key: &str| summary["energy"][key].as_f64().unwrap();
    let put_in = energy("kinetic_in_J") + energy("gravity_work_J");
    let gone = energy("recovered_J") + energy("plastic_J") + energy("damping_J") + energy("stored_at_separation_J");
    // at separation the force of the law alone is not zero, and elastic energy is left: (2/5) F (δ − δ_r) on the branch
    // of exponent 3/2
    let (_, _, impact) = impact::compute(&scenario("[damping]\nviscous = 0.1\n", &[]), Some(400)).unwrap();
    let last = impact.trace.last().unwrap();
    let held = 0.4 * last.elastic_force.unwrap() * (last.indentation - impact.residual_indentation);
    assert!(held > 0.0 && (energy("stored_at_separation_J") / held - 1.0).abs() < 1e-9, "{held}");
    assert!((gone / put_in - 1.0).abs() < 1e-9, "{gone} {put_in}");
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
    let run = run(scenario);
    let line = |name: &str| run.text.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
    assert!(line("energy").contains(", drift "), "{}", run.text);
    (line("closed form"), run.warnings)
}

#[test]
fn without_a_closed_form_the_energy_ledger_stands_in_for_it() {
    // a law whose curves are not powers has no closed form under gravity
    let (line, _) = closed_form_and_warnings(&scenario("[law.jackson_green]\n", &[]));
    assert!(line.ends_with("  none"), "{line}");
    // with an exponent of 1.2 near yield, unloading gives back no more than the work of loading, also without closed
    // form
    let soft = "[law.plm]\nunloading_exponent = 1.2\n[damping]\nhunt_crossley = 1e-6\n";
    let (line, warnings) = closed_form_and_warnings(&scenario(soft, &["impact.drop_height=10 um"]));
    assert!(line.ends_with("  none"), "{line}");
    assert!(warnings.is_empty(), "{warnings:?}");
}

#[test]
fn a_range_without_an_upper_end_is_told_so() {
    let text = STEEL.replace("3 m/s", "1 m/s") + "[law.mesarovic_johnson]\n";
    let (_, warnings) = closed_form_and_warnings(&Scenario::from_text("s.toml", &text, &[]).unwrap());
    assert!(warnings.iter().any(|warning| warning.contains("and more, the range that the law")), "{warnings:?}");
}

#[test]
fn rows_of_a_table_are_the_single_impacts() {
    let sweep = "[damping]\nviscous = 0.1\n[sweep]\n\"impact.drop_height\" = [0, 1e-9, 0.5]\n\"damping.viscous\" = [0, 0.1]\n\
                 \"gravity.acceleration\" = [9.81, 1e5]\n";
    for method in [Method::Auto, Method::Rk8] {
        let overrides = if method == Method::Rk8 { &["solver.method=rk8"][..] } else { &[] };
        let plan = scenario(sweep, overrides).plan().unwrap().unwrap();
        let mut rows = Rows::default();
        Evaluator::new(&plan).rows(0..12, &mut rows);
        for (case, got) in rows.results.iter().map(|row| row.unwrap()).enumerate() {
            let [height, zeta, g] = [[0.0, 1e-9, 0.5][case / 4], [0.0, 0.1][case / 2 % 2], [9.81, 1e5][case % 2]];
            let set = [format!("impact.drop_height={height}"), format!("gravity.acceleration={g}")];
            let one = scenario(&format!("[damping]\nviscous = {zeta}\n"), &[&set[0], &set[1]]);
            let scene = one.resolve().unwrap();
            let solver = Solver { method, ..scene.solver };
            let want = scene.contact().unwrap().impact(scene.speed, &solver, None).unwrap().essentials;
            assert_eq!((got.restitution, got.contact_time), (want.restitution, want.contact_time));
            assert_eq!((got.peak_force, got.residual_indentation), (want.peak_force, want.residual_indentation));
        }
    }
}

#[test]
fn a_table_by_a_closed_form_that_is_one_is_accepted() {
    let table = "[solver]\nmethod = \"closed_form\"\n[sweep]\n\"impact.speed\" = [1, 3]\n";
    for forces in ["[damping]\nhunt_crossley = \"0.1 s/m\"\n", "[gravity]\nacceleration = 9.81\n"] {
        let text = format!("{STEEL}{forces}{table}");
        assert!(Scenario::from_text("table.toml", &text, &[]).unwrap().plan().unwrap().is_some(), "{forces}");
    }
}
