//! Axes of words: methods and laws by name.

use serde::de::Error;

use crate::impact::Method;
use crate::law::LawChoice;
use crate::nearest::nearest;

/// Laws by name.
pub(super) fn laws<E: Error>(names: &[String]) -> Result<Vec<LawChoice>, E> {
    if names.is_empty() {
        return Err(E::custom("an axis needs at least one value"));
    }
    names.iter().map(|name| super::law::named(name).map_err(E::custom)).collect()
}

/// Methods by name.
pub(super) fn methods<E: Error>(names: &[String]) -> Result<Vec<Method>, E> {
    if names.is_empty() {
        return Err(E::custom("an axis needs at least one value"));
    }
    let all = || Method::ALL.iter().map(|(name, _)| *name);
    let unknown = |name: &String| {
        let guess = nearest(name, all()).map_or_else(String::new, |near| format!(", did you mean \"{near}\"?"));
        let known: Vec<_> = all().collect();
        E::custom(format!("unknown method \"{name}\"{guess}; methods are {}", known.join(", ")))
    };
    let named = |name: &String| Method::ALL.iter().find(|(known, _)| known == name).map(|(_, method)| *method);
    names.iter().map(|name| named(name).ok_or_else(|| unknown(name))).collect()
}
