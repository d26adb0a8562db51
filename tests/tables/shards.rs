//! Shards, interruption, resuming and merging, with the command as a process.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output};
use std::time::{Duration, Instant};

use crate::common::STEEL;

const PROGRAM: &str = env!("CARGO_BIN_EXE_plm-impact");

/// A scenario of `points` speeds and two strengths, in its own directory.
fn scenario(directory: &Path, points: u32) -> PathBuf {
    let path = directory.join("scenario.toml");
    let bodies = STEEL.replace("yield_strength = \"345 MPa\"\n", "");
    let text = format!(
        r#"{bodies}[sweep]
"impact.speed" = {{ logspace = ["1 mm/s", "100 m/s"], points = {points} }}
"half_space.yield_strength" = ["345 MPa", "900 MPa"]
"#
    );
    fs::write(&path, text).unwrap();
    path
}

fn run(scenario: &Path, out: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(PROGRAM);
    command.arg("run").arg(scenario).arg("--out").arg(out).arg("--quiet").args(more);
    command
}

fn merge(from: &Path, out: &Path) -> Output {
    Command::new(PROGRAM).arg("merge").arg(from).arg("--out").arg(out).output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Starts a run and stops it after it has written a megabyte. `stop` returns whether that was before the end of the
/// run. On a busy machine the run may end earlier; then its files are removed and it is started again.
fn at_work(out: &Path, part: &Path, start: impl Fn() -> Child, stop: impl Fn(&mut Child) -> bool) {
    for _ in 0..20 {
        let mut child = start();
        let begun = Instant::now();
        while child.try_wait().unwrap().is_none() && fs::metadata(part).map_or(0, |data| data.len()) < 1_000_000 {
            assert!(begun.elapsed() < Duration::from_secs(60), "no rows after a minute");
            std::thread::sleep(Duration::from_micros(200));
        }
        if stop(&mut child) {
            return;
        }
        fs::remove_dir_all(out).unwrap();
    }
    panic!("twenty runs ended before they could be stopped");
}

#[test]
fn a_shard_killed_midway_resumes_and_the_merge_is_the_undivided_table() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), 350_000);
    let (whole, shards) = (directory.path().join("whole"), directory.path().join("shards"));
    assert!(run(&file, &whole, &[]).status().unwrap().success());

    let start = |i: u32| run(&file, &shards, &["--shard", &format!("{i}/7")]).spawn().unwrap();
    // the fourth shard alone first, so that it is surely running when it is killed
    let part = shards.join("table-3-of-7.csv.part");
    at_work(
        &shards,
        &part,
        || start(3),
        |victim| {
            victim.kill().unwrap(); // SIGKILL
            victim.wait().unwrap();
            part.exists() && !shards.join("table-3-of-7.csv").exists()
        },
    );
    // an incomplete line, as after a full disk
    let mut torn = fs::read(&part).unwrap();
    torn.extend_from_slice(b"99999,0.1,345");
    fs::write(&part, torn).unwrap();

    let others: Vec<_> = (0..7).filter(|i| *i != 3).map(start).collect();
    for mut child in others {
        assert!(child.wait().unwrap().success());
    }
    let merged = directory.path().join("merged.csv");
    let unfinished = merge(&shards, &merged);
    assert_eq!(code(&unfinished), 2);
    assert!(stderr(&unfinished).contains("table-3-of-7.csv: unfinished"), "{}", stderr(&unfinished));
    assert!(!merged.exists());

    assert!(start(3).wait().unwrap().success());
    let done = merge(&shards, &merged);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert!(fs::read(&merged).unwrap() == fs::read(whole.join("table.csv")).unwrap(), "bytes differ");
}

#[test]
fn the_table_does_not_depend_on_the_number_of_threads() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), 20_000);
    let table = |threads: &str, format: &str| {
        let out = directory.path().join(threads);
        assert!(run(&file, &out, &["--threads", threads, "--format", format]).status().unwrap().success());
        fs::read(out.join(format!("table.{format}"))).unwrap()
    };
    for format in ["csv", "json"] {
        let one = table("1", format);
        assert!(one.len() > 1_000_000);
        assert!(one == table("2", format) && one == table("5", format), "{format}");
    }
}

