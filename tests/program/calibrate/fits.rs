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

/// Synthetic restitutions at a yield strength of 345 MPa with normal scatter of 0.01.
pub fn restitutions() -> String {
    super::table::data("restitutions")
}

/// A calibration with one key.
pub const STRENGTH: &str = "free = { \"half_space.yield_strength\" = { from = \"100 MPa\", to = \"3 GPa\" } }\n";
pub const BOTH: &str = "free = { \"half_space.yield_strength\" = { from = \"100 MPa\", to = \"3 GPa\" }, \"half_space.youngs_modulus\" = { from = \"50 GPa\", to = \"500 GPa\" } }\n";

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
    // two of ten impacts are a basin that does not fit as well, and the interval leaves it out
    let few: String = data.lines().take(11).map(|line| line.to_owned() + "\n").collect();
    let (_, summary) = run_calibration(&text.replace("0.005", "0.002"), &few, &[], 0);
    assert_eq!(summary["minima"].as_array().unwrap().len(), 2, "{summary}");
    assert_close(&summary["keys"][0]["estimate"], 200e6, 1e-3);
    let interval = &summary["keys"][0]["interval_95"];
    assert!(interval["low"].as_f64().unwrap() > 190e6 && interval["high"].as_f64().unwrap() < 210e6, "{interval}");
}

/// Every impact of one material is an outlier for the other material, and adds 2 (4 + 1) ln(1/sd) to the sum of Student's distribution
/// with 4 degrees of freedom. So a noise that is 2 % larger at eight impacts makes the sum of this material 80 ln 1.02 = 1.58 larger. An
/// interval has all materials whose sum is larger by less than 1 (68 %) or 3.84 (95 %).
#[test]
fn interval_includes_second_basin_below_its_level() {
    let data = restitution_over_speed(
        "[sweep]\n\"half_space.yield_strength\" = [2e8, 8e8]\n\"impact.speed\" = { logspace = [0.5, 5], points = 8 }\n",
    );
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}robust = \"student-t\""));
    let (soft, hard) = (200e6, 800e6);
    for (deviations, of_68, of_95) in [
        ([0.001, 0.00102], [soft, soft], [soft, hard]),
        ([0.00102, 0.001], [hard, hard], [soft, hard]),
        ([0.001, 0.001], [soft, hard], [soft, hard]),
    ] {
        let of_line = |(line, text): (usize, &str)| match line {
            0 => format!("{text},restitution_sd\n"),
            _ => format!("{text},{}\n", deviations[(line - 1) / 8]),
        };
        let data: String = data.lines().enumerate().map(of_line).collect();
        let (_, summary) = run_calibration(&text, &data, &[], 3);
        for (name, wanted) in [("interval_68", of_68), ("interval_95", of_95)] {
            for (bound, wanted) in bounds(&summary["keys"][0][name]).into_iter().zip(wanted) {
                assert_close(bound, wanted, 0.004);
            }
        }
        let excess = summary["minima"][1]["excess"].as_f64().unwrap();
        let expected = 80.0 * f64::ln(deviations[1] / deviations[0]).abs();
        assert!((excess - expected).abs() < 1e-3, "{excess} {expected}");
    }
}

#[test]
fn outliers_shift_robust_estimate_below_one_sd() {
    let outliers = super::table::data("outliers");
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
    let (desk, found) = run_calibration(&text, &outliers, &[], 0);
    assert!((estimate(&clean) - estimate(&found)).abs() < 2.0 * found["keys"][0]["sd"].as_f64().unwrap());
    // The noise is a share of the law, at least of half a reading. For normal noise the median of |residual| is the standard deviation
    // over 1.4826, and one key takes one of 10 degrees of freedom
    let table = desk.read("o/residuals.csv");
    let (measured, law) = (numbers(&table, "measured"), numbers(&table, "predicted"));
    let share = |(law, read): (&f64, &f64)| (read - law).abs() / law.max(0.5 * read);
    let mut shares: Vec<f64> = law.iter().zip(&measured).map(share).collect();
    shares.sort_by(f64::total_cmp);
    let noise = 1.482_602_2 * 0.5 * (shares[4] + shares[5]) * (10.0_f64 / 9.0).sqrt();
    assert_close(&found["estimated_noise"], noise, 1e-4);
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
    // the distance to the smallest AIC, after Burnham and Anderson (2002)
    let aic = |law: &Value| law["aic"].as_f64();
    let smallest = aic(&laws[0]).unwrap();
    for (law, aic) in laws.iter().filter_map(|law| Some((law, aic(law)?))) {
        assert_eq!(law["delta_aic"].as_f64(), Some(aic - smallest), "{law}");
    }
    assert!(desk.path("o/laws.svg").exists());
}

/// Rebounds determine one product of powers of strength and modulus, and nothing beside it. So this product is known as well as the
/// strength alone, if the modulus is given.
#[test]
fn product_of_two_keys_is_known_like_one() {
    let data =
        restitution_over_speed("[sweep]\n\"impact.speed\" = { logspace = [\"0.5 m/s\", \"5 m/s\"], points = 12 }\n");
    let known = |free: &str| {
        let text = scenario(&format!("data = \"d.csv\"\n{free}noise = {{ restitution = 0.01 }}"));
        let summary = run_calibration(&text, &data, &[], 0).1;
        summary["identifiability"]["relative_sd_of_that"].as_f64().unwrap()
    };
    let (product, alone) = (known(BOTH), known(STRENGTH));
    assert!((product / alone - 1.0).abs() < 1e-3, "{product} {alone}");
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

/// The time A of a viscoelastic contact follows from one rebound: with a = (3/2) A v/L = 0.1 a Hertz contact has e = 0.892858875506553
/// (20 digits, `tests/reference/viscoelastic.csv`). Here k = (4/3) E* √R = 10⁸ N/m^(3/2), m = 10⁻⁴ kg, v = 1 m/s, so L = 10^(−4.8) m.
#[test]
fn viscoelastic_time_follows_from_one_rebound() {
    let text = "[sphere]\nradius = 0.0025\nmass = 1e-4\nyoungs_modulus = \"rigid\"\npoissons_ratio = 0.3\n\
                [half_space]\nyoungs_modulus = 1.5e9\npoissons_ratio = 0\n[impact]\nspeed = 1\n\
                [calibrate]\nmeasured.restitution = 0.892858875506553\n\
                free.\"damping.viscoelastic_time\" = { from = \"1 ns\", to = \"1 ms\" }\n";
    let desk = Sandbox::with(text);
    desk.run_expecting(&["run", "s.toml", "--out", "o", "--pictures", "none"], 0);
    let length = 10_f64.powf(-4.8);
    assert_close(&desk.json("o/summary.json")["keys"][0]["estimate"], 0.1 * length / 1.5, 1e-6);
}
