//! Values for people: in SI, and in the unit that gives a short number.

use super::Dimension;
use super::table::Scale;

use crate::math::functions::powi;

/// A number in its shortest exact form, with an exponent where zeros would hide the digits.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || (1e-4..1e6).contains(&size) || !value.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// To four significant digits, for messages.
pub fn four_digits(value: f64) -> String {
    number(format!("{value:.3e}").parse().unwrap_or(value))
}

/// In the SI unit, exact: "0.005 m".
pub fn si(value: f64, dimension: Dimension) -> String {
    format!("{} {}", number(value), dimension.si_unit()).trim_end().to_owned()
}

/// In a suitable unit, to six digits: "5 mm".
pub fn human(value: f64, dimension: Dimension) -> String {
    let shown = || {
        dimension.units().filter(|unit| unit.is_shown).filter_map(|unit| match unit.scale {
            Scale::Ten(power) => Some((unit.name, power)),
            Scale::Times(_) | Scale::Over(_) => None,
        })
    };
    if value == 0.0 {
        return si(value, dimension);
    }
    let fits = |&(_, power): &(&str, i32)| value.abs() >= powi(10_f64, power);
    let scientific = format!("{value:.5e}");
    let (Some((name, power)), Some((digits, exponent))) =
        (shown().filter(fits).last().or_else(|| shown().next()), scientific.split_once('e'))
    else {
        return si(value, dimension);
    };
    // the exponent is changed in the decimal text, so that no digit changes
    let shifted = exponent.parse::<i32>().ok().and_then(|e| format!("{digits}e{}", e - power).parse().ok());
    format!("{} {name}", number(shifted.unwrap_or(value)))
}

/// Both: "0.005 m (5 mm)"; one where they are the same.
pub fn describe(value: f64, dimension: Dimension) -> String {
    let (exact, short) = (si(value, dimension), human(value, dimension));
    if exact == short { exact } else { format!("{exact} ({short})") }
}

/// The text with a capital letter at its beginning.
pub fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
