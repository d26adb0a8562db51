//! Johnson (1985): rigid-plastic loading, Hertz rebound.

use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawParts, Loading, hertz_unloading};
use crate::numerics::curve::LoadingCurve;

/// The impact of Johnson, with its closed-form restitution.
///
/// ```text
/// loading    F = π a² p_d,   a² = 2R δ
/// unloading  Hertz-type from the contact radius a_m: δ_m − δ_r = 3 F_m/(4E* a_m)
/// e² = (3 π^(5/4) 4^(3/4)/10) (p_d/E*) (m v²/(2 p_d R³))^(−1/4)
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | p_d | `dynamic_pressure` | Pa | mean pressure of the dent; 3 σ_Y if not given |
///
/// There is no elastic regime. Near yield, below x of about 15 for steel, the rebound would be deeper than the indentation and
/// e above 1: there the law has no answer. Combined with the loading of another law, the unloading takes a_m of that loading.
///
/// Johnson (1985), Contact Mechanics, Cambridge University Press, ch. 11.5; the coefficient 3.549 follows from the two lines
/// above.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Johnson {
    /// p_d \[Pa\]; `None`: 3 σ_Y.
    pub dynamic_pressure: Option<f64>,
}

impl ContactLaw for Johnson {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let pressure = self.dynamic_pressure.map_or(3.0, |pressure| pressure / bodies.yield_point.strength);
        let slope = bodies.slope_at_pressure(2.0, pressure);
        let loading = Loading::new(LoadingCurve::linear(slope), 0.0, |x, _| (2.0 * x).sqrt());
        LawParts::new(loading, hertz_unloading(|peak| peak.force / peak.contact_radius))
    }
}