#[test]
fn json_shards_merge_to_one_array() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), 50);
    let (whole, shards) = (directory.path().join("whole"), directory.path().join("shards"));
    assert!(run(&file, &whole, &["--format", "json"]).status().unwrap().success());
    for i in 0..3 {
        let mut command = run(&file, &shards, &["--format", "json", "--shard-env", "TASK/3"]);
        assert!(command.env("TASK", i.to_string()).status().unwrap().success());
    }
    let merged = directory.path().join("merged.json");
    assert_eq!(code(&merge(&shards, &merged)), 0);
    let bytes = fs::read(&merged).unwrap();
    assert!(bytes == fs::read(whole.join("table.json")).unwrap());
    let rows: Vec<serde_json::Value> = serde_json::from_slice(&bytes).unwrap();
    assert_eq!(rows.len(), 100);
    assert_eq!(rows[99]["case"], 99);
    assert_eq!(rows[99]["status"], "ok");
}

/// `summary.json` of a directory, without the command line.
fn summary(directory: &Path) -> String {
    let text = fs::read_to_string(directory.join("summary.json")).unwrap();
    let rest: Vec<_> = text.lines().filter(|line| !line.trim_start().starts_with("\"command\": ")).collect();
    assert_eq!(rest.len() + 1, text.lines().count());
    rest.join("\n")
}

/// Runs a scenario undivided and in five shards, removes the files that it was read from, merges, and compares every
/// file.
fn merged_is_whole(directory: &Path, scenario: &Path, more: &[&str], pictures: &[&str]) {
    let [whole, shards, merged] = ["whole", "shards", "merged"].map(|name| directory.join(name));
    assert!(run(scenario, &whole, more).status().unwrap().success());
    for i in 0..5 {
        let shard = format!("{i}/5");
        assert!(run(scenario, &shards, &[more, &["--shard", &shard]].concat()).status().unwrap().success());
    }
    fs::remove_file(scenario).unwrap();
    let _ = fs::remove_file(directory.join("my.toml"));
    let output = merge(&shards, &merged.join("table.csv"));
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert_eq!(summary(&merged), summary(&whole));
    let names = |of: &Path| {
        let mut names: Vec<_> = fs::read_dir(of).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        names.sort();
        names
    };
    assert_eq!(names(&merged), names(&whole));
    for name in ["table.csv"].iter().chain(pictures) {
        assert!(fs::read(merged.join(name)).unwrap() == fs::read(whole.join(name)).unwrap(), "{name} differs");
        assert!(stderr(&output).contains(name), "{}", stderr(&output));
    }
}

#[test]
fn merged_shards_of_a_sweep_have_the_summary_and_pictures_of_the_undivided_run() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("scenario.toml");
    let text = format!(
        r#"{STEEL}[law.plm]
coefficients = "my.toml"
[sweep]
"impact.speed" = {{ logspace = ["1 mm/s", "100 m/s"], points = 40 }}
"sphere.radius" = {{ linspace = ["1 mm", "10 mm"], points = 30 }}
"#
    );
    fs::write(&path, text).unwrap();
    fs::write(directory.path().join("my.toml"), include_str!("../../src/law/plm/coefficients.toml")).unwrap();
    let more = ["--set", "half_space.yield_strength=500 MPa", "--set", "sphere.density=7.9 g/cm^3"];
    merged_is_whole(directory.path(), &path, &more, &["restitution.png", "restitution_map.png"]);
    // the speeds go beyond the range of the model, and both summaries have the warning
    assert!(summary(&directory.path().join("merged")).contains("impact.speed = 100 m/s"));
}

#[test]
fn merged_shards_of_random_cases_have_the_statistics_and_histogram_of_the_undivided_run() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("scenario.toml");
    let text = format!(
        r#"{STEEL}[monte_carlo]
samples = 20000
seed = 11
"half_space.yield_strength" = {{ lognormal = {{ mean = "345 MPa", sd = "60 MPa" }} }}
"sphere.poissons_ratio" = {{ normal = {{ mean = 0.45, sd = 0.1 }} }}
"#
    );
    fs::write(&path, text).unwrap();
    merged_is_whole(directory.path(), &path, &[], &["restitution_histogram.png"]);
    let merged = summary(&directory.path().join("merged"));
    assert!(merged.contains("\"quantile_95\"") && merged.contains("\"truncated_to\""), "{merged}");
}

