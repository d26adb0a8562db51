//! The texts and warnings of `check` are data in `check_messages.toml`. A run gives the same warnings (`words/warnings.rs`).

use serde::Deserialize;

use crate::common::prelude::*;

#[derive(Deserialize)]
struct ExpectedMessages {
    scene: Vec<ExpectedCheck>,
}

/// A scenario, and what is said of it under these settings: all words of an entry, as the first those behind a `^`,
/// and none behind a `!`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ExpectedCheck {
    about: String,
    #[serde(default)]
    text: String,
    /// A file of the repository whose text it is.
    copy_of: Option<String>,
    #[serde(default)]
    warned: Vec<Vec<String>>,
    #[serde(default)]
    shown: Vec<Vec<String>>,
}

/// The error of a text according to one entry, if any.
fn wrong_words(about: &str, said: &str, entry: &[String]) -> Vec<String> {
    let wrong = |words: &String| {
        if let Some(first) = words.strip_prefix('^') {
            let problem = format!("{about}, {}: {first:?} is not the first of\n{said}", entry[0]);
            return (!said.starts_with(first)).then_some(problem);
        }
        let (words, is_said) = words.strip_prefix('!').map_or((words.as_str(), true), |words| (words, false));
        let problem =
            format!("{about}, {}: {words:?} must {}be in\n{said}", entry[0], if is_said { "" } else { "not " });
        (said.contains(words) != is_said).then_some(problem)
    };
    entry[1..].iter().filter_map(wrong).collect()
}

#[test]
fn check_prints_exactly_the_expected_messages() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut wrong = Vec::new();
    for scene in toml::from_str::<ExpectedMessages>(include_str!("check_messages.toml")).unwrap().scene {
        let copied = scene.copy_of.map(|path| std::fs::read_to_string(root.join(path)).unwrap());
        let checked = |entry: &[String]| {
            let set: Vec<&str> = entry[0].split(" & ").filter(|setting| !setting.is_empty()).collect();
            let outcome = run::check(&read(copied.as_ref().unwrap_or(&scene.text), &set));
            outcome.unwrap_or_else(|error| panic!("{}, {}: {error}", scene.about, entry[0]))
        };
        for entry in &scene.warned {
            let warnings = checked(entry).warnings;
            wrong.extend(wrong_words(&scene.about, &warnings.join("\n"), entry));
            // an entry without words has no warning
            if entry.len() == 1 && !warnings.is_empty() {
                wrong.push(format!("{}, {}: {warnings:?}", scene.about, entry[0]));
            }
        }
        wrong.extend(scene.shown.iter().flat_map(|entry| wrong_words(&scene.about, &checked(entry).text, entry)));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
