//! Changes in the text of a scenario: changes of the command line, of the page, and the values of a calibration. Everything else
//! stays as written, with its comments.

use toml_edit::{DocumentMut, InlineTable, Item, Table, TableLike, Value};

use crate::scenario::input::read_input::is_known_path;
use crate::scenario::input::{REQUIRED_KEYS, alternatives_to};
use crate::scenario::toml_node::{COMBINED, join_path, without_indices};

/// The text cannot be changed, because it is no TOML.
pub type TomlError = toml_edit::TomlError;

/// A key and its new value.
#[derive(Debug, Clone)]
pub struct Change {
    /// The names of the tables of the key, and the name of the key.
    path: Vec<String>,
    /// `None` removes the key or the table.
    value: Option<Value>,
}

impl Change {
    /// Parses `key=value`. A value that is no TOML is a word whose quotes the shell has removed; the word `none` removes the key.
    pub fn parse(key: &str, value: &str) -> Result<Self, TomlError> {
        let as_word = || format!("{key}={}", toml::Value::from(value.trim()));
        let document: DocumentMut = format!("{key}={value}").parse().or_else(|_| as_word().parse())?;
        let (mut path, mut item) = (Vec::new(), document.as_item());
        while let Some((name, inner)) = item.as_table().and_then(|table| table.iter().next()) {
            path.push(name.to_owned());
            item = inner;
        }
        let value =
            item.as_value().filter(|_| value.trim() != REMOVAL_WORD).map(|value| value.clone().decorated(" ", ""));
        Ok(Self { path, value })
    }

    /// The path of the key, with dots.
    pub fn key(&self) -> String {
        self.path.join(".")
    }
}

/// The word that removes a key or a table.
const REMOVAL_WORD: &str = "none";

/// The text with these changes, one after the other. A key replaces its alternative, unless a change gave the alternative.
pub fn with_changes<'c>(text: &str, changes: impl IntoIterator<Item = &'c Change>) -> Result<String, TomlError> {
    let mut document: DocumentMut = text.parse()?;
    let mut given: Vec<String> = Vec::new();
    for change in changes {
        let key = change.key();
        let path: Vec<&str> = change.path.iter().map(String::as_str).collect();
        match (&path[..], &change.value) {
            // an unknown name is inserted, so that it is refused as unknown
            (_, None) if !remove(document.as_table_mut(), &path) && !is_known_path(&without_indices(&key)) => {
                insert(&mut document, &path, REMOVAL_WORD.into());
            }
            (_, None) => {}
            (["law"], Some(Value::String(law))) => select_law(&mut document, law.value()),
            (_, Some(value)) => {
                if let ["law", law, ..] = path[..] {
                    select_law(&mut document, law);
                }
                insert(&mut document, &path, value.clone());
                for other in replaced_keys(&path, &key, value) {
                    if !given.iter().any(|given| given == other) {
                        remove(document.as_table_mut(), &path_parts(other));
                    }
                }
            }
        }
        given.push(key);
    }
    Ok(document.to_string())
}

/// The keys that this change replaces. The axis of a key counts like the key.
fn replaced_keys(path: &[&str], key: &str, value: &Value) -> Vec<&'static str> {
    match (path, value) {
        (["sweep" | "monte_carlo", number], _) => alternatives_to(number).collect(),
        (["sweep" | "monte_carlo"], Value::InlineTable(axes)) => {
            axes.iter().flat_map(|(name, _)| alternatives_to(name)).collect()
        }
        _ => alternatives_to(key).collect(),
    }
}

/// The text with another value of a key, or of the law. The value is given as on the command line: a number, a word, or a number
/// with its unit; `None` removes the key.
pub fn with_value(text: &str, path: &str, given: &str) -> Result<String, TomlError> {
    let given = Some(given.trim()).filter(|given| !given.is_empty());
    let value = given.map(|given| given.parse().unwrap_or_else(|_| given.into()));
    with_changes(text, [&Change { path: path.split('.').map(str::to_owned).collect(), value }])
}

fn path_parts(path: &str) -> Vec<&str> {
    path.split('.').collect()
}

