//! `[indentation]` as a process: outputs, messages and exit codes. If the input is wrong, nothing is written.

use std::fs;

use plm_impact::units::four_digits;

use crate::common::command::Desk;

const CYCLES: &str = include_str!("../../scenarios/indentation-cycles.toml");
const ALLOYS: &str = include_str!("../../scenarios/indentation-ti-nb.toml");

#[test]
fn cycles_give_a_table_a_summary_a_trace_and_a_picture() {
    let desk = Desk::with(CYCLES);
    let (table, _) = desk.ends(&["run", "s.toml", "--out", "out"], 0);
    assert!(table.starts_with("step  to") && table.lines().count() == 9, "{table}");
    let summary = desk.summary();
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
    let (table, _) = desk.ends(&["run", "s.toml", "--out", "out"], 0);
    for name in ["Ti-5Nb", "Ti-10Nb", "Ti-40Nb", "Ti-70Nb"] {
        assert!(table.contains(name), "{table}");
    }
    let summary = desk.summary();
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
    let (printed, _) = desk.ends(&["check", "s.toml"], 0);
    for want in ["load 30 N", "± 12 GPa", "yield force F_Y", "Ti-40Nb"] {
        assert!(printed.contains(want), "{want}: {printed}");
    }
}

/// The same cycles with other laws: the dents follow from the published formulas of these laws.
#[test]
fn other_laws_leave_their_own_dents() {
    let under = |table: &str| CYCLES.replace("[law.plm]\nunloading_exponent = \"pressure-shape\"", table);
    let steps = |scenario: String| {
        let summary = Desk::ran(scenario).summary();
        (summary["half_spaces"][0].clone(), summary["provenance"]["law"].as_str().unwrap().to_owned())
    };
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let (radius, strength) = (0.25e-3_f64, 630e6);
    let pi = std::f64::consts::PI;

    let (half_space, law) = steps(under("[law.thornton]"));
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

    let (half_space, law) = steps(under("[law.jackson_green]"));
    assert_eq!(law, "jackson_green");
    // δ_r/δ_m = 1.02 (1 − ((x + 5.9)/6.9)^−0.54), x = δ_m over R (π C σ_Y/(2 E*))², C = 1.295 exp(0.736 ν)
    let yields = radius * (pi * 1.295 * (0.736_f64 * 0.3).exp() * strength / (2.0 * modulus)).powi(2);
    for step in half_space["steps"].as_array().unwrap() {
        let depth = number(&step["peak_indentation_m"]);
        let share = 1.02 * (1.0 - ((depth / yields + 5.9) / 6.9).powf(-0.54));
        assert!((number(&step["residual_indentation_m"]) / (share * depth) - 1.0).abs() < 1e-10, "{step}");
    }

    // an elastic law has no dent, so none is written
    let (half_space, law) = steps(under("[law.hertz]"));
    assert_eq!(law, "hertz");
    assert!(!half_space.to_string().contains("residual") && !half_space.to_string().contains("plastic"));

    // nor has an elastic half-space
    let elastic = CYCLES.replace("yield_strength = \"630 MPa\"\n", "").replace("{ load = \"10 N\" },", "");
    let (half_space, law) = steps(elastic);
    assert!(!half_space.to_string().contains("residual") && !half_space.to_string().contains("plastic_work"));
    assert_eq!(law, "hertz");

    // if the steps leave the range of a law, the message names the steps
    let narrow = under("[law.mesarovic_johnson]").replace("{ load = \"10 N\" }", "{ load = \"0.1 N\" }");
    let desk = Desk::with(narrow);
    let (_, message) = desk.ends(&["run", "s.toml", "--out", "out"], 2);
    assert!(message.contains("s.toml:17:") && message.contains("step 1: the law has no answer"), "{message}");
    assert!(!desk.path("out").exists());
}

#[test]
fn densities_are_not_needed_and_do_no_harm() {
    let dense = CYCLES
        .replace("poissons_ratio = 0.23", "poissons_ratio = 0.23\ndensity = 15600")
        .replace("poissons_ratio = 0.3\n", "poissons_ratio = 0.3\ndensity = 4500\n");
    let [plain, dense] = [CYCLES.to_owned(), dense].map(|text| Desk::ran(text).summary());
    assert_eq!(plain["half_spaces"], dense["half_spaces"]);
}
