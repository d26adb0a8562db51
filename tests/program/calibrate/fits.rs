//! `plm-impact calibrate`: compares the found keys with independent fits, with data of known strength, and with
//! measured hardness.

use plm_impact::contact::body::Material;
use plm_impact::contact::law::plm::hardness_test::hardness_of_flow_stress;

use crate::common::prelude::*;

/// A steel ball of 10 mm diameter on steel.
pub fn bodies() -> String {
    crate::common::STEEL.split("[impact]").next().unwrap().to_owned()
}

/// The coefficients that the independent programs below have.
pub const NINE_PIECE_COEFFICIENTS: &str =
    concat!("coefficients = \"", env!("CARGO_MANIFEST_DIR"), "/tests/reference/coefficients-9.toml\"\n");

/// These bodies under that law, with these lines of `[calibrate]`.
pub fn nine_piece_scenario(calibrate: &str) -> String {
    format!("{}[law.plm]\n{NINE_PIECE_COEFFICIENTS}[calibrate]\n{calibrate}", bodies())
}

/// These bodies, with these lines of `[calibrate]`.
pub fn scenario(calibrate: &str) -> String {
    bodies() + "[calibrate]\n" + calibrate
}

/// Two columns of a table as a file of data.
pub fn pairs(table: &str, columns: [&str; 2], head: &str) -> String {
    let [one, other] = columns.map(|name| column(table, name));
    one.iter().zip(&other).fold(format!("{head}\n"), |data, (x, y)| data + &format!("{x},{y}\n"))
}

/// e over the speed, as data, of a table that this sweep makes.
fn restitution_over_speed(sweep: &str) -> String {
    let table = Sandbox::with_results(bodies() + sweep).read("out/table.csv");
    pairs(&table, ["impact_speed_m_per_s", "restitution"], "speed_m_per_s,restitution")
}

pub const SVG_PICTURES: [&str; 2] = ["--pictures", "svg"];

/// Runs a calibration of these data, which has to end with this exit code. It draws only if asked to.
pub fn run_calibration(scenario: &str, data: &str, more: &[&str], code: i32) -> (Sandbox, Value) {
    let desk = Sandbox::with(scenario);
    std::fs::write(desk.path("d.csv"), data).unwrap();
    let pictures: &[&str] = if more.contains(&SVG_PICTURES[0]) { &[] } else { &["--pictures", "none"] };
    desk.run_expecting(&[&["calibrate", "s.toml", "--out", "o"], more, pictures].concat(), code);
    let summary = desk.json("o/summary.json");
    (desk, summary)
}

/// Asserts that a number of a summary is this one.
pub fn assert_close(value: &Value, wanted: f64, tolerance: f64) {
    let value = value.as_f64().unwrap_or(f64::NAN);
    assert!((value / wanted - 1.0).abs() < tolerance, "{value} instead of {wanted}");
}

pub fn bounds(interval: &Value) -> [&Value; 2] {
    [&interval["low"], &interval["high"]]
}

/// Synthetic data: e and peak force at a yield strength of 345 MPa with normal scatter of 0.01 and 2 %.
pub const SYNTHETIC_DATA: &str = "speed_m_per_s,restitution,peak_force_N,peak_force_N_sd
0.2,0.7569,57.08,1.1416\n0.3,0.7275,86.99,1.7398\n0.5,0.6623,157.5,3.15\n0.8,0.6306,269.5,5.39\n1.2,0.5753,402.5,8.05
1.8,0.5484,638.6,12.772\n2.5,0.527,928.9,18.578\n3.2,0.4845,1177,23.54\n4,0.4871,1482,29.64\n5,0.4297,1830,36.6\n";

/// The synthetic data without the force.
pub fn restitutions() -> String {
    let line = |line: &str| line.split(',').take(2).collect::<Vec<_>>().join(",") + "\n";
    SYNTHETIC_DATA.lines().map(line).collect()
}

