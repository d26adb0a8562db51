//! Several functions of one variable as polynomials on common intervals, to nearly all digits of a double.
//!
//! On every interval, a polynomial of degree 13 interpolates each function at Chebyshev nodes. An interval whose polynomials miss the
//! functions between the nodes is halved. A kink of a function would be halved down to the last digit, and each half would cost an interval:
//! so the search runs again with the kinks that it found as ends of intervals.

use std::f64::consts::PI;

use super::functions::cos;

/// Terms of a polynomial, an even number.
pub const N_TERMS: usize = 14;
/// Points between the nodes at which a polynomial is compared with its function.
const N_CHECKS: usize = 2 * N_TERMS + 1;
/// An interval that is narrower than this fraction of its place lies at a kink.
const KINK_WIDTH: f64 = 1e-4;
/// More intervals than this are no description of a function.
const MAX_INTERVALS: usize = 4096;
/// Rounds of the search for kinks.
const MAX_ROUNDS: usize = 4;

/// The polynomials of one interval: p(t) = Σ `terms[k]` t^k with t = (x − `middle`)·`inverse_half`.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedInterval<const K: usize> {
    pub start: f64,
    pub end: f64,
    pub middle: f64,
    pub inverse_half: f64,
    pub terms: [[f64; N_TERMS]; K],
}

/// The polynomials between the first and the last of these knots, which rise. `functions` computes the values at x, and the scale of the
/// error of each value. Each polynomial differs from its function by at most `tolerance` scales. `None` if a value is not finite, or if the functions have too many intervals.
pub fn fit_piecewise<const K: usize>(
    functions: &impl Fn(f64) -> ([f64; K], [f64; K]),
    knots: &[f64],
    tolerance: f64,
) -> Option<Vec<FittedInterval<K>>> {
    let mut knots = knots.to_vec();
    let mut best: Option<Vec<FittedInterval<K>>> = None;
    for _ in 0..MAX_ROUNDS {
        let intervals = halve_until_fitted(functions, &knots, tolerance)?;
        let kinks = kinks(&intervals);
        if best.as_ref().is_none_or(|best| intervals.len() < best.len()) {
            best = Some(intervals);
        }
        if kinks.is_empty() {
            break;
        }
        knots.extend(kinks);
        knots.sort_by(f64::total_cmp);
        knots.dedup();
    }
    best
}

/// The narrowest interval of every group of neighbours that are narrow, as the place of a kink.
fn kinks<const K: usize>(intervals: &[FittedInterval<K>]) -> Vec<f64> {
    let width = |interval: &FittedInterval<K>| interval.end - interval.start;
    let is_narrow = |interval: &FittedInterval<K>| width(interval) < KINK_WIDTH * interval.end;
    let groups = intervals.chunk_by(|a, b| is_narrow(a) == is_narrow(b)).filter(|group| is_narrow(&group[0]));
    groups
        .filter_map(|group| group.iter().min_by(|a, b| width(a).total_cmp(&width(b))))
        .map(|interval| interval.start + 0.5 * width(interval))
        .collect()
}

/// The intervals from knot to knot, halved where a polynomial is not good enough.
fn halve_until_fitted<const K: usize>(
    functions: &impl Fn(f64) -> ([f64; K], [f64; K]),
    knots: &[f64],
    tolerance: f64,
) -> Option<Vec<FittedInterval<K>>> {
    let mut fitted = Vec::new();
    let mut open: Vec<[f64; 2]> = knots.windows(2).map(|ends| [ends[0], ends[1]]).rev().collect();
    while let Some([start, end]) = open.pop() {
        let (interval, error) = fit(functions, start, end);
        let middle = interval.middle;
        let is_shortest = end - start <= 8.0 * f64::EPSILON * end || middle <= start || middle >= end;
        if error.is_nan() || fitted.len() > MAX_INTERVALS {
            return None;
        }
        if error <= tolerance || is_shortest {
            fitted.push(interval);
        } else {
            open.extend([[middle, end], [start, middle]]);
        }
    }
    Some(fitted)
}

/// The polynomials of one interval, and their largest error in units of the scales.
#[allow(clippy::cast_precision_loss)] // a few terms
fn fit<const K: usize>(
    functions: &impl Fn(f64) -> ([f64; K], [f64; K]),
    start: f64,
    end: f64,
) -> (FittedInterval<K>, f64) {
    let half = 0.5 * (end - start);
    let middle = start + half;
    let node = |j: usize, n: usize| cos(PI * (2 * j + 1) as f64 / (2 * n) as f64);
    let values: [[f64; K]; N_TERMS] = std::array::from_fn(|j| functions(middle + half * node(j, N_TERMS)).0);
    let mut terms = [[0.0; N_TERMS]; K];
    // T_(n+1) = 2 t T_n − T_(n−1), in powers of t
    let (mut before, mut chebyshev) = ([0.0; N_TERMS], [0.0; N_TERMS]);
    chebyshev[0] = 1.0;
    for n in 0..N_TERMS {
        let factor = if n == 0 { 1.0 } else { 2.0 };
        let weights: [f64; N_TERMS] =
            std::array::from_fn(|j| cos(PI * (n * (2 * j + 1) % (4 * N_TERMS)) as f64 / (2 * N_TERMS) as f64));
        for (k, terms) in terms.iter_mut().enumerate() {
            let sum: f64 = values.iter().zip(&weights).map(|(values, weight)| values[k] * weight).sum();
            let coefficient = factor * sum / N_TERMS as f64;
            for (term, power) in terms.iter_mut().zip(&chebyshev) {
                *term += coefficient * power;
            }
        }
        let next = std::array::from_fn(|i| if i == 0 { 0.0 } else { factor * chebyshev[i - 1] } - before[i]);
        (before, chebyshev) = (chebyshev, next);
    }
    let interval = FittedInterval { start, end, middle, inverse_half: 1.0 / half, terms };
    let mut worst = 0.0;
    for j in 0..N_CHECKS {
        let x = middle + half * node(j, N_CHECKS);
        let (values, scales) = functions(x);
        for k in 0..K {
            let error = (interval.value(k, x) - values[k]).abs() / scales[k];
            worst = if error > worst || error.is_nan() { error } else { worst };
        }
        if f64::is_nan(worst) {
            break;
        }
    }
    (interval, worst)
}

impl<const K: usize> FittedInterval<K> {
    /// The function with this number at x.
    pub fn value(&self, k: usize, x: f64) -> f64 {
        let t = (x - self.middle) * self.inverse_half;
        self.terms[k].iter().rev().fold(0.0, |sum, term| sum * t + term)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A power, and a function with a kink at an irrational place: one interval more than without the kink, not one for each half.
    #[test]
    fn kinks_become_ends_of_intervals() {
        let kink = 3.0_f64.sqrt();
        let functions = |x: f64| {
            let values = [x * x.sqrt(), if x < kink { x } else { kink + 0.5 * (x - kink) }];
            (values, values)
        };
        let intervals = fit_piecewise(&functions, &[1.0, 2.0, 4.0], 1e-14).unwrap();
        assert!(intervals.len() <= 10, "{}", intervals.len());
        for i in 0..1000 {
            let x = 1.0 + 0.003 * f64::from(i);
            let interval = intervals.iter().rfind(|interval| interval.start <= x).unwrap();
            let (values, _) = functions(x);
            for (k, value) in values.iter().enumerate() {
                assert!((interval.value(k, x) / value - 1.0).abs() < 2e-14, "{x}");
            }
        }
        assert!(fit_piecewise(&|x: f64| ([x.sqrt()], [1.0]), &[-1.0, 1.0], 1e-14).is_none());
    }
}
