//! Numbers for people: four significant digits and an SI prefix, "36.95 µm", "1.106 kN".

use super::four_digits;

/// A power of ten with its SI symbol.
#[derive(Debug, Clone, PartialEq)]
pub struct Prefix {
    /// What a value is divided by.
    pub factor: f64,
    /// "m", "µ", "k"; "10⁻³⁰⁰ " where SI has no common letter.
    pub symbol: String,
}

const SYMBOLS: [&str; 10] = ["f", "p", "n", "µ", "m", "", "k", "M", "G", "T"];
const FIRST_EXPONENT: i32 = -15;

impl Prefix {
    /// The prefix under which `value` is written with one to three digits before the point.
    pub fn of(value: f64) -> Self {
        let exponent = if value.is_finite() && value != 0.0 { exponent(value).div_euclid(3) * 3 } else { 0 };
        // 1e-306 is the smallest multiple of three that is not subnormal
        let exponent = exponent.max(-306);
        let symbol = usize::try_from((exponent - FIRST_EXPONENT) / 3)
            .ok()
            .filter(|_| exponent >= FIRST_EXPONENT)
            .and_then(|index| SYMBOLS.get(index))
            .map_or_else(|| format!("{} ", power_of_ten(exponent)), ToString::to_string);
        Self { factor: ten_to(exponent), symbol }
    }
}

/// The power of ten of a number rounded to four digits.
fn exponent(value: f64) -> i32 {
    format!("{value:.3e}").split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// 10^k, correctly rounded (`powi` is not).
pub fn ten_to(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::INFINITY)
}

/// "10⁻³".
pub fn power_of_ten(exponent: i32) -> String {
    let superscript = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    format!("10{}", exponent.to_string().chars().map(superscript).collect::<String>())
}

/// A value in an SI unit, with prefix: `quantity(3.6948e-5, "m")` is "36.95 µm".
pub fn quantity(value: f64, unit: &str) -> String {
    let prefix = Prefix::of(value);
    let space = match (unit, prefix.symbol.as_str()) {
        ("", "") => "",
        // a power of ten is no letter that could stand beside a number
        (_, symbol) if symbol.starts_with("10") => " × ",
        _ => " ",
    };
    format!("{}{space}{}{unit}", four_digits(value / prefix.factor), prefix.symbol)
}

/// A share as a percentage, "37.74 %".
pub fn percent(share: f64) -> String {
    format!("{} %", four_digits(100.0 * share))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantities_have_four_digits_and_a_prefix() {
        let table = [
            (3.6948e-5, "m", "36.95 µm"),
            (1105.7, "N", "1.106 kN"),
            (3.45e8, "Pa", "345 MPa"),
            (0.0, "N", "0 N"),
            (999.96, "N", "1 kN"),
            (0.012, "m/s", "12 mm/s"),
            (-2.5, "m/s", "-2.5 m/s"),
            (1.234e-300, "m", "1.234 × 10⁻³⁰⁰ m"),
            (f64::INFINITY, "Pa", "inf Pa"),
        ];
        for (value, unit, text) in table {
            assert_eq!(quantity(value, unit), text);
        }
    }
}
