//! `[sweep]` and `[monte_carlo]`: keys with many values, or with a distribution of them.

use std::collections::HashSet;
use std::hash::Hash;

use toml::de::{DeTable, DeValue};

use crate::contact::law::LawChoice;
use crate::contact::strength::hardness;
use crate::impact::Method;
use crate::materials;
use crate::scenario::input::reader::{
    Reader, ValueError, as_table, find_word, read_count, read_list, read_number, read_pair, read_word,
};
use crate::scenario::input::{Body, BodyMaterial, NUMERIC_KEYS, NumericKey};
use crate::scenario::keys::Quantity;
use crate::scenario::keys::quantity::{N_SAMPLES, POINTS, SEED, positive_quantity};
use crate::scenario::keys::words::{LAW_AXIS, MATERIAL_DISTRIBUTIONS, MATERIALS, METHODS, SCALES};
use crate::scenario::plan::{AxisValues, AxisWord, Distribution, FreeKey, SweepAxis, Variable};
use crate::scenario::toml_node::{TomlKey, TomlValue, describe_value};
use crate::strings::{did_you_mean, known_names};

/// The keys whose axes hold words.
pub(in crate::scenario) const METHOD_KEY: &str = "solver.method";
pub(in crate::scenario) const LAW_KEY: &str = "law";

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
pub(in crate::scenario) fn read_axes(node: &TomlValue, reader: &mut Reader) -> Result<Vec<SweepAxis>, ValueError> {
    let keys = as_table(node)?;
    if keys.is_empty() {
        let message = "has no axis. Remove the table, or add an axis such as \"impact.speed\" = [\"1 m/s\", \"2 m/s\"]";
        return Err(ValueError::new(node, message));
    }
    Ok(read_each(keys, reader, read_axis))
}

/// Reads every key of a table and collects the refusals.
fn read_each<T>(
    keys: &DeTable,
    reader: &mut Reader,
    read: fn(&TomlKey, &TomlValue) -> Result<T, ValueError>,
) -> Vec<T> {
    let mut all = Vec::new();
    for (name, node) in keys {
        reader.in_table(name.get_ref(), |_| read(name, node).map(|one| all.push(one)));
    }
    all
}

fn read_axis(name: &TomlKey, node: &TomlValue) -> Result<SweepAxis, ValueError> {
    let path = name.get_ref();
    if path == METHOD_KEY {
        let method = |item: &TomlValue| find_word(&METHODS, item, Method::from_name).map(AxisWord::Method);
        return read_word_axis(METHOD_KEY, node, "[\"rk8\", \"dop853\"]", method);
    }
    if path == LAW_KEY {
        let find = |name: &str| LawChoice::from_name(name).filter(LawChoice::has_loading);
        if matches!(node.get_ref(), DeValue::String(all) if all == "all") {
            let laws = LawChoice::all().into_iter().filter(LawChoice::has_loading);
            return Ok(SweepAxis::from_words(LAW_KEY, laws.map(AxisWord::Law).collect()));
        }
        let law = |item: &TomlValue| find_word(&LAW_AXIS, item, find).map(AxisWord::Law);
        return read_word_axis(LAW_KEY, node, "[\"plm\", \"thornton\"]", law);
    }
    if let Some(body) = Body::from_material_key(path) {
        // the values that a material leaves to its defaults depend on the other keys, and are set later
        let choice = |material| AxisWord::Material(BodyMaterial { body, material, defaults: Vec::new() });
        let material = |item: &TomlValue| find_word(&MATERIALS, item, materials::find).map(choice);
        return read_word_axis(body.material(), node, "[\"steel-s235\", \"aluminium-6061-t6\"]", material);
    }
    let key = find_numeric_key(name, true)?;
    refuse_word(key, node)?;
    Ok(SweepAxis::from_numbers(key, read_axis_values(key.quantity(), node)?))
}

fn read_word_axis(
    path: &'static str,
    node: &TomlValue,
    example: &str,
    word: impl Fn(&TomlValue) -> Result<AxisWord, ValueError>,
) -> Result<SweepAxis, ValueError> {
    Ok(SweepAxis::from_words(path, read_distinct(node, read_list(node, example)?, word, AxisWord::name)?))
}

