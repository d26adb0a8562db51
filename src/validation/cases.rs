//! The five pairs of materials of the quasi-static finite elements, each with its loading curve and its unloadings.

use super::ValidationError;
use crate::fit::{LoadingCurve, LoadingPoint};
use crate::law::{Law, Peak, PlmCoefficients, UnloadingExponent};
use crate::math::functions::ln;
use crate::reference::{LOADING, unloading};

/// Smallest number of elements across the contact radius for which the shape of the dent is compared.
const RESOLVED: f64 = 10.0;

/// One of the five pairs of materials: loading curve and unloadings.
#[derive(Debug, Clone)]
pub struct Case {
    /// The name, such as "case 3".
    pub name: &'static str,
    /// The loading curve.
    pub loading: LoadingCurve,
    /// The unloadings, in the order of rising depth.
    pub cycles: Vec<Cycle>,
}

/// A full unloading from one peak.
#[derive(Debug, Clone)]
pub struct Cycle {
    /// Name of the run.
    pub run: String,
    /// Number of the unloading in the run, counted from 1.
    pub number: u32,
    /// Number of elements across the contact radius at the peak.
    pub elements: f64,
    /// The peak of the finite elements: x_m, f_m and ε_m = x_s,m/κ.
    pub peak: Peak,
    /// Contact radius at the peak, a_m/R.
    pub contact_radius: f64,
    /// Residual indentation x_r of the finite elements.
    pub residual: f64,
    /// Restitution √(recovered/spent work); `None` if the loading curve does not reach back to first yield.
    pub restitution: Option<f64>,
    /// Residual radius R_res/R, fitted within the contact radius and within 0.7 of it.
    pub residual_radii: [f64; 2],
    /// x, f and x_s at points between peak and separation.
    pub points: Vec<[f64; 3]>,
    /// Points r/R and z/R of the surface after unloading. Only a few unloadings have them.
    pub dent: Vec<[f64; 2]>,
}

impl Cycle {
    /// The name, such as "case3_small, x = 105.1".
    pub fn name(&self) -> String {
        format!("{}, x = {}", self.run, crate::units::rounded::number(self.peak.indentation))
    }

    /// Whether there are enough elements to compare the shape of the dent.
    pub fn is_resolved(&self) -> bool {
        self.elements >= RESOLVED
    }
}

impl Case {
    /// The law of this pair.
    pub fn law(&self, coefficients: &PlmCoefficients, exponent: UnloadingExponent) -> Law {
        coefficients.law(&self.loading.pair, self.loading.yield_radius_ratio, exponent)
    }

    /// Sphere compliance κ.
    pub fn sphere_compliance(&self) -> f64 {
        self.loading.pair.sphere_compliance
    }

    /// Points of the loading curve from first yield on.
    pub fn plastic(&self) -> impl Iterator<Item = &LoadingPoint> {
        self.loading.points.iter().filter(|point| point.indentation >= 1.0)
    }

    /// The unloadings, without those for which another unloading at nearly the same depth has more elements.
    pub fn distinct_cycles(&self) -> Vec<&Cycle> {
        let is_near = |a: &Cycle, b: &Cycle| ln(a.peak.indentation / b.peak.indentation).abs() < 0.1;
        let has_better = |one: &&Cycle| {
            let mut others = self.cycles.iter().filter(|other| !std::ptr::eq(*one, *other));
            others.any(|other| is_near(one, other) && other.elements > one.elements)
        };
        self.cycles.iter().filter(|one| !has_better(one)).collect()
    }
}

/// The five cases.
///
/// # Errors
/// [`ValidationError::Reference`] or [`ValidationError::Curve`] if a table is damaged.
pub fn cases() -> Result<Vec<Case>, ValidationError> {
    let (cycles, curves, dents) = (unloading::unloadings()?, unloading::points()?, unloading::dents()?);
    LOADING
        .iter()
        .map(|&(name, text)| {
            let loading = LoadingCurve::parse(name, text)?;
            let kappa = loading.pair.sphere_compliance;
            let of_case = cycles.iter().filter(|row| row.case == name.replace(' ', ""));
            let mut cycles: Vec<Cycle> = of_case
                .map(|row| {
                    let is_this = |run: &str, cycle: u32| run == row.run && cycle == row.cycle;
                    let peak =
                        Peak { indentation: row.x, force: row.f, elastic_approach: row.x * row.sphere_share / kappa };
                    Cycle {
                        run: row.run.clone(),
                        number: row.cycle,
                        elements: row.elements,
                        peak,
                        contact_radius: row.contact_radius,
                        residual: row.residual_share * row.x,
                        restitution: row.restitution,
                        residual_radii: [row.residual_radius, row.inner_residual_radius],
                        points: curves
                            .iter()
                            .filter(|point| is_this(&point.run, point.cycle))
                            .map(|point| [point.x, point.f, point.sphere_x])
                            .collect(),
                        dent: dents
                            .iter()
                            .filter(|point| is_this(&point.run, point.cycle))
                            .map(|point| [point.r, point.z])
                            .collect(),
                    }
                })
                .collect();
            cycles.sort_by(|a, b| a.peak.indentation.total_cmp(&b.peak.indentation));
            Ok(Case { name, loading, cycles })
        })
        .collect()
}