#[test]
fn merge_refuses_shards_of_another_version_and_damaged_ones() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), 50);
    let shards = directory.path().join("shards");
    for i in 0..3 {
        assert!(run(&file, &shards, &["--shard", &format!("{i}/3")]).status().unwrap().success());
    }
    let merged = directory.path().join("merged/table.csv");
    let refused = |name: &str, change: &dyn Fn(&str) -> String, wanted: &str| {
        let path = shards.join(name);
        let text = fs::read_to_string(&path).unwrap();
        let changed = change(&text);
        assert_ne!(changed, text);
        fs::write(&path, changed).unwrap();
        let output = merge(&shards, &merged);
        assert_eq!(code(&output), 2);
        assert!(stderr(&output).contains(wanted), "{}", stderr(&output));
        assert!(!merged.exists() && !merged.with_file_name("table.csv.part").exists());
        fs::write(&path, text).unwrap();
    };
    let version = format!("\"version\": \"{}\"", env!("CARGO_PKG_VERSION"));
    let older = |text: &str| text.replace(&version, "\"version\": \"0.0.1\"");
    refused("table-1-of-3.csv.sidecar.json", &older, "table-1-of-3.csv: foreign: its version is 0.0.1");
    // a sidecar of an older version, without the scenario
    let without = |text: &str| {
        let mut fields: serde_json::Map<String, serde_json::Value> = serde_json::from_str(text).unwrap();
        assert!(fields.remove("scenario").is_some());
        serde_json::to_string(&fields).unwrap()
    };
    refused("table-2-of-3.csv.sidecar.json", &without, "table-2-of-3.csv: foreign: its sidecar");
    // a sidecar with an edited scenario
    let edited = |text: &str| text.replace("100 m/s", "200 m/s");
    refused("table-0-of-3.csv.sidecar.json", &edited, "its scenario has another hash");
    let header = |text: &str| text.replacen("restitution", "Restitution", 1);
    refused("table-2-of-3.csv", &header, "its first line is not what was written");
    assert_eq!(code(&merge(&shards, &merged)), 0);
}

#[test]
fn merge_names_missing_double_and_foreign_shards() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), 50);
    let shards = directory.path().join("shards");
    for i in [0, 2] {
        assert!(run(&file, &shards, &["--shard", &format!("{i}/4")]).status().unwrap().success());
    }
    // a shard of another scenario, and a copy of the first
    let other = ["--shard", "1/4", "--set", "impact.speed=2 m/s"];
    assert!(run(&file, &shards, &other).status().unwrap().success());
    for suffix in ["", ".sidecar.json"] {
        fs::copy(shards.join(format!("table-0-of-4.csv{suffix}")), shards.join(format!("table-copy.csv{suffix}")))
            .unwrap();
    }
    let output = merge(&shards, &directory.path().join("merged.csv"));
    assert_eq!(code(&output), 2);
    let text = stderr(&output);
    assert!(text.contains("missing: shards 1, 3 of 4"), "{text}");
    assert!(text.contains("table-copy.csv: double: shard 0"), "{text}");
    assert!(text.contains("table-1-of-4.csv: foreign: its scenario"), "{text}");
}

#[test]
fn a_merge_takes_the_place_of_no_shard_and_leaves_nothing_half_written() {
    let directory = tempfile::tempdir().unwrap();
    let (file, shards) = (scenario(directory.path(), 500), directory.path().join("shards"));
    for i in 0..2 {
        assert!(run(&file, &shards, &["--shard", &format!("{i}/2")]).status().unwrap().success());
    }
    let names = || {
        let entries = fs::read_dir(&shards).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
        entries.collect::<std::collections::BTreeSet<_>>()
    };
    let (before, second) = (names(), shards.join("table-1-of-2.csv"));
    let text = fs::read_to_string(&second).unwrap();
    for (out, why) in [
        (shards.join("table-0-of-2.csv"), "is one of the shards"),
        (shards.join("../shards/table-1-of-2.csv"), "is one of the shards"),
        (shards.join("table-1-of-2.csv.sidecar.json"), "is one of the shards"),
        (shards.join("summary.json"), "is the name of the summary"),
        (shards.clone(), "is a directory"),
    ] {
        let refused = merge(&shards, &out);
        assert_eq!(code(&refused), 2, "{}", stderr(&refused));
        assert!(
            stderr(&refused).contains(why) && stderr(&refused).contains("name another file"),
            "{}",
            stderr(&refused)
        );
    }
    // a shard that was cut off is found during the merge
    fs::write(&second, &text[..text.len() / 2]).unwrap();
    let damaged = merge(&shards, &shards.join("whole.csv"));
    assert_eq!(code(&damaged), 2);
    assert!(stderr(&damaged).contains("table-1-of-2.csv: damaged: it has"), "{}", stderr(&damaged));
    assert_eq!(names(), before);
    fs::write(&second, &text).unwrap();
    assert_eq!(code(&merge(&shards, &shards.join("whole.csv"))), 0);
}

