//! A scenario as it is written: tables of TOML in which every key and every value knows its place in the text.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeInteger, DeString, DeValue};

/// A key, with its place in bytes.
pub type TomlKey<'t> = Spanned<DeString<'t>>;
pub type TomlValue<'t> = Spanned<DeValue<'t>>;

/// The law of two halves.
pub const COMBINED: &str = "combined";

/// Adds where the values of a table are, by their paths with dots; behind the path of a list, `[2]` stands for an item.
pub fn collect_spans(path: &str, node: &TomlValue, into: &mut BTreeMap<String, Range<usize>>) {
    match node.get_ref() {
        DeValue::Table(table) => {
            for (name, inner) in table {
                collect_spans(&join_path(path, name.get_ref()), inner, into);
            }
        }
        DeValue::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                collect_spans(&format!("{path}[{i}]"), item, into);
            }
        }
        _ => {}
    }
    if !path.is_empty() {
        into.insert(path.to_owned(), node.span());
    }
}

/// The path of a name in a table of this path, which is empty for the whole scenario.
pub fn join_path(path: &str, name: &str) -> String {
    if path.is_empty() || name.starts_with('[') { format!("{path}{name}") } else { format!("{path}.{name}") }
}

/// The path without the numbers of items: an item of a list has the keys of all its items.
pub fn without_indices(path: &str) -> String {
    let parts: Vec<&str> = path.split('[').map(|part| part.trim_start_matches(|c: char| c.is_ascii_digit())).collect();
    parts.join("[")
}

/// Describes a value in messages.
pub fn describe_value(node: &TomlValue) -> String {
    match node.get_ref() {
        DeValue::String(text) => format!("\"{text}\""),
        DeValue::Integer(digits) => format!("`{digits}`"),
        DeValue::Float(digits) => format!("`{digits}`"),
        DeValue::Boolean(word) => format!("`{word}`"),
        DeValue::Datetime(date) => format!("the date `{date}`"),
        DeValue::Array(_) => "a list".to_owned(),
        DeValue::Table(_) => "a table".to_owned(),
    }
}

/// An integer as a floating number. Digits of another base are not read as decimal ones, however many they are.
pub fn whole_number(digits: &DeInteger) -> Option<f64> {
    let (text, radix) = (digits.as_str(), digits.radix());
    if radix == 10 { text.parse().ok() } else { u128::from_str_radix(text, radix).ok().map(|number| number as f64) }
}
