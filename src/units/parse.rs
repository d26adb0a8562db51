//! Reading of a quantity with its unit.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::Dimension;
use super::table::{UNITS, Unit, UnitScale};
use crate::error::Error;
use crate::strings::capitalise;
use crate::strings::names::did_you_mean;

/// Other spellings of units, each with the unit that is meant. Letter by letter some are nearer to another unit.
const LIKELY: [(&str, &str); 14] = [
    ("inches", "in"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("meter", "m"),
    ("metre", "m"),
    ("microns", "micron"),
    ("kmh", "km/h"),
    ("km/hr", "km/h"),
    ("kmph", "km/h"),
    ("fps", "ft/s"),
    ("lbs", "lb"),
    ("pound", "lb"),
    ("ounce", "oz"),
    ("gram", "g"),
];

/// The end of a message about an unknown unit: the unit that is likely meant, if there is one, and all units.
fn unknown_unit_hint(unit: &str, dimension: Dimension) -> String {
    let all = match dimension {
        Dimension::Ratio => "none, or %".to_owned(),
        _ => dimension.unit_names().collect::<Vec<_>>().join(", "),
    };
    let rest = format!("units of {} are {all}", dimension.name());
    // "m/sec" and "m s^-1" are near to no name letter by letter
    let joined = normalise_unit(unit).replace(' ', "").replace("sec", "s");
    let guess = joined.replace("s-", "/s").replace("m-", "/m").replace("/s1", "/s");
    let same = dimension.unit_names().find(|name| normalise_unit(name).replace(' ', "").eq_ignore_ascii_case(&guess));
    let likely = || {
        let lower = guess.to_lowercase();
        let meant = LIKELY.iter().find(|(written, _)| *written == lower || format!("{written}s") == lower);
        meant.and_then(|(_, meant)| dimension.unit_names().find(|name| name == meant))
    };
    match same.or_else(likely) {
        Some(unit) => format!(", did you mean \"{unit}\"? {}", capitalise(&rest)),
        // one letter makes another unit of a short name: km/h is no mile an hour
        None if guess.chars().count() <= MAX_SHORT => format!("; {rest}"),
        None => did_you_mean(&guess, dimension.unit_names(), '"', &rest),
    }
}

/// A unit with so few letters is not guessed from its letters.
const MAX_SHORT: usize = 3;

/// Reads a quantity with its unit and gives it in SI.
///
/// # Errors
/// The text, the mistake, and the accepted forms.
pub fn parse(text: &str, dimension: Dimension) -> Result<f64, Error> {
    parse_named(text, dimension, dimension.name(), dimension.example()).map_err(Error::input)
}

/// Reads a quantity that messages call by this name, and for which they give this example.
pub fn parse_named(text: &str, dimension: Dimension, name: &str, example: &str) -> Result<f64, String> {
    let no_number = || format!("\"{text}\" does not begin with a number; write {name} such as {example}");
    // printed text, which tables and pages have, has another minus than a keyboard
    let mut plain = text.trim().replace('\u{2212}', "-");
    for (sign, fraction) in FRACTIONS {
        plain = plain.replace(sign, fraction);
    }
    let (number, unit) = split_number_and_unit(plain.trim());
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
    if let Some((fraction, unit)) = split_fraction(number, unit) {
        let inch = SPELLINGS.get(&normalise_unit(unit)).filter(|unit| ["in", "inch"].contains(&unit.name));
        let of_inches =
            inch.filter(|unit| unit.dimension == dimension).and_then(|unit| unit.scale.apply_to_fraction(fraction));
        let no_inches =
            || format!("\"{text}\" has a fraction, which only inches have; write a decimal number, such as {example}");
        return of_inches.ok_or_else(no_inches);
    }
    match SPELLINGS.get(&normalise_unit(unit)) {
        Some(unit) if dimension.has_units_of(unit.dimension) => unit.scale.to_si(number).ok_or_else(no_number),
        Some(other) => {
            let found = other.dimension.name();
            Err(format!("\"{text}\" is {found}, but {} is needed, such as {}", dimension.name(), dimension.example()))
        }
        None => Err(format!("unknown unit \"{unit}\" in \"{text}\"{}", unknown_unit_hint(unit, dimension))),
    }
}

/// The units by their plain spelling.
static SPELLINGS: LazyLock<HashMap<String, &Unit>> =
    LazyLock::new(|| UNITS.iter().map(|unit| (normalise_unit(unit.name), unit)).collect());

impl UnitScale {
    /// The number in SI, rounded once.
    fn to_si(self, number: &str) -> Option<f64> {
        match self {
            Self::PowerOfTen(power) => {
                let (digits, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
                match exponent.parse::<i32>() {
                    Ok(exponent) => format!("{digits}e{}", exponent.saturating_add(power)).parse().ok(),
                    // an exponent of ten digits: infinite or zero in any unit
                    Err(_) => number.parse().ok(),
                }
            }
            Self::Decimal(factor) => {
                product(number, factor).or_else(|| Some(number.parse::<f64>().ok()? * factor.parse::<f64>().ok()?))
            }
            Self::Factor(factor) => number.parse::<f64>().ok().map(|value| value * factor),
            Self::Divisor(divisor) => number.parse::<f64>().ok().map(|value| value / divisor),
        }
    }

    /// A fraction in SI, rounded once; `None` for a unit that has no decimal factor.
    fn apply_to_fraction(self, [numerator, denominator]: [i64; 2]) -> Option<f64> {
        let Self::Decimal(factor) = self else { return None };
        let (factor, power) = integer_and_power(factor)?;
        let divisor = 10_i128.checked_pow(power.checked_neg()?.try_into().ok()?)?;
        let numerator = factor.checked_mul(numerator.into())?;
        Some(numerator as f64 / divisor.checked_mul(denominator.into())? as f64)
    }
}

/// The product of two decimal numbers, rounded once; `None` if they have too many digits.
fn product(one: &str, other: &str) -> Option<f64> {
    let ((one, power), (other, other_power)) = (integer_and_power(one)?, integer_and_power(other)?);
    format!("{}e{}", one.checked_mul(other)?, power.checked_add(other_power)?).parse().ok()
}

/// A decimal number as an integer and the power of ten behind it: 254 and -4 for "0.0254".
fn integer_and_power(number: &str) -> Option<(i128, i32)> {
    let (digits, exponent) = number.split_once(['e', 'E']).unwrap_or((number, "0"));
    let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
    let power = exponent.parse::<i32>().ok()?.checked_sub(decimals.len().try_into().ok()?)?;
    Some((format!("{whole}{decimals}").parse().ok()?, power))
}

/// Splits "5e3 mm" into "5e3" and "mm".
fn split_number_and_unit(text: &str) -> (&str, &str) {
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

/// Fractions that are one character.
const FRACTIONS: [(char, &str); 7] =
    [('½', " 1/2"), ('¼', " 1/4"), ('¾', " 3/4"), ('⅛', " 1/8"), ('⅜', " 3/8"), ('⅝', " 5/8"), ('⅞', " 7/8")];

/// The numerator and the denominator of a fraction, "1/2", "1 1/2" or "1-1/2", and the unit behind it; `None` for a text without a
/// fraction. `number` and `rest` are the parts of a text by [`split_number_and_unit`].
fn split_fraction<'t>(number: &str, rest: &'t str) -> Option<([i64; 2], &'t str)> {
    let natural = |text: &str| text.parse::<u16>().ok().map(i64::from);
    let (sign, number) = number.strip_prefix('-').map_or((1, number), |positive| (-1, positive));
    let (whole, numerator, behind) = if let Some(behind) = rest.strip_prefix('/') {
        (0, natural(number)?, behind)
    } else {
        let (numerator, behind) = rest.strip_prefix('-').unwrap_or(rest).split_once('/')?;
        (natural(number)?, natural(numerator)?, behind)
    };
    let (denominator, unit) = behind.split_at(behind.find(|c: char| !c.is_ascii_digit()).unwrap_or(behind.len()));
    let denominator = natural(denominator).filter(|denominator| *denominator > 0)?;
    Some(([sign * (whole * denominator + numerator), denominator], unit.trim_start()))
}

/// One spelling for all of "kg/m^3", "kg / m³", "kg/m**3", "kg/m3"; "Pa·s", "Pa*s"; "µm" with either sign, "um"; 1" and 1″.
fn normalise_unit(unit: &str) -> String {
    let plain = |c: char| match c {
        '\u{b5}' | '\u{3bc}' => Some('u'),
        '²' => Some('2'),
        '³' => Some('3'),
        '^' => None,
        // the signs of a product
        '\u{b7}' | '\u{22c5}' | '*' => Some(' '),
        c => Some(c),
    };
    if ["\"", "\u{2033}", "\u{201d}", "''"].contains(&unit) {
        return "in".to_owned();
    }
    let parts: Vec<&str> = unit.split('/').map(str::trim).collect();
    let all: String = parts.join("/").replace("**", "").chars().filter_map(plain).collect();
    all.split_whitespace().collect::<Vec<_>>().join(" ")
}
