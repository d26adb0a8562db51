//! The command as a process: outputs, messages and exit codes. If the input is wrong, nothing is written.

use std::fs;
use std::path::Path;

use crate::common::command::{Desk, text};

const STEEL: &str = include_str!("../../scenarios/steel-on-steel.toml");
const FILES: [&str; 4] = ["force_indentation.png", "history.png", "summary.json", "trace.csv"];

/// Asserts that the command refuses with exit code 2 and a message that has all of `wants`, and writes no file.
fn assert_refused(desk: &Desk, arguments: &[&str], wants: &[&str]) {
    let before = desk.files("");
    let output = desk.call(arguments);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
    assert!(output.stdout.is_empty(), "{arguments:?}: {}", text(&output.stdout));
    for want in wants {
        assert!(message.contains(want), "{arguments:?}: {want:?} is not in\n{message}");
    }
    assert!(message.len() < 2000, "{arguments:?}: {} bytes of message", message.len());
    assert_eq!(desk.files(""), before, "{arguments:?}");
}

#[test]
fn run_writes_all_outputs_and_prints_the_table_alone() {
    let desk = Desk::with(STEEL);
    let output = desk.call(&["run", "s.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(desk.files("plots/s"), FILES);
    let table = text(&output.stdout);
    // src/reference/oracle.csv: e = 0.49246
    assert!(table.starts_with("impact speed") && table.contains("0.4925"), "{table}");
    assert!(text(&output.stderr).contains("wrote summary.json"));

    let summary: serde_json::Value =
        serde_json::from_slice(&fs::read(desk.path("plots/s/summary.json")).unwrap()).unwrap();
    let restitution = summary["restitution"].as_f64().unwrap();
    // src/reference/oracle.csv, "steel on steel, 3 m/s"
    assert!((restitution / 0.492_463_617_254_029_9 - 1.0).abs() < 1e-8, "{restitution}");
    assert_eq!(summary["provenance"]["command"], "plm-impact run s.toml");
    assert_eq!(summary["provenance"]["scenario_sha256"].as_str().unwrap().len(), 64);
}

#[test]
fn overrides_directory_and_quiet_do_what_they_say() {
    let desk = Desk::with(STEEL);
    let output = desk.call(&["run", "s.toml", "--out", "a/b", "--set", "impact.speed=1 m/s", "--quiet"]);
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
    assert_eq!(desk.files("a/b"), FILES);
    let summary = fs::read_to_string(desk.path("a/b/summary.json")).unwrap();
    assert!(summary.contains("\"impact_speed_m_per_s\": 1.0"), "{summary}");
    assert!(summary.contains("--set 'impact.speed=1 m/s'"), "{summary}");
}

#[test]
fn a_second_run_replaces_outputs_and_leaves_other_files_alone() {
    let desk = Desk::with(STEEL);
    let faster = ["run", "s.toml", "--out", "out", "--set", "impact.speed=4 m/s"];
    assert_eq!(desk.call(&faster).status.code(), Some(0));
    let old = desk.read("out/summary.json");
    fs::write(desk.path("out/notes.txt"), "mine").unwrap();
    assert_eq!(desk.call(&["run", "s.toml", "--out", "out"]).status.code(), Some(0));
    assert_ne!(desk.read("out/summary.json"), old);
    assert!(fs::read_to_string(desk.path("out/summary.json")).unwrap().contains("restitution"));
    assert_eq!(fs::read_to_string(desk.path("out/notes.txt")).unwrap(), "mine");
    assert_eq!(desk.files("out").len(), FILES.len() + 1);
}

#[test]
fn a_scenario_without_a_command_and_no_threads_at_all_are_refused() {
    let desk = Desk::with(STEEL);
    assert_refused(&desk, &["s.toml"], &["no command is given for s.toml; write `plm-impact run s.toml`"]);
    assert_refused(&desk, &["run", "s.toml", "--threads", "0"], &["--threads", "1..=1024"]);
}

#[test]
fn check_prints_what_was_understood_and_writes_nothing() {
    let desk = Desk::with(STEEL);
    let output = desk.call(&["check", "s.toml", "--set", "sphere.youngs_modulus=rigid"]);
    assert_eq!(output.status.code(), Some(0));
    let table = text(&output.stdout);
    for want in ["0.005 m (5 mm)", "rigid", "3.45e8 Pa (345 MPa)", "yield speed v_Y", "effective modulus E*", "kappa  "]
    {
        assert!(table.contains(want), "{want}: {table}");
    }
    assert_eq!(desk.files(""), ["s.toml"]);
}

#[test]
fn an_elastic_scene_reports_nothing_plastic() {
    let desk = Desk::with(STEEL.replace("yield_strength = \"345 MPa\"", ""));
    let output = desk.call(&["run", "s.toml", "--out", "out"]);
    assert_eq!(output.status.code(), Some(0));
    // the exponent in the scenario has no effect on an elastic scene
    assert!(text(&output.stderr).contains("warning: law.plm.unloading_exponent is not used"));
    let summary = fs::read_to_string(desk.path("out/summary.json")).unwrap();
    assert!(!summary.contains("dent_radius") && !summary.contains("plastic_J"), "{summary}");
    let checked = desk.call(&["check", "s.toml"]);
    assert!(text(&checked.stderr).contains("is not used"));
    assert!(text(&checked.stdout).contains("stays elastic"));
}

#[test]
fn a_reader_who_has_left_is_no_failure() {
    let desk = Desk::with(STEEL);
    // the first command prints results and warnings, the second an error
    for arguments in [&["run", "s.toml", "--set", "impact.speed=200 m/s"][..], &["check", "none.toml"]] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_plm-impact"));
        command.current_dir(desk.path("")).args(arguments).stdout(writer.try_clone().unwrap()).stderr(writer);
        let want = if arguments[0] == "run" { 0 } else { 2 };
        assert_eq!(command.status().unwrap().code(), Some(want), "{arguments:?}");
    }
    assert_eq!(desk.files("plots/s"), FILES);
}

#[test]
fn strict_makes_warnings_errors_and_writes_nothing() {
    let desk = Desk::with(STEEL);
    // the contact is far beyond a/R = 0.45
    let arguments = ["run", "s.toml", "--out", "out", "--set", "impact.speed=200 m/s"];
    let output = desk.call(&arguments);
    assert_eq!(output.status.code(), Some(0));
    assert!(text(&output.stderr).contains("warning: "));
    fs::remove_dir_all(desk.path("out")).unwrap();
    let output = desk.call(&[&arguments[..], &["--strict"]].concat());
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("--strict"));
    assert!(output.stdout.is_empty());
    assert_eq!(desk.files(""), ["s.toml"]);
}

