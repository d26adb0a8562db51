//! The interface to programs and shells: summaries and errors as JSON, standard input, completions, and the
//! examples of the help.

use std::process::{Command, Output};

use crate::common::prelude::*;

const PROGRAM: &str = env!("CARGO_BIN_EXE_plm-impact");

/// Runs a line in a shell in a directory, where `plm-impact` is the program.
fn shell(desk: &Sandbox, line: &str) -> Output {
    let script = format!("plm-impact() {{ '{PROGRAM}' \"$@\"; }}; {line}");
    Command::new("bash").args(["-c", &script]).current_dir(desk.path("")).env("HOME", desk.path("")).output().unwrap()
}

fn objects(bytes: &[u8]) -> Vec<Value> {
    text(bytes).lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn json_prints_only_the_written_summary() {
    for kind in Kind::ALL.map(Kind::name) {
        let desk = Sandbox::with("");
        let file = format!("{kind}.toml");
        desk.run_expecting(&["init", kind], 0);
        let said = desk.run_expecting(&["run", &file, "--json", "--pictures", "none", "--out", "out"], 0);
        assert_eq!(said, (desk.read("out/summary.json"), String::new()), "{kind}");
        assert!(desk.summary().is_object());
    }
    // warnings go to standard error
    let desk = Sandbox::with(STEEL);
    let output = desk.run(&["run", "s.toml", "--json", "--set", "impact.speed=200 m/s"]);
    assert_eq!(serde_json::from_slice::<Value>(&output.stdout).unwrap()["inputs"]["impact_speed_m_per_s"], 200.0);
    assert!(text(&output.stderr).starts_with("warning: "));
    // a shard has no summary
    desk.run_expecting(&["init", "sweep"], 0);
    let (_, said) = desk.run_expecting(&["run", "sweep.toml", "--json", "--shard", "0/2", "--out", "out"], 2);
    assert!(said.contains("--json and --shard exclude each other"));
    assert!(!desk.path("out").exists());
}

#[test]
fn json_error_has_position_and_allowed_values() {
    let desk = Sandbox::with(STEEL.replace("radius = \"5 mm\"", "radius = \"-5 mm\""));
    fs::write(desk.path("name.toml"), STEEL.replace("radius =", "radus =")).unwrap();
    fs::write(desk.path("good.toml"), STEEL).unwrap();
    fs::write(desk.path("no-speed.toml"), STEEL.replace("speed =", "#")).unwrap();
    fs::write(desk.path("data.csv"), "restitution\n0.5\nmuch\n").unwrap();
    let cases: [(&[&str], Value); 11] = [
        (&["run", "good.toml", "--set", "law=thorntn"], json!({"key": "law.thorntn", "value": "thorntn"})),
        (
            &["run", "s.toml"],
            json!({"file": "s.toml", "line": 2, "column": 10, "key": "sphere.radius", "value": "\"-5 mm\"",
                   "allowed": "a length > 0 m and finite", "exit_code": 2}),
        ),
        (&["check", "name.toml"], json!({"file": "name.toml", "line": 2, "column": 1, "key": "sphere.radus"})),
        (
            &["check", "good.toml", "--set", "impact.speed=-1"],
            json!({"key": "impact.speed", "value": "-1", "allowed": "a speed > 0 m/s and finite"}),
        ),
        (&["check", "good.toml", "--set", "impact.angle=45 deg"], json!({"missing_key": "friction.coefficient"})),
        (&["check", "good.toml", "--set", "half_space.thickness=5 mm"], json!({"missing_key": "half_space.density"})),
        (&["check", "no-speed.toml"], json!({"key": "impact", "missing_key": "impact.speed"})),
        (&["run", "none.toml"], json!({"file": "none.toml", "exit_code": 2})),
        (&["calibrate", "good.toml", "data.csv"], json!({"line": 3, "exit_code": 2})),
        (&["run", "good.toml", "--out", "good.toml"], json!({"file": "good.toml", "exit_code": 2})),
        (&["run", "good.toml", "--no-such-option"], json!({"exit_code": 2})),
    ];
    for (arguments, want) in cases {
        let (printed, said) = desk.run_expecting(&[arguments, &["--error-format", "json"]].concat(), 2);
        assert!(printed.is_empty());
        let all = objects(said.as_bytes());
        let [said] = &all[..] else { panic!("{arguments:?}: {all:?}") };
        assert_eq!(said["level"], "error");
        assert!(said["message"].as_str().is_some_and(|message| message.len() > 10), "{said}");
        for (key, value) in want.as_object().unwrap() {
            assert_eq!(&said[key], value, "{key} of {arguments:?}: {said}");
        }
    }
    // all mistakes of a file are there
    fs::write(desk.path("two.toml"), STEEL.replace("radius =", "radus =").replace("speed =", "sped =")).unwrap();
    let output = desk.run(&["check", "two.toml", "--error-format", "json"]);
    let said = &objects(&output.stderr)[0];
    assert_eq!([&said["key"], &said["more_errors"][0]["key"]], ["sphere.radus", "impact.sped"], "{said}");
    assert_eq!(said["more_errors"].as_array().unwrap().len(), 1, "{said}");
    // the words of one argument are not an option
    let quoted = desk.run(&["run", "s.toml", "--nosuch", "x --error-format json"]);
    assert!(text(&quoted.stderr).starts_with("error: unexpected argument"), "{}", text(&quoted.stderr));
    // a file name that is not valid UTF-8
    let odd = shell(&desk, "plm-impact run $'\\xff.toml' --no-such-option --error-format=json");
    assert_eq!(odd.status.code(), Some(2), "{}", text(&odd.stderr));
    assert_eq!(objects(&odd.stderr)[0]["level"], "error");
    // fields without a value are left out
    let output = desk.run(&["check", "name.toml", "--error-format", "json"]);
    let said = &objects(&output.stderr)[0];
    assert!(["value", "allowed", "missing_key"].iter().all(|key| said.get(key).is_none()), "{said}");
    assert!(said["message"].as_str().unwrap().contains("did you mean `radius`"), "{said}");
    // warnings and notes are objects too
    let arguments = ["run", "good.toml", "--set", "impact.speed=200 m/s", "--error-format", "json"];
    let levels: Vec<Value> = objects(&desk.run(&arguments).stderr).iter().map(|said| said["level"].clone()).collect();
    assert!(levels.contains(&json!("warning")) && levels.last() == Some(&json!("note")), "{levels:?}");
}

#[test]
fn a_dash_reads_the_scenario_from_standard_input() {
    let desk = Sandbox::with(STEEL);
    let run = |arguments: &[&str], input: &str| {
        let output = desk.run_with_stdin(arguments, input);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text(&output.stderr));
        text(&output.stdout)
    };
    assert_eq!(run(&["run", "-"], STEEL), text(&desk.run(&["run", "s.toml"]).stdout));
    assert!(desk.path("plots/stdin/summary.json").exists());
    assert_eq!(run(&["check", "-"], STEEL), text(&desk.run(&["check", "s.toml"]).stdout));
    let export = |file| ["export", file, "--to", "csv", "--speed", "1 m/s"];
    let lines =
        |printed: &str| printed.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(lines(&run(&export("-"), STEEL)), lines(&text(&desk.run(&export("s.toml")).stdout)));
    assert!(
        run(&["calibrate", "-", "--restitution", "0.49", "--out", "c"], STEEL).contains("half_space.yield_strength")
    );
    // a table, and a file relative to the current directory
    let sweep = text(&desk.run(&["init", "sweep", "--out", "-"]).stdout);
    run(&["run", "-", "--out", "t"], &sweep);
    assert!(desk.path("t/table.csv").exists());
    fs::write(desk.path("flow.csv"), "plastic_strain,stress_Pa\n0,3.45e8\n0.1,5e8\n").unwrap();
    let flow = STEEL.replace("[impact]", "flow_stress.table = \"flow.csv\"\n[impact]");
    run(&["check", "-"], &flow);
    // messages name standard input
    let bad = desk.run_with_stdin(&["check", "-"], &STEEL.replace("5 mm", "5 mn"));
    assert_eq!(bad.status.code(), Some(2));
    assert!(text(&bad.stderr).starts_with("error: stdin:2:10: sphere.radius: "), "{}", text(&bad.stderr));
    let endless = desk.run_with_stdin(&["check", "-"], &"# long\n".repeat(200_000));
    assert!(text(&endless.stderr).contains("stdin: is larger than 1 MiB"), "{}", text(&endless.stderr));
}

