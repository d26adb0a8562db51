//! Checks of the radius of curvature of the dent: Eq. 25 with the peak of the finite elements, against circles fitted
//! to the dents of the finite elements.

use super::ValidationError;
use super::cases::cases;
use super::check::{Check, Tolerance};
use crate::law::{Peak, PlmCoefficients};
use crate::reference::STATIC;

/// Largest error of Table 2 of the paper.
const TABLE_2: f64 = 0.0139;
const MARGIN: f64 = 0.002;

/// Residual radius of the dent, R_res/R = R_e/(R_e − R) (Eqs. 24-25).
pub(super) fn residual_radius(peak: &Peak) -> f64 {
    let ratio = peak.unloading_radius_ratio();
    ratio / (ratio - 1.0)
}

pub(super) fn checks(_: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let cases = cases()?;
    let resolved = cases.iter().flat_map(|case| &case.cycles).filter(|cycle| cycle.is_resolved());
    Ok(resolved
        .map(|cycle| {
            let (whole, inner) = (cycle.row.residual_radius, cycle.row.inner_residual_radius);
            // if the dent is not a circle, the fitted radius depends on the range of the fit
            let tolerance = Tolerance {
                limit: TABLE_2 + MARGIN + (inner / whole - 1.0).abs(),
                source: "Xie et al. 2024, Table 2: 1.39 %, margin 0.2 %, and the difference of fits within a and 0.7 a",
            };
            let numbers = [whole, residual_radius(&cycle.peak)];
            let quantity = "unloading: residual radius from the reference's peak (Eq. 25)";
            Check::numbers(quantity, cycle.name(), STATIC, "R", numbers, tolerance)
        })
        .collect())
}
