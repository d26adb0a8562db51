//! Ma and Liu (2015): elastic, mixed and fully plastic loading, joined with equal slopes.

use super::thornton;
use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawParts, Loading, hertz_unloading};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::functions::{cbrt, ln, powi};

/// The law of Ma and Liu, written from memory.
///
/// ```text
/// loading    f = x^1.5                      x ≤ 1
///            f = x (c_1 + c_2 ln x) + c_3    1 < x < x_p
///            f = f_p + k (x − x_p)           x ≥ x_p
/// unloading  Hertz-type with R_e = R_p(F_m) of Thornton for F_m < F_p, held at R_p(F_p) beyond
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | H | `hardness_ratio` × σ_Y | Pa | pressure of full plasticity; 2.8 σ_Y if not given |
/// | x_p | `transition_ratio` | 1 | δ_p/δ_Y; 110 if not given |
/// | k | | 1 | slope of F = 2π R H δ: 3 H/(C_ν σ_Y) |
/// | c_1, c_2, c_3 | | 1 | from equal force and slope at x = 1 and equal slope at x_p: c_2 = (k − 3/2)/ln x_p, c_1 = 3/2 − c_2, c_3 = 1 − c_1 |
///
/// The structure is that of the abstract: three regimes, fixed by hardness and one geometric parameter, joined with equal
/// slopes, and Hertzian unloading. The constants and the fully plastic slope were not seen in print. Take its numbers as an
/// example of the form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MaLiu {
    /// H/σ_Y.
    pub hardness_ratio: f64,
    /// x_p.
    pub transition_ratio: f64,
}

impl Default for MaLiu {
    fn default() -> Self {
        Self { hardness_ratio: 2.8, transition_ratio: 110.0 }
    }
}

impl ContactLaw for MaLiu {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let slope = bodies.slope_at_pressure(2.0, self.hardness_ratio);
        let end = self.transition_ratio;
        let c2 = (slope - 1.5) / ln(end);
        let c1 = 1.5 - c2;
        let mixed = move |x: f64| x * (c2 * ln(x) + c1) + (1.0 - c1);
        let plastic = mixed(end);
        // ε = (f²/(R_e/R))^(1/3)
        let elastic_approach = move |force: f64| {
            let at = force.min(plastic);
            thornton::elastic_approach(at) * powi(cbrt(force / at), 2)
        };
        let curve = LoadingCurve::hertz().then_fitted(1.0, end, 0.0, mixed).then_line(end, slope);
        // the radius of the Hertz contact at the start of unloading
        let loading = Loading::new(curve, 1.0, move |_, force| force / elastic_approach(force));
        LawParts::new(loading, hertz_unloading(move |peak| elastic_approach(peak.force)))
    }
}