/// A calibration with one key.
pub const STRENGTH: &str = "free = { \"half_space.yield_strength\" = { from = \"100 MPa\", to = \"3 GPa\" } }\n";
pub const BOTH: &str = "free = { \"half_space.yield_strength\" = { from = \"100 MPa\", to = \"3 GPa\" }, \"half_space.youngs_modulus\" = { from = \"50 GPa\", to = \"500 GPa\" } }\n";

// The numbers of the next three tests come from a Python program that implements the law again from its equations.
// Estimate and sd are from lmfit 1.3 (leastsq). Intervals are from brute force: chi-square at 8000 strengths
// from 300 to 410 MPa; for two keys, the bounded search of scipy at each value of one key.

#[test]
fn one_key_with_known_noise_matches_lmfit() {
    let text = nine_piece_scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = {{ restitution = 0.01 }}"));
    let (_, summary) = run_calibration(&text, &restitutions(), &[], 0);
    let key = &summary["keys"][0];
    assert_close(&key["estimate"], 346.702e6, 3e-5);
    assert_close(&key["sd"], 4.3305e6, 0.02);
    for (interval, wanted) in [("interval_68", [342.415e6, 351.380e6]), ("interval_95", [338.417e6, 355.624e6])] {
        bounds(&key[interval]).iter().zip(wanted).for_each(|(end, wanted)| assert_close(end, wanted, 1e-4));
    }
    assert_close(&summary["chi_square"], 15.910_44, 1e-6);
    assert_close(&summary["p"], 0.068_776, 1e-4);
}

// least squares over 11 001 strengths from 300 to 410 MPa, with the weights taken anew from the law until they stay
#[test]
fn with_an_unknown_noise_the_scatter_gives_it() {
    let text = nine_piece_scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = \"estimate\""));
    let (_, summary) = run_calibration(&text, &restitutions(), &[], 0);
    let key = &summary["keys"][0];
    assert_close(&key["estimate"], 349.2813e6, 3e-5);
    assert_close(&key["sd"], 5.8213e6, 0.02);
    assert_close(&summary["estimated_noise"], 0.024_649_8, 1e-5);
    // Student's t with 9 degrees of freedom
    for (interval, wanted) in [("interval_68", [342.706e6, 355.616e6]), ("interval_95", [335.702e6, 363.066e6])] {
        bounds(&key[interval]).iter().zip(wanted).for_each(|(end, wanted)| assert_close(end, wanted, 1e-4));
    }
    assert!(summary["p"].is_null());
}

#[test]
fn two_keys_match_lmfit_and_brute_force() {
    let text = nine_piece_scenario(&format!("data = \"d.csv\"\n{BOTH}noise = {{ restitution = 0.01 }}"));
    let (_, summary) = run_calibration(&text, SYNTHETIC_DATA, &[], 0);
    let keys = &summary["keys"];
    assert_close(&keys[0]["estimate"], 344.1025e6, 1e-4);
    assert_close(&keys[0]["sd"], 4.0671e6, 0.02);
    assert_close(&keys[1]["estimate"], 208.6711e9, 2e-4);
    assert_close(&keys[1]["sd"], 7.4755e9, 0.02);
    assert_close(&summary["correlation"], 0.4604, 0.02);
    assert_close(&summary["chi_square"], 21.994_35, 1e-5);
    let wanted =
        [[[340.068e6, 348.184e6], [336.233e6, 352.228e6]], [[200.9894e9, 216.3031e9], [193.7979e9, 224.0338e9]]];
    for (i, wanted) in wanted.iter().enumerate() {
        for (interval, wanted) in ["interval_68", "interval_95"].iter().zip(wanted) {
            bounds(&keys[i][interval]).iter().zip(wanted).for_each(|(end, wanted)| assert_close(end, *wanted, 3e-4));
        }
    }
}

#[test]
fn posterior_of_two_keys_is_only_picture() {
    // with as many values as keys there are no residuals to draw
    let text = scenario(&format!("data = \"d.csv\"\n{BOTH}noise = {{ restitution = 0.01 }}"));
    let data = "speed_m_per_s,restitution,peak_force_N,peak_force_N_sd\n3,0.49,1100,20\n";
    let (desk, _) = run_calibration(&text, data, &SVG_PICTURES, 0);
    let files = desk.files("o");
    let pictures = files.iter().filter(|name| name.contains(".svg"));
    assert_eq!(pictures.collect::<Vec<_>>(), ["posterior.svg"]);
}

