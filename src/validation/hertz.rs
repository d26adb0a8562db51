//! Checks of elastic impacts, integrated by rk8, against published values and against the closed forms of Hertz.
//!
//! The half-space of this model is never rigid. But a sphere of modulus E on a rigid plane, and a rigid sphere of the
//! same density on a half-space of modulus E, are the same problem: in both F = (4/3) E* √R δ^1.5 with E* = E/(1 − ν²).

use super::ValidationError;
use super::check::{Check, Tolerance};
use crate::impact::{Contact, Impact, Method, Solver};
use crate::law::{Plm, PlmCoefficients};
use crate::material::{HalfSpace, Material, Sphere};
use crate::math::functions::{pow, powi};

const RIGID: Material = Material { youngs_modulus: f64::INFINITY, poissons_ratio: 0.3 };
const CHUNG_OOI: &str = "Hertz impact with the inputs of Chung & Ooi 2011, test 2";
const LAMMPS: &str = "LAMMPS pair granular, hertz/material, wall";
const EXACT: Tolerance = Tolerance { limit: 1e-9, source: "10 x the solver's tolerance" };
const PRINTED: &str = "half a unit of the last digit";
/// Contact time of Hertz's impact in units of peak indentation over speed: (4/5) B(2/5, 1/2).
const HERTZ_TIME: f64 = 2.943_275_184_324_704_7;

struct HertzImpact {
    name: &'static str,
    sphere: Material,
    half_space: Material,
    radius: f64,
    density: f64,
    speed: f64,
    reference: &'static str,
    /// Published values, each with half a unit of its last digit.
    values: &'static [(Quantity, f64, f64)],
}

/// Name, unit, and value in an impact.
type Quantity = (&'static str, &'static str, fn(&Impact) -> f64);

const INDENTATION: Quantity = ("largest indentation", "m", |impact| impact.peak_indentation);
const FORCE: Quantity = ("largest force", "N", |impact| impact.peak_force);
const TIME: Quantity = ("contact time", "s", |impact| impact.contact_time);
const RESTITUTION: Quantity = ("restitution", "", |impact| impact.restitution);

const IMPACTS: [HertzImpact; 4] = [
    HertzImpact {
        name: "aluminium alloy on a rigid plane, 0.2 m/s",
        sphere: RIGID,
        half_space: Material { youngs_modulus: 70e9, poissons_ratio: 0.3 },
        radius: 0.1,
        density: 2699.0,
        speed: 0.2,
        reference: CHUNG_OOI,
        values: &[(INDENTATION, 49.72e-6, 0.005e-6), (FORCE, 11_370.0, 0.5), (TIME, 731.7e-6, 0.05e-6)],
    },
    HertzImpact {
        name: "magnesium alloy on a rigid plane, 0.2 m/s",
        sphere: RIGID,
        half_space: Material { youngs_modulus: 40e9, poissons_ratio: 0.35 },
        radius: 0.1,
        density: 1800.0,
        speed: 0.2,
        reference: CHUNG_OOI,
        values: &[(INDENTATION, 52.12e-6, 0.005e-6), (FORCE, 7233.0, 0.5), (TIME, 767.1e-6, 0.05e-6)],
    },
    HertzImpact {
        name: "100 GPa, wall of the same material, 3.9 m/s",
        sphere: Material { youngs_modulus: 100e9, poissons_ratio: 0.25 },
        half_space: Material { youngs_modulus: 100e9, poissons_ratio: 0.25 },
        radius: 2.5e-3,
        density: 7000.0,
        speed: 3.9,
        reference: LAMMPS,
        values: &[(INDENTATION, 22.6806e-6, 0.000_05e-6)],
    },
    HertzImpact {
        name: "100 GPa, rigid wall, 3.9 m/s",
        sphere: RIGID,
        half_space: Material { youngs_modulus: 100e9, poissons_ratio: 0.25 },
        radius: 2.5e-3,
        density: 7000.0,
        speed: 3.9,
        reference: LAMMPS,
        values: &[(INDENTATION, 17.19e-6, 0.005e-6)],
    },
];

pub(super) fn checks(_: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let mut checks = Vec::new();
    for case in &IMPACTS {
        let sphere = Sphere::elastic(case.radius, case.sphere, case.density);
        let half_space = HalfSpace { material: case.half_space, yield_strength: None, density: None };
        let contact = Contact::try_new(sphere, half_space, &Plm::default())?;
        let solver = Solver { method: Method::Rk8, ..Solver::default() };
        let impact = contact.impact(case.speed, &solver, None)?;
        let mut check = |kind: &str, (quantity, unit, of): Quantity, reference, expected: f64, tolerance| {
            let name = format!("Hertz impact, {kind}: {quantity}");
            let numbers = [expected, of(&impact)];
            checks.push(Check::numbers(&name, case.name.to_owned(), reference, unit, numbers, tolerance));
        };
        for &(quantity, value, half_a_digit) in case.values {
            check(
                "published",
                quantity,
                case.reference,
                value,
                Tolerance { limit: half_a_digit / value, source: PRINTED },
            );
        }
        let plane_strain = |material: Material| material.youngs_modulus / (1.0 - powi(material.poissons_ratio, 2));
        let e_star = 1.0 / (1.0 / plane_strain(case.sphere) + 1.0 / plane_strain(case.half_space));
        let stiffness = 4.0 / 3.0 * e_star * case.radius.sqrt();
        let mass = 4.0 / 3.0 * std::f64::consts::PI * powi(case.radius, 3) * case.density;
        let depth = pow(1.25 * mass * powi(case.speed, 2) / stiffness, 0.4);
        for (quantity, value) in [
            (INDENTATION, depth),
            (FORCE, stiffness * pow(depth, 1.5)),
            (TIME, HERTZ_TIME * depth / case.speed),
            (RESTITUTION, 1.0),
        ] {
            check("exact", quantity, "closed form of Hertz's impact", value, EXACT);
        }
    }
    checks.sort_by(|a, b| a.quantity.cmp(&b.quantity));
    Ok(checks)
}
