//! What scenarios are refused for, as data: `refusals.toml`. Each entry is read as `plm-impact check` reads it, and the
//! message must have all its parts.

use plm_impact::run;
use plm_impact::scenario::Scenario;
use serde::Deserialize;

use crate::common::command::{Desk, text};

#[derive(Deserialize)]
struct Refusals {
    scenario: Vec<Case>,
}

/// A scenario that is good, and the changes that make it bad.
#[derive(Deserialize)]
struct Case {
    about: String,
    file: String,
    text: String,
    /// What has to be added to the text to make it a whole scenario.
    #[serde(default)]
    to_be_good: String,
    refused: Vec<Vec<String>>,
}

impl Case {
    /// The changed text, the new part of it, and the parts of the message.
    fn changed(&self) -> impl Iterator<Item = (String, &str, &[String])> {
        self.refused.iter().map(|entry| {
            let [old, new, parts @ ..] = &entry[..] else { panic!("{}: {entry:?}", self.about) };
            assert!(!parts.is_empty() && self.text.contains(old), "{}: {entry:?}", self.about);
            let changed =
                if old.is_empty() { self.text.clone() + new } else { self.text.replacen(old.as_str(), new, 1) };
            (changed, new.as_str(), parts)
        })
    }
}

fn all() -> Vec<Case> {
    toml::from_str::<Refusals>(include_str!("refusals.toml")).unwrap().scenario
}

fn refusal(file: &str, text: &str) -> Option<String> {
    match Scenario::from_text(file, text, &[]) {
        Ok(scenario) => run::check(&scenario).err().map(|error| error.to_string()),
        Err(error) => Some(error.to_string()),
    }
}

#[test]
fn every_wrong_scenario_is_refused_with_what_helps() {
    for scenario in all() {
        let good = scenario.text.clone() + &scenario.to_be_good;
        assert_eq!(refusal(&scenario.file, &good), None, "{}", scenario.about);
        for (changed, new, parts) in scenario.changed() {
            let message = refusal(&scenario.file, &changed).unwrap_or_else(|| panic!("{new} is accepted"));
            for part in parts {
                assert!(message.contains(part), "{}, {new}: {part:?} is not in\n{message}", scenario.about);
            }
            assert!(message.len() < 2000, "{new}: {} bytes of message", message.len());
        }
    }
}

/// The command says the same, with exit code 2, and writes nothing: one entry of each kind of scenario.
#[test]
fn run_and_check_refuse_what_is_refused_and_write_nothing() {
    for scenario in all() {
        let (changed, new, parts) = scenario.changed().next().unwrap();
        let desk = Desk::with("");
        std::fs::write(desk.path(&scenario.file), changed).unwrap();
        let before = desk.files("");
        for command in ["run", "check"] {
            let output = desk.call(&[command, &scenario.file]);
            let message = text(&output.stderr);
            assert_eq!(output.status.code(), Some(2), "{command}, {new}: {message}");
            assert!(output.stdout.is_empty(), "{}", text(&output.stdout));
            assert!(parts.iter().all(|part| message.contains(part)), "{command}, {new}: {message}");
            assert_eq!(desk.files(""), before, "{command}, {new}");
        }
    }
}
