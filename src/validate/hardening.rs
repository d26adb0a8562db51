//! A half-space that hardens, and deep dents: the law, loaded with the same work as the finite elements.

use super::comparison::{ComparedQuantity, Comparison, Group, compare_all};
use super::load_cycle::LoadCycle;
use crate::contact::law::{Law, Plm, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::reference::{DEEP_UNLOADINGS, HARDENING, ReferenceRow, ReferenceTable};

/// A load cycle by finite elements, the cycle by the law with the same work, and a_Y/R.
type HardeningCase = (ReferenceRow, LoadCycle, f64);

/// Names of the quantities of a load cycle: restitution, peak force, peak indentation, residual indentation, contact radius.
type QuantityNames = [&'static str; 5];

const HARDENING_SOURCE: &str = "finite elements, CalculiX 2.20, fe_hardening.csv";
const HARDENING_NAMES: QuantityNames = [
    "hardening: restitution, pressure-shape",
    "hardening: peak force",
    "hardening: peak indentation",
    "hardening: residual indentation, deviation over peak indentation",
    "hardening: contact radius",
];

const DEEP_SOURCE: &str = "finite elements of deep dents (a/R 0.34 to 0.58), CalculiX 2.20, src/reference/fe_deep.csv";
const DEEP_NAMES: QuantityNames = [
    "deep dent: restitution, pressure-shape",
    "deep dent: peak force",
    "deep dent: peak indentation",
    "deep dent: residual indentation, deviation over peak indentation",
    "deep dent: contact radius",
];

/// The quantities of a load cycle at equal work.
const fn quantities(names: QuantityNames, source: &'static str) -> [ComparedQuantity<HardeningCase>; 5] {
    let [restitution, force, indentation, residual, radius] = names;
    [
        (Group::new(restitution, source, ""), |(row, cycle, _)| Some([row.number("restitution"), cycle.restitution])),
        (Group::new(force, source, ""), |(row, cycle, _)| Some([row.number("f"), cycle.peak.force])),
        (Group::new(indentation, source, ""), |(row, cycle, _)| Some([row.number("x"), cycle.peak.indentation])),
        // a shallow dent would have a large relative deviation
        (Group::new_difference(residual, source, ""), |(row, cycle, _)| {
            Some([row.number("residual_share"), cycle.peak.residual() / cycle.peak.indentation])
        }),
        (Group::new(radius, source, ""), |(row, cycle, yield_radius_ratio)| {
            Some([row.number("contact_radius_over_R"), cycle.contact_radius * yield_radius_ratio])
        }),
    ]
}

/// The law of these materials, and a_Y/R. Without `hardens` the law has no flow curve.
pub(super) fn hardening_law(
    materials: &ReferenceRow,
    coefficients: &PlmCoefficients,
    hardens: bool,
) -> Result<Option<(Law, f64)>, Error> {
    let flow = [None, materials.curve().filter(|_| hardens)];
    let plm = Plm { flow, ..Plm::new(coefficients, UnloadingExponent::PressureShape) };
    Ok(materials.bodies()?.map(|bodies| (plm.law_for_yielding_pair(&bodies), bodies.yield_radius_ratio())))
}

/// The load cycles of a table by the law, at the work of the finite elements.
pub(super) fn load_cycles(table: &ReferenceTable, coefficients: &PlmCoefficients) -> Result<Vec<HardeningCase>, Error> {
    let mut cases = Vec::new();
    for row in table.rows()? {
        if let Some((law, yield_radius_ratio)) = hardening_law(&row, coefficients, true)? {
            let cycle = LoadCycle::with_work(&law, row.number("spent"));
            cases.push((row, cycle, yield_radius_ratio));
        }
    }
    Ok(cases)
}

pub(super) fn unloadings(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let quantities = quantities(HARDENING_NAMES, HARDENING_SOURCE);
    let name = |(row, ..): &HardeningCase| format!("{}, x = {}", row.cell_text("material"), row.number("x"));
    Ok(compare_all(&quantities, &load_cycles(&HARDENING, coefficients)?, name))
}

pub(super) fn deep_unloadings(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let quantities = quantities(DEEP_NAMES, DEEP_SOURCE);
    let name =
        |(row, ..): &HardeningCase| format!("{}, a/R = {}", row.cell_text("case"), row.number("contact_radius_over_R"));
    Ok(compare_all(&quantities, &load_cycles(&DEEP_UNLOADINGS, coefficients)?, name))
}
