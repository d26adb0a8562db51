//! Output files beside links, pipes, files of the user, and results of other scenarios. Tested with processes and signals.

#![cfg(unix)]
use std::os::unix::fs::{FileTypeExt as _, symlink};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use crate::common::prelude::*;
use crate::output_after_signal;

const PROGRAM: &str = env!("CARGO_BIN_EXE_plm-impact");
/// Two axes of numbers, so that there are two pictures.
fn sweep(points: u32) -> String {
    format!(
        r#"{STEEL}[sweep]
"impact.speed" = {{ logspace = ["1 mm/s", "100 m/s"], points = {points} }}
"sphere.radius" = {{ linspace = ["1 mm", "10 mm"], points = 40 }}
"#
    )
}

fn start(desk: &Sandbox, arguments: &[&str]) -> Child {
    let mut command = Command::new(PROGRAM);
    command.current_dir(desk.path("")).args(arguments).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

#[test]
fn stale_temporary_files_are_removed() {
    let desk = Sandbox::with(sweep(2));
    fs::create_dir(desk.path("out")).unwrap();
    let stale = [".table.csv.0123456789abcdef.part", ".summary.json.00000000000000ff.part", ".summary.json.1.part"];
    let others = [".notes.csv.0123456789abcdef.part", ".table.csv.mine.part"];
    let young = ".table.csv.0123456789abcdee.part";
    for name in stale.iter().chain(&others).chain([&young]) {
        let file = fs::File::create(desk.path("out").join(name)).unwrap();
        let hours = if *name == young { 0 } else { 2 };
        file.set_modified(std::time::SystemTime::now() - Duration::from_secs(3600 * hours)).unwrap();
    }
    desk.run_expecting(&["run", "s.toml", "--out", "out"], 0);
    assert!(stale.iter().all(|name| !desk.path("out").join(name).exists()), "{:?}", desk.files("out"));
    // a young one may be that of a run at work
    assert!(others.iter().chain([&young]).all(|name| desk.path("out").join(name).exists()), "{:?}", desk.files("out"));
}

#[test]
fn no_link_is_followed() {
    for name in ["table.csv", "summary.json", "restitution.png"] {
        for is_hard in [false, true] {
            let desk = Sandbox::with(sweep(2));
            fs::create_dir(desk.path("out")).unwrap();
            fs::write(desk.path("mine"), "mine").unwrap();
            let (mine, link) = (desk.path("mine"), desk.path("out").join(name));
            if is_hard { fs::hard_link(&mine, &link) } else { symlink(&mine, &link) }.unwrap();
            // only a link in the place of a picture needs pictures
            let pictures = ["--pictures", if name.ends_with("png") { "png" } else { "none" }];
            let run = [&["run", "s.toml", "--out", "out"][..], &pictures].concat();
            desk.run_expecting(&run, 2);
            // with --force a result that is a hard link is replaced, and the file under its other name is kept
            desk.run_expecting(&[&run[..], &["--force"]].concat(), if is_hard { 0 } else { 2 });
            assert_eq!(desk.read("mine"), "mine", "{name}");
        }
    }
}

#[test]
fn pipes_and_devices_are_not_replaced() {
    let desk = Sandbox::with(sweep(2));
    fs::create_dir(desk.path("out")).unwrap();
    let pipe = desk.path("out/table.csv");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let message = desk.run_expecting(&["run", "s.toml", "--out", "out"], 2).1;
    assert!(message.contains("table.csv: cannot be written: it is a device or a pipe"), "{message}");
    desk.run_expecting(&["run", "s.toml", "--out", "out", "--force"], 2);
    assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
    assert_eq!(desk.files("out"), ["table.csv"]);
}

#[test]
fn files_of_others_are_replaced_by_force_alone() {
    let desk = Sandbox::with(STEEL);
    fs::create_dir(desk.path("out")).unwrap();
    fs::write(desk.path("out/trace.csv"), "mine").unwrap();
    let arguments = ["run", "s.toml", "--out", "out", "--pictures", "svg"];
    let message = desk.run_expecting(&arguments, 2).1;
    assert!(message.contains("out/trace.csv: already exists and was not written by this program"), "{message}");
    assert_eq!((desk.read("out/trace.csv"), desk.files("out")), ("mine".to_owned(), vec!["trace.csv".to_owned()]));
    desk.run_expecting(&[&arguments[..], &["--force"]].concat(), 0);
    assert!(desk.read("out/trace.csv").starts_with("time_s,"));
    // as after a kill between two files, or in a fresh clone with a picture: a file that begins with the same line gives way
    fs::remove_file(desk.path("out/summary.json")).unwrap();
    desk.run_expecting(&arguments, 0);
    // a table is refused before any row is computed
    let desk = Sandbox::with(sweep(2));
    fs::create_dir(desk.path("out")).unwrap();
    fs::write(desk.path("out/summary.json"), "mine").unwrap();
    desk.run_expecting(&arguments, 2);
    assert_eq!(desk.files("out"), ["summary.json"]);
    fs::rename(desk.path("out/summary.json"), desk.path("out/table.csv")).unwrap();
    desk.run_expecting(&arguments, 2);
    assert_eq!(desk.read("out/table.csv"), "mine");
}

#[test]
fn scenarios_share_a_folder_only_with_notice() {
    let desk = Sandbox::with("");
    for folder in ["a", "b"] {
        fs::create_dir(desk.path(folder)).unwrap();
        fs::write(desk.path(folder).join("s.toml"), STEEL.replace("3 m/s", &format!("{} m/s", folder.len()))).unwrap();
    }
    fs::write(desk.path("b/s.toml"), STEEL).unwrap();
    desk.run_expecting(&["run", "a/s.toml", "--pictures", "svg"], 0);
    let first = desk.read("plots/s/summary.json");
    let message = desk.run_expecting(&["run", "b/s.toml"], 2).1;
    assert!(message.contains("contains results of a/s.toml; the current scenario is b/s.toml"), "{message}");
    assert_eq!(desk.read("plots/s/summary.json"), first);
    // an edited scenario and a copy of the scenario are allowed
    fs::write(desk.path("a/s.toml"), STEEL.replace("3 m/s", "2 m/s")).unwrap();
    let message = desk.run_expecting(&["run", "a/s.toml", "--pictures", "svg"], 0).1;
    assert!(message.contains("plots/s: replaced the results of a/s.toml as it was"), "{message}");
    // the same again has nothing to say, also from another folder
    let arguments = ["run", "../a/s.toml", "--out", "../plots/s", "--pictures", "svg"];
    assert!(!text(&crate::common::command::run_in(&desk.path("b"), &arguments).stderr).contains("replaced"));
    fs::write(desk.path("a/s.toml"), STEEL.replace("3 m/s", "4 m/s")).unwrap();
    desk.run_expecting(&["run", "a/s.toml", "--pictures", "svg"], 0);
    fs::write(desk.path("b/s.toml"), STEEL.replace("3 m/s", "4 m/s")).unwrap();
    desk.run_expecting(&["run", "b/s.toml", "--pictures", "svg"], 0);
    fs::write(desk.path("a/s.toml"), STEEL).unwrap();
    desk.run_expecting(&["run", "a/s.toml"], 2);
    // with --force only the files of the new run are left
    fs::write(desk.path("a/s.toml"), sweep(2)).unwrap();
    desk.run_expecting(&["run", "a/s.toml", "--force"], 0);
    assert_eq!(desk.files("plots/s"), ["restitution.png", "summary.json", "table.csv"]);
}

#[test]
fn results_of_other_file_stay_for_any_path() {
    let desk = Sandbox::with("");
    for (number, name) in (1..).zip(["case.toml", "a/case.toml", "b/case.toml"]) {
        desk.write(name, STEEL.replace("3 m/s", &format!("{number} m/s")));
    }
    let run = |folder: &str, file: &str, out: &str| {
        let output =
            crate::common::command::run_in(&desk.path(folder), &["run", file, "--out", out, "--pictures", "none"]);
        (output.status.code(), text(&output.stderr))
    };
    // a bare name is the end of every path to a file of that name
    for (out, [one, other]) in [("x", ["case.toml", "b/case.toml"]), ("y", ["b/case.toml", "case.toml"])] {
        assert_eq!(run("", one, out).0, Some(0));
        let there = desk.read(&format!("{out}/summary.json"));
        let (code, said) = run("", other, out);
        assert!(
            code == Some(2) && said.contains(&format!("contains results of {one}; the current scenario is {other}")),
            "{said}"
        );
        assert_eq!(desk.read(&format!("{out}/summary.json")), there);
    }
    // the same words in two folders are two files, and one file may have two names
    assert_eq!(run("a", "case.toml", "../z").0, Some(0));
    assert_eq!(run("b", "case.toml", "../z").0, Some(2));
    desk.write("a/case.toml", STEEL.replace("3 m/s", "4 m/s"));
    let (code, said) = run("", "b/../a/./case.toml", "z");
    assert!(code == Some(0) && said.contains("z: replaced the results of case.toml as it was"), "{said}");
    // a summary names no path of this machine, and results and scenario know each other where both are moved together
    assert_eq!(desk.json("z/summary.json")["provenance"]["scenario_path"], "../a/case.toml");
    fs::create_dir(desk.path("moved")).unwrap();
    for name in ["a", "z"] {
        fs::rename(desk.path(name), desk.path("moved").join(name)).unwrap();
    }
    desk.write("moved/a/case.toml", STEEL.replace("3 m/s", "5 m/s"));
    assert_eq!(run("moved/z", "../a/case.toml", ".").0, Some(0));
    // a text from standard input is of no file
    let piped = |speed: &str| {
        desk.run_with_stdin(&["run", "-", "--out", "w", "--pictures", "none"], &STEEL.replace("3 m/s", speed))
            .status
            .code()
    };
    assert_eq!([piped("1 m/s"), piped("1 m/s"), piped("2 m/s")], [Some(0), Some(0), Some(2)]);
}

#[test]
fn results_folder_has_only_listed_files() {
    let desk = Sandbox::with(STEEL);
    desk.write("other.toml", STEEL);
    desk.write("d.csv", "speed_m_per_s,restitution\n1,0.6\n2,0.53\n3,0.49\n");
    let calibrate = ["calibrate", "s.toml", "d.csv", "--out", "o", "--pictures", "png"];
    let listed = || {
        let summary = desk.json("o/summary.json");
        let names = summary["provenance"]["files"].as_array().unwrap().iter();
        let mut names: Vec<String> = names.map(|name| name.as_str().unwrap().to_owned()).collect();
        names.push("summary.json".to_owned());
        names.sort();
        names
    };
    desk.run_expecting(&[&calibrate[..], &["--all-laws"]].concat(), 0);
    assert!(desk.files("o").contains(&"laws.png".to_owned()) && desk.files("o") == listed());
    // other options, another kind of scene by force, another format, another kind again
    let sweep = "sweep={\"impact.speed\"=[1,2]}";
    let repeat = "repeat={impacts=2,spot=\"same\"}";
    let run = ["run", "other.toml", "--out", "o"];
    let svg = ["run", "other.toml", "--out", "o", "--pictures", "svg"];
    for arguments in [
        [&calibrate[..], &["--force"]].concat(),
        [&run[..], &["--force"]].concat(),
        svg.to_vec(),
        [&svg[..], &["--set", sweep, "--force"]].concat(),
        [&run[..], &["--set", sweep, "--pictures", "none"]].concat(),
        [&svg[..], &["--set", repeat, "--force"]].concat(),
        [&svg[..], &["--force"]].concat(),
    ] {
        desk.run_expecting(&arguments, 0);
        assert_eq!(desk.files("o"), listed(), "{arguments:?}");
    }
    // files of others stay, also if a summary lists them by a path that leaves the folder
    desk.write("mine.png", "mine");
    desk.write("o/mine.txt", "mine");
    let summary = desk.read("o/summary.json").replace("\"history.svg\"", "\"../mine.png\", \"history.svg\"");
    assert!(summary.contains("../mine.png"));
    desk.write("o/summary.json", summary);
    desk.run_expecting(&[&svg[..], &["--set", sweep, "--force"]].concat(), 0);
    assert_eq!((desk.read("mine.png"), desk.read("o/mine.txt")), ("mine".to_owned(), "mine".to_owned()));
}

#[test]
fn signals_stop_other_long_work_without_leftovers() {
    let desk = Sandbox::with("");
    desk.run_expecting(&["init", "repeat"], 0);
    desk.run_expecting(&["init", "calibrate"], 0);
    // impacts that take some milliseconds each, and all of them hours
    let slow = ["--set", "solver.method=verlet", "--set", "solver.steps_per_contact=1000000", "--out", "out/deep"];
    let repeat = [&["run", "repeat.toml", "--set", "repeat.impacts=100000"][..], &slow].concat();
    let calibrate = [&["calibrate", "calibrate.toml", "--all-laws"][..], &slow].concat();
    let is_stopped = |output: Output, want: i32, arguments: &[&str]| {
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(want), "{arguments:?}: {said}");
        assert!(said.ends_with("error: interrupted; no files were written\n"), "{arguments:?}: {said}");
        // the bench says before what it measures
        assert!(arguments[0] == "bench" || said.lines().count() == 1, "{arguments:?}: {said}");
        assert!(!desk.path("out").exists(), "{arguments:?}");
    };
    for (name, number, want) in [("-INT", 2, 130), ("-TERM", 15, 143)] {
        for arguments in [&repeat, &calibrate] {
            // the folder is made when signals are listened to
            let output = output_after_signal(start(&desk, arguments), || desk.path("out/deep").exists(), name);
            is_stopped(output, want, arguments);
        }
        // these are short: the signal comes from the process itself, when the folder is made
        for arguments in [&["validate", "--out", "out/deep"][..], &["bench", "--quick", "--out", "out/deep"]] {
            let mut command = Command::new(PROGRAM);
            command.current_dir(desk.path("")).env("PLM_IMPACT_TEST_SIGNAL", format!("{number}@1")).args(arguments);
            is_stopped(command.output().unwrap(), want, arguments);
        }
    }
}

#[test]
fn signal_in_second_file_ends_the_command() {
    let desk = Sandbox::with(STEEL);
    desk.write("big.toml", sweep(2_000_000));
    desk.write("third.toml", STEEL);
    let child = start(&desk, &["run", "s.toml", "big.toml", "third.toml", "--pictures", "none"]);
    let is_part = |name: &String| name.starts_with("part-");
    let is_at_work = || desk.path("plots/big/parts").exists() && desk.files("plots/big/parts").iter().any(is_part);
    let output = output_after_signal(child, is_at_work, "-INT");
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.contains("interrupted after") && said.contains("Run the same command again"), "{said}");
    assert!(!desk.files("plots/big/parts").iter().any(|name| name.starts_with('.')));
    // the third is not begun
    assert!(!desk.path("plots/third").exists());
}
