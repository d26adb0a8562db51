//! `[sweep]` and `[monte_carlo]`: keys with many values, or with a distribution of them.

use std::collections::HashSet;

use crate::impact::Method;
use crate::law::LawChoice;
use crate::materials::Entry as Material;
use crate::plan::axis::{Axis, Values, Word};
use crate::plan::free::Free;
use crate::plan::random::{Distribution, Variable};
use crate::scene::field::{Count, Fault, Reader, Scalar, items, list, number, text, word};
use crate::scene::key::Form;
use crate::scene::quantity::{Points, Quantity, Sampled, Seed};
use crate::scene::taken::{Body, Taken};
use crate::scene::words::{DRAWN, LAWS, METHODS, SCALES};
use crate::scene::written::{Item, Node, Value};
use crate::scene::{KEYS, Key};
use crate::units::nearest::did_you_mean;

/// The keys that are axes of words.
pub(super) const METHOD: &str = "solver.method";
pub(super) const LAW: &str = "law";

/// A body whose material is drawn from its ranges.
#[derive(Debug, Clone)]
pub(super) struct DrawnMaterial {
    pub(super) body: Body,
    /// How many random keys stand before it.
    pub(super) place: usize,
}

/// `[monte_carlo]`
#[derive(Debug, Clone, Default)]
pub(super) struct RandomKeys {
    /// Number of samples.
    pub(super) samples: u64,
    /// Seed of the random numbers; 0 if not given.
    pub(super) seed: u64,
    /// Random keys in the order of the file.
    pub(super) variables: Vec<Variable>,
    /// Materials to draw from.
    pub(super) materials: Vec<DrawnMaterial>,
}

impl Scalar for Vec<Axis> {
    fn form() -> Form {
        Form::Axes
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        let keys = &items(node)?.0;
        if keys.is_empty() {
            let message =
                "has no axis; leave the table out, or give one such as \"impact.speed\" = [\"1 m/s\", \"2 m/s\"]";
            return Err(Fault::at(node, message));
        }
        let mut axes = Vec::new();
        for item in keys {
            reader.within(&item.name, |reader| {
                axes.push(axis(item, reader)?);
                Ok(())
            });
        }
        Ok(axes)
    }
}

fn axis(item: &Item, reader: &mut Reader) -> Result<Axis, Fault> {
    let Item { name: path, node, .. } = item;
    if path == METHOD {
        let names = names(node, "[\"rk8\", \"dop853\"]", |item| word(&METHODS, item))?;
        let method = |name: &String| Method::from_name(name).map(Word::Method);
        return Ok(Axis::of_words(METHOD, names.iter().filter_map(method).collect()));
    }
    if path == LAW {
        let names = names(node, "[\"plm\", \"thornton\"]", law)?;
        let law = |name: &String| LawChoice::from_name(name).map(Word::Law);
        return Ok(Axis::of_words(LAW, names.iter().filter_map(law).collect()));
    }
    if let Some(body) = Body::of_key(path) {
        let example = "[\"steel-s235\", \"aluminium-6061-t6\"]";
        let name = |item: &Node| <&Material>::read(item, reader).map(|material| material.name.clone());
        let names = names(node, example, name)?;
        // what is left to the materials depends on the other keys
        let taken = |material| Word::Material(Taken { body, material, left: Vec::new() });
        let words = names.iter().filter_map(|name| crate::materials::find(name)).map(taken);
        return Ok(Axis::of_words(body.material(), words.collect()));
    }
    let key = known(item, true)?;
    Ok(Axis::of_number(key, axis_values(key.quantity, node, reader)?))
}

impl Scalar for RandomKeys {
    fn form() -> Form {
        Form::Variables
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        let mut keys = Self::default();
        for item in &items(node)?.0 {
            reader.within(&item.name, |reader| keys.take(item, reader));
        }
        let problem = if keys.samples == 0 && items(node)?.get("samples").is_none() {
            "samples, the number of cases, is missing"
        } else if keys.variables.is_empty() && keys.materials.is_empty() && reader.refused.is_empty() {
            "has no random key; give one such as \"half_space.yield_strength\" = { normal = { mean = \"345 MPa\", sd = \"20 MPa\" } }"
        } else {
            return Ok(keys);
        };
        Err(Fault::at(node, problem))
    }
}

