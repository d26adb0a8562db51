//! Tables that are refused, and the messages.

use std::process::Command;

use plm_impact::scenario::Scenario;

use super::{refusal, rows};
use crate::common::STEEL;

#[test]
fn bad_axes_are_refused_with_axis_value_and_way_out() {
    let says = |tables: &str, wanted: &[&str]| {
        let text = refusal(tables);
        for want in wanted {
            assert!(text.contains(want), "{tables}\nshould say {want:?}:\n{text}");
        }
    };
    let speed = |axis: &str| format!("[sweep]\n\"impact.speed\" = {axis}\n");
    says("[sweep]\nlaw = [\"plm\", \"hertz\", \"plm\"]\n", &["toml:15:7: sweep.law", "\"plm\" is there twice"]);
    says("[sweep]\n\"solver.method\" = [\"rk8\", \"rk8\"]\n", &["\"rk8\" is there twice"]);
    says(&speed("{ linspace = [1, 2], points = 0 }"), &["points = 0", "at least one"]);
    says(&speed("[]"), &["at least one"]);
    says(&speed("{ linspace = [1, 2], points = -3 }"), &["-3 is not allowed: a number of values must be >= 1"]);
    says(
        &speed("{ linspace = [1, 2], points = \"ten\" }"),
        &["\"ten\" does not begin with a number", "a number of values such as 11"],
    );
    says(&speed("{ logspace = [0, 1], points = 3 }"), &["impact.speed", "> 0"]);
    says(
        "[sweep]\n\"half_space.poissons_ratio\" = { logspace = [-0.1, 0.3], points = 3 }\n",
        &["logspace cannot reach or pass zero", "linspace"],
    );
    says(&speed("{ logspace = [1], points = 3 }"), &["two ends"]);
    says(&speed("[1, \"-3 m/s\"]"), &["impact.speed", "-3 m/s", "> 0"]);
    says(&speed("[\"3 kg\"]"), &["impact.speed", "kg"]);
    // the key is in line 15, and the message points to it, not to its table
    says("[sweep]\n\"impact.sped\" = [1]\n", &["toml:15:1: sweep.impact.sped", "did you mean \"impact.speed\""]);
    says("[sweep]\nlaw = [\"plm\", \"plmm\"]\n", &["toml:15:15: sweep.law", "did you mean \"plm\""]);
    says(
        "[sweep]\n\"law.thornton.yield_pressure\" = [1e9]\n",
        &["toml:15:33: sweep.law.thornton", "no case is under that law"],
    );
    says("[sweep]\n\"impact.drop_height\" = [1]\n", &["toml:15:", "stands in place of impact.speed"]);
    says("[sweep]\n\"law.plm.unloading_exponent\" = [\"steep\"]\n", &["an unloading exponent such as 1.5"]);
    says("[sweep]\nimpact.speed = [1]\n", &["in quotes", "\"impact.speed\""]);
    says("[sweep]\n\"law.plm.coefficients\" = [1]\n", &["no numeric key"]);
    says("[sweep]\n\"solver.method\" = [\"dop835\"]\n", &["dop835", "did you mean \"dop853\""]);
    says("[sweep]\n\"solver.tolerance\" = [1e-6, 1e-9]\n", &["solver.tolerance", "not used", "solver.method"]);
    says("[sweep]\n\"sphere.yield_strength\" = [1e9]\n", &["sphere.yield_strength", "not used"]);
    says("[sweep]\n\"sphere.radius\" = [0.1]\n\"sphere.diameter\" = [0.2]\n", &["stands in place of sphere.radius"]);
    says("[sweep]\n\"impact.speed\" = [1]\n\"impact.speed\" = [2]\n", &["duplicate"]);
    says("[sweep]\n", &["no axis"]);
    let long = "{ linspace = [1, 2], points = 4000000000 }";
    says(&format!("[sweep]\n\"impact.speed\" = {long}\n\"sphere.radius\" = {long}\n"), &["more than 2^63 cases"]);
    says(
        "[sweep]\n\"impact.speed\" = [1]\n[monte_carlo]\nsamples = 1\n\"sphere.radius\" = { uniform = [1, 2] }\n",
        &["only one"],
    );
    says("[monte_carlo]\n\"impact.speed\" = { uniform = [1, 2] }\n", &["samples"]);
    says("[monte_carlo]\nsamples = 3\n", &["no random key"]);
    let many = "[monte_carlo]\nsamples = 9999999999999999999\n\"impact.speed\" = { uniform = [1, 2] }\n";
    says(many, &["more than 2^63 cases"]);
    says("[monte_carlo]\nsamples = 3\n\"impact.speed\" = {}\n", &["has no distribution"]);
    says("[monte_carlo]\nsamples = 3\n\"impact.speed\" = { gauss = 1 }\n", &["gauss", "normal, lognormal, uniform"]);
    says(
        "[monte_carlo]\nsamples = 3\n\"impact.speed\" = { normal = { mean = 1, sd = 0 } }\n",
        &["0 m/s is not allowed: a standard deviation (sd) must be > 0 m/s and finite"],
    );
    says("[monte_carlo]\nsamples = 3\n\"impact.speed\" = { uniform = [2, 1] }\n", &["lower first"]);
}

