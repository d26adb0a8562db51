//! Powers, exponentials, logarithms, the functions of angles and the normal distribution, with the same bits on every processor and system.
//!
//! The methods of `f64` ask the C library of the machine, which picks other variants on processors without fused
//! multiply-add: the last digit differs. These come from the crate libm and from the modules here; all of them are made of
//! additions, multiplications, divisions and square roots, which IEEE 754 fixes to the last bit. `.clippy.toml` refuses the
//! methods of `f64` everywhere in the library.

mod pow;

use std::f64::consts::FRAC_1_SQRT_2;

pub use libm::{
    acos, asin, atan, atan2, cbrt, cos, cosh, expm1 as exp_m1, hypot, log as ln, log1p as ln_1p, log2, log10, sin,
    sincos as sin_cos, sinh, tanh, tgamma as gamma,
};
pub use pow::{exp, pow};

/// x^n by repeated squaring, always in the same order.
#[inline(always)]
pub fn powi(x: f64, n: i32) -> f64 {
    let (mut remaining, mut square, mut total) = (n.unsigned_abs(), x, 1.0);
    loop {
        if remaining % 2 == 1 {
            total *= square;
        }
        remaining /= 2;
        if remaining == 0 {
            return if n < 0 { 1.0 / total } else { total };
        }
        square *= square;
    }
}

/// The share of the normal distribution, with mean 0 and standard deviation 1, that lies below z.
pub fn normal_cdf(z: f64) -> f64 {
    0.5 * libm::erfc(-z * FRAC_1_SQRT_2)
}

/// The value below which the share p, 0 to 1, of this distribution lies.
pub fn normal_quantile(p: f64) -> f64 {
    /// 1/√(2π).
    const DENSITY: f64 = 0.398_942_280_401_432_7;
    let share = p.min(1.0 - p);
    if share <= 0.0 {
        return f64::INFINITY.copysign(p - 0.5);
    }
    // ln Φ rises and is concave, and Φ(z) ≤ ½ exp(−z²/2) for z ≤ 0: Newton's method comes up to the root from there
    let wanted = ln(share);
    let mut z = -(-2.0 * ln(2.0 * share)).max(0.0).sqrt();
    for _ in 0..20 {
        let below = normal_cdf(z);
        let step = (wanted - ln(below)) * below / (DENSITY * exp(-0.5 * z * z));
        z += step;
        // the next step would be its square
        if step.abs() <= 1e-9 {
            break;
        }
    }
    if p < 0.5 { z } else { -z }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Neighbouring doubles between two positive numbers.
    fn ulp_distance(a: f64, b: f64) -> u64 {
        a.to_bits().abs_diff(b.to_bits())
    }

    #[allow(clippy::cast_precision_loss)] // 53 bits
    #[test]
    fn powers_match_libm_to_last_digit() {
        // both are within 0.7 of the last digit
        let mut seed = 7_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut equal = 0;
        for case in 0..100_000 {
            let x = match case % 3 {
                0 => libm::exp(1200.0 * random() - 600.0),
                1 => 0.9 + 0.2 * random(),
                _ => 1.0 + 1e-4 * (random() - 0.5),
            };
            let y = if case % 2 == 0 { 4.0 * random() - 2.0 } else { 1000.0 * (random() - 0.5) };
            let (own, theirs) = (pow(x, y), libm::pow(x, y));
            assert!(ulp_distance(own, theirs) <= 1, "{x:e}^{y:e}: {own:e}, {theirs:e}");
            equal += u32::from(own == theirs);
            let z = 1400.0 * (random() - 0.5);
            assert!(ulp_distance(exp(z), libm::exp(z)) <= 1, "e^{z}");
        }
        assert!(equal > 95_000, "{equal}");
    }

    #[test]
    fn powers_that_are_doubles_are_exact() {
        for n in 0..=22 {
            let want: f64 = format!("1e{n}").parse().unwrap();
            assert_eq!((pow(10.0, f64::from(n)), powi(10.0, n)), (want, want));
        }
        for n in -1074..1024 {
            assert_eq!(pow(2.0, f64::from(n)), libm::ldexp(1.0, n));
        }
        assert_eq!((pow(32.0, 0.2), pow(4096.0, 0.75), pow(7.0, 0.0), exp(0.0)), (2.0, 512.0, 1.0, 1.0));
        assert_eq!((powi(2.0, -3), powi(3.0, 5), powi(0.0, 0)), (0.125, 243.0, 1.0));
    }

    #[test]
    fn powers_at_limits_follow_ieee_754() {
        let (big, least) = (f64::INFINITY, f64::from_bits(1));
        assert_eq!((pow(0.0, 1.5), pow(0.0, -1.5), pow(big, 0.5), pow(big, -0.5)), (0.0, big, big, 0.0));
        assert_eq!((pow(1e300, 2.0), pow(1e-300, 2.0), pow(least, 0.5)), (big, 0.0, least.sqrt()));
        assert_eq!((exp(710.0), exp(-746.0), exp(big), exp(-big)), (big, 0.0, big, 0.0));
        assert!(pow(-2.0, 0.5).is_nan() && pow(f64::NAN, 2.0).is_nan() && pow(2.0, f64::NAN).is_nan());
        assert!(exp(f64::NAN).is_nan());
    }

    #[test]
    fn quantiles_are_the_inverse_of_the_distribution() {
        for z in [-37.0, -20.0, -8.0, -5.5, -3.0, -1.5, -1.0, -0.3, 0.0, 0.5, 1.0, 1.4, 2.0, 3.0] {
            // beside 1, p has lost the digits of z
            let lost = if z > 0.0 { f64::EPSILON / normal_cdf(-z) } else { 0.0 };
            // the error function takes the rounded z/√2, and near the mean p has no more than absolute digits
            let epsilon = 4.0 * f64::EPSILON * z.abs().max(1.0) + lost;
            approx::assert_abs_diff_eq!(normal_quantile(normal_cdf(z)), z, epsilon = epsilon);
        }
        assert_eq!((normal_quantile(0.0), normal_quantile(1.0)), (f64::NEG_INFINITY, f64::INFINITY));
    }
}
