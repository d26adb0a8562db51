//! Limits of the machine, and numbers of threads that are too large.

use std::process::{Command, Output};

use crate::common::prelude::*;

/// A scenario of 40 speeds and two strengths.
const SWEEP: &str = r#"[sweep]
"impact.speed" = { logspace = ["1 mm/s", "10 m/s"], points = 40 }
"half_space.yield_strength" = ["345 MPa", "900 MPa"]
"#;
const RUN: [&str; 7] = ["run", "s.toml", "--out", "out", "--quiet", "--pictures", "none"];

/// Asserts exit code 2 and all of these words, or exit code 0 if there are none.
#[track_caller]
fn assert_ends(output: &Output, words: &[&str]) {
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(if words.is_empty() { 0 } else { 2 }), "{said}");
    assert!(words.iter().all(|word| said.contains(word)), "should say {words:?}:\n{said}");
}

#[test]
fn excessive_threads_from_environment_are_refused() {
    let desk = Sandbox::with(format!("{STEEL}{SWEEP}"));
    let with = |threads: &str, more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
        command.current_dir(desk.path("")).args(RUN).args(more).env("RAYON_NUM_THREADS", threads).output().unwrap()
    };
    // only slightly more than the limit, so that a missing check does not stop the machine of the test
    for threads in ["1025", "-1", "many"] {
        assert_ends(&with(threads, &[]), &[&format!("RAYON_NUM_THREADS={threads}"), "0 to 1024"]);
        assert!(!desk.path("out/table.csv").exists());
    }
    for threads in ["3", "0", ""] {
        assert_ends(&with(threads, &[]), &[]);
    }
    assert_ends(&with("1", &["--threads", "100000"]), &["..=1024"]);
    // the option is used before the variable
    assert_ends(&with("1025", &["--threads", "2"]), &[]);
}

/// The stacks of the threads do not fit into the allowed memory, so the system refuses to start some of them: 200 MB are left
/// for the heap, and stacks of a gigabyte are far from that. With one heap for all threads mainly the stacks use memory.
#[cfg(target_os = "linux")]
#[test]
fn thread_start_failure_suggests_fewer_threads() {
    const STACK: u32 = 1 << 30;
    let desk = Sandbox::with(format!("{STEEL}{SWEEP}"));
    let script = format!("ulimit -v {} && RUST_MIN_STACK={STACK} exec \"$0\" \"$@\"", 2 * (STACK >> 10) + 220_000);
    let mut command = Command::new("sh");
    command.env("MALLOC_ARENA_MAX", "1").current_dir(desk.path("")).args([
        "-c",
        &script,
        env!("CARGO_BIN_EXE_plm-impact"),
    ]);
    let output = command.args(RUN).args(["--threads", "1000"]).output().unwrap();
    assert_ends(&output, &["cannot start 1000 threads", "--threads"]);
}
