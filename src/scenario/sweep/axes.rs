//! How `[sweep]` is read: axes of numbers or words, checked value by value.

use std::fmt;

use serde::de::{Deserialize, DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::{AxisEntry, LAW, PathSeed, SweepTable, quantity};
use crate::scenario::quantity::Quantity;
use crate::scenario::reader::Reader;
use crate::scenario::words;
use crate::sweep::axis::Values;

impl<'de> Deserialize<'de> for SweepTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(AxesVisitor)
    }
}

/// Reads the table key by key; each value is read as its key says.
struct AxesVisitor;

impl<'de> Visitor<'de> for AxesVisitor {
    type Value = SweepTable;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table of axes such as \"impact.speed\" = { logspace = [\"1 mm/s\", \"100 m/s\"], points = 101 }")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<SweepTable, A::Error> {
        let mut axes = Vec::new();
        while let Some(path) = map.next_key_seed(PathSeed { has_words: true })? {
            let entry = match quantity(path) {
                Some(quantity) => AxisEntry::Numbers(map.next_value_seed(AxisSeed(quantity))?),
                None if path == LAW => AxisEntry::Laws(map.next_value::<words::Laws>()?.0),
                None => AxisEntry::Methods(map.next_value::<words::Methods>()?.0),
            };
            axes.push((path, entry));
        }
        if axes.is_empty() {
            Err(A::Error::custom(
                "has no axis; leave the table out, or give one such as \"impact.speed\" = [\"1 m/s\", \"2 m/s\"]",
            ))
        } else {
            Ok(SweepTable(axes))
        }
    }
}

/// An axis of numbers: a list, or two ends and how many points.
struct AxisSeed(&'static Quantity);

impl<'de> DeserializeSeed<'de> for AxisSeed {
    type Value = Values;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Values, D::Error> {
        deserializer.deserialize_any(self)
    }
}

impl<'de> Visitor<'de> for AxisSeed {
    type Value = Values;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let example = self.0.example;
        write!(f, "a list such as [{example}], or {{ linspace = [from, to], points = 11 }}, or logspace")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, seq: A) -> Result<Values, A::Error> {
        let values = ListSeed(self.0).visit_seq(seq)?;
        if values.is_empty() {
            Err(A::Error::custom("an axis needs at least one value"))
        } else {
            Ok(Values::List(values))
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Values, A::Error> {
        let (mut ends, mut points) = (None, None);
        while let Some(name) = map.next_key::<String>()? {
            match name.as_str() {
                "linspace" | "logspace" if ends.is_none() => {
                    let values = map.next_value_seed(ListSeed(self.0))?;
                    let [from, to] = values[..] else {
                        return Err(A::Error::custom(format!("{name} takes two ends, not {} values", values.len())));
                    };
                    ends = Some((name == "logspace", from, to));
                }
                "points" => points = Some(map.next_value::<u64>()?),
                _ => {
                    return Err(A::Error::custom(format!(
                        "`{name}`: an axis is {{ linspace = [from, to], points = n }} or {{ logspace = ... }}"
                    )));
                }
            }
        }
        let (is_log, from, to) =
            ends.ok_or_else(|| A::Error::custom("linspace = [from, to] or logspace is missing"))?;
        let points = points.ok_or_else(|| A::Error::custom("points, the number of values, is missing"))?;
        if points == 0 {
            return Err(A::Error::custom("points = 0: an axis needs at least one value"));
        }
        if is_log && !(from > 0.0 && to > 0.0) {
            return Err(A::Error::custom(
                "logspace cannot reach or pass zero: begin above it, or use linspace, or a list of values",
            ));
        }
        Ok(if is_log { Values::Logarithmic { from, to, points } } else { Values::Linear { from, to, points } })
    }
}

/// Values of one quantity.
pub(super) struct ListSeed(pub(super) &'static Quantity);

impl<'de> DeserializeSeed<'de> for ListSeed {
    type Value = Vec<f64>;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Vec<f64>, D::Error> {
        deserializer.deserialize_seq(self)
    }
}

impl<'de> Visitor<'de> for ListSeed {
    type Value = Vec<f64>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a list such as [{}]", self.0.example)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Vec<f64>, A::Error> {
        let mut values = Vec::new();
        while let Some(value) = seq.next_element_seed(Reader(self.0))? {
            values.push(value);
        }
        Ok(values)
    }
}
