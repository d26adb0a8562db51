//! Tables in parts: kills, shards, parts that are torn or of another table. Tested with processes.

#![cfg(unix)]

mod interruptions;

use std::collections::BTreeMap;
use std::os::unix::fs::MetadataExt as _;
use std::os::unix::process::ExitStatusExt as _;
use std::process::{Child, Command, Stdio};

use crate::common::prelude::*;

const PROGRAM: &str = env!("CARGO_BIN_EXE_plm-impact");
/// Tables of these tests are small, and so are their parts.
const ROWS_PER_PART: &str = "PLM_IMPACT_TEST_ROWS_PER_PART";

/// 12 000 rows under three laws, one of which has a name with blanks.
fn grid() -> String {
    let laws = r#"law = ["plm", "jackson_green + brake", "thornton"]"#;
    let speeds = r#""impact.speed" = { logspace = ["1 mm/s", "10 m/s"], points = 4000 }"#;
    format!("{STEEL}[sweep]\n{laws}\n{speeds}\n")
}

/// 12 000 random rows, some of them without restitution.
fn random() -> String {
    let strength = r#""half_space.yield_strength" = { lognormal = { mean = "345 MPa", sd = "60 MPa" } }"#;
    // a resumed run reads the columns with statistics back
    let asked = "[output]\ncolumns = [\"peak_force_N\"]\npicture = [\"contact_time_s\"]\n";
    format!("{STEEL}[monte_carlo]\nsamples = 12000\nseed = 11\n{strength}\n{asked}")
}

/// The command on this scenario, with parts of `rows_per_part` rows.
fn run(desk: &Sandbox, out: &str, rows_per_part: Option<u32>, more: &[&str]) -> Command {
    let mut command = Command::new(PROGRAM);
    command
        .current_dir(desk.path(""))
        .args(["run", "s.toml", "--quiet", "--pictures", "none", "--out", out])
        .args(more);
    command.stdout(Stdio::null()).stderr(Stdio::piped());
    command.envs(rows_per_part.map(|rows| (ROWS_PER_PART, rows.to_string())));
    command
}

#[track_caller]
fn ends(mut command: Command, want: i32) -> String {
    let output = command.output().unwrap();
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(want), "{command:?}: {message}");
    message
}

/// The bytes of all files of a table: of the one file, or of the parts.
fn bytes(desk: &Sandbox, out: &str) -> Vec<u8> {
    let parts = desk.path(out).join("parts");
    if !parts.exists() {
        let file = |name: &str| fs::read(desk.path(out).join(name)).unwrap_or_default();
        return [file("table.csv"), file("table.parquet")].concat();
    }
    let names = desk.files(&format!("{out}/parts")).into_iter().filter(|name| !name.starts_with('.'));
    names.flat_map(|name| fs::read(parts.join(name)).unwrap()).collect()
}

/// `summary.json` without the command line.
fn summary(desk: &Sandbox, out: &str) -> serde_json::Value {
    let mut summary: serde_json::Value = serde_json::from_str(&desk.read(&format!("{out}/summary.json"))).unwrap();
    summary["provenance"].as_object_mut().unwrap().remove("command").unwrap();
    summary
}

const FORMATS: [&str; 2] = ["csv", "parquet"];

#[test]
fn threads_parts_and_shards_give_identical_tables() {
    for scenario in [grid(), random()] {
        let desk = Sandbox::with(&scenario);
        ends(run(&desk, "whole", None, &[]), 0);
        for (threads, rows) in [("1", 600), ("2", 600), ("7", 601)] {
            ends(run(&desk, threads, Some(rows), &["--threads", threads]), 0);
            assert!(bytes(&desk, threads) == bytes(&desk, "whole"), "{threads} threads");
            assert_eq!(summary(&desk, threads), summary(&desk, "whole"));
        }
        for format in FORMATS {
            let whole = format!("whole-{format}");
            ends(run(&desk, &whole, Some(600), &["--format", format]), 0);
            for (out, order) in [("a", ["0/3", "1/3", "2/3"]), ("b", ["2/3", "0/3", "1/3"])] {
                let out = format!("{out}-{format}");
                for shard in order {
                    let message = ends(run(&desk, &out, Some(600), &["--format", format, "--shard", shard]), 0);
                    assert_eq!(message, "");
                    assert!(!desk.path(&out).join("summary.json").exists());
                }
                ends(run(&desk, &out, Some(600), &["--format", format]), 0);
                assert!(bytes(&desk, &out) == bytes(&desk, &whole), "{order:?}, {format}");
                assert_eq!(summary(&desk, &out), summary(&desk, &whole));
                assert_eq!(desk.files(&out), desk.files(&whole));
            }
        }
    }
}

