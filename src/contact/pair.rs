//! The pair of the two bodies, and its numbers that do not depend on a law: effective modulus, fractions of the compliance, first
//! yield.

use thiserror::Error;

use super::body::{HalfSpace, InvalidInput, OutOfFloatRange, Sphere, check_bodies, finite_positive};
use crate::error::ErrorKind;
use crate::numerics::comparison::is_below;
use crate::numerics::functions::{atan, exp};
use crate::numerics::root::illinois;
use crate::units::{Dimension, format_input};

/// First yield of the softer body (Xie et al. 2024, Eqs. 17-18).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldPoint {
    /// The bodies that yield.
    pub yield_partition: YieldPartition,
    /// σ_Y of the softer body \[Pa\].
    pub strength: f64,
    /// ν of the softer body.
    pub poissons_ratio: f64,
    /// C_ν \[1\] of the softer body: largest Hertz pressure over yield strength at first yield.
    pub factor: f64,
    /// δ_Y = (π C_ν σ_Y / 2E*)² R \[m\].
    pub indentation: f64,
    /// F_Y = (π C_ν σ_Y)³ R² / (6 E*²) \[N\].
    pub force: f64,
    /// a_Y = π C_ν σ_Y R / 2E* \[m\].
    pub contact_radius: f64,
}

impl YieldPoint {
    /// First yield of a softer body of this strength \[Pa\] and Poisson's ratio, in a pair of this effective radius \[m\] and
    /// modulus \[Pa\].
    fn new(
        yield_partition: YieldPartition,
        strength: f64,
        poissons_ratio: f64,
        radius: f64,
        effective_modulus: f64,
    ) -> Result<Self, OutOfFloatRange> {
        let factor = yield_factor(poissons_ratio);
        let pressure = std::f64::consts::PI * factor * strength;
        let a_over_r = pressure / (2.0 * effective_modulus);
        let indentation = finite_positive("yield indentation (m)", a_over_r * a_over_r * radius)?;
        let contact_radius = a_over_r * radius;
        let force = finite_positive("yield force (N)", 2.0 / 3.0 * pressure * contact_radius * contact_radius)?;
        Ok(Self { yield_partition, strength, poissons_ratio, factor, indentation, force, contact_radius })
    }
}

/// A hollow wall that is so narrow that a sphere does not touch it at a point.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[error(
    "half_space.radius = {} is the radius of a concave wall, and a sphere of radius {} touches such a wall at one point only if the radius of the wall is at least twice as large. Give at most {}, or a positive radius for a convex wall.",
    format_input(*.radius, Dimension::Length), format_input(*.sphere, Dimension::Length), format_input(-2.0 * *.sphere, Dimension::Length)
)]
pub struct HollowTooSmall {
    /// R_h \[m\].
    pub radius: f64,
    /// R_s \[m\].
    pub sphere: f64,
}

