//! A half-space that hardens, and deep dents: the law, loaded with the same work as the finite elements.

use super::comparison::{ComparedQuantity, Comparison, Group, compare_all};
use crate::contact::law::{ContactState, Law, Plm, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::reference::{DEEP_UNLOADINGS, HARDENING, ReferenceRow, ReferenceTable};

/// A load cycle by finite elements, and by the law.
type HardeningCase = (ReferenceRow, LoadCycle);

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
        (Group::new(restitution, source, ""), |(row, state)| Some([row.number("restitution"), state.restitution])),
        (Group::new(force, source, ""), |(row, state)| Some([row.number("f"), state.peak.force])),
        (Group::new(indentation, source, ""), |(row, state)| Some([row.number("x"), state.peak.indentation])),
        // a shallow dent would have a large relative deviation
        (Group::new_difference(residual, source, ""), |(row, state)| {
            Some([row.number("residual_share"), state.peak.residual() / state.peak.indentation])
        }),
        (Group::new(radius, source, ""), |(row, state)| {
            Some([row.number("contact_radius_over_R"), state.contact_radius])
        }),
    ]
}

/// A load cycle by the law.
pub(super) struct LoadCycle {
    pub(super) peak: ContactState,
    /// Restitution √(recovered/spent work).
    pub(super) restitution: f64,
    /// Contact radius at the peak, a_m/R.
    contact_radius: f64,
}

/// The load cycle in which loading takes this work, in units of first yield.
pub(super) fn load_cycle_at_work(law: &Law, yield_radius_ratio: f64, spent: f64) -> LoadCycle {
    let piece = &law.loading.pieces()[law.loading.index_at_work(spent)];
    let peak = law.loaded_state(piece.indentation_at_work(spent));
    let restitution = (law.unloading(peak).recoverable_energy() / spent).sqrt();
    LoadCycle { peak, restitution, contact_radius: law.contact_radius(&peak) * yield_radius_ratio }
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
            let state = load_cycle_at_work(&law, yield_radius_ratio, row.number("spent"));
            cases.push((row, state));
        }
    }
    Ok(cases)
}

pub(super) fn unloadings(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let quantities = quantities(HARDENING_NAMES, HARDENING_SOURCE);
    let name = |(row, _): &HardeningCase| format!("{}, x = {}", row.cell_text("material"), row.number("x"));
    Ok(compare_all(&quantities, &load_cycles(&HARDENING, coefficients)?, name))
}

pub(super) fn deep_unloadings(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let quantities = quantities(DEEP_NAMES, DEEP_SOURCE);
    let name =
        |(row, _): &HardeningCase| format!("{}, a/R = {}", row.cell_text("case"), row.number("contact_radius_over_R"));
    Ok(compare_all(&quantities, &load_cycles(&DEEP_UNLOADINGS, coefficients)?, name))
}
