//! Brake (2015): unloading only.

use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawError, LawParts, hertz_unloading};

/// The unloading of Brake.
///
/// ```text
/// δ_r = δ_m (1 − F_m/((4/3) E* √R δ_m^1.5)),   F = (4/3) E* √R_e (δ − δ_r)^1.5,   R_e = F_m²/(((4/3) E*)² (δ_m − δ_r)³)
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | δ_m, F_m | `indentation`, `force` | m, N | peak |
/// | δ_m − δ_r | `elastic_approach` | m | δ_m F_m/F_Hertz(δ_m): ε = f/√x |
///
/// It was made for Brake's own loading law, which is not public in full. With the loading of Jackson and Green it leaves far
/// smaller dents than finite elements do. Name a loading under `[law.combined]`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Brake;

impl ContactLaw for Brake {
    fn build_parts(&self, _: &YieldingPair) -> LawParts {
        let loading = Err(LawError::Incomplete { name: "brake" });
        LawParts { loading, recovery: hertz_unloading(|peak| peak.force / peak.indentation.sqrt()) }
    }
}
