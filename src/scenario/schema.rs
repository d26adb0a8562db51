//! The JSON Schema of a scenario, made from the registry of keys: for editors, and for programs that write scenarios.

use std::ops::Bound;

use serde_json::{Value, json};

use super::Kind;
use super::input::read_input::POINT;
use super::input::{Body, NUMERIC_KEYS, alternative_pairs};
use super::keys::words::{MATERIAL_DISTRIBUTIONS, MATERIALS, METHODS, SCALES};
use super::keys::{ALL_KEYS, Quantity, ValueForm, WordList};
use crate::contact::law::LawChoice;

/// The schema (draft 2020-12). It describes the forms, the words, the ranges of numbers, which keys exclude each other, and
/// that an impact needs a speed. Of texts with a unit it refuses those of another dimension; the program itself checks more.
pub fn schema() -> Value {
    let mut root = empty_table_schema();
    for law in LawChoice::names() {
        insert(&mut root, &format!("law.{law}"), empty_table_schema());
    }
    let mut quantities = Vec::new();
    for key in ALL_KEYS {
        let mut schema = form_schema(&key.form, &mut quantities);
        schema["description"] = json!(key.description);
        insert(&mut root, key.path, schema);
    }
    for quantity in quantities {
        root["$defs"][quantity.name] = quantity_schema(quantity);
    }
    root["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    root["title"] = json!("Scenario of plm-impact");
    root["properties"]["law"]["minProperties"] = json!(1);
    root["properties"]["law"]["maxProperties"] = json!(1);
    for [one, other] in alternative_pairs() {
        let (Some((table, one)), Some((_, other))) = (one.split_once('.'), other.split_once('.')) else { continue };
        let pairs = &mut root["properties"][table]["allOf"];
        let mut all = pairs.as_array().cloned().unwrap_or_default();
        all.push(json!({ "not": { "required": [one, other] } }));
        *pairs = all.into();
    }
    // without the table of another kind it is one impact, and that needs a speed
    let speed = json!({ "anyOf": [{ "required": ["speed"] }, { "required": ["drop_height"] }] });
    let impact = json!({ "required": ["sphere", "half_space", "impact"], "properties": { "impact": speed } });
    let others = Kind::ALL[1..].iter().map(|kind| json!({ "required": [kind.name()] }));
    root["anyOf"] = others.chain([impact]).collect();
    root
}

/// A table whose keys are added later.
fn empty_table_schema() -> Value {
    json!({ "type": "object", "additionalProperties": false, "properties": {} })
}

/// A table of these keys, of which some are required.
fn table_schema(properties: &Value, required: &[&str]) -> Value {
    json!({ "type": "object", "additionalProperties": false, "required": required, "properties": properties })
}

/// A list of at least `least` such items.
fn list_schema(item: &Value, least: u32) -> Value {
    json!({ "type": "array", "items": item, "minItems": least })
}

/// The two ends of a range.
fn range_schema(value: &Value) -> Value {
    json!({ "type": "array", "items": value, "minItems": 2, "maxItems": 2 })
}

/// Puts the schema of a key where its path says; `[]` behind a name is a list of tables.
fn insert(root: &mut Value, path: &str, leaf: Value) {
    let (first, rest) = path.split_once('.').map_or((path, None), |(first, rest)| (first, Some(rest)));
    let (name, is_list) = first.strip_suffix("[]").map_or((first, false), |name| (name, true));
    let place = &mut root["properties"][name];
    if place.is_null() {
        *place = match rest {
            None => leaf,
            Some(rest) => {
                let mut inner = empty_table_schema();
                insert(&mut inner, rest, leaf);
                if is_list { list_schema(&inner, 0) } else { inner }
            }
        };
    } else if let Some(rest) = rest {
        insert(if is_list { &mut place["items"] } else { place }, rest, leaf);
    }
}

/// Describes the values of a key; the quantities that it refers to are added to the list.
fn form_schema(form: &ValueForm, quantities: &mut Vec<&'static Quantity>) -> Value {
    let mut number = |quantity: &'static Quantity| {
        quantities.push(quantity);
        quantity_reference(quantity)
    };
    match form {
        ValueForm::Number(quantity) => number(quantity),
        ValueForm::NumberOr(quantity, word) => json!({ "anyOf": [number(quantity), { "const": word }] }),
        ValueForm::Count(quantity) => bounded_schema("integer", quantity),
        ValueForm::Flag => json!({ "type": "boolean" }),
        ValueForm::Numbers(quantity) => list_schema(&number(quantity), 0),
        ValueForm::Points => {
            let pair = POINT.map(number);
            list_schema(&json!({ "type": "array", "prefixItems": pair, "minItems": 2, "maxItems": 2 }), 2)
        }
        ValueForm::Word(words) => word_schema(words),
        ValueForm::Words(words) => list_schema(&word_schema(words), 0),
        ValueForm::Text(_) | ValueForm::File(_) => json!({ "type": "string" }),
        ValueForm::Axes => axes_schema(),
        ValueForm::Variables => variables_schema(),
        ValueForm::Free => free_keys_schema(),
        ValueForm::WordOrTable(words) => {
            let mut schema = empty_table_schema();
            schema["type"] = json!(["string", "object"]);
            schema["pattern"] = json!(format!("^({})$", (words.values)().join("|")));
            schema
        }
    }
}

