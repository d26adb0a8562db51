//! Reads values as they are written. A refusal reports the value, the allowed range and the remedy.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use crate::materials;
use crate::scenario::keys::words::unknown_material;
use crate::scenario::keys::{ALL_KEYS, KeySpec, Quantity, WordList};
use crate::scenario::toml_node::{TomlKey, TomlValue, describe_value, join_path, whole_number};
use crate::strings::{did_you_mean, known_names};

/// A refused value: its span, and the reason.
#[derive(Debug, Clone)]
pub struct ValueError {
    pub span: Range<usize>,
    /// The value, the allowed range and the remedy.
    pub message: String,
}

impl ValueError {
    /// A refusal of the value at this span.
    pub fn new(node: &TomlValue, message: impl Into<String>) -> Self {
        Self { span: node.span(), message: message.into() }
    }

    /// The refusal of a value of the wrong kind.
    pub fn wrong_type(node: &TomlValue, expected: &str) -> Self {
        Self::new(node, format!("found {}, expected {expected}", describe_value(node)))
    }
}

/// Reads the file of this name, relative to the scenario, for the key of this path: returns its path and its text.
pub type FileReader<'f> = &'f mut dyn FnMut(&str, &str) -> Result<[String; 2], String>;

/// Reads the tables of a scenario and collects the refusals.
pub struct Reader<'f> {
    /// The table or key that is read, with dots.
    pub path: String,
    /// Keys whose value or name is refused.
    pub errors: Vec<(String, ValueError)>,
    pub has_unknown: bool,
    files: FileReader<'f>,
}

impl<'f> Reader<'f> {
    /// A reader at the top of a scenario.
    pub fn new(files: FileReader<'f>) -> Self {
        Self { path: String::new(), errors: Vec::new(), has_unknown: false, files }
    }

    /// Reads the value of this name; a refusal is collected.
    pub fn in_table(&mut self, name: &str, read: impl FnOnce(&mut Self) -> Result<(), ValueError>) {
        let inner = join_path(&self.path, name);
        let outer = std::mem::replace(&mut self.path, inner);
        if let Err(fault) = read(self) {
            self.errors.push((self.path.clone(), fault));
        }
        self.path = outer;
    }

    /// Path and text of the file that this key names.
    pub fn file(&mut self, node: &TomlValue, example: &str) -> Result<[String; 2], ValueError> {
        (self.files)(&self.path, read_text(node, example)?).map_err(|message| ValueError::new(node, message))
    }

    /// Refuses keys that are not in `known`, the names of the keys of this table.
    pub fn refuse_unknown(&mut self, name: &TomlKey, known: &[&str]) {
        let (thing, things) = match self.path.as_str() {
            "" => ("table", "tables"),
            "law" => ("law", "laws"),
            _ => ("key", "keys here"),
        };
        let written = name.get_ref();
        self.has_unknown = true;
        let message = if known.is_empty() {
            format!("unknown {thing} `{written}`; this table has no keys")
        } else {
            let all = known_names(written, known, things);
            let hint = keys_of_this_name(&self.path, written)
                .unwrap_or_else(|| did_you_mean(written, known.iter().copied(), '`', &all));
            let way = match &**written {
                "plate" if self.path.is_empty() => " A plate has `half_space.thickness`.",
                "rod" if self.path.is_empty() => " A rod has `half_space.rod_diameter`.",
                _ => "",
            };
            format!("unknown {thing} `{written}`{hint}{way}")
        };
        self.in_table(written, |_| Err(ValueError { span: name.span(), message }));
    }
}

/// A hint at the keys that end in a name which is given as a table.
fn keys_of_this_name(path: &str, name: &str) -> Option<String> {
    // `plate` is a key of the half-space, but a user who writes a table of this name means the body
    let ends = |key: &&KeySpec| {
        let (table, last) = key.path.rsplit_once('.').unwrap_or_default();
        last == name && !table.contains('.') && name != "plate"
    };
    let keys: Vec<&str> = ALL_KEYS.iter().filter(ends).map(|key| key.path).filter(|_| path.is_empty()).collect();
    match &keys[..] {
        [] => None,
        [one] => Some(format!(", did you mean `{one}`?")),
        several => Some(format!(", did you mean one of `{}`?", several.join("`, `"))),
    }
}

