//! A scenario as it is written: tables, lists and values, each with its place.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue, Error};

/// A value and its place, in bytes.
#[derive(Debug, Clone)]
pub struct Node {
    /// Where it stands.
    pub span: Range<usize>,
    /// What stands there.
    pub value: Value,
}

/// What may stand behind a key.
#[derive(Debug, Clone)]
pub enum Value {
    /// A text in quotes.
    Text(String),
    /// A number.
    Number {
        /// As it is written, but for underscores.
        digits: String,
        /// Its value; `None` where it has too many digits of another base than ten.
        value: Option<f64>,
        /// The same, if it is written as a whole number of at most 64 bits.
        whole: Option<u64>,
    },
    /// `true`, `false` or a date, which no key takes.
    Other(String),
    /// A list in brackets.
    List(Vec<Node>),
    /// A table.
    Table(Table),
}

/// A table, in the order of the file.
#[derive(Debug, Clone, Default)]
pub struct Table(pub Vec<Item>);

/// A key of a table, and its value.
#[derive(Debug, Clone)]
pub struct Item {
    /// The key.
    pub name: String,
    /// Where the key stands.
    pub span: Range<usize>,
    /// Its value.
    pub node: Node,
}

impl Table {
    /// Reads TOML. The places in it are counted from `start`, so that several texts can lie behind each other in one
    /// space, in which a place tells its text.
    pub fn parse(text: &str, start: usize) -> Result<Self, Error> {
        DeTable::parse(text).map(|table| Self::of(table.into_inner(), start))
    }

    fn of(table: DeTable, start: usize) -> Self {
        let item = |(key, value): (Spanned<_>, Spanned<DeValue>)| {
            let span = further(&key, start);
            let name: std::borrow::Cow<str> = key.into_inner();
            Item { name: name.into_owned(), span, node: Node::of(value, start) }
        };
        Self(table.into_iter().map(item).collect())
    }

    /// The value of a key.
    pub fn get(&self, name: &str) -> Option<&Node> {
        self.0.iter().find(|item| item.name == name).map(|item| &item.node)
    }

    /// The same, to be changed.
    pub fn get_mut(&mut self, name: &str) -> Option<&mut Node> {
        self.0.iter_mut().find(|item| item.name == name).map(|item| &mut item.node)
    }

    /// Puts the keys of another table in place of those of the same name; tables are merged.
    pub fn merge(&mut self, from: Self) {
        for item in from.0 {
            match (self.get_mut(&item.name), item.node.value) {
                (Some(Node { value: Value::Table(old), .. }), Value::Table(new)) => old.merge(new),
                (Some(old), value) => *old = Node { span: item.node.span, value },
                (None, value) => self.0.push(Item { node: Node { span: item.node.span, value }, ..item }),
            }
        }
    }

    /// Where the value of a dotted key is; the last part may be a key in quotes with dots of its own, and `[2]` stands for
    /// an item of a list.
    pub fn span_of(&self, path: &str) -> Option<Range<usize>> {
        if let Some(node) = self.get(path) {
            return Some(node.span.clone());
        }
        let (name, rest) = path.split_once('.').map_or((path, None), |(name, rest)| (name, Some(rest)));
        let (name, item) = name.split_once('[').map_or((name, None), |(name, item)| (name, Some(item)));
        let mut node = self.get(name)?;
        if let Some(item) = item {
            let Value::List(items) = &node.value else { return None };
            node = items.get(item.trim_end_matches(']').parse::<usize>().ok()?)?;
        }
        match (rest, &node.value) {
            (None, _) => Some(node.span.clone()),
            (Some(rest), Value::Table(inner)) => inner.span_of(rest),
            _ => None,
        }
    }
}

impl Node {
    fn of(value: Spanned<DeValue>, start: usize) -> Self {
        let span = further(&value, start);
        let number = |digits: String, value, whole| Value::Number { digits, value, whole };
        let value = match value.into_inner() {
            DeValue::String(text) => Value::Text(text.into_owned()),
            DeValue::Integer(digits) => {
                let whole = u64::from_str_radix(digits.as_str(), digits.radix()).ok();
                number(digits.to_string(), whole_number(digits.as_str(), digits.radix()), whole)
            }
            DeValue::Float(digits) => number(digits.to_string(), digits.as_str().parse().ok(), None),
            DeValue::Boolean(word) => Value::Other(format!("`{word}`")),
            DeValue::Datetime(date) => Value::Other(format!("the date `{date}`")),
            DeValue::Array(items) => Value::List(items.into_iter().map(|item| Self::of(item, start)).collect()),
            DeValue::Table(table) => Value::Table(Table::of(table, start)),
        };
        Self { span, value }
    }

    /// What was found here, for messages.
    pub fn described(&self) -> String {
        match &self.value {
            Value::Text(text) => format!("\"{text}\""),
            Value::Number { digits, .. } => format!("`{digits}`"),
            Value::Other(text) => text.clone(),
            Value::List(_) => "a list".to_owned(),
            Value::Table(_) => "a table".to_owned(),
        }
    }
}

fn further<T>(place: &Spanned<T>, start: usize) -> Range<usize> {
    place.span().start + start..place.span().end + start
}

/// An integer as a floating number. Digits of another base are not read as decimal ones, however many they are.
#[allow(clippy::cast_precision_loss)] // as if it had been written with a decimal point
fn whole_number(digits: &str, radix: u32) -> Option<f64> {
    if radix == 10 { digits.parse().ok() } else { u128::from_str_radix(digits, radix).ok().map(|number| number as f64) }
}
