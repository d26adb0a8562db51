//! Input and output of a calibration: columns, units, curves, refusals, files.

use std::fmt::Write as _;

use serde_json::Value;

use super::{STRENGTH, calibrated, near, restitutions, scenario};
use crate::common::command::{Desk, column, text};

#[test]
fn every_bad_file_is_refused_with_its_line_and_the_way_out() {
    let many =
        |line: &str| format!("# heights\nspeed_m_per_s,restitution,restitution_sd\n1,0.5,0.01\n{line}\n3,0.4,0.01\n");
    let cases: [(String, &[&str]); 27] = [
        (many("2,x,0.01"), &["d.csv:4", "column 2, `restitution`", "\"x\" is no number"]),
        (many("2,1.5,0.01"), &["d.csv:4", "1.5 is not allowed", "<= 1"]),
        (many("2,0,0.01"), &["d.csv:4", "> 0"]),
        (many("2,nan,0.01"), &["d.csv:4", "NaN"]),
        (many("-2,0.5,0.01"), &["d.csv:4", "column 1", "> 0 m/s"]),
        (many(",0.5,0.01"), &["d.csv:4", "`speed_m_per_s`", "is empty"]),
        (many("2,,0.01"), &["d.csv:4", "no quantity was measured"]),
        (many("2,0.5,0"), &["d.csv:4", "`restitution_sd`", "> 0"]),
        (many("2,0.5,"), &["d.csv:4", "no standard deviation", "calibrate.noise.restitution"]),
        (many("2,0.5"), &["d.csv:4", "not as many values"]),
        (many("2,0.5,0.01,7"), &["d.csv:4", "not as many values"]),
        ("speed_m_per_s,restitutoin\n1,0.5\n".to_owned(), &["d.csv:1", "did you mean `restitution`?", "Columns are"]),
        ("speed,restitution\n1,0.5\n".to_owned(), &["d.csv:1", "no unit", "speed_m_per_s"]),
        ("speed_kg,restitution\n1,0.5\n".to_owned(), &["d.csv:1", "`kg`", "no unit of a speed"]),
        (
            "speed_kg_per_s,restitution\n1,0.5\n".to_owned(),
            &["d.csv:1", "`kg/s`, which is no unit of a speed: write speed_m_per_s, or another unit"],
        ),
        (many("2,0.5,1e-300"), &["d.csv:4", "standard deviation of this restitution is 1e-300", "no instrument"]),
        // a rebound that is higher or faster than the impact
        (
            "speed_m_per_s,rebound_speed_m_per_s\n1,0.9\n1,1.2\n".to_owned(),
            &["d.csv:3", "rebound_speed of 1.2 m/s is more than a rebound without any loss gives, 1 m/s"],
        ),
        ("speed_m_per_s,leeb\n1,1000.5\n".to_owned(), &["d.csv:2", "<= 1000"]),
        ("speed_m_per_s,rebound_speed_mm_per_s\n1,1e3\n2,2000.1\n".to_owned(), &["d.csv:3", "check columns and units"]),
        ("speed_m_per_s;restitution\n1;0,5\n".to_owned(), &["d.csv:1", "commas"]),
        ("speed_m_per_s,speed_mm_per_s,restitution\n1,1,0.5\n".to_owned(), &["d.csv:1", "twice"]),
        ("speed_m_per_s,restitution_sd\n1,0.5\n".to_owned(), &["d.csv:1", "no column `restitution` beside it"]),
        ("speed_m_per_s\n1\n".to_owned(), &["d.csv", "no column is a measured quantity"]),
        ("speed_m_per_s,restitution\n".to_owned(), &["d.csv", "no measured value"]),
        (String::new(), &["d.csv", "no column is a measured quantity"]),
        ("indentation_m,restitution\n1e-6,0.5\n".to_owned(), &["d.csv:1", "indentation_m and force_N"]),
        ("drop_height_m,restitution\n1,0.5\n".to_owned(), &["its column impact.drop_height needs gravity"]),
    ];
    for (data, wanted) in cases {
        let desk = Desk::with(scenario(&format!("data = \"d.csv\"\n{STRENGTH}")));
        std::fs::write(desk.path("d.csv"), &data).unwrap();
        let output = desk.call(&["calibrate", "s.toml", "--out", "o"]);
        let error = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{data}{error}");
        for part in wanted {
            assert!(error.contains(part), "{part} is not in {error}");
        }
        assert!(!desk.path("o").exists(), "{data}");
    }
}

