//! Warnings are the same everywhere: terminal, `summary.json`, `check`, `--strict`.

use crate::common::prelude::*;

const RUN: [&str; 7] = ["run", "s.toml", "--out", "out", "--pictures", "none", "--strict"];
const NO_STRENGTH: &str = "yield_strength = \"345 MPa\"\n";

/// The lines of standard error that begin with `warning: `, without this word.
fn warned(stderr: &str) -> Vec<String> {
    stderr.lines().filter_map(|line| line.strip_prefix("warning: ")).map(str::to_owned).collect()
}

#[test]
fn a_key_of_the_law_is_used_where_only_the_axis_gives_a_yield_strength() {
    let soft = STEEL.replace(NO_STRENGTH, "");
    let law = "[law.plm]\nunloading_exponent = 1.6\n";
    for axis in [
        "[sweep]\n\"half_space.yield_strength\" = [\"300 MPa\", \"400 MPa\"]\n",
        "[monte_carlo]\nsamples = 5\n\"half_space.yield_strength\" = { uniform = [3e8, 4e8] }\n",
    ] {
        assert!(warned(&Desk::with(format!("{soft}{law}{axis}")).ends(&RUN, 0).1).is_empty(), "{axis}");
    }
    // without any yield strength the key has no effect, and every place says so
    let (_, said) = Desk::with(format!("{soft}{law}[sweep]\n\"impact.speed\" = [1, 2]\n")).ends(&RUN, 1);
    assert!(said.contains("law.plm.unloading_exponent is not used"), "{said}");
}

#[test]
fn the_table_of_a_law_that_no_case_is_under_is_named() {
    let sweep = |laws: &str| format!("{STEEL}[law.thornton]\nyield_pressure = 6e8\n[sweep]\nlaw = [{laws}]\n");
    let warnings = warned(&Desk::with(sweep("\"hertz\", \"johnson\"")).ends(&RUN, 1).1);
    assert!(warnings[0].starts_with("law.thornton is not used: no case is under that law"), "{warnings:?}");
    Desk::with(sweep("\"hertz\", \"thornton\"")).ends(&RUN, 0);
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
    let idle = "law.plm.unloading_exponent is not used";
    vec![
        ("contact radius / sphere radius", fast.clone()),
        (idle, format!("{elastic}{law}")),
        ("impact.speed = 60 m/s", format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 60]\n")),
        (idle, format!("{elastic}{law}[sweep]\n\"impact.speed\" = [1, 2]\n")),
        ("is beyond 0.45", format!("{STEEL}[monte_carlo]\nsamples = 3\n\"impact.speed\" = {{ uniform = [50, 70] }}\n")),
        ("impact 1: contact radius", format!("{fast}[repeat]\nimpacts = 2\nspot = \"fresh\"\n")),
        (idle, format!("{elastic}{law}[repeat]\nimpacts = 2\nspot = \"same\"\n")),
        (idle, format!("{slow}{law}[indentation]\nsteps = [{{ load = 100 }}]\n")),
        ("density", format!("{}[compare]\npeak_indentation_ratio = 50\n", still(&dense))),
        ("density", format!("{}[indentation]\nsteps = [{{ load = 100 }}]\n", still(&dense))),
        (
            "step 1: contact radius / sphere radius",
            format!(
                "{}[indentation]\nsteps = [{{ indentation = \"1 mm\" }}]\n",
                slow.replace("[half_space]\n", "[half_space]\nyield_strength = 345e6\n")
            ),
        ),
    ]
}

#[test]
fn terminal_summary_and_check_give_the_same_warnings_and_strict_makes_them_errors() {
    for (words, scene) in doubtful() {
        let desk = Desk::with(scene);
        let strict = desk.ends(&RUN, 1);
        assert!(strict.0.is_empty() && strict.1.contains("--strict") && desk.files("") == ["s.toml"], "{strict:?}");
        let said = warned(&desk.ends(&RUN[..6], 0).1);
        assert!(said.iter().any(|line| line.contains(words)), "{words}: {said:?}");
        assert_eq!(desk.summary()["warnings"], json!(said), "{words}: summary.json");
        assert_eq!(warned(&desk.ends(&["check", "s.toml"], 0).1), said, "{words}: check");
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
        ("compare", format!("{still}[compare]\npeak_indentation_ratio = 50\n")),
    ];
    for (kind, scene) in kinds {
        let desk = Desk::with(scene);
        // without motion a density has no effect, in a comparison the strength of the sphere neither; the impacts of a series
        // radiate no waves, and the density of the half-space is refused beside them
        let has_key = |set: &str| match kind {
            "indentation" => !set.contains("density"),
            "compare" => !set.contains("density") && !set.contains("sphere.yield_strength"),
            "repeat" => !set.contains("half_space.density"),
            _ => true,
        };
        for (set, doubt) in slips.iter().filter(|(set, _)| has_key(set)) {
            let said = warned(&desk.ends(&["check", "s.toml", "--set", set], 0).1);
            assert!(said.iter().any(|line| line.contains(doubt)), "{kind} {set}: {said:?}");
        }
        // the largest, the strongest and the lightest that are not doubted
        for set in ["half_space.yield_strength=21 GPa", "sphere.radius=1", "sphere.density=100"]
            .iter()
            .filter(|set| has_key(set))
        {
            let (_, said) = desk.ends(&["check", "s.toml", "--set", set], 0);
            assert!(!said.contains("check the unit"), "{kind} {set}: {said}");
        }
    }
}
