//! `[sweep]` and `[monte_carlo]`: keys of the scenario with many values, checked while they are read.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{Deserialize, DeserializeSeed, Deserializer, Error, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::keys::{KEYS, Key};
use super::quantity::Quantity;
use super::reader::Reader;
use super::{Kind, Scenario, ScenarioError, words};
use crate::impact::Method;
use crate::law::LawChoice;
use crate::nearest::nearest;
use crate::sweep::axis::{Axis, Values};
use crate::sweep::plan::{Cases, Plan};
use crate::sweep::random::{Distribution, Variable};
use crate::units;

/// The keys of a sweep that are no numbers.
pub const METHOD: &str = "solver.method";
/// The law, by name.
pub const LAW: &str = "law";

/// `[sweep]`: axes in the order of the file.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepTable(pub Vec<(&'static str, AxisEntry)>);

/// What an axis runs through.
#[derive(Debug, Clone, PartialEq)]
pub enum AxisEntry {
    /// Numbers in SI.
    Numbers(Values),
    /// Methods.
    Methods(Vec<Method>),
    /// Laws.
    Laws(Vec<LawChoice>),
}

/// `[monte_carlo]`
#[derive(Debug, Clone, PartialEq)]
pub struct MonteCarloTable {
    /// How many samples.
    pub samples: u64,
    /// Which random numbers; 0 if not given.
    pub seed: u64,
    /// Random keys in the order of the file.
    pub variables: Vec<(&'static str, Distribution)>,
}

impl Scenario {
    /// The sweep that the scenario asks for, if it does.
    ///
    /// # Errors
    /// [`ScenarioError`] for an axis that changes nothing, two that change the same, or more than 2⁶³ cases.
    pub fn plan(&self) -> Result<Option<Plan>, ScenarioError> {
        if !matches!(self.kind()?, Kind::Sweep | Kind::MonteCarlo) {
            return Ok(None);
        }
        let mut scene = self.resolve()?;
        if self.file.solver.method.is_none() {
            // a table has no trace, so the closed form is enough
            scene.solver.method = Method::Auto;
        }
        let refuse = |path: &str, message: String| Err(self.document.refuse(path, message));
        let (cases, table) = match (&self.file.sweep, &self.file.monte_carlo) {
            (None, None) => return Ok(None),
            (Some(SweepTable(axes)), _) => {
                // the law that the scenario names has its parameters from there
                let own =
                    |law: &LawChoice| if law.name() == scene.law.name() { scene.law.clone() } else { law.clone() };
                let axes = axes.iter().filter_map(|(path, entry)| match entry {
                    AxisEntry::Numbers(values) => Some(Axis::of_number(Key::find(path)?, values.clone())),
                    AxisEntry::Methods(methods) => Some(Axis::of_methods(methods.clone())),
                    AxisEntry::Laws(laws) => Some(Axis::of_laws(laws.iter().map(own).collect())),
                });
                let axes: Vec<Axis> = axes.collect();
                for axis in &axes {
                    axis.put(0, &mut scene);
                }
                (Cases::Grid(axes), "sweep")
            }
            (None, Some(MonteCarloTable { samples, seed, variables })) => {
                let variables = variables.iter().filter_map(|(path, distribution)| {
                    let key = Key::find(path)?;
                    Some(Variable::new(key, *distribution, key.quantity.range()))
                });
                let variables: Vec<Variable> = variables.collect();
                for variable in &variables {
                    (variable.key.set)(&mut scene, variable.middle());
                }
                (Cases::MonteCarlo { samples: *samples, seed: *seed, variables }, "monte_carlo")
            }
        };
        let mut plan = Plan { scene, cases, columns: None };
        self.choose_columns(&mut plan)?;
        if let Some((path, problem)) = self.contradicted(&plan.paths()).or_else(|| plan.unused()) {
            return refuse(table, format!("\"{path}\" {problem}"));
        }
        if let Cases::MonteCarlo { variables, .. } = &plan.cases
            && let Some(variable) = variables.iter().find(|variable| variable.kept() < LEAST_KEPT)
        {
            let (path, allowed) = (variable.key.path, variable.key.quantity.allowed());
            let message = format!("\"{path}\": almost nothing of its distribution is in the allowed range, {allowed}");
            return refuse(table, message);
        }
        if plan.count().is_none() {
            return refuse(table, "has more than 2^63 cases; take fewer points".to_owned());
        }
        Ok(Some(plan))
    }
}

/// A distribution of which less lies in the allowed range is a slip.
const LEAST_KEPT: f64 = 1e-3;

/// The known key of that path.
fn known<E: Error>(path: &str, has_words: bool) -> Result<&'static str, E> {
    if let Some(word) = [METHOD, LAW].into_iter().find(|word| has_words && path == *word) {
        return Ok(word);
    }
    if let Some(key) = Key::find(path) {
        return Ok(key.path);
    }
    let paths = || KEYS.iter().map(|key| key.path);
    let dotted = format!("{path}.");
    let hint = if let Some(inner) = paths().find(|known| known.starts_with(&dotted)) {
        format!("; write the whole key in quotes, such as \"{inner}\" = ...")
    } else if let Some(near) = nearest(path, paths().chain([METHOD])) {
        format!(", did you mean \"{near}\"?")
    } else {
        String::new()
    };
    let all: Vec<_> = paths().collect();
    Err(E::custom(format!("`{path}` is no numeric key of a scenario{hint}; numeric keys are {}", all.join(", "))))
}

