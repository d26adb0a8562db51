//! Descriptions of the keys for the command `keys`, the reference page and messages.

use std::fmt::Write as _;

use super::input::read_input::{POINT, pair_example};
use super::input::{Key, varied};
use super::keys::{AnyKey, EVERY_KEY, Form, Quantity, Words};
use super::toml_node::pattern;
use crate::results::impact::impact_results;

/// Describes the keys whose paths hold this text; `None` if no path holds it.
pub fn about_keys(text: &str) -> Option<String> {
    let known: Vec<&AnyKey> = EVERY_KEY.iter().collect();
    let exact: Vec<&AnyKey> = known.iter().copied().filter(|key| key.path == text).collect();
    let some = known.into_iter().filter(|key| key.path.contains(text)).collect();
    let found = if exact.is_empty() { some } else { exact };
    let mut all = String::new();
    for AnyKey { path, form, default, about, .. } in &found {
        let _ = writeln!(all, "{path}\n  {about}\n  value: {}", in_plain_text(form));
        if !default.is_empty() {
            let _ = writeln!(all, "  default: {default}");
        }
        if Key::find(path).is_some() {
            let _ = writeln!(all, "  may be an axis of [sweep] or random in [monte_carlo]");
        }
    }
    (!found.is_empty()).then_some(all)
}

/// The meaning of a result of an impact; `None` if no result has this name.
pub fn about_result(name: &str) -> Option<&'static str> {
    impact_results().into_iter().find(|result| result.name == name).map(|result| result.description)
}

/// A key with more words refers to a table of its words.
const MOST_WORDS: usize = 20;

/// The values that a key may have, as Markdown.
pub fn written(form: &Form) -> String {
    let number = |quantity: &Quantity| format!("{} {}", quantity.name, quantity.allowed());
    match form {
        Form::Number(quantity) => number(quantity),
        Form::NumberOr(quantity, word) => format!("{}, or `\"{word}\"`", number(quantity)),
        Form::Count(quantity) => format!("a whole number {}", quantity.allowed()),
        Form::Numbers(quantity) => format!("a list of numbers, each {}", number(quantity)),
        Form::Points => {
            let [strain, stress] = POINT.map(number);
            format!("a list of pairs such as `[{}]`: {strain} and {stress}", pair_example(POINT))
        }
        Form::Words(words) => format!("a list of {}", one_of(words).trim_start_matches("one of ")),
        Form::Word(words) => one_of(words),
        Form::Text(example) | Form::File(example) => format!("a text such as `\"{example}\"`"),
        Form::Axes | Form::Variables | Form::Free => "a table, see below".to_owned(),
        Form::WordOrTable(words) => format!("{}, or a table", quoted(&(words.known)())),
    }
}

/// The values that a key may have, without Markdown.
fn in_plain_text(form: &Form) -> String {
    let named = |words: &Words| match words.several {
        "materials" => "materials, which `plm-impact materials` lists".to_owned(),
        several => several.to_owned(),
    };
    match form {
        Form::Word(words) if is_long(words) => format!("one of the {}", named(words)),
        Form::Words(words) if is_long(words) => format!("a list of {}", named(words)),
        form => written(form).replace('`', ""),
    }
}

fn is_long(words: &Words) -> bool {
    (words.known)().len() > MOST_WORDS
}

fn one_of(words: &Words) -> String {
    if !is_long(words) {
        return quoted(&(words.known)());
    }
    // the list of materials ends the page of keys; results have a page of their own
    let place = if words.several == "results" { "results.md" } else { "#materials" };
    format!("one of the [{}]({place})", words.several)
}

fn quoted(words: &[String]) -> String {
    words.iter().map(|word| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", ")
}

/// The form of the value of a key, in words; for an axis, a distribution or a range, the form of the varied key.
pub(super) fn allowed(key: &str) -> Option<String> {
    match form_of(varied(key))? {
        Form::Axes | Form::Variables | Form::Free => None,
        Form::Word(words) => Some((words.known)().join(", ")),
        form => Some(in_plain_text(&form)),
    }
}

/// The form of the value of a key.
fn form_of(key: &str) -> Option<Form> {
    let pattern = pattern(key);
    EVERY_KEY.iter().find(|key| key.path == pattern).map(|key| key.form)
}

/// The message that `name` is missing in `table`; where `table` is empty, that the table `name` is missing.
pub(super) fn missing(name: &str, table: &str) -> String {
    if table.is_empty() {
        let way_out = match name {
            "sphere" => "; give its radius, youngs_modulus, poissons_ratio and density",
            "half_space" => "; give its youngs_modulus, poissons_ratio and, unless it is elastic, yield_strength",
            "impact" => "; give it with a speed such as speed = \"3 m/s\"",
            _ => "",
        };
        return format!("the table [{name}] is missing{way_out}");
    }
    let path = format!("{table}.{name}");
    let example = match form_of(&path) {
        Some(Form::Number(quantity) | Form::NumberOr(quantity, _) | Form::Count(quantity)) => {
            format!("{} such as {name} = {}", quantity.name, quantity.example)
        }
        Some(Form::Text(example) | Form::File(example)) => format!("a text such as {name} = \"{example}\""),
        _ => return format!("the key `{name}` is missing"),
    };
    format!("the key `{name}` is missing: {example}")
}
