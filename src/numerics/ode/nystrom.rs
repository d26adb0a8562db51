//! One step of the Runge-Kutta-Nyström pair RKN8(6)9FM for y'' = g(y).
//!
//! Dormand, El-Mikkawy, Prince (1987), High-order embedded Runge-Kutta-Nyström formulae, IMA J. Numer. Anal. 7, 423-430:
//! order 8 is propagated, order 6 estimates the error, nine stages of which the last is the first of the next step. A
//! conservative impact is a Nyström problem on every piece, so one stage sum serves position and velocity: eight
//! evaluations a step against twelve for Dormand-Prince 8(5,3), and a third of its arithmetic.

use super::equations::NystromEquation;

/// c_2 … c_8 (c_1 = 0, c_9 = 1).
const C: [f64; 7] = [0.05, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0];
const A2: [f64; 1] = [1.0 / 800.0];
const A3: [f64; 2] = [1.0 / 600.0, 1.0 / 300.0];
const A4: [f64; 3] = [9.0 / 200.0, -9.0 / 100.0, 9.0 / 100.0];
const A5: [f64; 4] = [-66_701.0 / 197_352.0, 28_325.0 / 32_892.0, -2665.0 / 5482.0, 2170.0 / 24_669.0];
const A6: [f64; 5] = [
    227_015_747.0 / 304_251_000.0,
    -54_897_451.0 / 30_425_100.0,
    12_942_349.0 / 10_141_700.0,
    -9499.0 / 304_251.0,
    539.0 / 9250.0,
];
const A7: [f64; 6] = [
    -1_131_891_597.0 / 901_789_000.0,
    41_964_921.0 / 12_882_700.0,
    -6_663_147.0 / 3_220_675.0,
    270_954.0 / 644_135.0,
    -108.0 / 5875.0,
    114.0 / 1645.0,
];
const A8: [f64; 7] = [
    13_836_959.0 / 3_667_458.0,
    -17_731_450.0 / 1_833_729.0,
    1_063_919_505.0 / 156_478_208.0,
    -33_213_845.0 / 39_119_552.0,
    13_335.0 / 28_544.0,
    -705.0 / 14_272.0,
    1645.0 / 57_088.0,
];
/// Position weights of stages 1, 3 … 7 (also the row of stage 9); those of 2, 8, 9 are 0.
const B: [f64; 6] =
    [223.0 / 7938.0, 1175.0 / 8064.0, 925.0 / 6048.0, 41.0 / 448.0, 925.0 / 14_112.0, 1175.0 / 72_576.0];
/// Velocity weights of stages 1, 3 … 8; those of 2, 9 are 0.
const V: [f64; 7] = [
    223.0 / 7938.0,
    5875.0 / 36_288.0,
    4625.0 / 21_168.0,
    41.0 / 224.0,
    4625.0 / 21_168.0,
    5875.0 / 36_288.0,
    223.0 / 7938.0,
];
/// Order 8 less order 6, position, stages 1, 3 … 7.
const EB: [f64; 6] = [
    B[0] - 7_987_313.0 / 109_941_300.0,
    B[1] - 1_610_737.0 / 44_674_560.0,
    B[2] - 10_023_263.0 / 33_505_920.0,
    B[3] + 497_221.0 / 12_409_600.0,
    B[4] - 10_023_263.0 / 78_180_480.0,
    B[5] - 1_610_737.0 / 402_071_040.0,
];
/// Order 8 less order 6, velocity, stages 1, 3 … 9.
const EV: [f64; 8] = [
    V[0] - 7_987_313.0 / 109_941_300.0,
    V[1] - 1_610_737.0 / 40_207_104.0,
    V[2] - 10_023_263.0 / 23_454_144.0,
    V[3] + 497_221.0 / 6_204_800.0,
    V[4] - 10_023_263.0 / 23_454_144.0,
    V[5] - 1_610_737.0 / 40_207_104.0,
    V[6] + 4_251_941.0 / 54_970_650.0,
    -3.0 / 20.0,
];

const V_REST: [f64; 6] = [V[1], V[2], V[3], V[4], V[5], V[6]];
const EB_REST: [f64; 5] = [EB[1], EB[2], EB[3], EB[4], EB[5]];
const EV_REST: [f64; 7] = [EV[1], EV[2], EV[3], EV[4], EV[5], EV[6], EV[7]];

/// Evaluations of g a step costs: stages 2 … 9.
pub const EVALUATIONS: u64 = 8;

/// The results of a step of length h.
#[derive(Debug, Clone, Copy)]
pub struct NystromStep {
    /// y at the end.
    pub position: f64,
    /// h y' at the end.
    pub velocity: f64,
    /// h² g at the end: the first stage of the next step.
    pub acceleration: f64,
    /// Mean of y over the step, by the velocity weights (order 8).
    pub mean: f64,
    /// Estimated error of `position`.
    pub position_error: f64,
    /// Estimated error of `velocity`.
    pub velocity_error: f64,
}

