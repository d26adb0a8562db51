//! A smooth force on one interval as a polynomial. Its work, the distance for a given work, and travel times follow in a few products.
//!
//! ```text
//! f = P(t),   w = d Q(t),   t = t_0 + s d        d: distance from the start of the interval, s = dt/dx
//! ```
//!
//! P interpolates the force at Chebyshev nodes of an interval that is a little longer at both ends. Q is the integral of P over d,
//! divided by d, so the work has all digits at any small d. If the distance from the nearest singular point of the force doubles
//! over the interval, the relative error of P is at most 5⁻¹⁸, which is below rounding.

use std::f64::consts::PI;
use std::sync::LazyLock;

use crate::numerics::functions::cos;
use crate::numerics::quadrature::{GAUSS_POINTS, gauss_legendre};

/// Terms of a polynomial, an even number.
const N_COEFFICIENTS: usize = 18;

/// Coefficients of the powers of t.
type Terms = [f64; N_COEFFICIENTS];

/// How far a polynomial is valid beyond both ends, relative to the distance of that end from the singular point. Derivatives have more
/// digits inside of the interval than at its ends, and a motion with its turning point near the end is followed a little beyond.
const EXTRAPOLATION_MARGIN: f64 = 0.03;

/// The quadrature of the time loses digits if the turning point lies beyond the end by less than this fraction of the distance. The
/// fraction is less than twice [`EXTRAPOLATION_MARGIN`], because the distance is at most half of the distance from the singular point.
pub(super) const NEAR_END_SHARE: f64 = 0.06;

struct FitTables {
    nodes: Terms,
    /// Row k: the weights of the values at the nodes in the coefficient of T_k.
    weights: [Terms; N_COEFFICIENTS],
    /// Row k: the powers of t in T_k = 2 t T_(k−1) − T_(k−2).
    powers: [Terms; N_COEFFICIENTS],
}

#[allow(clippy::cast_precision_loss)] // a few terms
static FIT: LazyLock<FitTables> = LazyLock::new(|| {
    // cos(π k (2 j + 1)/(2 N)), whose angle is folded into the first quarter as a whole number: that has no rounding
    let cosine = |k: usize, j: usize| {
        let turned = k * (2 * j + 1) % (4 * N_COEFFICIENTS);
        let half = turned.min(4 * N_COEFFICIENTS - turned);
        let quarter = half.min(2 * N_COEFFICIENTS - half);
        let cosine = cos(PI * quarter as f64 / (2 * N_COEFFICIENTS) as f64);
        if half == quarter { cosine } else { -cosine }
    };
    let weight = |k: usize, j: usize| if k == 0 { 1.0 } else { 2.0 * cosine(k, j) } / N_COEFFICIENTS as f64;
    let mut powers = [[0.0; N_COEFFICIENTS]; N_COEFFICIENTS];
    (powers[0][0], powers[1][1]) = (1.0, 1.0);
    for k in 2..N_COEFFICIENTS {
        for j in 0..=k {
            powers[k][j] = if j == 0 { 0.0 } else { 2.0 * powers[k - 1][j - 1] } - powers[k - 2][j];
        }
    }
    let row = |k: usize| std::array::from_fn(|j| weight(k, j));
    FitTables { nodes: std::array::from_fn(|j| cosine(1, j)), weights: std::array::from_fn(row), powers }
});

/// The polynomial and its derivative at t.
#[inline(always)]
fn value_and_slope(terms: &Terms, t: f64) -> (f64, f64) {
    terms.iter().rev().fold((0.0, 0.0), |(value, slope), term| (value * t + term, slope * t + value))
}

/// The polynomial at t; even and odd terms apart, so that neither waits for the other.
#[inline(always)]
fn value(terms: &Terms, t: f64) -> f64 {
    let square = t * t;
    let add = |[even, odd]: [f64; 2], pair: &[f64]| [even * square + pair[0], odd * square + pair[1]];
    let [even, odd] = terms.chunks_exact(2).rev().fold([0.0; 2], add);
    even + t * odd
}

/// ∫ P from t_1 to t over t − t_1, as a polynomial of t.
#[inline]
#[allow(clippy::cast_precision_loss)] // a few terms
fn work_quotient(force: &Terms, t_1: f64) -> Terms {
    let (mut quotient, mut sum) = ([0.0; N_COEFFICIENTS], 0.0);
    for k in (0..N_COEFFICIENTS).rev() {
        sum = sum * t_1 + force[k] / (k + 1) as f64;
        quotient[k] = sum;
    }
    quotient
}

