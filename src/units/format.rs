//! Values for people: in SI, and in the unit that gives a short number.

use super::Dimension;
use super::table::UnitScale;

use crate::numerics::functions::powi;

/// A number in its shortest exact form, with an exponent where zeros would hide the digits.
pub fn format_number(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 || (1e-4..1e6).contains(&size) || !value.is_finite() {
        value.to_string()
    } else {
        format!("{value:e}")
    }
}

/// To four significant digits, for messages.
pub fn format_four_digits(value: f64) -> String {
    format_number(format!("{value:.3e}").parse().unwrap_or(value))
}

/// In the SI unit, exact: "0.005 m".
pub fn format_si(value: f64, dimension: Dimension) -> String {
    format!("{} {}", format_number(value), dimension.si_unit()).trim_end().to_owned()
}

/// In a suitable unit, to six digits, as inputs are shown: "5 mm".
pub fn format_input(value: f64, dimension: Dimension) -> String {
    format_rounded(value, dimension, 6)
}

/// In a suitable unit, to four digits, as results are shown: "36.95 µm".
pub fn format_result(value: f64, dimension: Dimension) -> String {
    format_rounded(value, dimension, 4)
}

fn format_rounded(value: f64, dimension: Dimension, digits: usize) -> String {
    let rounded = format!("{value:.*e}", digits - 1);
    // 0.9999999 m is 1 m, and not 1000 mm
    format_in_suitable_unit(rounded.parse().unwrap_or(value), &rounded, dimension)
}

/// Values of one kind in one unit, to four digits: "0.1 m", "2 m". The unit suits most of them; a larger unit is taken if the
/// smallest value is a hundredth of that unit or more.
pub fn quantities(values: &[f64], dimension: Dimension) -> Vec<String> {
    let sizes = || values.iter().map(|value| value.abs()).filter(|size| *size > 0.0 && size.is_finite());
    let (low, high) = sizes().fold((f64::INFINITY, 0.0_f64), |(low, high), size| (low.min(size), high.max(size)));
    let middle = if high > 0.0 { (low.sqrt() * high.sqrt()).max(high.min(100.0 * low)) } else { 0.0 };
    let text = |value: &f64| {
        let rounded = format!("{value:.3e}");
        in_unit_of(middle, &rounded, dimension)
            .unwrap_or_else(|| format_si(rounded.parse().unwrap_or(*value), dimension))
    };
    values.iter().map(text).collect()
}

/// A share as a percentage, "37.74 %".
pub fn format_percent(share: f64) -> String {
    format!("{} %", format_four_digits(100.0 * share))
}

/// In a suitable unit, with all digits: it is read back to the same number.
pub fn format_exact(value: f64, dimension: Dimension) -> String {
    format_in_suitable_unit(value, &format!("{value:e}"), dimension)
}

/// A number as text with an exponent, in a suitable unit.
fn format_in_suitable_unit(value: f64, scientific: &str, dimension: Dimension) -> String {
    in_unit_of(value, scientific, dimension).unwrap_or_else(|| format_si(value, dimension))
}

/// A number as text with an exponent, in the unit that suits this size; `None` without such a unit. The exponent is changed in
/// the text, so that no digit changes.
fn in_unit_of(size: f64, scientific: &str, dimension: Dimension) -> Option<String> {
    let shown = || {
        dimension.units().filter(|unit| unit.is_displayed).filter_map(|unit| match unit.scale {
            UnitScale::PowerOfTen(power) => Some((unit.name, power)),
            UnitScale::Decimal(_) | UnitScale::Factor(_) | UnitScale::Divisor(_) => None,
        })
    };
    let fits = |&(_, power): &(&str, i32)| size.abs() >= powi(10_f64, power);
    let (name, power) = shown().filter(fits).last().or_else(|| shown().next()).filter(|_| size != 0.0)?;
    let (digits, exponent) = scientific.split_once('e')?;
    Some(format!("{} {name}", shift_exponent(digits, exponent.parse::<i32>().ok()? - power)))
}

/// Digits with a point behind the first, times ten to this power, as [`format_number`] writes it.
fn shift_exponent(digits: &str, exponent: i32) -> String {
    let (sign, digits) = digits.strip_prefix('-').map_or(("", digits), |digits| ("-", digits));
    let digits = if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits };
    if !(-4..6).contains(&exponent) {
        return format!("{sign}{digits}e{exponent}");
    }
    let zeros = "0".repeat(usize::try_from(-exponent).unwrap_or(0));
    let all = zeros + &digits.replace('.', "");
    let whole = 1 + usize::try_from(exponent).unwrap_or(0);
    let (before, after) = all.split_at_checked(whole).unwrap_or((&all, ""));
    format!("{sign}{before:0<whole$}.{after}").trim_end_matches('.').to_owned()
}

/// The quantity in the SI unit and in a suitable unit: "0.005 m (5 mm)". Only in the suitable unit if both are the same, or if the number in
/// SI has more than six digits.
pub fn format_si_and_short(value: f64, dimension: Dimension) -> String {
    let (exact, short) = (format_si(value, dimension), format_input(value, dimension));
    let is_long = format!("{value:.5e}").parse() != Ok(value);
    if exact == short || is_long { short } else { format!("{exact} ({short})") }
}
