//! `[indentation]` as a process: what the terminal shows, and what is not written.

use plm_impact::units::format_four_digits;

use crate::common::prelude::*;

const CYCLES: &str = include_str!("../../../scenarios/indentation-cycles.toml");
const ALLOYS: &str = include_str!("../../../scenarios/indentation-ti-nb.toml");

#[test]
fn several_half_spaces_have_separate_names() {
    let desk = Sandbox::with(ALLOYS);
    let (table, _) = desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
    for half_space in desk.summary()["half_spaces"].as_array().unwrap() {
        let step = &half_space["steps"][0];
        // the terminal shows the same in µm, with four digits
        let shown = format!("{} µm", format_four_digits(1e6 * step["residual_indentation_m"].as_f64().unwrap()));
        let name = half_space["name"].as_str().unwrap();
        assert!(table.contains(name) && table.contains(&shown), "{name}: {shown} not in\n{table}");
    }
    let trace = desk.read("out/trace.csv");
    assert!(trace.starts_with("half_space,step,indentation_m,") && trace.contains("\nTi-70Nb,2,"), "{}", &trace[..200]);
}

/// The values of an instrument with a diamond tip on fused silica, which stays elastic: 1/E* = (1 − 0.07²)/1141 GPa +
/// (1 − 0.17²)/72.5 GPa by hand, with the numbers of the two materials; S = 2 E* a; H = F/(π a²).
#[test]
fn a_nanoindentation_has_stiffness_modulus_and_hardness() {
    let text = "[sphere]\nmaterial = \"diamond\"\nradius = \"10 um\"\n[half_space]\nmaterial = \"silica-fused\"\n\
        [indentation]\nsteps = [{ load = \"50 mN\" }, { load = 0 }]\n";
    let desk = Sandbox::with(text);
    let (table, said) = desk.run_expecting(&["run", "s.toml", "--out", "out", "--pictures", "none"], 0);
    assert!(said.contains("silica-fused cracks"), "{said}");
    let half_space = &desk.summary()["half_spaces"][0];
    let step = &half_space["steps"][1];
    let of = |name: &str| step[name].as_f64().unwrap();
    let modulus = 1.0 / ((1.0 - 0.07 * 0.07) / 1141e9 + (1.0 - 0.17 * 0.17) / 72.5e9);
    let radius = of("peak_contact_radius_m");
    assert!(relative_error(half_space["effective_modulus_Pa"].as_f64().unwrap(), modulus) < 1e-12);
    assert!(relative_error(of("unloading_stiffness_N_per_m"), 2.0 * modulus * radius) < 1e-12);
    assert!(relative_error(of("peak_mean_pressure_Pa"), 0.05 / (std::f64::consts::PI * radius * radius)) < 1e-12);
    assert!(table.contains("hardness F/A"), "{table}");
    // with a hardness it has a dent
    let hard = Sandbox::with_results(
        text.replace("silica-fused\"\n", "silica-fused\"\nhardness = \"7 GPa\"\n").replace("50 mN", "300 mN"),
    );
    assert!(hard.summary()["half_spaces"][0]["steps"][1]["residual_indentation_m"].as_f64().unwrap() > 1e-8);
}

#[test]
fn densities_are_not_needed_and_do_no_harm() {
    let dense = CYCLES
        .replace("poissons_ratio = 0.23", "poissons_ratio = 0.23\ndensity = 15600")
        .replace("poissons_ratio = 0.3\n", "poissons_ratio = 0.3\ndensity = 4500\n");
    let [plain, dense] = [CYCLES.to_owned(), dense].map(|text| Sandbox::with_results(text).summary());
    assert_eq!(plain["half_spaces"], dense["half_spaces"]);
}
