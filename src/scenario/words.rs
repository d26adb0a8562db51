//! Words: methods and laws by name on an axis, each shown where it stands if there is no such one; a law by name on the
//! command line.

use std::collections::HashSet;

use serde::de::{Deserialize, Deserializer, Error};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::law::named;
use super::values::MethodName;
use crate::impact::Method;
use crate::law::LawChoice;

/// Laws by name.
pub(super) struct Laws(pub(super) Vec<LawChoice>);

impl<'de> Deserialize<'de> for Laws {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let laws: Vec<LawName> = not_empty(deserializer)?;
        distinct(laws.into_iter().map(|law| law.0), LawChoice::name).map(Self)
    }
}

/// Methods by name.
pub(super) struct Methods(pub(super) Vec<Method>);

impl<'de> Deserialize<'de> for Methods {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let methods: Vec<MethodName> = not_empty(deserializer)?;
        distinct(methods.into_iter().map(|method| method.0), |method| method.name().to_owned()).map(Self)
    }
}

struct LawName(LawChoice);

impl<'de> Deserialize<'de> for LawName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        named(&String::deserialize(deserializer)?).map(Self).map_err(D::Error::custom)
    }
}

fn not_empty<'de, T: Deserialize<'de>, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<T>, D::Error> {
    let list = Vec::deserialize(deserializer)?;
    if list.is_empty() { Err(D::Error::custom("an axis needs at least one value")) } else { Ok(list) }
}

/// Prepares an override of the law: a scenario has one, so that the law of the override takes the place of that of the file.
/// A name alone stands for the law with its defaults, or with the keys that the file gives to that law.
pub(super) fn choose_law<'a>(root: &mut DeTable<'a>, changes: &mut DeTable<'a>) {
    let Some(law) = changes.get_mut("law") else { return };
    let span = law.span();
    if let DeValue::String(name) = law.get_ref() {
        let word = |text: &str| Spanned::new(span.clone(), text.trim().to_owned().into());
        let (mut table, mut keys) = (DeTable::new(), DeTable::new());
        let key = match name.split_once('+') {
            None => word(name),
            Some((loading, unloading)) => {
                for (half, law) in [("loading", loading), ("unloading", unloading)] {
                    let law = DeValue::String(law.trim().to_owned().into());
                    keys.insert(word(half), Spanned::new(span.clone(), law));
                }
                word("combined")
            }
        };
        table.insert(key, Spanned::new(span.clone(), DeValue::Table(keys)));
        *law.get_mut() = DeValue::Table(table);
    }
    let (DeValue::Table(chosen), Some(DeValue::Table(laws))) =
        (law.get_ref(), root.get_mut("law").map(Spanned::get_mut))
    else {
        return;
    };
    let names: Vec<String> = laws.keys().map(|name| name.get_ref().to_string()).collect();
    for name in names.iter().filter(|name| !chosen.contains_key(name.as_str())) {
        laws.remove(name.as_str());
    }
}

/// The values, if no two have the same name.
fn distinct<T, E: Error>(values: impl Iterator<Item = T>, name: impl Fn(&T) -> String) -> Result<Vec<T>, E> {
    let values: Vec<T> = values.collect();
    let mut names = HashSet::new();
    match values.iter().map(name).find(|name| !names.insert(name.clone())) {
        Some(name) => {
            Err(E::custom(format!("\"{name}\" is there twice, which would be the same rows twice; leave one out")))
        }
        None => Ok(values),
    }
}
