//! Axes of words: methods and laws by name, each shown where it stands if there is no such one.

use std::collections::HashSet;

use serde::de::{Deserialize, Deserializer, Error};

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