#[test]
fn every_bad_table_is_refused() {
    let cases = [
        ("data = \"none.csv\"", "none.csv: cannot be read"),
        ("", "there are no measurements"),
        ("data = \"d.csv\"\nmeasured = { restitution = 0.5 }", "write only one of the two"),
        ("data = \"d.csv\"\nfree = {}", "expected one or two"),
        ("data = \"d.csv\"\nfree = { \"sphere.raduis\" = { from = 1, to = 2 } }", "did you mean \"sphere.radius\"?"),
        ("data = \"d.csv\"\nfree = { \"sphere.radius\" = { from = 2, to = 1 } }", "the lower first"),
        ("data = \"d.csv\"\nfree = { \"sphere.radius\" = { from = \"1 kg\", to = 2 } }", "is a mass"),
        (
            "data = \"d.csv\"\nfree = { \"damping.viscous\" = { from = 0, to = 1, scale = \"log\" } }",
            "scale = \"linear\"",
        ),
        (
            "data = \"d.csv\"\nfree = { \"impact.speed\" = { from = 1, to = 2 } }",
            "is a key to find, and the data give it",
        ),
        ("data = \"d.csv\"\nfree = { \"sphere.yield_strength\" = { from = 1, to = 2 } }", "only warns"),
        (
            "data = \"d.csv\"\nfree = { \"law.thornton.yield_pressure\" = { from = 1, to = 2 } }",
            "no case is under that law",
        ),
        ("data = \"d.csv\"\nnoise = { restitutoin = 1 }", "did you mean `restitution`?"),
        ("data = \"d.csv\"\nnoise = { leeb = 1 }", "no leeb was measured"),
        ("data = \"d.csv\"\nnoise = \"some\"", "\"estimate\""),
        ("data = \"d.csv\"\nrobust = \"huber\"", "student-t"),
        ("data = \"d.csv\"\n[sweep]\n\"impact.speed\" = [1]", "write only one of the two"),
        ("measured = { restitution = 0.5 }", "the table [impact] is missing"),
        ("measured = { rebound_height = 0.5 }\n[impact]\nspeed = 3", "needs gravity"),
        (
            "measured = { rebound_height = \"150 mm\" }\n[impact]\ndrop_height = \"100 mm\"\n[gravity]\nacceleration = 9.81",
            "rebound_height of 150 mm is more than a rebound without any loss gives, 100 mm",
        ),
    ];
    for (table, wanted) in cases {
        let desk = Desk::with(scenario(table));
        std::fs::write(desk.path("d.csv"), restitutions()).unwrap();
        let output = desk.call(&["calibrate", "s.toml", "--out", "o"]);
        let error = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{table}\n{error}");
        assert!(error.contains(wanted), "{table}\n{error}");
        assert!(!desk.path("o").exists());
    }
    let output = Desk::with(crate::common::STEEL).call(&["calibrate", "s.toml"]);
    assert!(text(&output.stderr).contains("there is nothing to calibrate"));
}

/// These columns of a table of 12 impacts that the program computes.
fn made(sweep: &str, columns: &[&str]) -> Vec<Vec<f64>> {
    let text = crate::common::STEEL.split("[impact]").next().unwrap().to_owned() + sweep;
    let desk = Desk::with(text);
    assert_eq!(desk.call(&["run", "s.toml", "--out", "t"]).status.code(), Some(0));
    let table = desk.read("t/table.csv");
    let number = |field: &String| field.parse().unwrap();
    columns.iter().map(|name| column(&table, name).iter().map(number).collect()).collect()
}

