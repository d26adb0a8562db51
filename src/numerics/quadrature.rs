//! Integrals: the double exponential rule where an end may be singular, and the nodes of Gauss's rule for smooth functions.
//!
//! The double exponential rule is that of Takahasi and Mori (1974), Publ. RIMS 9, 721-741: with
//! x = a + (b − a)/(1 + exp(−π sinh t)) the trapezoidal rule in t converges exponentially, also where the integrand has an
//! integrable singularity at an end.

use std::sync::LazyLock;

use crate::numerics::functions::{cosh, exp, sinh};

/// How far t runs: the weights are below 1e-30 there.
const MAX_T: f64 = 4.0;
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
        let ts = std::iter::successors(Some(first), |t| Some(t + step)).take_while(|t| *t <= MAX_T);
        let nodes = ts.map(Node::new).collect();
        (first, step) = (0.5 * first, first);
        nodes
    };
    (1..=LEVELS).map(level).collect()
});

/// ∫ f over an interval of this `length`. f is given the distances from the lower and the upper end, both with all digits.
/// Halves its step until the relative change is below 1e-13, or about 4000 evaluations.
pub fn tanh_sinh(length: f64, mut f: impl FnMut(f64, f64) -> f64) -> f64 {
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
pub fn tanh_sinh_between(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    tanh_sinh(to - from, |below, above| f(if below < above { from + below } else { to - above }))
}

pub(crate) const GAUSS_POINTS: usize = 20;

/// Gauss's rule of twenty nodes on (−1, 1): the nodes above 0, which have their mirror images below it, and their weights.
const HALF_RULE: [[f64; 2]; GAUSS_POINTS / 2] = [
    [0.076_526_521_133_497_34, 0.152_753_387_130_725_84],
    [0.227_785_851_141_645_07, 0.149_172_986_472_603_74],
    [0.373_706_088_715_419_55, 0.142_096_109_318_382_04],
    [0.510_867_001_950_827_1, 0.131_688_638_449_176_64],
    [0.636_053_680_726_515, 0.118_194_531_961_518_41],
    [0.746_331_906_460_150_8, 0.101_930_119_817_240_44],
    [0.839_116_971_822_218_8, 0.083_276_741_576_704_75],
    [0.912_234_428_251_326, 0.062_672_048_334_109_07],
    [0.963_971_927_277_913_8, 0.040_601_429_800_386_94],
    [0.993_128_599_185_094_9, 0.017_614_007_139_152_118],
];

/// Nodes and weights of Gauss's rule on (0, 1).
static RULE: [[f64; GAUSS_POINTS]; 2] = {
    let (mut rule, mut i) = ([[0.0; GAUSS_POINTS]; 2], 0);
    while i < GAUSS_POINTS / 2 {
        let [node, weight] = HALF_RULE[i];
        rule[0][GAUSS_POINTS / 2 + i] = 0.5 + 0.5 * node;
        rule[0][GAUSS_POINTS / 2 - 1 - i] = 0.5 - 0.5 * node;
        rule[1][GAUSS_POINTS / 2 + i] = 0.5 * weight;
        rule[1][GAUSS_POINTS / 2 - 1 - i] = 0.5 * weight;
        i += 1;
    }
    rule
};

/// Nodes and weights of Gauss's rule on (0, 1).
pub(crate) fn gauss_legendre() -> (&'static [f64; GAUSS_POINTS], &'static [f64; GAUSS_POINTS]) {
    (&RULE[0], &RULE[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ x^k = 1/(k + 1), which the rule gives up to k = 39.
    #[test]
    fn the_rule_of_gauss_is_exact_for_powers() {
        let (nodes, weights) = gauss_legendre();
        for k in 0..40 {
            let sum: f64 = nodes.iter().zip(weights).map(|(node, weight)| weight * powi(*node, k)).sum();
            approx::assert_relative_eq!(sum, 1.0 / f64::from(k + 1), max_relative = 2e-15);
        }
    }
    use crate::numerics::functions::{ln, pow, powi};

    #[test]
    fn singular_ends_are_integrated_to_rounding() {
        // ∫ 1/√(x (1 − x)) = π; ∫ x^1.5 = 0.4; ∫ ln x = −1; ∫ 1/√(a² + x) with a = 1e-6: 2 (√(1 + a²) − a)
        approx::assert_relative_eq!(
            tanh_sinh(1.0, |x, y| 1.0 / (x * y).sqrt()),
            std::f64::consts::PI,
            max_relative = 1e-14
        );
        approx::assert_relative_eq!(tanh_sinh(1.0, |x, _| x * x.sqrt()), 0.4, max_relative = 1e-14);
        approx::assert_relative_eq!(tanh_sinh(1.0, |x, _| ln(x)), -1.0, max_relative = 1e-14);
        let near = 2.0 * ((1.0 + 1e-12_f64).sqrt() - 1e-6);
        approx::assert_relative_eq!(tanh_sinh(1.0, |x, _| 1.0 / (1e-12 + x).sqrt()), near, max_relative = 1e-13);
        approx::assert_relative_eq!(tanh_sinh(3.0, |x, _| x * x), 9.0, max_relative = 1e-14);
        // a root just beyond an end, and a layer 10⁻⁶ wide: 1 − w ln(1 + 1/w)
        let root = (pow(1.0001_f64, 1.5) - 1e-6) / 1.5;
        approx::assert_relative_eq!(tanh_sinh_between(0.0, 1.0, |x| (1.0001 - x).sqrt()), root, max_relative = 1e-13);
        let layer = 1.0 - 1e-6 * ln(1_000_001_f64);
        approx::assert_relative_eq!(tanh_sinh_between(0.0, 1.0, |x| x / (x + 1e-6)), layer, max_relative = 1e-13);
    }
}
