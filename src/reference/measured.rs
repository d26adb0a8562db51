//! Public measurements of restitution: rebound hardness after Leeb.

use serde::Deserialize;

use crate::material::Material;

/// An impact device, and what it shows on two test blocks.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Device {
    /// "D".
    #[serde(rename = "device")]
    pub name: String,
    #[serde(rename = "energy_J")]
    energy: f64,
    /// Of the body that rebounds \[kg\].
    #[serde(rename = "mass_kg")]
    pub mass: f64,
    #[serde(rename = "tip_youngs_modulus_Pa")]
    tip_modulus: f64,
    tip_poissons_ratio: f64,
    hard_block: f64,
    soft_block: f64,
}

impl Device {
    pub fn tip(&self) -> Material {
        Material { youngs_modulus: self.tip_modulus, poissons_ratio: self.tip_poissons_ratio }
    }

    /// Impact speed √(2 W/m) \[m/s\].
    pub fn speed(&self) -> f64 {
        (2.0 * self.energy / self.mass).sqrt()
    }
}

/// A test block: its name, and its HL by a device.
pub type Block = (&'static str, fn(&Device) -> f64);

pub const BLOCKS: [Block; 2] = [("hard block", |device| device.hard_block), ("soft block", |device| device.soft_block)];

/// Ends of the range of a steel.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Steel {
    pub steel: String,
    #[serde(rename = "low_HLD")]
    low_hardness: f64,
    #[serde(rename = "high_HLD")]
    high_hardness: f64,
    #[serde(rename = "low_tensile_strength_MPa")]
    low_strength: f64,
    #[serde(rename = "high_tensile_strength_MPa")]
    high_strength: f64,
}

impl Steel {
    /// Tensile strength \[MPa\] and HLD at both ends.
    pub fn ends(&self) -> [(f64, f64); 2] {
        [(self.low_strength, self.low_hardness), (self.high_strength, self.high_hardness)]
    }
}

tables! {
    /// The devices, D first.
    devices: Device = "leeb.csv";
    /// Tensile strength of steels against HLD.
    steels: Steel = "leeb_tensile.csv";
}
