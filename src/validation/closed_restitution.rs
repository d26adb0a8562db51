//! Checks of published laws whose restitution has a closed form: Thornton (1997) and Johnson (1985), integrated by rk8.

use super::ValidationError;
use super::check::{Check, Tolerance};
use crate::impact::{Contact, Method, Solver};
use crate::law::catalogue::johnson::{self, Johnson};
use crate::law::catalogue::thornton::{self, Thornton};
use crate::law::{ContactLaw, PlmCoefficients};
use crate::material::{HalfSpace, Material, Sphere};

const STRENGTH: f64 = 345e6;
const TOLERANCE: Tolerance = Tolerance { limit: 1e-9, source: "10 x the solver's tolerance" };

/// Case 3 of Xie et al. (2024), Table 1, with the density of steel.
fn contact(law: &dyn ContactLaw) -> Result<Contact, ValidationError> {
    let sphere = Sphere::elastic(35e-3, Material { youngs_modulus: 208e9, poissons_ratio: 0.3 }, 7850.0);
    let half_space = HalfSpace {
        material: Material { youngs_modulus: 210e9, poissons_ratio: 0.3 },
        yield_strength: Some(STRENGTH),
        density: None,
    };
    Ok(Contact::try_new(sphere, half_space, law)?)
}

pub(super) fn checks(_: &PlmCoefficients) -> Result<Vec<Check>, ValidationError> {
    let solver = Solver { method: Method::Rk8, ..Solver::default() };
    let mut checks = Vec::new();
    let mut compare = |contact: &Contact, speed: f64, case: String, law: &str, reference, expected: f64| {
        let got = contact.impact(speed, &solver, None)?.restitution;
        let name = format!("restitution of {law}'s law");
        checks.push(Check::numbers(&name, case, reference, "", [expected, got], TOLERANCE));
        Ok::<_, ValidationError>(())
    };
    // the yield pressure is given as 1.6 σ_Y, so that the yield point does not come from the program
    let pressure = 1.6 * STRENGTH;
    let by_thornton = contact(&Thornton { yield_pressure: Some(pressure) })?;
    let (radius, mass) = (by_thornton.sphere().radius, by_thornton.mass());
    let modulus = by_thornton.pair().effective_modulus;
    let yield_speed = thornton::yield_speed(modulus, radius, mass, pressure);
    for ratio in [1.0, 1.5, 3.0, 10.0, 100.0, 1e4] {
        let (speed, case) = (ratio * yield_speed, format!("case 3, {ratio} x the yield speed"));
        let expected = thornton::restitution(1.0 / ratio);
        compare(&by_thornton, speed, case, "Thornton", "Thornton 1997, e(v) in closed form", expected)?;
    }
    let pressure = 3.0 * STRENGTH;
    let by_johnson = contact(&Johnson { dynamic_pressure: Some(pressure) })?;
    for speed in [1.0, 3.0, 10.0, 30.0] {
        let case = format!("case 3, {speed} m/s");
        let expected = johnson::restitution(modulus, pressure, mass, radius, speed);
        compare(&by_johnson, speed, case, "Johnson", "Johnson 1985, e(v) in closed form", expected)?;
    }
    Ok(checks)
}
