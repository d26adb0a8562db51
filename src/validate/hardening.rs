//! A half-space that hardens: the law, loaded with the same work as the finite elements.

use super::comparison::{ComparedQuantity, Comparison, Group, compare_all};
use super::load_cycle::LoadCycle;
use crate::contact::law::{Law, Plm, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::reference::{HARDENING, ReferenceRow};

const REFERENCE: &str = "finite elements, CalculiX 2.20, fe_hardening.csv";

/// A load cycle by finite elements, the cycle by the law with the same work, and a_Y/R.
type HardeningCase = (ReferenceRow, LoadCycle, f64);

const QUANTITIES: [ComparedQuantity<HardeningCase>; 5] = [
    (hardening_group("hardening: restitution, pressure-shape"), |(row, cycle, _)| {
        Some([row.number("restitution"), cycle.restitution])
    }),
    (hardening_group("hardening: peak force"), |(row, cycle, _)| Some([row.number("f"), cycle.peak.force])),
    (hardening_group("hardening: peak indentation"), |(row, cycle, _)| Some([row.number("x"), cycle.peak.indentation])),
    // a shallow dent would have a large relative deviation
    (
        Group::new_difference("hardening: residual indentation, deviation over peak indentation", REFERENCE, ""),
        |(row, cycle, _)| Some([row.number("residual_share"), cycle.peak.residual() / cycle.peak.indentation]),
    ),
    (hardening_group("hardening: contact radius"), |(row, cycle, yield_radius_ratio)| {
        Some([row.number("contact_radius_over_R"), cycle.contact_radius * yield_radius_ratio])
    }),
];

const fn hardening_group(name: &'static str) -> Group {
    Group::new(name, REFERENCE, "")
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
            let cycle = LoadCycle::with_work(&law, row.number("spent"));
            cases.push((row, cycle, yield_radius_ratio));
        }
    }
    Ok(compare_all(&QUANTITIES, &cases, |(row, ..)| format!("{}, x = {}", row.cell_text("material"), row.number("x"))))
}