#[test]
fn columns_are_read_in_any_unit_with_keys_that_change_from_line_to_line() {
    let columns = [
        "sphere_radius_m",
        "impact_speed_m_per_s",
        "contact_time_s",
        "dent_radius_m",
        "residual_indentation_m",
        "peak_force_N",
    ];
    let sweep = "[sweep]\n\"sphere.radius\" = [\"1 mm\", \"5 mm\", \"2 cm\"]\n\"impact.speed\" = [0.5, 1, 2, 5]\n";
    let table = made(sweep, &columns);
    let mut data =
        "note,sphere_radius_mm,speed_cm_per_s,contact_time_us,dent_diameter_um,dent_depth_nm,peak_force_kN\n"
            .to_owned();
    for (row, radius) in table[0].iter().enumerate() {
        let [speed, time, dent, depth, force] = [1, 2, 3, 4, 5].map(|column: usize| table[column][row]);
        // the field is empty if the quantity was not measured
        let depth = if row == 3 { String::new() } else { (depth * 1e9).to_string() };
        let (radius, speed, time, dent) = (radius * 1e3, speed * 1e2, time * 1e6, 2e6 * dent);
        writeln!(data, "a,{radius},{speed},{time},{dent},{depth},{}", force * 1e-3).unwrap();
    }
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = {{ model = 0.02 }}"));
    let (desk, summary) = calibrated(&text, &data, &[], 0);
    let key = &summary["keys"][0];
    near(&key["estimate"], 345e6, 1e-7);
    assert_eq!(summary["values"], 47);
    // averaging does not reduce an error that is common to all values of a quantity
    let (own, common) = (key["sd"].as_f64().unwrap(), key["sd_if_model_error_is_common"].as_f64().unwrap());
    assert!(common > 1.5 * own, "{own} {common}");
    let residuals = column(&desk.read("o/residuals.csv"), "residual_over_sd");
    assert!(residuals.iter().all(|field| field.parse::<f64>().unwrap().abs() < 1e-5));
}

#[test]
fn a_whole_cycle_of_indentation_gives_strength_and_modulus() {
    let text = crate::common::STEEL.split("[impact]").next().unwrap().to_owned()
        + "[indentation]\nsteps = [{ load = \"500 N\" }, { load = \"0 N\" }]\n[output]\nsamples = 60\n";
    let desk = Desk::with(text);
    assert_eq!(desk.call(&["run", "s.toml", "--out", "t"]).status.code(), Some(0));
    let trace = desk.read("t/trace.csv");
    let pairs = column(&trace, "indentation_m").into_iter().zip(column(&trace, "force_N"));
    let data = pairs.fold("indentation_m,force_N\n".to_owned(), |data, (x, f)| data + &format!("{x},{f}\n"));
    let both = "free = { \"half_space.yield_strength\" = { from = \"100 MPa\", to = \"3 GPa\" }, \"half_space.youngs_modulus\" = { from = \"50 GPa\", to = \"500 GPa\" } }\n";
    let text = scenario(&format!("data = \"d.csv\"\n{both}noise = {{ force = \"5 N\" }}"));
    let (desk, summary) = calibrated(&text, &data, &[], 0);
    near(&summary["keys"][0]["estimate"], 345e6, 1e-5);
    near(&summary["keys"][1]["estimate"], 210e9, 1e-5);
    assert!(summary["keys"][1]["interval_95"]["low"].as_f64().unwrap() > 150e9);
    // the new scenario indents as deep as the data
    assert_eq!(desk.call(&["run", "o/calibrated.toml", "--out", "p"]).status.code(), Some(0));
    let again: Value = serde_json::from_str(&desk.read("p/summary.json")).unwrap();
    assert!(again.to_string().contains("unloading_stiffness"), "{again}");
}

#[test]
fn a_value_that_is_left_out_shifts_the_estimate_as_the_residuals_say() {
    let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}noise = {{ restitution = 0.01 }}"));
    let (desk, summary) = calibrated(&text, &restitutions(), &[], 0);
    let whole = summary["keys"][0]["estimate"].as_f64().unwrap();
    let shifts = column(&desk.read("o/residuals.csv"), "shift_without_it_half_space_yield_strength_Pa");
    let sd = summary["keys"][0]["sd"].as_f64().unwrap();
    for (left_out, shift) in shifts.iter().enumerate().step_by(3) {
        let lines: Vec<String> = restitutions().lines().map(str::to_owned).collect();
        let rest: String =
            lines.iter().enumerate().filter(|(i, _)| *i != left_out + 1).map(|(_, line)| line.clone() + "\n").collect();
        let again = calibrated(&text, &rest, &[], 0).1["keys"][0]["estimate"].as_f64().unwrap();
        // to first order
        assert!(
            (again - whole - shift.parse::<f64>().unwrap()).abs() < 0.15 * sd,
            "{left_out}: {again} {whole} {shift}"
        );
    }
    let largest = &summary["keys"][0]["largest_shift"];
    let expected = shifts.iter().map(|shift| shift.parse::<f64>().unwrap().abs()).fold(0.0, f64::max);
    near(&Value::from(largest["without_it"].as_f64().unwrap().abs()), expected, 1e-12);
}