fn word_schema(words: &WordList) -> Value {
    json!({ "enum": (words.values)() })
}

fn quantity_reference(quantity: &Quantity) -> Value {
    json!({ "$ref": format!("#/$defs/{}", quantity.name.replace(' ', "%20")) })
}

/// A number in SI within its range, or a text with a unit that is not one of another dimension. A unit of this dimension may end in
/// one of another, as "Pa s" does.
fn quantity_schema(quantity: &Quantity) -> Value {
    fn alternatives<'u>(units: impl Iterator<Item = &'u str>) -> String {
        units.map(|unit| unit.replace('^', "\\^")).collect::<Vec<_>>().join("|")
    }
    let (own, others) = (quantity.dimension.unit_names(), quantity.dimension.units_of_other_dimensions());
    let (own, others) = (alternatives(own), alternatives(others));
    let number = "\\s*[+\u{2212}-]?[0-9.]";
    let with_own = format!("{number}[0-9.eE+\u{2212}-]*\\s*({own})\\s*$");
    let pattern = format!("^(?:{with_own}|(?!.*[0-9.\\s]({others})\\s*$){number})");
    let example = quantity.example.trim_matches('"');
    let text = json!({ "type": "string", "pattern": pattern, "examples": [example] });
    json!({ "anyOf": [bounded_schema("number", quantity), text] })
}

fn bounded_schema(kind: &str, quantity: &Quantity) -> Value {
    let mut schema = json!({ "type": kind });
    for (excluded, included, bound) in
        [("exclusiveMinimum", "minimum", quantity.low), ("exclusiveMaximum", "maximum", quantity.high)]
    {
        match bound {
            Bound::Excluded(value) if value.is_finite() => schema[excluded] = json!(value),
            Bound::Included(value) => schema[included] = json!(value),
            Bound::Excluded(_) | Bound::Unbounded => {}
        }
    }
    schema
}

/// A table of numeric keys. `form` makes the schema of a value that varies from the schema of one value.
fn varied_keys_schema(form: impl Fn(&Value) -> Value) -> Value {
    let mut schema = empty_table_schema();
    for key in NUMERIC_KEYS.iter() {
        schema["properties"][key.path()] = form(&quantity_reference(key.quantity()));
    }
    schema
}

/// `[sweep]`: numeric keys with values, and the keys with words.
fn axes_schema() -> Value {
    let space = |name: &str, value: &Value| {
        let properties = json!({ name: range_schema(value), "points": { "type": "integer", "minimum": 1 } });
        table_schema(&properties, &[name, "points"])
    };
    let mut schema = varied_keys_schema(
        |value| json!({ "anyOf": [list_schema(value, 1), space("linspace", value), space("logspace", value)] }),
    );
    schema["properties"]["solver.method"] = list_schema(&word_schema(&METHODS), 1);
    schema["properties"]["law"] =
        json!({ "anyOf": [{ "const": "all" }, list_schema(&json!({ "type": "string" }), 1)] });
    for body in Body::ALL {
        schema["properties"][body.material()] = list_schema(&word_schema(&MATERIALS), 1);
    }
    schema
}

/// `calibrate.free`: numeric keys with ranges. Without a key, laws and data are compared, and nothing is fitted.
fn free_keys_schema() -> Value {
    let mut schema = varied_keys_schema(|end| {
        table_schema(&json!({ "from": end, "to": end, "scale": word_schema(&SCALES) }), &["from", "to"])
    });
    schema["maxProperties"] = json!(2);
    schema
}

/// `[monte_carlo]`: numeric keys with distributions.
fn variables_schema() -> Value {
    let spread = json!({ "anyOf": [{ "type": "number", "exclusiveMinimum": 0 }, { "type": "string" }] });
    let mut schema = varied_keys_schema(|value| {
        let moments = table_schema(&json!({ "mean": value, "sd": spread }), &["mean", "sd"]);
        let properties = json!({ "normal": moments, "lognormal": moments, "uniform": range_schema(value) });
        let mut one = table_schema(&properties, &[]);
        one["minProperties"] = json!(1);
        one["maxProperties"] = json!(1);
        one
    });
    for body in Body::ALL {
        schema["properties"][body.material()] = word_schema(&MATERIAL_DISTRIBUTIONS);
    }
    schema["properties"]["samples"] = json!({ "type": "integer", "minimum": 1, "description": "Number of cases." });
    schema["properties"]["seed"] =
        json!({ "type": "integer", "minimum": 0, "description": "Which random numbers; 0 if left out." });
    schema["required"] = json!(["samples"]);
    schema
}
