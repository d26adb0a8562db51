//! Judges the rows of all files: one test for each kind of row.

use super::{Expectations, Row, Scene, scenes};
use crate::common::prelude::*;

/// The faults of a row: the words that are expected and not met, and those behind a `!` that are met.
fn unmet(row: &Row, got: &str, is_met: impl Fn(&str) -> bool) -> Vec<String> {
    let is_wrong = |words: &&String| match words.strip_prefix('!') {
        Some(words) => is_met(words),
        None => !is_met(words),
    };
    row.words.iter().filter(is_wrong).map(|words| format!("{}: {words:?} is wrong for\n{got}", row.name)).collect()
}

/// The faults of a text: words behind a `^` are its first.
fn wrong_words(row: &Row, got: &str) -> Vec<String> {
    unmet(row, got, |words| words.strip_prefix('^').map_or_else(|| got.contains(words), |first| got.starts_with(first)))
}

fn assert_none_wrong(wrong: &[String]) {
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

fn wrong_refusal(row: &Row, message: &str) -> Vec<String> {
    let mut wrong = wrong_words(row, message);
    if message.len() >= 2000 {
        wrong.push(format!("{}: {} bytes of message", row.name, message.len()));
    }
    wrong
}

/// Runs a command that has to end with code 2 and must not write, and returns what it says.
fn refusal_by_command(scene: &Scene, row: &Row, command: &str) -> String {
    let folder = scene.folder(&row.change);
    let before = folder.files("");
    let output = folder.run(&row.change.arguments(command));
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{command}, {}: {message}", row.name);
    assert!(output.stdout.is_empty(), "{command}, {}: {}", row.name, text(&output.stdout));
    assert_eq!(folder.files(""), before, "{command}, {}", row.name);
    message
}

#[test]
fn invalid_scenarios_are_refused_with_advice() {
    let mut wrong = Vec::new();
    for scene in scenes().iter().filter(|scene| scene.command.is_none()) {
        let refusal = |text: &str, settings: &[String]| {
            let scenario = Scenario::from_text(&scene.file, text, &Override::list(settings));
            scenario.and_then(|scenario| run::check(&scenario).map(drop)).err().map(|error| error.to_string())
        };
        let rows = scene.refused();
        if !rows.is_empty() {
            assert_eq!(refusal(&(scene.text() + &scene.to_be_good), &[]), None, "{}", scene.about);
        }
        for row in rows {
            let message = refusal(&row.change.text, &row.change.settings);
            wrong.extend(
                message
                    .map_or_else(|| vec![format!("{}: accepted", row.name)], |message| wrong_refusal(&row, &message)),
            );
        }
    }
    assert_none_wrong(&wrong);
}

#[test]
fn wrong_request_is_refused_without_output() {
    let mut wrong = Vec::new();
    for scene in scenes().iter().filter(|scene| scene.command.is_some()) {
        for row in scene.refused() {
            let message = refusal_by_command(scene, &row, row.change.command.as_ref().unwrap());
            wrong.extend(wrong_refusal(&row, &message));
        }
    }
    assert_none_wrong(&wrong);
}

/// The command says of a scenario what the library says: the first row of each scene.
#[test]
fn run_and_check_refuse_alike_without_output() {
    let mut wrong = Vec::new();
    for scene in scenes().iter().filter(|scene| scene.command.is_none()) {
        for (row, command) in scene.refused().iter().take(1).flat_map(|row| ["run", "check"].map(|name| (row, name))) {
            let message = refusal_by_command(scene, row, &format!("{command} {}", scene.file));
            wrong.extend(wrong_refusal(row, &message));
        }
    }
    assert_none_wrong(&wrong);
}

/// A run gives the same warnings (`warnings.rs`).
#[test]
fn check_prints_exactly_the_expected_messages() {
    let mut wrong = Vec::new();
    for scene in scenes() {
        let checked = |row: &Row| {
            let outcome = row.change.scenario(&scene.file).and_then(|scenario| run::check(&scenario));
            outcome.unwrap_or_else(|error| panic!("{}: {error}", row.name))
        };
        for row in scene.with_settings(&scene.warned) {
            let warnings = checked(&row).warnings;
            wrong.extend(wrong_words(&row, &warnings.join("\n")));
            if row.words.is_empty() && !warnings.is_empty() {
                wrong.push(format!("{}: {warnings:?}", row.name));
            }
        }
        for row in scene.with_settings(&scene.shown) {
            assert!(!row.words.is_empty(), "{}", row.name);
            wrong.extend(wrong_words(&row, &checked(&row).terminal_text()));
        }
    }
    assert_none_wrong(&wrong);
}

/// Whether a run contains an entry: a column of a file, words on the terminal, or a value of the summary, which may be given as JSON
/// behind an equals sign.
fn is_result(folder: &Sandbox, printed: &str, entry: &str) -> bool {
    if let Some(words) = entry.strip_prefix("shown: ") {
        return printed.contains(words);
    }
    if let Some((file, name)) = entry.split_once(": ") {
        let text = folder.read(&format!("out/{file}"));
        return text.lines().next().unwrap().split(',').any(|column| column == name);
    }
    let (path, wanted) = entry.split_once(" = ").map_or((entry, None), |(path, value)| (path, Some(value)));
    let summary = folder.summary();
    let got = summary.pointer(&format!("/{}", path.replace('.', "/")));
    let Some(wanted) = wanted.map(|value| serde_json::from_str::<Value>(value).unwrap()) else {
        return got.is_some_and(|value| !value.is_null());
    };
    got.is_some_and(|got| match (got.as_f64(), wanted.as_f64()) {
        (Some(got), Some(wanted)) => (got - wanted).abs() <= 1e-12 * wanted.abs(),
        _ => *got == wanted,
    })
}

#[test]
fn results_contain_exactly_what_applies() {
    let mut wrong = Vec::new();
    for scene in scenes() {
        for row in scene.with_settings(&scene.results) {
            assert!(!row.words.is_empty(), "{}", row.name);
            let (folder, command) =
                (scene.folder(&row.change), format!("run {} --out out --pictures none", scene.file));
            let (printed, _) = folder.run_expecting(&row.change.arguments(&command), 0);
            wrong.extend(unmet(&row, &printed, |entry| is_result(&folder, &printed, entry)));
        }
    }
    assert_none_wrong(&wrong);
}

/// Reads all parts of a scenario, without running it.
fn read_all_parts(scenario: &Scenario) -> Result<(), Error> {
    match scenario.kind()? {
        Kind::Indentation => scenario.indentation().map(drop),
        Kind::Sweep | Kind::MonteCarlo => scenario.plan().map(drop),
        Kind::Calibrate => scenario.calibration_request().map(drop),
        Kind::Impact => scenario.resolve().map(drop),
        Kind::Repeat => scenario.resolve().and_then(|scene| scenario.series(&scene)).map(drop),
    }
}

/// A refusal of a value of a wrong type uses the words of a scenario, and not those of the parser.
#[test]
fn no_word_of_the_parser_reaches_a_user() {
    let Expectations { scene: scenes, wrong_values, parser_words } = Expectations::read("value_types.toml");
    let mut refused = 0;
    for (scene, key) in scenes.iter().flat_map(|scene| scene.mistyped.iter().map(move |key| (scene, key))) {
        let mut of_key = 0;
        for value in &wrong_values {
            let change = key.replace('@', value);
            for row in scene.with_each("--set", &change, &[]) {
                let read = row.change.scenario(&scene.file).and_then(|scenario| read_all_parts(&scenario));
                let Err(error) = read else { continue };
                of_key += 1;
                // the quoted input does not count as a word of the parser
                let own = error.to_string().replace(&change, "");
                let word = parser_words.iter().find(|word| own.contains(word.as_str()));
                assert_eq!(word, None, "{change}: {error}");
            }
        }
        assert!(of_key >= 5, "{key}: only {of_key} of {} refused", wrong_values.len());
        refused += of_key;
    }
    assert!(refused > 1000, "{refused}");
}
