//! Warnings are the same everywhere: terminal, `summary.json`, `check`, `--strict`.

use crate::common::prelude::*;

const RUN: [&str; 7] = ["run", "s.toml", "--out", "out", "--pictures", "none", "--strict"];
const NO_STRENGTH: &str = "yield_strength = \"345 MPa\"\n";

/// The lines of standard error that begin with `warning: `, without this word.
fn warned(stderr: &str) -> Vec<String> {
    stderr.lines().filter_map(|line| line.strip_prefix("warning: ")).map(str::to_owned).collect()
}

/// Scenarios of every kind that can have warnings, each with a warning.
fn scenarios_with_warnings() -> Vec<(&'static str, String)> {
    let fast = STEEL.replace("3 m/s", "60 m/s");
    let elastic = STEEL.replace(NO_STRENGTH, "");
    let law = "[law.plm]\nunloading_exponent = 1.6\n";
    let still = |scene: &str| scene.replace("[impact]\nspeed = \"3 m/s\"\n", "");
    let slow = still(&elastic).replace("density = \"7850 kg/m^3\"\n", "");
    let dense = STEEL
        .replace("[sphere]\n", "[sphere]\nyield_strength = 1e10\n")
        .replace(NO_STRENGTH, "yield_strength = 3e8\ndensity = 7850\n");
    let idle = "law.plm.unloading_exponent has no effect";
    vec![
        ("Contact radius / sphere radius", fast.clone()),
        (idle, format!("{elastic}{law}")),
        ("impact.speed = 60 m/s", format!("{STEEL}[sweep]\n\"impact.speed\" = [1, 60]\n")),
        (idle, format!("{elastic}{law}[sweep]\n\"impact.speed\" = [1, 2]\n")),
        ("exceeds 0.55", format!("{STEEL}[monte_carlo]\nsamples = 3\n\"impact.speed\" = {{ uniform = [50, 70] }}\n")),
        ("impact 1: Force, dent and e", format!("{fast}[repeat]\nimpacts = 2\nspot = \"fresh\"\n")),
        (idle, format!("{elastic}{law}[repeat]\nimpacts = 2\nspot = \"same\"\n")),
        (idle, format!("{slow}{law}[indentation]\nsteps = [{{ load = 100 }}]\n")),
        ("density", format!("{}[indentation]\nsteps = [{{ load = 100 }}]\n", still(&dense))),
        (
            "step 1: Force, dent and e",
            format!(
                "{}[indentation]\nsteps = [{{ indentation = \"1 mm\" }}]\n",
                slow.replace("[half_space]\n", "[half_space]\nyield_strength = 345e6\n")
            ),
        ),
    ]
}

#[test]
fn warnings_are_equal_everywhere_and_strict_fails() {
    for (words, scene) in scenarios_with_warnings() {
        let desk = Sandbox::with(scene);
        let strict = desk.run_expecting(&RUN, 1);
        assert!(strict.0.is_empty() && strict.1.contains("--strict") && desk.files("") == ["s.toml"], "{strict:?}");
        let said = warned(&desk.run_expecting(&RUN[..6], 0).1);
        assert!(said.iter().any(|line| line.contains(words)), "{words}: {said:?}");
        assert_eq!(desk.summary()["warnings"], json!(said), "{words}: summary.json");
        assert_eq!(warned(&desk.run_expecting(&["check", "s.toml"], 0).1), said, "{words}: check");
    }
}
