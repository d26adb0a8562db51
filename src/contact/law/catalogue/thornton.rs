//! Thornton (1997), Thornton and Ning (1998): contact pressure capped at a limiting value.

use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawParts, Loading, hertz_unloading};
use crate::numerics::curve::LoadingCurve;

/// The law of Thornton.
///
/// ```text
/// loading    F = (4/3) E* √R δ^1.5                     δ ≤ δ_y
///            F = F_y + π p_y R (δ − δ_y)               beyond
/// unloading  F = (4/3) E* √R_p (δ − δ_r)^1.5
///            R_p = (4E*/(3 F_m)) ((2 F_m + F_y)/(2π p_y))^1.5,  δ_r = δ_m − (3 F_m/(4 E* √R_p))^(2/3)
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | p_y | `yield_pressure` | Pa | limiting contact pressure: the largest Hertz pressure at yield; C_ν σ_Y if not given |
/// | δ_y, F_y | | m, N | Hertz where its largest pressure reaches p_y: δ_y = R (π p_y/2E*)² |
/// | R_p | | m | radius of unloading, R_p F_m = R F_e with the Hertz force F_e at (2 F_m + F_y)/(2π p_y R) = δ_m |
///
/// The straight line is tangent to Hertz at δ_y. In units of δ_y and F_y: f = 1 + 1.5 (x − 1), R_p/R = ((2f + 1)/3)^1.5/f.
///
/// e(v) in closed form, q = V_y/V: e = (6√3/5)^½ √(1 − q²/6) (q/(q + 2√(6/5 − q²/5)))^¼, 1.185 q^¼ for fast impacts.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Thornton {
    /// p_y \[Pa\]; `None`: C_ν σ_Y.
    pub yield_pressure: Option<f64>,
}

/// ε/δ_y of Hertz-type unloading with Thornton's R_p, at f = F_m/F_y: (f² R/R_p)^(1/3) = f √(3/(2f + 1)).
pub(super) fn elastic_approach(force: f64) -> f64 {
    force * (3.0 / (2.0 * force + 1.0)).sqrt()
}

impl ContactLaw for Thornton {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        // δ_y/δ_Y
        let yields = self
            .yield_pressure
            .map_or(1.0, |pressure| bodies.yield_indentation_ratio(pressure / bodies.yield_point.strength));
        let unit = yields * yields.sqrt();
        let loading = Loading::new(LoadingCurve::hertz().then_tangent(yields), yields, |x, _| x.sqrt());
        LawParts::new(loading, hertz_unloading(move |peak| yields * elastic_approach(peak.force / unit)))
    }
}
