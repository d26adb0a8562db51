//! Checks of loading: force, indentations of sphere and half-space, and contact radius along the five finite-element
//! curves.

use super::ValidationError;
use super::cases::{Case, cases};
use super::check::{Check, Tolerance, deviation, rms};
use crate::fit::LoadingPoint;
use crate::law::{Law, PlmCoefficients, UnloadingExponent};
use crate::reference::STATIC;

const FORCE: Tolerance = Tolerance { limit: 0.015, source: "documented 1.4 %, margin 0.1 %" };
const LARGEST_FORCE: Tolerance = Tolerance { limit: 0.036, source: "documented 3.5 %, margin 0.1 %" };
const INDENTATION: Tolerance = Tolerance { limit: 0.013, source: "documented 1.2 %, margin 0.1 %" };
const RADIUS: Tolerance = Tolerance { limit: 0.027, source: "documented 2.6 %, margin 0.1 %" };
const LARGEST_RADIUS: Tolerance = Tolerance { limit: 0.053, source: "documented 5 % at every depth, margin 0.3 %" };

/// A quantity along the loading curve, by the law and by the finite elements.
pub(super) struct Quantity {
    pub name: &'static str,
    pub of_law: fn(&Case, &Law, f64) -> f64,
    pub of_point: fn(&Case, &LoadingPoint) -> Option<f64>,
}

/// The quantities that are compared, in units of first yield.
pub(super) const QUANTITIES: [Quantity; 4] = [
    Quantity { name: "force", of_law: |_, law, x| law.loading.force(x), of_point: |_, point| Some(point.force) },
    Quantity {
        name: "sphere indentation",
        of_law: |case, law, x| case.sphere_compliance() * law.loaded_to(x).elastic_approach,
        of_point: |case, point| Some(case.sphere_compliance() * point.elastic_approach),
    },
    Quantity {
        name: "half-space indentation",
        of_law: |case, law, x| x - case.sphere_compliance() * law.loaded_to(x).elastic_approach,
        of_point: |case, point| Some(point.indentation - case.sphere_compliance() * point.elastic_approach),
    },
    Quantity {
        name: "contact radius",
        of_law: |_, law, x| law.contact_radius(&law.loaded_to(x)),
        of_point: |_, point| point.contact_radius,
    },
];

/// x, and the expected and the computed value of a quantity, at all points from first yield on.
pub(super) fn along(case: &Case, law: &Law, quantity: &Quantity) -> Vec<(f64, [f64; 2])> {
    let pair = |point: &LoadingPoint| {
        let expected = (quantity.of_point)(case, point)?;
        Some((point.indentation, [expected, (quantity.of_law)(case, law, point.indentation)]))
    };
    case.plastic().filter_map(pair).collect()
}

/// One check for each curve: the root mean square of the deviations along it.
fn spreads(laws: &[(&Case, Law)], quantity: &Quantity, tolerance: Tolerance) -> Vec<Check> {
    let name = format!("loading: {}, rms over the curve", quantity.name);
    let spread = |(case, law): &(&Case, Law)| {
        let points = along(case, law, quantity);
        let deviations: Vec<f64> = points.iter().map(|(_, [expected, got])| deviation(*expected, *got)).collect();
        let over = format!("{}, {} points", case.name, points.len());
        Check::mean(&name, over, STATIC, rms(&deviations), tolerance)
    };
    laws.iter().map(spread).collect()
}

/// One check for each curve: the largest deviation along it.
fn largest(laws: &[(&Case, Law)], quantity: &Quantity, unit: &'static str, tolerance: Tolerance) -> Vec<Check> {
    let name = format!("loading: {}, largest over the curve", quantity.name);
    let off = |(_, [expected, got]): &(f64, [f64; 2])| deviation(*expected, *got).abs();
    let worst = |(case, law): &(&Case, Law)| {
        let (x, numbers) = along(case, law, quantity).into_iter().max_by(|a, b| off(a).total_cmp(&off(b)))?;
        let at = format!("{}, x = {}", case.name, crate::units::rounded::number(x));
        Some(Check::numbers(&name, at, STATIC, unit, numbers, tolerance))
    };
    laws.iter().filter_map(worst).collect()
}

pub(super) fn checks(coefficients: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let cases = cases()?;
    let laws: Vec<(&Case, Law)> =
        cases.iter().map(|case| (case, case.law(coefficients, UnloadingExponent::Paper))).collect();
    let [force, sphere, half_space, radius] = &QUANTITIES;
    let mut checks = spreads(&laws, force, FORCE);
    checks.extend(largest(&laws, force, "F_Y", LARGEST_FORCE));
    checks.extend(spreads(&laws, sphere, INDENTATION));
    checks.extend(spreads(&laws, half_space, INDENTATION));
    checks.extend(spreads(&laws, radius, RADIUS));
    checks.extend(largest(&laws, radius, "a_Y", LARGEST_RADIUS));
    Ok(checks)
}