type Files = BTreeMap<String, Vec<u8>>;

/// The files in `out` and `out/parts`. Hidden ones are not in their places.
fn files(desk: &Sandbox) -> Files {
    let mut files = Files::new();
    for folder in ["out", "out/parts"].into_iter().filter(|folder| desk.path(folder).exists()) {
        let names = desk.files(folder).into_iter().map(|name| format!("{folder}/{name}"));
        for name in names.filter(|name| !name.contains("/.") && desk.path(name).is_file()) {
            files.insert(name.clone(), fs::read(desk.path(&name)).unwrap());
        }
    }
    files
}

/// Makes these runs one after the other, and returns the files in `out`.
fn after(desk: &Sandbox, runs: &[&[&str]]) -> Files {
    for more in runs {
        ends(run(desk, "out", Some(2), more), 0);
    }
    files(desk)
}

/// Makes these runs beside files that are there, and returns all files.
fn made(desk: &Sandbox, there: &Files, runs: &[&[&str]]) -> Files {
    drop(fs::remove_dir_all(desk.path("out")));
    for (name, bytes) in there {
        desk.write(name, bytes);
    }
    after(desk, runs)
}

/// Kills the first runs after their first change of the disk, after the second, and so on until they are through. Each time all
/// runs follow. Files that are `there` before give way; `between` are others that the runs make and remove.
fn killed_after_every_change(desk: &Sandbox, there: &Files, between: &Files, first: &[&[&str]], all: &[&[&str]]) {
    let last = made(desk, there, all);
    for change in 1.. {
        made(desk, there, &[]);
        let signal = format!("9@{change}");
        let begin =
            |more: &&[&str]| run(desk, "out", Some(2), more).env("PLM_IMPACT_TEST_SIGNAL", &signal).spawn().unwrap();
        // at the same time
        let children: Vec<Child> = first.iter().map(begin).collect();
        let ended = children.into_iter().map(|child| child.wait_with_output().unwrap().status);
        let ended: Vec<(Option<i32>, Option<i32>)> = ended.map(|status| (status.code(), status.signal())).collect();
        assert!(ended.iter().all(|ended| [(Some(0), None), (None, Some(9))].contains(ended)), "{ended:?}");
        let left = files(desk);
        for (name, bytes) in &left {
            let is_whole = [there, between, &last].into_iter().any(|files| files.get(name) == Some(bytes));
            assert!(is_whole, "{name} after change {change} of {first:?}");
        }
        // a summary says of what the files beside it are
        assert!(!left.contains_key("out/summary.json") || left == *there || left == last, "{change} of {first:?}");
        assert!(after(desk, all) == last, "after change {change} of {first:?}");
        if ended.iter().all(|(code, _)| code.is_some()) {
            assert!(change > 10, "{change} changes by {first:?}");
            return;
        }
    }
}

