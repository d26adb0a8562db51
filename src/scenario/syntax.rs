//! Messages about a text that is no TOML, in the words of somebody who has not read the specification of TOML.

use std::ops::Range;

/// What is wrong with the text at this place, and what to write; `message` is that of the parser.
pub(super) fn syntax_message(text: &str, span: Option<&Range<usize>>, message: &str) -> String {
    let plain = || message.trim_end().replace('\n', "; ");
    let Some(span) = span else { return plain() };
    if message.starts_with("string values must be quoted") {
        return quotes_message(text, span.start).unwrap_or_else(plain);
    }
    if message.starts_with("duplicate key") {
        return duplicate_message(text, span).unwrap_or_else(plain);
    }
    plain()
}

/// A value with a unit, or a word, that has no quotes.
fn quotes_message(text: &str, start: usize) -> Option<String> {
    let rest = text.get(start..)?.lines().next()?;
    let value = rest.split('#').next()?.trim().trim_end_matches(',');
    let is_list = value.contains([',', ']', '}']);
    (!value.is_empty() && !is_list && !value.contains('"'))
        .then(|| format!("a value with a unit, and a word, needs quotes. Write \"{value}\""))
}

/// A table or a key that is there twice.
fn duplicate_message(text: &str, span: &Range<usize>) -> Option<String> {
    let name = text.get(span.clone())?.trim();
    let (before, line) = (text.get(..span.start)?, text.get(span.start..)?.lines().next()?);
    let is_table = before.rsplit('\n').next()?.trim_start().starts_with('[');
    let shown = if is_table { format!("[{}]", line.split(']').next()?) } else { format!("`{name}`") };
    let begins = |line: &str| {
        let line = line.trim_start();
        if is_table {
            line.starts_with(&shown)
        } else {
            line.strip_prefix(name).is_some_and(|rest| rest.trim_start().starts_with('='))
        }
    };
    // a key is there twice in its own table
    let table = if is_table { 0 } else { before.rfind("\n[").map_or(0, |at| at + 1) };
    let first = before[table..].lines().position(begins)? + before[..table].matches('\n').count() + 1;
    let way_out = if is_table { "Put all keys below one of the two." } else { "Remove one of the two." };
    Some(format!("{shown} is there twice, first in line {first}. {way_out}"))
}
