//! The command as a process: a directory to call it in, its output and its files.

use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use plm_impact::files::progress::Progress;
use plm_impact::report::chart::PictureFormat;
use plm_impact::report::run::{Outcome, RunOptions, run};
use plm_impact::report::text::Detail;
use plm_impact::scenario::Scenario;
use serde_json::Value;
use tempfile::TempDir;

/// A directory with a scenario in it, `s.toml`.
pub struct Sandbox(TempDir);

impl Sandbox {
    pub fn with(scenario: impl AsRef<[u8]>) -> Self {
        let desk = Self(TempDir::new().unwrap());
        fs::write(desk.path("s.toml"), scenario).unwrap();
        desk
    }

    /// Writes a file, with the folders to it.
    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::create_dir_all(self.path(name).parent().unwrap()).unwrap();
        fs::write(self.path(name), content).unwrap();
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn run(&self, arguments: &[&str]) -> Output {
        run_in(self.0.path(), arguments)
    }

    /// Calls the command with a text on standard input.
    pub fn run_with_stdin(&self, arguments: &[&str], input: &str) -> Output {
        let mut command = command(self.0.path(), arguments);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().unwrap();
        // a command that refuses its arguments may end before it has read all
        let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
        child.wait_with_output().unwrap()
    }

    /// Calls the command, which has to end with this exit code; returns standard output and standard error.
    #[track_caller]
    pub fn run_expecting(&self, arguments: &[&str], code: i32) -> (String, String) {
        let output = self.run(arguments);
        let said = (text(&output.stdout), text(&output.stderr));
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said:?}");
        said
    }

    /// Runs a scenario into the folder `out`, without pictures.
    #[track_caller]
    pub fn with_results(scenario: impl AsRef<[u8]>) -> Self {
        let desk = Self::with(scenario);
        desk.run_expecting(&["run", "s.toml", "--out", "out", "--quiet", "--pictures", "none"], 0);
        desk
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// A file as JSON.
    pub fn json(&self, name: &str) -> Value {
        serde_json::from_str(&self.read(name)).unwrap()
    }

    /// `out/summary.json`.
    pub fn summary(&self) -> Value {
        self.json("out/summary.json")
    }

    /// The sorted names of the files in a directory.
    pub fn files(&self, directory: &str) -> Vec<String> {
        let entries = fs::read_dir(self.path(directory)).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned());
        let mut names: Vec<String> = names.collect();
        names.sort();
        names
    }
}

/// Says on the terminal what is not tested here and why. `.ci/run` counts such lines.
#[allow(clippy::explicit_write)] // the test runner would keep what `eprintln!` says
pub fn skip(what: &str, why: &str) {
    writeln!(io::stderr(), "!!! SKIPPED: {what}. {why} !!!").unwrap();
}

/// Runs the one impact of a scenario in memory, without pictures.
pub fn outcome(scenario: &Scenario) -> Outcome {
    let order = RunOptions {
        command: "plm-impact run",
        detail: Detail::Full,
        pictures: PictureFormat::None,
        progress: &Progress::default(),
    };
    run(scenario, Some(&order)).unwrap().unwrap()
}

/// The text of one of its files.
pub fn text_of_file(outcome: &Outcome, name: &str) -> String {
    text(&outcome.files.iter().find(|file| file.name == name).unwrap().bytes)
}

/// Calls the command in a directory.
pub fn run_in(directory: &Path, arguments: &[&str]) -> Output {
    command(directory, arguments).output().unwrap()
}

fn command(directory: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
    command.current_dir(directory).args(arguments);
    command
}

pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// A column of numbers of a CSV file by its name; an empty field is no number.
pub fn numbers(csv: &str, name: &str) -> Vec<f64> {
    column(csv, name).iter().map(|field| field.parse().unwrap_or(f64::NAN)).collect()
}

/// A column of a CSV file by its name.
pub fn column(csv: &str, name: &str) -> Vec<String> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let index = reader.headers().unwrap().iter().position(|header| header == name).unwrap_or_else(|| panic!("{name}"));
    reader.records().map(|record| record.unwrap()[index].to_owned()).collect()
}