/// Why two bodies cannot be paired.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum PairError {
    #[error(transparent)]
    Range(#[from] OutOfFloatRange),
    #[error(transparent)]
    Hollow(#[from] HollowTooSmall),
    /// A number that is not possible for a body.
    #[error(transparent)]
    Invalid(#[from] InvalidInput),
}

impl From<PairError> for crate::error::Error {
    fn from(error: PairError) -> Self {
        Self::caused_by(ErrorKind::Failed, &error)
    }
}

/// How the bodies share the yielding.
///
/// A body yields if the largest Hertz pressure is P = C_ν σ_Y; P is infinite for a body that stays elastic. With P_b of the softer
/// body b and P_o of the other body
///
/// ```text
/// q = P_o/P_b,   w = min(1, (q − 1)/0.25)        0: both flow alike, 1: only the softer flows
/// κ = w E*/E_o*                                  share of what stays elastic beside the flow in the compliance
/// β = 1 − (1 − w) E*/E_h*   (the sphere is the softer, or q = 1),   (1 − w) E*/E_s*   (the half-space is)
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldPartition {
    /// q; infinite if the other body stays elastic.
    pub ratio: f64,
    /// True if the sphere is the softer body, or if the strengths are equal.
    pub is_sphere: bool,
    /// w.
    pub single_body_weight: f64,
    /// κ.
    pub elastic_share: f64,
    /// 1 − κ.
    pub plastic_share: f64,
    /// β: the fraction of the yielding that is in the sphere.
    pub sphere_share: f64,
    /// The fraction of the residual indentation that is a flat on the sphere; the rest is a dent. For the harder body this fraction is
    /// (E*/E_o*) exp(−(q − 1)/0.27) below q = 2, and zero from q = 2 on: an estimate from finite elements up to a/R = 0.11.
    pub flat_share: f64,
}

/// The imprint of an impact: a dent in the half-space, a flat on the sphere, or both. `flat_share` is the fraction of the flat.
pub fn imprint_name(flat_share: f64) -> &'static str {
    match flat_share {
        share if share >= 1.0 => "flat",
        share if share > 0.0 => "dent and flat",
        _ => "dent",
    }
}

/// From this ratio q on, only the softer body yields.
pub const ALONE_FROM: f64 = 1.25;

impl YieldPartition {
    /// Shares the flow between two bodies. It takes the pressures of sphere and half-space at first yield, and their compliances
    /// E*/E_i*.
    fn new([of_sphere, of_half_space]: [f64; 2], [sphere, half_space]: [f64; 2]) -> Self {
        let is_sphere = of_sphere <= of_half_space;
        let (ratio, softer, harder) = if is_sphere {
            (of_half_space / of_sphere, sphere, half_space)
        } else {
            (of_sphere / of_half_space, half_space, sphere)
        };
        let single_body_weight = if is_below(ratio, ALONE_FROM) { (ratio - 1.0) / (ALONE_FROM - 1.0) } else { 1.0 };
        let of_harder = (1.0 - single_body_weight) * harder;
        let remaining = if is_below(ratio, 2.0) { harder * exp((1.0 - ratio) / 0.27) } else { 0.0 };
        Self {
            ratio,
            is_sphere,
            single_body_weight,
            elastic_share: single_body_weight * harder,
            plastic_share: softer + of_harder,
            sphere_share: if is_sphere { 1.0 - of_harder } else { of_harder },
            flat_share: if is_sphere { 1.0 - remaining } else { remaining },
        }
    }

    /// Selects the item of the softer body from a pair of sphere and half-space.
    pub fn for_softer<T>(&self, [sphere, half_space]: [T; 2]) -> T {
        if self.is_sphere { sphere } else { half_space }
    }

    /// True if both bodies yield.
    pub fn is_shared(&self) -> bool {
        self.single_body_weight < 1.0
    }

    /// True if the half-space alone yields, apart from a small flat on the sphere.
    pub fn is_half_space_alone(&self) -> bool {
        !self.is_shared() && !self.is_sphere
    }
}

/// The numbers that follow from sphere and half-space together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    /// Effective radius \[m\], 1/R = 1/R_s + 1/R_h: the radius of the sphere on a flat half-space (Eq. 9).
    pub radius: f64,
    /// R \[m\] of the finite geometry of the law: the effective radius, or the radius of one ball if the balls are equal.
    pub geometry_radius: f64,
    /// The radius \[m\] of the smaller ball.
    pub smaller_radius: f64,
    /// E* \[Pa\], 1/E* = (1 − ν_s²)/E_s + (1 − ν_h²)/E_h (Eq. 11). With two equal bodies this is E/(2(1 − ν²)).
    pub effective_modulus: f64,
    /// κ = E*/E_s* in \[0, 1): share of the sphere in the elastic compliance; 0 is a rigid sphere.
    pub sphere_compliance: f64,
    /// ρ_E = E*/E_h* = 1 − κ: fraction of the half-space in the elastic compliance.
    pub half_space_compliance: f64,
    /// First yield, if a body has a yield strength.
    pub yield_point: Option<YieldPoint>,
    /// Sphere and half-space; a body that is no ball, or does not yield, changes nothing.
    pub balls: [Ball; 2],
}

