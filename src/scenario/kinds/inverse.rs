//! The value of a key that gives a wanted result: the key, its range, and the input in which the key varies.

use std::ops::Bound::{self, Excluded};

use super::calibration::strength_range;
use crate::error::Error;
use crate::results::impact::impact_results;
use crate::results::{RESTITUTION, dimension_of, result_columns};
use crate::scenario::input::{Body, Input, NumericKey};
use crate::scenario::keys::Quantity;
use crate::scenario::plan::FreeKey;
use crate::scenario::plan::read_axes::unknown_key_message;
use crate::scenario::{Kind, Scenario};
use crate::strings::did_you_mean;
use crate::units::{self, Dimension};

/// The key that is searched, and the impact in which it varies.
#[derive(Debug, Clone)]
pub struct InverseRequest {
    pub free: FreeKey,
    /// The input with the key at the lower end of its range. The input has no alternative of the key.
    pub input: Input,
}

/// The range reaches from the value of the scenario divided by this factor to the value times this factor.
const RANGE_FACTOR: f64 = 100.0;
/// A key whose allowed range is not wider is searched in its whole allowed range.
const MAX_WHOLE_RANGE: f64 = 100.0;
/// The distance from an end that is not allowed, as a share of the range.
const MARGIN: f64 = 1e-6;
/// How a range is given, for messages.
pub const RANGE_OPTIONS: &str = "--from and --to (in Python: between)";
/// The ranges of speeds \[m/s\] and heights \[m\] if the scenario has none.
const APPROACH_RANGE: [f64; 2] = [1e-3, 100.0];

impl Scenario {
    /// The request for the value of the key `path` that gives a wanted `result`. The ends of the range are texts such as "1 mm"; an
    /// end that is not given follows from the scenario.
    ///
    /// # Errors
    /// [`Error`] for a scenario that is not a single impact, for a path that is not a numeric key or has no effect, for a bad range,
    /// and for a result that the scenario does not have.
    pub fn inverse_request(
        &self,
        path: &str,
        [from, to]: [Option<&str>; 2],
        result: &str,
    ) -> Result<InverseRequest, Error> {
        let kind = self.kind()?;
        if kind != Kind::Impact {
            let [name, description] = [kind.name(), kind.description()];
            let message = format!(
                "find needs a single impact, and this scenario is {description}. Remove this table, or add --set {name}=none."
            );
            return Err(self.document.refusal(name, message));
        }
        let Some(key) = NumericKey::find(path) else { return Err(Error::input(unknown_key_message(path, false))) };
        let read = |end: &str, text: Option<&str>| {
            let refuse = |message| Error::input(format!("{end} end of the range of {path}: {message}"));
            text.map(|text| read_value(key.quantity(), text).map_err(refuse)).transpose()
        };
        let range = match [read("lower", from)?, read("upper", to)?] {
            [Some(from), Some(to)] => [from, to],
            [from, to] => {
                let [low, high] = self.default_range(key).ok_or_else(|| {
                    Error::input(format!(
                        "{path} has no value in the scenario, so its range is not known. Give the range with {RANGE_OPTIONS}."
                    ))
                })?;
                [from.unwrap_or(low), to.unwrap_or(high)]
            }
        };
        let [from, to] = range;
        let free = FreeKey { key, from, to, is_logarithmic: from > 0.0, hardness: self.hardness_scale(key) };
        if from >= to {
            let [low, high] = range.map(|end| free.format_value(end, 6));
            return Err(Error::input(format!(
                "the range of {path} is {low} to {high}, but the lower end must be below the upper end. Change the range with {RANGE_OPTIONS}."
            )));
        }
        let varying = self.varying(&free, result)?;
        let mut input = varying.plan().map_err(|error| at_arguments(error, path))?.input;
        input.set(key, Some(from));
        Ok(InverseRequest { free, input })
    }