#[test]
fn restitution_alone_cannot_separate_strength_and_modulus() {
    let text = scenario(&format!("data = \"d.csv\"\n{BOTH}noise = {{ restitution = 0.01 }}"));
    let (desk, summary) = run_calibration(&text, &restitutions(), &SVG_PICTURES, 0);
    let refusal = summary["refusal"].as_str().unwrap();
    assert!(refusal.contains("cannot identify the keys separately") && refusal.contains("contact_time"), "{refusal}");
    for key in summary["keys"].as_array().unwrap() {
        assert!(key["interval_95"].is_null() && key["sd"].is_null());
    }
    // e depends on strength^5/modulus^4, and a little on the compliances of the two bodies
    let known = summary["identifiability"]["best_known_combination"].as_str().unwrap();
    assert!(known.starts_with("half_space.yield_strength x half_space.youngs_modulus^-0."), "{known}");
    assert!(desk.path("o/posterior.svg").exists());
}

#[test]
fn hardness_tester_is_calibrated_by_one_reading() {
    // rebound hardness of two blocks, nominal HLD 760 and 530. An independent program of the law gives the strength,
    // and e of the devices C and E: 2606 MPa, 0.836 and 0.731; 1081 MPa, 0.608 and 0.511
    let text = "[sphere]\nradius = \"1.5 mm\"\nyoungs_modulus = \"600 GPa\"\npoissons_ratio = 0.23\nmass = \"5.5 g\" # the body\n\
                [half_space]\nyoungs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\ndensity = \"7850 kg/m^3\"\n\
                [law.plm]\nunloading_exponent = \"pressure-shape\"\n";
    let text = &(text.to_owned() + NINE_PIECE_COEFFICIENTS);
    for (leeb, strength, c, e) in [("760", 2606e6, 0.836, 0.731), ("530", 1081e6, 0.608, 0.511)] {
        let (desk, summary) = run_calibration(text, "", &["--leeb", leeb, "--speed", "2 m/s"], 0);
        assert_close(&summary["keys"][0]["estimate"], strength, 2e-3);
        assert!(summary["refusal"].as_str().unwrap().contains("noise"));
        assert!(desk.read("o/calibrated.toml").contains("mass = \"5.5 g\" # the body\n"));
        let others = [
            (vec!["sphere.mass=3 g", "impact.speed=1.341641 m/s"], c),
            (vec!["sphere.youngs_modulus=1000 GPa", "sphere.poissons_ratio=0.1"], e),
        ];
        for (settings, wanted) in others {
            let settings: Vec<&str> = settings.into_iter().flat_map(|setting| ["--set", setting]).collect();
            desk.run_expecting(
                &[&["run", "o/calibrated.toml", "--out", "p", "--force", "--pictures", "none"], &settings[..]].concat(),
                0,
            );
            let summary = desk.json("p/summary.json");
            let found = summary["restitution_with_waves"].as_f64().unwrap();
            assert!((found - wanted).abs() < 1e-3, "{found} instead of {wanted}");
        }
    }
}

/// The strength and the hardness that one rebound gives belong together.
#[test]
fn scenario_with_hardness_is_calibrated_by_hardness() {
    let of_hardness = crate::common::STEEL.replace("yield_strength = \"345 MPa\"", "hardness = \"300 HV\"");
    let arguments = ["--restitution", "0.49", "--speed", "3 m/s"];
    let (_, strength) = run_calibration(crate::common::STEEL, "", &arguments, 0);
    let (desk, hardness) = run_calibration(&of_hardness, "", &arguments, 0);
    assert_eq!(hardness["keys"][0]["key"], "half_space.hardness");
    let steel = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };
    let strength = strength["keys"][0]["estimate"].as_f64().unwrap();
    assert_close(&hardness["keys"][0]["estimate"], hardness_of_flow_stress(strength, &steel), 1e-6);
    desk.run_expecting(&["run", "o/calibrated.toml", "--out", "p", "--pictures", "none"], 0);
    let run = desk.json("p/summary.json");
    assert_close(&run["restitution"], 0.49, 1e-6);
}

