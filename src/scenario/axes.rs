//! `[sweep]` and `[monte_carlo]`: keys with many values, or with a distribution of them.

use std::collections::HashSet;
use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::values::{Fault, count, described, list, number, numbers, word};
use crate::impact::Method;
use crate::law::LawChoice;
use crate::materials::{Entry, find};
use crate::plan::axis::Values;
use crate::plan::random::Distribution;
use crate::scene::quantity::{Quantity, SAMPLED, SEED};
use crate::scene::taken::Body;
use crate::scene::words::{DRAWN, LAWS, MATERIALS, METHODS, SCALES};
use crate::scene::{KEYS, Key};
use crate::units::nearest::did_you_mean;

/// The keys that are axes of words.
pub(super) const METHOD: &str = "solver.method";
pub(super) const LAW: &str = "law";

/// What an axis runs through.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum AxisEntry {
    /// Numbers in SI.
    Numbers(Values),
    /// Methods.
    Methods(Vec<Method>),
    /// Laws.
    Laws(Vec<LawChoice>),
    /// Materials of a body.
    Materials(Vec<&'static Entry>),
}

/// A body whose material is drawn from.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DrawnMaterial {
    pub(super) body: Body,
    /// How many random keys stand before it.
    pub(super) place: usize,
    /// Where it stands in the file.
    pub(super) span: Range<usize>,
}

