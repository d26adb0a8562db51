//! Several scenarios in one command, and what a long run says of its progress.

use std::process::Command;

use crate::common::prelude::*;

/// The square of the second speed is no number of the computer.
const FAILING_ROW: &str = "\n[sweep]\n\"impact.speed\" = [1, 1e-250]\n";

#[test]
fn failing_file_does_not_stop_next_files() {
    let desk = Sandbox::with(STEEL);
    desk.write("f.toml", format!("{STEEL}{FAILING_ROW}").replace("speed = \"3 m/s\"\n", ""));
    desk.write("bad.toml", STEEL.replace("5 mm", "5 mn"));
    let run = |files: &[&str], code| desk.run_expecting(&[&["run"], files, &["--pictures", "none"]].concat(), code).1;
    let said = run(&["f.toml", "bad.toml", "s.toml"], 2);
    assert!(desk.path("plots/s/summary.json").exists() && desk.path("plots/f/summary.json").exists());
    assert!(said.contains("error: 1 of 2 cases have no result") && said.contains("error: bad.toml:2:10"), "{said}");
    let last = "error: 2 of 3 scenarios failed: f.toml (exit code 1), bad.toml (exit code 2)\n";
    assert!(said.ends_with(last), "{said}");
    assert!(run(&["f.toml", "s.toml"], 1).ends_with("error: 1 of 2 scenarios failed: f.toml (exit code 1)\n"));
}

#[test]
fn files_of_equal_name_are_refused_first() {
    let desk = Sandbox::with("");
    desk.write("a/s.toml", STEEL);
    desk.write("b/s.toml", STEEL.replace("3 m/s", "2 m/s"));
    let said = desk.run_expecting(&["run", "a/s.toml", "b/s.toml"], 2).1;
    assert!(said.contains("a/s.toml and b/s.toml have the same name") && said.contains("its own --out"), "{said}");
    assert!(!desk.path("plots").exists());
    // and --out is for one file
    let said = desk.run_expecting(&["run", "a/s.toml", "s.toml", "--out", "o"], 2).1;
    assert!(said.contains("run one file at a time"), "{said}");
}

#[test]
fn unknown_columns_are_refused_with_scenario_kind() {
    let columns = "output.columns=[\"restitution\"]";
    for (more, kind) in [
        ("", "a single impact"),
        ("[repeat]\nspot = \"same\"\nimpacts = 2\n", "a series of impacts"),
        ("[indentation]\nsteps = [{ load = 10 }]\n", "an indentation"),
    ] {
        let scenario =
            if kind == "an indentation" { STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", "") } else { STEEL.into() };
        let desk = Sandbox::with(scenario + more);
        let said = desk.run_expecting(&["run", "s.toml", "--set", columns], 2).1;
        assert!(said.contains(&format!("this scenario is {kind}. Remove this key")), "{said}");
    }
}

#[test]
fn too_large_file_is_refused_with_remedy() {
    let desk = Sandbox::with(STEEL.replace("[impact]", "flow_stress = { table = \"flow.csv\" }\n\n[impact]"));
    desk.write("flow.csv", "plastic_strain,stress_Pa\n".to_owned() + &"0.1,400e6\n".repeat(110_000));
    let said = desk.run_expecting(&["check", "s.toml"], 2).1;
    assert!(said.contains("is larger than 1 MiB, the limit. Split the file."), "{said}");
    assert!(!said.contains("linspace"), "{said}");
}

#[test]
fn deviation_column_without_unit_gets_full_name() {
    let desk = Sandbox::with(STEEL);
    desk.write("d.csv", "speed_m_per_s,dent_depth_m,dent_depth_sd\n3,1e-5,1e-6\n");
    let said = desk.run_expecting(&["calibrate", "s.toml", "d.csv"], 2).1;
    assert!(said.contains("`dent_depth_sd` has no unit. Write dent_depth_m_sd"), "{said}");
}

/// A log of a batch job has lines in place of a bar.
#[test]
fn progress_is_logged_where_there_is_no_terminal() {
    let desk = Sandbox::with("");
    desk.run_expecting(&["init", "repeat"], 0);
    let logged = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
        command.current_dir(desk.path("")).env("PLM_IMPACT_TEST_LOG_EVERY_MS", "0");
        let output = command.args(arguments).args(["--pictures", "none"]).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        text(&output.stderr)
    };
    let run = |more: &[&str]| logged(&[&["run", "repeat.toml", "--set", "repeat.impacts=200"], more].concat());
    let said = run(&[]);
    assert!(said.lines().any(|line| line.contains("/200 done")), "{said}");
    assert!(!run(&["--quiet"]).contains("/200"));
    // of a calibration: a fit and the intervals of two keys
    desk.write("c.toml", STEEL.split("[impact]").next().unwrap());
    desk.write("d.csv", "speed_m_per_s,restitution,peak_force_N,peak_force_N_sd\n2,0.51,700,10\n3,0.49,1100,20\n");
    let strength = "\"half_space.yield_strength\" = { from = \"100 MPa\", to = \"3 GPa\" }";
    let modulus = "\"half_space.youngs_modulus\" = { from = \"50 GPa\", to = \"500 GPa\" }";
    let free = format!("calibrate.free={{ {strength}, {modulus} }}");
    let said = logged(&["calibrate", "c.toml", "d.csv", "--set", &free, "--set", "calibrate.noise.restitution=0.01"]);
    let mut counts = said.lines().filter_map(|line| line.split_once(" done")).map(|(count, _)| count);
    assert!(said.contains("/3 done") && counts.all(|count| count.ends_with("/3")), "{said}");
    // a line a minute: a short run has none
    let said = desk.run_expecting(&["run", "repeat.toml", "--set", "repeat.impacts=200", "--pictures", "none"], 0).1;
    assert!(!said.contains("/200"), "{said}");
}

/// A standard deviation larger than the value: its bar ends at the lower end of a logarithmic axis, and does not vanish.
#[test]
fn bar_below_logarithmic_axis_is_cut() {
    let drawn = |share: f64| {
        let desk = Sandbox::with(STEEL);
        let depths = [(0.5, 1.2e-6), (1.0, 3.2e-6), (2.0, 8.0e-6), (4.0, 1.9e-5)];
        let rows = depths.iter().enumerate().map(|(at, (speed, depth))| {
            let sd = depth * if at == 0 { share } else { 0.1 };
            format!("{speed},{depth},{sd}\n")
        });
        desk.write("d.csv", "speed_m_per_s,dent_depth_m,dent_depth_m_sd\n".to_owned() + &rows.collect::<String>());
        desk.run(&["calibrate", "s.toml", "d.csv", "--out", "o", "--pictures", "svg"]);
        let picture = desk.read("o/fit_dent_depth.svg");
        Document::parse(&picture).unwrap().descendants().filter(|node| node.has_tag_name("polyline")).count()
    };
    let usual = drawn(0.2);
    assert!(usual > 4);
    assert_eq!(drawn(2.0), usual);
}
