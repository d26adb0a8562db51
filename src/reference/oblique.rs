//! Measured and computed oblique rebounds.

use serde::Deserialize;

/// A measured rebound of Kharaz, Gorham and Salman (2001).
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Rebound {
    /// `tangential_restitution`, `spin_rad_per_s` or `rebound_angle_deg`.
    pub quantity: String,
    /// Angle of impact from the normal.
    #[serde(rename = "angle_deg")]
    pub angle: f64,
    pub value: f64,
}

/// Slip speed before and after an impact, in units of friction times normal speed.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Slip {
    #[serde(rename = "slip_before")]
    pub before: f64,
    #[serde(rename = "slip_after")]
    pub after: f64,
}

tables! {
    /// The measured rebounds.
    rebounds: Rebound = "kharaz.csv";
    /// The finite elements.
    slips: Slip = "fe_oblique.csv";
}
