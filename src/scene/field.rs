//! The fields of tables: how each type takes the value of a key, and gives it back.

use super::key::Form;
use super::quantity::Quantity;
use super::read::{Fault, Reader, count, list, number, pair, text, word};
use super::written::{Node, Value};

/// What is given for a numeric key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Given {
    /// A number in SI.
    Number(f64),
    /// The word that may stand in its place.
    Word,
}

/// A key and its value, for reports.
#[derive(Debug, Clone, PartialEq)]
pub struct Held {
    /// As in the file, with dots.
    pub path: String,
    /// Of a number.
    pub quantity: Option<&'static Quantity>,
    /// In SI, or a word.
    pub value: serde_json::Value,
}

/// A field of a table: where the value of a key is kept.
pub trait Field {
    /// Takes the value that stands there, written in this form.
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault>;
    /// The number that it has, for a key that may vary.
    fn given(&self) -> Option<Given> {
        None
    }
    /// Puts a checked number there, SI, or nothing.
    fn put(&mut self, _: Option<f64>) {}
    /// Adds what it has, for reports.
    fn show(&self, form: &Form, path: &str, into: &mut Vec<Held>) {
        let (quantity, word) = match form {
            Form::Number(quantity) => (Some(*quantity), ""),
            Form::NumberOr(quantity, word) => (Some(*quantity), *word),
            _ => (None, ""),
        };
        let value = match self.given() {
            Some(Given::Number(value)) => value.into(),
            Some(Given::Word) => word.into(),
            None => return,
        };
        into.push(Held { path: path.to_owned(), quantity, value });
    }
}

/// Adds a word or a count.
pub fn show_word(value: impl Into<serde_json::Value>, path: &str, into: &mut Vec<Held>) {
    into.push(Held { path: path.to_owned(), quantity: None, value: value.into() });
}

impl<T: Field + Default> Field for Option<T> {
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let mut value = T::default();
        value.read(form, node, reader)?;
        *self = Some(value);
        Ok(())
    }
    fn given(&self) -> Option<Given> {
        self.as_ref()?.given()
    }
    fn put(&mut self, value: Option<f64>) {
        *self = value.map(|_| T::default());
        if let Some(field) = self {
            field.put(value);
        }
    }
    fn show(&self, form: &Form, path: &str, into: &mut Vec<Held>) {
        if let Some(value) = self {
            value.show(form, path, into);
        }
    }
}

impl Field for f64 {
    fn read(&mut self, form: &Form, node: &Node, _: &mut Reader) -> Result<(), Fault> {
        if let Form::Number(quantity) = form {
            *self = number(quantity, None, node)?;
        }
        Ok(())
    }
    fn given(&self) -> Option<Given> {
        Some(Given::Number(*self))
    }
    fn put(&mut self, value: Option<f64>) {
        *self = value.unwrap_or(*self);
    }
}

impl Field for Option<Given> {
    fn read(&mut self, form: &Form, node: &Node, _: &mut Reader) -> Result<(), Fault> {
        if let Form::NumberOr(quantity, word) = form {
            *self = Some(number_or(quantity, word, node)?);
        }
        Ok(())
    }
    fn given(&self) -> Option<Given> {
        *self
    }
    fn put(&mut self, value: Option<f64>) {
        *self = value.map(Given::Number);
    }
}

/// A number, or the word in its place.
pub fn number_or(quantity: &Quantity, word: &str, node: &Node) -> Result<Given, Fault> {
    match &node.value {
        Value::Text(text) if text.trim() == word => Ok(Given::Word),
        _ => number(quantity, Some(word), node).map(Given::Number),
    }
}

impl Field for u64 {
    fn read(&mut self, form: &Form, node: &Node, _: &mut Reader) -> Result<(), Fault> {
        if let Form::Count(quantity) = form {
            *self = count(quantity, node)?;
        }
        Ok(())
    }
    fn show(&self, _: &Form, path: &str, into: &mut Vec<Held>) {
        show_word(*self, path, into);
    }
}

impl Field for [f64; 2] {
    fn read(&mut self, form: &Form, node: &Node, _: &mut Reader) -> Result<(), Fault> {
        if let Form::Pair(first, second) = form {
            *self = pair([first, second], node)?;
        }
        Ok(())
    }
}

impl Field for String {
    fn read(&mut self, form: &Form, node: &Node, _: &mut Reader) -> Result<(), Fault> {
        match form {
            Form::Word(words) => *self = word(words, node)?,
            Form::Text(example) => text(node, example)?.clone_into(self),
            _ => {}
        }
        Ok(())
    }
}

impl<T: Field + Default> Field for Vec<T> {
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        match form {
            Form::List(inner) => {
                for item in list(node, &form.example())? {
                    let mut one = T::default();
                    one.read(inner, item, reader)?;
                    self.push(one);
                }
            }
            Form::Items(of, _) => {
                let Value::List(items) = &node.value else {
                    return Err(Fault::unexpected(node, &format!("a list of tables: {}", of.example)));
                };
                for (i, item) in items.iter().enumerate() {
                    let mut one = T::default();
                    reader.within(&format!("[{i}]"), |reader| match item.value {
                        Value::Table(_) => one.read(form, item, reader),
                        _ => Err(Fault::unexpected(item, of.item)),
                    });
                    self.push(one);
                }
            }
            _ => {}
        }
        Ok(())
    }
}

impl Form {
    /// How such a value may be written.
    pub fn example(&self) -> String {
        match self {
            Self::Number(quantity) | Self::NumberOr(quantity, _) | Self::Count(quantity) => quantity.example.to_owned(),
            Self::Pair(first, second) => format!("[{}, {}]", first.example, second.example),
            Self::Word(words) => format!("\"{}\"", (words.known)().first().map_or("", String::as_str)),
            Self::List(inner) => format!("[{}]", inner.example()),
            _ => String::new(),
        }
    }
}