impl RandomKeys {
    fn take(&mut self, item: &Item, reader: &mut Reader) -> Result<(), Fault> {
        match item.name.as_str() {
            "samples" => self.samples = Count::<Sampled>::read(&item.node, reader)?.0,
            "seed" => self.seed = Count::<Seed>::read(&item.node, reader)?.0,
            path => {
                if let Some(body) = Body::of_key(path) {
                    word(&DRAWN, &item.node)?;
                    self.materials.push(DrawnMaterial { body, place: self.variables.len() });
                } else {
                    let key = known(item, false)?;
                    self.variables.push(Variable::of(key, distribution(key.quantity, &item.node)?));
                }
            }
        }
        Ok(())
    }
}

impl Scalar for Vec<Free> {
    fn form() -> Form {
        Form::Free
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        let keys = &items(node)?.0;
        if keys.is_empty() || keys.len() > 2 {
            let message = format!("{} keys are given, expected one or two, each with {FREE}", keys.len());
            return Err(Fault::at(node, message));
        }
        let mut all = Vec::new();
        for item in keys {
            reader.within(&item.name, |_| {
                all.push(free(item)?);
                Ok(())
            });
        }
        Ok(all)
    }
}

const FREE: &str = "{ from = ..., to = ... }, and scale = \"log\" or \"linear\" if need be";

/// A key to find, with its range.
fn free(item: &Item) -> Result<Free, Fault> {
    let (key, node) = (known(item, false)?, &item.node);
    let [from, to, scale] = parts(node, ["from", "to", "scale"], FREE)?;
    let end = |end: Option<_>| end.map(|end| number(key.quantity, None, end)).transpose();
    let ends = end(from)?.zip(end(to)?).filter(|(from, to)| from < to);
    let (from, to) = ends.ok_or_else(|| Fault::at(node, format!("needs two ends, the lower first: {FREE}")))?;
    let is_logarithmic = match scale {
        Some(scale) => word(&SCALES, scale)? == "log",
        None => from > 0.0,
    };
    if is_logarithmic && from <= 0.0 {
        return Err(Fault::at(node, "a logarithmic range begins above 0; write scale = \"linear\""));
    }
    Ok(Free { key, from, to, is_logarithmic })
}

/// The values of a table that has these keys alone; `form` says how such a table is written.
fn parts<'n, const N: usize>(node: &'n Node, names: [&str; N], form: &str) -> Result<[Option<&'n Node>; N], Fault> {
    let Value::Table(table) = &node.value else { return Err(Fault::unexpected(node, form)) };
    let unknown = table.0.iter().find(|item| !names.contains(&item.name.as_str()));
    let Some(Item { name, span, .. }) = unknown else { return Ok(names.map(|name| table.get(name))) };
    let hint = did_you_mean(name, names, '`', &format!("keys here are {}", names.join(", ")));
    Err(Fault { span: span.clone(), message: format!("unknown key `{name}`{hint}") })
}

/// The numeric key of that path.
fn known(item: &Item, has_words: bool) -> Result<&'static Key, Fault> {
    let path = item.name.as_str();
    if let Some(key) = Key::find(path) {
        return Ok(key);
    }
    let paths = || KEYS.iter().map(|key| key.path);
    let dotted = format!("{path}.");
    let all = format!("numeric keys are {}", paths().collect::<Vec<_>>().join(", "));
    let hint = match paths().find(|known| known.starts_with(&dotted)) {
        Some(inner) => format!("; write the whole key in quotes, such as \"{inner}\" = ...; {all}"),
        None => did_you_mean(
            path,
            paths().chain(Body::ALL.map(Body::material)).chain(has_words.then_some(METHOD)),
            '"',
            &all,
        ),
    };
    Err(Fault { span: item.span.clone(), message: format!("`{path}` is no numeric key of a scenario{hint}") })
}

/// The names of an axis of words, each read by `read`; none may be there twice.
fn names(
    value: &Node,
    example: &str,
    mut read: impl FnMut(&Node) -> Result<String, Fault>,
) -> Result<Vec<String>, Fault> {
    let names = list(value, example)?.iter().map(&mut read).collect::<Result<Vec<_>, _>>()?;
    if names.is_empty() {
        return Err(Fault::at(value, AT_LEAST_ONE));
    }
    let mut seen = HashSet::new();
    match names.iter().find(|name| !seen.insert(*name)) {
        None => Ok(names),
        Some(name) => {
            let message = format!("\"{name}\" is there twice, which would be the same rows twice; leave one out");
            Err(Fault::at(value, message))
        }
    }
}

const AT_LEAST_ONE: &str = "an axis needs at least one value";

