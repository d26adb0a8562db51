//! `[sweep]` and `[monte_carlo]`: keys with many values, or with a distribution of them.

use std::collections::HashSet;
use std::hash::Hash;

use toml::de::{DeTable, DeValue};

use crate::contact::law::LawChoice;
use crate::contact::strength::hardness;
use crate::impact::Method;
use crate::materials;
use crate::scenario::input::reader::{Fault, Reader, count, items, list, named, number, pair, word};
use crate::scenario::input::{Body, BodyMaterial, KEYS, Key};
use crate::scenario::keys::Quantity;
use crate::scenario::keys::quantity::{POINTS, SAMPLED, SEED, positive_of};
use crate::scenario::keys::words::{AXIS_OF_LAWS, DRAWN, MATERIALS, METHODS, SCALES};
use crate::scenario::plan::{Axis, Distribution, Free, Values, Variable, Word};
use crate::scenario::toml_node::{Name, Node, described};
use crate::strings::{did_you_mean, known_names};

/// The keys whose axes hold words.
pub(in crate::scenario) const METHOD: &str = "solver.method";
pub(in crate::scenario) const LAW: &str = "law";

/// The table `[monte_carlo]`.
#[derive(Debug, Clone, Default, PartialEq)]
pub(in crate::scenario) struct RandomKeys {
    pub(in crate::scenario) samples: u64,
    /// Seed of the random numbers; 0 if not given.
    pub(in crate::scenario) seed: u64,
    /// Random keys in the order of the file.
    pub(in crate::scenario) variables: Vec<Variable>,
    /// Bodies whose materials are drawn from their ranges, each with the number of random keys before it.
    pub(in crate::scenario) materials: Vec<(Body, usize)>,
}

/// The axes of `[sweep]`.
pub(in crate::scenario) fn axes(node: &Node, reader: &mut Reader) -> Result<Vec<Axis>, Fault> {
    let keys = items(node)?;
    if keys.is_empty() {
        let message = "has no axis; leave the table out, or give one such as \"impact.speed\" = [\"1 m/s\", \"2 m/s\"]";
        return Err(Fault::at(node, message));
    }
    Ok(each(keys, reader, axis))
}

/// Reads every key of a table and collects the refusals.
fn each<T>(keys: &DeTable, reader: &mut Reader, read: fn(&Name, &Node) -> Result<T, Fault>) -> Vec<T> {
    let mut all = Vec::new();
    for (name, node) in keys {
        reader.in_table(name.get_ref(), |_| read(name, node).map(|one| all.push(one)));
    }
    all
}

fn axis(name: &Name, node: &Node) -> Result<Axis, Fault> {
    let path = name.get_ref();
    if path == METHOD {
        let method = |item: &Node| named(&METHODS, item, Method::find).map(Word::Method);
        return words(METHOD, node, "[\"rk8\", \"dop853\"]", method);
    }
    if path == LAW {
        let find = |name: &str| LawChoice::from_name(name).filter(LawChoice::has_loading);
        if matches!(node.get_ref(), DeValue::String(all) if all == "all") {
            let laws = LawChoice::all().into_iter().filter(LawChoice::has_loading);
            return Ok(Axis::of_words(LAW, laws.map(Word::Law).collect()));
        }
        let law = |item: &Node| named(&AXIS_OF_LAWS, item, find).map(Word::Law);
        return words(LAW, node, "[\"plm\", \"thornton\"]", law);
    }
    if let Some(body) = Body::of_key(path) {
        // the values that a material leaves to its defaults depend on the other keys, and are set later
        let choice = |material| Word::Material(BodyMaterial { body, material, defaults: Vec::new() });
        let material = |item: &Node| named(&MATERIALS, item, materials::find).map(choice);
        return words(body.material(), node, "[\"steel-s235\", \"aluminium-6061-t6\"]", material);
    }
    let key = known(name, true)?;
    refuse_word(key, node)?;
    Ok(Axis::of_number(key, axis_values(key.quantity, node)?))
}

fn words(
    path: &'static str,
    node: &Node,
    example: &str,
    word: impl Fn(&Node) -> Result<Word, Fault>,
) -> Result<Axis, Fault> {
    Ok(Axis::of_words(path, different(node, list(node, example)?, word, Word::name)?))
}

