//! One step of the Runge-Kutta pair of Dormand and Prince of order 8(5,3), for motions whose force depends on the speed.
//!
//! Hairer, Nørsett, Wanner (1993), Solving Ordinary Differential Equations I, section II.10: order 8 is propagated, orders
//! 5 and 3 estimate the error, twelve stages. Only position and speed feed back; time and loss are quadratures beside them.

use super::piece::{Motion, Quad};

use crate::math::functions::hypot;

const A2: [f64; 1] = [0.052_600_151_958_767_73];
const A3: [f64; 2] = [0.019_725_056_984_537_9, 0.059_175_170_953_613_7];
const A4: [f64; 2] = [0.029_587_585_476_806_85, 0.088_762_756_430_420_54];
const A5: [f64; 3] = [0.241_365_134_159_266_7, -0.884_549_479_328_286_1, 0.924_834_003_261_792];
const A6: [f64; 3] = [0.037_037_037_037_037_035, 0.170_828_608_729_473_86, 0.125_467_687_566_822_42];
const A7: [f64; 4] = [0.037_109_375, 0.170_252_211_019_544_05, 0.060_216_538_980_455_96, -0.017_578_125];
const A8: [f64; 5] = [
    0.037_092_000_118_504_79,
    0.170_383_925_712_239_98,
    0.107_262_030_446_373_28,
    -0.015_319_437_748_624_402,
    0.008_273_789_163_814_023,
];
const A9: [f64; 6] = [
    0.624_110_958_716_075_7,
    -3.360_892_629_446_941_4,
    -0.868_219_346_841_726,
    27.592_099_699_446_71,
    20.154_067_550_477_894,
    -43.489_884_181_069_96,
];
const A10: [f64; 7] = [
    0.477_662_536_438_264_34,
    -2.488_114_619_971_667_7,
    -0.590_290_826_836_843,
    21.230_051_448_181_193,
    15.279_233_632_882_423,
    -33.288_210_968_984_86,
    -0.020_331_201_708_508_627,
];
const A11: [f64; 8] = [
    -0.937_142_430_085_987_3,
    5.186_372_428_844_064,
    1.091_437_348_996_729_5,
    -8.149_787_010_746_927,
    -18.520_065_659_996_96,
    22.739_487_099_350_505,
    2.493_605_552_679_652_3,
    -3.046_764_471_898_219_6,
];
const A12: [f64; 9] = [
    2.273_310_147_516_538,
    -10.534_495_466_737_25,
    -2.000_872_058_224_862_5,
    -17.958_931_863_118_8,
    27.948_884_529_419_96,
    -2.858_998_277_135_023_5,
    -8.872_856_933_530_63,
    12.360_567_175_794_303,
    0.643_392_746_015_763_6,
];
/// Weights of order 8, stages 1, 6 … 12.
const B: [f64; 8] = [
    0.054_293_734_116_568_765,
    4.450_312_892_752_409,
    1.891_517_899_314_500_3,
    -5.801_203_960_010_585,
    0.311_164_366_957_819_9,
    -0.152_160_949_662_516_1,
    0.201_365_400_804_030_34,
    0.044_710_615_727_772_59,
];
/// Weights of order 8 less those of order 5, the same stages.
const E5: [f64; 8] = [
    0.013_120_044_994_194_88,
    -1.225_156_446_376_204_4,
    -0.495_758_949_657_250_2,
    1.664_377_182_454_986_4,
    -0.350_328_848_749_973_66,
    0.334_179_118_713_017_5,
    0.081_923_206_485_115_71,
    -0.022_355_307_863_886_294,
];
/// Weights of order 3, stages 1, 9, 12.
const B3: [f64; 3] = [0.244_094_488_188_976_4, 0.733_846_688_281_611_8, 0.022_058_823_529_411_766];

/// Evaluations of the rates a step costs: stages 2 … 12 and the first of the next step.
pub(super) const EVALUATIONS: u64 = 12;

/// The end of a step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Step {
    pub(super) node: Quad,
    /// Rates at the end: the first stage of the next step.
    pub(super) rates: Quad,
    /// Largest relative error of order 5, per length of the step.
    pub(super) fifth: f64,
    /// Largest relative error of order 3, per length of the step.
    pub(super) third: f64,
}

