//! Descriptions of the keys for the command `keys`, the reference page and messages.

use std::fmt::Write as _;

use super::input::read_input::{POINT, pair_example};
use super::input::{NumericKey, without_axis_table};
use super::keys::{ALL_KEYS, KeySpec, Quantity, ValueForm, WordList};
use super::toml_node::without_indices;
use crate::results::impact::impact_results;

/// Describes the keys whose paths hold this text; `None` if no path holds it.
pub fn describe_keys(text: &str) -> Option<String> {
    let known: Vec<&KeySpec> = ALL_KEYS.iter().collect();
    let exact: Vec<&KeySpec> = known.iter().copied().filter(|key| key.path == text).collect();
    let some = known.into_iter().filter(|key| key.path.contains(text)).collect();
    let found = if exact.is_empty() { some } else { exact };
    let mut all = String::new();
    for KeySpec { path, form, default, description: about, .. } in &found {
        let _ = writeln!(all, "{path}\n  {about}\n  value: {}", form_as_text(form));
        if !default.is_empty() {
            let _ = writeln!(all, "  default: {default}");
        }
        if NumericKey::find(path).is_some() {
            let _ = writeln!(all, "  may be an axis of [sweep] or random in [monte_carlo]");
        }
    }
    (!found.is_empty()).then_some(all)
}

/// The meaning of a result of an impact; `None` if no result has this name.
pub fn describe_result(name: &str) -> Option<&'static str> {
    impact_results().into_iter().find(|result| result.name == name).map(|result| result.description)
}

/// A key with more words refers to a table of its words.
const MAX_LISTED_WORDS: usize = 20;

/// The values that a key may have, as Markdown.
pub fn form_as_markdown(form: &ValueForm) -> String {
    let number = |quantity: &Quantity| format!("{} {}", quantity.name, quantity.allowed_range());
    match form {
        ValueForm::Number(quantity) => number(quantity),
        ValueForm::NumberOr(quantity, word) => format!("{}, or `\"{word}\"`", number(quantity)),
        ValueForm::Count(quantity) => format!("a whole number {}", quantity.allowed_range()),
        ValueForm::Flag => "`true` or `false`".to_owned(),
        ValueForm::Numbers(quantity) => format!("a list of numbers, each {}", number(quantity)),
        ValueForm::Points => {
            let [strain, stress] = POINT.map(number);
            format!("a list of pairs such as `[{}]`: {strain} and {stress}", pair_example(POINT))
        }
        ValueForm::Words(words) => format!("a list of {}", word_choices(words).trim_start_matches("one of ")),
        ValueForm::Word(words) => word_choices(words),
        ValueForm::Text(example) | ValueForm::File(example) => format!("a text such as `\"{example}\"`"),
        ValueForm::Axes | ValueForm::Variables | ValueForm::Free => "a table, see below".to_owned(),
        ValueForm::WordOrTable(words) => format!("{}, or a table", join_quoted(&(words.values)())),
    }
}

/// The values that a key may have, without Markdown.
fn form_as_text(form: &ValueForm) -> String {
    let named = |words: &WordList| match words.plural {
        "materials" => "materials, which `plm-impact materials` lists".to_owned(),
        several => several.to_owned(),
    };
    match form {
        ValueForm::Word(words) if is_long(words) => format!("one of the {}", named(words)),
        ValueForm::Words(words) if is_long(words) => format!("a list of {}", named(words)),
        form => form_as_markdown(form).replace('`', ""),
    }
}

fn is_long(words: &WordList) -> bool {
    (words.values)().len() > MAX_LISTED_WORDS
}

fn word_choices(words: &WordList) -> String {
    if !is_long(words) {
        return join_quoted(&(words.values)());
    }
    // the list of materials ends the page of keys; results have a page of their own
    let place = if words.plural == "results" { "results.md" } else { "#materials" };
    format!("one of the [{}]({place})", words.plural)
}

fn join_quoted(words: &[String]) -> String {
    words.iter().map(|word| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", ")
}

/// The form of the value of a key, in words; for an axis, a distribution or a range, the form of the varied key.
pub(super) fn allowed_value(key: &str) -> Option<String> {
    match value_form(without_axis_table(key))? {
        ValueForm::Axes | ValueForm::Variables | ValueForm::Free => None,
        ValueForm::Word(words) => Some((words.values)().join(", ")),
        form => Some(form_as_text(&form)),
    }
}

/// The form of the value of a key.
fn value_form(key: &str) -> Option<ValueForm> {
    let pattern = without_indices(key);
    ALL_KEYS.iter().find(|key| key.path == pattern).map(|key| key.form)
}

/// The message that `name` is missing in `table`; where `table` is empty, that the table `name` is missing.
pub(super) fn missing_message(name: &str, table: &str) -> String {
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
    let example = match value_form(&path) {
        Some(ValueForm::Number(quantity) | ValueForm::NumberOr(quantity, _) | ValueForm::Count(quantity)) => {
            format!("{} such as {name} = {}", quantity.name, quantity.example)
        }
        Some(ValueForm::Text(example) | ValueForm::File(example)) => format!("a text such as {name} = \"{example}\""),
        _ => return format!("the key `{name}` is missing"),
    };
    format!("the key `{name}` is missing: {example}")
}
