//! Input and output of a calibration: columns, units, curves, files.

use std::fmt::Write as _;

use super::fits::{BOTH, STRENGTH, assert_close, bodies, pairs, restitutions, run_calibration, scenario};
use crate::common::prelude::*;

#[test]
fn changed_measurements_replace_results_with_notice() {
    let desk = Sandbox::with(scenario(&format!("data = \"d.csv\"\n{STRENGTH}")));
    let calibrated = |restitution: &str| {
        let data = format!("speed_m_per_s,restitution,restitution_sd\n1,{restitution},0.01\n3,0.49,0.01\n");
        std::fs::write(desk.path("d.csv"), data).unwrap();
        let output = desk.run(&["calibrate", "s.toml", "--out", "o"]);
        assert!(desk.path("o/summary.json").exists(), "{}", text(&output.stderr));
        text(&output.stderr).contains("o: replaced the results of s.toml")
    };
    let replaces = ["0.60", "0.60", "0.61"].map(calibrated);
    assert_eq!(replaces, [false, false, true]);
    // what fails replaces nothing, and does not say so
    let there = desk.read("o/summary.json");
    std::fs::write(desk.path("d.csv"), "speed_m_per_s,restitution\n1,much\n").unwrap();
    let (_, said) = desk.run_expecting(&["calibrate", "s.toml", "--out", "o"], 2);
    assert!(!said.contains("replace") && desk.read("o/summary.json") == there, "{said}");
}

#[test]
fn columns_have_any_unit_and_keys_per_line() {
    let columns = [
        "sphere_radius_m",
        "impact_speed_m_per_s",
        "contact_time_s",
        "dent_diameter_m",
        "residual_indentation_m",
        "peak_force_N",
    ];
    let sweep = "[sweep]\n\"sphere.radius\" = [\"1 mm\", \"5 mm\", \"2 cm\"]\n\"impact.speed\" = [0.5, 1, 2, 5]\n";
    let made = Sandbox::with_results(bodies() + sweep).read("out/table.csv");
    let table = columns.map(|name| numbers(&made, name));
    let mut data =
        "note,sphere_radius_mm,speed_cm_per_s,contact_time_us,dent_diameter_um,dent_depth_nm,peak_force_kN\n"
            .to_owned();
    for (row, radius) in table[0].iter().enumerate() {
        let [speed, time, dent, depth, force] = [1, 2, 3, 4, 5].map(|column: usize| table[column][row]);
        // the field is empty if the quantity was not measured
        let depth = if row == 3 { String::new() } else { (depth * 1e9).to_string() };
        let (radius, speed, time, dent) = (radius * 1e3, speed * 1e2, time * 1e6, 1e6 * dent);
        writeln!(data, "a,{radius},{speed},{time},{dent},{depth},{}", force * 1e-3).unwrap();
    }
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = {{ model = 0.02 }}"));
    let (desk, summary) = run_calibration(&text, &data, &[], 0);
    let key = &summary["keys"][0];
    assert_close(&key["estimate"], 345e6, 1e-7);
    assert_eq!(summary["values"], 47);
    let residuals = numbers(&desk.read("o/residuals.csv"), "residual_over_sd");
    assert!(residuals.iter().all(|residual| residual.abs() < 1e-5));
}

/// A spreadsheet writes semicolons and decimal commas in many countries, and tabs into the clipboard.
#[test]
fn separators_and_decimal_commas_give_same_bits() {
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}"));
    let plain =
        "note,speed_m_per_s,restitution,restitution_sd\nwarm,0.2,0.7569,1e-2\n,0.3,0.7275,1.5e-2\n,0.5,0.6623,2e-2\n";
    let [semicolons, tabs] = [";", "\t"].map(|sign| plain.replace(',', sign));
    let commas = semicolons.replace('.', ",").replace("1e-2", "+1,0E-2").replace("warm", "\"a; b, c\"");
    let residuals = [plain, &semicolons, &commas, &tabs, &tabs.replace('.', ",")].map(|data| {
        let (desk, summary) = run_calibration(&text, data, &[], 0);
        (desk.read("o/residuals.csv"), summary["keys"].to_string())
    });
    assert!(residuals.iter().all(|one| *one == residuals[0]), "{residuals:?}");
    assert_eq!(numbers(&residuals[0].0, "measured"), [0.7569, 0.7275, 0.6623]);
}

#[test]
fn indentation_cycle_gives_strength_and_modulus() {
    let steps = "[indentation]\nsteps = [{ load = \"500 N\" }, { load = \"0 N\" }]\n[output]\nsamples = 24\n";
    let trace = Sandbox::with_results(bodies() + steps).read("out/trace.csv");
    let data = pairs(&trace, ["indentation_m", "force_N"], "indentation_m,force_N");
    let text = scenario(&format!("data = \"d.csv\"\n{BOTH}noise = {{ force = \"5 N\" }}"));
    let (desk, summary) = run_calibration(&text, &data, &[], 0);
    assert_close(&summary["keys"][0]["estimate"], 345e6, 1e-5);
    assert_close(&summary["keys"][1]["estimate"], 210e9, 1e-5);
    assert!(summary["keys"][1]["interval_95"]["low"].as_f64().unwrap() > 150e9);
    // the new scenario indents as deep as the data
    desk.run_expecting(&["run", "o/calibrated.toml", "--out", "p", "--pictures", "none"], 0);
    let again = desk.json("p/summary.json");
    assert!(again.to_string().contains("unloading_stiffness"), "{again}");
}

