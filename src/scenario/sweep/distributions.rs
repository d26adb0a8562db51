//! How `[monte_carlo]` is read: samples, seed, and a distribution for each random key.

use std::fmt;

use serde::de::{Deserialize, DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, Visitor};

use super::axes::ListSeed;
use super::{MonteCarloTable, known, quantity};
use crate::nearest::nearest;
use crate::scenario::quantity::{Quantity, positive};
use crate::scenario::reader::Reader;
use crate::sweep::random::Distribution;

impl<'de> Deserialize<'de> for MonteCarloTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(VariablesVisitor)
    }
}

/// Reads the table key by key; each distribution is one of the quantity of its key.
struct VariablesVisitor;

impl<'de> Visitor<'de> for VariablesVisitor {
    type Value = MonteCarloTable;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table with samples, seed and random keys")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<MonteCarloTable, A::Error> {
        let mut table = MonteCarloTable { samples: 0, seed: 0, variables: Vec::new() };
        while let Some(path) = map.next_key::<String>()? {
            match path.as_str() {
                "samples" => table.samples = map.next_value()?,
                "seed" => table.seed = map.next_value()?,
                path => {
                    let path = known(path, false)?;
                    let quantity = quantity(path).ok_or_else(|| A::Error::custom("no number"))?;
                    table.variables.push((path, map.next_value_seed(DistributionSeed(quantity))?));
                }
            }
        }
        if table.samples == 0 {
            return Err(A::Error::custom("samples, the number of cases, is missing or 0"));
        }
        if table.variables.is_empty() {
            return Err(A::Error::custom(
                "has no random key; give one such as \"half_space.yield_strength\" = { normal = { mean = \"345 MPa\", sd = \"20 MPa\" } }",
            ));
        }
        Ok(table)
    }
}

/// One distribution: `normal`, `lognormal` or `uniform`.
struct DistributionSeed(&'static Quantity);

impl<'de> DeserializeSeed<'de> for DistributionSeed {
    type Value = Distribution;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Distribution, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for DistributionSeed {
    type Value = Distribution;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("{ normal = { mean = ..., sd = ... } }, { lognormal = { mean = ..., sd = ... } } or { uniform = [from, to] }")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Distribution, A::Error> {
        let name = map.next_key::<String>()?.unwrap_or_default();
        let distribution = match name.as_str() {
            "uniform" => match map.next_value_seed(ListSeed(self.0))?[..] {
                [from, to] if from < to => Distribution::Uniform { from, to },
                _ => return Err(A::Error::custom("uniform takes two ends, the lower first")),
            },
            "normal" | "lognormal" => {
                let (mean, sd) = map.next_value_seed(MomentsSeed(self.0))?;
                if name == "lognormal" && mean <= 0.0 {
                    return Err(A::Error::custom("the mean of a lognormal must be > 0; use normal or uniform"));
                }
                if name == "normal" { Distribution::Normal { mean, sd } } else { Distribution::Lognormal { mean, sd } }
            }
            "" => {
                return Err(A::Error::custom("has no distribution; distributions are normal, lognormal, uniform"));
            }
            other => {
                let guess = nearest(other, ["normal", "lognormal", "uniform"])
                    .map_or_else(String::new, |near| format!(", did you mean `{near}`?"));
                return Err(A::Error::custom(format!(
                    "unknown distribution `{other}`{guess}; distributions are normal, lognormal, uniform"
                )));
            }
        };
        if map.next_key::<IgnoredAny>()?.is_some() {
            return Err(A::Error::custom("a key has one distribution"));
        }
        Ok(distribution)
    }
}

/// Mean and standard deviation of a quantity.
struct MomentsSeed(&'static Quantity);

impl<'de> DeserializeSeed<'de> for MomentsSeed {
    type Value = (f64, f64);

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<(f64, f64), D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for MomentsSeed {
    type Value = (f64, f64);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{{ mean = {}, sd = ... }}", self.0.example)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(f64, f64), A::Error> {
        let spread = positive("a standard deviation (sd)", self.0.dimension, self.0.example);
        let (mut mean, mut sd) = (None, None);
        while let Some(name) = map.next_key::<String>()? {
            match name.as_str() {
                "mean" => mean = Some(map.next_value_seed(Reader(self.0))?),
                "sd" => sd = Some(map.next_value_seed(Reader(&spread))?),
                _ => return Err(A::Error::custom(format!("`{name}`: a distribution has mean and sd"))),
            }
        }
        match (mean, sd) {
            (Some(mean), Some(sd)) => Ok((mean, sd)),
            _ => Err(A::Error::custom("mean and sd, the standard deviation, are both needed")),
        }
    }
}
