//! `[indentation]` as a process: outputs, messages and exit codes. If the input is wrong, nothing is written.

use std::fs;

use plm_impact::units::four_digits;

use crate::common::command::{Desk, text};

const CYCLES: &str = include_str!("../../scenarios/indentation-cycles.toml");
const ALLOYS: &str = include_str!("../../scenarios/indentation-ti-nb.toml");

/// Runs the scenario and returns the standard output.
fn run(desk: &Desk) -> String {
    let output = desk.call(&["run", "s.toml", "--out", "out"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    text(&output.stdout)
}

fn summary(desk: &Desk) -> serde_json::Value {
    serde_json::from_str(&desk.read("out/summary.json")).unwrap()
}

#[test]
fn cycles_give_a_table_a_summary_a_trace_and_a_picture() {
    let desk = Desk::with(CYCLES);
    let table = run(&desk);
    assert!(table.starts_with("step  to") && table.lines().count() == 9, "{table}");
    let summary = summary(&desk);
    let half_space = &summary["half_spaces"][0];
    let steps = half_space["steps"].as_array().unwrap();
    assert_eq!(steps.len(), 8);
    let number = |step: usize, key: &str| steps[step][key].as_f64().unwrap();
    // the sphere is lifted off and pressed in again
    assert_eq!((number(5, "force_N"), number(5, "indentation_m")), (0.0, 2e-6));
    assert!(steps[5]["branch"] == "separated" && steps[6]["branch"] == "plastic" && steps[4]["branch"] == "reloading");
    assert_eq!(number(7, "indentation_m"), number(7, "residual_indentation_m"));
    let plastic: f64 = (0..8).map(|step| number(step, "plastic_work_J")).sum();
    assert!((half_space["plastic_work_J"].as_f64().unwrap() / plastic - 1.0).abs() < 1e-14);
    // unloaded at the end, so all work is plastic
    assert!((half_space["work_J"].as_f64().unwrap() / plastic - 1.0).abs() < 1e-12);
    assert_eq!(summary["provenance"]["law"], "plm");
    assert!(half_space.get("name").is_none());

    let trace = desk.read("out/trace.csv");
    let header = "step,indentation_m,sphere_indentation_m,half_space_indentation_m,force_N,branch";
    assert_eq!(trace.lines().next().unwrap(), header);
    // 400 rows for each step, and one more where branches meet: at two earlier peaks, at separation and at renewed
    // contact
    assert_eq!(trace.lines().count(), 1 + 8 * 400 + 4, "{}", trace.lines().count());
    let image = fs::read(desk.path("out/force_indentation.png")).unwrap();
    assert!(image.starts_with(b"\x89PNG"));
}

#[test]
fn several_half_spaces_are_told_apart_by_name() {
    let desk = Desk::with(ALLOYS);
    let table = run(&desk);
    for name in ["Ti-5Nb", "Ti-10Nb", "Ti-40Nb", "Ti-70Nb"] {
        assert!(table.contains(name), "{table}");
    }
    let summary = summary(&desk);
    let half_spaces = summary["half_spaces"].as_array().unwrap();
    assert_eq!(half_spaces.len(), 4);
    for half_space in half_spaces {
        let step = &half_space["steps"][0];
        let span = &step["uncertainty"]["residual_indentation_m"];
        let residual = step["residual_indentation_m"].as_f64().unwrap();
        let [low, high] = [0, 1].map(|end| span[end].as_f64().unwrap());
        assert!(low < residual && residual < high);
        // the terminal shows the same in µm, with four digits
        let digits = |length: f64| four_digits(1e6 * length);
        let shown = format!("{} µm ({} to {})", digits(residual), digits(low), digits(high));
        assert!(table.contains(&shown), "{shown} not in\n{table}");
    }
    let trace = desk.read("out/trace.csv");
    assert!(trace.starts_with("half_space,step,indentation_m,") && trace.contains("\nTi-70Nb,2,"), "{}", &trace[..200]);
    let checked = desk.call(&["check", "s.toml"]);
    let printed = text(&checked.stdout);
    for want in ["load 30 N", "± 12 GPa", "yield force F_Y", "Ti-40Nb"] {
        assert!(printed.contains(want), "{want}: {printed}");
    }
}

/// The same cycles with other laws: the dents follow from the published formulas of these laws.
#[test]
fn other_laws_leave_their_own_dents() {
    let under = |table: &str| Desk::with(CYCLES.replace("[law.plm]\nunloading_exponent = \"pressure-shape\"", table));
    let steps = |desk: &Desk| {
        run(desk);
        let summary = summary(desk);
        (summary["half_spaces"][0].clone(), summary["provenance"]["law"].as_str().unwrap().to_owned())
    };
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let (radius, strength) = (0.25e-3_f64, 630e6);
    let pi = std::f64::consts::PI;

    let (half_space, law) = steps(&under("[law.thornton]"));
    assert_eq!(law, "thornton");
    let modulus = number(&half_space["effective_modulus_Pa"]);
    // R_p = (4E*/(3 F_m)) ((2 F_m + F_y)/(2π p_y))^1.5, δ_m − δ_r = (3 F_m/(4 E* √R_p))^(2/3), p_y from F_y = π³ R²
    // p_y³/(6 E*²)
    let yield_force = number(&half_space["yield_force_N"]);
    let pressure = (6.0 * modulus * modulus * yield_force / (pi.powi(3) * radius * radius)).cbrt();
    for step in half_space["steps"].as_array().unwrap() {
        let force = number(&step["peak_force_N"]);
        let of_unloading =
            4.0 * modulus / (3.0 * force) * ((2.0 * force + yield_force) / (2.0 * pi * pressure)).powf(1.5);
        let recovered = (3.0 * force / (4.0 * modulus * of_unloading.sqrt())).powf(2.0 / 3.0);
        let dent = number(&step["peak_indentation_m"]) - recovered;
        assert!((number(&step["residual_indentation_m"]) / dent - 1.0).abs() < 1e-10, "{step}");
    }

    let (half_space, law) = steps(&under("[law.jackson_green]"));
    assert_eq!(law, "jackson_green");
    // δ_r/δ_m = 1.02 (1 − ((x + 5.9)/6.9)^−0.54), x = δ_m over R (π C σ_Y/(2 E*))², C = 1.295 exp(0.736 ν)
    let yields = radius * (pi * 1.295 * (0.736_f64 * 0.3).exp() * strength / (2.0 * modulus)).powi(2);
    for step in half_space["steps"].as_array().unwrap() {
        let depth = number(&step["peak_indentation_m"]);
        let share = 1.02 * (1.0 - ((depth / yields + 5.9) / 6.9).powf(-0.54));
        assert!((number(&step["residual_indentation_m"]) / (share * depth) - 1.0).abs() < 1e-10, "{step}");
    }

    // an elastic law has no dent, so none is written
    let (half_space, law) = steps(&under("[law.hertz]"));
    assert_eq!(law, "hertz");
    assert!(!half_space.to_string().contains("residual") && !half_space.to_string().contains("plastic"));

    // if the steps leave the range of a law, the message names the steps
    let desk = Desk::with(
        CYCLES
            .replace("[law.plm]\nunloading_exponent = \"pressure-shape\"", "[law.mesarovic_johnson]")
            .replace("{ load = \"10 N\" }", "{ load = \"0.1 N\" }"),
    );
    let output = desk.call(&["run", "s.toml", "--out", "out"]);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("s.toml:17:") && message.contains("step 1: the law has no answer"), "{message}");
    assert!(!desk.path("out").exists());
}

#[test]
fn an_elastic_half_space_has_nothing_plastic() {
    let desk = Desk::with(CYCLES.replace("yield_strength = \"630 MPa\"\n", "").replace("{ load = \"10 N\" },", ""));
    let output = desk.call(&["run", "s.toml", "--out", "out"]);
    // the exponent in the scenario has no effect on an elastic half-space
    assert!(text(&output.stderr).contains("law.plm.unloading_exponent is not used"), "{}", text(&output.stderr));
    let summary = summary(&desk).to_string();
    assert!(!summary.contains("plastic_work") && !summary.contains("residual"), "{summary}");
    assert!(summary.contains("\"hertz\""));
}

#[test]
fn densities_are_not_needed_and_do_no_harm() {
    let plain = Desk::with(CYCLES);
    run(&plain);
    let dense = Desk::with(
        CYCLES
            .replace("poissons_ratio = 0.23", "poissons_ratio = 0.23\ndensity = 15600")
            .replace("poissons_ratio = 0.3\n", "poissons_ratio = 0.3\ndensity = 4500\n"),
    );
    run(&dense);
    assert_eq!(summary(&plain)["half_spaces"], summary(&dense)["half_spaces"]);
}

#[test]
fn strict_makes_a_deep_dent_an_error() {
    let desk = Desk::with(CYCLES.replace("\"16 um\"", "\"50 um\""));
    let output = desk.call(&["run", "s.toml", "--out", "out", "--strict"]);
    assert_eq!(output.status.code(), Some(1));
    let message = text(&output.stderr);
    assert!(message.contains("step 7: contact radius / sphere radius") && message.contains("--strict"), "{message}");
    assert!(!desk.path("out").exists());
}

#[test]
fn no_half_space_and_options_of_tables_are_refused() {
    let start = ALLOYS.find("[[").unwrap();
    let output = Desk::with(&ALLOYS[..start]).call(&["run", "s.toml"]);
    assert!(text(&output.stderr).contains("the table [half_space] is missing"), "{}", text(&output.stderr));
    let output = Desk::with(ALLOYS).call(&["run", "s.toml", "--shard", "0/2"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("--shard is for tables"), "{}", text(&output.stderr));
}
