//! Gauss quadrature on panels, and the time integral ∫ dd/u, whose integrand is itself an integral.

use std::sync::LazyLock;

use crate::math::functions::cos;

/// Nodes of a panel.
const NODES: usize = 20;

/// Gauss-Legendre on (0, 1), with the integrals up to every node.
struct Rule {
    nodes: [f64; NODES],
    weights: [f64; NODES],
    /// Row i integrates the polynomial through all nodes from 0 to node i.
    partial: [[f64; NODES]; NODES],
}

static RULE: LazyLock<Rule> = LazyLock::new(Rule::new);

/// P_0 … P_n at t.
fn legendre(t: f64) -> [f64; NODES + 1] {
    let mut p = [1.0; NODES + 1];
    p[1] = t;
    let mut k = 1.0;
    for i in 1..NODES {
        p[i + 1] = ((2.0 * k + 1.0) * t * p[i] - k * p[i - 1]) / (k + 1.0);
        k += 1.0;
    }
    p
}

impl Rule {
    #[allow(clippy::cast_precision_loss)] // a few nodes
    fn new() -> Self {
        let n = NODES as f64;
        let mut rule = Self { nodes: [0.0; NODES], weights: [0.0; NODES], partial: [[0.0; NODES]; NODES] };
        let mut roots = [0.0; NODES];
        for (i, root) in roots.iter_mut().enumerate() {
            let mut t = -cos(std::f64::consts::PI * (i as f64 + 0.75) / (n + 0.5));
            for _ in 0..20 {
                let p = legendre(t);
                t -= p[NODES] * (t * t - 1.0) / (n * (t * p[NODES] - p[NODES - 1]));
            }
            let p = legendre(t);
            let slope = n * (t * p[NODES] - p[NODES - 1]) / (t * t - 1.0);
            *root = t;
            rule.nodes[i] = 0.5 * (1.0 + t);
            rule.weights[i] = 1.0 / ((1.0 - t * t) * slope * slope);
        }
        // the polynomial as a sum of Legendre's, whose integrals are (P_k+1 − P_k−1)/(2k + 1)
        for (i, row) in rule.partial.iter_mut().enumerate() {
            let up_to = legendre(roots[i]);
            for (j, entry) in row.iter_mut().enumerate() {
                let at = legendre(roots[j]);
                let sum: f64 = (1..NODES).map(|k| at[k] * (up_to[k + 1] - up_to[k - 1])).sum();
                *entry = 0.5 * rule.weights[j] * (roots[i] + 1.0 + sum);
            }
        }
        rule
    }
}

/// ∫ f on one panel.
pub(super) fn integrate(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let width = to - from;
    let rule = &*RULE;
    width * rule.nodes.iter().zip(&rule.weights).map(|(node, weight)| weight * f(from + width * node)).sum::<f64>()
}

/// ∫ f from `from` to `to` (either may be the larger), both > 0, for an f that is smooth but for x = 0: panels that grow as
/// powers of 4, on which 20 nodes leave 3⁻⁴⁰ of the singularity.
pub(super) fn over_decades(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (low, high) = (from.min(to), from.max(to));
    let mut total = 0.0;
    let mut end = high;
    while end > low && end.is_finite() {
        let begin = if 0.25 * end > 1.5 * low { 0.25 * end } else { low };
        total += integrate(begin, end, &f);
        end = begin;
    }
    if to >= from { total } else { -total }
}

/// ∫ dd/u from `from` to `to` for d'' = −g(d), with u = `exit` at `to` (0: a turning point); g is smooth but for a zero at
/// `zero` ≤ `from`.
///
/// With d = to − ζ (ζ + 2 z), z² = exit²/(2 g(to)) the way beyond `to` that a constant g would leave, the root in
/// u² = exit² + 2 ∫ g loses its singularity. On every panel in ζ the inner integral is that of the polynomial through the
/// nodes; panels shrink by 2/3 in the distance from `zero`.
pub(super) fn time(g: impl Fn(f64) -> f64, zero: f64, from: f64, to: f64, exit: f64) -> f64 {
    /// What is nearer to the zero than this share of the way counts as smooth: its work is below rounding.
    const NEAREST: f64 = 1e-8;
    if to <= from {
        return 0.0;
    }
    let rule = &*RULE;
    let z = (0.5 * exit * exit / g(to)).max(0.0).sqrt();
    // ζ of a distance below `to`
    let zeta = |way: f64| way / ((way + z * z).sqrt() + z);
    let floor = NEAREST * (to - zero);
    let (mut total, mut square, mut near) = (0.0, exit * exit, 0.0);
    let mut end = to;
    while end > from {
        let reach = zero + (end - zero) * (2.0 / 3.0);
        let begin = if reach > from + 0.2 * (end - from) && reach - zero > floor { reach } else { from };
        let far = zeta(to - begin);
        let width = far - near;
        let mut rates = [0.0; NODES];
        let mut halves = [0.0; NODES];
        for i in 0..NODES {
            let at = near + width * rule.nodes[i];
            // −dd/dζ
            halves[i] = 2.0 * (at + z);
            rates[i] = halves[i] * g(to - at * (at + 2.0 * z));
        }
        for ((half, weight), parts) in halves.iter().zip(&rule.weights).zip(&rule.partial) {
            let inner: f64 = parts.iter().zip(&rates).map(|(part, rate)| part * rate).sum();
            total += width * weight * half / (square + 2.0 * width * inner).sqrt();
        }
        square += 2.0 * width * rule.weights.iter().zip(&rates).map(|(weight, rate)| weight * rate).sum::<f64>();
        (end, near) = (begin, far);
    }
    total
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::functions::powi;

    #[test]
    fn the_rule_integrates_polynomials() {
        for k in 0..39 {
            let exact = 1.0 / f64::from(k + 1);
            approx::assert_relative_eq!(integrate(0.0, 1.0, |x| powi(x, k)), exact, max_relative = 1e-14);
        }
        for k in 0..20 {
            for i in 0..NODES {
                let got: f64 = (0..NODES).map(|j| RULE.partial[i][j] * powi(RULE.nodes[j], k)).sum();
                approx::assert_abs_diff_eq!(got, powi(RULE.nodes[i], k + 1) / f64::from(k + 1), epsilon = 1e-15);
            }
        }
    }
}
