//! The tables of the reference page, made from the registries: every key, and every result.

use std::fmt::Write as _;

use super::key::Form;
use super::keys::KEYS;
use super::other_keys::OTHER_KEYS;
use super::quantity::Quantity;
use super::results::{Described, files};
use crate::law::LawChoice;
use crate::materials::Property;

/// All keys as Markdown, a table for every table of a scenario.
pub fn keys() -> String {
    let numeric = KEYS.iter().map(|key| Row {
        path: key.path,
        written: written(&Form::Number(key.quantity, key.word)),
        default: key.default,
        about: key.about,
        varies: true,
    });
    let others = OTHER_KEYS.iter().map(|key| Row {
        path: key.path,
        written: written(&key.form),
        default: key.default,
        about: key.about,
        varies: false,
    });
    let rows: Vec<Row> = numeric.chain(others).collect();
    let mut tables: Vec<&str> = Vec::new();
    for row in &rows {
        if !tables.contains(&row.table()) {
            tables.push(row.table());
        }
    }
    // the tables in the order of the registry, those of the laws together
    tables.sort_by_key(|table| rows.iter().position(|row| row.path.split('.').next() == table.split('.').next()));
    let mut text = String::new();
    for table in tables {
        let _ = writeln!(text, "### {}\n\n| key | value | default | meaning |\n|---|---|---|---|", heading(table));
        for row in rows.iter().filter(|row| row.table() == table) {
            let axis = if row.varies { " \u{2195}" } else { "" };
            let default = if row.default.is_empty() { "\u{2013}" } else { row.default };
            let _ = writeln!(text, "| `{}`{axis} | {} | {default} | {} |", row.name(), row.written, row.about);
        }
        text.push('\n');
    }
    text
}

/// A line of the page.
struct Row {
    path: &'static str,
    written: String,
    default: &'static str,
    about: &'static str,
    varies: bool,
}

impl Row {
    /// The table that the key stands in; `sweep` and `monte_carlo` are tables themselves.
    fn table(&self) -> &'static str {
        self.path.rsplit_once('.').map_or(self.path, |(table, _)| table)
    }

    fn name(&self) -> &'static str {
        self.path.rsplit('.').next().unwrap_or(self.path)
    }
}

fn heading(table: &str) -> String {
    let name = match table.strip_suffix("[]") {
        Some(list) => format!("`[[{list}]]`"),
        None => format!("`[{table}]`"),
    };
    let law = table.strip_prefix("law.").and_then(LawChoice::from_name);
    law.map_or(name.clone(), |law| format!("{name}: {}", law.about().title))
}

/// A key with more words than this refers to a table of them.
const MOST_WORDS: usize = 20;

/// What may be written as the value of a key, as Markdown.
pub fn written(form: &Form) -> String {
    let number = |quantity: &Quantity| format!("{} {}", quantity.name, quantity.allowed());
    match form {
        Form::Number(quantity, None) => number(quantity),
        Form::Number(quantity, Some(word)) => format!("{}, or `\"{word}\"`", number(quantity)),
        Form::Count(quantity) => format!("a whole number {}", quantity.allowed()),
        Form::Numbers(quantity) => format!("a list of numbers, each {}", number(quantity)),
        Form::Pairs(first, second) => {
            format!(
                "a list of pairs such as `[[{}, {}]]`: {} and {}",
                first.example,
                second.example,
                number(first),
                number(second)
            )
        }
        Form::Word(words) if (words.known)().len() > MOST_WORDS => {
            format!("one of the [{0}](#{0}) below", words.several)
        }
        Form::Word(words) => quoted(&(words.known)()),
        Form::WordList(words) => format!("a list of {}", quoted(&(words.known)())),
        Form::Text(example) => format!("a text such as `\"{example}\"`"),
        Form::Axes | Form::Variables | Form::Free => "a table, see below".to_owned(),
        Form::WordOrTable(words) => format!("{}, or a table", quoted(&(words.known)())),
    }
}

fn quoted(words: &[String]) -> String {
    words.iter().map(|word| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", ")
}

/// A part of a page that the program writes.
struct Part {
    /// The marks before and after it.
    marks: [&'static str; 2],
    /// Its text.
    text: fn() -> String,
}

const PARTS: [Part; 3] = [
    Part { marks: ["<!-- keys: written by `plm-impact reference` -->", "<!-- end of keys -->"], text: keys },
    Part { marks: ["<!-- results: written by `plm-impact reference` -->", "<!-- end of results -->"], text: results },
    Part {
        marks: ["<!-- materials: written by `plm-impact reference` -->", "<!-- end of materials -->"],
        text: materials,
    },
];

/// Keys, results and materials as Markdown.
pub fn page() -> String {
    PARTS.iter().map(|part| (part.text)()).collect()
}

/// A page with the text between the marks written anew.
///
/// # Errors
/// The marks that the page lacks.
pub fn renewed(page: &str) -> Result<String, [&'static str; 2]> {
    let write = |page: String, Part { marks: [begin, end], text }: &Part| {
        let (before, rest) = page.split_once(begin)?;
        let (_, after) = rest.split_once(end)?;
        Some(format!("{before}{begin}\n\n{}{end}{after}", text()))
    };
    PARTS.iter().try_fold(page.to_owned(), |page, part| write(page, part).ok_or(part.marks))
}

/// All results as Markdown, a table for every file, or part of one, that has them.
pub fn results() -> String {
    files().iter().fold(String::new(), |mut text, (title, results)| {
        let _ = writeln!(text, "### {title}\n\n| name | meaning | when it is there |\n|---|---|---|");
        for Described { name, about, condition, is_column } in results {
            let mark = if *is_column { " \u{25a6}" } else { "" };
            let condition = if condition.is_empty() { "always" } else { condition };
            let _ = writeln!(text, "| `{name}`{mark} | {about} | {condition} |");
        }
        text.push('\n');
        text
    })
}

/// All materials as Markdown.
fn materials() -> String {
    let mut text = "| name | material | density | E | ν | hardness | N |\n|---|---|---|---|---|---|---|\n".to_owned();
    for entry in crate::materials::all() {
        let value =
            |property| entry.of(property).map_or_else(|| "\u{2013}".to_owned(), |known| known.taken.text.clone());
        let [density, modulus, ratio, hardness, exponent] = Property::ALL.map(value);
        let (name, title) = (&entry.name, &entry.title);
        let _ = writeln!(text, "| `{name}` | {title} | {density} | {modulus} | {ratio} | {hardness} | {exponent} |");
    }
    text.push('\n');
    text
}
