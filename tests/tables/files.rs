//! Output files beside links, pipes, files of the user, and results of other scenarios. Tested with processes and signals.

#![cfg(unix)]
use std::os::unix::fs::{FileTypeExt as _, symlink};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use crate::common::prelude::*;
use crate::signalled;

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

fn start(desk: &Desk, arguments: &[&str]) -> Child {
    let mut command = Command::new(PROGRAM);
    command.current_dir(desk.path("")).args(arguments).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
}

#[test]
fn what_runs_left_that_were_killed_an_hour_ago_is_removed_by_the_next_run_of_the_same_output() {
    let desk = Desk::with(sweep(2));
    fs::create_dir(desk.path("out")).unwrap();
    let stale = [".table.csv.0123456789abcdef.part", ".summary.json.00000000000000ff.part", ".summary.json.1.part"];
    let others = [".notes.csv.0123456789abcdef.part", ".table.csv.mine.part"];
    let young = ".table.csv.0123456789abcdee.part";
    for name in stale.iter().chain(&others).chain([&young]) {
        let file = fs::File::create(desk.path("out").join(name)).unwrap();
        let hours = if *name == young { 0 } else { 2 };
        file.set_modified(std::time::SystemTime::now() - Duration::from_secs(3600 * hours)).unwrap();
    }
    desk.ends(&["run", "s.toml", "--out", "out"], 0);
    assert!(stale.iter().all(|name| !desk.path("out").join(name).exists()), "{:?}", desk.files("out"));
    // a young one may be that of a run at work
    assert!(others.iter().chain([&young]).all(|name| desk.path("out").join(name).exists()), "{:?}", desk.files("out"));
}

#[test]
fn no_link_is_followed() {
    for name in ["table.csv", "summary.json", "restitution.png"] {
        for is_hard in [false, true] {
            let desk = Desk::with(sweep(2));
            fs::create_dir(desk.path("out")).unwrap();
            fs::write(desk.path("mine"), "mine").unwrap();
            let (mine, link) = (desk.path("mine"), desk.path("out").join(name));
            if is_hard { fs::hard_link(&mine, &link) } else { symlink(&mine, &link) }.unwrap();
            desk.ends(&["run", "s.toml", "--out", "out"], 2);
            // with --force a result that is a hard link is replaced, and the file under its other name is kept
            desk.ends(&["run", "s.toml", "--out", "out", "--force"], if is_hard { 0 } else { 2 });
            assert_eq!(desk.read("mine"), "mine", "{name}");
        }
    }
}

#[test]
fn pipes_and_devices_are_not_replaced() {
    let desk = Desk::with(sweep(2));
    fs::create_dir(desk.path("out")).unwrap();
    let pipe = desk.path("out/table.csv");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let message = desk.ends(&["run", "s.toml", "--out", "out"], 2).1;
    assert!(message.contains("table.csv: cannot be written: it is a device or a pipe"), "{message}");
    desk.ends(&["run", "s.toml", "--out", "out", "--force"], 2);
    assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
    assert_eq!(desk.files("out"), ["table.csv"]);
}

#[test]
fn files_of_others_are_replaced_by_force_alone() {
    let desk = Desk::with(STEEL);
    fs::create_dir(desk.path("out")).unwrap();
    fs::write(desk.path("out/trace.csv"), "mine").unwrap();
    let arguments = ["run", "s.toml", "--out", "out"];
    let message = desk.ends(&arguments, 2).1;
    assert!(message.contains("out/trace.csv: exists, and is no result of this program"), "{message}");
    assert_eq!((desk.read("out/trace.csv"), desk.files("out")), ("mine".to_owned(), vec!["trace.csv".to_owned()]));
    desk.ends(&["run", "s.toml", "--out", "out", "--force"], 0);
    assert!(desk.read("out/trace.csv").starts_with("time_s,"));
    // as after a kill between two files, or in a fresh clone with a picture: a file that begins with the same line gives way
    fs::remove_file(desk.path("out/summary.json")).unwrap();
    desk.ends(&arguments, 0);
    // a table is refused before any row is computed
    let desk = Desk::with(sweep(2));
    fs::create_dir(desk.path("out")).unwrap();
    fs::write(desk.path("out/summary.json"), "mine").unwrap();
    desk.ends(&arguments, 2);
    assert_eq!(desk.files("out"), ["summary.json"]);
    fs::rename(desk.path("out/summary.json"), desk.path("out/table.csv")).unwrap();
    desk.ends(&arguments, 2);
    assert_eq!(desk.read("out/table.csv"), "mine");
}

