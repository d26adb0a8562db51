//! Comparisons of a computed number with a limit.

/// The relative rounding error of a number that follows from the numbers of a user in a few steps.
///
/// Users often enter numbers that meet a limit exactly: 69 GPa is a third of 207 GPa. Then rounding puts the computed number on either
/// side of the limit. A comparison that allows this error decides alike for all numbers of the same ratio.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// True if a number is above a limit by more than rounding.
#[inline]
pub fn is_above(value: f64, limit: f64) -> bool {
    value - limit > ROUNDING * limit.abs()
}

/// True if a number is below a limit by more than rounding.
#[inline]
pub fn is_below(value: f64, limit: f64) -> bool {
    limit - value > ROUNDING * limit.abs()
}

#[cfg(test)]
mod tests {
    use super::{is_above, is_below};

    #[test]
    fn rounding_does_not_pass_a_limit() {
        // the quotient is a little below 1.25, and the sum a little above 0.3
        let (ratio, sum) = (1.61316 * 45.0 / (1.61316 * 36.0), 0.1 + 0.2);
        assert!(ratio < 1.25 && !is_below(ratio, 1.25) && sum > 0.3 && !is_above(sum, 0.3));
        assert!(is_below(-0.1 - 1e-14, -0.1) && !is_below(-0.1, -0.1) && is_above(0.3 + 1e-14, 0.3));
    }

    #[test]
    fn infinite_limit_is_not_passed() {
        for value in [1.0, f64::INFINITY, f64::NAN] {
            assert!(!is_above(value, f64::INFINITY) && !is_below(f64::NAN, value), "{value}");
        }
        assert!(is_above(f64::INFINITY, 1.0) && !is_below(f64::INFINITY, 1.25));
    }
}
