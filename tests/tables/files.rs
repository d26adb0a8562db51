//! Output files with two writers, killed runs, full disks, links, and files of the user. Tested with processes and
//! signals.

#![cfg(unix)]
use std::fs;
use std::os::unix::fs::{FileTypeExt as _, MetadataExt as _, symlink};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use crate::common::STEEL;
use crate::common::command::{Desk, text};

const PROGRAM: &str = env!("CARGO_BIN_EXE_plm-impact");
/// The list of the files that the program wrote.
const LIST: &str = ".plm-impact.json";

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

fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

/// Runs the command, which has to end with this code, and returns its standard error.
fn ends(desk: &Desk, arguments: &[&str], want: i32) -> String {
    let output = desk.call(arguments);
    let message = text(&output.stderr);
    assert_eq!(code(&output), Some(want), "{arguments:?}: {message}");
    message
}

/// Waits until `is_so` is true or the child ends; returns whether the child is still running.
fn is_reached(child: &mut Child, is_so: impl Fn() -> bool) -> bool {
    let begun = Instant::now();
    while !is_so() {
        assert!(begun.elapsed() < Duration::from_secs(100), "nothing after 100 s");
        if child.try_wait().unwrap().is_some() {
            return false;
        }
        std::thread::sleep(Duration::from_micros(200));
    }
    child.try_wait().unwrap().is_none()
}

fn signal(child: &Child, name: &str) {
    assert!(Command::new("kill").arg(name).arg(child.id().to_string()).status().unwrap().success());
}

fn has_rows(part: &Path) -> bool {
    fs::metadata(part).is_ok_and(|data| data.len() > 200_000)
}

#[test]
fn of_two_runs_into_one_place_the_second_is_refused_and_the_table_is_whole() {
    let whole: &[&str] = &[];
    for (format, shard, name) in
        [("csv", whole, "table.csv"), ("json", whole, "table.json"), ("csv", &["--shard", "1/2"], "table-1-of-2.csv")]
    {
        let desk = Desk::with(sweep(4000));
        let arguments = |out| [&["run", "s.toml", "--quiet", "--format", format, "--out", out], shard].concat();
        ends(&desk, &arguments("alone"), 0);
        let part = desk.path(&format!("out/{name}.part"));
        let mut refused = 0;
        // on a busy machine the first run may end before the second begins
        for _ in 0..10 {
            let mut first = start(&desk, &arguments("out"));
            if is_reached(&mut first, || has_rows(&part)) {
                let second = desk.call(&arguments("out"));
                if code(&second) == Some(2) {
                    let message = text(&second.stderr);
                    assert!(message.contains(&format!("process {}", first.id())), "{message}");
                    assert!(message.contains(", since 20") && message.contains("is writing it"), "{message}");
                    refused += 1;
                }
            }
            assert!(first.wait().unwrap().success());
            assert!(desk.read(&format!("out/{name}")) == desk.read(&format!("alone/{name}")), "{name} differs");
            assert!(!desk.path(&format!("out/{name}.lock")).exists());
            if refused > 0 {
                break;
            }
            fs::remove_dir_all(desk.path("out")).unwrap();
        }
        assert!(refused > 0);
    }
}

#[test]
fn the_file_of_a_lock_that_a_killed_run_left_blocks_nobody() {
    let desk = Desk::with(sweep(2));
    fs::create_dir(desk.path("out")).unwrap();
    fs::write(desk.path("out/table.csv.lock"), "1\n1700000000\nelsewhere\n").unwrap();
    fs::write(desk.path("out/.plm-impact.json.lock"), "").unwrap();
    ends(&desk, &["run", "s.toml", "--out", "out"], 0);
    assert_eq!(desk.files("out"), ["restitution.png", "summary.json", "table.csv"]);
}

#[test]
fn what_killed_runs_left_is_removed_by_the_next_run_of_the_same_output_alone() {
    let desk = Desk::with(sweep(2));
    fs::create_dir(desk.path("out")).unwrap();
    let stale = [".table.csv.0123456789abcdef.part", ".summary.json.00000000000000ff.part", ".summary.json.1.part"];
    let others = [".notes.csv.0123456789abcdef.part", ".table.csv.mine.part"];
    for name in stale.iter().chain(&others) {
        fs::write(desk.path("out").join(name), "x").unwrap();
    }
    ends(&desk, &["run", "s.toml", "--out", "out"], 0);
    assert!(stale.iter().all(|name| !desk.path("out").join(name).exists()), "{:?}", desk.files("out"));
    assert!(others.iter().all(|name| desk.path("out").join(name).exists()), "{:?}", desk.files("out"));
}

