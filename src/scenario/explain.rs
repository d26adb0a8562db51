//! The place of a key in a document, and the message about a missing key.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::scene::key::Form;
use crate::scene::keys::every_key;
use crate::scene::other_keys::List;

/// Where the value of a dotted key is; the last part may be a key in quotes with dots of its own, and `[2]` stands for an
/// item of a list.
pub(super) fn span_of(table: &DeTable<'_>, path: &str) -> Option<Range<usize>> {
    if let Some(value) = table.get(path) {
        return Some(value.span());
    }
    let (name, rest) = path.split_once('.').map_or((path, None), |(name, rest)| (name, Some(rest)));
    let (name, item) =
        name.split_once('[').map_or((name, None), |(name, item)| (name, Some(item.trim_end_matches(']'))));
    let mut value: &Spanned<DeValue> = table.get(name)?;
    if let Some(item) = item {
        value = value.get_ref().as_array()?.get(item.parse::<usize>().ok()?)?;
    }
    match (rest, value.get_ref()) {
        (None, _) => Some(value.span()),
        (Some(rest), DeValue::Table(inner)) => span_of(inner, rest),
        _ => None,
    }
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
    // an item of a list has the keys of all its items
    let pattern = match table.split_once('[') {
        Some((list, _)) => format!("{list}[].{name}"),
        None => format!("{table}.{name}"),
    };
    let example = match every_key().find(|key| key.path == pattern).map(|key| key.form) {
        _ if pattern == "law.combined.loading" => "the law that loads, such as loading = \"plm\"".to_owned(),
        _ if pattern == "law.combined.unloading" => "the law that unloads, such as unloading = \"thornton\"".to_owned(),
        Some(Form::Number(quantity, _) | Form::Count(quantity)) => {
            format!("{} such as {name} = {}", quantity.name, quantity.example)
        }
        Some(Form::Text(example)) => format!("a text such as {name} = \"{example}\""),
        _ => match List::find(&pattern) {
            Some(list) => format!("a list such as {}", list.example),
            None => return format!("the key `{name}` is missing"),
        },
    };
    format!("the key `{name}` is missing: {example}")
}