/// The values of an axis: at least one, and no value twice. Two values with the same `identity` are equal.
fn different<T, K: Eq + Hash>(
    node: &Node,
    items: &[Node],
    read: impl FnMut(&Node) -> Result<T, Fault>,
    identity: impl Fn(&T) -> K,
) -> Result<Vec<T>, Fault> {
    if items.is_empty() {
        return Err(Fault::at(node, "an axis needs at least one value"));
    }
    let values = items.iter().map(read).collect::<Result<Vec<T>, _>>()?;
    let mut seen = HashSet::new();
    let twice = values.iter().zip(items).find(|(value, _)| !seen.insert(identity(value)));
    match twice.map(|(_, item)| (item, described(item))) {
        None => Ok(values),
        Some((item, text)) => {
            Err(Fault::at(item, format!("{text} is there twice, which would be the same rows twice; leave one out")))
        }
    }
}

impl RandomKeys {
    /// Reads `[monte_carlo]`.
    pub(in crate::scenario) fn read(&mut self, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let refused = reader.refused.len();
        for (name, value) in items(node)? {
            reader.in_table(name.get_ref(), |_| self.take(name, value));
        }
        let problem = if !items(node)?.contains_key("samples") {
            "samples, the number of cases, is missing"
        } else if self.variables.is_empty() && self.materials.is_empty() && reader.refused.len() == refused {
            "has no random key; give one such as \"half_space.yield_strength\" = { normal = { mean = \"345 MPa\", sd = \"20 MPa\" } }"
        } else {
            return Ok(());
        };
        Err(Fault::at(node, problem))
    }

    fn take(&mut self, name: &Name, node: &Node) -> Result<(), Fault> {
        match &**name.get_ref() {
            "samples" => self.samples = count(&SAMPLED, node)?,
            "seed" => self.seed = count(&SEED, node)?,
            path => {
                if let Some(body) = Body::of_key(path) {
                    word(&DRAWN, node)?;
                    self.materials.push((body, self.variables.len()));
                } else {
                    let key = known(name, false)?;
                    self.variables.push(Variable::new(key, distribution(key.quantity, node)?));
                }
            }
        }
        Ok(())
    }
}

/// The keys of `calibrate.free`; empty if measurements are only compared.
pub(in crate::scenario) fn free_keys(node: &Node, reader: &mut Reader) -> Result<Vec<Free>, Fault> {
    let DeValue::Table(keys) = node.get_ref() else { return Err(Fault::unexpected(node, A_FREE_KEY)) };
    if keys.len() > 2 {
        let message =
            format!("{} keys are given, expected one or two, each with {FREE}; or none, to compare", keys.len());
        return Err(Fault::at(node, message));
    }
    Ok(each(keys, reader, free))
}

/// The index of a logarithmic scale in [`SCALES`].
const LOG: usize = 0;
const A_FREE_KEY: &str = "a table such as { \"half_space.yield_strength\" = { from = \"100 MPa\", to = \"1 GPa\" } }";
const FREE: &str = "{ from = ..., to = ... }, and scale = \"log\" or \"linear\" if need be";

/// A free key with its range.
fn free(name: &Name, node: &Node) -> Result<Free, Fault> {
    let key = known(name, false)?;
    let [from, to, scale] = parts(node, ["from", "to", "scale"], FREE)?;
    let end = |end: Option<_>| end.map(|end| number(key.quantity, None, end)).transpose();
    let ends = end(from)?.zip(end(to)?).filter(|(from, to)| from < to);
    let (from, to) = ends.ok_or_else(|| Fault::at(node, format!("needs two ends, the lower first: {FREE}")))?;
    let is_logarithmic = match scale {
        Some(scale) => word(&SCALES, scale)? == LOG,
        None => from > 0.0,
    };
    if is_logarithmic && from <= 0.0 {
        return Err(Fault::at(node, "a logarithmic range begins above 0; write scale = \"linear\""));
    }
    Ok(Free { key, from, to, is_logarithmic, hardness: None })
}

/// Refuses the word in place of a number, because it cannot lie between numbers.
fn refuse_word(key: &Key, node: &Node) -> Result<(), Fault> {
    let (Some(word), DeValue::Array(items)) = (key.word, node.get_ref()) else { return Ok(()) };
    let Some(item) = items.iter().find(|item| item.get_ref().as_str().is_some_and(|text| text.trim() == word)) else {
        return Ok(());
    };
    let path = key.path;
    let message = format!(
        "\"{word}\" is no number, and an axis has numbers alone: make a table of its own with --set {path}={word}"
    );
    Err(Fault::at(item, message))
}