/// An increasing force on one interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedPolynomial {
    /// t_0.
    first: f64,
    /// s.
    scale: f64,
    /// P.
    force: Terms,
    /// Q.
    work: Terms,
    length: f64,
}

impl FittedPolynomial {
    /// Fits a function of x from `from` to `to`. Its nearest singular point is `pole` < `from`. The function is evaluated up to 3 % of
    /// the distance from `pole` outside of both ends.
    pub fn fit(f: impl Fn(f64) -> f64, from: f64, to: f64, pole: f64) -> Self {
        let FitTables { nodes, weights, powers } = &*FIT;
        let (low, high) = (from - EXTRAPOLATION_MARGIN * (from - pole), to + EXTRAPOLATION_MARGIN * (to - pole));
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let values = nodes.map(|t| f(middle + half * t));
        let mut force = [0.0; N_COEFFICIENTS];
        for (weights, powers) in weights.iter().zip(powers) {
            let coefficient: f64 = weights.iter().zip(&values).map(|(weight, value)| weight * value).sum();
            for (term, power) in force.iter_mut().zip(powers) {
                *term += coefficient * power;
            }
        }
        let first = (from - middle) / half;
        Self { first, scale: 1.0 / half, force, work: work_quotient(&force, first), length: to - from }
    }

    /// Returns this force on an interval whose start is moved by the distance `by`.
    pub fn with_shift(&self, by: f64) -> Self {
        let first = self.first + by * self.scale;
        Self { first, length: self.length - by, work: work_quotient(&self.force, first), ..*self }
    }

    #[inline]
    pub fn force(&self, d: f64) -> f64 {
        let t = self.first + d * self.scale;
        if t.abs() > 1.0 { self.extrapolate(t)[0] } else { value(&self.force, t) }
    }

    /// f and its first two derivatives.
    #[inline]
    pub fn derivatives(&self, d: f64) -> [f64; 3] {
        let t = self.first + d * self.scale;
        if t.abs() > 1.0 {
            return self.extrapolate(t);
        }
        let add = |[f, slope, half]: [f64; 3], term: &f64| [f * t + term, slope * t + f, half * t + slope];
        let [f, slope, half] = self.force.iter().rev().fold([0.0; 3], add);
        [f, slope * self.scale, 2.0 * half * self.scale * self.scale]
    }

    /// Beyond its interval, which trial steps of an integrator may reach, the polynomial continues along its tangent.
    #[cold]
    fn extrapolate(&self, t: f64) -> [f64; 3] {
        let end = t.clamp(-1.0, 1.0);
        let (f, slope) = value_and_slope(&self.force, end);
        [f + slope * (t - end), slope * self.scale, 0.0]
    }

    /// Work from the start to d.
    #[inline]
    pub fn work(&self, d: f64) -> f64 {
        d * value(&self.work, self.first + d * self.scale)
    }

    /// The turning distance of a motion that begins at the start with the kinetic energy `rest`, under a constant force `pull`; up to a
    /// little beyond the end.
    pub fn turning_distance(&self, rest: f64, pull: f64) -> f64 {
        // the first guess is for a linear force that does the same work up to the end
        let [first, mean] = [0.0, self.length].map(|d| value(&self.work, self.first + d * self.scale));
        let slope = 2.0 * (mean - first) / self.length;
        let net = first - pull;
        let root = (net * net + 2.0 * slope * rest).max(0.0).sqrt();
        let guess = if net > 0.0 { 2.0 * rest / (net + root) } else { (root - net) / slope };
        self.distance_for_work(&self.work, self.first, [rest, pull], guess)
    }

    /// The way d from t_1 on that takes a work, d Q_1(t_1 + s d) − pull d = work, by Newton's method: it falls to the root from
    /// the second guess on, as the force rises.
    #[inline(always)]
    fn distance_for_work(&self, quotient: &Terms, t_1: f64, [work, pull]: [f64; 2], guess: f64) -> f64 {
        let mut d = guess;
        for _ in 0..50 {
            let by = d * self.scale;
            let (mean, slope) = value_and_slope(quotient, t_1 + by);
            let step = (d * (mean - pull) - work) / (mean + by * slope - pull);
            d -= step;
            // the next step would be below the square of this one
            if step.abs() <= 1e-8 * d || step.is_nan() {
                break;
            }
        }
        d
    }

