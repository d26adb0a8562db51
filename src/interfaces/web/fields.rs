//! The keys and the materials, for a form.

use serde_json::{Map, Value, json};

use crate::materials::{MaterialEntry, Property, all_materials};
use crate::report::pictures::path_title;
use crate::report::text::materials::material_page;
use crate::scenario::input::{ALTERNATIVES, Body};
use crate::scenario::keys::words::LAWS;
use crate::scenario::keys::{ALL_KEYS, KeyId, NUMBER, ValueForm, WordList};

/// The keys whose value is a number or a word: path, title, meaning, default, an example, the unit of a number that is written
/// without one, the words that may be chosen, and the key in whose place it may stand.
pub fn fields() -> Value {
    let law = json!({ "path": "law", "title": "Law", "description": "The contact law.", "default": "plm", "words": (LAWS.values)() });
    let keys = ALL_KEYS.iter().filter(|key| !key.path.contains("[]")).filter_map(|key| {
        let (example, unit, words) = match key.form {
            ValueForm::Number(quantity) | ValueForm::NumberOr(quantity, _) | ValueForm::Count(quantity) => {
                (quantity.example.trim_matches('"'), quantity.dimension.si_unit(), None)
            }
            ValueForm::Word(WordList { values, .. }) => ("", "", Some(values())),
            _ => return None,
        };
        let group = ALTERNATIVES.into_iter().find(|group| group[1..].contains(&key.path));
        Some(json!({
            "path": key.path,
            "title": path_title(key.path),
            "description": key.description,
            "default": key.default.replace(['"', '`'], ""),
            "example": example,
            "unit": unit,
            "words": words,
            "instead": group.map(|group| group[0])
        }))
    });
    keys.chain([law]).collect()
}

/// The materials: name, what each is, the keys that take a value from it, with that value as it is written, and its page.
pub fn materials() -> Value {
    let entry = |entry: &MaterialEntry| {
        let defaults = Body::ALL.into_iter().flat_map(Body::material_keys);
        let written = |(at, property): (KeyId<NUMBER>, Property)| {
            Some((at.path().to_owned(), json!(entry.get(property)?.value.text)))
        };
        let values: Map<_, _> = defaults.filter_map(written).collect();
        json!({ "name": entry.name, "title": entry.title, "values": values, "page": material_page(entry) })
    };
    all_materials().iter().map(entry).collect()
}
