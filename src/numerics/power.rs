//! The power law d^n: its value, and the time that a motion d'' = −k d^n takes.

use crate::numerics::functions::{atan, gamma, pow};
use crate::numerics::root::newton_convex;

/// d^n; n = 3/2 without a call to `powf`. Continued smoothly (as an odd function) to d < 0.
#[inline]
pub fn power(distance: f64, exponent: f64) -> f64 {
    let size = distance.abs();
    #[allow(clippy::float_cmp)] // 1.5 is exact, and the default
    if exponent == 1.5 { distance * size.sqrt() } else { distance.signum() * pow(size, exponent) }
}

/// The larger of two numbers. The result is NaN if one of them is NaN, which `f64::max` ignores.
#[inline(always)]
pub fn nan_max(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// 1/(n + 1), the share of force times distance that is the work; n = 3/2 without a division.
#[inline(always)]
pub(crate) fn work_factor(exponent: f64) -> f64 {
    #[allow(clippy::float_cmp)] // as above
    if exponent == 1.5 { 0.4 } else { 1.0 / (exponent + 1.0) }
}

/// Time on a power law from its zero, at speed `entry`, to `distance`, where the speed is `exit`.
///
/// With z = 1 − (exit/entry)² = (d/d_max)^(n+1) and a = 1/(n+1) the time is
/// (d/entry) ₂F₁(½, a; 1 + a; z), or for z near 1 the whole quarter period less the rest.
#[inline]
pub(crate) fn power_time(exponent: f64, distance: f64, entry: f64, exit: f64) -> f64 {
    if distance == 0.0 {
        0.0
    } else if exit == 0.0 {
        quarter_period_factor(exponent) * distance / entry
    } else {
        power_time_to_speed(exponent, distance, entry, exit)
    }
}

/// [`power_time`] to a place before the turning point.
fn power_time_to_speed(exponent: f64, distance: f64, entry: f64, exit: f64) -> f64 {
    let a = work_factor(exponent);
    let slowness = exit / entry;
    let remaining = slowness * slowness;
    let spent = (1.0 - slowness) * (1.0 + slowness);
    if spent <= 0.5 {
        let series = if exponent == 1.5 { sum(spent, &SERIES_FROM_ZERO) } else { series(0.5, a, spent) };
        return distance / entry * series;
    }
    // distance over the turning point, z^a
    let turning = distance * pow(spent, -a);
    let rest = if exponent == 1.5 { sum(remaining, &SERIES_FROM_TURNING) } else { series(a, 0.5, remaining) };
    turning / entry * (quarter_period_factor(exponent) - 2.0 * a * slowness * rest)
}

/// Terms of the series for an argument of at most ½: 2⁻⁵⁰ of the last coefficient, which is below 0.02.
const SERIES_TERMS: usize = 50;
/// For n = 3/2, the default: ₂F₁(½, a; 1 + a; z) = Σ (½)_k/k! · a/(a + k) · z^k.
const SERIES_FROM_ZERO: [f64; SERIES_TERMS] = coefficients(0.5, 0.4);
/// The time from z to the turning point over 2a√z: Σ (1 − a)_k/k! · z^k/(1 + 2k).
const SERIES_FROM_TURNING: [f64; SERIES_TERMS] = coefficients(0.4, 0.5);

/// (1 − a)_k/k! · b/(b + k).
const fn coefficients(a: f64, b: f64) -> [f64; SERIES_TERMS] {
    let (mut coefficients, mut term, mut i) = ([1.0; SERIES_TERMS], 1.0, 1);
    let mut k = 1.0;
    while i < SERIES_TERMS {
        term *= (k - a) / k;
        coefficients[i] = term * b / (b + k);
        (i, k) = (i + 1, k + 1.0);
    }
    coefficients
}

/// Σ (1 − a)_k/k! · b/(b + k) · z^k for 0 ≤ z ≤ ½, until nothing is added.
fn series(a: f64, b: f64, z: f64) -> f64 {
    let (mut total, mut term, mut k) = (1.0, 1.0, 1.0);
    for _ in 1..SERIES_TERMS {
        term *= (k - a) / k * z;
        total += term * b / (b + k);
        if term < 1e-17 {
            break;
        }
        k += 1.0;
    }
    total
}

/// Σ c_k z^k for 0 ≤ z ≤ ½ with falling c_k ≤ 1, until nothing is added.
fn sum(z: f64, coefficients: &[f64; SERIES_TERMS]) -> f64 {
    let (mut total, mut power) = (0.0, 1.0);
    for coefficient in coefficients {
        total += coefficient * power;
        power *= z;
        if power < 1e-17 {
            break;
        }
    }
    total
}

/// arctan t; by its series for small t, as on the pieces that are crossed fast.
#[inline]
pub(crate) fn arctangent(t: f64) -> f64 {
    // the first term left out is t^15/15 < 2^-60/15 · t
    const SMALL: f64 = 0.0625;
    if t.abs() > SMALL {
        return atan(t);
    }
    let s = t * t;
    let series = 1.0 / 3.0 - s * (0.2 - s * (1.0 / 7.0 - s * (1.0 / 9.0 - s * (1.0 / 11.0 - s * (1.0 / 13.0)))));
    t - t * s * series
}

/// ∫₀¹ dy/√(1 − y^(n+1)) = (1/(n+1)) B(1/(n+1), ½): time from the zero of a power law to the turning point, times
/// speed over distance. 1.4716375921623523 for n = 3/2: half a Hertz impact.
#[inline]
pub fn quarter_period_factor(exponent: f64) -> f64 {
    #[allow(clippy::float_cmp)] // the default, exactly
    if exponent == 1.5 { 1.471_637_592_162_352_3 } else { quarter_period_factor_by_series(exponent) }
}

fn quarter_period_factor_by_series(exponent: f64) -> f64 {
    /// The coefficients for a = 1/(n + 1) from 1/3 to 1/2, in powers of 12 (a − 5/12). The error of the series is
    /// less than rounding.
    const USUAL: [f64; 12] = [
        1.488_564_008_466_679_4,
        0.084_214_351_498_150_6,
        -0.002_069_956_879_291_922,
        9.249_133_510_805_557e-5,
        -4.820_258_239_622_401e-6,
        2.670_186_539_219_82e-7,
        -1.521_754_179_641_838_5e-8,
        8.797_997_780_720_307e-10,
        -5.125_301_429_678_46e-11,
        2.998_397_825_046_097e-12,
        -1.776_621_660_438_098e-13,
        1.043_192_502_678_304_1e-14,
    ];
    let a = work_factor(exponent);
    let t = 12.0 * a - 5.0;
    if t.abs() <= 1.0 {
        return USUAL.iter().rev().fold(0.0, |sum, coefficient| sum * t + coefficient);
    }
    // √π Γ(1 + a)/Γ(½ + a)
    1.772_453_850_905_516 * gamma(1.0 + a) / gamma(0.5 + a)
}

/// The positive root of k d^(n+1)/(n+1) = rest + w d.
///
/// With a the root without weight, b the one without `rest`, and d = (a + b) z it is z^(n+1) = â^(n+1) + b̂^n z (hats:
/// over a + b), convex and not negative at z = 1, so that Newton's method from there falls towards the root.
#[inline]
pub(crate) fn power_turning_distance(stiffness: f64, exponent: f64, rest: f64, weight: f64) -> f64 {
    let of_rest = pow((exponent + 1.0) / stiffness * rest, work_factor(exponent));
    if weight == 0.0 { of_rest } else { power_turning_distance_with_weight(stiffness, exponent, of_rest, weight) }
}

#[cold]
fn power_turning_distance_with_weight(stiffness: f64, exponent: f64, of_rest: f64, weight: f64) -> f64 {
    let p = exponent + 1.0;
    let of_weight = pow(p * weight / stiffness, 1.0 / exponent);
    let both = of_rest + of_weight;
    let (constant, slope) = (pow(of_rest / both, p), pow(of_weight / both, exponent));
    both * newton_convex(1.0, |z| {
        let higher = pow(z, exponent);
        (z * higher - constant - slope * z) / (p * higher - slope)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_periods_are_those_of_the_gamma_function() {
        for step in 0..=20 {
            let (n, a) = (1.0 + 0.05 * f64::from(step), 1.0 / (2.0 + 0.05 * f64::from(step)));
            let want = std::f64::consts::PI.sqrt() * gamma(1.0 + a) / gamma(0.5 + a);
            approx::assert_relative_eq!(quarter_period_factor(n), want, max_relative = 2e-15);
        }
    }

    #[test]
    fn nan_max_propagates_nan() {
        let largest = |rows: [f64; 3]| rows.into_iter().fold(0.0, nan_max);
        assert_eq!(largest([1.0, 3.0, 2.0]), 3.0);
        for row in 0..3 {
            let mut rows = [1.0, 3.0, 2.0];
            rows[row] = f64::NAN;
            assert!(largest(rows).is_nan(), "{row}");
        }
    }
}