/// The given keys of a text, with their values as on the command line; and the name of the law.
pub fn given_values(text: &str) -> Result<Vec<(String, String)>, TomlError> {
    let document: DocumentMut = text.parse()?;
    let mut all = Vec::new();
    collect_values("", document.as_table(), &mut all);
    let laws = document.get("law").and_then(Item::as_table_like);
    all.extend(laws.and_then(|laws| laws.iter().next()).map(|(name, _)| ("law".to_owned(), name.to_owned())));
    Ok(all)
}

fn collect_values(path: &str, table: &dyn TableLike, all: &mut Vec<(String, String)>) {
    for (name, item) in table.iter() {
        let path = join_path(path, name);
        match (item.as_table_like(), item.as_value()) {
            (Some(table), _) => collect_values(&path, table, all),
            (None, Some(Value::String(text))) => all.push((path, text.value().to_owned())),
            // without the comment after it
            (None, Some(other)) => all.push((path, other.clone().decorated("", "").to_string())),
            (None, None) => {}
        }
    }
}

/// Removes a key or a table, and then a table that is empty, unless every impact needs this table. True if the key existed.
fn remove(table: &mut dyn TableLike, path: &[&str]) -> bool {
    let Some((first, rest)) = path.split_first() else { return false };
    if rest.is_empty() {
        return table.remove(first).is_some();
    }
    let Some(inner) = table.get_mut(first).and_then(Item::as_table_like_mut) else { return false };
    let was_there = remove(inner, rest);
    if was_there && inner.is_empty() && !REQUIRED_KEYS.iter().any(|key| key.split('.').next() == Some(first)) {
        table.remove(first);
    }
    was_there
}

/// Sets the value of a key, at the position of the key that it replaces. Comments beside and above the old value stay.
pub fn set(document: &mut DocumentMut, path: &str, new: impl Into<Value>) {
    insert(document, &path_parts(path), new.into());
    for other in alternatives_to(path) {
        remove(document.as_table_mut(), &path_parts(other));
    }
}

fn insert(document: &mut DocumentMut, path: &[&str], mut new: Value) {
    let Some((name, tables)) = path.split_last() else { return };
    let (mut table, mut is_inline): (&mut dyn TableLike, bool) = (document.as_table_mut(), false);
    for part in tables {
        let empty = if is_inline { Item::Value(InlineTable::new().into()) } else { Item::Table(implicit_table()) };
        if table.get(part).is_none_or(|inner| !inner.is_table_like()) {
            table.insert(part, empty);
        }
        let Some(inner) = table.get_mut(part) else { return };
        is_inline |= inner.is_inline_table();
        let Some(inner) = inner.as_table_like_mut() else { return };
        table = inner;
    }
    match table.get_mut(name) {
        Some(old) => {
            if let Some(old) = old.as_value() {
                *new.decor_mut() = old.decor().clone();
            }
            *old = Item::Value(new);
        }
        None => drop(table.insert(name, Item::Value(new))),
    }
}

/// A table without a header, as long as it holds only tables.
fn implicit_table() -> Table {
    let mut table = Table::new();
    table.set_implicit(true);
    table
}

/// Keeps only the law of this name, with its keys in the text.
fn select_law(document: &mut DocumentMut, law: &str) {
    let halves = law.split_once('+').map(|(loading, unloading)| [loading.trim(), unloading.trim()]);
    let chosen = halves.map_or(law.trim(), |_| COMBINED);
    if document.get("law").is_none_or(|laws| !laws.is_table_like()) {
        document.remove("law");
        if chosen == "plm" {
            return;
        }
        document.insert("law", Item::Table(implicit_table()));
    }
    let Some(laws) = document.get_mut("law") else { return };
    let is_inline = laws.is_inline_table();
    let Some(laws) = laws.as_table_like_mut() else { return };
    let others: Vec<String> = laws.iter().map(|(name, _)| name.to_owned()).filter(|name| name != chosen).collect();
    for other in others {
        laws.remove(&other);
    }
    if laws.get(chosen).is_none() {
        let empty = if is_inline { Item::Value(InlineTable::new().into()) } else { Item::Table(Table::new()) };
        laws.insert(chosen, empty);
    }
    for (half, name) in ["loading", "unloading"].into_iter().zip(halves.into_iter().flatten()) {
        set(document, &format!("law.{COMBINED}.{half}"), name);
    }
}