#[test]
fn leave_one_out_shifts_match_refits() {
    shifts_match_refits("");
    shifts_match_refits("robust = \"student-t\"\n");
}

/// Refits without every third value.
fn shifts_match_refits(robust: &str) {
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}{robust}noise = {{ restitution = 0.01 }}"));
    let (desk, summary) = run_calibration(&text, &restitutions(), &[], 0);
    let whole = summary["keys"][0]["estimate"].as_f64().unwrap();
    let shifts = numbers(&desk.read("o/residuals.csv"), "shift_without_it_half_space_yield_strength_Pa");
    let sd = summary["keys"][0]["sd"].as_f64().unwrap();
    for (left_out, shift) in shifts.iter().enumerate().step_by(3) {
        let data = restitutions();
        let rest = data.lines().enumerate().filter(|(line, _)| *line != left_out + 1);
        let rest: String = rest.map(|(_, line)| line.to_owned() + "\n").collect();
        let again = run_calibration(&text, &rest, &[], 0).1["keys"][0]["estimate"].as_f64().unwrap();
        // to first order
        assert!((again - whole - shift).abs() < 0.05 * sd, "{left_out}: {again} {whole} {shift}");
    }
    let largest = &summary["keys"][0]["largest_shift"];
    let expected = shifts.iter().map(|shift| shift.abs()).fold(0.0, f64::max);
    assert_close(&Value::from(largest["without_it"].as_f64().unwrap().abs()), expected, 1e-12);
}

/// Two equal impacts determine one combination of two keys, so there are no steps of the keys.
#[test]
fn undetermined_keys_have_no_shifts() {
    let text = scenario(&format!("data = \"d.csv\"\n{BOTH}noise = {{ restitution = 0.01 }}"));
    let (desk, _) = run_calibration(&text, "speed_m_per_s,restitution\n3,0.49\n3,0.49\n", &[], 0);
    let table = desk.read("o/residuals.csv");
    for key in ["half_space_yield_strength_Pa", "half_space_youngs_modulus_Pa"] {
        assert_eq!(column(&table, &format!("shift_without_it_{key}")), ["", ""], "{table}");
    }
}

#[test]
fn calibrated_scenario_keeps_comments_and_runs() {
    let text = "# of a block\n".to_owned()
        + &scenario(&format!("data = \"d.csv\" # drops\n{STRENGTH}noise = {{ restitution = 0.01 }}\n"))
            .replace("yield_strength = \"345 MPa\"", "yield_strength = \"1 GPa\" # guess")
            .replace("radius = \"5 mm\"", "radius = \"5 mm\" # not the diameter");
    let (desk, summary) =
        run_calibration(&text, &restitutions(), &["--set", "law=thornton", "--set", "sphere.radius=4 mm"], 3);
    let new = desk.read("o/calibrated.toml");
    assert!(
        new.starts_with("# half_space.yield_strength: fitted by plm-impact")
            && new.contains("\n# of a block\n")
            && new.contains(" # guess\n")
            && !new.contains("calibrate"),
        "{new}"
    );
    assert!(new.contains("[law.thornton]") && new.contains("radius = \"4 mm\" # not the diameter\n"), "{new}");
    // the strength has a unit, and all digits
    let estimate = summary["keys"][0]["estimate"].as_f64().unwrap();
    let written = new.split("yield_strength = \"").nth(1).unwrap().split(" MPa\"").next().unwrap();
    assert_eq!(format!("{written}e6").parse::<f64>().unwrap(), estimate, "{new}");
    desk.run_expecting(
        &["run", "o/calibrated.toml", "--set", "impact.speed=2.5", "--out", "p", "--pictures", "none"],
        0,
    );
    let again = desk.json("p/summary.json");
    let predicted = numbers(&desk.read("o/residuals.csv"), "predicted")[6];
    assert_close(&again["restitution"], predicted, 1e-8);
    assert_eq!(summary["inputs"]["law"], "thornton");
    // a law of two, chosen over that of the file
    let text = text.clone() + "[law.plm]\nunloading_exponent = 1.6\n";
    let (desk, summary) = run_calibration(&text, &restitutions(), &["--set", "law=jackson_green + brake"], 0);
    assert_eq!(summary["inputs"]["law"], "jackson_green + brake");
    let new = desk.read("o/calibrated.toml");
    assert!(new.contains("loading = \"jackson_green\"") && !new.contains("law.plm"), "{new}");
    desk.run_expecting(&["check", "o/calibrated.toml"], 0);
}

