//! Input that is refused, and the words of the refusal, are data in `refusals.toml`. A scenario is read as `plm-impact check` reads it; for other files
//! and for requests the command is run. The message must have all its parts, the exit code is 2, and nothing is written.

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::common::prelude::*;

#[derive(Deserialize)]
struct Refusals {
    input: Vec<Case>,
}

/// Input that is good, and the changes that make it bad.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    about: String,
    /// The name of the file that is changed.
    file: String,
    #[serde(default)]
    text: String,
    /// A file of the repository whose text is the input.
    copy_of: Option<String>,
    /// These lines make a whole scenario of the text.
    #[serde(default)]
    to_be_good: String,
    /// Files beside it, by name.
    #[serde(default)]
    beside: BTreeMap<String, String>,
    /// The arguments of the command that reads the file; without it the file is a scenario.
    command: Option<String>,
    refused: Vec<Vec<String>>,
}

/// One entry: the changed text, overrides, the arguments of the command, and the parts of the message.
struct Change<'a> {
    text: String,
    overrides: Vec<String>,
    command: Option<String>,
    parts: &'a [String],
}

impl Case {
    fn text(&self) -> String {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        self.copy_of
            .as_ref()
            .map_or_else(|| self.text.clone(), |path| std::fs::read_to_string(root.join(path)).unwrap())
    }

    fn changes(&self) -> impl Iterator<Item = Change<'_>> {
        let (text, command) = (self.text(), self.command.clone());
        self.refused.iter().map(move |entry| {
            let [old, new, parts @ ..] = &entry[..] else { panic!("{}: {entry:?}", self.about) };
            assert!(!parts.is_empty(), "{}: {entry:?}", self.about);
            let good = Change { text: text.clone(), overrides: Vec::new(), command: command.clone(), parts };
            match old.as_str() {
                "" => Change { text: text.clone() + new, ..good },
                "--set" => Change { overrides: new.split(" & ").map(str::to_owned).collect(), ..good },
                "call" => Change { command: Some(new.clone()), ..good },
                old => {
                    assert!(text.contains(old), "{}: {old} is not in the text", self.about);
                    Change { text: text.replacen(old, new, 1), ..good }
                }
            }
        })
    }

    /// A directory with this text in the file, and the files beside it.
    fn desk(&self, text: &str) -> Sandbox {
        let desk = Sandbox::with("");
        std::fs::remove_file(desk.path("s.toml")).unwrap();
        for (name, text) in
            self.beside.iter().map(|(name, text)| (name.as_str(), text.as_str())).chain([(&*self.file, text)])
        {
            std::fs::create_dir_all(desk.path(name).parent().unwrap()).unwrap();
            std::fs::write(desk.path(name), text).unwrap();
        }
        desk
    }

    /// Runs a command that has to end with code 2 and must not write, and returns what it says.
    fn message(&self, change: &Change, command: &str) -> String {
        let desk = self.desk(&change.text);
        let before = desk.files("");
        let arguments: Vec<&str> =
            command.split(' ').chain(change.overrides.iter().flat_map(|given| ["--set", given])).collect();
        let output = desk.run(&arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{command}, {:?}: {message}", change.parts);
        assert!(output.stdout.is_empty(), "{command}: {}", text(&output.stdout));
        assert_eq!(desk.files(""), before, "{command}");
        message
    }
}

fn all() -> Vec<Case> {
    toml::from_str::<Refusals>(include_str!("refusals.toml")).unwrap().input
}

fn assert_says(message: &str, parts: &[String], about: &str) {
    assert_eq!(missing_parts(message, parts, about), Vec::<String>::new());
}

/// The parts that are missing in a message.
fn missing_parts(message: &str, parts: &[String], about: &str) -> Vec<String> {
    let missing = parts.iter().filter(|part| !message.contains(*part));
    let mut wrong: Vec<String> = missing.map(|part| format!("{about}: {part:?} is not in\n{message}")).collect();
    if message.len() >= 2000 {
        wrong.push(format!("{about}, {parts:?}: {} bytes of message", message.len()));
    }
    wrong
}

fn refusal(file: &str, text: &str, overrides: &[String]) -> Option<String> {
    match Scenario::from_text(file, text, &Override::list(overrides)) {
        Ok(scenario) => run::check(&scenario).err().map(|error| error.to_string()),
        Err(error) => Some(error.to_string()),
    }
}

#[test]
fn invalid_scenarios_are_refused_with_advice() {
    let mut wrong = Vec::new();
    for case in all().iter().filter(|case| case.command.is_none()) {
        assert_eq!(refusal(&case.file, &(case.text() + &case.to_be_good), &[]), None, "{}", case.about);
        for change in case.changes() {
            let message = refusal(&case.file, &change.text, &change.overrides);
            let message = message.unwrap_or_else(|| panic!("{}, {:?}: accepted", case.about, change.parts));
            wrong.extend(missing_parts(&message, change.parts, &case.about));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

#[test]
fn wrong_request_is_refused_without_output() {
    let mut wrong = Vec::new();
    for case in all().iter().filter(|case| case.command.is_some()) {
        for change in case.changes() {
            let message = case.message(&change, change.command.as_ref().unwrap());
            wrong.extend(missing_parts(&message, change.parts, &case.about));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// The command says of a scenario what the library says: one entry of each kind.
#[test]
fn run_and_check_refuse_alike_without_output() {
    for case in all().iter().filter(|case| case.command.is_none()) {
        let change = case.changes().next().unwrap();
        for command in ["run", "check"] {
            assert_says(&case.message(&change, &format!("{command} {}", case.file)), change.parts, &case.about);
        }
    }
}
