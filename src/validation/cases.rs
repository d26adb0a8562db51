//! The five pairs of materials of the quasi-static finite elements, each with its loading curve and its unloadings.

use crate::error::Error;
use crate::fit::{LoadingCurve, LoadingPoint};
use crate::law::{Law, Peak, PlmCoefficients, UnloadingExponent};
use crate::math::functions::ln;
use crate::reference::LOADING;
use crate::reference::unloading::{self, UnloadingRow};

/// Smallest number of elements across the contact radius for which the shape of the dent is compared.
const RESOLVED: f64 = 10.0;

/// One of the five pairs of materials: loading curve and unloadings.
#[derive(Debug, Clone)]
pub struct Case {
    /// The name, such as "case 3".
    pub name: &'static str,
    pub loading: LoadingCurve,
    /// The unloadings, in the order of rising depth.
    pub cycles: Vec<Cycle>,
}

/// A full unloading from one peak.
#[derive(Debug, Clone)]
pub struct Cycle {
    /// The results of the finite elements.
    pub row: UnloadingRow,
    /// Their peak: x_m, f_m and ε_m = x_s,m/κ.
    pub peak: Peak,
    /// x, f and x_s at points between peak and separation.
    pub points: Vec<[f64; 3]>,
    /// Points r/R and z/R of the surface after unloading. Only a few unloadings have them.
    pub dent: Vec<[f64; 2]>,
}

impl Cycle {
    /// The name, such as "case3_small, x = 105.1".
    pub fn name(&self) -> String {
        format!("{}, x = {}", self.row.run, crate::units::four_digits(self.row.x))
    }

    /// Residual indentation x_r of the finite elements.
    pub fn residual(&self) -> f64 {
        self.row.residual_share * self.row.x
    }

    /// Whether there are enough elements to compare the shape of the dent.
    pub fn is_resolved(&self) -> bool {
        self.row.elements >= RESOLVED
    }
}

impl Case {
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
        let is_near = |a: &Cycle, b: &Cycle| ln(a.row.x / b.row.x).abs() < 0.1;
        let has_better = |one: &&Cycle| {
            let mut others = self.cycles.iter().filter(|other| !std::ptr::eq(*one, *other));
            others.any(|other| is_near(one, other) && other.row.elements > one.row.elements)
        };
        self.cycles.iter().filter(|one| !has_better(one)).collect()
    }
}

/// The five cases.
///
/// # Errors
/// [`Error`] if a table is damaged.
pub fn cases() -> Result<Vec<Case>, Error> {
    let (rows, points, dents) = (unloading::unloadings()?, unloading::points()?, unloading::dents()?);
    let cycle = |row: &UnloadingRow, kappa: f64| {
        let is_this = |run: &str, cycle: u32| run == row.run && cycle == row.cycle;
        let points = points.iter().filter(|point| is_this(&point.run, point.cycle));
        let dent = dents.iter().filter(|point| is_this(&point.run, point.cycle));
        Cycle {
            peak: Peak { indentation: row.x, force: row.f, elastic_approach: row.x * row.sphere_share / kappa },
            points: points.map(|point| [point.x, point.f, point.sphere_x]).collect(),
            dent: dent.map(|point| [point.r, point.z]).collect(),
            row: row.clone(),
        }
    };
    let case = |&(name, text): &(&'static str, &str)| {
        let loading = LoadingCurve::parse(name, text)?;
        let of_case = rows.iter().filter(|row| row.case == name.replace(' ', ""));
        let mut cycles: Vec<Cycle> = of_case.map(|row| cycle(row, loading.pair.sphere_compliance)).collect();
        cycles.sort_by(|a, b| a.row.x.total_cmp(&b.row.x));
        Ok(Case { name, loading, cycles })
    };
    LOADING.iter().map(case).collect()
}
