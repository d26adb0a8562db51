//! The fields of tables: how each type takes the value of a key, and gives it back.

use toml::de::DeValue;

use super::key::{AnyKey, Form};
use super::quantity::Quantity;
use super::read::{Fault, Reader, count, list, number, pair, text, word};
use super::written::Node;
use crate::units::describe;

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

impl Held {
    /// Its name in summaries, with the unit: `impact_speed_m_per_s`.
    pub fn column(&self) -> String {
        self.path.replace('.', "_") + self.quantity.map_or("", |quantity| quantity.dimension.suffix())
    }

    /// The value for the terminal.
    pub fn text(&self) -> String {
        match (self.quantity, self.value.as_f64(), self.value.as_str()) {
            (Some(quantity), Some(number), _) => describe(number, quantity.dimension),
            (.., Some(word)) => word.to_owned(),
            _ => self.value.to_string(),
        }
    }
}

/// A field of a table: where the value of a key is kept.
pub trait Field {
    /// Takes the value that stands there, written in this form.
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault>;
    /// The number that it has, for a key that may vary; infinite for the word in its place.
    fn given(&self) -> Option<f64> {
        None
    }
    /// Puts a checked number there, SI, or nothing.
    fn put(&mut self, _: Option<f64>) {}
    /// The field of this number, of a table.
    fn at(&self, _: usize) -> Option<&dyn Field> {
        None
    }
    /// The same, to be changed; a table that is not there is made.
    fn at_mut(&mut self, _: usize) -> Option<&mut dyn Field> {
        None
    }
    /// Adds the keys of a table; the path and the way are those of the table.
    fn keys(&self, _: &str, _: &[usize], _: &mut Vec<AnyKey>) {}
    /// Adds what it has, for reports.
    fn show(&self, form: &Form, path: &str, into: &mut Vec<Held>) {
        if let (Some((quantity, word)), Some(value)) = (form.number(), self.given()) {
            let value = word.filter(|_| value.is_infinite()).map_or_else(|| value.into(), Into::into);
            into.push(Held { path: path.to_owned(), quantity: Some(quantity), value });
        }
    }
}

/// Adds a word or a count.
pub fn show_word(value: impl Into<serde_json::Value>, path: &str, into: &mut Vec<Held>) {
    into.push(Held { path: path.to_owned(), quantity: None, value: value.into() });
}

impl<T: Field + Default + 'static> Field for Option<T> {
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let mut value = T::default();
        value.read(form, node, reader)?;
        *self = Some(value);
        Ok(())
    }
    fn given(&self) -> Option<f64> {
        self.as_ref()?.given()
    }
    fn put(&mut self, value: Option<f64>) {
        *self = value.map(|_| T::default());
        if let Some(field) = self {
            field.put(value);
        }
    }
    fn at(&self, at: usize) -> Option<&dyn Field> {
        self.as_ref()?.at(at)
    }
    fn at_mut(&mut self, at: usize) -> Option<&mut dyn Field> {
        self.get_or_insert_default().at_mut(at)
    }
    fn keys(&self, path: &str, way: &[usize], into: &mut Vec<AnyKey>) {
        T::default().keys(path, way, into);
    }
    fn show(&self, form: &Form, path: &str, into: &mut Vec<Held>) {
        if let Some(value) = self {
            value.show(form, path, into);
        }
    }
}

impl Field for f64 {
    fn read(&mut self, form: &Form, node: &Node, _: &mut Reader) -> Result<(), Fault> {
        if let Some((quantity, word)) = form.number() {
            *self = number(quantity, word, node)?;
        }
        Ok(())
    }
    fn given(&self) -> Option<f64> {
        Some(*self)
    }
    fn put(&mut self, value: Option<f64>) {
        *self = value.unwrap_or(*self);
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
    fn keys(&self, path: &str, way: &[usize], into: &mut Vec<AnyKey>) {
        T::default().keys(&format!("{path}[]"), way, into);
    }
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        match form {
            Form::List(inner) => {
                for item in list(node, &form.example())? {
                    let mut one = T::default();
                    one.read(inner, item, reader)?;
                    self.push(one);
                }
            }
            Form::Items(example, one_item) => {
                let DeValue::Array(items) = node.get_ref() else {
                    return Err(Fault::unexpected(node, &format!("a list of tables: {example}")));
                };
                for (i, item) in items.iter().enumerate() {
                    let mut one = T::default();
                    reader.within(&format!("[{i}]"), |reader| match item.get_ref() {
                        DeValue::Table(_) => one.read(form, item, reader),
                        _ => Err(Fault::unexpected(item, one_item)),
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
    /// The quantity of a number, and the word that may stand in its place.
    pub fn number(&self) -> Option<(&'static Quantity, Option<&'static str>)> {
        match self {
            Self::Number(quantity) => Some((quantity, None)),
            Self::NumberOr(quantity, word) => Some((quantity, Some(word))),
            _ => None,
        }
    }

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
