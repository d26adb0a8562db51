//! Changes in the text of a scenario. All that is not changed stays as it was written, with its comments.

use toml_edit::{DocumentMut, Item, Table, TableLike, Value, value};

use super::NEEDED;
use crate::scene::written::below;

/// Why a text cannot be changed: it is no TOML.
pub type NotToml = toml_edit::TomlError;

/// The text with another value of a key, or of the law. The value is given as on the command line: a number, a word, or a number
/// with its unit; nothing takes the key away.
///
/// # Errors
/// [`NotToml`]
pub fn edited(text: &str, path: &str, given: &str) -> Result<String, NotToml> {
    let mut document: DocumentMut = text.parse()?;
    match (path, given.trim()) {
        (path, "") => remove(document.as_table_mut(), path),
        ("law", law) => choose_law(&mut document, law),
        (path, given) => set(&mut document, path, given.parse::<Value>().map_or_else(|_| value(given), Item::Value)),
    }
    Ok(document.to_string())
}

/// The keys that a text gives, and their values as they are given on the command line; and the name of the law.
///
/// # Errors
/// [`NotToml`]
pub fn given(text: &str) -> Result<Vec<(String, String)>, NotToml> {
    let document: DocumentMut = text.parse()?;
    let mut all = Vec::new();
    collect("", document.as_table(), &mut all);
    let laws = document.get("law").and_then(Item::as_table_like);
    all.extend(laws.and_then(|laws| laws.iter().next()).map(|(name, _)| ("law".to_owned(), name.to_owned())));
    Ok(all)
}

fn collect(path: &str, table: &dyn TableLike, all: &mut Vec<(String, String)>) {
    for (name, item) in table.iter() {
        let path = below(path, name);
        match (item.as_table_like(), item.as_value()) {
            (Some(table), _) => collect(&path, table, all),
            (None, Some(Value::String(text))) => all.push((path, text.value().clone())),
            // without the comment behind it
            (None, Some(other)) => all.push((path, other.clone().decorated("", "").to_string())),
            (None, None) => {}
        }
    }
}

/// Takes a key away, and a table that is empty then, unless every impact needs that table.
fn remove(table: &mut dyn TableLike, path: &str) {
    let (first, rest) = path.split_once('.').map_or((path, None), |(first, rest)| (first, Some(rest)));
    let inner = table.get_mut(first).and_then(Item::as_table_like_mut);
    let is_empty = match (inner, rest) {
        (Some(inner), Some(rest)) => {
            remove(inner, rest);
            inner.is_empty() && !NEEDED.iter().any(|key| key.split('.').next() == Some(first))
        }
        (None, Some(_)) => false,
        (_, None) => true,
    };
    if is_empty {
        table.remove(first);
    }
}

/// Sets the value of a key. Comments beside the old value and above it stay.
pub fn set(document: &mut DocumentMut, path: &str, new: Item) {
    let (tables, name) = path.rsplit_once('.').unwrap_or(("", path));
    let mut table: &mut dyn TableLike = document.as_table_mut();
    for part in tables.split('.').filter(|part| !part.is_empty()) {
        let inner = table.entry(part).or_insert_with(|| Item::Table(tables_alone()));
        let Some(inner) = inner.as_table_like_mut() else { return };
        table = inner;
    }
    replace(table, name, new);
}

/// Puts a value in the place of another, whose comments stay.
fn replace(table: &mut dyn TableLike, name: &str, mut new: Item) {
    let decor = table.get(name).and_then(Item::as_value).map(|old| old.decor().clone());
    if let (Some(decor), Some(value)) = (decor, new.as_value_mut()) {
        *value.decor_mut() = decor;
    }
    match table.get_mut(name) {
        Some(old) => *old = new,
        None => drop(table.insert(name, new)),
    }
}

/// A table that has no head of its own while there are only tables in it.
fn tables_alone() -> Table {
    let mut table = Table::new();
    table.set_implicit(true);
    table
}

