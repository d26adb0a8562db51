//! Restitution, dent and contact time over the speed. A line is a law for the bodies of case 3, steel on steel with 345 MPa; the points
//! have their own bodies, and the deviations in the key are those for the bodies of the points.

use super::question::{AtlasSeries, Origin, Question};
use crate::contact::body::{HalfSpace, Material, STEEL_DENSITY, Sphere};
use crate::contact::law::{LawChoice, Plm, PlmCoefficients, UnloadingExponent};
use crate::error::Error;
use crate::impact::{Contact, ImpactRow, Solver};
use crate::numerics::functions::{exp, ln};
use crate::reference::{HARDENING, RATE_IMPACTS, ReferenceRow, UNLOADINGS};
use crate::report::chart::Axis;
use crate::validate::dynamic::dynamic_scenarios;
use crate::validate::laws::LawDeviations;
use crate::validate::leeb::{LeebPoints, measured_points};
use crate::validate::rate::input_of;
use crate::validate::yielding::yielding_cycles;

/// Speeds over the speed at first yield, from 1/4 to this.
const MAX_SPEED: f64 = 3000.0;
const POINTS: u32 = 120;

/// Energy at first yield over F_Y δ_Y, by Hertz.
const YIELD_ENERGY: f64 = 0.4;

/// v/v_Y of a load cycle that takes this work, in units of first yield.
fn speed_ratio(spent: f64) -> f64 {
    (spent / YIELD_ENERGY).sqrt()
}

/// Points of finite elements: v/v_Y, restitution, residual over peak indentation, contact time over that by Hertz.
type Point = (f64, [Option<f64>; 3]);

/// The bodies of the lines.
fn steel(law: &LawChoice) -> Result<Contact, Error> {
    let [sphere, material] = [208e9, 210e9].map(|youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 });
    let half_space = HalfSpace::flat(material, Some(345e6));
    Ok(Contact::try_new(Sphere::elastic(5e-3, sphere, STEEL_DENSITY), half_space, law.as_contact_law())?)
}

/// The contact time \[s\] of these bodies by Hertz.
fn hertz_time(sphere: Sphere, half_space: HalfSpace, speed: f64) -> Result<f64, Error> {
    let elastic = HalfSpace { yield_strength: None, density: None, ..half_space };
    let contact = Contact::try_new(Sphere { yield_strength: None, ..sphere }, elastic, &Plm::default())?;
    Ok(contact.closed_form(speed)?.row.contact_time)
}

/// The quantities of a computed impact.
fn by_law(contact: &Contact, row: &ImpactRow, speed: f64) -> Result<[f64; 3], Error> {
    let time = hertz_time(*contact.sphere(), *contact.half_space(), speed)?;
    Ok([row.restitution, row.residual_indentation / row.peak_indentation, row.contact_time / time])
}

/// The points of a law at rising speeds, without the speeds at which the law has no answer.
fn law_points(law: &LawChoice) -> Result<Vec<(f64, [f64; 3])>, Error> {
    // all laws have the axis of the PLM, also those with another criterion of yield
    let yield_speed = steel(&LawChoice::Plm(Plm::default()))?.yield_speed().unwrap_or(f64::NAN);
    let Ok(contact) = steel(law) else { return Ok(Vec::new()) };
    let mut points = Vec::new();
    for step in 0..=POINTS {
        let ratio = 0.25 * exp(ln(4.0 * MAX_SPEED) * f64::from(step) / f64::from(POINTS));
        let speed = ratio * yield_speed;
        let Ok(row) = contact.row(speed, &Solver::AUTO) else { continue };
        points.push((ratio, by_law(&contact, &row, speed)?));
    }
    Ok(points)
}

