//! Checks of unloading from the peak of the finite elements: depth of the dent, and force during unloading.

use super::cases::{Case, Cycle, cases};
use super::check::{Check, Tolerance};
use super::{EXPONENTS, ValidationError};
use crate::law::{Peak, PlmCoefficients, Unloading, UnloadingExponent};
use crate::reference::STATIC;

const SHALLOW: Tolerance = Tolerance { limit: 0.03, source: "Xie et al. 2024, Fig. 6: 3 % from 3 delta_Y on" };
const DEEP: Tolerance = Tolerance { limit: 0.02, source: "Xie et al. 2024, Fig. 6: 2 % from 6 delta_Y on" };
const FORCE: Tolerance = Tolerance { limit: 0.052, source: "documented 5 % of the peak force, margin 0.2 %" };

/// The unloading branch of the law with peak and dent of the finite elements, so that only the shape is compared.
pub(super) fn branch(
    case: &Case,
    cycle: &Cycle,
    coefficients: &PlmCoefficients,
    exponent: UnloadingExponent,
) -> Unloading {
    let law = case.law(coefficients, exponent);
    let exponent = law.unloading(cycle.peak).exponent;
    let elastic_approach = cycle.row.x - cycle.residual();
    Unloading::power(Peak { elastic_approach, ..cycle.peak }, exponent)
}

/// The point with the largest deviation of the force: x, and the expected and the computed force over the peak force.
pub(super) fn farthest(cycle: &Cycle, branch: &Unloading) -> Option<(f64, [f64; 2])> {
    let of_peak = |force: f64| force / cycle.row.f;
    let pairs = cycle.points.iter().map(|[x, f, _]| (*x, [of_peak(*f), of_peak(branch.force(*x))]));
    pairs.max_by(|(_, a), (_, b)| (a[1] - a[0]).abs().total_cmp(&(b[1] - b[0]).abs()))
}

pub(super) fn checks(coefficients: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let cases = cases()?;
    let mut checks = Vec::new();
    let cycles = || cases.iter().flat_map(|case| case.cycles.iter().map(move |cycle| (case, cycle)));
    for (_, cycle) in cycles() {
        let numbers = [cycle.residual(), cycle.peak.residual()];
        let tolerance = if cycle.row.x < 6.0 { SHALLOW } else { DEEP };
        let quantity = "unloading: residual indentation from the reference's peak (Eq. 23)";
        checks.push(Check::numbers(quantity, cycle.name(), STATIC, "delta_Y", numbers, tolerance));
    }
    for (exponent, name) in EXPONENTS {
        let quantity = format!("unloading: force, largest deviation over peak force, {name}");
        for (case, cycle) in cycles() {
            if let Some((x, numbers)) = farthest(cycle, &branch(case, cycle, coefficients, exponent)) {
                let at = format!("{}, at x = {}", cycle.name(), crate::units::rounded::number(x));
                checks.push(Check::numbers(&quantity, at, STATIC, "F_m", numbers, FORCE).of_difference());
            }
        }
    }
    Ok(checks)
}
