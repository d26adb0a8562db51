//! The value of a result, and how values are written as JSON and CSV.

use std::borrow::Cow;

use serde::ser::{Serialize, SerializeMap as _, Serializer};

/// The value of a result.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// No number: there is none, or JSON has none for it.
    Null,
    /// A finite number.
    Number(f64),
    /// A count.
    Count(u64),
    /// A word or a sentence.
    Text(Cow<'static, str>),
    /// The two ends of an interval.
    Span([f64; 2]),
    /// Numbers.
    Numbers(Vec<f64>),
    /// Sentences.
    Texts(Vec<String>),
    /// Results in a group of their own.
    Group(Fields),
    /// A list of such groups.
    Groups(Vec<Fields>),
}

/// Values by name. A name with a dot stands in a group: `energy.drift` is `drift` in `energy`.
#[derive(Debug, Clone, PartialEq)]
pub struct Fields(pub Vec<(&'static str, Value)>);

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        if value.is_finite() { Self::Number(value) } else { Self::Null }
    }
}

impl From<Option<f64>> for Value {
    fn from(value: Option<f64>) -> Self {
        value.map_or(Self::Null, Self::from)
    }
}

impl From<u64> for Value {
    fn from(count: u64) -> Self {
        Self::Count(count)
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Self::Count(count as u64)
    }
}

impl From<&'static str> for Value {
    fn from(word: &'static str) -> Self {
        Self::Text(word.into())
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text.into())
    }
}

impl From<[f64; 2]> for Value {
    fn from(ends: [f64; 2]) -> Self {
        Self::Span(ends)
    }
}

impl From<Vec<f64>> for Value {
    fn from(numbers: Vec<f64>) -> Self {
        Self::Numbers(numbers)
    }
}

impl From<Vec<String>> for Value {
    fn from(texts: Vec<String>) -> Self {
        Self::Texts(texts)
    }
}

impl From<Fields> for Value {
    fn from(group: Fields) -> Self {
        Self::Group(group)
    }
}

impl From<Vec<Fields>> for Value {
    fn from(groups: Vec<Fields>) -> Self {
        Self::Groups(groups)
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Null => serializer.serialize_none(),
            Self::Number(value) => serializer.serialize_f64(*value),
            Self::Count(count) => serializer.serialize_u64(*count),
            Self::Text(text) => serializer.serialize_str(text),
            Self::Span(ends) => ends.serialize(serializer),
            Self::Numbers(numbers) => numbers.serialize(serializer),
            Self::Texts(texts) => texts.serialize(serializer),
            Self::Group(fields) => fields.serialize(serializer),
            Self::Groups(groups) => groups.serialize(serializer),
        }
    }
}

impl Serialize for Fields {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        let mut rest = self.0.as_slice();
        while let Some((name, value)) = rest.first() {
            let group = |name: &'static str| name.split_once('.').map(|(group, _)| group);
            let Some(own) = group(name) else {
                map.serialize_entry(name, value)?;
                rest = &rest[1..];
                continue;
            };
            let length = rest.iter().take_while(|(name, _)| group(name) == Some(own)).count();
            let (inner, behind) = rest.split_at(length);
            let inner = inner.iter().map(|(name, value)| (&name[own.len() + 1..], value.clone()));
            map.serialize_entry(own, &Self(inner.collect()))?;
            rest = behind;
        }
        map.end()
    }
}