/// The name of a law, or of two halves "loading + unloading".
fn law(item: &Node) -> Result<String, Fault> {
    let name = text(item, "plm")?;
    if let Some(law) = LawChoice::from_name(name).filter(LawChoice::has_loading) {
        return Ok(law.name());
    }
    let whole = (LAWS.known)();
    let all = format!("laws are {}, or \"loading + unloading\" such as \"jackson_green + brake\"", whole.join(", "));
    let hint = did_you_mean(name, whole.iter().map(String::as_str), '"', &all);
    Err(Fault::at(item, format!("no law is known as \"{name}\"{hint}")))
}

fn numbers(quantity: &Quantity, items: &[Node]) -> Result<Vec<f64>, Fault> {
    items.iter().map(|item| number(quantity, None, item)).collect()
}

/// A list of values, or two ends and how many points.
fn axis_values(quantity: &Quantity, value: &Node, reader: &mut Reader) -> Result<Values, Fault> {
    if let Value::List(items) = &value.value {
        return if items.is_empty() {
            Err(Fault::at(value, AT_LEAST_ONE))
        } else {
            numbers(quantity, items).map(Values::List)
        };
    }
    let example = quantity.example;
    let form = format!("a list such as [{example}], or {{ linspace = [from, to], points = 11 }}, or logspace");
    let (ends, is_log, points) = match parts(value, ["linspace", "logspace", "points"], &form)? {
        [Some(ends), None, points] => (ends, false, points),
        [None, Some(ends), points] => (ends, true, points),
        _ => return Err(Fault::at(value, "needs one of linspace = [from, to] and logspace = [from, to]")),
    };
    let values = numbers(quantity, list(ends, &format!("[{example}]"))?)?;
    let [from, to] = values[..] else {
        return Err(Fault::at(ends, format!("{} values are given; write the two ends", values.len())));
    };
    let points = points.ok_or_else(|| Fault::at(value, "points, the number of values, is missing"))?;
    let points = Count::<Points>::read(points, reader)?.0;
    if !is_log {
        return Ok(Values::Linear { from, to, points });
    }
    if from > 0.0 && to > 0.0 {
        return Ok(Values::logarithmic(from, to, points));
    }
    let message = "logspace cannot reach or pass zero: begin above it, or use linspace, or a list of values";
    Err(Fault::at(value, message))
}

/// One distribution: `normal`, `lognormal` or `uniform`.
fn distribution(quantity: &Quantity, value: &Node) -> Result<Distribution, Fault> {
    const FORMS: &str =
        "{ normal = { mean = ..., sd = ... } }, { lognormal = { mean = ..., sd = ... } } or { uniform = [from, to] }";
    match parts(value, ["normal", "lognormal", "uniform"], FORMS)? {
        [None, None, None] => Err(Fault::at(value, format!("has no distribution; write {FORMS}"))),
        [None, None, Some(ends)] => match numbers(quantity, list(ends, &format!("[{}]", quantity.example))?)?[..] {
            [from, to] if from < to => Ok(Distribution::Uniform { from, to }),
            _ => Err(Fault::at(ends, "uniform takes two ends, the lower first")),
        },
        [Some(normal), None, None] => moments(quantity, normal).map(|(mean, sd)| Distribution::Normal { mean, sd }),
        [None, Some(lognormal), None] => match moments(quantity, lognormal)? {
            (mean, _) if mean <= 0.0 => {
                Err(Fault::at(lognormal, "the mean of a lognormal must be > 0; use normal or uniform"))
            }
            (mean, sd) => Ok(Distribution::Lognormal { mean, sd }),
        },
        _ => Err(Fault::at(value, "a key has one distribution")),
    }
}

/// Mean and standard deviation of a quantity.
fn moments(quantity: &Quantity, value: &Node) -> Result<(f64, f64), Fault> {
    let form = format!("{{ mean = {}, sd = ... }}", quantity.example);
    let [Some(mean), Some(sd)] = parts(value, ["mean", "sd"], &form)? else {
        return Err(Fault::at(value, "mean and sd, the standard deviation, are both needed"));
    };
    Ok((number(quantity, None, mean)?, number(&spread(quantity), None, sd)?))
}

/// A standard deviation of this quantity.
fn spread(quantity: &Quantity) -> Quantity {
    Quantity {
        name: "a standard deviation (sd)",
        example: quantity.dimension.example(),
        notation: quantity.notation,
        ..crate::scene::quantity::positive_of(quantity.dimension)
    }
}
