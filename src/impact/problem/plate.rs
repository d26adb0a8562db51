//! A large thin plate in place of the half-space: its mobility, its wave speed and its bending waves. The motion on it is that of
//! every [`waveguide`](super::waveguide).
//!
//! ```text
//! Y = 1/(8 √(D ρ h)),   D = E_h* h³/12                          ρ, h, E_h*: density, thickness, plane-strain modulus
//! ```
//!
//! **Range of validity**, against the exact motion of an elastic layer (Rayleigh and Lamb): X = c_p t_c/h is the number of plate
//! thicknesses that a wave of speed c_p = √(E_h*/ρ) travels in the contact time t_c of the impact on a half-space. The loss is at most
//! 21 % above Zener's from X = 10 on, and 4 % from X = 50 on. Below X = 2 the plate is a half-space. The first term of a thick plate,
//! Y (1 + 1.86 h/(c_p t_c)), brings the loss within 8 % from X = 5 on and within 2 % from X = 10 on. Bending waves return in time from
//! an edge that is nearer than 2 √(c t_c), c = √(D/(ρ h)).

use crate::contact::body::Material;
use crate::strings::names::named_enum;

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    /// h \[m\], > 0.
    pub thickness: f64,
    /// Distance of the nearest edge \[m\], used only for a warning.
    pub edge_distance: Option<f64>,
    pub theory: PlateTheory,
}

named_enum! {
    /// The theory of the plate.
    #[derive(Default)]
    pub enum PlateTheory {
        #[default]
        Zener = "zener",
        /// With the first term of a thick plate.
        Thick = "thick",
    }
}

impl Plate {
    /// Y of the thin plate \[s/kg\].
    pub(in crate::impact) fn mobility(&self, material: &Material, density: f64) -> f64 {
        // 1/(8 √(D ρ h)) with √12/8 = 0.433
        12.0_f64.sqrt() / 8.0 / (material.plane_strain_modulus() * density).sqrt() / self.thickness / self.thickness
    }

    /// c_p = √(E_h*/ρ) \[m/s\].
    pub(in crate::impact) fn wave_speed(material: &Material, density: f64) -> f64 {
        (material.plane_strain_modulus() / density).sqrt()
    }

    /// 2 √(c t) \[m\], c = c_p h/√12: no bending wave returns within the time t from an edge that is farther away.
    pub(in crate::impact) fn wave_reach(&self, wave_speed: f64, time: f64) -> f64 {
        2.0 * (wave_speed * self.thickness / 12.0_f64.sqrt() * time).sqrt()
    }

    /// Y of this theory over Y of the thin plate, for this X.
    pub(in crate::impact) fn correction(&self, wave_transits: f64) -> f64 {
        match self.theory {
            PlateTheory::Zener => 1.0,
            PlateTheory::Thick => 1.0 + 1.86 / wave_transits,
        }
    }
}
