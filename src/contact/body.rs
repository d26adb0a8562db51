//! The two bodies, sphere and half-space, and the checks of their numbers. Only the densities matter for the motion.

use thiserror::Error;

use crate::units::format_number;

/// An isotropic elastic material.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus E \[Pa\], > 0; `f64::INFINITY` is a rigid body.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν \[1\], −1 < ν < 0.5.
    pub poissons_ratio: f64,
}

impl Material {
    /// The steel of benchmarks and of validation.
    pub(crate) const STEEL: Self = Self { youngs_modulus: 210e9, poissons_ratio: 0.3 };

    /// Plane-strain modulus E/(1 − ν²) \[Pa\] (Xie et al. 2024, Eq. 6); infinite for a rigid body.
    pub fn plane_strain_modulus(&self) -> f64 {
        self.youngs_modulus / (1.0 - self.poissons_ratio * self.poissons_ratio)
    }
}

/// Density of that steel \[kg/m³\].
pub(crate) const STEEL_DENSITY: f64 = 7850.0;

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Radius R \[m\], > 0 (not the diameter).
    pub radius: f64,
    /// Elastic constants; may be rigid.
    pub material: Material,
    /// Density ρ \[kg/m³\], > 0.
    pub density: f64,
    /// Yield strength σ_Y \[Pa\] (von Mises); `None`: the sphere stays elastic.
    pub yield_strength: Option<f64>,
}

impl Sphere {
    /// A sphere whose own yield strength is not known.
    pub fn elastic(radius: f64, material: Material, density: f64) -> Self {
        Self { radius, material, density, yield_strength: None }
    }

    /// Mass (4/3) π R³ ρ \[kg\].
    pub fn mass(&self) -> f64 {
        sphere_volume(self.radius) * self.density
    }
}

/// Volume (4/3) π R³ \[m³\] of a sphere of this radius \[m\].
pub fn sphere_volume(radius: f64) -> f64 {
    4.0 / 3.0 * std::f64::consts::PI * radius * radius * radius
}

/// The body that is hit: a half-space, a curved wall, or a second ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HalfSpace {
    /// Elastic constants; never rigid.
    pub material: Material,
    /// Yield strength σ_Y \[Pa\] (von Mises); `None`: the half-space stays elastic.
    pub yield_strength: Option<f64>,
    /// Density \[kg/m³\]; `None`: elastic waves are not computed.
    pub density: Option<f64>,
    /// R_h \[m\] at the contact: positive for a convex wall or a ball, negative for a hollow; `None`: flat.
    pub radius: Option<f64>,
    pub support: Support,
}

/// The support of the target.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Support {
    #[default]
    Fixed,
    /// Free to move, with this mass \[kg\].
    Free(f64),
    /// A solid ball of this radius and density that is free to move.
    Ball,
}

impl HalfSpace {
    /// A flat half-space that does not move, of unknown density.
    pub fn flat(material: Material, yield_strength: Option<f64>) -> Self {
        Self { material, yield_strength, density: None, radius: None, support: Support::Fixed }
    }

    /// The radius \[m\], if the half-space is a ball or a convex wall.
    pub fn ball_radius(&self) -> Option<f64> {
        self.radius.filter(|radius| *radius > 0.0)
    }

    /// Mass \[kg\] of a target that is free to move; NaN for a ball without radius or density.
    pub fn free_mass(&self) -> Option<f64> {
        match self.support {
            Support::Fixed => None,
            Support::Free(mass) => Some(mass),
            Support::Ball => {
                let volume = self.ball_radius().map_or(f64::NAN, sphere_volume);
                Some(volume * self.density.unwrap_or(f64::NAN))
            }
        }
    }
}

/// A quantity of the pair that double precision cannot hold.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "{quantity} = {} is outside the range of double precision. Check the units; use a less extreme radius, modulus, density, strength or speed.",
    format_number(*.value)
)]
pub struct OutOfFloatRange {
    pub quantity: &'static str,
    /// The number that was computed.
    pub value: f64,
}

/// `value`, if it is a normal positive number.
pub(crate) fn finite_positive(quantity: &'static str, value: f64) -> Result<f64, OutOfFloatRange> {
    if value.is_normal() && value > 0.0 { Ok(value) } else { Err(OutOfFloatRange { quantity, value }) }
}

/// A number of a body, of gravity or of damping outside of its possible range.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error("{quantity} = {} is not allowed: {rule}", format_number(*.value))]
pub struct InvalidInput {
    /// The name of the number, with its unit.
    pub quantity: &'static str,
    pub value: f64,
    /// The allowed values.
    pub rule: &'static str,
}

impl InvalidInput {
    /// Checks that a number is within its range.
    pub(crate) fn check(
        quantity: &'static str,
        value: f64,
        is_allowed: bool,
        rule: &'static str,
    ) -> Result<(), InvalidInput> {
        if is_allowed { Ok(()) } else { Err(Self { quantity, value, rule }) }
    }
}

/// Checks the numbers of two bodies, as a scenario does. An infinite Young's modulus is that of a rigid body.
pub(super) fn check_bodies(sphere: &Sphere, half_space: &HalfSpace) -> Result<(), InvalidInput> {
    let check = InvalidInput::check;
    let positive = "it must be a positive number";
    let is_positive = |value: f64| value > 0.0 && value.is_finite();
    let names = [
        ["Young's modulus of the sphere (Pa)", "Poisson's ratio of the sphere", "yield strength of the sphere (Pa)"],
        [
            "Young's modulus of the half-space (Pa)",
            "Poisson's ratio of the half-space",
            "yield strength of the half-space (Pa)",
        ],
    ];
    let bodies = [(sphere.material, sphere.yield_strength), (half_space.material, half_space.yield_strength)];
    check("radius of the sphere (m)", sphere.radius, is_positive(sphere.radius), positive)?;
    for ([modulus, ratio, limit], (material, strength)) in names.into_iter().zip(bodies) {
        let Material { youngs_modulus, poissons_ratio } = material;
        check(modulus, youngs_modulus, youngs_modulus > 0.0, positive)?;
        let is_in_range = poissons_ratio > -1.0 && poissons_ratio < 0.5;
        check(ratio, poissons_ratio, is_in_range, "it must be larger than -1 and smaller than 0.5")?;
        if let Some(strength) = strength {
            check(limit, strength, is_positive(strength), positive)?;
        }
    }
    Ok(())
}
