//! Slip after an oblique impact over slip before, dimensionless as by Maw, Barber and Fawcett (1976): one curve for each χ.

use super::question::{AtlasSeries, Origin, Question};
use crate::contact::law::PlmCoefficients;
use crate::error::Error;
use crate::impact::{Contact, ImpactError};
use crate::numerics::functions::{atan, sin_cos};
use crate::reference::{OBLIQUE_SLIPS, REBOUNDS};
use crate::report::chart::Axis;
use crate::validate::measured::glass_balls;
use crate::validate::oblique::{FRICTION, alumina_on_glass, bodies_of_elements, rebound, single_spring_ratio};

/// The largest ψ_1 of the lines.
const MAX_PSI: f64 = 16.0;
const POINTS: u32 = 160;

/// s_1/s_0 at this ψ_1 of a rigid body, which slides or rolls in the end.
fn rigid_ratio(psi: f64, chi: f64) -> f64 {
    (1.0 - 4.0 * chi / psi).max(0.0)
}

/// The lines, for the bodies of the measured rebounds of alumina from glass.
fn lines(contact: &Contact) -> Result<[Vec<(f64, f64)>; 3], Error> {
    let chi = contact.chi();
    let mut lines = [Vec::new(), Vec::new(), Vec::new()];
    for step in 1..=POINTS {
        let wanted = MAX_PSI * f64::from(step) / f64::from(POINTS);
        let angle = atan(wanted * FRICTION / (4.0 * contact.shear_ratio()));
        let Some(after) = rebound(contact, angle, FRICTION)? else { continue };
        let psi = after.psi;
        let spring = single_spring_ratio(psi, chi).map_err(ImpactError::from)?;
        for (line, ratio) in lines.iter_mut().zip([-after.contact_point_restitution, spring, rigid_ratio(psi, chi)]) {
            line.push((psi, ratio * psi));
        }
    }
    Ok(lines)
}

pub(super) fn question() -> Result<Question, Error> {
    let alumina = alumina_on_glass()?;
    let psi_of = |contact: &Contact, slip: f64| 4.0 * contact.shear_ratio() * slip;
    let rows = REBOUNDS.rows()?;
    let kharaz = rows.iter().filter(|row| row.cell_text("quantity") == "tangential_restitution").map(|row| {
        let (sin, cos) = sin_cos(row.number("angle_deg").to_radians());
        let psi = psi_of(&alumina, sin / cos / FRICTION);
        (psi, psi * (1.0 + (row.number("value") - 1.0) * alumina.slip_factor()))
    });
    let equal = bodies_of_elements()?;
    let slips = OBLIQUE_SLIPS.rows()?;
    let elements =
        slips.iter().map(|row| (psi_of(&equal, row.number("slip_before")), psi_of(&equal, row.number("slip_after"))));
    let glass = glass_balls(PlmCoefficients::built_in())?;
    let [program, spring, rigid] = lines(&alumina)?;
    let deviation = |place: usize| glass.deviations.get(place).map_or_else(String::new, |rms| format!("{rms:.3} m/s"));
    let law = |name: &str, deviation, points| AtlasSeries { deviation, ..AtlasSeries::new(Origin::Law, name, points) };
    let series = vec![
        law("Mindlin, this program", deviation(0), program),
        law("one spring, as in LAMMPS", deviation(1), spring),
        law("rigid body", deviation(2), rigid),
        AtlasSeries::new(Origin::FiniteElements, "FE: Chung and Ooi 2011", elements.collect()),
        AtlasSeries::new(Origin::Measured, "measured: alumina on glass", kharaz.collect()),
        AtlasSeries::new(Origin::Measured, "measured: two glass balls", glass.slips),
    ];
    Ok(Question {
        name: "oblique",
        title: "Slip after an oblique impact",
        caption: "ψ = 4 (G*/E*) s/(μ vₙ) with the slip speed s; lines: alumina on glass; m/s: rms of the tangential speed of glass balls",
        axes: [Axis::linear("ψ₁ before", ""), Axis::linear("ψ₂ after", "")],
        has_points_of_laws: false,
        series,
    })
}
