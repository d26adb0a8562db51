//! Checks of the program against 30-digit arithmetic: impacts in closed form and integrated. These checks always use the
//! built-in coefficients, also if others are validated.

use serde::Deserialize;

use super::ValidationError;
use super::check::{Check, Tolerance};
use crate::impact::{Contact, Impact, Solver};
use crate::law::{Plm, PlmCoefficients, UnloadingExponent};
use crate::material::Sphere;
use crate::reference::hardening::{Materials, impacts};
use crate::reference::rows;

const INTEGRATED: Tolerance = Tolerance { limit: 1e-8, source: "100 x the default tolerance 1e-10" };

/// A table of exact impacts: what the program computes, and the tolerance of the closed form.
struct Table {
    what: &'static str,
    reference: &'static str,
    exact: Tolerance,
}

const PLM: Table = Table {
    what: "impact under the law",
    reference: "30-digit energy balance and quadrature, src/reference/oracle.csv",
    exact: Tolerance { limit: 5e-14, source: "rounding; two digits are lost in shallow dents" },
};
const HARDENING: Table = Table {
    what: "impact on a half-space that hardens",
    reference: "30-digit energy balance and quadrature, oracle_hardening.csv",
    exact: Tolerance { limit: 1e-12, source: "rounding; two digits are lost in shallow dents" },
};

/// Quantity, unit, exact value, computed value.
type Compared = (&'static str, &'static str, f64, f64);

impl Table {
    /// The checks of one impact.
    fn checks<const N: usize>(
        &self,
        case: &str,
        contact: &Contact,
        speed: f64,
        compared: impl Fn(&Impact) -> [Compared; N],
    ) -> Result<Vec<Check>, ValidationError> {
        let closed = contact.closed_form(speed)?;
        let integrated = contact.impact(speed, &Solver::default(), None)?;
        let mut checks = Vec::new();
        for (form, tolerance, impact) in
            [("closed form", self.exact, closed), ("integrated by rk8", INTEGRATED, integrated)]
        {
            let name = format!("program: {}, {form}", self.what);
            for (quantity, unit, expected, got) in compared(&impact) {
                let case = format!("{case}: {quantity}");
                checks.push(Check::numbers(&name, case, self.reference, unit, [expected, got], tolerance));
            }
        }
        Ok(checks)
    }
}

/// Columns of `oracle.csv` beside those of [`Materials`].
#[derive(Deserialize)]
struct Row {
    case: String,
    radius_m: f64,
    sphere_density_kg_per_m3: f64,
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

pub(super) fn checks(_: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let (name, text) = ("oracle.csv", include_str!("../reference/oracle.csv"));
    let mut checks = Vec::new();
    for (row, materials) in rows::<Row>(name, text)?.iter().zip(rows::<Materials>(name, text)?) {
        let exponent = match row.unloading_exponent.as_str() {
            "pressure-shape" => UnloadingExponent::PressureShape,
            _ => UnloadingExponent::Paper,
        };
        let sphere = Sphere::elastic(row.radius_m, materials.sphere(), row.sphere_density_kg_per_m3);
        let contact = Contact::try_new(sphere, materials.half_space(), &Plm { exponent, ..Plm::default() })?;
        checks.extend(PLM.checks(&row.case, &contact, row.impact_speed_m_per_s, |impact| {
            [
                ("restitution", "", row.restitution, impact.restitution),
                ("contact time", "s", row.contact_time_s, impact.contact_time),
                ("loading time", "s", row.loading_time_s, impact.loading_time),
                ("peak force", "N", row.peak_force, impact.peak_force),
                ("peak indentation", "m", row.peak_indentation_m, impact.peak_indentation),
                ("residual indentation", "m", row.residual_indentation_m, impact.residual_indentation),
                ("elastic approach", "m", row.elastic_approach_m, impact.elastic_approach),
                ("unloading radius", "m", row.unloading_radius_m, impact.unloading_radius),
            ]
        })?);
    }
    checks.sort_by(|a, b| a.quantity.cmp(&b.quantity));
    Ok(checks)
}

pub(super) fn of_hardening() -> Result<Vec<Check>, ValidationError> {
    let mut checks = Vec::new();
    for (materials, row) in impacts()? {
        let sphere = Sphere::elastic(row.radius_m, materials.sphere(), row.sphere_density_kg_per_m3);
        let contact = Contact::try_new(sphere, materials.half_space(), &materials.law(row.exponent()))?;
        checks.extend(HARDENING.checks(&row.case, &contact, row.impact_speed_m_per_s, |impact| {
            [
                ("restitution", "", row.restitution, impact.restitution),
                ("contact time", "s", row.contact_time_s, impact.contact_time),
                ("peak force", "N", row.peak_force, impact.peak_force),
                ("peak indentation", "m", row.peak_indentation_m, impact.peak_indentation),
                ("elastic approach", "m", row.elastic_approach_m, impact.elastic_approach),
                ("contact radius", "m", row.peak_contact_radius_m, impact.peak_contact_radius),
                ("unloading exponent", "", row.unloading_exponent, impact.unloading_exponent),
            ]
        })?);
    }
    checks.sort_by(|a, b| a.quantity.cmp(&b.quantity));
    Ok(checks)
}
