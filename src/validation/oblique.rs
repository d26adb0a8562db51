//! Checks of oblique impacts: measured rebounds of alumina from glass, and finite elements. Both stay elastic, and nothing
//! is fitted to them. Measured oblique rebounds from a dent are not public.

use super::check::{Check, Group, RMS, found};
use crate::error::Error;
use crate::impact::{Approach, Contact, Incidence, Rebound, Solver};
use crate::law::{Plm, PlmCoefficients};
use crate::material::{HalfSpace, Material, Sphere};
use crate::math::functions::atan;
use crate::reference::oblique::{rebounds, slips};

const KHARAZ: &str = "Kharaz, Gorham and Salman 2001, kharaz.csv";
const FINITE_ELEMENTS: &str = "finite elements, Chung and Ooi 2011, fe_oblique.csv";

/// The sphere of Kharaz et al. and its speed.
pub(super) const RADIUS: f64 = 2.5e-3;
pub(super) const SPEED: f64 = 3.9;
/// Their coefficient of friction, and that of the finite elements.
pub(super) const FRICTION: f64 = 0.092;
const FRICTION_OF_ELEMENTS: f64 = 0.3;

const TANGENTIAL: Group = Group::of("oblique: tangential restitution", KHARAZ, "", found(0.0299, 0.032))
    .of_differences()
    .with_overall(&[(RMS, found(0.0135, 0.0142))]);
const SPIN: Group = Group::of("oblique: spin, radius times spin over speed", KHARAZ, "", found(0.0244, 0.026))
    .of_differences()
    .with_overall(&[(RMS, found(0.0132, 0.0140))]);
const ANGLE: Group = Group::of("oblique: rebound angle, deviation over 1 rad", KHARAZ, "rad", found(0.0056, 0.006))
    .of_differences()
    .with_overall(&[(RMS, found(0.0033, 0.0036))]);
const SLIP: Group =
    Group::of("oblique: slip speed after the impact over mu v_n", FINITE_ELEMENTS, "", found(0.1496, 0.16))
        .of_differences()
        .with_overall(&[(RMS, found(0.0666, 0.070))]);

/// Alumina on glass.
pub(super) fn alumina_on_glass() -> Result<Contact, Error> {
    let sphere = Sphere::elastic(RADIUS, Material { youngs_modulus: 380e9, poissons_ratio: 0.23 }, 4000.0);
    let glass = Material { youngs_modulus: 70e9, poissons_ratio: 0.25 };
    let half_space = HalfSpace { material: glass, yield_strength: None, density: None };
    Ok(Contact::try_new(sphere, half_space, &Plm::default())?)
}

/// The rebound at an angle from the normal \[rad\], without spin before.
pub(super) fn rebound(contact: &Contact, angle: f64, friction: f64) -> Result<Option<Rebound>, Error> {
    let approach = Approach { speed: SPEED, incidence: Some(Incidence { angle, spin: 0.0, friction }) };
    Ok(contact.impact(approach, &Solver::default(), None)?.rebound)
}

/// The coefficients of the law have no part in impacts that stay elastic.
pub(super) fn checks(_: &PlmCoefficients) -> Result<Vec<Check>, Error> {
    let alumina = alumina_on_glass()?;
    let mut numbers = [Vec::new(), Vec::new(), Vec::new()];
    for row in rebounds()? {
        let Some(after) = rebound(&alumina, row.angle.to_radians(), FRICTION)? else { continue };
        let (of, pair) = match row.quantity.as_str() {
            "tangential_restitution" => (0, [row.value, after.tangential_restitution]),
            "spin_rad_per_s" => (1, [row.value, after.spin].map(|spin| spin * RADIUS / SPEED)),
            _ => (2, [row.value.to_radians(), after.angle]),
        };
        numbers[of].push((format!("{} deg", row.angle), pair));
    }
    // a rigid plane under an elastic sphere has the G*/E* of two equal bodies
    let body = Material { youngs_modulus: 70e9, poissons_ratio: 0.3 };
    let half_space = HalfSpace { material: body, yield_strength: None, density: None };
    let equal = Contact::try_new(Sphere::elastic(RADIUS, body, 2700.0), half_space, &Plm::default())?;
    let mut slipped = Vec::new();
    for row in slips()? {
        let angle = atan(FRICTION_OF_ELEMENTS * row.before);
        let Some(after) = rebound(&equal, angle, FRICTION_OF_ELEMENTS)? else { continue };
        let got = -after.contact_point_restitution * row.before;
        slipped.push((format!("s_0/(mu v_n) = {}", row.before), [row.after, got]));
    }
    let of_angles = [TANGENTIAL, SPIN, ANGLE].into_iter().zip(numbers);
    let measured = of_angles.flat_map(|(group, numbers)| group.checks(numbers, "rebounds"));
    Ok(measured.chain(SLIP.checks(slipped, "impacts")).collect())
}