/// The strength follows from the hardness that is found, so it is no input: one of the search would be that of 30 HV.
#[test]
fn check_of_a_calibration_shows_bodies_and_columns() {
    let hardness = "free.\"half_space.hardness\" = { from = \"30 HV\", to = \"300 HV\" }\n";
    let hard = scenario(&format!("data = \"d.csv\"\n{hardness}")).replace("yield_strength = \"345 MPa\"\n", "");
    let desk = Sandbox::with(&hard);
    std::fs::write(desk.path("d.csv"), "drop_height_cm,restitution\n10,0.6\n20,0.55\n40,0.5\n").unwrap();
    let (printed, _) = desk.run_expecting(&["check", "s.toml"], 0);
    let row = |name: &str| {
        let found = printed.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' ')).unwrap_or_default();
        found.trim().to_owned()
    };
    assert_eq!(row("sphere.radius"), "0.005 m (5 mm)", "{printed}");
    assert_eq!(row("impact.drop_height"), "3 values, 100 mm to 400 mm, in d.csv", "{printed}");
    assert_eq!(row("restitution"), "3 values, 0.5 to 0.6, in d.csv", "{printed}");
    assert!(row("half_space.hardness").contains("HV (") && !printed.contains("yield_strength  "), "{printed}");
    desk.run_expecting(&["calibrate", "s.toml", "--out", "o", "--pictures", "none"], 0);
    let inputs = desk.json("o/summary.json")["inputs"].clone();
    assert!(inputs.get("half_space_yield_strength_Pa").is_none(), "{inputs}");
    assert!(inputs.get("half_space_hardness_over_flow_stress").is_none(), "{inputs}");
}

#[test]
fn existing_files_are_not_overwritten() {
    let desk = Sandbox::with(scenario(&format!("data = \"d.csv\"\n{STRENGTH}")));
    std::fs::write(desk.path("d.csv"), restitutions()).unwrap();
    std::fs::create_dir(desk.path("o")).unwrap();
    std::fs::write(desk.path("o/residuals.csv"), "mine").unwrap();
    desk.run_expecting(&["calibrate", "s.toml", "--out", "o"], 2);
    assert_eq!((desk.read("o/residuals.csv").as_str(), desk.files("o")), ("mine", vec!["residuals.csv".to_owned()]));
    // the data are given as an argument, in another folder than the scenario; `run` gives the same as `calibrate`
    std::fs::create_dir(desk.path("data")).unwrap();
    std::fs::rename(desk.path("d.csv"), desk.path("data/e.csv")).unwrap();
    std::fs::copy(desk.path("data/e.csv"), desk.path("data/o'brien \\ é.csv")).unwrap();
    desk.run_expecting(&["calibrate", "s.toml", "data/e.csv", "--out", "p", "--pictures", "none"], 0);
    desk.run_expecting(&["calibrate", "s.toml", "data/o'brien \\ é.csv", "--out", "r", "--pictures", "none"], 0);
    desk.run_expecting(&["run", "s.toml", "--set", "calibrate.data=data/e.csv", "--out", "q"], 0);
    assert_eq!(desk.read("p/residuals.csv"), desk.read("q/residuals.csv"));
}

/// The rebounds of five drops of a steel ball on 6061, heights measured in cm, with the speeds and restitutions that follow
/// from them with standard gravity.
#[test]
fn heights_and_speeds_give_the_same_strength() {
    let text = "[sphere]\nradius = \"5 mm\"\nmaterial = \"steel-52100-hardened\"\n\
                [half_space]\nmaterial = \"aluminium-6061-t6\"\n[calibrate]\ndata = \"d.csv\"\nnoise = { model = 0.02 }\n";
    let drops: [[f64; 2]; 5] = [[20.0, 7.9], [40.0, 14.2], [60.0, 20.1], [80.0, 25.2], [100.0, 30.6]];
    let heights = drops
        .iter()
        .fold("drop_height_cm,rebound_height_cm\n".to_owned(), |data, [h, back]| data + &format!("{h},{back}\n"));
    let speeds = drops.iter().fold("speed_m_per_s,restitution,restitution_sd\n".to_owned(), |data, [h, back]| {
        data + &format!("{},{},0.001\n", (2.0 * 9.80665 * 0.01 * h).sqrt(), (back / h).sqrt())
    });
    let sd =
        drops.iter().fold("drop_height_cm,rebound_height_cm,rebound_height_cm_sd\n".to_owned(), |data, [h, back]| {
            data + &format!("{h},{back},{}\n", 2.0 * back * 0.001 / (back / h).sqrt())
        });
    let strength = |data: &str, more: &[&str]| {
        let (_, summary) = run_calibration(text, data, more, 0);
        summary["keys"][0]["estimate"].as_f64().unwrap()
    };
    let by_speed = strength(&speeds, &[]);
    assert!(relative_error(strength(&sd, &[]), by_speed) < 2e-3, "{} {by_speed}", strength(&sd, &[]));
    // gravity during contact changes next to nothing; the waves stay
    let under_gravity = strength(&heights, &["--set", "gravity.acceleration=9.80665"]);
    assert!(relative_error(under_gravity, strength(&heights, &[])) < 1e-4);
}
