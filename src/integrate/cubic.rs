//! The cubic through the values and slopes at both ends of a step, on 0 ≤ x ≤ 1.

use std::convert::Infallible;

use crate::math::root::bracketed;

/// The cubic with these values and slopes at both ends.
fn cubic(x: f64, before: f64, slope_before: f64, after: f64, slope_after: f64) -> f64 {
    let y = 1.0 - x;
    y * y * ((1.0 + 2.0 * x) * before + x * slope_before) + x * x * ((3.0 - 2.0 * x) * after - y * slope_after)
}

/// Whether such a cubic falls to zero between ends where it is positive.
pub(super) fn dips(before: f64, slope_before: f64, after: f64, slope_after: f64) -> bool {
    let least = cubic_minimum(before, slope_before, after, slope_after);
    least.is_some_and(|x| cubic(x, before, slope_before, after, slope_after) <= 0.0)
}

/// Where in (0, 1) the cubic with these values and slopes at both ends is least, if it falls at first and rises at last.
pub(super) fn cubic_minimum(before: f64, slope_before: f64, after: f64, slope_after: f64) -> Option<f64> {
    if slope_before >= 0.0 || slope_after <= 0.0 {
        return None;
    }
    // slope s_0 + 2 b x + 3 a x², which has one rising zero between
    let rise = after - before;
    let b = 3.0 * rise - 2.0 * slope_before - slope_after;
    let a = slope_before + slope_after - 2.0 * rise;
    let root = (b * b - 3.0 * a * slope_before).max(0.0).sqrt();
    let x = if b > 0.0 { -slope_before / (b + root) } else { (root - b) / (3.0 * a) };
    (x > 0.0 && x < 1.0).then_some(x)
}

/// Where in (0, 1) the cubic with these values and slopes at both ends is zero; `before` > 0 ≥ `after`.
pub(super) fn cubic_root(before: f64, slope_before: f64, after: f64, slope_after: f64) -> f64 {
    let at = |x: f64| {
        let y = 1.0 - x;
        let value = cubic(x, before, slope_before, after, slope_after);
        let slope =
            6.0 * x * y * (after - before) + y * (1.0 - 3.0 * x) * slope_before + x * (3.0 * x - 2.0) * slope_after;
        Ok((value, slope))
    };
    let first = if before > after { before / (before - after) } else { 1.0 };
    bracketed((0.0, 1.0), first, |x, next| (next - x).abs() <= 1e-12, at)
        .unwrap_or_else(|never: Infallible| match never {})
}
