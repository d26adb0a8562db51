//! Measured restitution: rebound hardness after Leeb, which is restitution times 1000.
//!
//! The strength of each test block is found from device D alone. Then the rebound of the other devices, which have
//! other masses, speeds and tips, is predicted with the exponent "pressure-shape" and elastic waves.

use super::comparison::{Comparison, Group};
use crate::contact::body::{HalfSpace, Material, STEEL_DENSITY, Sphere, sphere_volume};
use crate::contact::law::plm::hardness_test::strength_of_hardness;
use crate::contact::law::{Plm, PlmCoefficients, UnloadingExponent};
use crate::contact::strength::hardness::HardnessScale;
use crate::error::Error;
use crate::impact::Contact;
use crate::numerics::functions::{exp, ln};
use crate::numerics::root;
use crate::reference::{LEEB_DEVICES, ReferenceRow};

const REFERENCE: &str = "Leeb test blocks, nominal values of public manuals, leeb.csv";

/// Radius of the tip \[m\].
const TIP: f64 = 1.5e-3;

const GROUP: Group = Group::new("measured: rebound of Leeb devices", REFERENCE, "");

/// The test blocks, by their columns.
const BLOCKS: [(&str, &str); 2] = [("hard block", "hard_block"), ("soft block", "soft_block")];

/// Restitution by a device on steel of this yield strength \[Pa\]; it arrives with √(2 W/m).
pub(super) fn restitution(device: &ReferenceRow, strength: f64, coefficients: &PlmCoefficients) -> Result<f64, Error> {
    let [energy, mass] = ["energy_J", "mass_kg"].map(|column| device.number(column));
    let [youngs_modulus, poissons_ratio] =
        ["tip_youngs_modulus_Pa", "tip_poissons_ratio"].map(|column| device.number(column));
    let sphere = Sphere::elastic(TIP, Material { youngs_modulus, poissons_ratio }, mass / sphere_volume(TIP));
    let half_space = HalfSpace { density: Some(STEEL_DENSITY), ..HalfSpace::flat(Material::STEEL, Some(strength)) };
    let law = Plm::new(coefficients, UnloadingExponent::PressureShape);
    let impact = Contact::try_new(sphere, half_space, &law)?.closed_form((2.0 * energy / mass).sqrt())?;
    Ok(impact.row.measured_restitution())
}

/// The yield strength \[Pa\] of a block on which the device measures this restitution, by bisection: e rises with the
/// strength.
fn strength_for(device: &ReferenceRow, wanted: f64, coefficients: &PlmCoefficients) -> f64 {
    let is_low = |strength: f64| restitution(device, exp(strength), coefficients).is_ok_and(|e| e < wanted);
    let (low, high) = root::bisect(ln(1e7), ln(1e11), is_low);
    exp(0.5 * (low + high))
}

const CONVERSION: &str = "Leeb's conversion of hardness: a fit (T. Foale) to an unnamed conversion table; one row checked against ASTM E140 within 1.4 %";
const BY_HARDNESS: Group =
    Group::new("restitution of quenched steels by their hardness, pressure-shape with waves", CONVERSION, "");

/// The Vickers hardness of a steel on which device D shows this number.
fn vickers(number: f64) -> f64 {
    (0.002_641_69 * number - 1.900_271) * number + 519.8346
}

/// Nothing is fitted: the strength is that of the hardness, without a strain rate.
pub(super) fn restitutions_by_hardness(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let devices = LEEB_DEVICES.rows()?;
    let Some(device) = devices.first() else { return Ok(Vec::new()) };
    let compared = |number: u16| {
        let (number, hardness) = (f64::from(number), vickers(number.into()));
        let pressure =
            HardnessScale::Vickers.mean_pressure(hardness).map_err(|error| Error::failed(error.to_string()))?;
        let strength = strength_of_hardness(pressure, None, &Material::STEEL);
        let numbers = [number / 1000.0, restitution(device, strength, coefficients)?];
        Ok(BY_HARDNESS.compare(format!("{hardness:.0} HV"), numbers))
    };
    (500..=860).step_by(20).map(compared).collect()
}

pub(super) fn rebounds(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let devices = LEEB_DEVICES.rows()?;
    let Some((first, others)) = devices.split_first() else { return Ok(Vec::new()) };
    let mut compared = Vec::new();
    for (block, column) in BLOCKS {
        let strength = strength_for(first, first.number(column) / 1000.0, coefficients);
        for device in others {
            let case =
                format!("{block}, device {}, strength from D {:.0} MPa", device.cell_text("device"), strength / 1e6);
            let numbers = [device.number(column) / 1000.0, restitution(device, strength, coefficients)?];
            compared.push(GROUP.compare(case, numbers));
        }
    }
    Ok(compared)
}
