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

fn assert_says(about: &str, said: &str, entry: &[String]) {
    for words in &entry[1..] {
        if let Some(first) = words.strip_prefix('^') {
            assert!(said.starts_with(first), "{about}, {}: {first:?} is not the first of\n{said}", entry[0]);
            continue;
        }
        let (words, is_said) = words.strip_prefix('!').map_or((words.as_str(), true), |words| (words, false));
        assert_eq!(said.contains(words), is_said, "{about}, {}: {words:?} in\n{said}", entry[0]);
    }
}

#[test]
fn check_prints_exactly_the_expected_messages() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    for scene in toml::from_str::<ExpectedMessages>(include_str!("check_messages.toml")).unwrap().scene {
        let copied = scene.copy_of.map(|path| std::fs::read_to_string(root.join(path)).unwrap());
        let checked = |entry: &[String]| {
            let set: Vec<&str> = entry[0].split(" & ").filter(|setting| !setting.is_empty()).collect();
            let outcome = run::check(&read(copied.as_ref().unwrap_or(&scene.text), &set));
            outcome.unwrap_or_else(|error| panic!("{}, {}: {error}", scene.about, entry[0]))
        };
        for entry in &scene.warned {
            let warnings = checked(entry).warnings;
            assert_says(&scene.about, &warnings.join("\n"), entry);
            // an entry without words has no warning
            assert!(entry.len() > 1 || warnings.is_empty(), "{}, {}: {warnings:?}", scene.about, entry[0]);
        }
        scene.shown.iter().for_each(|entry| assert_says(&scene.about, &checked(entry).text, entry));
    }
}
