//! Shot peening: how many impacts at random places cover a surface, and the mass and the time of these impacts.
//!
//! ```text
//! C(N) = 1 − exp(−N A)             A = π a²: area of a dent, N: impacts per area (Kolmogorov, Johnson and Mehl, Avrami)
//! N(C) = −ln(1 − C)/A              0.98, which peeners call full coverage: N = ln 50/A
//! ```
//!
//! With dents of several sizes A is their mean area, because the probability that no dent covers a point is exp(−N E\[A\]).

use crate::numerics::functions::{exp, ln};

/// The request of `[peening]` on a contact. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peening {
    /// The covered fraction of the surface that is to be reached.
    pub coverage: f64,
    /// Mass flow over area \[kg/(m² s)\], if both are given.
    pub mass_flux: Option<f64>,
    /// Time of peening \[s\].
    pub time: Option<f64>,
}

/// Dents and shots of a peened surface: their means, if they scatter. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeenedSurface {
    pub request: Peening,
    /// Area of a dent \[m²\]; 0 without a dent.
    pub dent_area: f64,
    /// Mass of a shot \[kg\].
    pub shot_mass: f64,
}

impl PeenedSurface {
    /// Impacts per area for the coverage \[1/m²\]; `None` without a dent.
    pub fn impacts_per_area(&self) -> Option<f64> {
        (self.dent_area > 0.0).then(|| -ln(1.0 - self.request.coverage) / self.dent_area)
    }

    /// Mass of shot per area for the coverage \[kg/m²\].
    pub fn mass_per_area(&self) -> Option<f64> {
        self.impacts_per_area().map(|impacts| impacts * self.shot_mass)
    }

    /// Time for the coverage \[s\].
    pub fn time(&self) -> Option<f64> {
        Some(self.mass_per_area()? / self.request.mass_flux?)
    }

    /// The covered fraction of the surface after the time of peening.
    pub fn coverage_after_time(&self) -> Option<f64> {
        let impacts = self.request.mass_flux? * self.request.time? / self.shot_mass;
        Some(1.0 - exp(-impacts * self.dent_area))
    }
}