/// Merges the changes of the command line. The name of a law is no table that could be merged.
pub fn merge(into: &mut dyn TableLike, from: &dyn TableLike) {
    for (name, item) in from.iter().filter(|(name, item)| *name != "law" || item.is_table_like()) {
        match (into.get_mut(name).and_then(Item::as_table_like_mut), item.as_table_like()) {
            (Some(old), Some(new)) => merge(old, new),
            _ => replace(into, name, item.clone()),
        }
    }
}

/// Leaves the law of this name as the only one.
pub fn choose_law(document: &mut DocumentMut, law: &str) {
    let halves = law.split_once(" + ");
    let chosen = halves.map_or(law, |_| "combined");
    if chosen != "plm" && document.get("law").is_none() {
        document.insert("law", Item::Table(tables_alone()));
    }
    let Some(laws) = document.get_mut("law").and_then(Item::as_table_like_mut) else { return };
    let others: Vec<String> = laws.iter().map(|(name, _)| name.to_owned()).filter(|name| name != chosen).collect();
    for other in others {
        laws.remove(&other);
    }
    laws.entry(chosen).or_insert_with(|| Item::Table(Table::new()));
    for (half, name) in halves.into_iter().flat_map(|(one, two)| [("loading", one), ("unloading", two)]) {
        set(document, &format!("law.combined.{half}"), value(name));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# a ball\n[sphere]\n# how large\nradius = \"5 mm\"  # not the diameter\n[impact]\nspeed = 3\n";

    #[test]
    fn a_change_leaves_the_rest_of_the_text_as_it_was() {
        let change = |path, given| edited(TEXT, path, given).unwrap();
        assert_eq!(change("sphere.radius", "2 mm"), TEXT.replace("5 mm", "2 mm"));
        assert_eq!(change("impact.speed", "0.5"), TEXT.replace("= 3", "= 0.5"));
        assert_eq!(
            change("sphere.youngs_modulus", "rigid"),
            TEXT.replace("[impact]", "youngs_modulus = \"rigid\"\n[impact]")
        );
        assert_eq!(change("gravity.acceleration", "9.81"), format!("{TEXT}\n[gravity]\nacceleration = 9.81\n"));
        assert_eq!(change("law", "thornton"), format!("{TEXT}\n[law.thornton]\n"));
        assert_eq!(change("impact.speed", ""), TEXT.replace("speed = 3\n", ""));
        assert_eq!(edited(&change("gravity.acceleration", "9.81"), "gravity.acceleration", "").unwrap(), TEXT);
        assert_eq!(change("damping.viscous", ""), TEXT);
    }

    #[test]
    fn a_change_of_the_command_line_leaves_comments_where_they_are() {
        let mut document: DocumentMut = TEXT.parse().unwrap();
        let change: DocumentMut = "sphere.radius=\"6 mm\"".parse().unwrap();
        merge(document.as_table_mut(), change.as_table());
        assert_eq!(document.to_string(), TEXT.replace("5 mm", "6 mm"));
    }

    #[test]
    fn what_a_text_gives_is_what_was_put_there() {
        let changes = [("impact.speed", "3 m/s"), ("half_space.flow_stress.power.exponent", "0.1"), ("law", "stronge")];
        let text = changes.iter().fold(TEXT.to_owned(), |text, (path, value)| edited(&text, path, value).unwrap());
        let given = given(&text).unwrap();
        for (path, value) in changes.iter().chain(&[("sphere.radius", "5 mm")]) {
            assert!(given.contains(&((*path).to_owned(), (*value).to_owned())), "{path} in {given:?}");
        }
        assert_eq!(given.len(), 4, "{given:?}");
        // a comment behind a number is no part of it
        assert_eq!(super::given("speed = 3  # fast\n").unwrap(), [("speed".to_owned(), "3".to_owned())]);
    }
}