    /// The distance at which the force is `force`.
    pub fn distance_at_force(&self, force: f64) -> f64 {
        let first = self.force(0.0);
        let mut d = self.length * ((force - first) / (self.force(self.length) - first)).clamp(0.0, 1.0);
        for _ in 0..50 {
            let [f, slope, _] = self.derivatives(d);
            let step = (f - force) / slope;
            d = (d - step).clamp(0.0, self.length * (1.0 + EXTRAPOLATION_MARGIN));
            if step.abs() <= 1e-8 * d || step.is_nan() {
                break;
            }
        }
        d
    }

    /// The time of a motion d'' = −c f over this distance up to `to`, where the speed is `exit` (0 at a turning point).
    ///
    /// With d = to − ζ (ζ + 2 z), z² = exit²/(2 c f(to)), the root in u² = exit² + 2 c (w(to) − w) loses its singularity.
    pub fn travel_time(&self, distance: f64, to: f64, exit: f64, c: f64) -> f64 {
        if distance == 0.0 {
            return 0.0;
        }
        let t_1 = self.first + to * self.scale;
        let quotient = work_quotient(&self.force, t_1);
        let more = 0.5 * exit * exit / c;
        // z²: how far behind `to` it would turn against the force there
        let behind = more / value(&quotient, t_1);
        if behind > 0.0 && behind < NEAR_END_SHARE * distance {
            // the time to the turn, less the rest, which is short
            let rest = self.distance_for_work(&quotient, t_1, [more, 0.0], behind);
            return self.travel_time(distance + rest, to + rest, 0.0, c) - self.travel_time(rest, to + rest, 0.0, c);
        }
        let z = behind.sqrt();
        let far = distance / ((distance + behind).sqrt() + z);
        let (nodes, weights) = gauss_legendre();
        let gaps = nodes.map(|node| far * node * (far * node + 2.0 * z));
        let ts = gaps.map(|gap| t_1 - gap * self.scale);
        let mut means = [0.0; GAUSS_POINTS];
        for term in quotient.iter().rev() {
            for (mean, t) in means.iter_mut().zip(&ts) {
                *mean = *mean * t + term;
            }
        }
        let at = |i: usize| weights[i] * (far * nodes[i] + z) / (more + gaps[i] * means[i]).sqrt();
        far * (0..GAUSS_POINTS).map(at).sum::<f64>() * (2.0 / c).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::functions::pow;
    use crate::numerics::power::{power_time, quarter_period_factor};
    use approx::assert_relative_eq;

    /// x^1.5 from 2 to 4, against its closed forms.
    #[test]
    fn hertz_on_octave_has_exact_force_work_times() {
        let (start, hertz) = (2.0, |x: f64| x * x.sqrt());
        let poly = FittedPolynomial::fit(hertz, start, 4.0, 0.0);
        let work = |x: f64| 0.4 * pow(x, 2.5);
        for i in 0..=40 {
            let d = 0.05 * f64::from(i);
            let x = start + d;
            let [f, slope, curvature] = poly.derivatives(d);
            assert_relative_eq!(poly.force(d), hertz(x), max_relative = 3e-15);
            assert_relative_eq!(f, hertz(x), max_relative = 3e-15);
            assert_relative_eq!(slope, 1.5 * x.sqrt(), max_relative = 1e-13);
            assert_relative_eq!(curvature, 0.75 / x.sqrt(), max_relative = 1e-10);
            assert_relative_eq!(poly.work(d), work(x) - work(start), epsilon = 4e-15);
            assert_relative_eq!(poly.turning_distance(poly.work(d), 0.0), d, max_relative = 1e-14);
            assert_relative_eq!(poly.distance_at_force(hertz(x)), d, max_relative = 1e-13, epsilon = 1e-15);
            let pulled = poly.turning_distance(poly.work(1.0) - d, d);
            assert_relative_eq!(pulled, 1.0, max_relative = 1e-14);
        }
        assert_relative_eq!(poly.with_shift(0.5).work(1.0), work(3.5) - work(2.5), max_relative = 2e-15);
        // a motion that turns at 3, from 2.2 on, and to places before the turn
        let (turn, from) = (3.0, 2.2);
        let speed = |x: f64| (2.0 * (work(turn) - work(x))).sqrt();
        let whole = turn / speed(0.0) * quarter_period_factor(1.5);
        let until = |x: f64| if x == turn { whole } else { power_time(1.5, x, speed(0.0), speed(x)) };
        for to in [2.3, 2.7, 2.95, 2.999_999, turn] {
            let got = poly.travel_time(to - from, to - start, speed(to), 1.0);
            assert_relative_eq!(got, until(to) - until(from), max_relative = 1e-13);
        }
    }
}
