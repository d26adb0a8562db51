//! Searches for zeros of functions of one number.
//!
//! Every search ends after a fixed number of guesses, whatever the function returns, NaN too.

/// Most guesses of a search.
const MAX_EVALUATIONS: u32 = 200;

/// The zero of a function that falls from `low` to `high`, by Newton's method from `first` on until two guesses are near each
/// other by `is_converged`. `at` gives the value and its derivative. A guess outside of the bounds that the values so far leave is
/// replaced by their middle, and a value that is zero or NaN counts as beyond the zero.
///
/// Without a zero between the bounds the result is one of them.
#[inline]
pub(crate) fn newton_bisection(
    (mut low, mut high): (f64, f64),
    first: f64,
    is_near: impl Fn(f64, f64) -> bool,
    mut at: impl FnMut(f64) -> (f64, f64),
) -> f64 {
    let mut x = first;
    for _ in 0..MAX_EVALUATIONS {
        let (value, slope) = at(x);
        *(if value > 0.0 { &mut low } else { &mut high }) = x;
        let newton = x - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        let is_found = is_near(x, next);
        x = next;
        if is_found {
            break;
        }
    }
    x
}

/// Bisects 60 times for the point at which `is_before` changes from true to false. Returns the last point before the change and the
/// first point after it.
pub fn bisect(mut low: f64, mut high: f64, mut is_before: impl FnMut(f64) -> bool) -> (f64, f64) {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if is_before(middle) { &mut low } else { &mut high }) = middle;
    }
    (low, high)
}

/// The zero of a function that falls from above 0 at `low` to 0 or below at `high`: regula falsi (Illinois), with a halving
/// after every third guess. A guess on an end moves away from it by the resolution: if the zero is there, the search ends.
pub(crate) fn illinois((mut low, mut high): (f64, f64), mut at: impl FnMut(f64) -> f64) -> f64 {
    let (mut above, mut below) = (at(low), at(high));
    let mut low_moved = None;
    for guess in 1..MAX_EVALUATIONS {
        // below it, rounding decides on the sign of the function
        let resolution = 64.0 * f64::EPSILON * high.abs();
        let mut x = low + (high - low) * (above / (above - below));
        // a value of 0 at an end gives no direction for the next guess
        if guess % 4 == 0 || !(above > 0.0 && below < 0.0) {
            x = 0.5 * (low + high);
        }
        x = x.max(low + resolution).min(high - resolution);
        if high - low <= resolution || !(x > low && x < high) {
            break;
        }
        let value = at(x);
        if value == 0.0 {
            return x;
        }
        // an end that stays twice counts half
        let weight = if low_moved == Some(value > 0.0) { 0.5 } else { 1.0 };
        low_moved = Some(value > 0.0);
        if value > 0.0 {
            (low, above, below) = (x, value, weight * below);
        } else {
            (high, below, above) = (x, value, weight * above);
        }
    }
    high
}

/// The zero of a convex function below `start`, at which the function is positive and increases. Newton's method then decreases
/// monotonically to the zero, and ends when rounding stops the decrease. `step` is the value over the derivative.
#[inline]
pub(crate) fn newton_convex(start: f64, step: impl Fn(f64) -> f64) -> f64 {
    let mut x = start;
    for _ in 0..100 {
        let next = x - step(x);
        if next >= x || !next.is_finite() {
            break;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::functions::{atan, exp};

    /// [`newton_bisection`] to the last digit, and its number of evaluations.
    fn search(bounds: (f64, f64), first: f64, f: impl Fn(f64) -> (f64, f64)) -> (f64, u32) {
        let mut asked = 0;
        let is_near = |x: f64, next: f64| (next - x).abs() <= f64::EPSILON * next.abs();
        let root = newton_bisection(bounds, first, is_near, |x| {
            asked += 1;
            f(x)
        });
        (root, asked)
    }

    #[test]
    fn newton_bisection_is_fast_and_safe() {
        // 2 − x², e^−x − 1/2
        let (root, asked) = search((0.0, 2.0), 1.0, |x| (2.0 - x * x, -2.0 * x));
        assert!((root - 2f64.sqrt()).abs() <= 2e-16 * root && asked < 8, "{root} {asked}");
        let (root, asked) = search((0.0, 50.0), 49.0, |x| (exp(-x) - 0.5, -exp(-x)));
        // from 49 the first guesses are halves, and at the zero the value is one rounding off
        assert!((root - std::f64::consts::LN_2).abs() <= 2e-16 && asked < 60, "{root} {asked}");
        // Newton's method alone runs away from arctan's zero for |x| > 1.39
        let (root, asked) = search((-1e3, 1e3), 900.0, |x| (-atan(x - 0.25), -1.0 / (1.0 + (x - 0.25) * (x - 0.25))));
        assert!((root - 0.25).abs() <= 2e-16 && asked < 80, "{root} {asked}");
    }

    #[test]
    fn hard_functions_end_at_their_zero() {
        // at either end of the bracket: an end is no guess, so it is come near to by halves, 2^-200 from there at last
        assert!(search((0.0, 1.0), 0.5, |x| (-x, -1.0)).0.abs() < 1e-59);
        assert!((search((0.0, 1.0), 0.5, |x| (1.0 - x, -1.0)).0 - 1.0).abs() <= f64::EPSILON);
        // flat at the zero: (1 − x)³; flat all over but for a jump; a wrong slope; no slope
        let (root, _) = search((0.0, 3.0), 0.0, |x| ((1.0 - x) * (1.0 - x) * (1.0 - x), -3.0 * (1.0 - x) * (1.0 - x)));
        assert!((root - 1.0).abs() < 1e-5, "{root}");
        for slope in [0.0, f64::NAN, 1.0, -1e300] {
            let (root, asked) = search((0.0, 1.0), 0.9, |x| (if x < 0.3 { 1.0 } else { -1.0 }, slope));
            assert!((root - 0.3).abs() <= 2.0 * f64::EPSILON || slope == -1e300, "{slope} {root}");
            assert!(asked <= MAX_EVALUATIONS);
        }
        // no number beyond x = 1/2, as a formula has that ends there
        let (root, _) = search((0.0, 1.0), 0.75, |x| (if x <= 0.5 { 0.25 - x } else { f64::NAN }, -1.0));
        assert!((root - 0.25).abs() <= f64::EPSILON);
    }

    #[test]
    fn bound_is_returned_without_zero() {
        assert!((search((0.0, 1.0), 0.5, |_| (1.0, 0.0)).0 - 1.0).abs() <= f64::EPSILON);
        assert!(search((0.0, 1.0), 0.5, |_| (-1.0, 0.0)).0 < 1e-50);
        let (_, asked) = search((0.0, 1.0), 0.5, |_| (f64::NAN, f64::NAN));
        assert!(asked <= MAX_EVALUATIONS);
    }

    #[test]
    fn bisection_brackets_a_jump() {
        let (low, high) = bisect(0.0, 1.0, |x| x * x < 0.5);
        assert!(low * low < 0.5 && high * high >= 0.5 && high - low <= f64::EPSILON);
    }

    #[test]
    fn newton_from_above() {
        // x³ = 5 from above; x = 0 is a double zero of x², to which the fall is slow; no number ends it at once
        let cube = newton_convex(9.0, |x| (x * x * x - 5.0) / (3.0 * x * x));
        assert!((cube * cube * cube - 5.0).abs() < 4e-15, "{cube}");
        assert!(newton_convex(1.0, |x| 0.5 * x) < 1e-29);
        assert_eq!(newton_convex(2.0, |_| f64::NAN), 2.0);
    }
}
