//! Messages about a text that is no TOML, in the words of somebody who has not read the specification of TOML.

use std::ops::Range;

/// The mistake in the text at this position, and the remedy; `message` comes from the parser.
pub(super) fn syntax_message(text: &str, span: Option<&Range<usize>>, message: &str) -> String {
    let known = span.and_then(|span| {
        if message.starts_with("duplicate key") {
            duplicate_message(text, span)
        } else {
            quotes_message(text, span.start)
        }
    });
    known.unwrap_or_else(|| message.trim_end().replace('\n', "; "))
}

/// A value with a unit, a word, or a number with a decimal comma, that has no quotes.
fn quotes_message(text: &str, at: usize) -> Option<String> {
    let begin = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let (key, rest) = text.get(begin..)?.lines().next()?.split_once('=')?;
    let value = rest.split('#').next()?.trim();
    if at <= begin + key.len() || value.contains(['"', '\'', '[', '{', '=']) {
        return None;
    }
    let with_point = match value.split_once(',') {
        Some((whole, rest)) if is_digits(whole.trim_start_matches(['-', '+'])) && rest.starts_with(is_digit) => {
            Some(format!("{whole}.{rest}"))
        }
        // a list, or numbers with signs between thousands
        Some(_) => return None,
        None => None,
    };
    let meant = with_point.as_deref().unwrap_or(value);
    if meant.contains(char::is_alphabetic) {
        return Some(format!("values with units, and words, need quotes. Write \"{meant}\""));
    }
    let number = with_point.filter(|number| number.parse::<f64>().is_ok())?;
    Some(format!("a number needs a decimal point, not a comma. Write {number}"))
}

fn is_digit(character: char) -> bool {
    character.is_ascii_digit()
}

fn is_digits(text: &str) -> bool {
    !text.is_empty() && text.chars().all(is_digit)
}

/// A table or a key that is there twice.
fn duplicate_message(text: &str, span: &Range<usize>) -> Option<String> {
    let name = text.get(span.clone())?.trim();
    let (before, line) = (text.get(..span.start)?, text.get(span.start..)?.lines().next()?);
    let begin = before.rfind('\n').map_or(0, |end| end + 1);
    let table = header(&format!("{}{line}", &before[begin..])).map(str::to_owned);
    let begins = |line: &str| match &table {
        Some(table) => header(line) == Some(table.as_str()),
        None => line.trim_start().strip_prefix(name).is_some_and(|rest| rest.trim_start().starts_with('=')),
    };
    // a key is there twice in its own table
    let from = if table.is_some() { 0 } else { before.rfind("\n[").map_or(0, |at| at + 1) };
    let first = before[from..begin.max(from)].lines().position(begins);
    let first = first.map(|line| line + before[..from].matches('\n').count() + 1);
    let first = first.map_or_else(String::new, |line| format!(", first in line {line}"));
    Some(match table {
        Some(table) => format!("[{table}] is given twice{first}. Put all keys below one of the two."),
        None => format!("`{name}` is given twice{first}. Remove one of the two."),
    })
}

/// The name in the line that begins a table.
fn header(line: &str) -> Option<&str> {
    Some(line.trim_start().strip_prefix('[')?.split(']').next()?.trim())
}
