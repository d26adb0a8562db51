//! The two bodies and what their pairing fixes before any law is chosen: effective modulus, compliance shares, first
//! yield. Nothing here but the densities knows of motion.

use thiserror::Error;

use crate::error::ErrorKind;
use crate::units::number;

/// An isotropic elastic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus E \[Pa\], > 0; `f64::INFINITY` is a rigid body.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν \[1\], −1 < ν < 0.5.
    pub poissons_ratio: f64,
}

impl Material {
    /// Plane-strain modulus E/(1 − ν²) \[Pa\] (Xie et al. 2024, Eq. 6); infinite for a rigid body.
    pub fn plane_strain_modulus(&self) -> f64 {
        self.youngs_modulus / (1.0 - self.poissons_ratio * self.poissons_ratio)
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Radius R \[m\], > 0 (not the diameter).
    pub radius: f64,
    /// Elastic constants; may be rigid.
    pub material: Material,
    /// Density ρ \[kg/m³\], > 0.
    pub density: f64,
    /// The sphere's own yield strength \[Pa\], if known: only used to warn where the sphere would yield too.
    pub yield_strength: Option<f64>,
}

impl Sphere {
    /// A sphere whose own yield strength is not known.
    pub fn elastic(radius: f64, material: Material, density: f64) -> Self {
        Self { radius, material, density, yield_strength: None }
    }

    /// Mass (4/3) π R³ ρ \[kg\].
    pub fn mass(&self) -> f64 {
        4.0 / 3.0 * std::f64::consts::PI * self.radius * self.radius * self.radius * self.density
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfSpace {
    /// Elastic constants; never rigid.
    pub material: Material,
    /// Yield strength σ_Y \[Pa\] (von Mises); `None`: the half-space stays elastic.
    pub yield_strength: Option<f64>,
    /// Density \[kg/m³\]; `None`: nothing is said of elastic waves.
    pub density: Option<f64>,
}

/// First yield of the half-space under the sphere (Xie et al. 2024, Eqs. 17-18).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldPoint {
    /// C_ν \[1\]: largest Hertz pressure over yield strength at first yield.
    pub factor: f64,
    /// δ_Y = (π C_ν σ_Y / 2E*)² R \[m\].
    pub indentation: f64,
    /// F_Y = (π C_ν σ_Y)³ R² / (6 E*²) \[N\].
    pub force: f64,
    /// a_Y = π C_ν σ_Y R / 2E* \[m\].
    pub contact_radius: f64,
}

impl YieldPoint {
    /// v_Y \[m/s\] of a sphere of this mass \[kg\], from ½ m v_Y² = (2/5) F_Y δ_Y: the slowest impact that yields.
    ///
    /// # Errors
    /// [`OutOfFloatRange`] where it over- or underflows.
    pub fn speed(&self, mass: f64) -> Result<f64, OutOfFloatRange> {
        normal("yield speed (m/s)", (0.8 * (self.force / mass) * self.indentation).sqrt())
    }
}

/// A quantity of the pair that double precision cannot hold.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "{quantity} = {} cannot be held in double precision; choose a less extreme radius, modulus, density, strength or speed",
    number(*.value)
)]
pub struct OutOfFloatRange {
    pub quantity: &'static str,
    /// What came out.
    pub value: f64,
}

impl From<OutOfFloatRange> for crate::error::Error {
    fn from(error: OutOfFloatRange) -> Self {
        Self::of(ErrorKind::Failed, &error)
    }
}

/// `value`, if it is a normal positive number.
pub(crate) fn normal(quantity: &'static str, value: f64) -> Result<f64, OutOfFloatRange> {
    if value.is_normal() && value > 0.0 { Ok(value) } else { Err(OutOfFloatRange { quantity, value }) }
}

/// What the pairing of sphere and half-space fixes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Effective radius \[m\]: the sphere's, as the half-space is flat (Eq. 9).
    pub radius: f64,
    /// E* \[Pa\], 1/E* = (1 − ν_s²)/E_s + (1 − ν_h²)/E_h (Eq. 11). With two equal bodies this is E/(2(1 − ν²)).
    pub effective_modulus: f64,
    /// κ = E*/E_s* in \[0, 1): share of the sphere in the elastic compliance; 0 is a rigid sphere.
    pub sphere_compliance: f64,
    /// ρ_E = E*/E_h* = 1 − κ: share of the half-space.
    pub half_space_compliance: f64,
    /// First yield, if the half-space has a yield strength.
    pub yield_point: Option<YieldPoint>,
}

impl Pair {
    /// Pairs a sphere of this radius \[m\] and material with a half-space.
    ///
    /// # Errors
    /// [`OutOfFloatRange`] where effective modulus or yield point over- or underflow.
    pub fn try_new(radius: f64, sphere: &Material, half_space: &HalfSpace) -> Result<Self, OutOfFloatRange> {
        let of_sphere = 1.0 / sphere.plane_strain_modulus();
        let of_half_space = 1.0 / half_space.material.plane_strain_modulus();
        let effective_modulus = normal("effective modulus (Pa)", 1.0 / (of_sphere + of_half_space))?;
        let yield_point = half_space
            .yield_strength
            .map(|strength| {
                let factor = yield_factor(half_space.material.poissons_ratio);
                let pressure = std::f64::consts::PI * factor * strength;
                let a_over_r = pressure / (2.0 * effective_modulus);
                let indentation = normal("yield indentation (m)", a_over_r * a_over_r * radius)?;
                let a_y = a_over_r * radius;
                let force = normal("yield force (N)", 2.0 / 3.0 * pressure * a_y * a_y)?;
                Ok(YieldPoint { factor, indentation, force, contact_radius: a_y })
            })
            .transpose()?;
        Ok(Self {
            radius,
            effective_modulus,
            sphere_compliance: of_sphere * effective_modulus,
            half_space_compliance: of_half_space * effective_modulus,
            yield_point,
        })
    }

    /// Hertz stiffness K = (4/3) E* √R \[N/m^1.5\], F = K δ^1.5.
    pub fn hertz_stiffness(&self) -> f64 {
        4.0 / 3.0 * self.effective_modulus * self.radius.sqrt()
    }
}

/// C_ν = 1.30075 + 0.87825 ν + 0.54373 ν² \[1\] (Xie et al. 2024, Eq. 18), ν of the half-space; 1.61316 at ν = 0.3.
pub fn yield_factor(poissons_ratio: f64) -> f64 {
    1.300_75 + poissons_ratio * (0.878_25 + 0.543_73 * poissons_ratio)
}
