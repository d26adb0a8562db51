//! A large thin plate in place of the half-space: the plate gives way under the impact and absorbs energy as bending waves.
//!
//! Under a force F an infinite plate moves with w' = Y F at every instant (Zener 1941, Phys. Rev. 59, 669-673). So for the centre of
//! the sphere, p, and for the approach δ
//!
//! ```text
//! Y = 1/(8 √(D ρ h)),   D = E_h* h³/12                          ρ, h, E_h*: density, thickness, plane-strain modulus
//! m p' = −F + m g,   δ' = p − Y F    <=>    m δ'' = −F + m g − m Y F' δ'
//! ```
//!
//! So the plate acts as a drag on the motion, and not in the contact force. In the units of an impact y = Y Φ/V, and
//!
//! ```text
//! sphere   0.4 p²,  p = u + y f         plate   E_p = 0.8 ∫ drag u dτ − 0.8 y f u − 0.4 y² f² + w w_p
//! plate's displacement   w_p = y (w τ + 0.8 (q − p))             w = m g/Φ
//! ```
//!
//! Zener's number λ = Y m/T, T = (m/(K √v))^(2/5) with Hertz's K, measures the loss. For an elastic contact e = 1 − 1.73 λ for small
//! λ, and 0.679 λ^−5 for large λ.
//!
//! **Range of validity**, against the exact motion of an elastic layer (Rayleigh and Lamb): X = c_p t_c/h is the number of plate
//! thicknesses that a wave of speed c_p = √(E_h*/ρ) travels in the contact time t_c of the impact on a half-space. The loss is at most
//! 21 % above Zener's from X = 10 on, and 4 % from X = 50 on. Below X = 2 the plate is a half-space. The first term of a thick plate,
//! Y (1 + 1.86 h/(c_p t_c)), brings the loss within 8 % from X = 5 on and within 2 % from X = 10 on. Bending waves return in time from
//! an edge that is nearer than 2 √(c t_c), c = √(D/(ρ h)).

use thiserror::Error;

use super::scales::Scales;
use crate::contact::body::HalfSpace;
use crate::contact::law::Law;
use crate::numerics::functions::{pow, powi};
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

/// The largest λ with a result: e is below 3e-7 there.
pub const MAX_ZENER_NUMBER: f64 = 20.0;

/// Why an impact on a plate is not possible.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum PlateError {
    /// The density of the plate is not given.
    #[error("a plate requires half_space.density. Add the density of the plate.")]
    NoDensity,
    /// A wall that is not flat, or that moves as a whole.
    #[error(
        "a plate cannot have half_space.radius or half_space.mass, because a plate is flat and gives way by bending. Remove half_space.thickness, or the other keys."
    )]
    Curved,
    /// A plate together with damping, where the drag of one would act on the other.
    #[error("a plate cannot be combined with [damping]. Remove half_space.thickness or [damping].")]
    Damped,
    /// A straight unloading branch that the plate damps beyond critical.
    #[error(
        "the plate is too thin for this law: the sphere would not separate. half_space.thickness must be above {least:.3e} m."
    )]
    NeverEnds {
        /// Least thickness \[m\].
        least: f64,
    },
    #[error(
        "e is practically 0: Zener's number {zener_number:.4} exceeds {MAX_ZENER_NUMBER}, and an elastic contact has e = {restitution:.1e}. half_space.thickness must be above {least:.3e} m."
    )]
    TooThin {
        /// λ.
        zener_number: f64,
        /// e of an elastic contact.
        restitution: f64,
        /// Least thickness \[m\].
        least: f64,
    },
}

/// A plate under a sphere: everything that does not depend on the speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::impact) struct ContactPlate {
    plate: Plate,
    /// Mass of the sphere \[kg\].
    mass: f64,
    /// c_p = √(E_h*/ρ) \[m/s\].
    wave_speed: f64,
    /// Y of the thin plate \[s/kg\].
    mobility: f64,
}

/// A plate in the units of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::impact) struct ScaledPlate {
    pub(in crate::impact) plate: ContactPlate,
    /// y = Y Φ/V.
    pub(in crate::impact) mobility: f64,
    /// λ.
    pub(in crate::impact) zener_number: f64,
    /// X.
    pub(in crate::impact) wave_transits: f64,
}

impl ContactPlate {
    /// `law` is the law of the contact, in these scales.
    pub(in crate::impact) fn new(
        plate: Plate,
        half_space: &HalfSpace,
        mass: f64,
        scales: &Scales,
        law: &Law,
    ) -> Result<Self, PlateError> {
        let density = half_space.density.ok_or(PlateError::NoDensity)?;
        let modulus = half_space.material.plane_strain_modulus();
        // 1/(8 √(D ρ h)) with √12/8 = 0.433
        let mobility = 12.0_f64.sqrt() / 8.0 / (modulus * density).sqrt() / plate.thickness / plate.thickness;
        let under = Self { plate, mass, wave_speed: (modulus / density).sqrt(), mobility };
        // straight unloading is an oscillation of stiffness s that Y damps: critically where Y² s m = 4
        let unloading = law.unload(law.loaded_state(1.0));
        let square =
            mobility * mobility * (unloading.power_stiffness() * scales.units.force / scales.units.length) * mass;
        if unloading.exponent == 1.0 && square >= 4.0 {
            return Err(PlateError::NeverEnds { least: plate.thickness * (0.25 * square).sqrt().sqrt() });
        }
        Ok(under)
    }

    /// 2 √(c t) \[m\], c = c_p h/√12: no bending wave returns within the time t from an edge that is farther away.
    pub(in crate::impact) fn wave_reach(&self, time: f64) -> f64 {
        2.0 * (self.wave_speed * self.plate.thickness / 12.0_f64.sqrt() * time).sqrt()
    }

    /// The plate in the units of an impact at `speed` \[m/s\] with Hertz's stiffness K. `free_time` is the contact time \[s\] without a
    /// plate.
    pub(in crate::impact) fn to_scaled(
        self,
        speed: f64,
        hertz_stiffness: f64,
        scales: &Scales,
        free_time: f64,
    ) -> Result<ScaledPlate, PlateError> {
        let Self { plate: Plate { thickness, theory, .. }, mass, wave_speed, mobility: thin } = self;
        let wave_transits = wave_speed * free_time / thickness;
        let zener_number = thin * mass * pow(hertz_stiffness * speed.sqrt() / mass, 0.4);
        if zener_number > MAX_ZENER_NUMBER {
            let restitution = 0.679 * powi(zener_number, -5);
            let least = thickness * (zener_number / MAX_ZENER_NUMBER).sqrt();
            return Err(PlateError::TooThin { zener_number, restitution, least });
        }
        let mobility = match theory {
            PlateTheory::Zener => thin,
            PlateTheory::Thick => thin * (1.0 + 1.86 / wave_transits),
        };
        Ok(ScaledPlate {
            plate: self,
            mobility: mobility * scales.units.force / scales.speed,
            zener_number,
            wave_transits,
        })
    }
}
