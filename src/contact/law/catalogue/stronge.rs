//! Stronge (2000), Impact Mechanics: yield at a mean pressure, logarithmic growth of the pressure to full plasticity.

use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawParts, Loading, hertz_unloading};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::functions::{ln, pow};

/// The law of Stronge.
///
/// ```text
/// loading    f = x^1.5                                 x ≤ 1
///            f = (2x − 1)(1 + ln(2x − 1)/(3ϑ))         1 < x < 84,    a²/a_y² = 2x − 1
///            f = (2x − 1)(1 + ln 167/(3ϑ))             x ≥ 84
/// unloading  Hertz-type, f_u δ_y/R = (δ_m − δ_r)/R_e,  so that δ_m − δ_r = δ_y f_u^¼ √(F_m/F_y)
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | ϑ | `yield_pressure_ratio` | 1 | mean contact pressure at yield over σ_Y; 1.1 |
/// | f_u | `unloading_factor` | 1 | 1 by Stronge; Dong (2018) fits it, his fit is not public |
/// | x, f | | 1 | δ/δ_y, F/F_y of Stronge's own yield point, where the mean Hertz pressure is ϑ σ_Y (C = 1.5 ϑ) |
///
/// Full plasticity is where the mean pressure reaches about 2.8 σ_Y: 2.806 σ_Y at x = 84 for ϑ = 1.1. The law keeps that
/// pressure, so that the force does not jump (with exactly 2.8 σ_Y it would fall by 0.2 %). Texts that quote the law write the
/// factor of the last line as 2.55; here it is 1 + ln 167/(3ϑ) = 2.5509 for ϑ = 1.1, by continuity at x = 84.
///
/// Just above yield loading and unloading do not fit together: the force grows with twice Hertz's slope, and the unloading
/// gives back up to 17 % more energy than the loading takes. Between δ/δ_Y of about 1.1 and 2.5 (ν = 0.3) the law has no answer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stronge {
    /// ϑ.
    pub yield_pressure_ratio: f64,
    /// f_u.
    pub unloading_factor: f64,
}

impl Default for Stronge {
    fn default() -> Self {
        Self { yield_pressure_ratio: 1.1, unloading_factor: 1.0 }
    }
}

/// x of full plasticity.
const FULLY_PLASTIC: f64 = 84.0;

impl ContactLaw for Stronge {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let theta = self.yield_pressure_ratio;
        let s = bodies.yield_indentation_ratio(1.5 * theta);
        let (unit, end) = (s * s.sqrt(), FULLY_PLASTIC * s);
        let pressure = |area: f64| 1.0 + ln(area) / (3.0 * theta);
        let middle = |x: f64| {
            let area = 2.0 * x / s - 1.0;
            unit * area * pressure(area)
        };
        let curve = LoadingCurve::hertz()
            .then_fitted(s, end, 0.5 * s, middle)
            .then_line(end, 2.0 * s.sqrt() * pressure(2.0 * FULLY_PLASTIC - 1.0));
        let factor = s * pow(self.unloading_factor, 0.25);
        let recovery = hertz_unloading(move |peak| factor * (peak.force / unit).sqrt());
        LawParts::new(Loading::new(curve, s, move |x, _| (2.0 * x - s).sqrt()), recovery)
    }
}