/// 9.80665 HV/0.9272 MPa is the mean pressure of a Vickers hardness, and 285 HB is 300 HV (ISO 18265).
#[test]
fn hardness_is_returned_on_its_given_scale() {
    let of = |hardness: &str| crate::common::STEEL.replace("yield_strength = \"345 MPa\"", hardness);
    let arguments = ["--restitution", "0.49", "--speed", "3 m/s"];
    let (desk, summary) = run_calibration(&of("hardness = \"300 HV\""), "", &arguments, 0);
    let pressure = summary["keys"][0]["estimate"].as_f64().unwrap();
    let vickers = pressure * 0.9272 / 9.80665e6;
    let of_text = |text: &Value, scale: &str| -> f64 {
        text.as_str().and_then(|text| text.strip_suffix(scale)).unwrap().parse().unwrap()
    };
    assert!(relative_error(of_text(&summary["keys"][0]["estimate_on_its_scale"], " HV"), vickers) < 1e-12);
    assert!(
        desk.read("o/calibrated.toml").contains("hardness = \"") && desk.read("o/calibrated.toml").contains(" HV\"")
    );
    let (told, _) =
        desk.run_expecting(&[&["calibrate", "s.toml", "--out", "o", "--pictures", "none"], &arguments[..]].concat(), 0);
    let line = format!("{vickers:.2} HV ({:.1} MPa)", 1e-6 * pressure);
    assert!(told.contains(&line), "{told}: {line}");
    // on another scale the same pressure, and beyond the table of a scale the pressure alone
    let (_, brinell) = run_calibration(&of("hardness = \"285 HB\""), "", &arguments, 0);
    assert_close(&brinell["keys"][0]["estimate"], pressure, 1e-6);
    // 76 HB is 80 HV, and 95 HB is 100 HV
    let wanted = 76.0 + (vickers - 80.0) / 20.0 * 19.0;
    assert!((80.0..100.0).contains(&vickers));
    assert!(relative_error(of_text(&brinell["keys"][0]["estimate_on_its_scale"], " HB"), wanted) < 1e-6);
    let (desk, _) =
        run_calibration(&of("hardness = \"285 HB\""), "", &["--restitution", "0.97", "--speed", "3 m/s"], 0);
    assert!(desk.read("o/calibrated.toml").contains("Pa\""));
    let (_, strength) = run_calibration(crate::common::STEEL, "", &arguments, 0);
    assert!(strength["keys"][0]["estimate_on_its_scale"].is_null());
}

/// A ball that falls from 1 m and comes back to 24 cm has e = sqrt(0.24), at sqrt(2 g h) with standard gravity.
#[test]
fn one_drop_needs_heights_of_fall_and_rebound() {
    let heights = ["--drop-height", "1 m", "--rebound-height", "24 cm"];
    let (_, of_heights) = run_calibration(crate::common::STEEL, "", &heights, 0);
    let (e, speed) = (0.24_f64.sqrt().to_string(), format!("{} m/s", (2.0 * 9.80665_f64).sqrt()));
    let (_, of_speeds) = run_calibration(crate::common::STEEL, "", &["--restitution", &e, "--speed", &speed], 0);
    assert_close(&of_heights["keys"][0]["estimate"], of_speeds["keys"][0]["estimate"].as_f64().unwrap(), 1e-6);
}