fn quantity(path: &str) -> Option<&'static Quantity> {
    Key::find(path).map(|key| key.quantity)
}

/// Reads a table key by key; each value is read as its key says.
struct Table<T>(PhantomData<T>);

impl<'de> Deserialize<'de> for SweepTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(Table::<Self>(PhantomData))
    }
}

impl<'de> Visitor<'de> for Table<SweepTable> {
    type Value = SweepTable;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table of axes such as \"impact.speed\" = { logspace = [\"1 mm/s\", \"100 m/s\"], points = 101 }")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<SweepTable, A::Error> {
        let mut axes = Vec::new();
        while let Some(path) = map.next_key::<String>()? {
            let path = known(&path, true)?;
            let entry = match quantity(path) {
                Some(quantity) => AxisEntry::Numbers(map.next_value_seed(AxisSeed(quantity))?),
                None if path == LAW => AxisEntry::Laws(words::laws(&map.next_value::<Vec<String>>()?)?),
                None => AxisEntry::Methods(words::methods(&map.next_value::<Vec<String>>()?)?),
            };
            axes.push((path, entry));
        }
        if axes.is_empty() {
            Err(A::Error::custom("has no axis; leave the table out, or give one"))
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
struct ListSeed(&'static Quantity);

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

impl<'de> Deserialize<'de> for MonteCarloTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(Table::<Self>(PhantomData))
    }
}

impl<'de> Visitor<'de> for Table<MonteCarloTable> {
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
        /// A number in SI, or a text with a unit.
        #[derive(serde::Deserialize)]
        #[serde(untagged)]
        enum Spread {
            Number(f64),
            Text(String),
        }
        let (mut mean, mut sd) = (None, None);
        while let Some(name) = map.next_key::<String>()? {
            match name.as_str() {
                "mean" => mean = Some(map.next_value_seed(Reader(self.0))?),
                "sd" => {
                    sd = Some(match map.next_value::<Spread>()? {
                        Spread::Number(value) => value,
                        Spread::Text(text) => units::parse(&text, self.0.dimension).map_err(A::Error::custom)?,
                    });
                }
                _ => return Err(A::Error::custom(format!("`{name}`: a distribution has mean and sd"))),
            }
        }
        match (mean, sd) {
            (Some(mean), Some(sd)) if sd > 0.0 && sd.is_finite() => Ok((mean, sd)),
            (Some(_), Some(sd)) => Err(A::Error::custom(format!("sd = {sd} must be > 0 and finite"))),
            _ => Err(A::Error::custom("mean and sd, the standard deviation, are both needed")),
        }
    }
}
