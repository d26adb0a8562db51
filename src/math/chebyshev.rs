//! Smooth functions as polynomials through Chebyshev's nodes, so that a value costs a few products.
//!
//! On an interval whose ends are in the ratio 2, as distances from the nearest singular point, the polynomial is off by about
//! 5⁻¹⁸ and less of the function, which is rounding.

use std::f64::consts::PI;
use std::sync::LazyLock;

use crate::math::functions::cos;

pub(crate) const TERMS: usize = 18;

/// Coefficients of the powers of t, −1 ≤ t ≤ 1.
pub(crate) type Polynomial = [f64; TERMS];

/// cos(π k (j + 1/2)/TERMS); row 1 has the nodes.
#[allow(clippy::cast_precision_loss)] // a few terms
static COSINES: LazyLock<[[f64; TERMS]; TERMS]> = LazyLock::new(|| {
    let angle = |k: usize, j: usize| PI * k as f64 * (j as f64 + 0.5) / TERMS as f64;
    std::array::from_fn(|k| std::array::from_fn(|j| cos(angle(k, j))))
});

/// Row k has the coefficients of the powers of t in T_k, by T_(k+1) = 2 t T_k − T_(k−1).
static POWERS: LazyLock<[Polynomial; TERMS]> = LazyLock::new(|| {
    let mut rows = [[0.0; TERMS]; TERMS];
    (rows[0][0], rows[1][1]) = (1.0, 1.0);
    for k in 2..TERMS {
        for j in 0..=k {
            let shifted = if j == 0 { 0.0 } else { 2.0 * rows[k - 1][j - 1] };
            rows[k][j] = shifted - rows[k - 2][j];
        }
    }
    rows
});

/// The polynomial through the values of a function of t at the nodes.
#[allow(clippy::cast_precision_loss)] // a few terms
pub(crate) fn polynomial(function: impl Fn(f64) -> f64) -> Polynomial {
    let values = COSINES[1].map(function);
    let mut of_powers = [0.0; TERMS];
    for (k, (cosines, powers)) in COSINES.iter().zip(POWERS.iter()).enumerate() {
        let sum: f64 = cosines.iter().zip(&values).map(|(cosine, value)| cosine * value).sum();
        let coefficient = if k == 0 { sum } else { 2.0 * sum } / TERMS as f64;
        for (total, power) in of_powers.iter_mut().zip(powers) {
            *total += coefficient * power;
        }
    }
    of_powers
}

#[inline(always)]
pub(crate) fn value(polynomial: &Polynomial, t: f64) -> f64 {
    polynomial.iter().rev().fold(0.0, |sum, coefficient| sum * t + coefficient)
}
