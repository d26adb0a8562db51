//! Kogut and Komvopoulos (2004): indentation of an elastic-perfectly plastic half-space by a rigid sphere.

use crate::contact::law::contact_law::{ContactLaw, YieldingPair};
use crate::contact::law::plm::Plm;
use crate::contact::law::published::{LawParts, Loading, intersection};
use crate::numerics::curve::LoadingCurve;
use crate::numerics::functions::{ln, pow};

/// The loading of Kogut and Komvopoulos, with the unloading of Xie et al. (2024).
///
/// ```text
/// r'² = 2R δ − δ²,   s = E* δ/(σ_Y r')
/// s < 1.78       elastic
/// 1.78 ≤ s ≤ 21  p_m/σ_Y = 0.70 ln s + 0.66,   π r'²/A = 2.193 − 0.394 ln s
/// s > 21         p_m/σ_Y = 2.9,                A = π r'²
/// F = p_m A
/// ```
///
/// | symbol | here | unit | meaning |
/// |---|---|---|---|
/// | r' | | m | radius of the cut of sphere and undeformed surface |
/// | s | | 1 | 1.792 at Hertz's first yield for ν = 0.3 |
/// | p_m, A | | Pa, m² | mean pressure, contact area |
///
/// The printed pieces do not meet: the fit begins where Hertz reaches s = 1.78 (x = 0.987 for ν = 0.3) with a force 1.3 % above
/// Hertz's, and at s = 21 the next piece is 3.2 % higher (pressure +3.9 %, area −0.7 %). Here each piece continues until the next
/// one falls below it: x = 1.16, and s = 22. From the printed force this differs by those 3.2 % at most. Where yield is so deep
/// (σ_Y/E* above about 0.07) that the fit begins below Hertz, nothing crosses and the law has no answer beyond yield.
/// Beyond δ = R/2 the cut of the sphere no longer grows like a contact: there the law has no answer.
///
/// **Its own unloading is not public** (a fit of δ_r to δ_m and E*/σ_Y). Here it unloads by the paper's law with the elastic
/// approach that the PLM has at the same force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct KogutKomvopoulos;

const ELASTIC_LIMIT: f64 = 1.78;
const PLASTIC_LIMIT: f64 = 21.0;

impl ContactLaw for KogutKomvopoulos {
    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let (ratio, stiffness) = (bodies.yield_radius_ratio(), 1.0 / bodies.yield_strain());
        let depth = ratio * ratio;
        // σ_Y π R δ_Y/F_Y, as F_Y = (2/3) π C σ_Y R δ_Y
        let unit = 1.5 / bodies.yield_point.factor;
        // r'²/(R δ_Y) and s
        let cut = move |x: f64| x * (2.0 - depth * x);
        let strain = move |x: f64| stiffness * ratio * x / cut(x).sqrt();
        let mixed = move |x: f64| {
            let logarithm = ln(strain(x));
            (0.70 * logarithm + 0.66) * cut(x) / (2.193 - 0.394 * logarithm) * unit
        };
        let fully = move |x: f64| 2.9 * unit * cut(x);
        // x where s has this value: s² = (E*/σ_Y)² (δ_Y/R) x/(2 − x δ_Y/R)
        let reaches = |s: f64| {
            let per = s * s / (stiffness * stiffness * depth);
            2.0 * per / (1.0 + depth * per)
        };
        let (yields, plastic, end) = (reaches(ELASTIC_LIMIT), reaches(PLASTIC_LIMIT), 0.5 / depth);
        // the fit begins above Hertz, and the fully plastic force above the fit
        let first = intersection(|x| mixed(x) - pow(x, 1.5), yields, 2.0 * yields);
        let second = intersection(|x| fully(x) - mixed(x), plastic, 2.0 * plastic);
        let starts = first.zip(second);
        let mut curve = LoadingCurve::hertz();
        if let Some((first, second)) = starts.filter(|(first, _)| *first < end) {
            curve = curve.then_fitted(first, second.min(end), 0.0, mixed);
            if second < end {
                curve = curve.then_fitted(second, end, 0.0, fully);
            }
            curve = curve.then_tangent(end);
        }
        let mut loading = Loading::new(curve, yields, move |x, _| {
            let square = cut(x.min(end));
            let ratio = if x <= plastic { 2.193 - 0.394 * ln(strain(x)) } else { 1.0 };
            (square / ratio).sqrt()
        });
        loading.limits.max_indentation = if starts.is_some() { end } else { yields };
        LawParts::new(loading, Plm::default().build_parts(bodies).recovery)
    }
}