#[test]
fn no_link_is_followed() {
    let links = ["table.csv", "table.csv.part", "table.csv.sidecar.json", "summary.json", "restitution.png", LIST];
    for name in links {
        for is_hard in [false, true] {
            let desk = Desk::with(sweep(2));
            fs::create_dir(desk.path("out")).unwrap();
            fs::write(desk.path("mine"), "mine").unwrap();
            let (mine, link) = (desk.path("mine"), desk.path("out").join(name));
            if is_hard { fs::hard_link(&mine, &link) } else { symlink(&mine, &link) }.unwrap();
            ends(&desk, &["run", "s.toml", "--out", "out"], 2);
            // with --force a result that is a hard link is replaced, and the file under its other name is kept
            let is_result = ["table.csv", "summary.json", "restitution.png"].contains(&name);
            ends(&desk, &["run", "s.toml", "--out", "out", "--force"], if is_hard && is_result { 0 } else { 2 });
            assert_eq!(desk.read("mine"), "mine", "{name}");
        }
    }
}

#[test]
fn pipes_and_devices_are_not_replaced() {
    let desk = Desk::with(sweep(2));
    for shard in ["0/2", "1/2"] {
        ends(&desk, &["run", "s.toml", "--out", "shards", "--shard", shard], 0);
    }
    let pipe = desk.path("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let message = ends(&desk, &["merge", "shards", "--out", "pipe"], 2);
    assert!(message.contains("pipe: cannot be written: it is a device or a pipe"), "{message}");
    ends(&desk, &["merge", "shards", "--out", "pipe", "--force"], 2);
    let curves: Vec<String> =
        (1..=3).map(|i| format!("{}/src/reference/fe_loading_case{i}.csv", env!("CARGO_MANIFEST_DIR"))).collect();
    let fit = ["fit-plm", &curves[0], &curves[1], &curves[2], "-o", "pipe", "--force"];
    ends(&desk, &fit, 2);
    assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
    symlink("/dev/null", desk.path("null")).unwrap();
    ends(&desk, &["merge", "shards", "--out", "null"], 2);
    assert!(fs::symlink_metadata(desk.path("null")).unwrap().is_symlink());
    assert_eq!(desk.files(""), ["null", "pipe", "s.toml", "shards"]);
}

#[test]
fn files_of_others_are_replaced_by_force_alone() {
    let desk = Desk::with(STEEL);
    fs::create_dir(desk.path("out")).unwrap();
    fs::write(desk.path("out/trace.csv"), "mine").unwrap();
    let arguments = ["run", "s.toml", "--out", "out"];
    let message = ends(&desk, &arguments, 2);
    assert!(message.contains("out/trace.csv: exists, but not as this program wrote it"), "{message}");
    assert_eq!((desk.read("out/trace.csv"), desk.files("out")), ("mine".to_owned(), vec!["trace.csv".to_owned()]));
    ends(&desk, &["run", "s.toml", "--out", "out", "--force"], 0);
    let trace = desk.read("out/trace.csv");
    assert!(trace.starts_with("time_s,"), "{trace}");
    // files of the program are replaced, except if somebody has changed them
    ends(&desk, &arguments, 0);
    fs::write(desk.path("out/trace.csv"), trace.replacen('0', "1", 1)).unwrap();
    ends(&desk, &arguments, 2);
    assert_ne!(desk.read("out/trace.csv"), trace);
    // a table is refused before any row is computed
    let desk = Desk::with(sweep(2));
    fs::create_dir(desk.path("out")).unwrap();
    fs::write(desk.path("out/summary.json"), "mine").unwrap();
    ends(&desk, &arguments, 2);
    assert_eq!(desk.files("out"), ["summary.json"]);
    // a file of coefficients
    fs::write(desk.path("c.toml"), "mine").unwrap();
    let curve = format!("{}/src/reference/fe_loading_case1.csv", env!("CARGO_MANIFEST_DIR"));
    let message = ends(&desk, &["fit-plm", &curve, "-o", "c.toml"], 2);
    assert!(message.contains("c.toml: exists"), "{message}");
    assert_eq!(desk.read("c.toml"), "mine");
}

#[test]
fn two_scenarios_do_not_share_a_folder_in_silence() {
    let desk = Desk::with("");
    for folder in ["a", "b"] {
        fs::create_dir(desk.path(folder)).unwrap();
        fs::write(desk.path(folder).join("s.toml"), STEEL.replace("3 m/s", &format!("{} m/s", folder.len()))).unwrap();
    }
    fs::write(desk.path("b/s.toml"), STEEL).unwrap();
    ends(&desk, &["run", "a/s.toml"], 0);
    let first = desk.read("plots/s/summary.json");
    let message = ends(&desk, &["run", "b/s.toml"], 2);
    assert!(message.contains("holds results of ../../a/s.toml, and these are of ../../b/s.toml"), "{message}");
    assert_eq!(desk.read("plots/s/summary.json"), first);
    // an edited scenario, overrides, and a copy of the scenario are allowed
    ends(&desk, &["run", "a/s.toml", "--set", "impact.speed=2"], 0);
    fs::write(desk.path("a/s.toml"), STEEL.replace("3 m/s", "4 m/s")).unwrap();
    ends(&desk, &["run", "a/s.toml"], 0);
    fs::write(desk.path("b/s.toml"), STEEL.replace("3 m/s", "4 m/s")).unwrap();
    ends(&desk, &["run", "b/s.toml"], 0);
    fs::write(desk.path("a/s.toml"), STEEL).unwrap();
    ends(&desk, &["run", "a/s.toml"], 2);
    // with --force only the files of the new run are left
    fs::write(desk.path("a/s.toml"), sweep(2)).unwrap();
    ends(&desk, &["run", "a/s.toml", "--force"], 0);
    assert_eq!(desk.files("plots/s"), ["restitution.png", "summary.json", "table.csv"]);
}

#[test]
fn results_of_a_version_that_kept_no_list_are_replaced_and_it_is_said() {
    let desk = Desk::with(STEEL);
    ends(&desk, &["run", "s.toml", "--out", "out"], 0);
    fs::remove_file(desk.path("out").join(LIST)).unwrap();
    let message = ends(&desk, &["run", "s.toml", "--out", "out"], 0);
    assert!(message.contains("out: the results of an earlier version"), "{message}");
    // a file that is not a result is not replaced
    fs::remove_file(desk.path("out").join(LIST)).unwrap();
    fs::write(desk.path("out/trace.csv"), "t,F\n0,0\n").unwrap();
    ends(&desk, &["run", "s.toml", "--out", "out"], 2);
    assert_eq!(desk.read("out/trace.csv"), "t,F\n0,0\n");
}

#[test]
fn a_table_that_was_complete_is_kept_when_its_pictures_were_not_drawn() {
    for format in if cfg!(feature = "parquet") { &["csv", "json", "parquet"][..] } else { &["csv", "json"] } {
        is_kept(format);
    }
}

fn is_kept(format: &str) {
    let arguments = ["run", "s.toml", "--out", "out", "--format", format];
    let name = format!("table.{format}");
    let table = format!("out/{name}");
    for _ in 0..20 {
        let desk = Desk::with(sweep(20));
        ends(&desk, &arguments, 0);
        // an edited scenario, whose table replaces the first table
        fs::write(desk.path("s.toml"), sweep(200)).unwrap();
        let old = fs::metadata(desk.path(&table)).unwrap().ino();
        let mut child = start(&desk, &arguments);
        let is_drawing = || fs::metadata(desk.path(&table)).unwrap().ino() != old;
        let is_reached = is_reached(&mut child, is_drawing);
        child.kill().unwrap();
        child.wait().unwrap();
        if !is_reached || desk.path("out/summary.json").exists() {
            continue;
        }
        assert!(!desk.path("out/restitution_map.png").exists(), "a picture of the first table");
        let new = fs::metadata(desk.path(&table)).unwrap().ino();
        let message = ends(&desk, &arguments, 0);
        assert!(message.contains("8000 of these rows were there"), "{message}");
        assert_eq!(fs::metadata(desk.path(&table)).unwrap().ino(), new, "written again");
        assert_eq!(desk.files("out"), ["restitution.png", "restitution_map.png", "summary.json", name.as_str()]);
        assert!(desk.read("out/summary.json").contains("\"rows\": 8000"));
        return;
    }
    panic!("twenty runs ended before they could be killed");
}

/// A scenario with rows that take milliseconds each: velocity Verlet with very many steps.
fn slow(desk: &Desk) {
    let solver = "[solver]\nmethod = \"verlet\"\nsteps_per_contact = 100000\n";
    fs::write(desk.path("s.toml"), format!("{}{solver}", sweep(2000))).unwrap();
}

#[test]
fn signals_are_heard_between_slow_rows_and_each_has_its_exit_code() {
    let desk = Desk::with("");
    slow(&desk);
    let mut formats = vec!["csv", "json"];
    if cfg!(feature = "parquet") {
        formats.push("parquet");
    }
    for format in formats {
        for (name, want) in [("-INT", 130), ("-TERM", 143)] {
            let mut child = start(&desk, &["run", "s.toml", "--out", "out", "--format", format]);
            let begins = || desk.path(&format!("out/table.{format}.lock")).exists();
            assert!(is_reached(&mut child, begins));
            std::thread::sleep(Duration::from_millis(400));
            signal(&child, name);
            // all 80 000 rows would take minutes
            let begun = Instant::now();
            let output = child.wait_with_output().unwrap();
            assert_eq!(code(&output), Some(want), "{format}: {}", text(&output.stderr));
            assert!(begun.elapsed() < Duration::from_secs(20));
            assert!(text(&output.stderr).contains("interrupted"), "{}", text(&output.stderr));
        }
        if format != "parquet" {
            let rows = desk.read(&format!("out/table.{format}.part")).lines().count();
            assert!(rows > 10, "{rows}");
        }
    }
    assert!(desk.files("out").iter().all(|name| !name.starts_with(".table.parquet")), "{:?}", desk.files("out"));
}

/// A limit on the size of files acts as a full disk. Its signal is ignored, so that writing fails with an error.
#[test]
fn a_full_disk_ends_with_1_and_the_same_command_goes_on() {
    let desk = Desk::with(sweep(4000));
    ends(&desk, &["run", "s.toml", "--out", "alone"], 0);
    let script = "trap '' XFSZ; ulimit -f 2000; exec \"$0\" run s.toml --out out --quiet";
    let mut command = Command::new("bash");
    let output = command.args(["-c", script, PROGRAM]).current_dir(desk.path("")).output().unwrap();
    assert_eq!(code(&output), Some(1), "{}", text(&output.stderr));
    assert_eq!(desk.files("out"), ["table.csv.part", "table.csv.sidecar.json"]);
    assert!(ends(&desk, &["run", "s.toml", "--out", "out"], 0).contains("of these rows were there"));
    assert!(desk.read("out/table.csv") == desk.read("alone/table.csv"));
}

#[test]
fn a_file_of_somebody_else_gives_way_only_to_the_same_bytes() {
    let desk = Desk::with(STEEL);
    ends(&desk, &["run", "s.toml", "--out", "out"], 0);
    // as in a fresh clone: the picture exists, but no list says who wrote it
    fs::remove_file(desk.path("out/.plm-impact.json")).unwrap();
    fs::remove_file(desk.path("out/summary.json")).unwrap();
    fs::remove_file(desk.path("out/trace.csv")).unwrap();
    ends(&desk, &["run", "s.toml", "--out", "out"], 0);
    fs::remove_file(desk.path("out/.plm-impact.json")).unwrap();
    fs::remove_file(desk.path("out/summary.json")).unwrap();
    let said = ends(&desk, &["run", "s.toml", "--out", "out", "--set", "impact.speed=1"], 2);
    assert!(said.contains("not as this program wrote it"), "{said}");
}

#[test]
fn signals_end_other_long_work_at_once_and_nothing_is_left() {
    let desk = Desk::with("");
    ends(&desk, &["init", "repeat"], 0);
    ends(&desk, &["init", "calibrate"], 0);
    // impacts that take some milliseconds each
    let slow = ["--set", "solver.method=verlet", "--set", "solver.steps_per_contact=1000000", "--out", "out/deep"];
    let repeat = [&["run", "repeat.toml", "--set", "repeat.impacts=100000"][..], &slow].concat();
    let calibrate = [&["calibrate", "calibrate.toml", "--law", "all"][..], &slow].concat();
    let validate = vec!["validate", "--out", "out/deep"];
    for arguments in [repeat, calibrate, validate] {
        for (name, want) in [("-INT", 130), ("-TERM", 143)] {
            let mut child = start(&desk, &arguments);
            // the folder is made before the computation starts
            assert!(is_reached(&mut child, || desk.path("out/deep").exists()), "{arguments:?}");
            std::thread::sleep(Duration::from_millis(200));
            signal(&child, name);
            let begun = Instant::now();
            let output = child.wait_with_output().unwrap();
            let said = text(&output.stderr);
            assert_eq!(code(&output), Some(want), "{arguments:?}: {said}");
            assert_eq!(said, "error: interrupted; nothing was written\n");
            assert!(begun.elapsed() < Duration::from_secs(20));
            assert!(!desk.path("out").exists(), "{arguments:?}");
        }
    }
}