/// w_1 s_1 + … + w_N s_N. The newest stage is added last: the sum of the others is ready by then, which halves the chain of
/// dependent operations in a step.
#[inline(always)]
fn weighted_sum<const N: usize>(start: f64, weights: [f64; N], stages: [f64; N]) -> f64 {
    let mut total = start;
    for i in 0..N {
        total += stages[i] * weights[i];
    }
    total
}

/// One step of length h from (y, u), where `g1` = h² g(y) and `field` gives h² g.
#[inline(always)]
pub(super) fn step<F: NystromEquation>(y: f64, hu: f64, g1: f64, field: F) -> NystromStep {
    let g2 = field.g(weighted_sum(y + hu * C[0], A2, [g1]));
    let y3 = weighted_sum(y + hu * C[1], A3, [g1, g2]);
    let g3 = field.g(y3);
    let y4 = weighted_sum(y + hu * C[2], A4, [g1, g2, g3]);
    let g4 = field.g(y4);
    let y5 = weighted_sum(y + hu * C[3], A5, [g1, g2, g3, g4]);
    let g5 = field.g(y5);
    let y6 = weighted_sum(y + hu * C[4], A6, [g1, g2, g3, g4, g5]);
    let g6 = field.g(y6);
    let y7 = weighted_sum(y + hu * C[5], A7, [g1, g2, g3, g4, g5, g6]);
    let g7 = field.g(y7);
    let y8 = weighted_sum(y + hu * C[6], A8, [g1, g2, g3, g4, g5, g6, g7]);
    let g8 = field.g(y8);
    let position = weighted_sum(y + hu, B, [g1, g3, g4, g5, g6, g7]);
    let acceleration = field.g(position);
    NystromStep {
        position,
        velocity: weighted_sum(hu, V, [g1, g3, g4, g5, g6, g7, g8]),
        acceleration,
        mean: weighted_sum(y * V[0], V_REST, [y3, y4, y5, y6, y7, y8]),
        position_error: weighted_sum(g1 * EB[0], EB_REST, [g3, g4, g5, g6, g7]),
        velocity_error: weighted_sum(g1 * EV[0], EV_REST, [g3, g4, g5, g6, g7, g8, acceleration]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::functions::{log2, powi};

    /// Order conditions on monomials: with g = 0 but y given by hand the quadrature part of the weights must integrate
    /// 1, c, c² … exactly: Σ V c^k = 1/(k+1) for k < 8, Σ B c^k = 1/((k+1)(k+2)) for k < 7, rows Σ a = c²/2.
    #[test]
    fn weights_and_rows_meet_the_order_conditions() {
        let c: [f64; 7] = [0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0];
        for k in 0..8 {
            let want = 1.0 / f64::from(k + 1);
            let got: f64 = V.iter().zip(c).map(|(v, c)| v * powi(c, k)).sum();
            approx::assert_relative_eq!(got, want, max_relative = 1e-14);
            if k < 7 {
                let got: f64 = B.iter().zip(c).map(|(b, c)| b * powi(c, k)).sum();
                approx::assert_relative_eq!(got, want / f64::from(k + 2), max_relative = 1e-14);
            }
        }
        for (row, c) in [&A2[..], &A3, &A4, &A5, &A6, &A7, &A8].iter().zip(C) {
            approx::assert_relative_eq!(row.iter().sum::<f64>(), c * c / 2.0, max_relative = 1e-12);
        }
        approx::assert_abs_diff_eq!(EB.iter().sum::<f64>(), 0.0, epsilon = 1e-15);
        approx::assert_abs_diff_eq!(EV.iter().sum::<f64>(), 0.0, epsilon = 1e-15);
    }

    /// y'' = −y³ from (0, 1) to time 6: halving the step must cut the error by 2^8.
    #[test]
    fn a_nonlinear_oscillator_converges_with_order_eight() {
        /// −h² y³.
        #[derive(Clone, Copy)]
        struct Cubic(f64);
        impl NystromEquation for Cubic {
            const USES_PLAIN_VARIABLES: bool = true;
            const IS_SMOOTH_AT_ZERO: bool = true;
            fn scale_by(self, factor: f64) -> Self {
                Self(self.0 * factor)
            }
            fn g(self, y: f64) -> f64 {
                -self.0 * y * y * y
            }
            // a step asks for g alone
            fn derivatives(self, _: f64) -> (f64, f64) {
                unreachable!()
            }
            fn potential(self, _: f64) -> f64 {
                unreachable!()
            }
            fn y_at_potential(self, _: f64) -> f64 {
                unreachable!()
            }
        }
        let end = |n: u32| {
            let h = 6.0 / f64::from(n);
            let (mut y, mut u) = (0.0, 1.0);
            for _ in 0..n {
                let field = Cubic(1.0).scale_by(h * h);
                let next = step(y, h * u, field.g(y), field);
                (y, u) = (next.position, next.velocity / h);
            }
            (y, u)
        };
        let exact = end(200);
        let error = |n| (end(n).0 - exact.0).abs().max((end(n).1 - exact.1).abs());
        let order = log2(error(12) / error(24));
        assert!((7.5..9.5).contains(&order), "observed order {order}");
    }
}
