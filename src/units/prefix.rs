//! SI prefixes and powers of ten, for the axes of pictures.

/// A power of ten with its SI symbol.
#[derive(Debug, Clone, PartialEq)]
pub struct Prefix {
    /// A value is divided by it.
    pub factor: f64,
    /// "m", "µ", "k"; "10⁻³⁰⁰ " where SI has no common letter.
    pub symbol: String,
}

const SYMBOLS: [&str; 10] = ["f", "p", "n", "µ", "m", "", "k", "M", "G", "T"];
const FIRST_EXPONENT: i32 = -15;

impl Prefix {
    /// The prefix under which `value` is written with one to three digits before the point.
    pub fn for_value(value: f64) -> Self {
        let exponent = if value.is_finite() && value != 0.0 { exponent(value).div_euclid(3) * 3 } else { 0 };
        // 1e-306 is the smallest multiple of three that is not subnormal
        let exponent = exponent.max(-306);
        let symbol = usize::try_from((exponent - FIRST_EXPONENT) / 3)
            .ok()
            .filter(|_| exponent >= FIRST_EXPONENT)
            .and_then(|index| SYMBOLS.get(index))
            .map_or_else(|| format!("{} ", power_of_ten_text(exponent)), ToString::to_string);
        Self { factor: power_of_ten(exponent), symbol }
    }
}

/// The power of ten of a number rounded to four digits.
fn exponent(value: f64) -> i32 {
    format!("{value:.3e}").split_once('e').and_then(|(_, exponent)| exponent.parse().ok()).unwrap_or(0)
}

/// 10^k, correctly rounded (`powi` is not).
pub fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::INFINITY)
}

/// "10⁻³".
pub fn power_of_ten_text(exponent: i32) -> String {
    let superscript = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    };
    format!("10{}", exponent.to_string().chars().map(superscript).collect::<String>())
}