/// The part of a yielding ball in the law: a sphere, or a half-space with a positive radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// β_i: its fraction of the yielding.
    pub share: f64,
    /// E*/E_i*.
    pub compliance: f64,
    /// R/R_i; 0 for a body that is no ball.
    pub curvature: f64,
}

impl Ball {
    /// Sphere and half-space. Two equal balls are one ball on a rigid wall at half the approach, in units of the radius of this ball.
    fn pair_of_balls(
        yield_partition: &YieldPartition,
        radii: [Option<f64>; 2],
        radius: f64,
        compliances: [f64; 2],
        are_equal: bool,
    ) -> [Self; 2] {
        let [sphere, half_space] = radii.map(|ball| ball.map_or(0.0, |ball| radius / ball));
        if are_equal {
            let none = Self { share: 0.0, compliance: 0.0, curvature: 0.0 };
            return [Self { share: 1.0, compliance: 1.0, curvature: 1.0 }, none];
        }
        let of_sphere = Self { share: yield_partition.sphere_share, compliance: compliances[0], curvature: sphere };
        [
            of_sphere,
            Self { share: 1.0 - yield_partition.sphere_share, compliance: compliances[1], curvature: half_space },
        ]
    }
}

impl Pair {
    /// First yield; `None` if the contact would be wider than the sphere, where no law holds.
    pub fn reachable_yield_point(&self) -> Option<YieldPoint> {
        self.yield_point.filter(|point| point.contact_radius < self.smaller_radius)
    }

    /// Pairs a sphere with a half-space. The density of the sphere does not matter.
    ///
    /// # Errors
    /// [`PairError`] if effective radius, modulus or yield point over- or underflow, for a hollow that is too narrow, and for
    /// numbers that are not possible for a body.
    pub fn try_new(sphere: &Sphere, half_space: &HalfSpace) -> Result<Self, PairError> {
        check_bodies(sphere, half_space)?;
        let radius = match half_space.radius {
            None => sphere.radius,
            Some(hollow) if hollow < 0.0 && -hollow < 2.0 * sphere.radius => {
                return Err(HollowTooSmall { radius: hollow, sphere: sphere.radius }.into());
            }
            Some(of_wall) => finite_positive("effective radius (m)", sphere.radius / (1.0 + sphere.radius / of_wall))?,
        };
        let of_sphere = 1.0 / sphere.material.plane_strain_modulus();
        let of_half_space = 1.0 / half_space.material.plane_strain_modulus();
        let effective_modulus = finite_positive("effective modulus (Pa)", 1.0 / (of_sphere + of_half_space))?;
        let compliances = [of_sphere, of_half_space].map(|compliance| compliance * effective_modulus);
        let bodies = [(sphere.yield_strength, sphere.material), (half_space.yield_strength, half_space.material)];
        let pressures = bodies.map(|(strength, material)| {
            strength.map_or(f64::INFINITY, |strength| yield_factor(material.poissons_ratio) * strength)
        });
        let yield_partition = YieldPartition::new(pressures, compliances);
        let (strength, material) = yield_partition.for_softer(bodies);
        let radii = [Some(sphere.radius), half_space.ball_radius()];
        let are_equal = half_space.ball_radius() == Some(sphere.radius) && bodies[0] == bodies[1];
        let yield_point = strength
            .map(|strength| {
                YieldPoint::new(yield_partition, strength, material.poissons_ratio, radius, effective_modulus)
            })
            .transpose()?;
        let geometry_radius = if are_equal { sphere.radius } else { radius };
        Ok(Self {
            radius,
            geometry_radius,
            smaller_radius: half_space.ball_radius().map_or(sphere.radius, |other| other.min(sphere.radius)),
            effective_modulus,
            sphere_compliance: compliances[0],
            half_space_compliance: compliances[1],
            yield_point,
            balls: Ball::pair_of_balls(&yield_partition, radii, radius, compliances, are_equal),
        })
    }

