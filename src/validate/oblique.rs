//! Oblique impacts: measured rebounds of alumina from glass, and finite elements. Both stay elastic, and nothing
//! is fitted to them. Single measured rebounds from a dent are not public; the set of an impact chart has constants of one pair.

use super::comparison::{Comparison, Group};
use crate::contact::body::{HalfSpace, Material, Sphere};
use crate::contact::law::{Plm, PlmCoefficients};
use crate::error::Error;
use crate::impact::oblique::normal_motion::NormalMotion;
use crate::impact::problem::scales::FORCE_FACTOR;
use crate::impact::{Approach, Contact, Rebound, Solver};
use crate::numerics::functions::atan;
use crate::numerics::ode::IntegrationError;
use crate::reference::{OBLIQUE_SLIPS, REBOUNDS};

const KHARAZ: &str = "Kharaz, Gorham and Salman 2001, kharaz.csv";
const FINITE_ELEMENTS: &str = "finite elements, Chung and Ooi 2011, fe_oblique.csv";

/// The sphere of Kharaz et al. and its speed.
pub(super) const RADIUS: f64 = 2.5e-3;
pub(super) const SPEED: f64 = 3.9;
/// Their coefficient of friction, and that of the finite elements.
pub(super) const FRICTION: f64 = 0.092;
const FRICTION_OF_ELEMENTS: f64 = 0.3;

const TANGENTIAL: Group = Group::new_difference("oblique: tangential restitution", KHARAZ, "");
const SPIN: Group = Group::new_difference("oblique: spin, radius times spin over speed", KHARAZ, "");
const ANGLE: Group = Group::new_difference("oblique: rebound angle, deviation over 1 rad", KHARAZ, "rad");
const SLIP: Group = Group::new_difference("oblique: slip speed after the impact over mu v_n", FINITE_ELEMENTS, "");

pub(super) fn alumina_on_glass() -> Result<Contact, Error> {
    let sphere = Sphere::elastic(RADIUS, Material { youngs_modulus: 380e9, poissons_ratio: 0.23 }, 4000.0);
    let glass = Material { youngs_modulus: 70e9, poissons_ratio: 0.25 };
    let half_space = HalfSpace::flat(glass, None);
    Ok(Contact::try_new(sphere, half_space, &Plm::default())?)
}

/// The bodies of the finite elements: a rigid plane under an elastic sphere has the G*/E* of two equal bodies.
pub(super) fn bodies_of_elements() -> Result<Contact, Error> {
    let body = Material { youngs_modulus: 70e9, poissons_ratio: 0.3 };
    Ok(Contact::try_new(Sphere::elastic(RADIUS, body, 2700.0), HalfSpace::flat(body, None), &Plm::default())?)
}

/// The rebound at an angle from the normal \[rad\], without spin before.
pub(super) fn rebound(contact: &Contact, angle: f64, friction: f64) -> Result<Option<Rebound>, Error> {
    let approach = Approach::at_angle(SPEED, angle, 0.0, friction);
    Ok(contact.impact(approach, &Solver::default(), None)?.row.rebound)
}

/// The coefficients of the law have no part in impacts that stay elastic.
pub(super) fn rebounds(_: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let alumina = alumina_on_glass()?;
    let mut compared = Vec::new();
    for row in REBOUNDS.rows()? {
        let [angle, value] = ["angle_deg", "value"].map(|column| row.number(column));
        let Some(after) = rebound(&alumina, angle.to_radians(), FRICTION)? else { continue };
        let (group, numbers) = match row.cell_text("quantity") {
            "tangential_restitution" => (TANGENTIAL, [value, after.tangential_restitution]),
            "spin_rad_per_s" => (SPIN, [value, after.tangential.spin].map(|spin| spin * RADIUS / SPEED)),
            _ => (ANGLE, [value.to_radians(), after.angle]),
        };
        compared.push(group.compare(format!("{angle} deg"), numbers));
    }
    let equal = bodies_of_elements()?;
    for row in OBLIQUE_SLIPS.rows()? {
        let before = row.number("slip_before");
        let angle = atan(FRICTION_OF_ELEMENTS * before);
        let Some(after) = rebound(&equal, angle, FRICTION_OF_ELEMENTS)? else { continue };
        let numbers = [row.number("slip_after"), -after.contact_point_restitution * before];
        compared.push(SLIP.compare(format!("s_0/(mu v_n) = {before}"), numbers));
    }
    Ok(compared)
}

/// s_1/s_0 at this ψ_1 and χ of an elastic impact with one tangential spring, as the contact of a DEM code carries it
/// (`mindlin_rescale/force` of LAMMPS; Thornton, Cummins and Cleary 2013): during unloading the force is first scaled with the
/// radius. Velocity Verlet in 1000 steps a leg.
///
/// ```text
/// T' = −(3/2) α σ,   |T| ≤ f
/// ```
pub fn single_spring_ratio(psi: f64, chi: f64) -> Result<f64, IntegrationError> {
    const STEPS: u32 = 1000;
    let motion = NormalMotion::elastic_motion()?;
    let rate = 2.0 * FORCE_FACTOR * chi;
    let (mut slip, mut force, mut before, mut begun) = (psi, 0.0, 0.0, 0.0);
    for end in motion.leg_ends() {
        let dt = (end - begun) / f64::from(STEPS);
        for k in 1..=STEPS {
            let [after, limit] = motion.radius_and_force(if k == STEPS { end } else { begun + dt * f64::from(k) });
            let half = slip + 0.5 * dt * rate * force;
            let kept: f64 = if after < before { force * after / before } else { force };
            force = (kept - 0.75 * (before + after) * half * dt).clamp(-limit, limit);
            slip = half + 0.5 * dt * rate * force;
            before = after;
        }
        begun = end;
    }
    Ok(slip / psi)
}
