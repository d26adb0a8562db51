//! One step of the Runge-Kutta pair of Dormand and Prince of order 8(5,3), for motions whose force depends on the speed.
//!
//! Hairer, Nørsett, Wanner (1993), Solving Ordinary Differential Equations I, section II.10: order 8 is propagated, orders
//! 5 and 3 estimate the error, twelve stages. Only position and speed feed back; time and loss are quadratures beside them.

use super::equations::{DampedEquation, DampedState};
use crate::numerics::functions::hypot;

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

const A14: [f64; 8] = [
    0.056_167_502_283_047_954,
    0.253_500_210_216_624_83,
    -0.246_239_037_470_802_5,
    -0.124_191_423_263_816_37,
    0.153_291_798_278_765_68,
    0.008_201_052_295_634_69,
    0.007_567_897_660_545_699,
    -0.008_298,
];
const A15: [f64; 8] = [
    0.031_834_648_163_502_14,
    0.028_300_909_672_366_776,
    0.053_541_988_307_438_566,
    -0.054_923_748_571_390_99,
    -0.000_108_347_328_697_249_32,
    0.000_382_571_090_835_658_4,
    -0.000_340_465_008_687_404_56,
    0.141_312_443_674_632_5,
];
const A16: [f64; 8] = [
    -0.428_896_301_583_791_94,
    -4.697_621_415_361_164,
    7.683_421_196_062_599,
    4.068_989_818_397_11,
    0.356_727_187_455_281_1,
    -0.001_399_024_165_159_014_5,
    2.947_514_789_152_772_4,
    -9.150_958_472_179_87,
];
/// Weights of the last four terms, stages 1, 6 … 16.
const D: [[f64; 12]; 4] = [
    [
        -8.428_938_276_109_013,
        0.566_714_953_519_377_7,
        -3.068_949_945_949_891_7,
        2.384_667_656_512_07,
        2.117_034_582_445_028,
        -0.871_391_583_777_973,
        2.240_437_430_260_788_3,
        0.631_578_778_769_468_8,
        -0.088_990_336_451_333_31,
        18.148_505_520_854_727,
        -9.194_632_392_478_356,
        -4.436_036_387_594_894,
    ],
    [
        10.427_508_642_579_134,
        242.283_491_775_258_17,
        165.200_451_717_270_28,
        -374.546_754_722_690_2,
        -22.113_666_853_125_306,
        7.733_432_668_472_264,
        -30.674_084_731_089_398,
        -9.332_130_526_430_229,
        15.697_238_121_770_845,
        -31.139_403_219_565_178,
        -9.352_924_358_844_48,
        35.816_841_486_394_08,
    ],
    [
        19.985_053_242_002_433,
        -387.037_308_749_351_8,
        -189.178_138_195_167_58,
        527.808_159_205_423_6,
        -11.573_902_539_959_63,
        6.881_232_694_696_3,
        -1.000_605_096_691_083_8,
        0.777_713_779_805_344_3,
        -2.778_205_752_353_508,
        -60.196_695_231_264_12,
        84.320_405_506_677_16,
        11.992_291_136_182_79,
    ],
    [
        -25.693_933_462_703_75,
        -154.189_748_690_236_43,
        -231.529_379_176_045_5,
        357.639_117_910_614_1,
        93.405_324_183_624_32,
        -37.458_323_136_451_63,
        104.099_649_508_962_3,
        29.840_293_426_660_5,
        -43.533_456_590_011_14,
        96.324_553_959_188_28,
        -39.177_261_675_615_44,
        -149.726_836_257_985_64,
    ],
];

/// Evaluations of the rates a step costs: stages 2 … 12 and the first of the next step.
pub(super) const EVALUATIONS: u64 = 12;
/// Evaluations that its continuous solution costs besides.
pub(super) const DENSE_OUTPUT_EVALUATIONS: u64 = 3;

#[derive(Debug, Clone, Copy)]
pub(super) struct Dop853Step {
    pub(super) node: DampedState,
    /// Rates at the end: the first stage of the next step.
    pub(super) rates: DampedState,
    /// Largest relative error of order 5, per length of the step.
    pub(super) fifth: f64,
    /// Largest relative error of order 3, per length of the step.
    pub(super) third: f64,
    /// Stages 1, 6 … 12.
    stages: [DampedState; 8],
}

