//! Checks of the program against 30-digit arithmetic: every impact of `src/reference/oracle.csv`, in closed form and
//! integrated. These checks always use the built-in coefficients, also if others are validated.

use serde::Deserialize;

use super::ValidationError;
use super::check::{Check, Tolerance};
use crate::impact::{Contact, Impact, Solver};
use crate::law::{Plm, PlmCoefficients, UnloadingExponent};
use crate::material::{HalfSpace, Material, Sphere};
use crate::reference::rows;

const REFERENCE: &str = "30-digit energy balance and quadrature, src/reference/oracle.csv";
const EXACT: Tolerance = Tolerance { limit: 5e-14, source: "rounding; two digits are lost in shallow dents" };
const INTEGRATED: Tolerance = Tolerance { limit: 1e-8, source: "100 x the default tolerance 1e-10" };

#[derive(Deserialize)]
struct Row {
    case: String,
    radius_m: f64,
    #[serde(rename = "sphere_youngs_modulus_Pa")]
    sphere_modulus: f64,
    sphere_poissons_ratio: f64,
    sphere_density_kg_per_m3: f64,
    #[serde(rename = "half_space_youngs_modulus_Pa")]
    half_space_modulus: f64,
    half_space_poissons_ratio: f64,
    #[serde(rename = "yield_strength_Pa")]
    yield_strength: f64,
    impact_speed_m_per_s: f64,
    unloading_exponent: String,
    restitution: f64,
    contact_time_s: f64,
    loading_time_s: f64,
    #[serde(rename = "peak_force_N")]
    peak_force: f64,
    peak_indentation_m: f64,
    residual_indentation_m: f64,
    elastic_approach_m: f64,
    unloading_radius_m: f64,
}

impl Row {
    fn contact(&self) -> Result<Contact, ValidationError> {
        let material = |youngs_modulus, poissons_ratio| Material { youngs_modulus, poissons_ratio };
        let sphere = Sphere {
            radius: self.radius_m,
            material: material(self.sphere_modulus, self.sphere_poissons_ratio),
            density: self.sphere_density_kg_per_m3,
            yield_strength: None,
        };
        let half_space = HalfSpace {
            material: material(self.half_space_modulus, self.half_space_poissons_ratio),
            yield_strength: Some(self.yield_strength),
            density: None,
        };
        let exponent = match self.unloading_exponent.as_str() {
            "pressure-shape" => UnloadingExponent::PressureShape,
            _ => UnloadingExponent::Paper,
        };
        Ok(Contact::try_new(sphere, half_space, &Plm { exponent, ..Plm::default() })?)
    }

    fn compared(&self, impact: &Impact) -> [(&'static str, &'static str, f64, f64); 8] {
        [
            ("restitution", "", self.restitution, impact.restitution),
            ("contact time", "s", self.contact_time_s, impact.contact_time),
            ("loading time", "s", self.loading_time_s, impact.loading_time),
            ("peak force", "N", self.peak_force, impact.peak_force),
            ("peak indentation", "m", self.peak_indentation_m, impact.peak_indentation),
            ("residual indentation", "m", self.residual_indentation_m, impact.residual_indentation),
            ("elastic approach", "m", self.elastic_approach_m, impact.elastic_approach),
            ("unloading radius", "m", self.unloading_radius_m, impact.unloading_radius),
        ]
    }
}

pub(super) fn checks(_: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let table: Vec<Row> = rows("oracle.csv", include_str!("../reference/oracle.csv"))?;
    let mut checks = Vec::new();
    for row in &table {
        let contact = row.contact()?;
        let closed = contact.closed_form(row.impact_speed_m_per_s)?;
        let integrated = contact.impact(row.impact_speed_m_per_s, &Solver::default(), None)?;
        for (impact, name, tolerance) in [(closed, "closed form", EXACT), (integrated, "integrated by rk8", INTEGRATED)]
        {
            for (quantity, unit, expected, got) in row.compared(&impact) {
                let case = format!("{}: {quantity}", row.case);
                let name = format!("program: impact under the law, {name}");
                checks.push(Check::numbers(&name, case, REFERENCE, unit, [expected, got], tolerance));
            }
        }
    }
    checks.sort_by(|a, b| a.quantity.cmp(&b.quantity));
    Ok(checks)
}