#[test]
fn contradicting_data_end_with_code_3() {
    let rising = "speed_m_per_s,restitution\n0.5,0.4\n1,0.5\n2,0.6\n4,0.7\n";
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = {{ restitution = 0.01 }}"));
    let (desk, summary) = run_calibration(&text, rising, &SVG_PICTURES, 3);
    assert_eq!(summary["fits"], false);
    assert!(summary["contradiction"].as_str().unwrap().contains("chi-square"));
    let wanted = ["calibrated.toml", "fit_restitution.svg", "residuals.csv", "residuals.svg", "summary.json"];
    assert_eq!(desk.files("o"), wanted);
    // no noise is given, and the law deviates much and systematically
    let rising =
        (1..13).fold("speed_m_per_s,restitution\n".to_owned(), |data, i| data + &format!("{i},0.{}\n", 40 + 3 * i));
    let (_, summary) = run_calibration(&scenario(&format!("data = \"d.csv\"\n{STRENGTH}")), &rising, &[], 3);
    assert!(summary["contradiction"].as_str().unwrap().contains("the residuals are not random"));
    // no strength in the range gives this restitution
    let (_, summary) = run_calibration(crate::common::STEEL, "", &["--restitution", "0.02"], 3);
    assert!(summary["contradiction"].as_str().unwrap().contains("no value of half_space.yield_strength"));
}

#[test]
fn two_materials_in_one_file_are_two_basins() {
    // half of the impacts at 200 MPa, half at 800 MPa: with long tails, each half sees the other as outliers
    let data = restitution_over_speed(
        "[sweep]\n\"half_space.yield_strength\" = [2e8, 8e8]\n\"impact.speed\" = { logspace = [0.5, 5], points = 8 }\n",
    );
    let text =
        scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = {{ restitution = 0.005 }}\nrobust = \"student-t\""));
    let (_, summary) = run_calibration(&text, &data, &[], 3);
    let minima = summary["minima"].as_array().unwrap();
    let mut strengths: Vec<f64> = minima.iter().map(|place| place["values"][0].as_f64().unwrap()).collect();
    strengths.sort_by(f64::total_cmp);
    assert!(
        (strengths[0] / 200e6 - 1.0).abs() < 0.02 && (strengths.last().unwrap() / 800e6 - 1.0).abs() < 0.02,
        "{strengths:?}"
    );
    // the interval includes both strengths
    let interval = &summary["keys"][0]["interval_95"];
    assert!(interval["low"].as_f64().unwrap() < 201e6 && interval["high"].as_f64().unwrap() > 799e6, "{interval}");
}

#[test]
fn interval_at_its_bound_is_not_bounded() {
    // these impacts stay below first yield for every high strength, which gives e = 1
    let data = "speed_m_per_s,restitution,restitution_sd\n0.01,1,0.01\n0.02,0.99,0.01\n";
    let (desk, summary) = run_calibration(&scenario(&format!("data = \"d.csv\"\n{STRENGTH}")), data, &[], 0);
    let interval = &summary["keys"][0]["interval_95"];
    assert!(interval["high"].is_null() && interval["low"].as_f64().unwrap() > 100e6, "{interval}");
    assert_eq!(interval["note"], "open interval");
    assert!(
        desk.run_expecting(&["calibrate", "s.toml", "--out", "o", "--pictures", "none"], 0)
            .0
            .contains("and more (open interval)")
    );
    desk.run_expecting(&["calibrate", "s.toml", "--out", "p", "--pictures", "none", "--strict"], 1);
    assert!(!desk.path("p").exists());
}

#[test]
fn outliers_shift_robust_estimate_below_one_sd() {
    let outliers = restitutions().replace("0.5,0.6623", "0.5,0.95").replace("4,0.4871", "4,0.80");
    let noise = "noise = { restitution = 0.01 }\nrobust = ";
    let of = |data: &str, robust: &str, code| {
        let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}{noise}\"{robust}\""));
        run_calibration(&text, data, &[], code).1
    };
    let estimate = |summary: &Value| summary["keys"][0]["estimate"].as_f64().unwrap();
    let (clean, robust) = (of(&restitutions(), "student-t", 0), of(&outliers, "student-t", 0));
    let sd = robust["keys"][0]["sd"].as_f64().unwrap();
    assert!((estimate(&clean) - estimate(&robust)).abs() < sd, "{clean} {robust}");
    assert_eq!(robust["outliers"], 2);
    // least squares are moved by many standard deviations, and do not fit
    let normal = of(&outliers, "none", 3);
    assert!((estimate(&clean) - estimate(&normal)).abs() > 5.0 * sd);
    // with an estimated noise the estimate is robust too
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = \"estimate\"\nrobust = \"student-t\""));
    let found = run_calibration(&text, &outliers, &[], 0).1;
    assert!((estimate(&clean) - estimate(&found)).abs() < 2.0 * found["keys"][0]["sd"].as_f64().unwrap());
}