#[test]
fn no_number_is_called_extreme_where_none_stands_out() {
    // the speed that underflows is one value of a list
    let shots = "[repeat]\nspot = \"same\"\nspeeds = [\"1 m/s\", \"1e-200 m/s\"]\n";
    let desk = Desk::with(STEEL.replace("[impact]\nspeed = \"3 m/s\"\n", shots));
    assert_refused(&desk, &["run", "s.toml"], &["s.toml: kinetic energy", "choose a less extreme radius"]);
}

#[test]
fn what_is_no_scenario_is_refused() {
    assert_refused(&Desk::with(""), &["run", "s.toml"], &["s.toml: the table [sphere] is missing; give its radius"]);
    let binary: Vec<u8> = (0..=255).cycle().take(4096).collect();
    assert_refused(&Desk::with(binary), &["run", "s.toml"], &["s.toml:2: is not a text file"]);
    assert_refused(&Desk::with([0; 100]), &["run", "s.toml"], &["s.toml:1:101: key with no value"]);
    let desk = Desk::with("");
    fs::create_dir(desk.path("d")).unwrap();
    assert_refused(&desk, &["run", "d"], &["d: cannot be read"]);
    assert_refused(&desk, &["run", "none.toml"], &["none.toml: cannot be read"]);
    assert_refused(&desk, &["run"], &["FILE"]);
    assert_refused(&desk, &["dance"], &["unrecognized subcommand"]);
}

