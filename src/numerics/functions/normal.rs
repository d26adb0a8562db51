//! The normal distribution with mean 0 and standard deviation 1.

use std::f64::consts::FRAC_1_SQRT_2;

use super::{exp, ln};

pub fn normal_below(z: f64) -> f64 {
    0.5 * libm::erfc(-z * FRAC_1_SQRT_2)
}

/// The value below which the share p, 0 to 1, of all values lies.
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
        let below = normal_below(z);
        let step = (wanted - ln(below)) * below / (DENSITY * exp(-0.5 * z * z));
        z += step;
        // the next step would be its square
        if step.abs() <= 1e-9 {
            break;
        }
    }
    if p < 0.5 { z } else { -z }
}
