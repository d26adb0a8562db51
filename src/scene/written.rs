//! A scenario as it is written: tables of TOML in which every key and every value knows its place in the text.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeInteger, DeString, DeTable, DeValue};

/// A key, with its place in bytes.
pub type Name<'t> = Spanned<DeString<'t>>;
/// What stands behind a key, with its place.
pub type Node<'t> = Spanned<DeValue<'t>>;

/// The law of two halves.
pub const COMBINED: &str = "combined";

/// Puts the keys of another table in place of those of the same name; tables are merged.
pub fn merge<'t>(into: &mut DeTable<'t>, from: DeTable<'t>) {
    for (name, node) in from {
        let place = node.span();
        match (into.get_mut(&**name.get_ref()).map(Spanned::get_mut), node.into_inner()) {
            (Some(DeValue::Table(old)), DeValue::Table(new)) => merge(old, new),
            (_, value) => drop(into.insert(name, Spanned::new(place, value))),
        }
    }
}

/// Prepares changes that name a law. A scenario has one law, so theirs replaces that of the file. A name alone stands for
/// the law with its defaults, or with the keys that the file gives to that law.
pub fn choose_law<'t>(root: &mut DeTable<'t>, changes: &mut DeTable<'t>) {
    let Some(law) = changes.get_mut("law") else { return };
    let place = law.span();
    if let DeValue::String(name) = law.get_ref() {
        let table = |keys: Vec<(&str, DeValue<'t>)>| {
            let at = |(name, value): (&str, _)| {
                (Spanned::new(place.clone(), name.trim().to_owned().into()), Spanned::new(place.clone(), value))
            };
            DeValue::Table(keys.into_iter().map(at).collect())
        };
        let half = |name: &str| DeValue::String(name.trim().to_owned().into());
        let chosen = match name.split_once('+') {
            None => table(vec![(name, table(Vec::new()))]),
            Some((loading, unloading)) => {
                let halves = vec![("loading", half(loading)), ("unloading", half(unloading))];
                table(vec![(COMBINED, table(halves))])
            }
        };
        *law.get_mut() = chosen;
    }
    if let (DeValue::Table(chosen), Some(DeValue::Table(laws))) =
        (law.get_ref(), root.get_mut("law").map(Spanned::get_mut))
    {
        *laws =
            std::mem::take(laws).into_iter().filter(|(law, _)| chosen.contains_key(law.get_ref().as_ref())).collect();
    }
}

/// Adds where the values of a table are, by their paths with dots; behind the path of a list, `[2]` stands for an item.
pub fn add_places(path: &str, node: &Node, into: &mut BTreeMap<String, Range<usize>>) {
    match node.get_ref() {
        DeValue::Table(table) => {
            for (name, inner) in table {
                add_places(&below(path, name.get_ref()), inner, into);
            }
        }
        DeValue::Array(items) => {
            for (i, item) in items.iter().enumerate() {
                add_places(&format!("{path}[{i}]"), item, into);
            }
        }
        _ => {}
    }
    if !path.is_empty() {
        into.insert(path.to_owned(), node.span());
    }
}

/// The path of a name in a table of this path, which is empty for the whole scenario.
pub fn below(path: &str, name: &str) -> String {
    if path.is_empty() || name.starts_with('[') { format!("{path}{name}") } else { format!("{path}.{name}") }
}

/// The path without the numbers of items: an item of a list has the keys of all its items.
pub fn pattern(path: &str) -> String {
    let parts: Vec<&str> = path.split('[').map(|part| part.trim_start_matches(|c: char| c.is_ascii_digit())).collect();
    parts.join("[")
}

/// What was found here, for messages.
pub fn described(node: &Node) -> String {
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
#[allow(clippy::cast_precision_loss)] // as if it had been written with a decimal point
pub fn whole_number(digits: &DeInteger) -> Option<f64> {
    let (text, radix) = (digits.as_str(), digits.radix());
    if radix == 10 { text.parse().ok() } else { u128::from_str_radix(text, radix).ok().map(|number| number as f64) }
}
