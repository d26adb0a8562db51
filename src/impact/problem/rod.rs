//! A long elastic rod in place of the half-space, hit at its end: its mobility, its wave speed and its pulse. The motion on it is
//! that of every [`waveguide`](super::waveguide).
//!
//! ```text
//! Y = 1/(ρ c_0 A),   c_0 = √(E_h/ρ)                             ρ, A, E_h: density, cross section, Young's modulus
//! σ = F/A at the end that is hit; this pulse travels along the rod with c_0
//! ```
//!
//! **Range of validity** (Sears 1908; Hopkinson 1914): the wave is one-dimensional if the pulse is long, c_0 t_c of at least 4 diameters;
//! the contact law of a half-space holds if the contact radius is below a quarter of the radius of the rod; and no wave returns from
//! the far end within the contact time if the rod is longer than c_0 t_c/2.

use std::f64::consts::PI;

use crate::contact::body::Material;

/// A round rod.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rod {
    /// d \[m\], > 0.
    pub diameter: f64,
    /// Length of the rod \[m\], used only for a warning.
    pub length: Option<f64>,
}

impl Rod {
    /// A \[m²\].
    pub fn cross_section(&self) -> f64 {
        0.25 * PI * self.diameter * self.diameter
    }

    /// Y \[s/kg\].
    pub(in crate::impact) fn mobility(&self, material: &Material, density: f64) -> f64 {
        1.0 / (material.youngs_modulus * density).sqrt() / self.cross_section()
    }

    /// c_0 \[m/s\].
    pub(in crate::impact) fn wave_speed(material: &Material, density: f64) -> f64 {
        (material.youngs_modulus / density).sqrt()
    }

    /// c_0 t/2 \[m\]: no wave returns within the time t from the far end of a longer rod.
    pub(in crate::impact) fn wave_reach(wave_speed: f64, time: f64) -> f64 {
        0.5 * wave_speed * time
    }
}
