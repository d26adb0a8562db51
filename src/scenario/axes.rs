//! `[sweep]` and `[monte_carlo]`: keys with many values, or with a distribution of them.

use std::collections::HashSet;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::values::{Fault, Refused, count, list, number, numbers, unexpected, word};
use crate::impact::Method;
use crate::law::LawChoice;
use crate::materials::find;
use crate::plan::axis::{Axis, Values, Word};
use crate::plan::free::Free;
use crate::plan::random::{Distribution, Variable};
use crate::scene::quantity::{POINTS, Quantity, SAMPLED, SEED};
use crate::scene::taken::{Body, Taken};
use crate::scene::words::{DRAWN, LAWS, MATERIALS, METHODS, SCALES};
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
    /// Where it stands in the file.
    pub(super) span: Range<usize>,
}

/// `[monte_carlo]`
#[derive(Debug, Clone)]
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

/// The axes of `[sweep]`, in the order of the file; `place` is the path of the table.
pub(super) fn axes(place: &str, table: &DeTable, whole: &Spanned<DeValue>) -> Result<Vec<Axis>, Refused> {
    if table.is_empty() {
        let message = "has no axis; leave the table out, or give one such as \"impact.speed\" = [\"1 m/s\", \"2 m/s\"]";
        return Err(Fault::at(whole, message).of(place));
    }
    let axis = |(name, value): (&Spanned<DeString>, &Spanned<DeValue>)| {
        axis(name, value).map_err(|fault| fault.of(format!("{place}.{}", name.get_ref())))
    };
    table.iter().map(axis).collect()
}

fn axis(name: &Spanned<DeString>, value: &Spanned<DeValue>) -> Result<Axis, Fault> {
    let path = name.get_ref().as_ref();
    if path == METHOD {
        let names = names(value, "[\"rk8\", \"dop853\"]", |item| word(&METHODS, item))?;
        let method = |name: &String| Method::from_name(name).map(Word::Method);
        return Ok(Axis::of_words(METHOD, names.iter().filter_map(method).collect()));
    }
    if path == LAW {
        let names = names(value, "[\"plm\", \"thornton\"]", law)?;
        let law = |name: &String| LawChoice::from_name(name).map(Word::Law);
        return Ok(Axis::of_words(LAW, names.iter().filter_map(law).collect()));
    }
    if let Some(body) = Body::of_key(path) {
        let names = names(value, "[\"steel-s235\", \"aluminium-6061-t6\"]", |item| word(&MATERIALS, item))?;
        // what is left to the materials depends on the other keys
        let taken = |material| Word::Material(Taken { body, material, left: Vec::new() });
        let words = names.iter().filter_map(|name| find(name)).map(taken);
        return Ok(Axis::of_words(body.material(), words.collect()));
    }
    let key = known(path, true, name)?;
    Ok(Axis::of_number(key, axis_values(key.quantity, value)?))
}

/// `[monte_carlo]`.
pub(super) fn variables(place: &str, table: &DeTable, whole: &Spanned<DeValue>) -> Result<RandomKeys, Refused> {
    let mut read_table = RandomKeys { samples: 0, seed: 0, variables: Vec::new(), materials: Vec::new() };
    for (name, value) in table {
        let path = name.get_ref().as_ref();
        let refused = |fault: Fault| fault.of(format!("{place}.{path}"));
        match path {
            "samples" => read_table.samples = whole_number(&SAMPLED, value).map_err(refused)?,
            "seed" => read_table.seed = whole_number(&SEED, value).map_err(refused)?,
            path => {
                if let Some(body) = Body::of_key(path) {
                    word(&DRAWN, value).map_err(refused)?;
                    let place = read_table.variables.len();
                    read_table.materials.push(DrawnMaterial { body, place, span: value.span() });
                    continue;
                }
                let key = known(path, false, name).map_err(refused)?;
                read_table.variables.push(Variable::of(key, distribution(key.quantity, value).map_err(refused)?));
            }
        }
    }
    let problem = if read_table.samples == 0 {
        "samples, the number of cases, is missing"
    } else if read_table.variables.is_empty() && read_table.materials.is_empty() {
        "has no random key; give one such as \"half_space.yield_strength\" = { normal = { mean = \"345 MPa\", sd = \"20 MPa\" } }"
    } else {
        return Ok(read_table);
    };
    Err(Fault::at(whole, problem).of(place))
}

