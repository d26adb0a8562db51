//! Limits of the machine, and numbers of threads that are too large.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::common::STEEL;

/// A scenario of 40 speeds and two strengths in its own directory.
fn scenario(directory: &Path) -> PathBuf {
    let path = directory.join("scenario.toml");
    let sweep = r#"[sweep]
"impact.speed" = { logspace = ["1 mm/s", "10 m/s"], points = 40 }
"half_space.yield_strength" = ["345 MPa", "900 MPa"]
"#;
    fs::write(&path, STEEL.to_owned() + sweep).unwrap();
    path
}

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_plm-impact"))
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Asserts exit code 2, and that standard error has all of the words.
#[track_caller]
fn refused(output: &Output, words: &[&str]) {
    let text = stderr(output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    for word in words {
        assert!(text.contains(word), "should say {word:?}:\n{text}");
    }
}

#[track_caller]
fn done(output: &Output) {
    assert_eq!(output.status.code(), Some(0), "{}", stderr(output));
}

/// Runs the program under a limit set by the shell, with a variable in the environment.
#[cfg(target_os = "linux")]
fn under(environment: &str, limit: &str, arguments: &[&str]) -> Output {
    let script = format!("ulimit {limit} && {environment} exec \"$0\" \"$@\"");
    let mut command = Command::new("sh");
    // one heap for all threads, so that mainly the stacks use memory
    command.env("MALLOC_ARENA_MAX", "1");
    command.arg("-c").arg(script).arg(env!("CARGO_BIN_EXE_plm-impact")).args(arguments).output().unwrap()
}

#[test]
fn so_many_threads_that_a_machine_stops_are_refused_from_the_environment_too() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path());
    let out = directory.path().join("out");
    let with = |threads: &str, more: &[&str]| {
        let mut command = program();
        command.arg("run").arg(&file).arg("--quiet").arg("--out").arg(&out).args(more);
        command.env("RAYON_NUM_THREADS", threads).output().unwrap()
    };
    // only slightly more than the limit, so that a missing check does not stop the machine of the test
    for threads in ["1025", "-1", "many"] {
        refused(&with(threads, &[]), &[&format!("RAYON_NUM_THREADS={threads}"), "0 to 1024"]);
        assert!(!out.join("table.csv").exists());
    }
    for threads in ["3", "0", ""] {
        done(&with(threads, &[]));
    }
    refused(&with("1", &["--threads", "100000"]), &["..=1024"]);
    // the option is used before the variable
    done(&with("1025", &["--threads", "2"]));
}

/// The stacks of the threads do not fit into the allowed memory, so the system refuses to start some of them: 200 MB are left
/// for the heap, and stacks of a gigabyte are far from that.
#[cfg(target_os = "linux")]
#[test]
fn where_fewer_threads_start_than_were_asked_for_the_way_out_is_said() {
    const STACK: u32 = 1 << 30;
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path());
    let out = directory.path().join("out");
    let limit = format!("-v {}", 2 * (STACK >> 10) + 220_000);
    let environment = format!("RUST_MIN_STACK={STACK}");
    let (file, out) = (file.to_str().unwrap(), out.to_str().unwrap());
    let arguments = ["run", file, "--out", out, "--quiet", "--pictures", "none", "--threads", "1000"];
    refused(&under(&environment, &limit, &arguments), &["does not start 1000 threads", "--threads"]);
}