/// `[monte_carlo]`
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RandomKeys {
    /// How many samples.
    pub(super) samples: u64,
    /// Which random numbers; 0 if not given.
    pub(super) seed: u64,
    /// Random keys in the order of the file.
    pub(super) variables: Vec<(&'static str, Distribution)>,
    /// Materials to draw from.
    pub(super) materials: Vec<DrawnMaterial>,
}

/// A key that is wanted: its path, both ends of its range, and whether that is logarithmic.
pub(super) type FreeEntry = (&'static str, f64, f64, bool);

/// A refusal of a key of the table, or of the table itself.
type Refused = (Option<String>, Fault);

/// The axes of `[sweep]`, in the order of the file.
pub(super) fn axes(table: &DeTable, whole: &Spanned<DeValue>) -> Result<Vec<(&'static str, AxisEntry)>, Refused> {
    if table.is_empty() {
        let message = "has no axis; leave the table out, or give one such as \"impact.speed\" = [\"1 m/s\", \"2 m/s\"]";
        return Err((None, Fault::at(whole, message)));
    }
    let axis = |(name, value): (&Spanned<_>, &Spanned<DeValue>)| {
        let path: &std::borrow::Cow<str> = name.get_ref();
        let refused = |fault| (Some(path.to_string()), fault);
        let entry = match path.as_ref() {
            METHOD => {
                let words = not_empty(value, "[\"rk8\", \"dop853\"]").map_err(refused)?;
                let methods =
                    words.iter().map(|item| Ok(Method::from_name(&word(&METHODS, item)?).unwrap_or(Method::Auto)));
                let methods = methods.collect::<Result<Vec<_>, _>>().map_err(refused)?;
                distinct(methods.iter().map(|method| method.name().to_owned()), value).map_err(refused)?;
                (METHOD, AxisEntry::Methods(methods))
            }
            LAW => {
                let words = not_empty(value, "[\"plm\", \"thornton\"]").map_err(refused)?;
                let laws = words.iter().map(law).collect::<Result<Vec<_>, _>>().map_err(refused)?;
                distinct(laws.iter().map(LawChoice::name), value).map_err(refused)?;
                (LAW, AxisEntry::Laws(laws))
            }
            path => {
                if let Some(body) = Body::of_key(path) {
                    (body.material(), AxisEntry::Materials(materials(value).map_err(refused)?))
                } else {
                    let key = known(path, true, name.span()).map_err(refused)?;
                    (key.path, AxisEntry::Numbers(axis_values(key.quantity, value).map_err(refused)?))
                }
            }
        };
        Ok(entry)
    };
    table.iter().map(axis).collect()
}

/// `[monte_carlo]`.
pub(super) fn variables(table: &DeTable, whole: &Spanned<DeValue>) -> Result<RandomKeys, Refused> {
    let mut read_table = RandomKeys { samples: 0, seed: 0, variables: Vec::new(), materials: Vec::new() };
    for (name, value) in table {
        let path = name.get_ref().as_ref();
        let refused = |fault| (Some(path.to_owned()), fault);
        match path {
            "samples" => read_table.samples = whole_number(&SAMPLED, value).map_err(refused)?,
            "seed" => read_table.seed = whole_number(&SEED, value).map_err(refused)?,
            path if Body::of_key(path).is_some() => {
                word(&DRAWN, value).map_err(refused)?;
                let place = read_table.variables.len();
                let drawn = Body::of_key(path).map(|body| DrawnMaterial { body, place, span: value.span() });
                read_table.materials.extend(drawn);
            }
            path => {
                let key = known(path, false, name.span()).map_err(refused)?;
                read_table.variables.push((key.path, distribution(key.quantity, value).map_err(refused)?));
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
    Err((None, Fault::at(whole, problem)))
}

/// `calibrate.free`: keys with ranges.
pub(super) fn free(table: &DeTable, whole: &Spanned<DeValue>) -> Result<Vec<FreeEntry>, Refused> {
    const FORM: &str = "{ from = ..., to = ... }, and scale = \"log\" or \"linear\" if need be";
    if table.is_empty() || table.len() > 2 {
        let message = format!("{} keys are given, expected one or two, each with {FORM}", table.len());
        return Err((None, Fault::at(whole, message)));
    }
    let entry = |(name, value): (&Spanned<_>, &Spanned<DeValue>)| {
        let path: &std::borrow::Cow<str> = name.get_ref();
        let read = || {
            let key = known(path, false, name.span())?;
            let DeValue::Table(table) = value.get_ref() else {
                return Err(Fault::at(value, format!("found {}, expected {FORM}", described(value.get_ref()))));
            };
            let (mut from, mut to, mut scale) = (None, None, None);
            for (name, inner) in table {
                match name.get_ref().as_ref() {
                    "from" => from = Some(number(key.quantity, None, inner)?),
                    "to" => to = Some(number(key.quantity, None, inner)?),
                    "scale" => scale = Some(word(&SCALES, inner)? == "log"),
                    other => return Err(Fault { span: name.span(), message: format!("`{other}`: a range is {FORM}") }),
                }
            }
            let ends = from.zip(to).filter(|(from, to)| from < to);
            let (from, to) =
                ends.ok_or_else(|| Fault::at(value, format!("needs two ends, the lower first: {FORM}")))?;
            let is_logarithmic = scale.unwrap_or(from > 0.0);
            if is_logarithmic && from <= 0.0 {
                return Err(Fault::at(value, "a logarithmic range begins above 0; write scale = \"linear\""));
            }
            Ok((key.path, from, to, is_logarithmic))
        };
        read().map_err(|fault| (Some(path.to_string()), fault))
    };
    table.iter().map(entry).collect()
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
fn known(path: &str, has_words: bool, span: std::ops::Range<usize>) -> Result<&'static Key, Fault> {
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
    Err(Fault { span, message: format!("`{path}` is no numeric key of a scenario{hint}") })
}

/// The items of an axis of words.
fn not_empty<'v, 'i>(value: &'v Spanned<DeValue<'i>>, example: &str) -> Result<&'v [Spanned<DeValue<'i>>], Fault> {
    let items = list(value, example)?;
    if items.is_empty() { Err(Fault::at(value, AT_LEAST_ONE)) } else { Ok(items) }
}

/// The materials of an axis.
fn materials(value: &Spanned<DeValue>) -> Result<Vec<&'static Entry>, Fault> {
    let items = not_empty(value, "[\"steel-s235\", \"aluminium-6061-t6\"]")?;
    let names = items.iter().map(|item| word(&MATERIALS, item)).collect::<Result<Vec<_>, _>>()?;
    distinct(names.iter().cloned(), value)?;
    Ok(names.iter().filter_map(|name| find(name)).collect())
}

/// Refuses an axis with the same name twice.
fn distinct(names: impl Iterator<Item = String>, value: &Spanned<DeValue>) -> Result<(), Fault> {
    let mut seen = HashSet::new();
    for name in names {
        if let Some(name) = seen.replace(name) {
            let message = format!("\"{name}\" is there twice, which would be the same rows twice; leave one out");
            return Err(Fault::at(value, message));
        }
    }
    Ok(())
}

const AT_LEAST_ONE: &str = "an axis needs at least one value";

/// A law by its name, or two halves "loading + unloading".
fn law(item: &Spanned<DeValue>) -> Result<LawChoice, Fault> {
    let name = super::values::text(item, "plm")?;
    LawChoice::from_name(&name).filter(LawChoice::has_loading).ok_or_else(|| {
        let whole = (LAWS.known)();
        let all =
            format!("laws are {}, or \"loading + unloading\" such as \"jackson_green + brake\"", whole.join(", "));
        let hint = did_you_mean(&name, whole.iter().map(String::as_str), '"', &all);
        Fault::at(item, format!("no law is known as \"{name}\"{hint}"))
    })
}

/// A list of values, or two ends and how many points.
fn axis_values(quantity: &Quantity, value: &Spanned<DeValue>) -> Result<Values, Fault> {
    let refuse = |message: String| Err(Fault::at(value, message));
    let table = match value.get_ref() {
        DeValue::Array(items) if items.is_empty() => return refuse(AT_LEAST_ONE.to_owned()),
        DeValue::Array(_) => return Ok(Values::List(numbers(quantity, value)?)),
        DeValue::Table(table) => table,
        other => {
            let example = quantity.example;
            return refuse(format!(
                "found {}, expected a list such as [{example}], or {{ linspace = [from, to], points = 11 }}, or logspace",
                described(other)
            ));
        }
    };
    let (mut ends, mut points) = (None, None);
    for (name, inner) in table {
        match name.get_ref().as_ref() {
            space @ ("linspace" | "logspace") if ends.is_none() => {
                let values = numbers(quantity, inner)?;
                let [from, to] = values[..] else {
                    return Err(Fault::at(inner, format!("{space} takes two ends, not {} values", values.len())));
                };
                ends = Some((space == "logspace", from, to));
            }
            "points" => points = Some(whole_number(&crate::scene::quantity::POINTS, inner)?),
            other => {
                let message =
                    format!("`{other}`: an axis is {{ linspace = [from, to], points = n }} or {{ logspace = ... }}");
                return Err(Fault { span: name.span(), message });
            }
        }
    }
    let Some((is_log, from, to)) = ends else {
        return refuse("linspace = [from, to] or logspace is missing".to_owned());
    };
    let Some(points) = points else { return refuse("points, the number of values, is missing".to_owned()) };
    if is_log && !(from > 0.0 && to > 0.0) {
        return refuse(
            "logspace cannot reach or pass zero: begin above it, or use linspace, or a list of values".to_owned(),
        );
    }
    Ok(if is_log { Values::logarithmic(from, to, points) } else { Values::Linear { from, to, points } })
}

/// One distribution: `normal`, `lognormal` or `uniform`.
fn distribution(quantity: &Quantity, value: &Spanned<DeValue>) -> Result<Distribution, Fault> {
    const FORMS: &str =
        "{ normal = { mean = ..., sd = ... } }, { lognormal = { mean = ..., sd = ... } } or { uniform = [from, to] }";
    let DeValue::Table(table) = value.get_ref() else {
        return Err(Fault::at(value, format!("found {}, expected {FORMS}", described(value.get_ref()))));
    };
    let mut entries = table.iter();
    let Some((name, inner)) = entries.next() else {
        return Err(Fault::at(value, format!("has no distribution; write {FORMS}")));
    };
    if let Some((second, _)) = entries.next() {
        return Err(Fault { span: second.span(), message: "a key has one distribution".to_owned() });
    }
    match name.get_ref().as_ref() {
        "uniform" => match numbers(quantity, inner)?[..] {
            [from, to] if from < to => Ok(Distribution::Uniform { from, to }),
            _ => Err(Fault::at(inner, "uniform takes two ends, the lower first")),
        },
        "normal" => moments(quantity, inner).map(|(mean, sd)| Distribution::Normal { mean, sd }),
        "lognormal" => match moments(quantity, inner)? {
            (mean, _) if mean <= 0.0 => {
                Err(Fault::at(inner, "the mean of a lognormal must be > 0; use normal or uniform"))
            }
            (mean, sd) => Ok(Distribution::Lognormal { mean, sd }),
        },
        other => {
            let known = ["normal", "lognormal", "uniform"];
            let hint = did_you_mean(other, known, '`', &format!("distributions are {}", known.join(", ")));
            Err(Fault { span: name.span(), message: format!("unknown distribution `{other}`{hint}") })
        }
    }
}

/// Mean and standard deviation of a quantity.
fn moments(quantity: &Quantity, value: &Spanned<DeValue>) -> Result<(f64, f64), Fault> {
    let DeValue::Table(table) = value.get_ref() else {
        let expected = format!("{{ mean = {}, sd = ... }}", quantity.example);
        return Err(Fault::at(value, format!("found {}, expected {expected}", described(value.get_ref()))));
    };
    let (mut mean, mut sd) = (None, None);
    for (name, inner) in table {
        match name.get_ref().as_ref() {
            "mean" => mean = Some(number(quantity, None, inner)?),
            "sd" => sd = Some(number(&spread(quantity), None, inner)?),
            other => {
                let message = format!("`{other}`: a distribution has mean and sd");
                return Err(Fault { span: name.span(), message });
            }
        }
    }
    mean.zip(sd).ok_or_else(|| Fault::at(value, "mean and sd, the standard deviation, are both needed"))
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
