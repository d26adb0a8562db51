//! The JSON Schema of a scenario, made from the registry of keys: for editors, and for programs that write scenarios.

use serde_json::{Map, Value, json};

use super::Kind;
use super::file::every_key;
use crate::law::LawChoice;
use crate::scene::key::{Form, Words};
use crate::scene::quantity::{Bound, Quantity};
use crate::scene::taken::Body;
use crate::scene::words::{DRAWN, MATERIALS, METHODS, SCALES};
use crate::scene::{EITHER, KEYS};

/// The schema (draft 2020-12). It describes the forms, the words, the ranges of numbers, which keys exclude each other, and
/// that an impact needs a speed. Of texts with a unit it refuses those of another dimension; the program itself checks more.
pub fn schema() -> Value {
    let mut root = table();
    for key in every_key() {
        let quantities = match &key.form {
            Form::Number(quantity) | Form::NumberOr(quantity, _) | Form::List(Form::Number(quantity)) => {
                vec![*quantity]
            }
            Form::List(Form::Pair(first, second)) => vec![*first, *second],
            _ => Vec::new(),
        };
        for quantity in quantities {
            root["$defs"][quantity.name] = quantity_of(quantity);
        }
    }
    for law in LawChoice::names() {
        insert(&mut root, &format!("law.{law}"), table());
    }
    for key in every_key() {
        let mut schema = of_form(&key.form);
        schema["description"] = json!(key.about);
        insert(&mut root, key.path, schema);
    }
    root["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    root["title"] = json!("Scenario of plm-impact");
    root["properties"]["law"]["minProperties"] = json!(1);
    root["properties"]["law"]["maxProperties"] = json!(1);
    let mut excluded = Map::new();
    for [one, other] in EITHER {
        let (Some((table, one)), Some((_, other))) = (one.split_once('.'), other.split_once('.')) else { continue };
        let pairs = excluded.entry(table).or_insert_with(|| json!([]));
        if let Some(pairs) = pairs.as_array_mut() {
            pairs.push(json!({ "not": { "required": [one, other] } }));
        }
    }
    for (table, pairs) in excluded {
        root["properties"][table]["allOf"] = pairs;
    }
    // without the table of another kind it is one impact, and that needs a speed
    let others: Vec<Value> = Kind::ALL[1..].iter().map(|(name, _)| json!({ "required": [name] })).collect();
    let speed = json!({ "anyOf": [{ "required": ["speed"] }, { "required": ["drop_height"] }] });
    root["anyOf"] = json!(others);
    if let Some(kinds) = root["anyOf"].as_array_mut() {
        kinds.push(json!({ "required": ["sphere", "half_space", "impact"], "properties": { "impact": speed } }));
    }
    root
}

/// A table whose keys are added later.
fn table() -> Value {
    json!({ "type": "object", "additionalProperties": false, "properties": {} })
}

/// A table of these keys, of which some are required.
fn table_of(properties: &Value, required: &[&str]) -> Value {
    json!({ "type": "object", "additionalProperties": false, "required": required, "properties": properties })
}

/// The two ends of a range.
fn two_of(value: &Value) -> Value {
    json!({ "type": "array", "items": value, "minItems": 2, "maxItems": 2 })
}

/// Puts the schema of a key where its path says; `[]` behind a name is a list of tables.
fn insert(root: &mut Value, path: &str, leaf: Value) {
    let (first, rest) = path.split_once('.').map_or((path, None), |(first, rest)| (first, Some(rest)));
    let (name, is_list) = first.strip_suffix("[]").map_or((first, false), |name| (name, true));
    let place = &mut root["properties"][name];
    match rest {
        None if place.is_null() => *place = leaf,
        None => {}
        Some(rest) if is_list => {
            if place.is_null() {
                *place = json!({ "type": "array", "items": table() });
            }
            insert(&mut place["items"], rest, leaf);
        }
        Some(rest) => {
            if place.is_null() {
                *place = table();
            }
            insert(place, rest, leaf);
        }
    }
}

fn of_form(form: &Form) -> Value {
    match form {
        Form::Number(quantity) => number(quantity, None),
        Form::NumberOr(quantity, word) => number(quantity, Some(word)),
        Form::Count(quantity) => ranged("integer", quantity),
        Form::Pair(first, second) => {
            json!({ "type": "array", "prefixItems": [number(first, None), number(second, None)], "minItems": 2, "maxItems": 2 })
        }
        Form::List(inner @ Form::Pair(..)) => json!({ "type": "array", "items": of_form(inner), "minItems": 2 }),
        Form::List(inner) => json!({ "type": "array", "items": of_form(inner) }),
        Form::Word(words) => one_of(words),
        Form::Text(_) => json!({ "type": "string" }),
        Form::Axes => axes(),
        Form::Variables => variables(),
        Form::Free => free(),
        Form::Table(_) | Form::Items(..) => table(),
        Form::WordOrTable(words, _) => {
            let mut schema = table();
            schema["type"] = json!(["string", "object"]);
            schema["pattern"] = json!(format!("^({})$", (words.known)().join("|")));
            schema
        }
    }
}

fn one_of(words: &Words) -> Value {
    json!({ "enum": (words.known)() })
}

/// A number, or the word.
fn number(quantity: &Quantity, word: Option<&str>) -> Value {
    let number = json!({ "$ref": format!("#/$defs/{}", quantity.name.replace(' ', "%20")) });
    match word {
        Some(word) => json!({ "anyOf": [number, { "const": word }] }),
        None => number,
    }
}

/// A number in SI within its range, or a text with a unit that is not one of another dimension.
fn quantity_of(quantity: &Quantity) -> Value {
    let others: Vec<String> = quantity.dimension.units_of_others().map(|unit| unit.replace('^', "\\^")).collect();
    let pattern = format!("^(?!.*[0-9.\\s]({})\\s*$)\\s*[+\u{2212}-]?[0-9.]", others.join("|"));
    let example = quantity.example.trim_matches('"');
    let text = json!({ "type": "string", "pattern": pattern, "examples": [example] });
    json!({ "anyOf": [ranged("number", quantity), text] })
}

fn ranged(kind: &str, quantity: &Quantity) -> Value {
    let mut schema = Map::from_iter([("type".to_owned(), json!(kind))]);
    let mut bound = |open: &str, closed: &str, bound: Bound| match bound {
        Bound::Open(value) if value.is_finite() => drop(schema.insert(open.to_owned(), json!(value))),
        Bound::Closed(value) => drop(schema.insert(closed.to_owned(), json!(value))),
        Bound::Open(_) => {}
    };
    bound("exclusiveMinimum", "minimum", quantity.low);
    bound("exclusiveMaximum", "maximum", quantity.high);
    Value::Object(schema)
}

/// `[sweep]`: numeric keys with values, and the keys with words.
fn axes() -> Value {
    let mut schema = table();
    for key in KEYS.iter() {
        let value = number(key.quantity, None);
        let space = |name: &str| {
            let properties = json!({ name: two_of(&value), "points": { "type": "integer", "minimum": 1 } });
            table_of(&properties, &[name, "points"])
        };
        let list = json!({ "type": "array", "items": value, "minItems": 1 });
        schema["properties"][key.path] = json!({ "anyOf": [list, space("linspace"), space("logspace")] });
    }
    let words = |item: Value| json!({ "type": "array", "items": item, "minItems": 1 });
    schema["properties"]["solver.method"] = words(one_of(&METHODS));
    schema["properties"]["law"] = words(json!({ "type": "string" }));
    for body in Body::ALL {
        schema["properties"][body.material()] = words(one_of(&MATERIALS));
    }
    schema
}

/// `calibrate.free`: numeric keys with ranges.
fn free() -> Value {
    let mut schema = table();
    for key in KEYS.iter() {
        let end = number(key.quantity, None);
        let properties = json!({ "from": end, "to": end, "scale": one_of(&SCALES) });
        schema["properties"][key.path] = table_of(&properties, &["from", "to"]);
    }
    schema["minProperties"] = json!(1);
    schema["maxProperties"] = json!(2);
    schema
}

/// `[monte_carlo]`: numeric keys with distributions.
fn variables() -> Value {
    let mut schema = table();
    for key in KEYS.iter() {
        let value = number(key.quantity, None);
        let spread = json!({ "anyOf": [{ "type": "number", "exclusiveMinimum": 0 }, { "type": "string" }] });
        let moments = table_of(&json!({ "mean": value, "sd": spread }), &["mean", "sd"]);
        schema["properties"][key.path] = json!({
            "type": "object",
            "minProperties": 1,
            "maxProperties": 1,
            "additionalProperties": false,
            "properties": {
                "normal": moments,
                "lognormal": moments,
                "uniform": two_of(&value)
            }
        });
    }
    for body in Body::ALL {
        schema["properties"][body.material()] = one_of(&DRAWN);
    }
    schema["properties"]["samples"] = json!({ "type": "integer", "minimum": 1, "description": "Number of cases." });
    schema["properties"]["seed"] =
        json!({ "type": "integer", "minimum": 0, "description": "Which random numbers; 0 if left out." });
    schema["required"] = json!(["samples"]);
    schema
}