#[test]
fn table_survives_a_kill_at_every_disk_change() {
    let none = Files::new();
    // older results of the same file, before it was edited
    let older_results = |desk: &Sandbox, more: &[&str]| {
        let text = desk.read("s.toml");
        fs::write(desk.path("s.toml"), text.replace("5 mm", "4 mm")).unwrap();
        let older = made(desk, &none, &[more]);
        fs::write(desk.path("s.toml"), text).unwrap();
        older
    };
    let impact = Sandbox::with(STEEL);
    let older = older_results(&impact, &[]);
    killed_after_every_change(&impact, &older, &none, &[&[]], &[&[]]);
    let desk = Sandbox::with(random().replace("12000", "8"));
    for format in FORMATS.map(|format| ["--format", format]) {
        // as one file, in place of an older one
        let older = older_results(&desk, &format);
        killed_after_every_change(&desk, &older, &none, &[&format], &[&format]);
        // in four parts, of which one is there
        let [first, second, whole] = ["0/2", "1/2", "0/1"].map(|shard| [format[0], format[1], "--shard", shard]);
        let [begun, parts] =
            [made(&desk, &none, &[&[&format[..], &["--shard", "0/4"]].concat()]), made(&desk, &none, &[&whole])];
        killed_after_every_change(&desk, &begun, &parts, &[&format], &[&format]);
        // in two shards
        killed_after_every_change(&desk, &none, &parts, &[&first, &second], &[&first, &second, &format]);
    }
}
#[test]
fn a_torn_part_is_computed_anew() {
    for format in FORMATS {
        let more = ["--format", format];
        let desk = Sandbox::with(grid());
        let shard = |out: &str, set: &[&str]| {
            ends(run(&desk, out, Some(500), &[&more[..], &["--shard", "0/2"], set].concat()), 0);
        };
        let part = |out: &str, k: u32| desk.path(&format!("{out}/parts/part-{k:05}.{format}"));
        ends(run(&desk, "whole", Some(500), &more), 0);
        shard("out", &[]);
        let good = fs::read(part("out", 2)).unwrap();
        let first_lines: usize = good.split_inclusive(|byte| *byte == b'\n').take(9).map(<[u8]>::len).sum();
        for length in [good.len() - 1, good.len() - 20, good.len() / 2, first_lines, 30, 0] {
            fs::write(part("out", 2), &good[..length]).unwrap();
            shard("out", &[]);
            assert!(fs::read(part("out", 2)).unwrap() == good, "{length} bytes are left");
        }
        // parts of shards from separate disks are copied into one folder
        ends(run(&desk, "out-1", Some(500), &[&more[..], &["--shard", "1/2"]].concat()), 0);
        for name in desk.files("out-1/parts") {
            fs::rename(desk.path("out-1/parts").join(&name), desk.path("out/parts").join(&name)).unwrap();
        }
        ends(run(&desk, "out", Some(500), &more), 0);
        assert!(bytes(&desk, "out") == bytes(&desk, "whole"));
    }
}

#[test]
fn parts_of_other_table_are_refused() {
    let desk = Sandbox::with(grid());
    ends(run(&desk, "out", Some(500), &["--shard", "0/2"]), 0);
    let refused = |rows: u32, more: &[&str], wanted: &str| {
        let message = ends(run(&desk, "out", Some(rows), more), 2);
        assert!(message.contains("out/parts: these parts are") && message.contains(wanted), "{message}");
        assert!(message.contains("choose another --out, or use --force to start over"), "{message}");
    };
    refused(500, &["--set", "sphere.radius=0.004"], "its overrides is [], now [\"sphere.radius=0.004\"]");
    refused(400, &[], "its rows_per_part is 500, now 400");
    refused(500, &["--format", "parquet"], "its format is \"csv\", now \"parquet\"");
    fs::write(desk.path("s.toml"), grid().replace("345 MPa", "346 MPa")).unwrap();
    refused(500, &["--shard", "1/2"], "line 10 of its text is `yield_strength = \"345 MPa\"`, now");
    fs::write(desk.path("s.toml"), grid()).unwrap();
    let identity = desk.read("out/_table.json");
    let version = format!("\"version\": \"{}\"", env!("CARGO_PKG_VERSION"));
    for (from, to, wanted) in [
        (version.as_str(), "\"version\": \"0.0.1\"", "its version is \"0.0.1\", now"),
        ("\"numbers\": ", "\"numbers\": 7000", "its numbers is 7000"),
    ] {
        fs::write(desk.path("out/_table.json"), identity.replacen(from, to, 1)).unwrap();
        refused(500, &[], wanted);
    }
    fs::write(desk.path("out/_table.json"), "no").unwrap();
    assert!(ends(run(&desk, "out", Some(500), &[]), 2).contains("of an unknown table (_table.json cannot be read)"));
    fs::remove_file(desk.path("out/_table.json")).unwrap();
    assert!(ends(run(&desk, "out", Some(500), &[]), 2).contains("of an unknown table (_table.json is missing)"));
    ends(run(&desk, "out", Some(400), &["--force"]), 0);
    ends(run(&desk, "whole", None, &[]), 0);
    assert!(bytes(&desk, "out") == bytes(&desk, "whole"));
}