#[test]
fn almost_a_megabyte_is_read_or_refused_in_few_words() {
    const SIZE: usize = 1_000_000;
    assert_refused(&Desk::with("x".repeat(10 * SIZE)), &["check", "s.toml"], &["s.toml: is larger than 1 MiB"]);
    let long_line = "x".repeat(SIZE);
    assert_refused(&Desk::with(&long_line), &["check", "s.toml"], &["s.toml:1:"]);
    let many_lines = "sped = 3\n".repeat(SIZE / 9);
    assert_refused(&Desk::with(many_lines), &["check", "s.toml"], &["s.toml:2:1", "duplicate"]);
    // of such a long value or key only both ends are shown
    let digits = STEEL.replace("\"3 m/s\"", &format!("\"{} m/s\"", "3".repeat(SIZE)));
    assert_refused(
        &Desk::with(digits),
        &["check", "s.toml"],
        &["s.toml:18:9: impact.speed: \"333", "> 0 m/s and finite"],
    );
    let key = format!("{long_line} = 1\n{STEEL}");
    assert_refused(&Desk::with(key), &["check", "s.toml"], &["s.toml:1:1: xxx", "unknown table", "tables are sphere"]);
    let long_comment = format!("{STEEL}\n# {long_line}");
    assert_eq!(Desk::with(long_comment).call(&["check", "s.toml"]).status.code(), Some(0));
}

#[test]
fn outputs_that_cannot_be_written_are_refused_before_anything_runs() {
    let desk = Desk::with(STEEL);
    fs::write(desk.path("file"), "mine").unwrap();
    assert_refused(&desk, &["run", "s.toml", "--out", "file"], &["file: cannot be written", "--out"]);
    assert_refused(&desk, &["run", "s.toml", "--out", "file/below"], &["file/below: cannot be written", "--out"]);
    assert_eq!(fs::read_to_string(desk.path("file")).unwrap(), "mine");
    // a folder in which not even root may write
    if Path::new("/proc/self").exists() {
        assert_refused(&desk, &["run", "s.toml", "--out", "/proc/plm"], &["/proc/plm: cannot be written"]);
    }
    // if one of the outputs is a directory, no output is replaced
    fs::create_dir_all(desk.path("out/trace.csv")).unwrap();
    assert_refused(&desk, &["run", "s.toml", "--out", "out"], &["out/trace.csv: cannot be written"]);
    assert_eq!(desk.files("out"), ["trace.csv"]);
}

#[test]
fn coefficients_come_from_a_file_beside_the_scenario() {
    let built_in = include_str!("../../src/law/plm/coefficients.toml");
    let desk = Desk::with("");
    fs::create_dir(desk.path("sub")).unwrap();
    fs::write(desk.path("sub/s.toml"), STEEL).unwrap();
    let arguments = ["check", "sub/s.toml", "--set", "law.plm.coefficients=my.toml"];
    assert_refused(&desk, &arguments, &["law.plm.coefficients: sub/my.toml: cannot be read"]);
    let bad = built_in.replace("slope = [2.00,", "slope = [-2.00,");
    fs::write(desk.path("sub/my.toml"), bad).unwrap();
    assert_refused(&desk, &arguments, &["sub/my.toml", "force.slope", "-2.0", "> 0"]);
    fs::write(desk.path("sub/my.toml"), built_in.replace("[force]", "[forse]")).unwrap();
    assert_refused(&desk, &arguments, &["sub/my.toml", "unknown field `forse`"]);
    fs::write(desk.path("sub/my.toml"), built_in.replace("name = \"", "name = \"mine, ")).unwrap();
    let output = desk.call(&arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("mine, "));
}