    /// The result under which the scene has this one: if the ball cannot yield, the depth of the dent is the residual indentation.
    pub fn result_of_scene<'r>(&self, result: &'r str, key: &str) -> &'r str {
        let has_flat = self.input.sphere().yield_strength.is_some() || key.starts_with("sphere.");
        if result == "dent_depth_m" && !has_flat { "residual_indentation_m" } else { result }
    }

    /// The scenario as a table along the range of the key. The rules of tables then refuse a key without effect, a key whose
    /// alternative is given too, and a result that the scene does not have.
    fn varying(&self, free: &FreeKey, result: &str) -> Result<Self, Error> {
        let path = free.key.path();
        let axis = format!("sweep.\"{path}\"=[{}, {}]", free.to_toml(free.from), free.to_toml(free.to));
        let is_column = result != RESTITUTION && result_columns().iter().any(|column| column.name == result);
        let column = is_column.then(|| format!("output.columns=[\"{result}\"]"));
        self.to_table([axis].into_iter().chain(column)).map_err(|error| at_arguments(error, path))
    }

    /// The scenario with this value of the key.
    pub fn with_value(&self, free: &FreeKey, value: f64) -> Result<Self, Error> {
        let mut source = self.source();
        source.overrides.push(format!("{}={}", free.key.path(), free.to_toml(value)));
        Self::from_source(self.document.name(), &source)
    }

    /// The range of a key for which none is given; `None` if nothing limits it.
    fn default_range(&self, key: NumericKey) -> Option<[f64; 2]> {
        let (path, quantity) = (key.path(), key.quantity());
        let has_strength = |body: &Body| [body.yield_strength(), body.hardness()].contains(&path);
        if let Some(body) = Body::ALL.into_iter().find(has_strength) {
            return Some(strength_range(&self.input, body, path)).filter(|[from, to]| from < to);
        }
        let (low, high) = quantity.range();
        if high - low <= MAX_WHOLE_RANGE {
            let margin = |end: Bound<f64>| if matches!(end, Excluded(_)) { MARGIN * (high - low) } else { 0.0 };
            return Some([low + margin(quantity.low), high - margin(quantity.high)]);
        }
        let value = self.present_value(key).filter(|value| value.is_finite() && *value != 0.0);
        match value {
            Some(value) if low < 0.0 => Some([-RANGE_FACTOR * value.abs(), RANGE_FACTOR * value.abs()]),
            Some(value) => Some([(value / RANGE_FACTOR).max(low * (1.0 + MARGIN)), (value * RANGE_FACTOR).min(high)]),
            None => path.starts_with("impact.").then_some(APPROACH_RANGE),
        }
    }

    /// The value of the key in the scenario, also if the scenario gives its alternative.
    fn present_value(&self, key: NumericKey) -> Option<f64> {
        let input = &self.input;
        let speed = Some(input.speed()).filter(|speed| speed.is_finite());
        match key.path() {
            "sphere.radius" => input.radius(),
            "sphere.diameter" => input.radius().map(|radius| 2.0 * radius),
            "sphere.mass" => input.mass(),
            "impact.speed" => speed,
            "impact.drop_height" => speed.map(|speed| 0.5 * speed * speed / input.drop_gravity()),
            _ => input.number(key),
        }
    }
}

/// Reads a number in SI, or a number with a unit.
fn read_value(quantity: &Quantity, text: &str) -> Result<f64, String> {
    text.trim().parse().map_or_else(|_| quantity.parse(text), |number| quantity.check_si_number(number))
}

/// Reads the wanted value of a result: a number in the unit of its name, or a number with a unit.
///
/// # Errors
/// The value, and the unit that it needs.
pub fn read_result(name: &str, text: &str) -> Result<f64, String> {
    if let Ok(number) = text.trim().parse::<f64>() {
        let is_right = number.is_finite();
        return if is_right { Ok(number) } else { Err(format!("{text} is not a finite number")) };
    }
    let is_angle = name.ends_with(DEGREES);
    let dimension = if is_angle { Dimension::Angle } else { dimension_of(name) };
    let value = units::parse(text, dimension).map_err(|error| error.to_string())?;
    Ok(if is_angle { value.to_degrees() } else { value })
}

/// The full name of a result of an impact that is given with or without its unit, and with hyphens or underscores:
/// `dent_diameter_m` for `dent-diameter`.
///
/// # Errors
/// The name, and a similar name.
pub fn find_result(given: &str) -> Result<&'static str, String> {
    let plain = |name: &str| name.replace(['.', '-'], "_").to_lowercase();
    let names = || impact_results().into_iter().map(|result| result.name);
    let wanted = plain(given);
    let found = names().find(|name| plain(name) == wanted || plain(name_without_unit(name)) == wanted);
    found.ok_or_else(|| {
        let hint = did_you_mean(given, names().map(name_without_unit), '`', "results.md lists all");
        format!("`{given}` is not a result of an impact{hint}")
    })
}

/// The end of the name of a result in degrees.
const DEGREES: &str = "_deg";

/// The name of a result without its unit, as options have it: `dent_diameter` of `dent_diameter_m`.
pub fn name_without_unit(name: &str) -> &str {
    name.strip_suffix(DEGREES).or_else(|| name.strip_suffix(dimension_of(name).suffix())).unwrap_or(name)
}

/// The error with the key in place of its axis, which nobody wrote.
fn at_arguments(error: Error, path: &str) -> Error {
    let axis = format!("sweep.{path}");
    error.with_texts(|details, _| {
        let (None, Some(key), Some(message)) = (&details.file, &details.key, &details.message) else { return None };
        match key.as_str() {
            key if key == axis => Some(format!("{path}: {message}")),
            "output.columns" => Some(message.clone()),
            _ => None,
        }
    })
}
