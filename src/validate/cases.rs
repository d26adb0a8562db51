//! The five pairs of materials (cases) of the quasi-static finite elements, each with its loading curve and its unloadings.
//!
//! Everything is in units of first yield: x is the indentation and f the force.

use crate::contact::law::{ContactState, Law, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::reference::loading;
use crate::reference::loading::ReferenceLoadingCurve;
use crate::reference::{CURVES_OF_UNLOADINGS, ReferenceRow, UNLOADINGS};

/// One of the five pairs of materials.
#[derive(Debug, Clone)]
pub struct MaterialCase {
    pub loading: ReferenceLoadingCurve,
    /// The unloadings, in the order of rising depth.
    pub cycles: Vec<Cycle>,
}

/// A full unloading from one peak.
#[derive(Debug, Clone)]
pub struct Cycle {
    /// The results of the finite elements.
    pub row: ReferenceRow,
    /// The peak of the finite elements: x_m, f_m and the recovered approach ε_m = x_s,m/κ, with the indentation x_s,m of the sphere.
    pub peak: ContactState,
    /// x and f at points between peak and separation.
    pub points: Vec<(f64, f64)>,
}

impl Cycle {
    /// The name, such as "case3_small, x = 105.1".
    pub fn name(&self) -> String {
        format!("{}, x = {}", self.row.cell_text("run"), crate::units::format_four_digits(self.peak.indentation))
    }

    /// Residual indentation x_r of the finite elements.
    pub fn residual(&self) -> f64 {
        self.row.number("residual_share") * self.peak.indentation
    }
}

impl MaterialCase {
    /// The name, such as "case 3".
    pub fn name(&self) -> String {
        self.loading.case.replace("case", "case ")
    }

    /// The law of these two materials.
    pub fn law(&self, coefficients: &PlmCoefficients, exponent: UnloadingExponent) -> Law {
        coefficients.law(&self.loading.pair, self.loading.yield_radius_ratio, exponent)
    }

    /// κ, the share of the sphere in the elastic compliance.
    pub fn sphere_compliance(&self) -> f64 {
        self.loading.pair.sphere_compliance
    }
}

pub fn cases() -> Result<Vec<MaterialCase>, Error> {
    let (rows, points) = (UNLOADINGS.rows()?, CURVES_OF_UNLOADINGS.rows()?);
    let cycle = |row: &ReferenceRow, kappa: f64| {
        let is_same = |point: &&ReferenceRow| {
            ["run", "cycle"].iter().all(|column| point.cell_text(column) == row.cell_text(column))
        };
        let point = |row: &ReferenceRow| (row.number("x"), row.number("f"));
        let (indentation, force) = point(row);
        let elastic_approach = indentation * row.number("sphere_share") / kappa;
        Cycle {
            peak: ContactState { indentation, force, elastic_approach },
            points: points.iter().filter(is_same).map(point).collect(),
            row: row.clone(),
        }
    };
    let case = |loading: ReferenceLoadingCurve| {
        let of_case = rows.iter().filter(|row| row.cell_text("case") == loading.case);
        let mut cycles: Vec<Cycle> = of_case.map(|row| cycle(row, loading.pair.sphere_compliance)).collect();
        cycles.sort_by(|a, b| a.peak.indentation.total_cmp(&b.peak.indentation));
        MaterialCase { loading, cycles }
    };
    Ok(loading::curves()?.into_iter().map(case).collect())
}