/// A number in SI, or a text with a unit; infinite for the word in place of the number.
pub fn read_number(quantity: &Quantity, word: Option<&str>, node: &TomlValue) -> Result<f64, ValueError> {
    let or = |begin: &str| word.map_or_else(String::new, |word| format!("{begin} \"{word}\""));
    let value = match node.get_ref() {
        DeValue::String(text) if word.is_some_and(|word| text.trim() == word) => return Ok(f64::INFINITY),
        DeValue::String(text) => {
            return quantity.parse(text).map_err(|message| ValueError::new(node, message + &or("; or write")));
        }
        DeValue::Integer(digits) => whole_number(digits),
        DeValue::Float(digits) => digits.as_str().parse().ok(),
        _ => None,
    };
    let expected = || format!("{} such as {}{}", quantity.name, quantity.example, or(", or"));
    let value = value.ok_or_else(|| ValueError::wrong_type(node, &expected()))?;
    quantity.check_si_number(value).map_err(|message| ValueError::new(node, message))
}

/// A whole number.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, and below 2^64
pub fn read_count(quantity: &Quantity, node: &TomlValue) -> Result<u64, ValueError> {
    const U64_LIMIT: f64 = 18_446_744_073_709_551_616.0;
    if let DeValue::String(_) = node.get_ref() {
        return Err(ValueError::wrong_type(node, &format!("a whole number such as {}", quantity.example)));
    }
    let value = read_number(quantity, None, node)?;
    // above 2^53 only the digits show the number
    let whole =
        node.get_ref().as_integer().and_then(|digits| u64::from_str_radix(digits.as_str(), digits.radix()).ok());
    match whole {
        Some(whole) => Ok(whole),
        None if value.fract() == 0.0 && value < U64_LIMIT => Ok(value as u64),
        None => {
            let message = format!("{value} is not allowed: {} must be a whole number below 2^64", quantity.name);
            Err(ValueError::new(node, message))
        }
    }
}

/// Two numbers.
pub fn read_pair(quantities: [&Quantity; 2], node: &TomlValue) -> Result<[f64; 2], ValueError> {
    let example = quantities.map(|quantity| quantity.example).join(", ");
    match read_list(node, &format!("[{example}]"))? {
        [one, other] => Ok([read_number(quantities[0], None, one)?, read_number(quantities[1], None, other)?]),
        items => Err(ValueError::new(node, format!("has {} numbers; write two, such as [{example}]", items.len()))),
    }
}

pub fn read_list<'n, 't>(node: &'n TomlValue<'t>, example: &str) -> Result<&'n [TomlValue<'t>], ValueError> {
    match node.get_ref() {
        DeValue::Array(items) => Ok(items),
        _ => Err(ValueError::wrong_type(node, &format!("a list in [ ] such as {example}"))),
    }
}

/// Any text.
pub fn read_text<'n>(node: &'n TomlValue, example: &str) -> Result<&'n str, ValueError> {
    match node.get_ref() {
        DeValue::String(text) => Ok(text),
        _ => Err(ValueError::wrong_type(node, &format!("a text in quotes such as \"{example}\""))),
    }
}

/// True or false, without quotes.
pub fn read_flag(node: &TomlValue) -> Result<bool, ValueError> {
    match node.get_ref() {
        DeValue::Boolean(flag) => Ok(*flag),
        _ => Err(ValueError::wrong_type(node, "true or false, without quotes")),
    }
}

/// The index of a word in the list of known words.
pub fn read_word(words: &WordList, node: &TomlValue) -> Result<usize, ValueError> {
    find_word(words, node, |given| {
        let name = match words.singular {
            "material" => materials::find(given).map_or(given, |entry| entry.name.as_str()),
            _ => given,
        };
        (words.values)().iter().position(|word| word == name)
    })
}

/// Reads a word, and finds its meaning.
pub fn find_word<T>(words: &WordList, node: &TomlValue, find: impl FnOnce(&str) -> Option<T>) -> Result<T, ValueError> {
    let known = (words.values)();
    let given = read_text(node, known.first().map_or("", String::as_str))?;
    find(given).ok_or_else(|| {
        let all: Vec<String> = known.iter().map(|word| format!("\"{word}\"")).collect();
        let all: Vec<&str> = all.iter().map(String::as_str).collect();
        let hint = match words.singular {
            "material" => unknown_material(given),
            _ => did_you_mean(given, known.iter().map(String::as_str), '"', &known_names(given, &all, words.plural)),
        };
        ValueError::new(node, format!("unknown {} \"{given}\"{hint}", words.singular))
    })
}

pub fn as_table<'n, 't>(node: &'n TomlValue<'t>) -> Result<&'n DeTable<'t>, ValueError> {
    match node.get_ref() {
        DeValue::Table(table) => Ok(table),
        _ => Err(ValueError::wrong_type(node, "a table")),
    }
}
