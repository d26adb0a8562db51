//! Yigit and Christoforou (1994): the ancestor of MYC (2012) and CYM (2013), whose own equations are not public.

use std::sync::Arc;

use crate::contact::law::UnloadingShape;
use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawParts, LoadedState, Loading, Recovery};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::curve::unloading_curve::UnloadingCurveKind;
use crate::numerics::functions::cbrt;

/// The law of Yigit and Christoforou.
///
/// ```text
/// loading    F = K_h α^1.5                                        α ≤ α_y
///            F = K_h α_y^1.5 + K_y (α − α_y),  K_y = 1.5 K_h √α_y   beyond
/// unloading  F = F_m − K_h (α_m^1.5 − α^1.5)
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | K_h | | N/m^1.5 | (4/3) E* √R |
/// | α_y | | m | C² (π σ_Y/2E*)² R; 0.68 π² σ_Y² R/E*² by the authors |
/// | C | `yield_factor` | 1 | 2 √0.68 = 1.649 if not given |
///
/// The unloading curve is Hertz's, moved down: it leaves δ_r = (δ_m^1.5 − F_m/K_h)^(2/3). Where loading is stiffer than Hertz
/// (behind another loading law) there is no such depth, and the law has no answer.
///
/// From memory: the form is consistent, but no text of it could be opened. Not MYC 2012 and not CYM 2013, whose unloading
/// may have other terms.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct YigitChristoforou {
    /// C; `None`: 2 √0.68.
    pub yield_factor: Option<f64>,
}

impl ContactLaw for YigitChristoforou {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let yields = bodies.yield_indentation_ratio(self.yield_factor.unwrap_or(2.0 * 0.68_f64.sqrt()));
        let recovery = Arc::new(|peak: LoadedState| {
            let x = peak.indentation;
            // where there is no such depth, twice the indentation: more than any law may give back
            let hertz = x * x.sqrt();
            let below = hertz - peak.force;
            let elastic_approach = if below.abs() <= 8.0 * f64::EPSILON * hertz {
                // on Hertz's curve but for rounding, whose 2/3 power would be a dent
                x
            } else if below > 0.0 {
                x - cbrt(below) * cbrt(below)
            } else {
                2.0 * x
            };
            Recovery { elastic_approach, shape: UnloadingShape::Curve(UnloadingCurveKind::ShiftedHertz) }
        });
        LawParts::new(Loading::new(LoadingCurve::hertz().then_tangent(yields), yields, |x, _| x.sqrt()), recovery)
    }
}
