//! Restitution on a plate over its thickness: every law with the theory of a thin plate, and the PLM with that of a thick plate. There are
//! neither finite elements nor measurements of it in the references.

use super::question::{AtlasSeries, Origin, Question};
use crate::contact::law::LawChoice;
use crate::error::Error;
use crate::impact::{Forces, Plate, PlateTheory, Solver, Waveguide};
use crate::numerics::functions::{exp, ln};
use crate::report::chart::Axis;
use crate::scenario::Scenario;

/// A steel ball on a steel plate; its thickness is replaced.
const SCENARIO: &str = "[sphere]\ndiameter = 0.01\nyoungs_modulus = 210e9\npoissons_ratio = 0.3\ndensity = 7850\n\
    [half_space]\nyoungs_modulus = 210e9\npoissons_ratio = 0.3\ndensity = 7850\nyield_strength = 345e6\nthickness = 0.01\n\
    [impact]\nspeed = 1\n";
const DIAMETER: f64 = 0.01;
/// The thickest plate over the diameter of the ball, and the number of thicknesses.
const MAX_THICKNESS: f64 = 10.0;
const POINTS: u32 = 30;

fn line(law: &LawChoice, theory: PlateTheory) -> Result<Vec<(f64, f64)>, Error> {
    let input = Scenario::from_text("plate", SCENARIO, &[])?.resolve()?;
    let (sphere, half_space) = input.bodies(law);
    let Ok(contact) = input.contact_of(sphere, half_space, law) else { return Ok(Vec::new()) };
    let Some(plate) = contact.forces().waveguide.as_ref().and_then(Waveguide::plate) else { return Ok(Vec::new()) };
    let mut points = Vec::new();
    for step in 0..=POINTS {
        let ratio = MAX_THICKNESS * exp(ln(0.01) * (1.0 - f64::from(step) / f64::from(POINTS)));
        let plate = Plate { thickness: ratio * DIAMETER, theory, ..*plate };
        let contact =
            contact.clone().with_forces(Forces { waveguide: Some(Waveguide::Plate(plate)), ..*contact.forces() });
        let Ok(row) = contact.row(input.speed(), &Solver::AUTO) else { continue };
        points.push((ratio, row.restitution));
    }
    Ok(points)
}

pub(super) fn question(laws: &[(String, LawChoice)]) -> Result<Question, Error> {
    let mut series = Vec::new();
    for (place, (name, law)) in laws.iter().enumerate() {
        series.push(AtlasSeries::new(Origin::Law, name.clone(), line(law, PlateTheory::Zener)?));
        // the first law is the one whose restitution is nearest to finite elements
        if place == 0 {
            series.push(AtlasSeries::new(Origin::Law, format!("{name}, thick plate"), line(law, PlateTheory::Thick)?));
        }
    }
    series.retain(|one| !one.points.is_empty());
    Ok(Question {
        name: "plate",
        title: "Restitution on a plate",
        caption: "steel ball of 10 mm on steel of 345 MPa at 1 m/s, thin plate; no FE, no measurements",
        axes: [
            Axis::log("Thickness over diameter of the ball", ""),
            Axis::linear("Restitution e", "").with_range(0.0, 1.02),
        ],
        has_points_of_laws: false,
        series,
    })
}
