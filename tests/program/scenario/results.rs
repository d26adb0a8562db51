//! The results of runs, as data: `results.toml`.

use serde::Deserialize;

use crate::common::prelude::*;

#[derive(Deserialize)]
struct ExpectedResults {
    scene: Vec<ExpectedRun>,
}

/// A scenario, and what its results hold under these settings.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ExpectedRun {
    about: String,
    text: String,
    /// Settings, each of which is added to those of every row.
    #[serde(default)]
    with: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// A run with these settings: what it shows, and its files.
struct RunResult {
    desk: Sandbox,
    shown: String,
}

impl RunResult {
    fn new(text: &str, settings: &[&str]) -> Self {
        let desk = Sandbox::with(text);
        let set = settings.iter().flat_map(|one| one.split(" & ")).filter(|one| !one.is_empty());
        let set: Vec<&str> = set.flat_map(|one| ["--set", one]).collect();
        let run = ["run", "s.toml", "--out", "out", "--pictures", "none"];
        let (shown, _) = desk.run_expecting(&[&run, &set[..]].concat(), 0);
        Self { desk, shown }
    }

    /// Whether a column of a file or a value of the summary is there; behind an equals sign stands what it is.
    fn contains(&self, entry: &str) -> bool {
        if let Some(words) = entry.strip_prefix("shown: ") {
            return self.shown.contains(words);
        }
        if let Some((file, name)) = entry.split_once(": ") {
            let text = self.desk.read(&format!("out/{file}"));
            return text.lines().next().unwrap().split(',').any(|column| column == name);
        }
        let (path, wanted) = entry.split_once(" = ").map_or((entry, None), |(path, value)| (path, Some(value)));
        let summary = self.desk.summary();
        let got = summary.pointer(&format!("/{}", path.replace('.', "/")));
        let Some(wanted) = wanted.map(|value| serde_json::from_str::<Value>(value).unwrap()) else {
            return got.is_some_and(|value| !value.is_null());
        };
        got.is_some_and(|got| match (got.as_f64(), wanted.as_f64()) {
            (Some(got), Some(wanted)) => (got - wanted).abs() <= 1e-12 * wanted.abs(),
            _ => *got == wanted,
        })
    }
}

#[test]
fn results_contain_exactly_what_applies() {
    for ExpectedRun { about, text, with, rows } in
        toml::from_str::<ExpectedResults>(include_str!("results.toml")).unwrap().scene
    {
        let with: Vec<&str> = if with.is_empty() { vec![""] } else { with.iter().map(String::as_str).collect() };
        for (row, with) in rows.iter().flat_map(|row| with.iter().map(move |with| (row, *with))) {
            let ran = RunResult::new(&text, &[with, &row[0]]);
            for entry in &row[1..] {
                let (entry, is_there) = entry.strip_prefix('!').map_or((entry.as_str(), true), |entry| (entry, false));
                assert_eq!(ran.contains(entry), is_there, "{about}, {with} {}: {entry}\n{}", row[0], ran.shown);
            }
        }
    }
}
