//! Limits of the machine, and numbers of shards and threads that are too large.

use std::fs;
use std::process::{Command, Output};

use super::{done, program, refused, run, scenario, stderr};

/// Runs the program under a limit set by the shell.
#[cfg(unix)]
fn under(limit: &str, arguments: &[&str]) -> Output {
    under_with("", limit, arguments)
}

/// The same with a variable in the environment.
#[cfg(unix)]
fn under_with(environment: &str, limit: &str, arguments: &[&str]) -> Output {
    let script = format!("ulimit {limit} && {environment} exec \"$0\" \"$@\"");
    let mut command = Command::new("sh");
    // one heap for all threads, so that mainly the stacks use memory
    command.env("MALLOC_ARENA_MAX", "1");
    command.arg("-c").arg(script).arg(env!("CARGO_BIN_EXE_plm-impact")).args(arguments).output().unwrap()
}

#[cfg(unix)]
#[test]
fn more_shards_than_files_that_may_be_open_are_merged() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), "210 GPa");
    let [whole, shards, merged] = ["whole", "shards", "merged"].map(|name| directory.path().join(name));
    done(&run(&file, &whole, &[]));
    for shard in 0..40 {
        done(&run(&file, &shards, &["--shard", &format!("{shard}/40")]));
    }
    let out = merged.join("table.csv");
    let output = under("-n 16", &["merge", shards.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    done(&output);
    assert!(fs::read(out).unwrap() == fs::read(whole.join("table.csv")).unwrap());
}

#[test]
fn more_shards_than_any_array_has_are_refused() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), "210 GPa");
    let out = directory.path().join("out");
    refused(&run(&file, &out, &["--shard", "0/1000000000"]), &["1000000000", "100000"]);
    // with the largest number of shards, merge lists all missing ones in one line
    done(&run(&file, &out, &["--shard", "7/100000"]));
    let output = super::merge(&out, &directory.path().join("merged.csv"));
    refused(&output, &["missing: shards 0-6, 8-99999 of 100000"]);
}

#[test]
fn so_many_threads_that_a_machine_stops_are_refused_from_the_environment_too() {
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), "210 GPa");
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
    // the option is used before the variable
    done(&with("1025", &["--threads", "2"]));
}

/// The stacks of the threads do not fit into the allowed memory, so the system refuses to start some of them. A stack is
/// so large, and the limit so far above a whole number of stacks, that the memory ends at a stack, and never on the heap
/// or inside the start of a thread, where the standard library ends the program: 200 MB are left for these.
#[cfg(target_os = "linux")]
#[test]
fn where_fewer_threads_start_than_were_asked_for_the_table_is_made_with_those() {
    const STACK: u32 = 256 << 20;
    let directory = tempfile::tempdir().unwrap();
    let file = scenario(directory.path(), "210 GPa");
    let [whole, few] = ["whole", "few"].map(|name| directory.path().join(name));
    done(&run(&file, &whole, &[]));
    let out = few.to_str().unwrap();
    let limit = format!("-v {}", 6 * (STACK >> 10) + 220_000);
    let environment = format!("RUST_MIN_STACK={STACK}");
    let arguments = ["run", file.to_str().unwrap(), "--out", out, "--quiet", "--shard", "0/1", "--threads", "1000"];
    let output = under_with(&environment, &limit, &arguments);
    done(&output);
    let text = stderr(&output);
    assert_eq!(text.matches("of 1000 threads").count(), 1, "{text}");
    assert!(fs::read(few.join("table-0-of-1.csv")).unwrap() == fs::read(whole.join("table.csv")).unwrap());
}