/// Names of the commands, from the help.
fn commands() -> Vec<String> {
    let help = text(&Sandbox::with("").run(&["--help"]).stdout);
    let list = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let names = list.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    names.map(|line| line.split_whitespace().next().unwrap().to_owned()).filter(|name| name != "help").collect()
}

#[test]
fn completions_know_every_command() {
    let desk = Sandbox::with("");
    let commands = commands();
    assert!(commands.len() > 11, "{commands:?}");
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let (script, _) = desk.run_expecting(&["completions", shell], 0);
        for command in &commands {
            assert!(script.contains(command.as_str()), "{command} for {shell}");
        }
        assert!(script.contains("--error-format") || script.contains("error-format"), "{shell}");
    }
    // bash loads the completions and completes an option
    let line = "eval \"$(plm-impact completions bash)\"; COMP_WORDS=(plm-impact run --pic); COMP_CWORD=2; \
                complete -p plm-impact | sed 's/.*-F //; s/ .*//' > name; $(cat name) plm-impact --pic run; echo \"${COMPREPLY[@]}\"";
    assert_eq!(text(&shell(&desk, line).stdout).trim(), "--pictures");
}

#[test]
fn the_examples_of_every_help_run() {
    let desk = Sandbox::with("");
    // files that the examples need
    let prepared = "plm-impact init; plm-impact init sweep; mkdir -p scenarios measurements .local/share/bash-completion/completions";
    assert!(shell(&desk, prepared).status.success());
    fs::copy(concat!(env!("CARGO_MANIFEST_DIR"), "/src/contact/law/plm/coefficients.toml"), desk.path("mine.toml"))
        .unwrap();
    fs::write(desk.path("rebounds.csv"), "speed_m_per_s,restitution,restitution_sd\n1,0.62,0.02\n3,0.5,0.02\n")
        .unwrap();
    fs::copy(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference/lammps_hooke.txt"), desk.path("contact.csv"))
        .unwrap();
    let mut count = 0;
    for command in commands() {
        let help = text(&desk.run(&[&command, "--help"]).stdout);
        let examples = help.split("\nExamples:\n").nth(1).unwrap_or_else(|| panic!("{command}: {help}"));
        for example in examples.lines() {
            let example = example.trim_start();
            assert!(example.starts_with("plm-impact "), "{command}: {example}");
            // these examples measure time or need measurements: another test parses them. The tests of `validate` have its options
            if ["bench", "validate"].contains(&command.as_str()) || example.contains("measurements") {
                continue;
            }
            if example == "plm-impact init sweep" {
                fs::remove_file(desk.path("sweep.toml")).unwrap();
            }
            let output = shell(&desk, &format!("set -o pipefail; {example}"));
            assert_eq!(output.status.code(), Some(0), "{example}: {}", text(&output.stderr));
            count += 1;
        }
    }
    assert!(count > 20, "{count}");
}

#[test]
fn messages_are_coloured_on_a_terminal_alone() {
    const RED: &str = "\u{1b}[1m\u{1b}[31merror:\u{1b}[0m";
    let desk = Sandbox::with(STEEL);
    // `script` of util-linux runs a command on a terminal
    let on_terminal = |environment: &str| {
        text(
            &shell(&desk, &format!("{environment} TERM=xterm script -qec \"'{PROGRAM}' check none.toml\" /dev/null"))
                .stdout,
        )
    };
    assert!(on_terminal("").contains(RED), "{:?}", on_terminal(""));
    assert!(on_terminal("NO_COLOR=1").contains("error: none.toml"), "{:?}", on_terminal("NO_COLOR=1"));
    let piped = text(&desk.run(&["check", "none.toml"]).stderr);
    assert!(piped.starts_with("error: none.toml: "), "{piped:?}");
    // as in other tools, an environment variable can ask for colours
    let forced = text(&shell(&desk, "CLICOLOR_FORCE=1 plm-impact run s.toml --set impact.speed=200").stderr);
    assert!(forced.starts_with("\u{1b}[1m\u{1b}[33mwarning:\u{1b}[0m "), "{forced:?}");
}

#[test]
fn progress_is_shown_on_a_terminal_alone() {
    let desk = Sandbox::with("");
    desk.run_expecting(&["init", "repeat"], 0);
    // the bar is drawn at once, and so before the work ends, however fast the machine is
    let run = "run repeat.toml --set repeat.impacts=200 --pictures none";
    let line = |line: &str| shell(&desk, &format!("export PLM_IMPACT_TEST_BAR_AFTER_MS=0 TERM=xterm; {line}"));
    let piped = line(&format!("plm-impact {run}"));
    assert_eq!(piped.status.code(), Some(0), "{}", text(&piped.stderr));
    assert!(!text(&piped.stderr).contains("/200"), "{}", text(&piped.stderr));
    let shown = text(&line(&format!("script -qec \"'{PROGRAM}' {run}\" /dev/null")).stdout);
    assert!(shown.contains("/200 done"), "{shown:?}");
}