#[test]
fn two_scenarios_do_not_share_a_folder_in_silence() {
    let desk = Desk::with("");
    for folder in ["a", "b"] {
        fs::create_dir(desk.path(folder)).unwrap();
        fs::write(desk.path(folder).join("s.toml"), STEEL.replace("3 m/s", &format!("{} m/s", folder.len()))).unwrap();
    }
    fs::write(desk.path("b/s.toml"), STEEL).unwrap();
    desk.ends(&["run", "a/s.toml"], 0);
    let first = desk.read("plots/s/summary.json");
    let message = desk.ends(&["run", "b/s.toml"], 2).1;
    assert!(message.contains("holds results of a/s.toml, and these are of b/s.toml"), "{message}");
    assert_eq!(desk.read("plots/s/summary.json"), first);
    // an edited scenario, overrides, and a copy of the scenario are allowed
    let message = desk.ends(&["run", "a/s.toml", "--set", "impact.speed=2"], 0).1;
    assert!(message.contains("plots/s: replaces the results of a/s.toml as it was, or with other --set"), "{message}");
    // the same again has nothing to say, also from another folder
    let arguments = ["run", "../a/s.toml", "--set", "impact.speed=2", "--out", "../plots/s"];
    assert!(!text(&crate::common::command::call(&desk.path("b"), &arguments).stderr).contains("replaces"));
    fs::write(desk.path("a/s.toml"), STEEL.replace("3 m/s", "4 m/s")).unwrap();
    desk.ends(&["run", "a/s.toml"], 0);
    fs::write(desk.path("b/s.toml"), STEEL.replace("3 m/s", "4 m/s")).unwrap();
    desk.ends(&["run", "b/s.toml"], 0);
    fs::write(desk.path("a/s.toml"), STEEL).unwrap();
    desk.ends(&["run", "a/s.toml"], 2);
    // with --force only the files of the new run are left
    fs::write(desk.path("a/s.toml"), sweep(2)).unwrap();
    desk.ends(&["run", "a/s.toml", "--force"], 0);
    assert_eq!(desk.files("plots/s"), ["restitution.png", "summary.json", "table.csv"]);
}

#[test]
fn signals_end_other_long_work_at_once_and_nothing_is_left() {
    let desk = Desk::with("");
    desk.ends(&["init", "repeat"], 0);
    desk.ends(&["init", "calibrate"], 0);
    // impacts that take some milliseconds each, and all of them hours
    let slow = ["--set", "solver.method=verlet", "--set", "solver.steps_per_contact=1000000", "--out", "out/deep"];
    let repeat = [&["run", "repeat.toml", "--set", "repeat.impacts=100000"][..], &slow].concat();
    let calibrate = [&["calibrate", "calibrate.toml", "--law", "all"][..], &slow].concat();
    for (name, number, want) in [("-INT", 2, 130), ("-TERM", 15, 143)] {
        let is_stopped = |output: Output, arguments: &[&str]| {
            let said = text(&output.stderr);
            assert_eq!(output.status.code(), Some(want), "{arguments:?}: {said}");
            assert_eq!(said, "error: interrupted; nothing was written\n");
            assert!(!desk.path("out").exists(), "{arguments:?}");
        };
        for arguments in [&repeat, &calibrate] {
            // the folder is made when signals are listened to
            is_stopped(signalled(start(&desk, arguments), || desk.path("out/deep").exists(), name), arguments);
        }
        // a validation is short: the signal comes from the process itself, when the folder is made
        let mut command = Command::new(PROGRAM);
        command.current_dir(desk.path("")).env("PLM_IMPACT_SIGNAL", format!("{number}@1"));
        let arguments = ["validate", "--out", "out/deep"];
        is_stopped(command.args(arguments).output().unwrap(), &arguments);
    }
}