/// The values of an axis: at least one, and no value twice. Two values with the same `identity` are equal.
fn read_distinct<T, K: Eq + Hash>(
    node: &TomlValue,
    items: &[TomlValue],
    read: impl FnMut(&TomlValue) -> Result<T, ValueError>,
    identity: impl Fn(&T) -> K,
) -> Result<Vec<T>, ValueError> {
    if items.is_empty() {
        return Err(ValueError::new(node, "an axis needs at least one value"));
    }
    let values = items.iter().map(read).collect::<Result<Vec<T>, _>>()?;
    let mut seen = HashSet::new();
    let twice = values.iter().zip(items).find(|(value, _)| !seen.insert(identity(value)));
    match twice.map(|(_, item)| (item, describe_value(item))) {
        None => Ok(values),
        Some((item, text)) => Err(ValueError::new(item, format!("duplicate value {text}. Remove one."))),
    }
}

impl RandomKeys {
    /// Reads `[monte_carlo]`.
    pub(in crate::scenario) fn read(&mut self, node: &TomlValue, reader: &mut Reader) -> Result<(), ValueError> {
        let refused = reader.errors.len();
        for (name, value) in as_table(node)? {
            reader.in_table(name.get_ref(), |_| self.read_variable(name, value));
        }
        let problem = if !as_table(node)?.contains_key("samples") {
            "samples, the number of cases, is missing"
        } else if self.variables.is_empty() && self.materials.is_empty() && reader.errors.len() == refused {
            "has no random key. Add one such as \"half_space.yield_strength\" = { normal = { mean = \"345 MPa\", sd = \"20 MPa\" } }"
        } else {
            return Ok(());
        };
        Err(ValueError::new(node, problem))
    }

    fn read_variable(&mut self, name: &TomlKey, node: &TomlValue) -> Result<(), ValueError> {
        match &**name.get_ref() {
            "samples" => self.samples = read_count(&N_SAMPLES, node)?,
            "seed" => self.seed = read_count(&SEED, node)?,
            path => {
                if let Some(body) = Body::from_material_key(path) {
                    read_word(&MATERIAL_DISTRIBUTIONS, node)?;
                    self.materials.push((body, self.variables.len()));
                } else {
                    let key = find_numeric_key(name, false)?;
                    self.variables.push(Variable::new(key, read_distribution(key.quantity(), node)?));
                }
            }
        }
        Ok(())
    }
}

/// The keys of `calibrate.free`; empty if measurements are only compared.
pub(in crate::scenario) fn read_free_keys(node: &TomlValue, reader: &mut Reader) -> Result<Vec<FreeKey>, ValueError> {
    let DeValue::Table(keys) = node.get_ref() else { return Err(ValueError::wrong_type(node, FREE_KEY_EXAMPLE)) };
    if keys.len() > 2 {
        let message = format!(
            "{} keys are given, expected one or two, each with {FREE_KEY_FORM}; or none, to compare",
            keys.len()
        );
        return Err(ValueError::new(node, message));
    }
    Ok(read_each(keys, reader, read_free_key))
}

/// The index of a logarithmic scale in [`SCALES`].
const LOG_SCALE_INDEX: usize = 0;
const FREE_KEY_EXAMPLE: &str =
    "a table such as { \"half_space.yield_strength\" = { from = \"100 MPa\", to = \"1 GPa\" } }";
const FREE_KEY_FORM: &str = "{ from = ..., to = ... }, and scale = \"log\" or \"linear\" if need be";