    /// This pair with its strength at first yield multiplied by `factor`. The fractions of the bodies in the yielding do not change.
    pub(crate) fn with_raised_strength(&self, factor: f64) -> Result<Self, OutOfFloatRange> {
        let raised = |point: YieldPoint| {
            let strength = point.strength * factor;
            YieldPoint::new(point.yield_partition, strength, point.poissons_ratio, self.radius, self.effective_modulus)
        };
        Ok(Self { yield_point: self.yield_point.map(raised).transpose()?, ..*self })
    }

    /// The approach of the sphere alone: its fraction of the elastic approach, and the flat that it keeps.
    pub fn sphere_indentation(&self, indentation: f64, elastic_approach: f64) -> f64 {
        let elastic = self.sphere_compliance * elastic_approach;
        let flat_share = self.yield_point.map_or(0.0, |point| point.yield_partition.flat_share);
        if flat_share > 0.0 { elastic + flat_share * (indentation - elastic_approach) } else { elastic }
    }

    /// [κ, 1 − κ] of the law: see [`YieldPartition`]. For bodies that stay elastic, the compliance fractions of sphere and half-space.
    pub(crate) fn law_shares(&self) -> [f64; 2] {
        let of_bodies = [self.sphere_compliance, self.half_space_compliance];
        self.yield_point
            .map_or(of_bodies, |point| [point.yield_partition.elastic_share, point.yield_partition.plastic_share])
    }

    /// True if both bodies yield, and are balls that are not equal.
    pub fn has_unequal_balls(&self) -> bool {
        let is_of_both = self.yield_point.is_some_and(|point| point.yield_partition.is_shared());
        is_of_both && self.balls[1].curvature > 0.0
    }

    /// True for two equal balls, which the law treats as one ball on a rigid wall.
    pub fn has_equal_balls(&self) -> bool {
        self.geometry_radius != self.radius
    }

    /// Hertz stiffness K = (4/3) E* √R \[N/m^1.5\], F = K δ^1.5.
    pub fn hertz_stiffness(&self) -> f64 {
        4.0 / 3.0 * self.effective_modulus * self.radius.sqrt()
    }
}

/// C_ν \[1\] of the softer body. For ν ≥ 0 it is 1.30075 + 0.87825 ν + 0.54373 ν² (Xie et al. 2024, Eq. 18): 1.61316 at ν = 0.3.
///
/// Eq. 18 is a fit for ν ≥ 0. For ν < 0 the yield point is computed and scaled, so that C_ν is continuous at ν = 0, where Eq. 18
/// is 0.1 % above the computed value.
pub fn yield_factor(poissons_ratio: f64) -> f64 {
    /// The polynomial over the computed value at ν = 0.
    const AT_ZERO: f64 = 1.300_75 / 1.299_305_016_713_737_4;
    if poissons_ratio < 0.0 {
        return AT_ZERO * computed_yield_factor(poissons_ratio);
    }
    1.300_75 + poissons_ratio * (0.878_25 + 0.543_73 * poissons_ratio)
}

/// The largest Hertz pressure over the largest von Mises stress under it. The largest stress is on the axis at the depth ζ a, or at
/// the rim of the contact (Johnson 1985, ch. 3.4):
///
/// ```text
/// axis   |3/(2(1 + ζ²)) − (1 + ν)(1 − ζ arctan(1/ζ))|
/// rim    (1 − 2ν)/√3
/// ```
///
/// From ν = −0.342 downwards the rim yields first.
fn computed_yield_factor(poissons_ratio: f64) -> f64 {
    let growth = |depth: f64| {
        let square = 1.0 + depth * depth;
        (1.0 + poissons_ratio) * (atan(1.0 / depth) - depth / square) - 3.0 * depth / (square * square)
    };
    // the stress on the axis has one maximum, and the growth is negative at ζ = 2 for every ν
    let depth = illinois((0.0, 2.0), growth);
    let axis = 1.5 / (1.0 + depth * depth) - (1.0 + poissons_ratio) * (1.0 - depth * atan(1.0 / depth));
    let rim = (1.0 - 2.0 * poissons_ratio) / 3.0_f64.sqrt();
    1.0 / axis.max(rim)
}