/// `calibrate.free`: keys with ranges.
pub(super) fn free(place: &str, table: &DeTable, whole: &Spanned<DeValue>) -> Result<Vec<Free>, Refused> {
    const FORM: &str = "{ from = ..., to = ... }, and scale = \"log\" or \"linear\" if need be";
    if table.is_empty() || table.len() > 2 {
        let message = format!("{} keys are given, expected one or two, each with {FORM}", table.len());
        return Err(Fault::at(whole, message).of(place));
    }
    let entry = |name: &Spanned<DeString>, value: &Spanned<DeValue>| {
        let key = known(name.get_ref(), false, name)?;
        let [from, to, scale] = parts(value, ["from", "to", "scale"], FORM)?;
        let end = |end: Option<_>| end.map(|end| number(key.quantity, None, end)).transpose();
        let ends = end(from)?.zip(end(to)?).filter(|(from, to)| from < to);
        let (from, to) = ends.ok_or_else(|| Fault::at(value, format!("needs two ends, the lower first: {FORM}")))?;
        let is_logarithmic = match scale {
            Some(scale) => word(&SCALES, scale)? == "log",
            None => from > 0.0,
        };
        if is_logarithmic && from <= 0.0 {
            return Err(Fault::at(value, "a logarithmic range begins above 0; write scale = \"linear\""));
        }
        Ok(Free { key, from, to, is_logarithmic })
    };
    let entries = table.iter();
    entries
        .map(|(name, value)| entry(name, value).map_err(|fault| fault.of(format!("{place}.{}", name.get_ref()))))
        .collect()
}

/// The values of a table that has these keys alone; `form` says how such a table is written.
fn parts<'v, 'i, const N: usize>(
    value: &'v Spanned<DeValue<'i>>,
    names: [&str; N],
    form: &str,
) -> Result<[Option<&'v Spanned<DeValue<'i>>>; N], Fault> {
    let DeValue::Table(table) = value.get_ref() else { return Err(unexpected(value, form)) };
    let unknown = table.keys().find(|name| !names.contains(&name.get_ref().as_ref()));
    let Some(name) = unknown else { return Ok(names.map(|name| table.get(name))) };
    let hint = did_you_mean(name.get_ref(), names, '`', &format!("keys here are {}", names.join(", ")));
    Err(Fault::at(name, format!("unknown key `{}`{hint}", name.get_ref())))
}

/// A whole number of 64 bits, which a floating number could not hold.
fn whole_number(quantity: &'static Quantity, value: &Spanned<DeValue>) -> Result<u64, Fault> {
    if let DeValue::Integer(digits) = value.get_ref()
        && let Ok(number) = u64::from_str_radix(digits.as_str(), digits.radix())
        && number > 0
    {
        return Ok(number);
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, and in the range of its quantity
    count(quantity, value).map(|number| number as u64)
}

/// The numeric key of that path.
fn known(path: &str, has_words: bool, place: &Spanned<DeString>) -> Result<&'static Key, Fault> {
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
    Err(Fault::at(place, format!("`{path}` is no numeric key of a scenario{hint}")))
}

/// The names of an axis of words, each read by `read`; none may be there twice.
fn names(
    value: &Spanned<DeValue>,
    example: &str,
    read: impl Fn(&Spanned<DeValue>) -> Result<String, Fault>,
) -> Result<Vec<String>, Fault> {
    let names = list(value, example)?.iter().map(read).collect::<Result<Vec<_>, _>>()?;
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
fn law(item: &Spanned<DeValue>) -> Result<String, Fault> {
    let name = super::values::text(item, "plm")?;
    if let Some(law) = LawChoice::from_name(&name).filter(LawChoice::has_loading) {
        return Ok(law.name());
    }
    let whole = (LAWS.known)();
    let all = format!("laws are {}, or \"loading + unloading\" such as \"jackson_green + brake\"", whole.join(", "));
    let hint = did_you_mean(&name, whole.iter().map(String::as_str), '"', &all);
    Err(Fault::at(item, format!("no law is known as \"{name}\"{hint}")))
}

/// A list of values, or two ends and how many points.
fn axis_values(quantity: &Quantity, value: &Spanned<DeValue>) -> Result<Values, Fault> {
    if let DeValue::Array(items) = value.get_ref() {
        return if items.is_empty() {
            Err(Fault::at(value, AT_LEAST_ONE))
        } else {
            numbers(quantity, value).map(Values::List)
        };
    }
    let example = quantity.example;
    let form = format!("a list such as [{example}], or {{ linspace = [from, to], points = 11 }}, or logspace");
    let (ends, is_log, points) = match parts(value, ["linspace", "logspace", "points"], &form)? {
        [Some(ends), None, points] => (ends, false, points),
        [None, Some(ends), points] => (ends, true, points),
        _ => return Err(Fault::at(value, "needs one of linspace = [from, to] and logspace = [from, to]")),
    };
    let values = numbers(quantity, ends)?;
    let [from, to] = values[..] else {
        return Err(Fault::at(ends, format!("{} values are given; write the two ends", values.len())));
    };
    let points = points.ok_or_else(|| Fault::at(value, "points, the number of values, is missing"))?;
    let points = whole_number(&POINTS, points)?;
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
fn distribution(quantity: &Quantity, value: &Spanned<DeValue>) -> Result<Distribution, Fault> {
    const FORMS: &str =
        "{ normal = { mean = ..., sd = ... } }, { lognormal = { mean = ..., sd = ... } } or { uniform = [from, to] }";
    match parts(value, ["normal", "lognormal", "uniform"], FORMS)? {
        [None, None, None] => Err(Fault::at(value, format!("has no distribution; write {FORMS}"))),
        [None, None, Some(ends)] => match numbers(quantity, ends)?[..] {
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
fn moments(quantity: &Quantity, value: &Spanned<DeValue>) -> Result<(f64, f64), Fault> {
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
