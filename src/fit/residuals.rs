//! The residuals that the fit minimises: deviations of ln F and ln ε, with weights uniform in ln x, and any rise of e
//! with x.

use nalgebra::DVector;

use super::curve::LoadingCurve;
use super::parameters::decode;
use crate::law::{Law, PlmCoefficients, UnloadingExponent};
use crate::math::functions::{exp, ln, tanh};

/// Points along each curve where e is computed.
const RESTITUTION_POINTS: u32 = 150;
/// Rise of ln e that is not penalised. The law has straight pieces, and after a knot they let e rise by about this
/// much.
const ALLOWED_RISE: f64 = 3e-4;
/// Weight of a larger rise, relative to a deviation of the curve of the same size.
const RISE_WEIGHT: f64 = 1.0;
/// Weight of a change of ln coefficient. It is so small that it acts only on coefficients that no curve determines.
/// These keep their start values.
const STAY_WEIGHT: f64 = 1e-5;
/// Largest change of ln coefficient: a factor of 20.
const REACH: f64 = 3.0;

/// The least-squares problem.
pub(super) struct Residuals<'a> {
    pub curves: &'a [&'a LoadingCurve],
    pub form: &'a PlmCoefficients,
    pub has_knots: bool,
    /// The numbers of `form`.
    pub start: DVector<f64>,
}

impl Residuals<'_> {
    /// The fit varies numbers without bounds. tanh maps them to coefficients within a factor of 20 of the start, so
    /// that every step gives a law that can be evaluated.
    pub(super) fn table_at(&self, numbers: &DVector<f64>) -> PlmCoefficients {
        let bounded = numbers.zip_map(&self.start, |number, start| start + REACH * tanh((number - start) / REACH));
        decode(&bounded, self.form, self.has_knots)
    }

    pub(super) fn at(&self, numbers: &DVector<f64>) -> Vec<f64> {
        let table = self.table_at(numbers);
        let mut residuals = Vec::new();
        for curve in self.curves {
            let law = table.law(&curve.pair, curve.yield_radius_ratio, UnloadingExponent::Paper);
            residuals.extend(deviations(curve, &law).flat_map(|deviation| {
                let root = deviation.weight.sqrt();
                [root * deviation.force, root * deviation.approach]
            }));
            residuals.extend(rises(&law, curve).map(|rise| RISE_WEIGHT * (rise - ALLOWED_RISE).max(0.0)));
        }
        residuals.extend((numbers - &self.start).iter().map(|change| STAY_WEIGHT * change));
        residuals
    }
}

/// Deviation of the law from one point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Deviation {
    /// Share of the range of ln x that the point has. The weights of a curve sum to 1.
    pub weight: f64,
    /// ln f of the law − ln f of the point.
    pub force: f64,
    /// ln ε of the law − ln ε of the point.
    pub approach: f64,
    /// ln a of the law − ln a of the point, if the curve has the contact radius.
    pub radius: Option<f64>,
}

/// Deviations at all points from first yield on. Before first yield the law is that of Hertz and has no coefficients.
pub(super) fn deviations(curve: &LoadingCurve, law: &Law) -> impl Iterator<Item = Deviation> {
    let plastic = || curve.points.iter().zip(curve.log_weights()).filter(|(point, _)| point.indentation >= 1.0);
    let total: f64 = plastic().map(|(_, weight)| weight).sum();
    plastic().map(move |(point, weight)| {
        let peak = law.loaded_to(point.indentation);
        Deviation {
            weight: weight / total,
            force: ln(peak.force / point.force),
            approach: ln(peak.elastic_approach / point.elastic_approach),
            radius: point.contact_radius.map(|radius| ln(law.contact_radius(&peak) / radius)),
        }
    })
}

/// By how much ln e is above its smallest value at lower indentations. It is evaluated up to 1.5 times the last
/// indentation of the curve.
pub(super) fn rises(law: &Law, curve: &LoadingCurve) -> impl Iterator<Item = f64> {
    let last = curve.points.last().map_or(1.0, |point| point.indentation);
    let range = ln(1.5 * last);
    let mut least = 0.0_f64;
    (1..=RESTITUTION_POINTS).map(move |i| {
        let x = exp(range * f64::from(i) / f64::from(RESTITUTION_POINTS));
        let ln_restitution = 0.5 * ln(law.unloading(law.loaded_to(x)).stored(x) / law.loading.work(x));
        least = least.min(ln_restitution);
        ln_restitution - least
    })
}
