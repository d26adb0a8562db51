//! Storåkers, Mesarovic and Johnson: fully plastic loading, unloading from uniform pressure (Mesarovic and Johnson 2000).

use std::f64::consts::PI;
use std::sync::Arc;

use crate::contact::law::UnloadingShape;
use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawParts, LoadedState, Loading, Recovery};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::curve::unloading_curve::UnloadingCurveKind;

/// The law of Storåkers, Mesarovic and Johnson.
///
/// ```text
/// loading    F = 6π c² σ_Y R δ,   a² = 2 c² R δ
/// unloading  F = (2 F_m/π)(asin t − t √(1 − t²)),   δ_m − δ = (2 p_0 a_m/E*) √(1 − t²),   t = a/a_m
///            δ_m − δ_r = 2 F_m/(π E* a_m)
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | c² | `area_factor` | 1 | pile-up; 1.43 |
/// | p_0 | | Pa | uniform pressure at the peak, F_m/(π a_m²) = 3 σ_Y |
/// | t | | 1 | contact radius over that of the peak, 1 to 0; here t = sin θ, so that (δ − δ_r)/(δ_m − δ_r) = 1 − cos θ |
///
/// The elastic energy is 8 p_0² a_m³/(3E*) = (4/(3π)) F_m (δ_m − δ_r): that of a power law with n = 3π/4 − 1.
/// F(t) is the stack of flat punches of radii up to a; its second term is t √(1 − t²) (public code has t √(1 − t)).
///
/// Loading has no elastic regime. Below x of about 16 (steel) the residual indentation would be negative, and the law has no
/// answer. Its authors state it for full plasticity: E* a/(σ_Y R) ≥ 50 for loading, and ≥ 30 for uniform pressure.
///
/// Mesarovic and Johnson (2000), J. Mech. Phys. Solids 48, 2009; loading as Storåkers et al. (1997), Int. J. Solids
/// Struct. 34, 3061.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MesarovicJohnson {
    /// c².
    pub area_factor: f64,
}

impl Default for MesarovicJohnson {
    fn default() -> Self {
        Self { area_factor: 1.43 }
    }
}

impl ContactLaw for MesarovicJohnson {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let factor = self.area_factor;
        let curve = LoadingCurve::linear(bodies.slope_at_pressure(factor, 6.0));
        let mut loading = Loading::new(curve, 0.0, move |x, _| (2.0 * factor * x).sqrt());
        // a/a_Y of E* a/(σ_Y R) = 50
        let plastic = 50.0 * bodies.yield_strain() / bodies.yield_radius_ratio();
        loading.limits.fitted_range = Some((plastic * plastic / (2.0 * factor), f64::INFINITY));
        let recovery = |peak: LoadedState| Recovery {
            // 2F/(πE* a) in units of δ_Y; 3F/(4E* a) is f/(a/a_Y)
            elastic_approach: 8.0 / (3.0 * PI) * peak.force / peak.contact_radius,
            shape: UnloadingShape::Curve(UnloadingCurveKind::UniformPressure),
        };
        LawParts::new(loading, Arc::new(recovery))
    }
}
