//! Checks of a half-space that hardens: the law, loaded with the same work as the finite elements.

use std::sync::Arc;

use super::check::{Check, Group, RMS, Statistic, Tolerance, found};
use crate::error::Error;
use crate::law::{Law, Peak, Plm, PlmCoefficients, UnloadingExponent};
use crate::reference::hardening::{Materials, unloadings};
use crate::reference::unloading::Unloaded;

const REFERENCE: &str = "finite elements, CalculiX 2.20, fe_hardening.csv";

/// A quantity of an unloading: its checks, and its number by the finite elements and by the law.
type Quantity = (Group, fn(&Unloaded) -> f64, fn(&AtEnergy) -> f64);

const fn group(name: &'static str, limit: Tolerance, of_rms: &'static [(Statistic, Tolerance)]) -> Group {
    Group::of(name, REFERENCE, "", limit).with_overall(of_rms)
}

const QUANTITIES: [Quantity; 5] = [
    (
        group("hardening: restitution, pressure-shape", found(0.0289, 0.031), &[(RMS, found(0.0109, 0.012))]),
        |row| row.restitution,
        |state| state.restitution,
    ),
    (
        group("hardening: peak force", found(0.0375, 0.040), &[(RMS, found(0.0137, 0.015))]),
        |row| row.f,
        |state| state.peak.force,
    ),
    (
        group("hardening: peak indentation", found(0.0307, 0.033), &[(RMS, found(0.0105, 0.011))]),
        |row| row.x,
        |state| state.peak.indentation,
    ),
    // a shallow dent would have a large relative deviation
    (
        group(DENT, found(0.0280, 0.030), &[(RMS, found(0.0091, 0.010))]).of_differences(),
        |row| row.residual_share,
        |state| state.peak.residual() / state.peak.indentation,
    ),
    (
        group("hardening: contact radius", found(0.0355, 0.038), &[(RMS, found(0.0143, 0.016))]),
        |row| row.contact_radius,
        |state| state.contact_radius,
    ),
];
const DENT: &str = "hardening: residual indentation, deviation over peak indentation";

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
) -> Result<Option<(Law, f64)>, Error> {
    let plm = Plm {
        coefficients: Arc::new(coefficients.clone()),
        exponent: UnloadingExponent::PressureShape,
        flow: materials.curve().filter(|_| hardens),
    };
    Ok(materials.bodies()?.map(|bodies| (plm.of_bodies(&bodies), bodies.yield_radius_ratio())))
}

pub(super) fn checks(coefficients: &PlmCoefficients) -> Result<Vec<Check>, Error> {
    let rows = unloadings()?;
    let mut states = Vec::with_capacity(rows.len());
    for (materials, row) in &rows {
        if let Some((law, yield_radius_ratio)) = law(materials, coefficients, true)? {
            states.push((row, at_energy(&law, yield_radius_ratio, row.spent)));
        }
    }
    let of = |(group, of_reference, of_law): Quantity| {
        let case = |row: &Unloaded| format!("{}, x = {}", row.material, row.x);
        let numbers = states.iter().map(|(row, state)| (case(row), [of_reference(row), of_law(state)]));
        group.checks(numbers, "unloadings")
    };
    Ok(QUANTITIES.into_iter().flat_map(of).collect())
}