#[test]
fn forces_on_an_axis_are_refused_beside_waves_as_they_are_in_their_own_tables() {
    let metal = STEEL.replace("yield_strength = \"345 MPa\"\n", "yield_strength = \"345 MPa\"\ndensity = 7850\n");
    let refused = |tables: &str| {
        let scenario = Scenario::from_text("test", &format!("{metal}{tables}"), &[]).unwrap();
        let text = scenario.plan().unwrap_err().to_string();
        assert!(text.contains("elastic waves are computed"), "{tables}: {text}");
    };
    refused("[damping]\nviscous = 0.1\n[sweep]\n\"impact.speed\" = [1]\n");
    for key in ["gravity.acceleration", "damping.viscous", "damping.hunt_crossley"] {
        refused(&format!("[sweep]\n\"{key}\" = [0.1, 0.2]\n"));
        refused(&format!("[monte_carlo]\nsamples = 2\n\"{key}\" = {{ uniform = [0.1, 0.2] }}\n"));
    }
}

#[test]
fn a_key_that_varies_need_not_stand_in_its_own_table_too() {
    let same = |without: &str, tables: &str| {
        assert!(STEEL.contains(without), "{without}");
        let gap = STEEL.replacen(without, "", 1);
        // the same scenario with the key also in its own table
        let (short, full) = (rows(&format!("{gap}{tables}")), rows(&format!("{STEEL}{tables}")));
        assert_eq!((short.swept, short.results), (full.swept, full.results), "{tables}");
    };
    same("[impact]\nspeed = \"3 m/s\"\n", "[sweep]\n\"impact.speed\" = [\"3 m/s\", 4]\n");
    same("speed = \"3 m/s\"\n", "[sweep]\n\"impact.speed\" = { logspace = [\"3 m/s\", 4], points = 3 }\n");
    same("radius = \"5 mm\"\n", "[sweep]\n\"sphere.diameter\" = { linspace = [0.01, 0.02], points = 3 }\n");
    same("density = \"7850 kg/m^3\"\n", "[monte_carlo]\nsamples = 5\n\"sphere.density\" = { uniform = [7e3, 8e3] }\n");
    let modulus =
        "[monte_carlo]\nsamples = 5\n\"sphere.youngs_modulus\" = { normal = { mean = \"200 GPa\", sd = 1e9 } }\n";
    same("youngs_modulus = \"210 GPa\"\n", modulus);
    let strength = "[sweep]\n\"half_space.yield_strength\" = [\"200 MPa\", \"300 MPa\"]\n";
    same("yield_strength = \"345 MPa\"\n", strength);
    // a drop height needs gravity, which may be an axis too
    let fall = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let axes = "[sweep]\n\"impact.drop_height\" = [0.5, 1]\n\"gravity.acceleration\" = [9.81, 1.62]\n";
    assert!(rows(&format!("{fall}{axes}")).results.iter().all(Result::is_ok));
    // a missing key that is on no axis is still refused
    let text = Scenario::from_text("test", &format!("{fall}{strength}"), &[]).unwrap().plan().unwrap_err().to_string();
    assert!(text.contains("[impact] is missing"), "{text}");
    let bad = format!("{fall}[sweep]\n\"impact.speed\" = [\"3 kg\"]\n");
    let text = Scenario::from_text("test", &bad, &[]).unwrap_err().to_string();
    assert!(text.contains("sweep.impact.speed: \"3 kg\" is a mass"), "{text}");
}

#[test]
fn strict_makes_a_table_beyond_the_model_an_error() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("scenario.toml");
    std::fs::write(&file, format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 200]\n")).unwrap();
    let out = directory.path().join("out");
    let program = env!("CARGO_BIN_EXE_plm-impact");
    let output = Command::new(program).arg("run").arg(&file).arg("--strict").arg("--out").arg(&out).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stderr).unwrap().contains("impact.speed = 200 m/s"));
    assert!(!out.exists());
}

#[test]
fn a_tolerance_can_vary_wherever_auto_integrates_under_gravity_and_only_there() {
    // a law whose branches are not powers has no closed form under gravity: its rows are integrated with the tolerance
    let table = "[gravity]\nacceleration = 9.81\n[sweep]\n\"solver.tolerance\" = [1e-3, 1e-9]\n";
    for (law, is_stepped) in [
        ("[law.stronge]\n", true),
        ("[law.jackson_green]\n", true),
        ("[law.yigit_christoforou]\n", true),
        ("[law.mesarovic_johnson]\n", true),
        ("[law.thornton]\n", false),
        ("", false),
    ] {
        let scenario = format!("{law}{table}");
        if is_stepped {
            let results = rows(&format!("{STEEL}{scenario}")).results;
            let e: Vec<f64> = results.iter().map(|row| row.as_ref().unwrap().restitution).collect();
            assert!(e.len() == 2 && e[0] != e[1] && (e[0] - e[1]).abs() < 1e-2, "{law}: {e:?}");
        } else {
            assert!(refusal(&scenario).contains("the closed form takes no steps"), "{law}");
        }
    }
    // it is enough that one law of an axis has no closed form
    let laws = table.to_owned() + "law = [\"plm\", \"stronge\"]\n";
    assert_eq!(rows(&format!("{STEEL}{laws}")).results.len(), 4);
}

#[test]
fn closed_form_says_what_it_cannot_do_of_the_scene_at_hand() {
    let scenario = "[gravity]\nacceleration = 9.81\n[law.stronge]\n[solver]\nmethod = \"closed_form\"\n";
    let text = refusal(scenario);
    for want in ["no trace", "power laws and straight lines", "\"auto\""] {
        assert!(text.contains(want), "{text}");
    }
}