/// A free key with its range.
fn read_free_key(name: &TomlKey, node: &TomlValue) -> Result<FreeKey, ValueError> {
    let key = find_numeric_key(name, false)?;
    let [from, to, scale] = table_values(node, ["from", "to", "scale"], FREE_KEY_FORM)?;
    let end = |end: Option<_>| end.map(|end| read_number(key.quantity(), None, end)).transpose();
    let ends = end(from)?.zip(end(to)?).filter(|(from, to)| from < to);
    let (from, to) =
        ends.ok_or_else(|| ValueError::new(node, format!("needs two ends, the lower first: {FREE_KEY_FORM}")))?;
    let is_logarithmic = match scale {
        Some(scale) => read_word(&SCALES, scale)? == LOG_SCALE_INDEX,
        None => from > 0.0,
    };
    if is_logarithmic && from <= 0.0 {
        return Err(ValueError::new(node, "a logarithmic range begins above 0; write scale = \"linear\""));
    }
    Ok(FreeKey { key, from, to, is_logarithmic, hardness: None })
}

/// Refuses the word in place of a number, because it cannot lie between numbers.
fn refuse_word(key: NumericKey, node: &TomlValue) -> Result<(), ValueError> {
    let (Some(word), DeValue::Array(items)) = (key.alternative_word(), node.get_ref()) else { return Ok(()) };
    let Some(item) = items.iter().find(|item| item.get_ref().as_str().is_some_and(|text| text.trim() == word)) else {
        return Ok(());
    };
    let path = key.path();
    let message = format!(
        "\"{word}\" is not a number, and an axis can contain numbers only. Make a separate table with --set {path}={word}."
    );
    Err(ValueError::new(item, message))
}

/// The values of a table that has only these keys; `form` describes such a table in messages.
fn table_values<'n, 't, const N: usize>(
    node: &'n TomlValue<'t>,
    names: [&str; N],
    form: &str,
) -> Result<[Option<&'n TomlValue<'t>>; N], ValueError> {
    let DeValue::Table(table) = node.get_ref() else { return Err(ValueError::wrong_type(node, form)) };
    let unknown = table.keys().find(|name| !names.contains(&&**name.get_ref()));
    let Some((name, span)) = unknown.map(|name| (name.get_ref(), name.span())) else {
        return Ok(names.map(|name| table.get(name)));
    };
    let hint = did_you_mean(name, names, '`', &format!("keys here are {}", names.join(", ")));
    Err(ValueError { span, message: format!("unknown key `{name}`{hint}") })
}

/// The numeric key of that path.
fn find_numeric_key(name: &TomlKey, has_words: bool) -> Result<NumericKey, ValueError> {
    let path = &**name.get_ref();
    if let Some(key) = NumericKey::find(path) {
        return Ok(key);
    }
    Err(ValueError { span: name.span(), message: unknown_key_message(path, has_words) })
}

/// The message about a path that is no numeric key; `has_words` if some keys with words are allowed too.
pub(in crate::scenario) fn unknown_key_message(path: &str, has_words: bool) -> String {
    let paths = || NUMERIC_KEYS.iter().map(|key| key.path());
    let dotted = format!("{path}.");
    let all = known_names(path, &paths().collect::<Vec<_>>(), "numeric keys");
    let hint = match paths().find(|known| known.starts_with(&dotted)) {
        Some(inner) => format!("; write the whole key in quotes, such as \"{inner}\" = ...; {all}"),
        None => did_you_mean(
            path,
            paths().chain(Body::ALL.map(Body::material)).chain(has_words.then_some(METHOD_KEY)),
            '"',
            &all,
        ),
    };
    format!("`{path}` is not a numeric key{hint}")
}

