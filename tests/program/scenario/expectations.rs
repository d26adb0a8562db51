//! Expectations as data: scenarios, changes of them, and what the program then refuses, says or computes. One format in four files:
//! `refusals.toml`, `check_messages.toml`, `results.toml` and `value_types.toml`. The tests are in `judgements`.

mod judgements;

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::common::prelude::*;

/// A file of expectations.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Expectations {
    scene: Vec<Scene>,
    /// Values that the keys of `mistyped` are given one by one.
    #[serde(default)]
    wrong_values: Vec<String>,
    /// Words of the parser that do not occur in scenarios.
    #[serde(default)]
    parser_words: Vec<String>,
}

/// Good input, and rows of changes, each with what the program must make of the changed input.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Scene {
    about: String,
    /// The name of the file with the text that follows.
    #[serde(default = "name_of_scenarios")]
    file: String,
    #[serde(default)]
    text: String,
    /// A file of the repository whose text is the input.
    copy_of: Option<String>,
    /// These lines follow the scenario `common::STEEL`, and both are the input.
    added_to_steel: Option<String>,
    /// These lines make a whole scenario of the text.
    #[serde(default)]
    to_be_good: String,
    /// Other files in the folder, by name.
    #[serde(default)]
    beside: BTreeMap<String, String>,
    /// The arguments of the command that reads the file; without them the file is a scenario, and is checked.
    command: Option<String>,
    /// Settings in front of those of the rows. Every row is judged with each of them.
    #[serde(default)]
    with: Vec<String>,
    /// Old text, new text, and the words of the refusal. Two cells, because most places in messages are lines and columns of a text.
    #[serde(default)]
    refused: Vec<Vec<String>>,
    /// Settings, and the words of the warnings of `check`. A row without words has no warning.
    #[serde(default)]
    warned: Vec<Vec<String>>,
    /// Settings, and the words that `check` prints.
    #[serde(default)]
    shown: Vec<Vec<String>>,
    /// Settings, and what the results of a run contain.
    #[serde(default)]
    results: Vec<Vec<String>>,
    /// Settings with `@` in place of the value. Wrong values are refused without words of the parser.
    #[serde(default)]
    mistyped: Vec<String>,
}

fn name_of_scenarios() -> String {
    "s.toml".to_owned()
}

/// Changed input.
struct Change {
    text: String,
    settings: Vec<String>,
    command: Option<String>,
}

/// A row: changed input, and the words that are expected. The name is for errors.
struct Row<'a> {
    name: String,
    change: Change,
    words: &'a [String],
}

impl Expectations {
    /// Read at run time, so that a new row compiles nothing.
    fn read(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/program/scenario");
        toml::from_str(&fs::read_to_string(folder.join(name)).unwrap()).unwrap()
    }
}

/// The scenes of all files.
fn scenes() -> Vec<Scene> {
    let files = ["refusals.toml", "check_messages.toml", "results.toml", "value_types.toml"];
    files.into_iter().flat_map(|name| Expectations::read(name).scene).collect()
}

impl Scene {
    fn text(&self) -> String {
        match (&self.copy_of, &self.added_to_steel) {
            (Some(path), _) => fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap(),
            (None, Some(lines)) => STEEL.to_owned() + lines,
            (None, None) => self.text.clone(),
        }
    }

    /// The input with one place changed. Without old text the new text is added at the end. In place of old text, `--set` gives settings
    /// with ` & ` between them, and `call` gives another command.
    fn changed(&self, old: &str, new: &str) -> Change {
        let text = self.text();
        let good = Change { text: text.clone(), settings: Vec::new(), command: self.command.clone() };
        match old {
            "" => Change { text: text + new, ..good },
            "--set" => Change { settings: settings_of(new), ..good },
            "call" => Change { command: Some(new.to_owned()), ..good },
            old => {
                assert!(text.contains(old), "{}: {old} is not in the text", self.about);
                Change { text: text.replacen(old, new, 1), ..good }
            }
        }
    }

    /// A row with each of the settings `with`.
    fn with_each<'a>(&self, old: &str, new: &str, words: &'a [String]) -> Vec<Row<'a>> {
        let none = [String::new()];
        let with = if self.with.is_empty() { &none[..] } else { &self.with };
        let row = |with: &String| {
            let mut change = self.changed(old, new);
            change.settings.splice(..0, settings_of(with));
            Row { name: format!("{}, {with} {old} {new}", self.about), change, words }
        };
        with.iter().map(row).collect()
    }

    fn refused(&self) -> Vec<Row<'_>> {
        self.refused
            .iter()
            .flat_map(|row| {
                let [old, new, words @ ..] = &row[..] else { panic!("{}: {row:?}", self.about) };
                assert!(!words.is_empty(), "{}: {row:?}", self.about);
                self.with_each(old, new, words)
            })
            .collect()
    }

    /// Rows that begin with settings.
    fn with_settings<'a>(&self, rows: &'a [Vec<String>]) -> Vec<Row<'a>> {
        rows.iter().flat_map(|row| self.with_each("--set", &row[0], &row[1..])).collect()
    }

    /// A folder with the changed input and the files beside it.
    fn folder(&self, change: &Change) -> Sandbox {
        let folder = Sandbox::with("");
        fs::remove_file(folder.path("s.toml")).unwrap();
        self.beside.iter().for_each(|(name, text)| folder.write(name, text));
        folder.write(&self.file, &change.text);
        folder
    }
}

/// The settings of a cell.
fn settings_of(cell: &str) -> Vec<String> {
    cell.split(" & ").filter(|setting| !setting.is_empty()).map(str::to_owned).collect()
}

impl Change {
    fn scenario(&self, file: &str) -> Result<Scenario, Error> {
        Scenario::from_text(file, &self.text, &Override::list(&self.settings))
    }

    /// The arguments of a command with the settings.
    fn arguments<'a>(&'a self, command: &'a str) -> Vec<&'a str> {
        command.split(' ').chain(self.settings.iter().flat_map(|setting| ["--set", setting])).collect()
    }
}
