//! Damaged shards and unfinished tables are never merged and never resumed. Tested with the command as a process.

mod limits;
mod merged;
mod resumed;
mod versions;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

use tempfile::TempDir;

use crate::common::STEEL;

/// Number of shards of every table in these tests.
const SHARDS: usize = 3;

/// A scenario of 40 speeds and two strengths in its own directory. With another modulus it gives another table with the
/// same columns.
fn scenario(directory: &Path, modulus: &str) -> PathBuf {
    let path = directory.join("scenario.toml");
    let bodies = STEEL.replace("210 GPa", modulus);
    let sweep = r#"[sweep]
"impact.speed" = { logspace = ["1 mm/s", "10 m/s"], points = 40 }
"half_space.yield_strength" = ["345 MPa", "900 MPa"]
"#;
    fs::write(&path, bodies + sweep).unwrap();
    path
}

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_plm-impact"))
}

fn run(scenario: &Path, out: &Path, more: &[&str]) -> Output {
    program().arg("run").arg(scenario).arg("--out").arg(out).arg("--quiet").args(more).output().unwrap()
}

fn merge(from: &Path, out: &Path) -> Output {
    program().arg("merge").arg(from).arg("--out").arg(out).arg("--quiet").output().unwrap()
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

/// The names of the files in a directory.
fn names(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).unwrap();
    entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

/// The name of the table of a shard.
fn name(shard: usize, format: &str) -> String {
    format!("table-{shard}-of-{SHARDS}.{format}")
}

/// The shards of two tables, in both formats.
struct Tables {
    _directory: TempDir,
    /// The directory of the shards, with the folders `csv` and `json`.
    ours: PathBuf,
    /// The directory of shards with the same columns and rows, but other values.
    others: PathBuf,
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let directory = tempfile::tempdir().unwrap();
    let make = |modulus: &str, folder: &str| {
        let file = scenario(directory.path(), modulus);
        for format in ["csv", "json"] {
            for shard in 0..SHARDS {
                let out = directory.path().join(folder).join(format);
                done(&run(&file, &out, &["--format", format, "--shard", &format!("{shard}/{SHARDS}")]));
            }
        }
        directory.path().join(folder)
    };
    let (ours, others) = (make("210 GPa", "ours"), make("70 GPa", "others"));
    Tables { _directory: directory, ours, others }
});

/// A copy of the shards of one format that a test may change.
fn copy(format: &str) -> TempDir {
    let (directory, from) = (tempfile::tempdir().unwrap(), TABLES.ours.join(format));
    for name in names(&from) {
        fs::copy(from.join(&name), directory.path().join(&name)).unwrap();
    }
    directory
}

/// Merges shards of which one is damaged. The merge has to be refused with the name of the shard and the way out, and
/// must leave no file.
#[track_caller]
fn is_refused(shards: &Path, shard: &str) {
    let out = tempfile::tempdir().unwrap();
    let output = merge(shards, &out.path().join("merged/table.out"));
    refused(&output, &[shard, "run its command"]);
    assert_eq!(names(out.path()), [""; 0], "{}", stderr(&output));
}