/// A list of values, or two ends and a number of points.
fn read_axis_values(quantity: &Quantity, value: &TomlValue) -> Result<AxisValues, ValueError> {
    if let DeValue::Array(items) = value.get_ref() {
        let read = |item: &TomlValue| read_number(quantity, None, item);
        return read_distinct(value, items, read, |number: &f64| number.to_bits()).map(AxisValues::List);
    }
    let example = quantity.example;
    let form = format!("a list such as [{example}], or {{ linspace = [from, to], points = 11 }}, or logspace");
    let (ends, is_log, points) = match table_values(value, ["linspace", "logspace", "points"], &form)? {
        [Some(ends), None, points] => (ends, false, points),
        [None, Some(ends), points] => (ends, true, points),
        _ => return Err(ValueError::new(value, "needs one of linspace = [from, to] and logspace = [from, to]")),
    };
    // NumPy has the number of values in the list
    if let DeValue::Array(items) = ends.get_ref()
        && let [_, _, n_points] = &items[..]
    {
        let message = format!(
            "has 3 numbers. Write the two ends only, and the number of values as points = {}",
            describe_value(n_points)
        );
        return Err(ValueError::new(ends, message));
    }
    let [from, to] = read_pair([quantity; 2], ends)?;
    let points = points.ok_or_else(|| ValueError::new(value, "points, the number of values, is missing"))?;
    let points = read_count(&POINTS, points)?;
    if from.to_bits() == to.to_bits() && points > 1 {
        let message = format!(
            "both ends are equal, so all {points} rows would be the same. Give two different ends, or points = 1."
        );
        return Err(ValueError::new(ends, message));
    }
    if !is_log {
        return Ok(AxisValues::Spaced { from, to, points, log10_ends: None });
    }
    if from > 0.0 && to > 0.0 {
        return Ok(AxisValues::logarithmic(from, to, points));
    }
    let message = "the ends of logspace must both be positive or both be negative. Use linspace, or a list of values.";
    Err(ValueError::new(value, message))
}

/// One distribution: `normal`, `lognormal` or `uniform`.
fn read_distribution(quantity: &Quantity, value: &TomlValue) -> Result<Distribution, ValueError> {
    const FORMS: &str =
        "{ normal = { mean = ..., sd = ... } }, { lognormal = { mean = ..., sd = ... } } or { uniform = [from, to] }";
    match table_values(value, ["normal", "lognormal", "uniform"], FORMS)? {
        [None, None, None] => Err(ValueError::new(value, format!("has no distribution; write {FORMS}"))),
        [None, None, Some(ends)] => match read_pair([quantity; 2], ends)? {
            [from, to] if from < to => Ok(Distribution::Uniform { from, to }),
            _ => Err(ValueError::new(ends, "uniform needs two ends, the lower first")),
        },
        [Some(normal), None, None] => {
            read_moments(quantity, normal).map(|(mean, sd)| Distribution::Normal { mean, sd })
        }
        [None, Some(lognormal), None] => match read_moments(quantity, lognormal)? {
            (mean, _) if mean <= 0.0 => {
                Err(ValueError::new(lognormal, "the mean of a lognormal must be > 0; use normal or uniform"))
            }
            (mean, sd) => Ok(Distribution::Lognormal { mean, sd }),
        },
        _ => Err(ValueError::new(value, "a key has one distribution")),
    }
}

/// Mean and standard deviation of a quantity.
fn read_moments(quantity: &Quantity, value: &TomlValue) -> Result<(f64, f64), ValueError> {
    let form = format!("{{ mean = {}, sd = ... }}", quantity.example);
    let [Some(mean), Some(sd)] = table_values(value, ["mean", "sd"], &form)? else {
        return Err(ValueError::new(value, "mean and sd, the standard deviation, are both needed"));
    };
    Ok((read_number(quantity, None, mean)?, read_deviation(quantity, sd)?))
}

/// A standard deviation. On a curved scale of hardness a difference of numbers is no difference of pressures.
fn read_deviation(quantity: &Quantity, node: &TomlValue) -> Result<f64, ValueError> {
    let scale = node.get_ref().as_str().and_then(hardness::parse).map(|(_, scale)| scale);
    if let Some(scale) = scale.filter(|scale| quantity.is_hardness && *scale != hardness::HardnessScale::Vickers) {
        let name = scale.name();
        let message = format!(
            "a standard deviation cannot be given in {name}, because this scale is not linear. Write it in HV, such as \"20 HV\", or as a pressure."
        );
        return Err(ValueError::new(node, message));
    }
    read_number(&deviation_quantity(quantity), None, node)
}

fn deviation_quantity(quantity: &Quantity) -> Quantity {
    Quantity {
        name: "a standard deviation (sd)",
        example: quantity.dimension.example(),
        is_hardness: quantity.is_hardness,
        ..positive_quantity(quantity.dimension)
    }
}