/// The continuous solution of a step, of order 7: a polynomial on 0 ≤ θ ≤ 1 with the right values and rates at both ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct ContinuousExtension([DampedState; 8]);

impl ContinuousExtension {
    /// A part of the node at θ, and its derivative.
    #[inline]
    pub(super) fn component(&self, part: usize, theta: f64) -> (f64, f64) {
        let (mut value, mut slope) = (self.0[7][part], 0.0);
        for k in (0..7).rev() {
            let (x, dx) = if k % 2 == 0 { (theta, 1.0) } else { (1.0 - theta, -1.0) };
            slope = slope * x + value * dx;
            value = self.0[k][part] + value * x;
        }
        (value, slope)
    }

    /// A part of the node at θ alone.
    #[inline]
    pub(super) fn value(&self, part: usize, theta: f64) -> f64 {
        self.component(part, theta).0
    }

    pub(super) fn state_at(&self, theta: f64) -> DampedState {
        [self.value(0, theta), self.value(1, theta), self.value(2, theta), self.value(3, theta)]
    }
}

impl Dop853Step {
    /// The step with another node at its end, at which the motion has these rates.
    pub(super) fn with_end(self, node: DampedState, rates: DampedState) -> Self {
        Self { node, rates, ..self }
    }

    /// The continuous solution of this step of length h from `node`.
    pub(super) fn dense_output<P: DampedEquation>(&self, motion: P, node: &DampedState, h: f64) -> ContinuousExtension {
        let [k1, k6, k7, k8, k9, k10, k11, k12] = &self.stages;
        let k13 = &self.rates;
        let rates = |weights: [f64; 8], stages: [&DampedState; 8]| {
            motion.rates(node[0] + h * sum(weights, stages, 0), node[1] + h * sum(weights, stages, 1))
        };
        let k14 = &rates(A14, [k1, k7, k8, k9, k10, k11, k12, k13]);
        let k15 = &rates(A15, [k1, k6, k7, k8, k11, k12, k13, k14]);
        let k16 = &rates(A16, [k1, k6, k7, k8, k9, k13, k14, k15]);
        let mut terms = [*node; 8];
        for part in 0..4 {
            let change = self.node[part] - node[part];
            let first = h * k1[part] - change;
            terms[1][part] = change;
            terms[2][part] = first;
            terms[3][part] = change - h * k13[part] - first;
            for (term, weights) in terms[4..].iter_mut().zip(D) {
                term[part] = h * sum(weights, [k1, k6, k7, k8, k9, k10, k11, k12, k13, k14, k15, k16], part);
            }
        }
        ContinuousExtension(terms)
    }

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
fn sum<const N: usize>(weights: [f64; N], stages: [&DampedState; N], part: usize) -> f64 {
    let mut total = stages[0][part] * weights[0];
    for i in 1..N {
        total += stages[i][part] * weights[i];
    }
    total
}

/// One step of length h from `node` with its `rates`; errors are measured against 1/`inverse_sizes` of y, u and loss.
#[inline(always)]
pub(super) fn step<P: DampedEquation>(
    motion: P,
    node: &DampedState,
    rates: &DampedState,
    h: f64,
    inverse_sizes: &[f64; 3],
) -> Dop853Step {
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
    let stages = [k1, k6, k7, k8, k9, k10, k11, k12];
    Dop853Step { node: to, rates: motion.rates(to[0], to[1]), fifth, third, stages }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::functions::{log2, powi};

    /// u' = −y − 0.2 u: halving the step must cut the error by 2^8.
    #[test]
    fn a_damped_oscillator_converges_with_order_eight() {
        #[derive(Clone, Copy)]
        struct Damped;
        impl DampedEquation for Damped {
            const VARIABLE_ROOT: i32 = 1;
            fn rates(&self, y: f64, u: f64) -> DampedState {
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
        // the energy balance: kinetic + potential + loss
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
