//! Comparisons with the quasi-static finite elements of five pairs of materials: loading curves, dents that follow from the
//! peak of the finite elements, and load cycles by the whole law.

use super::cases::{Cycle, MaterialCase, cases};
use super::comparison::{Comparison, Group};
use crate::contact::law::{Law, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::reference::QUASI_STATIC_SOURCE;
use crate::units::format_four_digits;

/// The exponents of the unloading with which the law is compared.
const PAPER: UnloadingExponent = UnloadingExponent::Paper;
const SHAPE: UnloadingExponent = UnloadingExponent::PressureShape;

/// A quantity along the loading curve: its name, its column of the finite elements, and its value by the law at the same depth.
type LoadingQuantity = (Group, &'static str, fn(&MaterialCase, &Law, f64) -> f64);

const LOADING: [LoadingQuantity; 3] = [
    (Group::new("loading: force", QUASI_STATIC_SOURCE, "F_Y"), "F_over_FY", |_, law, x| law.loading.force(x)),
    (Group::new("loading: sphere indentation", QUASI_STATIC_SOURCE, "delta"), "delta_s_over_delta", |case, law, x| {
        case.sphere_compliance() * law.loaded_state(x).elastic_approach / x
    }),
    (Group::new("loading: contact radius", QUASI_STATIC_SOURCE, "R"), "a_over_R", |case, law, x| {
        law.contact_radius(&law.loaded_state(x)) * case.loading.yield_radius_ratio
    }),
];

/// Compares the loading curves at their points from first yield on.
pub(super) fn loading(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let (mut compared, cases) = (Vec::new(), cases()?);
    for (group, column, of_law) in LOADING {
        for case in &cases {
            let law = case.law(coefficients, PAPER);
            for point in case.loading.points.iter().filter(|point| point.number("delta_over_deltaY") >= 1.0) {
                let x = point.number("delta_over_deltaY");
                let name = format!("{}, x = {}", case.name(), format_four_digits(x));
                compared.push(group.compare(name, [point.number(column), of_law(case, &law, x)]));
            }
        }
    }
    Ok(compared)
}

/// Restitution of a load cycle to x: √(recovered/spent work).
pub(super) fn restitution(law: &Law, x: f64) -> f64 {
    (law.unload(law.loaded_state(x)).stored_energy(x) / law.loading.work(x)).sqrt()
}

/// A quantity of a load cycle: its name, the exponent of the law, and a function that gives the numbers of the finite elements and
/// of the law; `None` if the finite elements have no such number.
type CycleQuantity = (Group, UnloadingExponent, fn(&Law, &Cycle) -> Option<[f64; 2]>);

const CYCLES: [CycleQuantity; 4] = [
    (
        Group::new(
            "unloading: residual indentation from the reference's peak (Eq. 23)",
            QUASI_STATIC_SOURCE,
            "delta_Y",
        ),
        PAPER,
        |_, cycle| Some([cycle.residual(), cycle.peak.residual()]),
    ),
    (
        Group::new_difference(
            "load cycle: residual indentation, deviation over peak indentation",
            QUASI_STATIC_SOURCE,
            "delta_m",
        ),
        PAPER,
        |law, cycle| {
            let x = cycle.peak.indentation;
            Some([cycle.row.number("residual_share"), law.loaded_state(x).residual() / x])
        },
    ),
    (Group::new("load cycle: restitution, exponent 3/2", QUASI_STATIC_SOURCE, ""), PAPER, restitution_pair),
    (Group::new("load cycle: restitution, pressure-shape", QUASI_STATIC_SOURCE, ""), SHAPE, restitution_pair),
];

fn restitution_pair(law: &Law, cycle: &Cycle) -> Option<[f64; 2]> {
    Some([cycle.row.optional_number("restitution")?, restitution(law, cycle.peak.indentation)])
}

/// Compares every load cycle: first the dent that the law gives from the peak of the finite elements, then dent and restitution
/// by the law alone.
pub(super) fn cycles(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let (mut compared, cases) = (Vec::new(), cases()?);
    for (group, exponent, numbers) in CYCLES {
        for case in &cases {
            let law = case.law(coefficients, exponent);
            let of_case = case.cycles.iter().filter_map(|cycle| Some((cycle.name(), numbers(&law, cycle)?)));
            compared.extend(of_case.map(|(name, numbers)| group.compare(name, numbers)));
        }
    }
    Ok(compared)
}