#[test]
fn the_new_scenario_keeps_comments_and_options_and_runs_to_the_fitted_line() {
    let text = "# of a block\n".to_owned()
        + &scenario(&format!("data = \"d.csv\" # drops\n{STRENGTH}noise = {{ restitution = 0.01 }}\n"))
            .replace("yield_strength = \"345 MPa\"", "yield_strength = \"1 GPa\" # guess");
    let (desk, summary) =
        calibrated(&text, &restitutions(), &["--set", "law=thornton", "--set", "sphere.radius=4 mm"], 3);
    let new = desk.read("o/calibrated.toml");
    assert!(
        new.starts_with("# half_space.yield_strength: found by plm-impact")
            && new.contains("\n# of a block\n")
            && new.contains(" # guess\n")
            && !new.contains("calibrate"),
        "{new}"
    );
    assert!(new.contains("[law.thornton]") && new.contains("\"4 mm\""), "{new}");
    // the strength has a unit, and all digits
    let estimate = summary["keys"][0]["estimate"].as_f64().unwrap();
    let written = new.split("yield_strength = \"").nth(1).unwrap().split(" MPa\"").next().unwrap();
    assert_eq!(format!("{written}e6").parse::<f64>().unwrap(), estimate, "{new}");
    let run = desk.call(&["run", "o/calibrated.toml", "--set", "impact.speed=2.5", "--out", "p"]);
    assert_eq!(run.status.code(), Some(0), "{}", text_of(&run.stderr));
    let again: Value = serde_json::from_str(&desk.read("p/summary.json")).unwrap();
    let predicted = column(&desk.read("o/residuals.csv"), "predicted")[6].parse::<f64>().unwrap();
    near(&again["restitution"], predicted, 1e-8);
    assert_eq!(summary["inputs"]["law"], "thornton");
    // a law of two, chosen over that of the file
    let text = text.clone() + "[law.plm]\nunloading_exponent = 1.6\n";
    let (desk, summary) = calibrated(&text, &restitutions(), &["--set", "law=jackson_green + brake"], 0);
    assert_eq!(summary["inputs"]["law"], "jackson_green + brake");
    let new = desk.read("o/calibrated.toml");
    assert!(new.contains("loading = \"jackson_green\"") && !new.contains("law.plm"), "{new}");
    assert_eq!(desk.call(&["check", "o/calibrated.toml"]).status.code(), Some(0), "{new}");
}

fn text_of(bytes: &[u8]) -> String {
    text(bytes)
}

#[test]
fn nothing_that_is_there_is_overwritten() {
    let desk = Desk::with(scenario(&format!("data = \"d.csv\"\n{STRENGTH}")));
    std::fs::write(desk.path("d.csv"), restitutions()).unwrap();
    std::fs::create_dir(desk.path("o")).unwrap();
    std::fs::write(desk.path("o/residuals.csv"), "mine").unwrap();
    let output = desk.call(&["calibrate", "s.toml", "--out", "o"]);
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    assert_eq!((desk.read("o/residuals.csv").as_str(), desk.files("o")), ("mine", vec!["residuals.csv".to_owned()]));
    // the data are given as an argument, in another folder than the scenario; `run` gives the same as `calibrate`
    std::fs::create_dir(desk.path("data")).unwrap();
    std::fs::rename(desk.path("d.csv"), desk.path("data/e.csv")).unwrap();
    std::fs::copy(desk.path("data/e.csv"), desk.path("data/o'brien \\ é.csv")).unwrap();
    assert_eq!(desk.call(&["calibrate", "s.toml", "data/e.csv", "--out", "p"]).status.code(), Some(0));
    let quoted = desk.call(&["calibrate", "s.toml", "data/o'brien \\ é.csv", "--out", "r", "--pictures", "none"]);
    assert_eq!(quoted.status.code(), Some(0), "{}", text(&quoted.stderr));
    assert_eq!(
        desk.call(&["run", "s.toml", "--set", "calibrate.data=data/e.csv", "--out", "q"]).status.code(),
        Some(0)
    );
    assert_eq!(desk.read("p/residuals.csv"), desk.read("q/residuals.csv"));
}
