//! Calibrations of given data are a table, `calibrations.toml`: scene, data, exit code, and what the summary contains. The data that
//! a test makes by itself are in the other files.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::common::prelude::*;

/// The table. Scenes, keys to find and data have names, because several calibrations have them.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    scenes: BTreeMap<String, String>,
    free: BTreeMap<String, String>,
    data: BTreeMap<String, String>,
    calibration: Vec<Calibration>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Calibration {
    about: String,
    scene: String,
    free: Option<String>,
    /// Further lines of `[calibrate]`.
    #[serde(default)]
    calibrate: String,
    /// A name, or a text.
    data: Option<String>,
    #[serde(default)]
    arguments: Vec<String>,
    #[serde(default)]
    exit: i32,
    #[serde(default)]
    summary: Vec<String>,
    /// Words on standard output, and on standard error.
    #[serde(default)]
    printed: Vec<String>,
    #[serde(default)]
    warned: Vec<String>,
    /// All files, with pictures. Without this list there are no pictures.
    files: Option<Vec<String>>,
}

/// Whether an entry of `summary` is true: a path of keys, a sign, and what is wanted.
fn is_true(summary: &Value, entry: &str) -> bool {
    let [path, sign, wanted] = entry.splitn(3, ' ').collect::<Vec<_>>()[..] else { panic!("{entry}") };
    let Some(got) = summary.pointer(&format!("/{}", path.replace('.', "/"))) else { return false };
    let number = |text: &str| text.parse::<f64>().unwrap_or_else(|_| panic!("{entry}"));
    match (sign, wanted.split_once(" within ")) {
        ("=", Some((wanted, tolerance))) => {
            got.as_f64().is_some_and(|got| relative_error(got, number(wanted)) < number(tolerance))
        }
        ("=", None) => *got == serde_json::from_str::<Value>(wanted).unwrap(),
        (">", None) => got.as_f64().is_some_and(|got| got > number(wanted)),
        ("<", None) => got.as_f64().is_some_and(|got| got < number(wanted)),
        ("has", None) => got.as_str().is_some_and(|got| match wanted.strip_prefix('^') {
            Some(first) => got.starts_with(first),
            None => got.contains(wanted),
        }),
        _ => panic!("{entry}"),
    }
}

impl Calibration {
    fn scenario(&self, table: &Table) -> String {
        let text = table.scenes[&self.scene].replace('@', env!("CARGO_MANIFEST_DIR"));
        let free = self.free.iter().map(|name| format!("free = {}\n", table.free[name]));
        let data = self.data.iter().map(|_| "data = \"d.csv\"\n".to_owned());
        let lines: String = free.chain(data).chain([self.calibrate.clone()]).collect();
        if lines.is_empty() { text } else { format!("{text}[calibrate]\n{lines}\n") }
    }

    /// The faults of its results.
    fn wrong(&self, table: &Table) -> Vec<String> {
        let folder = Sandbox::with(self.scenario(table));
        if let Some(data) = &self.data {
            folder.write("d.csv", table.data.get(data).unwrap_or(data));
        }
        let pictures = if self.files.is_some() { "svg" } else { "none" };
        let mut arguments = vec!["calibrate", "s.toml", "--out", "o", "--pictures", pictures];
        arguments.extend(self.arguments.iter().map(String::as_str));
        let output = folder.run(&arguments);
        let (printed, warned) = (text(&output.stdout), text(&output.stderr));
        let mut wrong = Vec::new();
        if output.status.code() != Some(self.exit) {
            wrong.push(format!("exit code {:?}", output.status.code()));
        }
        for (text, words) in [(&printed, &self.printed), (&warned, &self.warned)] {
            let is_wrong = |words: &&String| match words.strip_prefix('!') {
                Some(words) => text.contains(words),
                None => !text.contains(words.as_str()),
            };
            wrong.extend(words.iter().filter(is_wrong).map(|words| format!("{words:?} is wrong for {text}")));
        }
        let has_results = folder.path("o").exists();
        let files = if has_results { folder.files("o") } else { Vec::new() };
        if self.files.as_ref().is_some_and(|wanted| *wanted != files) {
            wrong.push(format!("{files:?}"));
        }
        if has_results {
            let summary = folder.json("o/summary.json");
            let is_wrong = |entry: &&String| !is_true(&summary, entry);
            wrong.extend(self.summary.iter().filter(is_wrong).map(|entry| format!("{entry} is wrong for {summary}")));
            if folder.read("o/residuals.csv").contains("NaN") {
                wrong.push("NaN in residuals.csv".to_owned());
            }
        } else if !self.summary.is_empty() {
            wrong.push("no results".to_owned());
        }
        wrong.iter().map(|wrong| format!("{}: {wrong}\n{printed}{warned}", self.about)).collect()
    }
}

fn table() -> Table {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/program/calibrate/calibrations.toml");
    toml::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// Data of the table by their name.
pub fn data(name: &str) -> String {
    table().data[name].clone()
}

#[test]
fn calibrations_give_what_the_table_says() {
    let table = table();
    let mut wrong = Vec::new();
    for calibration in &table.calibration {
        let words = [&calibration.summary, &calibration.printed, &calibration.warned].map(Vec::is_empty);
        assert!(words.contains(&false) || calibration.files.is_some(), "{}: nothing is expected", calibration.about);
        wrong.extend(calibration.wrong(&table));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