/// The sets of finite elements, with their names.
fn elements(coefficients: &PlmCoefficients) -> Result<Vec<(&'static str, Vec<Point>)>, Error> {
    let cycle = |row: &ReferenceRow| {
        let spent = row.optional_number("spent")?;
        Some((speed_ratio(spent), [row.optional_number("restitution"), row.optional_number("residual_share"), None]))
    };
    let plastic = UNLOADINGS.rows()?.iter().filter_map(cycle).collect();
    let hardening = HARDENING.rows()?.iter().filter_map(cycle).collect();
    let yielding = yielding_cycles(coefficients, UnloadingExponent::PressureShape)?;
    let yielding = yielding.iter().map(|one| {
        let (point, row) = (one.bodies.yield_point, &one.row);
        let spent = row.number("W_J") / (point.force * point.indentation);
        let dent = row.number("residual_m") / row.number("delta_m");
        (speed_ratio(spent), [row.optional_number("e"), Some(dent), None])
    });
    let mut impacts = Vec::new();
    for (input, row, samples) in dynamic_scenarios()? {
        let contact = input.contact()?;
        let speed = input.speed();
        let peak = samples.iter().map(|sample| sample.number("indentation_m")).fold(0.0, f64::max);
        let time = row.number("contact_time_s") / hertz_time(input.sphere(), input.half_space(), speed)?;
        let dent = row.number("residual_indentation_m") / peak;
        let at = speed / contact.yield_speed().unwrap_or(f64::NAN);
        impacts.push((at, [row.optional_number("restitution"), Some(dent), Some(time)]));
    }
    let mut with_rate = Vec::new();
    for row in RATE_IMPACTS.rows()? {
        let input = input_of(&row)?;
        let speed = input.speed();
        let contact = Contact::try_new(input.sphere(), input.half_space(), &Plm::default())?;
        let time = row.number("contact_time_s") / hertz_time(input.sphere(), input.half_space(), speed)?;
        let dent = row.number("residual_indentation_m") / row.number("peak_indentation_m");
        let at = speed / contact.yield_speed().unwrap_or(f64::NAN);
        with_rate.push((at, [row.optional_number("restitution"), Some(dent), Some(time)]));
    }
    Ok(vec![
        ("FE: five pairs, load cycles", plastic),
        ("FE: half-space hardens", hardening),
        ("FE: sphere yields", yielding.collect()),
        ("FE: impacts with waves", impacts),
        ("FE: impacts with strain rate", with_rate),
    ])
}

/// The measured restitutions over v/v_Y: rebound hardness after Leeb.
fn measured(coefficients: &PlmCoefficients) -> Result<Vec<AtlasSeries>, Error> {
    let LeebPoints { blocks, steels } = measured_points(coefficients)?;
    Ok(vec![
        AtlasSeries::new(Origin::Measured, "measured: two steel blocks (Leeb)", blocks),
        AtlasSeries::new(Origin::Measured, "measured: quenched steels (Leeb)", steels),
    ])
}

/// Restitution, dent and contact time.
pub(super) fn questions(
    coefficients: &PlmCoefficients,
    deviations: &[LawDeviations],
    laws: &[(String, LawChoice)],
) -> Result<Vec<Question>, Error> {
    let elements = elements(coefficients)?;
    let of_laws = laws.iter().map(|(_, law)| law_points(law)).collect::<Result<Vec<_>, Error>>()?;
    // the place of a quantity among the points, and among the deviations of a law
    let series = |place: usize, of_deviations: usize| {
        let of_law = laws.iter().zip(&of_laws).map(|((name, _), points)| {
            let points = points.iter().map(|(x, y)| (*x, y[place])).filter(|(_, y)| y.is_finite()).collect();
            let found = deviations.iter().find(|one| one.name == *name);
            let deviation = found.map_or_else(String::new, |one| format!("{:.2} %", 100.0 * one.rms[of_deviations]));
            AtlasSeries { deviation, ..AtlasSeries::new(Origin::Law, name.clone(), points) }
        });
        let of_elements = elements.iter().map(|(name, points)| {
            let points = points.iter().filter_map(|(x, y)| Some((*x, y[place]?))).collect();
            AtlasSeries::new(Origin::FiniteElements, *name, points)
        });
        of_law.chain(of_elements).filter(|one| !one.points.is_empty()).collect::<Vec<_>>()
    };
    let speed = || Axis::log("Speed over that at first yield v/v_Y", "");
    let caption = "lines: steel sphere R 5 mm on steel of 345 MPa; points: their own bodies; % rms against FE";
    let question = |name, title, y, series| Question {
        name,
        title,
        caption,
        axes: [speed(), y],
        has_points_of_laws: false,
        series,
    };
    let mut restitution = series(0, 0);
    restitution.extend(measured(coefficients)?);
    Ok(vec![
        question("restitution", "Restitution", Axis::linear("Restitution e", "").with_range(0.0, 1.02), restitution),
        question(
            "dent",
            "Residual indentation",
            Axis::linear("Residual over peak indentation", "").with_range(0.0, 1.02),
            series(1, 2),
        ),
        question(
            "contact-time",
            "Contact time",
            Axis::linear("Contact time over that by Hertz", "").with_range(0.4, 1.6),
            series(2, 3),
        ),
    ])
}
