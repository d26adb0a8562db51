//! Hostile input, given to the command as a process: too long texts, overrides that set several keys, and texts that a
//! terminal or a spreadsheet would execute.

use crate::common::prelude::*;

/// The message of the command for arguments that it refuses.
fn refusal(desk: &Sandbox, arguments: &[&str]) -> String {
    let output = desk.run(arguments);
    assert_eq!(output.status.code(), Some(2), "{}", text(&output.stderr));
    assert!(output.stdout.is_empty() && !desk.path("out").exists());
    text(&output.stderr)
}

#[test]
fn long_scenario_takes_overrides_and_reports_bad_one() {
    // more than 65 535 bytes, the most blanks that a width of `format!` can make
    let desk = Sandbox::with(format!("{STEEL}{}", "# a comment\n".repeat(10_000)));
    let call = |speed: &str| desk.run(&["check", "s.toml", "--set", "sphere.density=7800", "--set", speed]);
    let output = call("impact.speed=7 m/s");
    assert!(output.status.success() && text(&output.stdout).contains("7 m/s"), "{}", text(&output.stderr));
    let says = text(&call("impact.speed=0").stderr);
    assert!(says.contains("--set impact.speed=0: impact.speed: 0 m/s is not allowed"), "{says}");
}

#[test]
fn one_set_changes_one_key() {
    let desk = Sandbox::with(STEEL);
    for hidden in ["impact.speed=1\nsphere.radius=1", "impact.speed=1\r\nsphere.radius=1", "impact.speed=\u{1b}[2J1"] {
        let says = refusal(&desk, &["run", "s.toml", "--out", "out", "--set", hidden]);
        assert!(says.contains("control character") && says.contains("one --set for each key"), "{says}");
        assert!(!says.contains(['\u{1b}', '\r']), "{says:?}");
    }
}

#[test]
fn last_of_many_overrides_wins() {
    let desk = Sandbox::with(STEEL);
    let speeds: Vec<String> = (1..=3000).map(|i| format!("impact.speed=0.0{i}")).collect();
    let call = |last: &[&str]| {
        let given = speeds.iter().flat_map(|speed| ["--set", speed.as_str()]);
        let arguments: Vec<&str> = ["check", "s.toml"].into_iter().chain(given).chain(last.iter().copied()).collect();
        desk.run(&arguments)
    };
    let output = call(&[]);
    assert!(text(&output.stdout).contains("0.03 m/s"), "{output:?}");
    let says = text(&call(&["--set", "solver.tolerance=7", "--set", "impact.speed=2"]).stderr);
    assert!(says.contains("--set solver.tolerance=7: ") && says.contains("<= 0.01"), "{says}");
    // also if the bad value is inside of a list
    let says = text(&call(&["--set", "sweep={\"impact.speed\"=[1, -2]}", "--set", "impact.speed=2"]).stderr);
    assert!(says.contains("--set sweep={") && says.contains("sweep.impact.speed"), "{says}");
}

#[test]
fn control_characters_do_not_reach_the_terminal() {
    let escape = "\u{1b}[31m";
    let desk = Sandbox::with(STEEL);
    let name = format!("{escape}.toml");
    fs::write(desk.path(&name), format!("{STEEL}\"{}\" = 1\n", "\\u001b[31m")).unwrap();
    let output = desk.run(&["run", &name, "--out", "out"]);
    let says = text(&output.stderr);
    assert!(
        output.status.code() == Some(2) && says.contains("\\u{1b}[31m.toml:") && !says.contains('\u{1b}'),
        "{says:?}"
    );
    // also in the output of a successful run
    fs::write(desk.path(&name), STEEL).unwrap();
    let output = desk.run(&["run", &name, "--out", escape]);
    let says = text(&output.stdout) + &text(&output.stderr);
    assert!(output.status.success() && !says.contains('\u{1b}'), "{says:?}");
    let output = desk.run(&["check", &name]);
    assert!(output.status.success() && !text(&output.stdout).contains('\u{1b}'));
}

#[test]
fn json_stays_json_whatever_the_names_hold() {
    let parsed = |bytes: &[u8]| serde_json::from_slice::<serde_json::Value>(bytes);
    let odd = "a\u{7f}b\u{9b}31mc\u{1b}.toml";
    let desk = Sandbox::with(STEEL);
    fs::write(desk.path(odd), STEEL).unwrap();
    let output = desk.run(&["run", odd, "--out", "out", "--json"]);
    let summary = parsed(&output.stdout).unwrap();
    assert_eq!(summary["provenance"]["scenario_file"], odd);
    let output = desk.run(&["check", odd, "--set", "impact.speed=-1 \u{7f}", "--error-format", "json"]);
    assert_eq!(parsed(&output.stderr).unwrap()["exit_code"], 2);
    for bytes in [&output.stdout, &output.stderr] {
        assert!(!text(bytes).contains(|c: char| c.is_control() && c != '\n'), "{:?}", text(bytes));
    }
}
