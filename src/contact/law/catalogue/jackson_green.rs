//! Jackson and Green (2005) loading, Jackson, Chusoipin and Green (2005) residual indentation.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::published::{LawParts, Loading, hertz_unloading, intersection};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::functions::{cos, exp, pow};
use crate::strings::names::named_enum;

/// The law of Jackson and Green.
///
/// ```text
/// loading    f = x^1.5                                                             x ≤ 1.9
///            f = exp(−x^(5/12)/4) x^1.5 + (4 H_G/(C σ_Y)) (1 − exp(−x^(5/9)/25)) x
///            a²/a_y² = x (x/1.9)^B,   B = 0.14 exp(23 σ_Y/E*)
///            H_G/σ_Y = 2.84 (1 − exp(−0.82 (a/R)^−0.7))                            2005
///                    = 2.84 − 0.92 (1 − cos(π a/R))                                later form
/// unloading  δ_r/δ_m = 1.02 (1 − ((x_m + 5.9)/6.9)^−0.54), Hertz-type in between
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | C | `yield_factor` | 1 | 1.295 exp(0.736 ν) if not given: x, f in units of the yield point by this C, not C_ν |
/// | H_G | `hardness` | Pa | average contact pressure of full plasticity, which falls with a/R |
/// | a, R | | m | contact radius, sphere radius |
/// | x_m | | 1 | δ_m/δ_y |
///
/// The printed pieces do not meet at x = 1.9: there the fit is 0.5 % above Hertz for ν = 0.3, and 3.1 % below for ν = 0.49.
/// Here Hertz continues to where the fit falls below Hertz: x = 2.0 for ν = 0.3, 1.825 for 0.34, 1.586 for 0.40, 1.412 for 0.45,
/// 1.287 for 0.49 (σ_Y/E* = 0.002). From the printed force this differs by those 0.5 to 3.1 % at most. For a given C above
/// about 2 the pieces would meet before first yield, and for one below about 0.3 perhaps beyond the range of the fit: then the
/// law has no answer beyond first yield.
/// The residual indentation would exceed δ_m from x_m = 10⁴ on, and the fits have no meaning beyond a = R or σ_Y/E* = 0.05:
/// there the law has no answer. Fitted for a/R ≤ 0.412 and σ_Y/E* from 0.00105 to 0.0081, a deformable sphere on a rigid flat.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct JacksonGreen {
    /// C; `None`: 1.295 exp(0.736 ν).
    pub yield_factor: Option<f64>,
    /// Which form of H_G.
    pub hardness: HardnessFit,
}

named_enum! {
    /// How H_G falls with a/R.
    #[derive(Default)]
    pub enum HardnessFit {
        /// Jackson and Green 2005.
        #[default]
        Exponential = "exponential",
        /// The later form with a cosine.
        Cosine = "cosine",
    }
}

const TRANSITION: f64 = 1.9;
/// a/R of the fit's data.
const FITTED_RADIUS: f64 = 0.412;
/// σ_Y/E* beyond which nothing of the fit is left.
const MAX_YIELD_STRAIN: f64 = 0.05;

/// δ_r/δ_m at x_m ≥ 1.
fn residual_ratio(x: f64) -> f64 {
    1.02 * (1.0 - pow((x + 5.9) / 6.9, -0.54))
}

impl ContactLaw for JacksonGreen {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let factor = self.yield_factor.unwrap_or(1.295 * exp(0.736 * bodies.yield_point.poissons_ratio));
        let (s, strain) = (bodies.yield_indentation_ratio(factor), bodies.yield_strain());
        // a/R = π C σ_Y/(2E*) x^½ (x/1.9)^(B/2), in units of the law
        let b = 0.14 * exp(23.0 * strain);
        let unit = FRAC_PI_2 * factor * strain * pow(TRANSITION, -0.5 * b);
        let is_cosine = self.hardness == HardnessFit::Cosine;
        let fit = move |x: f64| {
            let x = x / s;
            let ratio = unit * pow(x, 0.5 * (1.0 + b));
            let hardness = if is_cosine {
                2.84 - 0.92 * (1.0 - cos(PI * ratio))
            } else {
                2.84 * (1.0 - exp(-0.82 * pow(ratio, -0.7)))
            };
            let elastic = exp(-0.25 * pow(x, 5.0 / 12.0)) * x * x.sqrt();
            let plastic = 4.0 / factor * hardness * (1.0 - exp(-0.04 * pow(x, 5.0 / 9.0))) * x;
            (elastic + plastic) * (s * s.sqrt())
        };
        // a = R
        let end = pow(1.0 / unit, 2.0 / (1.0 + b));
        let excess = |x: f64| fit(s * x) - pow(s * x, 1.5);
        // from the printed limit, or from first yield if the fit has fallen below Hertz before that limit
        let starts = intersection(excess, TRANSITION, end).or_else(|| intersection(excess, 1.0, TRANSITION));
        let starts = starts.filter(|starts| strain <= MAX_YIELD_STRAIN && end > 2.0 * starts);
        let curve = starts.map_or_else(LoadingCurve::hertz, |starts| {
            // beyond a = R, where the law is refused, only so that the impact ends somewhere
            LoadingCurve::hertz().then_fitted(starts * s, end * s, 0.0, fit).then_tangent(end * s)
        });
        let from = pow(TRANSITION, -b);
        let mut loading = Loading::new(curve, s, move |x, _| {
            let own = x / s;
            if own <= TRANSITION { x.sqrt() } else { (x * from * pow(own, b)).sqrt() }
        });
        loading.limits.max_indentation = if starts.is_some() { end * s } else { s };
        loading.limits.max_radius_ratio = FITTED_RADIUS;
        let recovered = move |x: f64| x * (1.0 - residual_ratio((x / s).max(1.0)));
        LawParts::new(loading, hertz_unloading(move |peak| recovered(peak.indentation)))
    }
}
