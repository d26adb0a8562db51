//! Reading of a quantity with its unit.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::Dimension;
use super::names::did_you_mean;
use super::table::{Scale, UNITS, Unit};
use crate::error::Error;

fn known(unit: &str, dimension: Dimension) -> String {
    let all = match dimension {
        Dimension::Ratio => "none, or %".to_owned(),
        _ => dimension.units().map(|unit| unit.name).collect::<Vec<_>>().join(", "),
    };
    let rest = format!("units of {} are {all}", dimension.name());
    // "m/sec" and "m s^-1" are near to no name letter by letter
    let joined = plain_spelling(unit).replace(' ', "").replace("sec", "s");
    let guess = joined.replace("s-", "/s").replace("m-", "/m").replace("/s1", "/s");
    did_you_mean(&guess, dimension.units().map(|unit| unit.name), '"', &rest)
}

/// Reads a quantity with its unit and gives it in SI.
///
/// # Errors
/// The text, what is wrong, and what would be understood.
pub fn parse(text: &str, dimension: Dimension) -> Result<f64, Error> {
    parse_as(text, dimension, dimension.name(), dimension.example()).map_err(Error::input)
}

/// Reads a quantity that messages call by this name, and for which they give this example.
pub fn parse_as(text: &str, dimension: Dimension, name: &str, example: &str) -> Result<f64, String> {
    let no_number = || format!("\"{text}\" does not begin with a number; write {name} such as {example}");
    // printed text, which tables and pages have, has another minus than a keyboard
    let plain = text.trim().replace('\u{2212}', "-");
    let (number, unit) = split(&plain);
    if !number.bytes().any(|byte| byte.is_ascii_digit()) {
        return Err(no_number());
    }
    if unit.is_empty() {
        let no_unit = format!("\"{text}\" has no unit; write {name} such as {example}");
        return match dimension {
            Dimension::Ratio => number.parse().map_err(|_| no_number()),
            Dimension::Angle => Err(no_unit),
            _ => Err(format!("{no_unit}, or a number without quotes in {}", dimension.si_unit())),
        };
    }
    if unit.starts_with(',') {
        return Err(format!("\"{text}\" has a decimal comma; write a decimal point"));
    }
    if unit.starts_with(['.', '_']) {
        return Err(format!(
            "\"{text}\" has a number that cannot be read; write plain digits with one decimal point, such as {example}"
        ));
    }
    match SPELLINGS.get(&plain_spelling(unit)) {
        Some(unit) if unit.dimension == dimension => unit.scale.apply(number).ok_or_else(no_number),
        Some(other) => {
            let found = other.dimension.name();
            Err(format!("\"{text}\" is {found}, but {} is needed, such as {}", dimension.name(), dimension.example()))
        }
        None => Err(format!("unknown unit \"{unit}\" in \"{text}\"{}", known(unit, dimension))),
    }
}

/// The units by their plain spelling.
static SPELLINGS: LazyLock<HashMap<String, &Unit>> =
    LazyLock::new(|| UNITS.iter().map(|unit| (plain_spelling(unit.name), unit)).collect());

impl Scale {
    /// The number in SI, rounded once.
    fn apply(self, number: &str) -> Option<f64> {
        match self {
            Self::Ten(power) => {
                let (digits, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
                match exponent.parse::<i32>() {
                    Ok(exponent) => format!("{digits}e{}", exponent.saturating_add(power)).parse().ok(),
                    // an exponent of ten digits: infinite or zero in any unit
                    Err(_) => number.parse().ok(),
                }
            }
            Self::Times(factor) => number.parse::<f64>().ok().map(|value| value * factor),
            Self::Over(divisor) => number.parse::<f64>().ok().map(|value| value / divisor),
        }
    }
}

/// Splits "5e3 mm" into "5e3" and "mm".
fn split(text: &str) -> (&str, &str) {
    let bytes = text.as_bytes();
    let digits = |mut at: usize| {
        while bytes.get(at).is_some_and(u8::is_ascii_digit) {
            at += 1;
        }
        at
    };
    let sign = |at: usize| at + usize::from(matches!(bytes.get(at), Some(b'+' | b'-')));
    let mut end = digits(sign(0));
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    // an exponent only where digits follow: "5 e" is no number
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let from = sign(end + 1);
        let to = digits(from);
        if to > from {
            end = to;
        }
    }
    (&text[..end], text[end..].trim_start())
}

/// One spelling for all of "kg/m^3", "kg / m³", "kg/m**3", "kg/m3"; "µm" with either sign, "um".
fn plain_spelling(unit: &str) -> String {
    let plain = |c: char| match c {
        '\u{b5}' | '\u{3bc}' => Some('u'),
        '²' => Some('2'),
        '³' => Some('3'),
        '^' => None,
        c => Some(c),
    };
    let parts: Vec<&str> = unit.split('/').map(str::trim).collect();
    parts.join("/").replace("**", "").chars().filter_map(plain).collect()
}
