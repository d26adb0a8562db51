//! Kogut and Etsion (2002) loading, Etsion, Kligerman and Kadin (2005) unloading.

use std::sync::Arc;

use crate::contact::law::UnloadingShape;
use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawParts, LoadedState, Loading, Recovery};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::functions::pow;

/// The law of Kogut and Etsion.
///
/// ```text
/// loading    f = x^1.5              x ≤ 1
///            f = 1.03 x^1.425       1 < x ≤ 6        A/A_c = 0.93 x^1.136
///            f = 1.40 x^1.263       6 < x ≤ 110      A/A_c = 0.94 x^1.146
///            F = 2π R H δ           x > 110          A = 2π R δ
/// unloading  δ_r/δ_m = (1 − x_m^−0.28)(1 − x_m^−0.69)
///            F = F_m ((δ − δ_r)/(δ_m − δ_r))^n,  n = 1.5 x_m^−0.0331
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | ω_c | | m | (π K H/(2E*))² R, the unit of x |
/// | K H | `yield_factor` σ_Y | Pa | K = 0.454 + 0.41 ν, H = 2.8 σ_Y: largest Hertz pressure at yield |
/// | x, x_m | | 1 | δ/ω_c, δ_m/ω_c |
///
/// The printed pieces do not meet: the next one is 3.0 % higher at x = 1, 1.7 % at 6, and 7.9 % at 110, from where on users
/// continue fully plastic (an extension, not the authors'). Here every piece continues until the next one falls below it:
/// x = 1.48, 6.65 and 147 (ν = 0.3). From the printed force this differs by those 7.9 % at most. A large K H makes the last
/// piece cross an earlier one. From K H = 8.4 σ_Y on it would cross Hertz before first yield: there the law has no answer.
///
/// Fitted for 1 ≤ x ≤ 110, a deformable sphere on a rigid flat. The two exponents of the residual and n are from memory,
/// not seen in print.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct KogutEtsion {
    /// K H/σ_Y; `None`: 2.8 (0.454 + 0.41 ν).
    pub yield_factor: Option<f64>,
}

/// H/σ_Y.
const HARDNESS: f64 = 2.8;
const PIECES: [(f64, f64); 2] = [(1.03, 1.425), (1.40, 1.263)];
/// Where the printed pieces of the contact area begin.
const LIMITS: [f64; 3] = [1.0, 6.0, 110.0];

impl ContactLaw for KogutEtsion {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let factor = self.yield_factor.unwrap_or(HARDNESS * (0.454 + 0.41 * bodies.yield_point.poissons_ratio));
        let s = bodies.yield_indentation_ratio(factor);
        // f = 2π R H δ in units of ω_c and its force
        let plastic = 3.0 * HARDNESS / factor;
        let [(k1, p1), (k2, p2)] = PIECES;
        let (first, second) = (pow(k1, 1.0 / (1.5 - p1)), pow(k2 / k1, 1.0 / (p1 - p2)));
        // the straight line may cross a piece before the last one: then the pieces between are never reached
        let [at_first, at_second] = [(k1, p1), (k2, p2)].map(|(k, p)| pow(plastic / k, 1.0 / (p - 1.0)));
        let third = match () {
            () if at_second >= second => at_second,
            () if at_first >= first => at_first,
            () => plastic * plastic,
        };
        let is_whole = third >= 1.0;
        let mut curve = LoadingCurve::hertz();
        for (from, k, p) in [(first, k1, p1), (second, k2, p2)] {
            if from < third {
                // k s^1.5 (x/s)^p
                curve = curve.then_power(from * s, k * pow(s, 1.5 - p), p);
            }
        }
        if is_whole {
            curve = curve.then_line(third * s, plastic * s.sqrt());
        }
        let mut loading = Loading::new(curve, s, move |x, _| {
            let own = x / s;
            let area = match own {
                _ if own <= LIMITS[0] => own,
                _ if own <= LIMITS[1] => 0.93 * pow(own, 1.136),
                _ if own <= LIMITS[2] => 0.94 * pow(own, 1.146),
                _ => 2.0 * own,
            };
            (area * s).sqrt()
        });
        loading.limits.fitted_range = Some((0.0, LIMITS[2] * s));
        loading.limits.max_indentation = if is_whole { f64::INFINITY } else { s };
        let recovery = move |peak: LoadedState| {
            let m = (peak.indentation / s).max(1.0);
            let residual = (1.0 - pow(m, -0.28)) * (1.0 - pow(m, -0.69));
            let shape = UnloadingShape::Power(1.5 * pow(m, -0.0331));
            Recovery { elastic_approach: peak.indentation * (1.0 - residual), shape }
        };
        LawParts::new(loading, Arc::new(recovery))
    }
}
