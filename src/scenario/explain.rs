//! Where in a document an error is, and what it means for someone who writes scenarios.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::keys::Key;
use crate::nearest::nearest;

/// The dotted key whose name or value holds `span`.
pub(super) fn key_at(table: &DeTable<'_>, span: &Range<usize>) -> Option<String> {
    table.iter().find_map(|(key, value)| {
        let name = key.get_ref().as_ref();
        if let DeValue::Table(inner) = value.get_ref()
            && let Some(rest) = key_at(inner, span)
        {
            return Some(format!("{name}.{rest}"));
        }
        let holds = |outer: Range<usize>| outer.start <= span.start && span.end <= outer.end;
        (holds(key.span()) || holds(value.span())).then(|| name.to_owned())
    })
}

/// Where the value of a dotted key is; the last part may be a key in quotes with dots of its own.
pub(super) fn span_of(table: &DeTable<'_>, path: &str) -> Option<Range<usize>> {
    if let Some(value) = table.get(path) {
        return Some(value.span());
    }
    let (name, rest) = path.split_once('.').map_or((path, None), |(name, rest)| (name, Some(rest)));
    let value = table.get(name)?;
    match (rest, value.get_ref()) {
        (None, _) => Some(value.span()),
        (Some(rest), DeValue::Table(inner)) => span_of(inner, rest),
        _ => None,
    }
}

const ONE_LAW: &str = "write one table such as [law.plm], or leave [law] out";

/// The message of serde or toml in the words of a scenario; `key` is what it is about.
pub(super) fn explain(message: &str, key: &mut String, root: &DeTable<'_>) -> String {
    let mut quoted = message.split('`').skip(1).step_by(2);
    let known: Vec<&str> = quoted.clone().skip(1).collect();
    let first = quoted.next().unwrap_or_default();
    if message.starts_with("missing field") {
        return missing(first, key);
    }
    if message.starts_with("unknown field") || message.starts_with("unknown variant") {
        let guess =
            nearest(first, known.iter().copied()).map_or_else(String::new, |near| format!(", did you mean `{near}`?"));
        let (thing, things) = match (message.starts_with("unknown variant"), key.matches('.').count()) {
            (true, ..=1) => ("law", "laws"),
            (true, _) => ("word", "words here"),
            (false, 0) => ("table", "tables"),
            (false, _) => ("key", "keys here"),
        };
        if known.is_empty() {
            return format!("unknown {thing} `{first}`; this table takes none");
        }
        return format!("unknown {thing} `{first}`{guess}; {things} are {}", known.join(", "));
    }
    if message.starts_with("wanted exactly 1 element") {
        // the tables under [law] are where [law] itself is
        key.truncate(key.find('.').unwrap_or(key.len()));
        let found: Vec<&str> = match root.get(key.as_str()).map(toml::Spanned::get_ref) {
            Some(DeValue::Table(laws)) => laws.keys().map(|name| name.get_ref().as_ref()).collect(),
            _ => Vec::new(),
        };
        let found = if found.is_empty() { "none".to_owned() } else { found.join(" and ") };
        return format!("a scenario has exactly one law, found {found}; {ONE_LAW}");
    }
    if key == "law" {
        return format!("not a table; {ONE_LAW}");
    }
    in_words(message.trim_end())
}

/// What serde and toml call the kinds of values, and what a person does.
const KINDS: [(&str, &str); 17] = [
    ("wanted string or table", "not a text: write a word in quotes"),
    ("invalid type: ", "found the "),
    ("invalid value: ", "found the "),
    ("invalid length ", "found a number of values of "),
    ("expected a string", "expected a text in quotes"),
    ("expected path string", "expected the name of a file in quotes"),
    ("expected a sequence", "expected a list in [ ]"),
    ("expected a map", "expected a table"),
    ("expected u64", "expected a whole number, 0 or more"),
    ("found the string", "found the text"),
    ("found the integer", "found the number"),
    ("found the floating point", "found the number"),
    ("found the boolean ", "found "),
    ("found the sequence", "found a list"),
    ("found the map", "found a table or a date"),
    ("floating point", "number"),
    ("` as i128", "`"),
];

fn in_words(message: &str) -> String {
    KINDS.iter().fold(message.to_owned(), |message, (kind, word)| message.replace(kind, word))
}

/// What is said where `name` is missing in `table` (empty: the table of that name).
pub(super) fn missing(name: &str, table: &str) -> String {
    if table.is_empty() {
        let way_out = match name {
            "sphere" => "; give its radius, youngs_modulus, poissons_ratio and density",
            "half_space" => "; give its youngs_modulus, poissons_ratio and, unless it is elastic, yield_strength",
            "impact" => "; give it with a speed such as speed = \"3 m/s\"",
            _ => "",
        };
        return format!("the table [{name}] is missing{way_out}");
    }
    let example = match (table, name) {
        ("law.combined", "loading") => Some("the law that loads, such as loading = \"plm\""),
        ("law.combined", "unloading") => Some("the law that unloads, such as unloading = \"thornton\""),
        ("indentation", "steps") => Some("a list such as steps = [{ load = \"200 N\" }, { load = \"0 N\" }]"),
        ("indentation.half_space", "name") => Some("what the material is called, such as name = \"Ti-10Nb\""),
        _ => None,
    };
    if let Some(example) = example {
        return format!("the key `{name}` is missing: {example}");
    }
    match Key::find(&format!("{table}.{name}")) {
        Some(key) => {
            format!("the key `{name}` is missing: {} such as {name} = {}", key.quantity.name, key.quantity.example)
        }
        None => format!("the key `{name}` is missing"),
    }
}
