//! Comparisons with the quasi-static finite elements of five pairs of materials: loading curves, dents that follow from the
//! peak of the finite elements, and load cycles by the whole law.

use super::cases::{Cycle, MaterialCase, cases};
use super::comparison::{ComparedQuantity, Comparison, Group, compare_all};
use super::load_cycle::LoadCycle;
use crate::contact::law::{Law, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::reference::{QUASI_STATIC_SOURCE, ReferenceRow};
use crate::units::format_four_digits;

/// The exponents of the unloading with which the law is compared.
const PAPER: UnloadingExponent = UnloadingExponent::Paper;
const SHAPE: UnloadingExponent = UnloadingExponent::PressureShape;

/// A point of a loading curve by the finite elements, and the law of its materials.
struct LoadingPoint<'a> {
    case: &'a MaterialCase,
    law: &'a Law,
    row: &'a ReferenceRow,
    /// Indentation of both, in units of first yield.
    x: f64,
}

/// Compares the loading curves at their points from first yield on.
pub(super) fn loading(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let quantities: [ComparedQuantity<LoadingPoint>; 3] = [
        (Group::new("loading: force", QUASI_STATIC_SOURCE, "F_Y"), |LoadingPoint { law, row, x, .. }| {
            Some([row.number("F_over_FY"), law.loading.force(*x)])
        }),
        (
            Group::new("loading: sphere indentation", QUASI_STATIC_SOURCE, "delta"),
            |LoadingPoint { case, law, row, x }| {
                let of_law = case.sphere_compliance() * law.loaded_state(*x).elastic_approach / x;
                Some([row.number("delta_s_over_delta"), of_law])
            },
        ),
        (Group::new("loading: contact radius", QUASI_STATIC_SOURCE, "R"), |LoadingPoint { case, law, row, x }| {
            let of_law = law.contact_radius(&law.loaded_state(*x)) * case.loading.yield_radius_ratio;
            Some([row.number("a_over_R"), of_law])
        }),
    ];
    let cases = cases()?;
    let laws: Vec<Law> = cases.iter().map(|case| case.law(coefficients, PAPER)).collect();
    let mut points = Vec::new();
    for (case, law) in cases.iter().zip(&laws) {
        let of_case = case.loading.points.iter();
        points.extend(of_case.map(|row| LoadingPoint { case, law, row, x: row.number("delta_over_deltaY") }));
    }
    points.retain(|point| point.x >= 1.0);
    Ok(compare_all(&quantities, &points, |point| format!("{}, x = {}", point.case.name(), format_four_digits(point.x))))
}

/// A load cycle by the finite elements, and by the law with each exponent.
struct CycleCase<'a> {
    cycle: &'a Cycle,
    by_law: [LoadCycle; 2],
}

/// Compares every load cycle: first the dent that the law gives from the peak of the finite elements, then dent and restitution
/// by the law alone.
pub(super) fn cycles(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let quantities: [ComparedQuantity<CycleCase>; 4] = [
        (
            Group::new(
                "unloading: residual indentation from the reference's peak (Eq. 23)",
                QUASI_STATIC_SOURCE,
                "delta_Y",
            ),
            |case| Some([case.cycle.residual(), case.cycle.peak.residual()]),
        ),
        (
            Group::new_difference(
                "load cycle: residual indentation, deviation over peak indentation",
                QUASI_STATIC_SOURCE,
                "delta_m",
            ),
            |case| {
                let of_law = case.by_law[0].peak.residual() / case.cycle.peak.indentation;
                Some([case.cycle.row.number("residual_share"), of_law])
            },
        ),
        (Group::new("load cycle: restitution, exponent 3/2", QUASI_STATIC_SOURCE, ""), |case| {
            Some([case.cycle.row.optional_number("restitution")?, case.by_law[0].restitution])
        }),
        (Group::new("load cycle: restitution, pressure-shape", QUASI_STATIC_SOURCE, ""), |case| {
            Some([case.cycle.row.optional_number("restitution")?, case.by_law[1].restitution])
        }),
    ];
    let (cases, mut all) = (cases()?, Vec::new());
    for case in &cases {
        let laws = [PAPER, SHAPE].map(|exponent| case.law(coefficients, exponent));
        all.extend(case.cycles.iter().map(|cycle| CycleCase {
            cycle,
            by_law: laws.each_ref().map(|law| LoadCycle::to_depth(law, cycle.peak.indentation)),
        }));
    }
    Ok(compare_all(&quantities, &all, |case| case.cycle.name()))
}
