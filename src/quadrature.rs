//! Integrals of functions that are smooth inside an interval but for what happens at its ends: roots, and layers however
//! thin. A leaf.

use std::f64::consts::PI;
use std::sync::LazyLock;

/// ∫ f over an interval by the double-exponential rule of Takahasi and Mori (1974): nodes crowd towards both ends, so that
/// singularities there, and close beyond them, cost no accuracy. Neither end is evaluated.
pub fn integrate(from: f64, to: f64, f: impl Fn(f64) -> f64) -> f64 {
    let length = to - from;
    let pairs = NODES.iter().map(|Node { share, weight }| {
        let reach = length * share;
        weight * (f(from + reach) + f(to - reach))
    });
    length * (MIDDLE * f(from + 0.5 * length) + pairs.sum::<f64>())
}

/// Two nodes, at the same distance from either end.
struct Node {
    /// That distance, as a share of the interval.
    share: f64,
    weight: f64,
}

/// Spacing of the nodes in t, with the distance 1/(1 + exp(π sinh t)) from an end.
const STEP: f64 = 1.0 / 16.0;
/// Up to here: the next node is nearer to the end than one rounding error of the interval.
const COUNT: u32 = 51;
/// Weight of the node in the middle, t = 0.
const MIDDLE: f64 = STEP * PI / 4.0;

static NODES: LazyLock<Vec<Node>> = LazyLock::new(|| {
    (1..=COUNT)
        .map(|k| {
            let t = STEP * f64::from(k);
            let share = 1.0 / (1.0 + (PI * t.sinh()).exp());
            Node { share, weight: STEP * PI * t.cosh() * share * (1.0 - share) }
        })
        .collect()
});

#[cfg(test)]
mod tests {
    use super::integrate;

    #[test]
    fn singular_ends_and_thin_layers_cost_no_accuracy() {
        let table = [
            (integrate(0.0, 1.0, |x| x * x), 1.0 / 3.0),
            (integrate(-1.0, 1.0, |x| (1.0 - x * x).sqrt()), std::f64::consts::FRAC_PI_2),
            (integrate(0.0, 1.0, |x| x.powf(-0.2)), 1.25),
            // a layer 10^-6 wide: 1 - w ln(1 + 1/w)
            (integrate(0.0, 1.0, |x| x / (x + 1e-6)), 1.0 - 1e-6 * 1_000_001_f64.ln()),
            // a root just beyond an end
            (integrate(0.0, 1.0, |x| (1.0001 - x).sqrt()), (1.0001_f64.powf(1.5) - 1e-6) / 1.5),
        ];
        for (got, want) in table {
            approx::assert_relative_eq!(got, want, max_relative = 2e-13);
        }
    }
}
