//! Warnings are the same everywhere: terminal, `summary.json`, `check`, `--strict`.

use serde_json::Value;

use crate::common::STEEL;
use crate::common::command::{Desk, text};

const RUN: [&str; 5] = ["run", "s.toml", "--strict", "--out", "out"];
const NO_STRENGTH: &str = "yield_strength = \"345 MPa\"\n";

fn summary(desk: &Desk) -> Value {
    serde_json::from_str(&desk.read("out/summary.json")).unwrap()
}

/// The lines of standard error that begin with `warning: `, without this word.
fn warned(stderr: &[u8]) -> Vec<String> {
    text(stderr).lines().filter_map(|line| line.strip_prefix("warning: ")).map(str::to_owned).collect()
}

#[test]
fn a_key_of_the_law_is_used_where_only_the_axis_gives_a_yield_strength() {
    let soft = STEEL.replace(NO_STRENGTH, "");
    let law = "[law.plm]\nunloading_exponent = 1.6\n";
    for axis in [
        "[sweep]\n\"half_space.yield_strength\" = [\"300 MPa\", \"400 MPa\"]\n",
        "[monte_carlo]\nsamples = 5\n\"half_space.yield_strength\" = { uniform = [3e8, 4e8] }\n",
    ] {
        let desk = Desk::with(format!("{soft}{law}{axis}"));
        let output = desk.call(&RUN);
        assert_eq!(output.status.code(), Some(0), "{axis}: {}", text(&output.stderr));
        assert!(warned(&output.stderr).is_empty(), "{}", text(&output.stderr));
    }
    // without any yield strength the key has no effect, and every place says so
    let desk = Desk::with(format!("{soft}{law}[sweep]\n\"impact.speed\" = [1, 2]\n"));
    let output = desk.call(&RUN);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("law.plm.unloading_exponent is not used"), "{}", text(&output.stderr));
}

