//! Checks of a half-space that hardens: the law, loaded with the same work as the finite elements, and the program
//! against exact impacts.

use std::sync::Arc;

use super::ValidationError;
use super::check::{Check, Tolerance, rms};
use crate::impact::{Contact, Solver};
use crate::law::{Law, Peak, Plm, PlmCoefficients, UnloadingExponent};
use crate::material::Sphere;
use crate::reference::hardening::{ExactImpact, Materials, impacts, unloadings};
use crate::reference::unloading::Unloaded;

const REFERENCE: &str = "finite elements, CalculiX 2.20, fe_hardening.csv";
const EXACT_REFERENCE: &str = "30-digit energy balance and quadrature, oracle_hardening.csv";
const EXACT: Tolerance = Tolerance { limit: 1e-12, source: "rounding; two digits are lost in shallow dents" };
const INTEGRATED: Tolerance = Tolerance { limit: 1e-8, source: "100 x the default tolerance 1e-10" };

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
    let mut checks = Vec::new();
    for Quantity { name, of_reference, of_law, of_one, of_rms } in QUANTITIES {
        let is_difference = name == DENT;
        let name = format!("hardening: {name}");
        let of_row = |(row, state): &(&Unloaded, AtEnergy)| {
            let case = format!("{}, x = {}", row.material, row.x);
            let numbers = [of_reference(row), of_law(state)];
            let check = Check::numbers(&name, case, REFERENCE, "", numbers, of_one);
            if is_difference { Check { deviation: numbers[1] - numbers[0], ..check } } else { check }
        };
        let first = checks.len();
        checks.extend(states.iter().map(of_row));
        let deviations: Vec<f64> = checks[first..].iter().map(|check: &Check| check.deviation).collect();
        let over = format!("{} unloadings", deviations.len());
        checks.push(Check::mean(&format!("{name}, rms"), over, REFERENCE, rms(&deviations), of_rms));
    }
    checks.extend(of_program()?);
    Ok(checks)
}

/// Checks of closed form and integration against the exact impacts, which have the built-in law.
fn of_program() -> Result<Vec<Check>, ValidationError> {
    let mut checks = Vec::new();
    let rows = impacts()?;
    for (name, tolerance, is_exact) in [("closed form", EXACT, true), ("integrated by rk8", INTEGRATED, false)] {
        let name = format!("program: impact on a half-space that hardens, {name}");
        for (materials, row) in &rows {
            let contact = contact(materials, row)?;
            let speed = row.impact_speed_m_per_s;
            let got =
                if is_exact { contact.closed_form(speed)? } else { contact.impact(speed, &Solver::default(), None)? };
            for (quantity, unit, expected, got) in [
                ("restitution", "", row.restitution, got.restitution),
                ("contact time", "s", row.contact_time_s, got.contact_time),
                ("peak force", "N", row.peak_force, got.peak_force),
                ("peak indentation", "m", row.peak_indentation_m, got.peak_indentation),
                ("elastic approach", "m", row.elastic_approach_m, got.elastic_approach),
                ("contact radius", "m", row.peak_contact_radius_m, got.peak_contact_radius),
                ("unloading exponent", "", row.unloading_exponent, got.unloading_exponent),
            ] {
                let case = format!("{}: {quantity}", row.case);
                checks.push(Check::numbers(&name, case, EXACT_REFERENCE, unit, [expected, got], tolerance));
            }
        }
    }
    Ok(checks)
}

fn contact(materials: &Materials, row: &ExactImpact) -> Result<Contact, ValidationError> {
    let sphere = Sphere {
        radius: row.radius_m,
        material: materials.sphere(),
        density: row.sphere_density_kg_per_m3,
        yield_strength: None,
    };
    Ok(Contact::try_new(sphere, materials.half_space(), &materials.law(row.exponent()))?)
}
