//! Loading: force, sphere and half-space indentation, contact radius along the five finite-element curves.

use super::check::{Check, Tolerance, deviation, rms};
use super::reference::{Case, STATIC, cases};
use super::ValidationError;
use crate::fit::LoadingPoint;
use crate::law::{Law, PlmCoefficients, UnloadingExponent};

const FORCE: Tolerance = Tolerance { limit: 0.015, source: "documented 1.4 %, margin 0.1 %" };
const LARGEST_FORCE: Tolerance = Tolerance { limit: 0.036, source: "documented 3.5 %, margin 0.1 %" };
const INDENTATION: Tolerance = Tolerance { limit: 0.013, source: "documented 1.2 %, margin 0.1 %" };
const RADIUS: Tolerance = Tolerance { limit: 0.03, source: "documented 3 %" };

/// A quantity along the loading curve: of the law and of a point.
pub(super) struct Quantity {
    pub name: &'static str,
    pub of_law: fn(&Case, &Law, f64) -> f64,
    pub of_point: fn(&Case, &LoadingPoint) -> Option<f64>,
    tolerance: Tolerance,
}

/// What is compared, in units of the yield point.
pub(super) const QUANTITIES: [Quantity; 4] = [
    Quantity {
        name: "force",
        of_law: |_, law, x| law.loading.force(x),
        of_point: |_, point| Some(point.force),
        tolerance: FORCE,
    },
    Quantity {
        name: "sphere indentation",
        of_law: |case, law, x| case.sphere_compliance() * law.loaded_to(x).elastic_approach,
        of_point: |case, point| Some(case.sphere_compliance() * point.elastic_approach),
        tolerance: INDENTATION,
    },
    Quantity {
        name: "half-space indentation",
        of_law: |case, law, x| x - case.sphere_compliance() * law.loaded_to(x).elastic_approach,
        of_point: |case, point| Some(point.indentation - case.sphere_compliance() * point.elastic_approach),
        tolerance: INDENTATION,
    },
    Quantity {
        name: "contact radius",
        of_law: |_, law, x| law.contact_radius(&law.loaded_to(x)),
        of_point: |_, point| point.contact_radius,
        tolerance: RADIUS,
    },
];

/// x, expected and got of a quantity at every point from first yield on.
pub(super) fn along(case: &Case, law: &Law, quantity: &Quantity) -> Vec<(f64, [f64; 2])> {
    let pair = |point: &LoadingPoint| {
        let expected = (quantity.of_point)(case, point)?;
        Some((point.indentation, [expected, (quantity.of_law)(case, law, point.indentation)]))
    };
    case.plastic().filter_map(pair).collect()
}

pub(super) fn checks(coefficients: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let cases = cases()?;
    let mut checks = Vec::new();
    for quantity in &QUANTITIES {
        for case in &cases {
            let law = case.law(coefficients, UnloadingExponent::Paper);
            let points = along(case, &law, quantity);
            let deviations: Vec<f64> = points.iter().map(|(_, [expected, got])| deviation(*expected, *got)).collect();
            let name = format!("loading: {}, rms over the curve", quantity.name);
            let over = format!("{}, {} points", case.name, points.len());
            checks.push(Check::mean(&name, over, STATIC, rms(&deviations), quantity.tolerance));
        }
    }
    for case in &cases {
        let law = case.law(coefficients, UnloadingExponent::Paper);
        let off = |(_, [expected, got]): &(f64, [f64; 2])| deviation(*expected, *got).abs();
        let worst = along(case, &law, &QUANTITIES[0]).into_iter().max_by(|a, b| off(a).total_cmp(&off(b)));
        if let Some((x, numbers)) = worst {
            let at = format!("{}, x = {}", case.name, crate::report::human::number(x));
            checks.push(Check::numbers("loading: force, largest deviation", at, STATIC, "F_Y", numbers, LARGEST_FORCE));
        }
    }
    Ok(checks)
}
