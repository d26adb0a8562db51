//! Hertz (1882): elastic, whatever the load; as an unloading law, Hertz with the sphere's own radius.

use crate::contact::law::Law;
use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawError, LawParts, Loading, hertz_unloading};
use crate::numerics::curve::LoadingCurve;

use crate::numerics::functions::pow;

/// The elastic contact.
///
/// ```text
/// loading    F = (4/3) E* √R δ^1.5
/// unloading  δ_m − δ_r = (9 F_m²/(16 R E*²))^(1/3),  F as loading with δ − δ_r for δ
/// ```
///
/// | symbol | here | meaning |
/// |---|---|---|
/// | x, f | `indentation`, `force` | δ/δ_Y, F/F_Y: f = x^1.5 |
/// | ε | `elastic_approach` | (δ_m − δ_r)/δ_Y = f^(2/3) |
///
/// The whole law is elastic at any load, e = 1. Combined with the loading of another law, its unloading keeps the radius R of
/// the sphere (Sathuvalli 2016, Procedia Structural Integrity 2, 1771).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Hertz;

impl ContactLaw for Hertz {
    fn build_parts(&self, _: &YieldingPair) -> LawParts {
        let loading = Loading::new(LoadingCurve::hertz(), f64::INFINITY, |x, _| x.sqrt());
        LawParts::new(loading, hertz_unloading(|peak| pow(peak.force, 2.0 / 3.0)))
    }

    fn law(&self, _: &YieldingPair) -> Result<Law, LawError> {
        Ok(Law::hertz())
    }
}
