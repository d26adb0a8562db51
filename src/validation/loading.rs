//! Loading: force, sphere and half-space indentation, contact radius along the five finite-element curves.

use super::ValidationError;
use super::cases::{Case, cases};
use super::check::{Check, Known, Tolerance, deviation, rms};
use crate::fit::LoadingPoint;
use crate::law::{Law, PlmCoefficients, UnloadingExponent};
use crate::reference::STATIC;

const FORCE: Tolerance = Tolerance { limit: 0.015, source: "documented 1.4 %, margin 0.1 %" };
const LARGEST_FORCE: Tolerance = Tolerance { limit: 0.036, source: "documented 3.5 %, margin 0.1 %" };
const INDENTATION: Tolerance = Tolerance { limit: 0.013, source: "documented 1.2 %, margin 0.1 %" };
const RADIUS: Tolerance = Tolerance { limit: 0.03, source: "aim of the law, 3 %" };

/// Contact radii up to this a/R are compared by themselves.
const NARROW: f64 = 0.15;
/// Found by this validation: the polyline of the contact radius was fitted to be within 3 %, but is not everywhere.
const KNOWN_RADIUS: [Known; 2] = [
    Known {
        limit: 0.04,
        remark: "with a half-space softer than the sphere the contact is up to 5 % too wide at a few delta_Y",
    },
    Known {
        limit: 0.11,
        remark: "the contact is too wide beyond a/R = 0.15, by 6 to 18 % where the curves end, so the mean pressure is too low by twice that; in cases 1 and 2 up to 7 % of it is pile-up that the reference does not resolve",
    },
];

/// A quantity along the loading curve, by the law and by the finite elements.
pub(super) struct Quantity {
    pub name: &'static str,
    pub of_law: fn(&Case, &Law, f64) -> f64,
    pub of_point: fn(&Case, &LoadingPoint) -> Option<f64>,
}

/// The quantities that are compared, in units of the yield point.
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

/// x, and the expected and the computed value of a quantity, at every point from first yield on.
pub(super) fn along(case: &Case, law: &Law, quantity: &Quantity) -> Vec<(f64, [f64; 2])> {
    let pair = |point: &LoadingPoint| {
        let expected = (quantity.of_point)(case, point)?;
        Some((point.indentation, [expected, (quantity.of_law)(case, law, point.indentation)]))
    };
    case.plastic().filter_map(pair).collect()
}

/// A check of the root mean square of the deviations along a curve.
fn spread(quantity: &str, case: &Case, points: &[[f64; 2]], tolerance: Tolerance) -> Check {
    let deviations: Vec<f64> = points.iter().map(|[expected, got]| deviation(*expected, *got)).collect();
    let over = format!("{}, {} points", case.name, points.len());
    Check::mean(&format!("loading: {quantity}, rms over the curve"), over, STATIC, rms(&deviations), tolerance)
}

pub(super) fn checks(coefficients: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let cases = cases()?;
    let with_laws = || cases.iter().map(|case| (case, case.law(coefficients, UnloadingExponent::Paper)));
    let [force, shares @ .., radius] = &QUANTITIES;
    let mut checks = Vec::new();
    for (case, law) in with_laws() {
        let points: Vec<[f64; 2]> = along(case, &law, force).into_iter().map(|(_, numbers)| numbers).collect();
        checks.push(spread(force.name, case, &points, FORCE));
    }
    for (case, law) in with_laws() {
        let off = |(_, [expected, got]): &(f64, [f64; 2])| deviation(*expected, *got).abs();
        let worst = along(case, &law, force).into_iter().max_by(|a, b| off(a).total_cmp(&off(b)));
        if let Some((x, numbers)) = worst {
            let at = format!("{}, x = {}", case.name, crate::units::rounded::number(x));
            checks.push(Check::numbers(
                "loading: force, largest over the curve",
                at,
                STATIC,
                "F_Y",
                numbers,
                LARGEST_FORCE,
            ));
        }
    }
    for quantity in shares {
        for (case, law) in with_laws() {
            let points: Vec<[f64; 2]> = along(case, &law, quantity).into_iter().map(|(_, numbers)| numbers).collect();
            checks.push(spread(quantity.name, case, &points, INDENTATION));
        }
    }
    for (is_narrow, name, known) in [
        (true, "contact radius to a/R = 0.15", KNOWN_RADIUS[0]),
        (false, "contact radius from a/R = 0.15", KNOWN_RADIUS[1]),
    ] {
        for (case, law) in with_laws() {
            let in_range = |expected: f64| (expected * case.loading.yield_radius_ratio <= NARROW) == is_narrow;
            let points = along(case, &law, radius).into_iter().map(|(_, numbers)| numbers);
            let points: Vec<[f64; 2]> = points.filter(|[expected, _]| in_range(*expected)).collect();
            checks.push(Check { known: Some(known), ..spread(name, case, &points, RADIUS) });
        }
    }
    Ok(checks)
}
