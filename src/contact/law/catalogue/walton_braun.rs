//! Walton and Braun (1986), Luding (2008): two straight lines.

use std::sync::Arc;

use crate::contact::law::UnloadingShape;
use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawParts, Loading, Recovery};
use crate::numerics::curve::LoadingCurve;

/// The hysteretic spring.
///
/// ```text
/// loading    F = k_1 δ
/// unloading  F = k_2 (δ − δ_0),   δ_0 = (1 − k_1/k_2) δ_m,   e = √(k_1/k_2)
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | k_1 | `loading_stiffness` × F_Y/δ_Y | N/m | 1 if not given: the secant of Hertz at first yield |
/// | k_1/k_2 | `stiffness_ratio` | 1 | 0 < k_1/k_2 ≤ 1; 0.5 if not given |
///
/// e is the same at all speeds: there is no elastic regime. Both stiffnesses are fitted, none follows from the materials.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WaltonBraun {
    /// k_1 δ_Y/F_Y.
    pub loading_stiffness: f64,
    /// k_1/k_2.
    pub stiffness_ratio: f64,
}

impl Default for WaltonBraun {
    fn default() -> Self {
        Self { loading_stiffness: 1.0, stiffness_ratio: 0.5 }
    }
}

impl ContactLaw for WaltonBraun {
    fn build_parts(&self, _: &YieldingPair) -> LawParts {
        let mut loading = Loading::new(LoadingCurve::linear(self.loading_stiffness), 0.0, |x, _| x.sqrt());
        // a spring has no geometry
        loading.limits.max_radius_ratio = f64::INFINITY;
        let k2 = self.loading_stiffness / self.stiffness_ratio;
        let shape = UnloadingShape::Power(1.0);
        LawParts::new(loading, Arc::new(move |peak| Recovery { elastic_approach: peak.force / k2, shape }))
    }
}
