//! Values as they stand in a file, read and checked by the form that the registry gives their key.

use std::ops::Range;

use toml::Spanned;
use toml::de::DeValue;

use crate::scene::key::Form;
use crate::scene::quantity::Quantity;
use crate::scene::words::Words;
use crate::units::nearest::did_you_mean;

/// A value that was read.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Value {
    /// A number in SI.
    Number(f64),
    /// Numbers in SI.
    Numbers(Vec<f64>),
    /// Pairs of numbers in SI.
    Pairs(Vec<[f64; 2]>),
    /// A text, or a word that is known.
    Text(String),
    /// Words that are known.
    Texts(Vec<String>),
}

/// A value that is refused: where it stands, and why.
#[derive(Debug)]
pub(super) struct Fault {
    pub(super) span: Range<usize>,
    pub(super) message: String,
}

impl Fault {
    pub(super) fn at<T>(place: &Spanned<T>, message: impl Into<String>) -> Self {
        Self { span: place.span(), message: message.into() }
    }

    /// This fault as the refusal of a key.
    pub(super) fn of(self, key: impl Into<String>) -> Refused {
        Refused { key: key.into(), fault: self }
    }
}

/// A key whose value or name is refused, and why.
#[derive(Debug)]
pub(super) struct Refused {
    pub(super) key: String,
    pub(super) fault: Fault,
}

/// Reads a value of this form.
pub(super) fn read(form: &Form, value: &Spanned<DeValue>) -> Result<Value, Fault> {
    match form {
        Form::Number(quantity, word) => number(quantity, *word, value).map(Value::Number),
        Form::Count(quantity) => count(quantity, value).map(Value::Number),
        Form::Numbers(quantity) => numbers(quantity, value).map(Value::Numbers),
        Form::Pairs(first, second) => pairs(first, second, value).map(Value::Pairs),
        Form::Word(words) | Form::WordOrTable(words) => word(words, value).map(Value::Text),
        Form::WordList(words) => {
            let example = (words.known)().first().cloned().unwrap_or_default();
            list(value, &format!("[\"{example}\"]"))?
                .iter()
                .map(|item| word(words, item))
                .collect::<Result<_, _>>()
                .map(Value::Texts)
        }
        Form::Text(example) => text(value, example).map(Value::Text),
        Form::Axes | Form::Variables | Form::Free => Err(Fault::at(value, "is read by itself")),
    }
}

/// What was found in place of a value, for messages.
pub(super) fn described(value: &DeValue) -> String {
    match value {
        DeValue::String(text) => format!("\"{text}\""),
        DeValue::Integer(number) => format!("`{number}`"),
        DeValue::Float(number) => format!("`{number}`"),
        DeValue::Boolean(word) => format!("`{word}`"),
        DeValue::Datetime(date) => format!("the date `{date}`"),
        DeValue::Array(_) => "a list".to_owned(),
        DeValue::Table(_) => "a table".to_owned(),
    }
}

/// The refusal of a value of the wrong kind.
pub(super) fn unexpected(value: &Spanned<DeValue>, expected: &str) -> Fault {
    Fault::at(value, format!("found {}, expected {expected}", described(value.get_ref())))
}

/// A number in SI, or a text with a unit, or the word, which stands for an infinite number.
#[allow(clippy::cast_precision_loss)] // an integer is read as if it had been written with a decimal point
pub(super) fn number(quantity: &Quantity, word: Option<&str>, value: &Spanned<DeValue>) -> Result<f64, Fault> {
    let or_word = word.map_or_else(String::new, |word| format!(", or \"{word}\""));
    let read = match value.get_ref() {
        // hexadecimal digits are not read as decimal ones, however many they are
        DeValue::Integer(digits) if digits.radix() != 10 => {
            u128::from_str_radix(digits.as_str(), digits.radix()).map(|number| number as f64).ok()
        }
        DeValue::Integer(digits) => digits.as_str().parse().ok(),
        DeValue::Float(digits) => digits.as_str().parse().ok(),
        DeValue::String(text) if word.is_some_and(|word| word == text.trim()) => return Ok(f64::INFINITY),
        DeValue::String(text) => {
            let or_write = word.map_or_else(String::new, |word| format!("; or write \"{word}\""));
            return quantity.parse(text).map_err(|message| Fault::at(value, format!("{message}{or_write}")));
        }
        _ => return Err(unexpected(value, &format!("{} such as {}{or_word}", quantity.name, quantity.example))),
    };
    let read = read.ok_or_else(|| unexpected(value, &format!("{} such as {}", quantity.name, quantity.example)))?;
    quantity.check(read).map_err(|error| Fault::at(value, error.to_string()))
}

/// A whole number.
pub(super) fn count(quantity: &Quantity, value: &Spanned<DeValue>) -> Result<f64, Fault> {
    let read = number(quantity, None, value)?;
    if read.fract() == 0.0 {
        return Ok(read);
    }
    Err(Fault::at(value, format!("{read} is not allowed: {} must be a whole number", quantity.name)))
}

/// Several numbers in a list.
pub(super) fn numbers(quantity: &Quantity, value: &Spanned<DeValue>) -> Result<Vec<f64>, Fault> {
    list(value, &format!("[{}]", quantity.example))?.iter().map(|item| number(quantity, None, item)).collect()
}

/// Several pairs of numbers, each in a list of two.
fn pairs(first: &Quantity, second: &Quantity, value: &Spanned<DeValue>) -> Result<Vec<[f64; 2]>, Fault> {
    let example = format!("[{}, {}]", first.example, second.example);
    let pair = |item: &Spanned<DeValue>| match list(item, &example)? {
        [one, other] => Ok([number(first, None, one)?, number(second, None, other)?]),
        items => Err(Fault::at(item, format!("has {} numbers; write two, such as {example}", items.len()))),
    };
    list(value, &format!("[{example}]"))?.iter().map(pair).collect()
}

/// The items of a list.
pub(super) fn list<'v, 'i>(
    value: &'v Spanned<DeValue<'i>>,
    example: &str,
) -> Result<&'v [Spanned<DeValue<'i>>], Fault> {
    match value.get_ref() {
        DeValue::Array(items) => Ok(items),
        _ => Err(unexpected(value, &format!("a list in [ ] such as {example}"))),
    }
}

/// Any text.
pub(super) fn text(value: &Spanned<DeValue>, example: &str) -> Result<String, Fault> {
    match value.get_ref() {
        DeValue::String(text) => Ok(text.to_string()),
        _ => Err(unexpected(value, &format!("a text in quotes such as \"{example}\""))),
    }
}

/// A word that is known.
pub(super) fn word(words: &Words, value: &Spanned<DeValue>) -> Result<String, Fault> {
    let known = (words.known)();
    let given = text(value, known.first().map_or("", String::as_str))?;
    if known.contains(&given) {
        return Ok(given);
    }
    let all: Vec<String> = known.iter().map(|word| format!("\"{word}\"")).collect();
    let all = format!("{} are {}", words.several, all.join(", "));
    let hint = did_you_mean(&given, known.iter().map(String::as_str), '"', &all);
    Err(Fault::at(value, format!("unknown {} \"{given}\"{hint}", words.one)))
}