impl Step {
    /// Estimated error of this step of length h relative to the sizes, `least` times that of order 5 at least.
    #[inline(always)]
    pub(super) fn error(&self, h: f64, least: f64) -> f64 {
        // Hairer et al., Eq. (II.10.17): of order h^8, and kept apart from zero where both vanish
        let scale = hypot(self.fifth, 0.1 * self.third);
        // a step that is far too long may end in numbers that are not finite
        if !self.node.iter().all(|part| part.is_finite()) {
            f64::INFINITY
        } else if scale > 0.0 {
            h.abs() * self.fifth * (self.fifth / scale).max(least)
        } else {
            h.abs() * self.fifth
        }
    }
}

#[inline(always)]
fn sum<const N: usize>(weights: [f64; N], stages: [&Quad; N], part: usize) -> f64 {
    let mut total = stages[0][part] * weights[0];
    for i in 1..N {
        total += stages[i][part] * weights[i];
    }
    total
}

/// One step of length h from `node` with its `rates`; errors are measured against 1/`inverse_sizes` of y, u and loss.
#[inline(always)]
pub(super) fn step<M: Motion>(motion: M, node: &Quad, rates: &Quad, h: f64, inverse_sizes: &[f64; 3]) -> Step {
    macro_rules! stage {
        ($weights:ident, $($stage:ident),*) => {
            motion.rates(
                node[0] + h * sum($weights, [$(&$stage),*], 0),
                node[1] + h * sum($weights, [$(&$stage),*], 1),
            )
        };
    }
    let k1 = *rates;
    let k2 = stage!(A2, k1);
    let k3 = stage!(A3, k1, k2);
    let k4 = stage!(A4, k1, k3);
    let k5 = stage!(A5, k1, k3, k4);
    let k6 = stage!(A6, k1, k4, k5);
    let k7 = stage!(A7, k1, k4, k5, k6);
    let k8 = stage!(A8, k1, k4, k5, k6, k7);
    let k9 = stage!(A9, k1, k4, k5, k6, k7, k8);
    let k10 = stage!(A10, k1, k4, k5, k6, k7, k8, k9);
    let k11 = stage!(A11, k1, k4, k5, k6, k7, k8, k9, k10);
    let k12 = stage!(A12, k1, k4, k5, k6, k7, k8, k9, k10, k11);
    let stages = [&k1, &k6, &k7, &k8, &k9, &k10, &k11, &k12];
    let mut slope = k1;
    let mut to = *node;
    for part in 0..4 {
        slope[part] = sum(B, stages, part);
        to[part] = node[part] + h * slope[part];
    }
    let (mut fifth, mut third) = (0.0_f64, 0.0_f64);
    for i in 0..3 {
        let part = [0, 1, 3][i];
        let of_fifth = (sum(E5, stages, part) * inverse_sizes[i]).abs();
        let of_third = ((slope[part] - sum(B3, [&k1, &k9, &k12], part)) * inverse_sizes[i]).abs();
        fifth = fifth.max(of_fifth);
        third = third.max(of_third);
    }
    Step { node: to, rates: motion.rates(to[0], to[1]), fifth, third }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::functions::{log2, powi};

    /// u' = −y − 0.2 u: halving the step must cut the error by 2^8.
    #[test]
    fn a_damped_oscillator_converges_with_order_eight() {
        #[derive(Clone, Copy)]
        struct Damped;
        impl Motion for Damped {
            fn rates(&self, y: f64, u: f64) -> Quad {
                [u, -y * y * y - 0.2 * u, 1.0, 0.2 * u * u]
            }
        }
        let end = |n: u32| {
            let h = 6.0 / f64::from(n);
            let mut node = [0.0, 1.0, 0.0, 0.0];
            let mut rates = Damped.rates(0.0, 1.0);
            for _ in 0..n {
                let next = step(Damped, &node, &rates, h, &[1.0; 3]);
                (node, rates) = (next.node, next.rates);
            }
            node
        };
        let exact = end(400);
        // the ledger: kinetic + potential + loss
        let [y, u, time, loss] = exact;
        approx::assert_relative_eq!(0.5 * u * u + 0.25 * powi(y, 4) + loss, 0.5, max_relative = 1e-14);
        approx::assert_relative_eq!(time, 6.0, max_relative = 1e-14);
        for part in [0, 1, 3] {
            let error = |n| (end(n)[part] - exact[part]).abs();
            let order = log2(error(12) / error(24));
            assert!((7.5..10.5).contains(&order), "observed order {order} of part {part}");
        }
    }
}
