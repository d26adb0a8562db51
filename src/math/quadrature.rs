//! Integrals over an interval whose ends may be singular: the double exponential rule.
//!
//! Takahasi and Mori (1974), Publ. RIMS 9, 721-741: with x = a + (b − a)/(1 + exp(−π sinh t)) the trapezoidal rule in t
//! converges exponentially, also where the integrand has an integrable singularity at an end.

use std::sync::LazyLock;

use crate::math::functions::{cosh, exp, sinh};

/// How far t runs: the weights are below 1e-30 there.
const FARTHEST: f64 = 4.0;
/// The coarsest step is 1/2, the finest 2^-LEVELS.
const LEVELS: u32 = 9;

/// What belongs to t and, with the ends changed about, to -t.
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

/// ∫ f over an interval of this `length`; f is given the distances from its lower and upper end, neither of which cancels.
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

/// ∫ f from `from` to `to` for an f of the place alone, whose digits near the ends are those of the place.
pub fn over(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    integrate(to - from, |below, above| f(if below < above { from + below } else { to - above }))
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
