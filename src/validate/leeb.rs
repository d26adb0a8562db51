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

/// The contact of a device with steel of this yield strength \[Pa\], and its speed \[m/s\]: it arrives with √(2 W/m).
fn contact(device: &ReferenceRow, strength: f64, coefficients: &PlmCoefficients) -> Result<(Contact, f64), Error> {
    let [energy, mass] = ["energy_J", "mass_kg"].map(|column| device.number(column));
    let [youngs_modulus, poissons_ratio] =
        ["tip_youngs_modulus_Pa", "tip_poissons_ratio"].map(|column| device.number(column));
    let sphere = Sphere::elastic(TIP, Material { youngs_modulus, poissons_ratio }, mass / sphere_volume(TIP));
    let half_space = HalfSpace { density: Some(STEEL_DENSITY), ..HalfSpace::flat(Material::STEEL, Some(strength)) };
    let law = Plm::new(coefficients, UnloadingExponent::PressureShape);
    Ok((Contact::try_new(sphere, half_space, &law)?, (2.0 * energy / mass).sqrt()))
}

/// Restitution by a device on steel of this yield strength \[Pa\].
pub(super) fn restitution(device: &ReferenceRow, strength: f64, coefficients: &PlmCoefficients) -> Result<f64, Error> {
    let (contact, speed) = contact(device, strength, coefficients)?;
    Ok(contact.closed_form(speed)?.row.measured_restitution())
}

/// The measured restitutions over the speed over that at first yield.
pub(super) struct LeebPoints {
    /// The devices that did not give the strength of their block.
    pub(super) blocks: Vec<(f64, f64)>,
    /// Quenched steels with the strength of their hardness.
    pub(super) steels: Vec<(f64, f64)>,
}

pub(super) fn measured_points(coefficients: &PlmCoefficients) -> Result<LeebPoints, Error> {
    let devices = LEEB_DEVICES.rows()?;
    let (mut blocks, mut steels) = (Vec::new(), Vec::new());
    let Some((first, others)) = devices.split_first() else { return Ok(LeebPoints { blocks, steels }) };
    let speed_ratio = |device: &ReferenceRow, strength: f64| -> Result<f64, Error> {
        let (contact, speed) = contact(device, strength, coefficients)?;
        Ok(speed / contact.yield_speed().unwrap_or(f64::NAN))
    };
    for (_, column) in BLOCKS {
        let strength = strength_for(first, first.number(column) / 1000.0, coefficients);
        for device in others {
            blocks.push((speed_ratio(device, strength)?, device.number(column) / 1000.0));
        }
    }
    for number in leeb_numbers() {
        steels.push((speed_ratio(first, strength_of_number(number)?)?, number / 1000.0));
    }
    Ok(LeebPoints { blocks, steels })
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

/// The numbers of device D that are compared.
pub(super) fn leeb_numbers() -> impl Iterator<Item = f64> {
    (500..=860).step_by(20).map(f64::from)
}

/// The Vickers hardness of a steel on which device D shows this number.
pub(super) fn vickers(number: f64) -> f64 {
    (0.002_641_69 * number - 1.900_271) * number + 519.8346
}

/// The yield strength \[Pa\] of a steel on which device D shows this number, by its hardness.
fn strength_of_number(number: f64) -> Result<f64, Error> {
    let pressure = HardnessScale::Vickers.mean_pressure(vickers(number));
    let pressure = pressure.map_err(|error| Error::failed(error.to_string()))?;
    Ok(strength_of_hardness(pressure, None, &Material::STEEL))
}

/// Nothing is fitted: the strength is that of the hardness, without a strain rate.
pub(super) fn restitutions_by_hardness(coefficients: &PlmCoefficients) -> Result<Vec<Comparison>, Error> {
    let devices = LEEB_DEVICES.rows()?;
    let Some(device) = devices.first() else { return Ok(Vec::new()) };
    let compared = |number: f64| {
        let numbers = [number / 1000.0, restitution(device, strength_of_number(number)?, coefficients)?];
        Ok(BY_HARDNESS.compare(format!("{:.0} HV", vickers(number)), numbers))
    };
    leeb_numbers().map(compared).collect()
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