/// The values of a table that has only these keys; `form` describes such a table in messages.
fn parts<'n, 't, const N: usize>(
    node: &'n Node<'t>,
    names: [&str; N],
    form: &str,
) -> Result<[Option<&'n Node<'t>>; N], Fault> {
    let DeValue::Table(table) = node.get_ref() else { return Err(Fault::unexpected(node, form)) };
    let unknown = table.keys().find(|name| !names.contains(&&**name.get_ref()));
    let Some((name, span)) = unknown.map(|name| (name.get_ref(), name.span())) else {
        return Ok(names.map(|name| table.get(name)));
    };
    let hint = did_you_mean(name, names, '`', &format!("keys here are {}", names.join(", ")));
    Err(Fault { span, message: format!("unknown key `{name}`{hint}") })
}

/// The numeric key of that path.
fn known(name: &Name, has_words: bool) -> Result<&'static Key, Fault> {
    let path = &**name.get_ref();
    if let Some(key) = Key::find(path) {
        return Ok(key);
    }
    let paths = || KEYS.iter().map(|key| key.path);
    let dotted = format!("{path}.");
    let all = known_names(path, &paths().collect::<Vec<_>>(), "numeric keys");
    let hint = match paths().find(|known| known.starts_with(&dotted)) {
        Some(inner) => format!("; write the whole key in quotes, such as \"{inner}\" = ...; {all}"),
        None => did_you_mean(
            path,
            paths().chain(Body::ALL.map(Body::material)).chain(has_words.then_some(METHOD)),
            '"',
            &all,
        ),
    };
    Err(Fault { span: name.span(), message: format!("`{path}` is no numeric key of a scenario{hint}") })
}

/// A list of values, or two ends and a number of points.
fn axis_values(quantity: &Quantity, value: &Node) -> Result<Values, Fault> {
    if let DeValue::Array(items) = value.get_ref() {
        let read = |item: &Node| number(quantity, None, item);
        return different(value, items, read, |number: &f64| number.to_bits()).map(Values::List);
    }
    let example = quantity.example;
    let form = format!("a list such as [{example}], or {{ linspace = [from, to], points = 11 }}, or logspace");
    let (ends, is_log, points) = match parts(value, ["linspace", "logspace", "points"], &form)? {
        [Some(ends), None, points] => (ends, false, points),
        [None, Some(ends), points] => (ends, true, points),
        _ => return Err(Fault::at(value, "needs one of linspace = [from, to] and logspace = [from, to]")),
    };
    // NumPy has the number of values in the list
    if let DeValue::Array(items) = ends.get_ref()
        && let [_, _, n_points] = &items[..]
    {
        let message = format!(
            "has 3 numbers; write the two ends alone, and the number of values beside them: points = {}",
            described(n_points)
        );
        return Err(Fault::at(ends, message));
    }
    let [from, to] = pair([quantity; 2], ends)?;
    let points = points.ok_or_else(|| Fault::at(value, "points, the number of values, is missing"))?;
    let points = count(&POINTS, points)?;
    if from.to_bits() == to.to_bits() && points > 1 {
        let message =
            format!("both ends are equal, which would be the same rows {points} times; give two ends, or points = 1");
        return Err(Fault::at(ends, message));
    }
    if !is_log {
        return Ok(Values::Spaced { from, to, points, decades: None });
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
        [None, None, Some(ends)] => match pair([quantity; 2], ends)? {
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
    Ok((number(quantity, None, mean)?, deviation(quantity, sd)?))
}

/// A standard deviation. On a curved scale of hardness a difference of numbers is no difference of pressures.
fn deviation(quantity: &Quantity, node: &Node) -> Result<f64, Fault> {
    let scale = node.get_ref().as_str().and_then(hardness::parse).map(|(_, scale)| scale);
    if let Some(scale) = scale.filter(|scale| quantity.is_hardness && *scale != hardness::HardnessScale::Vickers) {
        let name = scale.name();
        let message = format!(
            "a standard deviation in {name} says nothing, as that scale is curved: write it in HV, such as \"20 HV\", or as a pressure"
        );
        return Err(Fault::at(node, message));
    }
    number(&spread(quantity), None, node)
}

fn spread(quantity: &Quantity) -> Quantity {
    Quantity {
        name: "a standard deviation (sd)",
        example: quantity.dimension.example(),
        is_hardness: quantity.is_hardness,
        ..positive_of(quantity.dimension)
    }
}
