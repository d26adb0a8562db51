//! The command as a process: outputs, messages and exit codes. If the input is wrong, nothing is written.

use crate::common::prelude::*;

const STEEL: &str = include_str!("../../../scenarios/steel-on-steel.toml");
const FILES: [&str; 4] = ["force_indentation.png", "history.png", "summary.json", "trace.csv"];

/// Asserts that the command refuses with exit code 2 and a message that has all of `wants`, and writes no file.
fn assert_refused(desk: &Sandbox, arguments: &[&str], wants: &[&str]) {
    let before = desk.files("");
    let (printed, message) = desk.run_expecting(arguments, 2);
    assert!(printed.is_empty(), "{arguments:?}: {printed}");
    assert!(wants.iter().all(|want| message.contains(want)), "{arguments:?}: {wants:?} are not in\n{message}");
    assert!(message.len() < 2000, "{arguments:?}: {} bytes of message", message.len());
    assert_eq!(desk.files(""), before, "{arguments:?}");
}

#[test]
fn run_writes_outputs_and_prints_only_table() {
    let desk = Sandbox::with(STEEL);
    let (table, said) =
        desk.run_expecting(&["run", "s.toml", "--set", "law.plm.unloading_exponent=1.5", "--out", "o"], 0);
    assert_eq!(desk.files("o"), FILES);
    // tests/reference/built_in.csv: e = 0.49058
    assert!(table.starts_with("impact speed") && table.contains("0.4906"), "{table}");
    assert!(said.contains("wrote summary.json"));
    let summary = desk.json("o/summary.json");
    let restitution = summary["restitution"].as_f64().unwrap();
    // tests/reference/built_in.csv, "steel on steel, 3 m/s"
    assert!((restitution / 0.490_578_548_979_793_5 - 1.0).abs() < 1e-8, "{restitution}");
    assert_eq!(summary["provenance"]["command"], "plm-impact run s.toml --set law.plm.unloading_exponent=1.5 --out o");
    assert_eq!(summary["provenance"]["scenario_sha256"].as_str().unwrap().len(), 64);
}

#[test]
fn overrides_directory_and_quiet_keep_other_files() {
    let desk = Sandbox::with(STEEL);
    let slow = ["run", "s.toml", "--out", "a/b", "--set", "impact.speed=1 m/s"];
    assert_eq!(desk.run_expecting(&[&slow[..], &["--quiet"]].concat(), 0), (String::new(), String::new()));
    assert_eq!(desk.files("a/b"), FILES);
    fs::write(desk.path("a/b/notes.txt"), "mine").unwrap();
    desk.run_expecting(&slow, 0);
    assert_eq!((desk.files("a/b").len(), desk.read("a/b/notes.txt").as_str()), (FILES.len() + 1, "mine"));
    let summary = desk.json("a/b/summary.json");
    assert_eq!(summary["inputs"]["impact_speed_m_per_s"], 1.0);
    assert!(summary["provenance"]["command"].as_str().unwrap().contains("--set 'impact.speed=1 m/s'"), "{summary}");
}

#[test]
fn speed_option_replaces_speed_and_drop_height() {
    let desk = Sandbox::with(STEEL);
    let e = |arguments: &[&str]| -> f64 {
        let (printed, _) = desk.run_expecting(
            &[&["run", "s.toml", "--json", "--pictures", "none", "--force", "--out", "o"], arguments].concat(),
            0,
        );
        let summary: Value = serde_json::from_str(&printed).unwrap();
        assert_eq!(summary["inputs"]["impact_speed_m_per_s"], 2.0);
        summary["restitution"].as_f64().unwrap()
    };
    let wanted = e(&["--set", "impact.speed=2 m/s"]);
    assert_eq!(e(&["--speed", "200 cm/s"]).to_bits(), wanted.to_bits());
    std::fs::write(desk.path("s.toml"), STEEL.replace("speed = \"3 m/s\"", "drop_height = \"1 m\"")).unwrap();
    assert_eq!(e(&["--speed", "2 m/s"]).to_bits(), wanted.to_bits());
}

#[test]
fn broken_pipe_is_not_an_error() {
    let desk = Sandbox::with(STEEL);
    // the first command prints results and warnings, the second an error
    for arguments in [&["run", "s.toml", "--set", "impact.speed=200 m/s"][..], &["check", "none.toml"]] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_plm-impact"));
        command.current_dir(desk.path("")).args(arguments).stdout(writer.try_clone().unwrap()).stderr(writer);
        let want = if arguments[0] == "run" { 0 } else { 2 };
        assert_eq!(command.status().unwrap().code(), Some(want), "{arguments:?}");
    }
    assert_eq!(desk.files("plots/s,impact.speed=200m_s"), FILES);
}

#[test]
fn non_scenarios_are_refused() {
    assert_refused(&Sandbox::with(""), &["run", "s.toml"], &["s.toml: the table [sphere] is missing; give its radius"]);
    let binary: Vec<u8> = (0..=255).cycle().take(4096).collect();
    assert_refused(&Sandbox::with(binary), &["run", "s.toml"], &["s.toml:2: is not a text file"]);
    assert_refused(&Sandbox::with([0; 100]), &["run", "s.toml"], &["s.toml:1:101: key with no value"]);
    // a folder in which not even root may write
    if Path::new("/proc/self").exists() {
        let arguments = ["run", "s.toml", "--out", "/proc/plm"];
        assert_refused(&Sandbox::with(STEEL), &arguments, &["/proc/plm: cannot be written"]);
    }
}

#[test]
fn huge_values_are_read_or_refused_briefly() {
    const SIZE: usize = 200_000;
    let refused = |text: &str, wants: &[&str]| assert_refused(&Sandbox::with(text), &["check", "s.toml"], wants);
    let long_line = "x".repeat(SIZE);
    refused(&long_line, &["s.toml:1:"]);
    refused(&"sped = 3\n".repeat(SIZE / 9), &["s.toml:2:1", "`sped` is given twice, first in line 1"]);
    // of such a long value or key only both ends are shown
    let digits = STEEL.replace("\"3 m/s\"", &format!("\"{} m/s\"", "3".repeat(SIZE)));
    refused(&digits, &["s.toml:19:9: impact.speed: \"333", "> 0 m/s and finite"]);
    refused(&format!("{long_line} = 1\n{STEEL}"), &["s.toml:1:1: xxx", "unknown table", "tables are sphere"]);
    Sandbox::with(format!("{STEEL}\n# {long_line}")).run_expecting(&["check", "s.toml"], 0);
    // a mebibyte, and one byte more
    let at_most = format!("{STEEL}{}", "#\n".repeat(((1 << 20) - STEEL.len()) / 2));
    Sandbox::with(&at_most).run_expecting(&["check", "s.toml"], 0);
    refused(&(at_most + "##\n"), &["s.toml: is larger than 1 MiB", "linspace"]);
}

#[test]
fn coefficients_come_from_a_file_beside_the_scenario() {
    let desk = Sandbox::with("");
    fs::create_dir(desk.path("sub")).unwrap();
    fs::write(desk.path("sub/s.toml"), STEEL).unwrap();
    let arguments = ["check", "sub/s.toml", "--set", "law.plm.coefficients=my.toml"];
    assert_refused(&desk, &arguments, &["law.plm.coefficients: sub/my.toml: cannot be read"]);
    let built_in = include_str!("../../../src/contact/law/plm/coefficients.toml");
    fs::write(desk.path("sub/my.toml"), built_in.replace("name = \"", "name = \"mine, ")).unwrap();
    assert!(desk.run_expecting(&arguments, 0).0.contains("mine, "));
}