#[test]
fn a_table_that_was_put_together_is_kept() {
    let desk = Sandbox::with(random());
    ends(run(&desk, "out", Some(500), &[]), 0);
    assert_eq!(desk.files("out"), ["_table.json", "summary.json", "table.csv"]);
    let table = || fs::metadata(desk.path("out/table.csv")).unwrap().ino();
    let (made, of_first) = (table(), summary(&desk, "out"));
    // as after a kill before the summary was written
    fs::remove_file(desk.path("out/summary.json")).unwrap();
    let mut again = Command::new(PROGRAM);
    again.current_dir(desk.path("")).args(["run", "s.toml", "--out", "out", "--pictures", "none"]);
    again.env(ROWS_PER_PART, "500");
    assert!(ends(again, 0).contains("12000 rows were already computed"));
    assert_eq!((table(), summary(&desk, "out")), (made, of_first));
    // a table that lost its end is made anew
    let whole = fs::read(desk.path("out/table.csv")).unwrap();
    fs::write(desk.path("out/table.csv"), &whole[..whole.len() - 10]).unwrap();
    ends(run(&desk, "out", Some(500), &[]), 0);
    assert!(fs::read(desk.path("out/table.csv")).unwrap() == whole);
    // an edited scenario takes the place of a finished table
    let mut edited = Command::new(PROGRAM);
    fs::write(desk.path("s.toml"), random().replace("5 mm", "4 mm")).unwrap();
    edited.current_dir(desk.path("")).args(["run", "s.toml", "--out", "out"]);
    assert!(ends(edited, 0).contains("out: replaced the results of s.toml as it was"));
    assert!(fs::read(desk.path("out/table.csv")).unwrap() != whole);
    assert!(!desk.path("out/_table.json").exists());
}

#[test]
fn other_run_of_same_scenario_removes_table_files() {
    let desk = Sandbox::with(random());
    ends(run(&desk, "out", Some(500), &[]), 0);
    assert_eq!(desk.files("out"), ["_table.json", "summary.json", "table.csv"]);
    // the same file as one impact
    fs::write(desk.path("s.toml"), STEEL).unwrap();
    ends(run(&desk, "out", None, &[]), 0);
    assert_eq!(desk.files("out"), ["summary.json", "trace.csv"]);
    // parts that cost time are removed by force alone
    fs::write(desk.path("s.toml"), random()).unwrap();
    ends(run(&desk, "parts", Some(500), &["--shard", "0/2"]), 0);
    fs::write(desk.path("s.toml"), STEEL).unwrap();
    let message = ends(run(&desk, "parts", None, &[]), 2);
    assert!(message.contains("parts/parts: contains parts of a table. Choose another --out"), "{message}");
    ends(run(&desk, "parts", None, &["--force"]), 0);
    assert_eq!(desk.files("parts"), ["summary.json", "trace.csv"]);
    // a folder of another program stays
    fs::create_dir(desk.path("parts/parts")).unwrap();
    fs::write(desk.path("parts/parts/mine"), "mine").unwrap();
    ends(run(&desk, "parts", None, &["--force"]), 0);
    assert_eq!(desk.read("parts/parts/mine"), "mine");
}

#[test]
fn shards_that_cannot_be_are_refused() {
    let desk = Sandbox::with(grid());
    for (shard, wanted) in
        [("3/2", "counted from 0"), ("0/0", "must be at least 1"), ("0/1000000000", "100000"), ("x", "i/n")]
    {
        assert!(ends(run(&desk, "out", None, &["--shard", shard]), 2).contains(wanted));
    }
    assert!(
        ends(run(&desk, "out", None, &["--shard", "auto"]), 2).contains("works only in a task of a Slurm array job")
    );
    assert!(!desk.path("out").exists());
}

#[test]
fn slurm_array_task_is_a_shard() {
    let desk = Sandbox::with(grid());
    let parts = |out: &str, more: &[&str], task: Option<[&str; 4]>| {
        let mut command = run(&desk, out, Some(2000), more);
        let names = ["ID", "COUNT", "MIN", "STEP"].map(|name| format!("SLURM_ARRAY_TASK_{name}"));
        command.envs(names.into_iter().zip(task.into_iter().flatten()));
        ends(command, 0);
        desk.files(&format!("{out}/parts"))
    };
    // --array=1-3, and --array=10-20:5
    let wanted = parts("a", &["--shard", "1/3"], None);
    assert_eq!(wanted, ["part-00001.csv", "part-00004.csv"]);
    assert_eq!(parts("b", &["--shard", "auto"], Some(["2", "3", "1", "1"])), wanted);
    assert_eq!(parts("c", &["--shard", "auto"], Some(["15", "3", "10", "5"])), wanted);
}
