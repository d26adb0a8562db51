//! Checks of a half-space that hardens: the law, loaded with the same work as the finite elements.

use std::sync::Arc;

use super::ValidationError;
use super::check::{Check, RMS, Tolerance};
use crate::law::{Law, Peak, Plm, PlmCoefficients, UnloadingExponent};
use crate::reference::hardening::{Materials, unloadings};
use crate::reference::unloading::Unloaded;

const REFERENCE: &str = "finite elements, CalculiX 2.20, fe_hardening.csv";

/// The only quantity whose deviation is a difference, because a shallow dent would have a large relative deviation.
const DENT: &str = "residual indentation, deviation over peak indentation";

/// A quantity of an unloading by the finite elements and by the law, and the tolerances of one value and of the rms.
struct Quantity {
    name: &'static str,
    of_reference: fn(&Unloaded) -> f64,
    of_law: fn(&AtEnergy) -> f64,
    of_one: Tolerance,
    of_rms: Tolerance,
}

const QUANTITIES: [Quantity; 5] = [
    Quantity {
        name: "restitution, pressure-shape",
        of_reference: |row| row.restitution,
        of_law: |state| state.restitution,
        of_one: Tolerance { limit: 0.031, source: "documented 2.9 %, margin 0.2 %" },
        of_rms: Tolerance { limit: 0.012, source: "documented 1.1 %, margin 0.1 %" },
    },
    Quantity {
        name: "peak force",
        of_reference: |row| row.f,
        of_law: |state| state.peak.force,
        of_one: Tolerance { limit: 0.040, source: "documented 3.8 %, margin 0.2 %" },
        of_rms: Tolerance { limit: 0.015, source: "documented 1.4 %, margin 0.1 %" },
    },
    Quantity {
        name: "peak indentation",
        of_reference: |row| row.x,
        of_law: |state| state.peak.indentation,
        of_one: Tolerance { limit: 0.033, source: "documented 3.1 %, margin 0.2 %" },
        of_rms: Tolerance { limit: 0.011, source: "documented 1.0 %, margin 0.1 %" },
    },
    Quantity {
        name: DENT,
        of_reference: |row| row.residual_share,
        of_law: |state| state.peak.residual() / state.peak.indentation,
        of_one: Tolerance { limit: 0.030, source: "found 2.8 %, margin 0.2 %" },
        of_rms: Tolerance { limit: 0.010, source: "found 0.9 %, margin 0.1 %" },
    },
    Quantity {
        name: "contact radius",
        of_reference: |row| row.contact_radius,
        of_law: |state| state.contact_radius,
        of_one: Tolerance { limit: 0.038, source: "documented 3.5 %, margin 0.3 % for the digits of the reference" },
        of_rms: Tolerance { limit: 0.016, source: "documented 1.5 %, margin 0.1 %" },
    },
];

/// A load cycle by the law.
pub(super) struct AtEnergy {
    peak: Peak,
    /// Restitution √(recovered/spent work).
    pub(super) restitution: f64,
    /// Contact radius at the peak, a_m/R.
    contact_radius: f64,
}

/// The load cycle in which loading takes this work, in units of first yield.
pub(super) fn at_energy(law: &Law, yield_radius_ratio: f64, spent: f64) -> AtEnergy {
    let piece = &law.loading.pieces()[law.loading.index_at_work(spent)];
    let peak = law.loaded_to(piece.indentation_at_work(spent));
    let restitution = (law.unloading(peak).capacity() / spent).sqrt();
    AtEnergy { peak, restitution, contact_radius: law.contact_radius(&peak) * yield_radius_ratio }
}

/// The law of these materials, and a_Y/R. Without `hardens` the law has no flow curve.
pub(super) fn law(
    materials: &Materials,
    coefficients: &PlmCoefficients,
    hardens: bool,
) -> Result<Option<(Law, f64)>, ValidationError> {
    let plm = Plm {
        coefficients: Arc::new(coefficients.clone()),
        exponent: UnloadingExponent::PressureShape,
        flow: materials.curve().filter(|_| hardens),
    };
    Ok(materials.bodies()?.map(|bodies| (plm.of_bodies(&bodies), bodies.yield_radius_ratio())))
}

pub(super) fn checks(coefficients: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let rows = unloadings()?;
    let mut states = Vec::with_capacity(rows.len());
    for (materials, row) in &rows {
        if let Some((law, yield_radius_ratio)) = law(materials, coefficients, true)? {
            states.push((row, at_energy(&law, yield_radius_ratio, row.spent)));
        }
    }
    let mut checks: Vec<Check> = Vec::new();
    for Quantity { name, of_reference, of_law, of_one, of_rms } in QUANTITIES {
        let is_difference = name == DENT;
        let name = format!("hardening: {name}");
        let of_row = |(row, state): &(&Unloaded, AtEnergy)| {
            let case = format!("{}, x = {}", row.material, row.x);
            let numbers = [of_reference(row), of_law(state)];
            let check = Check::numbers(&name, case, REFERENCE, "", numbers, of_one);
            if is_difference { check.of_difference() } else { check }
        };
        let first = checks.len();
        checks.extend(states.iter().map(of_row));
        checks.extend(Check::overall(&checks[first..], RMS, "unloadings", of_rms));
    }
    checks.extend(super::oracle::of_hardening()?);
    Ok(checks)
}
