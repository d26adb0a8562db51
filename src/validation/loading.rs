//! Checks of loading: force, indentations of sphere and half-space, and contact radius along the five finite-element
//! curves.

use super::ValidationError;
use super::cases::{Case, cases};
use super::check::{Check, Tolerance, deviation, rms};
use crate::fit::LoadingPoint;
use crate::law::{Law, PlmCoefficients, UnloadingExponent};
use crate::reference::STATIC;

/// A quantity along the loading curve, by the law and by the finite elements, in units of first yield.
pub(super) struct Quantity {
    pub name: &'static str,
    pub of_law: fn(&Case, &Law, f64) -> f64,
    pub of_point: fn(&Case, &LoadingPoint) -> Option<f64>,
    /// Tolerance of the root mean square of the deviations along a curve.
    rms: Tolerance,
    /// Unit, and tolerance of the largest deviation along a curve, if there is a check of it.
    largest: Option<(&'static str, Tolerance)>,
}

const INDENTATION: Tolerance = Tolerance { limit: 0.013, source: "documented 1.2 %, margin 0.1 %" };

pub(super) const QUANTITIES: [Quantity; 4] = [
    Quantity {
        name: "force",
        of_law: |_, law, x| law.loading.force(x),
        of_point: |_, point| Some(point.force),
        rms: Tolerance { limit: 0.015, source: "documented 1.4 %, margin 0.1 %" },
        largest: Some(("F_Y", Tolerance { limit: 0.036, source: "documented 3.5 %, margin 0.1 %" })),
    },
    Quantity {
        name: "sphere indentation",
        of_law: |case, law, x| case.sphere_compliance() * law.loaded_to(x).elastic_approach,
        of_point: |case, point| Some(case.sphere_compliance() * point.elastic_approach),
        rms: INDENTATION,
        largest: None,
    },
    Quantity {
        name: "half-space indentation",
        of_law: |case, law, x| x - case.sphere_compliance() * law.loaded_to(x).elastic_approach,
        of_point: |case, point| Some(point.indentation - case.sphere_compliance() * point.elastic_approach),
        rms: INDENTATION,
        largest: None,
    },
    Quantity {
        name: "contact radius",
        of_law: |_, law, x| law.contact_radius(&law.loaded_to(x)),
        of_point: |_, point| point.contact_radius,
        rms: Tolerance { limit: 0.027, source: "documented 2.6 %, margin 0.1 %" },
        largest: Some(("a_Y", Tolerance { limit: 0.053, source: "documented 5 % at every depth, margin 0.3 %" })),
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

/// Two checks for each curve: the root mean square of the deviations along it, and the largest.
pub(super) fn checks(coefficients: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let mut checks = Vec::new();
    let cases = cases()?;
    for quantity in &QUANTITIES {
        let name = format!("loading: {}, rms over the curve", quantity.name);
        let mut of_largest = Vec::new();
        for case in &cases {
            let points = along(case, &case.law(coefficients, UnloadingExponent::Paper), quantity);
            let off = |(_, [expected, got]): &(f64, [f64; 2])| deviation(*expected, *got);
            let over = format!("{}, {} points", case.name, points.len());
            let rms = rms(&points.iter().map(off).collect::<Vec<_>>());
            checks.push(Check::mean(&name, over, STATIC, rms, quantity.rms));
            let worst = points.iter().max_by(|a, b| off(a).abs().total_cmp(&off(b).abs()));
            if let (Some((x, numbers)), Some((unit, tolerance))) = (worst, quantity.largest) {
                let name = format!("loading: {}, largest over the curve", quantity.name);
                let at = format!("{}, x = {}", case.name, crate::units::rounded::number(*x));
                of_largest.push(Check::numbers(&name, at, STATIC, unit, *numbers, tolerance));
            }
        }
        checks.extend(of_largest);
    }
    Ok(checks)
}
