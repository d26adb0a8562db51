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

/// Where the value of a dotted key is.
pub(super) fn span_of(table: &DeTable<'_>, path: &str) -> Option<Range<usize>> {
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
        let (thing, things) = match (message.starts_with("unknown variant"), key.contains('.')) {
            (true, _) => ("law", "laws"),
            (false, true) => ("key", "keys here"),
            (false, false) => ("table", "tables"),
        };
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
    message.trim_end().to_owned()
}

/// What is said where `name` is missing in `table` (empty: the table of that name).
pub(super) fn missing(name: &str, table: &str) -> String {
    if table.is_empty() {
        return format!("the table [{name}] is missing");
    }
    match Key::find(&format!("{table}.{name}")) {
        Some(key) => {
            format!("the key `{name}` is missing: {} such as {name} = {}", key.quantity.name, key.quantity.example)
        }
        None => format!("the key `{name}` is missing"),
    }
}
