//! Integrals: the double exponential rule where an end may be singular, and the nodes of Gauss's rule for smooth functions.
//!
//! The double exponential rule is that of Takahasi and Mori (1974), Publ. RIMS 9, 721-741: with
//! x = a + (b − a)/(1 + exp(−π sinh t)) the trapezoidal rule in t converges exponentially, also where the integrand has an
//! integrable singularity at an end.

use std::sync::LazyLock;

use crate::math::functions::{cos, cosh, exp, sinh};

/// How far t runs: the weights are below 1e-30 there.
const FARTHEST: f64 = 4.0;
/// The coarsest step is 1/2, the finest 2^-LEVELS.
const LEVELS: u32 = 9;

/// A node at t. The node at −t is the same with `near` and `far` exchanged.
struct Node {
    /// Share of the interval from the nearer end.
    near: f64,
    /// Share from the farther end.
    far: f64,
    weight: f64,
}

impl Node {
    fn new(t: f64) -> Self {
        use std::f64::consts::PI;
        let e = exp(-PI * sinh(t));
        let (near, far) = (e / (1.0 + e), 1.0 / (1.0 + e));
        Self { near, far, weight: PI * cosh(t) * near * far }
    }
}

/// The nodes with t > 0 that each step adds to those of the coarser ones.
static NODES: LazyLock<Vec<Vec<Node>>> = LazyLock::new(|| {
    let (mut first, mut step) = (0.5, 0.5);
    let level = |_| {
        let ts = std::iter::successors(Some(first), |t| Some(t + step)).take_while(|t| *t <= FARTHEST);
        let nodes = ts.map(Node::new).collect();
        (first, step) = (0.5 * first, first);
        nodes
    };
    (1..=LEVELS).map(level).collect()
});

/// ∫ f over an interval of this `length`. f is given the distances from the lower and the upper end, both with all digits.
/// Halves its step until the relative change is below 1e-13, or about 4000 evaluations.
pub fn integrate(length: f64, mut f: impl FnMut(f64, f64) -> f64) -> f64 {
    if length <= 0.0 {
        return 0.0;
    }
    let mut at = |below: f64, above: f64, weight: f64| {
        let value = if below.min(above) * length > 0.0 { f(below * length, above * length) * weight } else { 0.0 };
        if value.is_finite() { value } else { 0.0 }
    };
    let mut total = {
        let Node { near, far, weight } = Node::new(0.0);
        at(near, far, weight)
    };
    let (mut step, mut integral) = (1.0, 0.0);
    for (level, nodes) in (1..).zip(NODES.iter()) {
        let sum = nodes
            .iter()
            .fold(0.0, |sum, Node { near, far, weight }| sum + (at(*far, *near, *weight) + at(*near, *far, *weight)));
        total += sum;
        step *= 0.5;
        let finer = total * step;
        let change = (finer - integral).abs();
        integral = finer;
        if level > 3 && change <= 1e-13 * integral.abs() {
            break;
        }
    }
    integral * length
}

/// ∫ f from `from` to `to` for an f of the place alone.
pub fn over(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    integrate(to - from, |below, above| f(if below < above { from + below } else { to - above }))
}

pub(crate) const PANEL: usize = 20;

/// Gauss's rule on (0, 1): nodes and weights.
static RULE: LazyLock<[[f64; PANEL]; 2]> = LazyLock::new(|| {
    #[allow(clippy::cast_precision_loss)] // a few nodes
    let (n, place) = (PANEL as f64, |i: usize| (i as f64 + 0.75) / (PANEL as f64 + 0.5));
    let nodes: [f64; PANEL] = std::array::from_fn(|i| {
        let newton = |t: f64, _| {
            let [before, last] = legendre(t);
            t - last * (t * t - 1.0) / (n * (t * last - before))
        };
        (0..20).fold(-cos(std::f64::consts::PI * place(i)), newton)
    });
    let weight = |t: f64| {
        let [before, last] = legendre(t);
        let slope = n * (t * last - before) / (t * t - 1.0);
        1.0 / ((1.0 - t * t) * slope * slope)
    };
    [nodes.map(|t| 0.5 * (1.0 + t)), nodes.map(weight)]
});

/// The last two of Legendre's polynomials at t, of the degrees PANEL − 1 and PANEL.
fn legendre(t: f64) -> [f64; 2] {
    let (mut pair, mut k) = ([1.0, t], 1.0);
    for _ in 1..PANEL {
        pair = [pair[1], ((2.0 * k + 1.0) * t * pair[1] - k * pair[0]) / (k + 1.0)];
        k += 1.0;
    }
    pair
}

/// Nodes and weights of Gauss's rule on (0, 1).
pub(crate) fn gauss() -> (&'static [f64; PANEL], &'static [f64; PANEL]) {
    (&RULE[0], &RULE[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::functions::{ln, pow};

    #[test]
    fn singular_ends_are_integrated_to_rounding() {
        // ∫ 1/√(x (1 − x)) = π; ∫ x^1.5 = 0.4; ∫ ln x = −1; ∫ 1/√(a² + x) with a = 1e-6: 2 (√(1 + a²) − a)
        approx::assert_relative_eq!(
            integrate(1.0, |x, y| 1.0 / (x * y).sqrt()),
            std::f64::consts::PI,
            max_relative = 1e-14
        );
        approx::assert_relative_eq!(integrate(1.0, |x, _| x * x.sqrt()), 0.4, max_relative = 1e-14);
        approx::assert_relative_eq!(integrate(1.0, |x, _| ln(x)), -1.0, max_relative = 1e-14);
        let near = 2.0 * ((1.0 + 1e-12_f64).sqrt() - 1e-6);
        approx::assert_relative_eq!(integrate(1.0, |x, _| 1.0 / (1e-12 + x).sqrt()), near, max_relative = 1e-13);
        approx::assert_relative_eq!(integrate(3.0, |x, _| x * x), 9.0, max_relative = 1e-14);
        // a root just beyond an end, and a layer 10⁻⁶ wide: 1 − w ln(1 + 1/w)
        let root = (pow(1.0001_f64, 1.5) - 1e-6) / 1.5;
        approx::assert_relative_eq!(over(0.0, 1.0, |x| (1.0001 - x).sqrt()), root, max_relative = 1e-13);
        let layer = 1.0 - 1e-6 * ln(1_000_001_f64);
        approx::assert_relative_eq!(over(0.0, 1.0, |x| x / (x + 1e-6)), layer, max_relative = 1e-13);
    }
}