#[test]
fn law_behind_data_is_ranked_first() {
    let data = restitution_over_speed(
        "[law.thornton]\n[sweep]\n\"impact.speed\" = { logspace = [\"0.1 m/s\", \"10 m/s\"], points = 12 }\n",
    );
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = {{ restitution = 0.005 }}"));
    let (desk, summary) = run_calibration(&text, &data, &[&["--all-laws"], &SVG_PICTURES[..]].concat(), 3);
    let laws = summary["laws"].as_array().unwrap();
    assert_eq!(laws[0]["law"], "thornton");
    assert_close(&laws[0]["values"][0], 345e6, 1e-6);
    let distances = laws.iter().map(|law| law["delta_aic"].as_f64().unwrap_or(f64::INFINITY));
    assert!(distances.is_sorted() && laws.len() > 9);
    assert!(desk.path("o/laws.svg").exists());
}

/// A ball that yields on a hard wall: its own strength is found from its rebounds.
#[test]
fn the_strength_of_a_soft_ball_is_found() {
    let hard = bodies().replace("345 MPa", "3 GPa");
    let of_ball = |lines: &str| hard.replace("[half_space]", &format!("{lines}[half_space]"));
    for wanted in [60e6, 300e6] {
        let table = Sandbox::with_results(
            of_ball(&format!("yield_strength = {wanted:?}\n"))
                + "[impact]\n[sweep]\n\"impact.speed\" = { logspace = [0.05, 5.0], points = 12 }\n",
        );
        let data =
            pairs(&table.read("out/table.csv"), ["impact_speed_m_per_s", "restitution"], "speed_m_per_s,restitution");
        let free = "[calibrate]\ndata = \"d.csv\"\nnoise = { restitution = 0.01 }\nfree = { \"sphere.yield_strength\" = { from = \"20 MPa\", to = \"2 GPa\" } }\n";
        let (desk, summary) = run_calibration(&(of_ball("yield_strength = \"150 MPa\"\n") + free), &data, &[], 0);
        assert_eq!(summary["keys"][0]["key"], "sphere.yield_strength", "{summary}");
        assert_close(&summary["keys"][0]["estimate"], wanted, 1e-6);
        assert!(summary["keys"][0]["sd"].as_f64().unwrap() < 0.05 * wanted, "{summary}");
        assert!(desk.path("o/calibrated.toml").exists());
    }
}

/// Without a key to find it is the strength of the body that yields by the strengths of the scenario, if these say something of the
/// sphere.
#[test]
fn strength_of_yielding_body_is_default_key() {
    let steel = "youngs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\n";
    let of = |sphere: &str, half_space: &str| {
        let text =
            format!("[sphere]\nradius = \"5 mm\"\ndensity = 7850\n{steel}{sphere}\n[half_space]\n{half_space}\n");
        let (_, summary) = run_calibration(&text, "", &["--restitution", "0.49", "--speed", "3 m/s"], 0);
        let key = &summary["keys"][0];
        (key["key"].as_str().unwrap().to_owned(), key["estimate"].as_f64().unwrap())
    };
    let soft = "yield_strength = \"300 MPa\"";
    let hard = format!("{steel}yield_strength = \"2 GPa\"");
    let (key, strength) = of(soft, steel);
    assert_eq!(key, "sphere.yield_strength");
    assert_eq!(of(soft, &hard), (key, strength));
    assert_eq!(of("hardness = \"100 HV\"", steel).0, "sphere.hardness");
    // a half-space that is the softer, or that has no number but a name
    assert_eq!(of("yield_strength = \"2 GPa\"", &format!("{steel}{soft}")).0, "half_space.yield_strength");
    assert_eq!(of("yield_strength = \"2 GPa\"", "material = \"steel-1045-normalized\"").0, "half_space.yield_strength");
}
