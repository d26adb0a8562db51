//! A half-space that hardens: the law, loaded with the same work as the finite elements.

use super::comparison::{ComparedQuantity, Comparison, Group, compare_all};
use crate::contact::law::{ContactState, Law, Plm, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::reference::{HARDENING, ReferenceRow};

const REFERENCE: &str = "finite elements, CalculiX 2.20, fe_hardening.csv";

/// A load cycle by finite elements, and by the law.
type HardeningCase = (ReferenceRow, LoadCycle);

const QUANTITIES: [ComparedQuantity<HardeningCase>; 5] = [
    (hardening_group("hardening: restitution, pressure-shape"), |(row, state)| {
        Some([row.number("restitution"), state.restitution])
    }),
    (hardening_group("hardening: peak force"), |(row, state)| Some([row.number("f"), state.peak.force])),
    (hardening_group("hardening: peak indentation"), |(row, state)| Some([row.number("x"), state.peak.indentation])),
    // a shallow dent would have a large relative deviation
    (
        Group::new_difference("hardening: residual indentation, deviation over peak indentation", REFERENCE, ""),
        |(row, state)| Some([row.number("residual_share"), state.peak.residual() / state.peak.indentation]),
    ),
    (hardening_group("hardening: contact radius"), |(row, state)| {
        Some([row.number("contact_radius_over_R"), state.contact_radius])
    }),
];

const fn hardening_group(name: &'static str) -> Group {
    Group::new(name, REFERENCE, "")
}

/// A load cycle by the law.
pub(super) struct LoadCycle {
    peak: ContactState,
    /// Restitution √(recovered/spent work).
    pub(super) restitution: f64,
    /// Contact radius at the peak, a_m/R.
    contact_radius: f64,
}

/// The load cycle in which loading takes this work, in units of first yield.
pub(super) fn load_cycle_at_work(law: &Law, yield_radius_ratio: f64, spent: f64) -> LoadCycle {
    let piece = &law.loading.pieces()[law.loading.index_at_work(spent)];
    let peak = law.loaded_state(piece.indentation_at_work(spent));
    let restitution = (law.unload(peak).recoverable_energy() / spent).sqrt();
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

pub(super) fn unloadings(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let mut cases = Vec::new();
    for row in HARDENING.rows()? {
        if let Some((law, yield_radius_ratio)) = hardening_law(&row, coefficients, true)? {
            let state = load_cycle_at_work(&law, yield_radius_ratio, row.number("spent"));
            cases.push((row, state));
        }
    }
    Ok(compare_all(&QUANTITIES, &cases, |(row, _)| format!("{}, x = {}", row.cell_text("material"), row.number("x"))))
}
