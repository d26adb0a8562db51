//! Published rebounds: rebound hardness after Leeb, the bounces of a table-tennis ball, and oblique rebounds, measured and
//! computed.

use crate::contact::material::Material;

rows! {
    /// An impact device, and what it shows on two test blocks.
    pub struct Device read by devices from "leeb.csv" {
        /// "D".
        pub name as "device": String,
        energy as "energy_J": f64,
        /// Mass of the body that rebounds \[kg\].
        pub mass as "mass_kg": f64,
        tip_modulus as "tip_youngs_modulus_Pa": f64,
        tip_poissons_ratio: f64,
        hard_block: f64,
        soft_block: f64,
    }
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

rows! {
    /// Ends of the range of a steel.
    pub struct Steel read by steels from "leeb_tensile.csv" {
        pub steel: String,
        low_hardness as "low_HLD": f64,
        high_hardness as "high_HLD": f64,
        low_strength as "low_tensile_strength_MPa": f64,
        high_strength as "high_tensile_strength_MPa": f64,
    }
}

impl Steel {
    /// Tensile strength \[MPa\] and HLD at both ends.
    pub fn ends(&self) -> [(f64, f64); 2] {
        [(self.low_strength, self.low_hardness), (self.high_strength, self.high_hardness)]
    }
}

rows! {
    /// The time between two bounces of a table-tennis ball; the height stands in the first line of a drop.
    pub struct Click read by clicks from "../../../scenarios/clicks.csv" {
        /// \[cm\].
        pub height as "drop_height_cm": Option<f64>,
        /// \[s\].
        pub interval as "bounce_interval_s": f64,
    }
}

rows! {
    /// A measured rebound of Kharaz, Gorham and Salman (2001).
    pub struct Rebound read by rebounds from "kharaz.csv" {
        /// `tangential_restitution`, `spin_rad_per_s` or `rebound_angle_deg`.
        pub quantity: String,
        /// Angle of impact from the normal.
        pub angle as "angle_deg": f64,
        pub value: f64,
    }
}

rows! {
    /// Slip speed before and after an impact, in units of friction times normal speed.
    pub struct Slip read by slips from "fe_oblique.csv" {
        pub before as "slip_before": f64,
        pub after as "slip_after": f64,
    }
}
