//! Tests of tables: rows, files, shards, interruptions, and the same bytes on every machine.

#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod files;
mod pairs;
mod parquet;
mod parts;
mod replaced;
mod reproducibility;
mod row_equals_impact;
mod thread_limits;
mod traces;

mod sweep;

use std::process::{Child, Command, Output};
use std::time::{Duration, Instant};

/// Waits until something is so, sends a running command this signal, and gives its output.
#[cfg(unix)]
fn output_after_signal(mut child: Child, is_so: impl Fn() -> bool, signal: &str) -> Output {
    wait(&mut child, is_so);
    if child.try_wait().unwrap().is_none() {
        Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    }
    wait(&mut child, || false);
    child.wait_with_output().unwrap()
}

/// Waits until something is so or the command has ended; after minutes it ends the command.
#[cfg(unix)]
fn wait(child: &mut Child, is_so: impl Fn() -> bool) {
    let begun = Instant::now();
    while !is_so() && child.try_wait().unwrap().is_none() {
        if begun.elapsed() > Duration::from_secs(600) {
            child.kill().unwrap();
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}