#[test]
fn the_table_of_a_law_that_no_case_is_under_is_named() {
    let sweep = |laws: &str| format!("{STEEL}[law.thornton]\nyield_pressure = 6e8\n[sweep]\nlaw = [{laws}]\n");
    let output = Desk::with(sweep("\"hertz\", \"johnson\"")).call(&RUN);
    let warnings = warned(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{warnings:?}");
    assert!(warnings[0].starts_with("law.thornton is not used: no case is under that law"), "{warnings:?}");
    assert_eq!(Desk::with(sweep("\"hertz\", \"thornton\"")).call(&RUN).status.code(), Some(0));
}

/// Scenarios of every kind that can have warnings, each with a warning.
fn doubtful() -> Vec<(&'static str, String)> {
    let fast = STEEL.replace("3 m/s", "60 m/s");
    let elastic = STEEL.replace(NO_STRENGTH, "");
    let law = "[law.plm]\nunloading_exponent = 1.6\n";
    let still = |scene: &str| scene.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let slow = still(&elastic).replace("density = \"7850 kg/m^3\"\n", "");
    let dense = STEEL
        .replace("[sphere]\n", "[sphere]\nyield_strength = 1e10\n")
        .replace(NO_STRENGTH, "yield_strength = 3e8\ndensity = 7850\n");
    vec![
        ("impact", fast.clone()),
        ("impact, key", format!("{elastic}{law}")),
        ("sweep", format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 60]\n")),
        ("sweep, key", format!("{elastic}{law}[sweep]\n\"impact.speed\" = [1, 2]\n")),
        ("monte_carlo", format!("{STEEL}[monte_carlo]\nsamples = 3\n\"impact.speed\" = {{ uniform = [50, 70] }}\n")),
        ("repeat", format!("{fast}[repeat]\nimpacts = 2\nspot = \"fresh\"\n")),
        ("repeat, key", format!("{elastic}{law}[repeat]\nimpacts = 2\nspot = \"same\"\n")),
        ("indentation, key", format!("{slow}{law}[indentation]\nsteps = [{{ load = 100 }}]\n")),
        ("compare", format!("{}[compare]\npeak_indentation_ratio = 50\n", still(&dense))),
        ("indentation, density", format!("{}[indentation]\nsteps = [{{ load = 100 }}]\n", still(&dense))),
        (
            "indentation",
            format!(
                "{}[indentation]\nsteps = [{{ indentation = \"1 mm\" }}]\n",
                slow.replace("[half_space]\n", "[half_space]\nyield_strength = 345e6\n")
            ),
        ),
    ]
}

#[test]
fn terminal_summary_and_check_give_the_same_warnings() {
    for (name, scene) in doubtful() {
        let desk = Desk::with(scene);
        let run = desk.call(&["run", "s.toml", "--out", "out"]);
        let said = warned(&run.stderr);
        assert!(run.status.success() && !said.is_empty(), "{name}: {}", text(&run.stderr));
        let written: Vec<String> = serde_json::from_value(summary(&desk)["warnings"].clone()).unwrap();
        assert_eq!(written, said, "{name}: summary.json");
        let check = desk.call(&["check", "s.toml"]);
        assert!(check.status.success(), "{name}: {}", text(&check.stderr));
        assert_eq!(warned(&check.stderr), said, "{name}: check");
    }
}

#[test]
fn tables_and_keys_that_a_kind_of_scene_has_no_use_for_are_refused_by_name() {
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let massless = still.replace("density = \"7850 kg/m^3\"\n", "");
    let compare = "[compare]\npeak_indentation_ratio = 50\n";
    let press = "[indentation]\nsteps = [{ load = 100 }]\n";
    for kind in [compare, press] {
        let good = Desk::with(format!("{massless}{kind}"));
        for command in ["check", "run"] {
            assert_eq!(good.call(&[command, "s.toml"]).status.code(), Some(0), "{command} {kind}");
        }
        for (set, named) in [
            ("solver.method=dopri5", "solver"),
            ("solver.tolerance=1e-6", "solver"),
            ("gravity.acceleration=9.81", "gravity"),
            ("impact.speed=3", "impact"),
        ] {
            for command in ["check", "run"] {
                let output = good.call(&[command, "s.toml", "--set", set]);
                let said = text(&output.stderr);
                assert_eq!(output.status.code(), Some(2), "{command} {kind} {set}: {said}");
                assert!(said.contains(&format!("--set {set}: {named}: ")), "{said}");
            }
        }
    }
    let compared = Desk::with(format!("{massless}{compare}"));
    for set in ["output.samples=50", "output.columns=[\"peak_force_N\"]"] {
        let output = compared.call(&["check", "s.toml", "--set", set]);
        assert_eq!(output.status.code(), Some(2), "{set}");
        assert!(text(&output.stderr).contains("output: [compare] is given too"), "{}", text(&output.stderr));
    }
}

#[test]
fn numbers_that_hardly_any_body_has_are_doubted() {
    // a radius that was meant in mm, a density in g/cm^3, a strength in MPa
    let slips = [
        ("sphere.radius=5", "sphere.radius = 5 m is above 1 m"),
        ("sphere.density=7.85", "sphere.density = 7.85 kg/m^3 is below 100 kg/m^3"),
        ("half_space.density=7.85", "half_space.density = 7.85 kg/m^3 is below 100 kg/m^3"),
        (
            "half_space.yield_strength=345 GPa",
            "half_space.yield_strength = 345 GPa is more than a tenth of Young's modulus, 210 GPa",
        ),
        (
            "sphere.yield_strength=22 GPa",
            "sphere.yield_strength = 22 GPa is more than a tenth of Young's modulus, 210 GPa",
        ),
    ];
    let still = STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "").replace("density = \"7850 kg/m^3\"\n", "");
    let kinds = [
        ("impact", STEEL.to_owned()),
        ("sweep", format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 2]\n")),
        ("repeat", format!("{STEEL}[repeat]\nimpacts = 2\nspot = \"fresh\"\n")),
        ("indentation", format!("{still}[indentation]\nsteps = [{{ indentation = \"1 um\" }}]\n")),
    ];
    for (kind, scene) in kinds {
        let desk = Desk::with(scene);
        // slow indentations take no density, and the impacts of a series no waves
        let has_key = |set: &str| match kind {
            "indentation" => !set.contains("density"),
            "repeat" => !set.contains("half_space.density"),
            _ => true,
        };
        for (set, doubt) in slips.iter().filter(|(set, _)| has_key(set)) {
            for command in ["check", "run"] {
                let said = warned(&desk.call(&[command, "s.toml", "--set", set]).stderr);
                assert!(said.iter().any(|line| line.contains(doubt)), "{command} {kind} {set}: {said:?}");
            }
            let strict = desk.call(&[&RUN[..], &["--set", set]].concat());
            assert_eq!(strict.status.code(), Some(1), "{kind} {set}");
        }
        // the largest, the strongest and the lightest that are not doubted
        for set in ["half_space.yield_strength=21 GPa", "sphere.radius=1", "sphere.density=100"]
            .iter()
            .filter(|set| has_key(set))
        {
            let said = warned(&desk.call(&["check", "s.toml", "--set", set]).stderr).concat();
            assert!(!said.contains("check the unit"), "{kind} {set}: {said}");
        }
    }
}