#[test]
fn so_many_threads_that_a_machine_stops_are_refused() {
    let directory = tempfile::tempdir().unwrap();
    let out = directory.path().join("out");
    let refused = run(&scenario(directory.path(), 3), &out, &["--threads", "100000"]).output().unwrap();
    assert_eq!(code(&refused), 2);
    assert!(stderr(&refused).contains("0..=1024"), "{}", stderr(&refused));
    assert!(!out.exists());
}

#[test]
fn unfinished_rows_of_a_changed_scenario_are_refused_and_others_go_on() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), 50);
    let out = directory.path().join("out");
    assert!(run(&file, &out, &["--shard", "0/2"]).status().unwrap().success());
    // as after a kill: a part of the rows and an incomplete line
    let (table, part) = (out.join("table-0-of-2.csv"), out.join("table-0-of-2.csv.part"));
    let complete = fs::read(&table).unwrap();
    fs::write(&part, &complete[..complete.len() / 2]).unwrap();
    fs::remove_file(&table).unwrap();

    let changed = run(&file, &out, &["--shard", "0/2", "--set", "impact.speed=2 m/s"]).output().unwrap();
    assert_eq!(code(&changed), 2);
    assert!(stderr(&changed).contains("unfinished rows of another scenario"), "{}", stderr(&changed));

    assert!(run(&file, &out, &["--shard", "0/2"]).status().unwrap().success());
    assert!(fs::read(&table).unwrap() == complete && !part.exists());
    // starting a finished shard again, as a scheduler may, changes nothing
    assert!(run(&file, &out, &["--shard", "0/2"]).status().unwrap().success());
    assert!(fs::read(&table).unwrap() == complete);

    // a row with a wrong case number (blocks of 3 cases: 0 1 2, 6 7 8, ...)
    let text = String::from_utf8(complete).unwrap().replacen("\n6,", "\n66,", 1);
    fs::remove_file(&table).unwrap();
    fs::write(&part, text).unwrap();
    let damaged = run(&file, &out, &["--shard", "0/2"]).output().unwrap();
    assert_eq!(code(&damaged), 2);
    assert!(stderr(&damaged).contains("is not case 6"), "{}", stderr(&damaged));
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_130_and_a_state_to_go_on_from() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), 500_000);
    let out = directory.path().join("out");
    let part = out.join("table.csv.part");
    let start = || run(&file, &out, &[]).stderr(std::process::Stdio::piped()).spawn().unwrap();
    at_work(&out, &part, start, |child| {
        Command::new("kill").arg("-INT").arg(child.id().to_string()).output().unwrap();
        let code = child.wait().unwrap().code();
        assert!(code == Some(130) || code == Some(0) && !part.exists(), "{code:?}");
        code == Some(130)
    });
    let bytes = fs::read(&part).unwrap();
    assert_eq!(bytes.last(), Some(&b'\n'));
    // the unfinished table and its sidecar are kept; the run is not finished here
    assert!(out.join("table.csv.sidecar.json").exists());
}

#[test]
fn shards_that_do_not_exist_are_refused() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), 5);
    let refused = |more: &[&str], want: &str| {
        let output = run(&file, &directory.path().join("out"), more).output().unwrap();
        assert_eq!(code(&output), 2, "{more:?}");
        assert!(stderr(&output).contains(want), "{}", stderr(&output));
    };
    refused(&["--shard", "7/7"], "the last of 7 is 6");
    refused(&["--shard", "seven"], "write i/n");
    refused(&["--shard", "0/0"], "there are no shards of 0");
    // the message is printed once
    let output = run(&file, &directory.path().join("out"), &["--shard", "7/7"]).output().unwrap();
    assert_eq!(stderr(&output).matches("the last of 7 is 6").count(), 1, "{}", stderr(&output));
    refused(&["--shard-env", "PLM_NO_SUCH_VARIABLE/3"], "PLM_NO_SUCH_VARIABLE is not set");
}
