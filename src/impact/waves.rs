//! Energy that an impact radiates as elastic waves into the half-space, to first order: the force is that of the impact
//! without waves.
//!
//! A normal point force F(t) on an elastic half-space radiates the power C(ν) F'²/(ρ c_s³) as pressure, shear and Rayleigh
//! waves, with c_s = √(E/(2 (1 + ν) ρ)) and E, ν, ρ of the half-space. Over an impact
//!
//! ```text
//! W_rad = C/(ρ c_s³) ∫ (dF/dδ)² |δ'| dδ        e_waves² = e² − 2 W_rad/(m v²)
//! ```
//!
//! along loading and unloading, |δ'| from the energy. Miller and Pursey (1955), Proc. R. Soc. A 233, 55-69, for the waves
//! under a normal load; Hunter (1957), J. Mech. Phys. Solids 5, 162-171, for the loss of an elastic impact, which grows as
//! v^(3/5). Finite elements of whole impacts radiate 1.00 to 1.07 times this.

use std::f64::consts::{FRAC_PI_2, PI};

use super::scales::{ACCELERATION, Scales};
use crate::law::piece::{Piece, Shape};
use crate::law::{Law, Peak, Unloading};
use crate::material::{HalfSpace, OutOfFloatRange, normal};
use crate::math::functions::{atan2, cos, gamma, sin};
use crate::math::quadrature::over as integrate;

/// How a half-space radiates under a changing normal force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waves {
    /// C/(ρ c_s³) \[s/kg\]: radiated power over F'².
    coefficient: f64,
}

impl Waves {
    /// Of a half-space of known density; `None` for one of unknown density.
    ///
    /// # Errors
    /// [`OutOfFloatRange`] where ρ c_s³ over- or underflows.
    pub fn of(half_space: &HalfSpace) -> Result<Option<Self>, OutOfFloatRange> {
        let Some(density) = half_space.density else { return Ok(None) };
        let nu = half_space.material.poissons_ratio;
        let shear_modulus = half_space.material.youngs_modulus / (2.0 * (1.0 + nu));
        let shear_speed = normal("shear wave speed of the half-space (m/s)", (shear_modulus / density).sqrt())?;
        let resistance = normal("rho c_s^3 of the half-space (kg/s)", shear_modulus * shear_speed)?;
        Ok(Some(Self { coefficient: radiation_factor(nu) / resistance }))
    }

    /// 2 W_rad/(m v²) \[1\]: what an impact at `speed` \[m/s\] radiates, over its kinetic energy. `None` where the force of
    /// the law jumps on the way: there F' is infinite, and so is W_rad.
    pub fn loss_fraction(
        &self,
        speed: f64,
        scales: &Scales,
        law: &Law,
        unloading: &Unloading,
    ) -> Result<Option<f64>, OutOfFloatRange> {
        if law.loading.jump_before(unloading.peak.indentation).is_some() {
            return Ok(None);
        }
        let (pieces, peak) = (law.loading.pieces(), unloading.peak.indentation);
        let of_loading = integral(&pieces[..=law.loading.index_at(peak)], peak);
        let integral = of_loading + integral(&[unloading.branch()], peak);
        // ½ m v² = (2/5) q² Φ L
        let ratio = scales.speed / speed;
        let fraction = 2.5
            * integral
            * (self.coefficient * (scales.force / scales.length))
            * (scales.speed / scales.length)
            * ratio
            * ratio;
        if fraction.is_finite() {
            Ok(Some(fraction))
        } else {
            Err(OutOfFloatRange { quantity: "share of the energy that is radiated as waves", value: fraction })
        }
    }
}

/// e_waves = √(e² − loss), or 0 where the waves would take more than comes back.
pub fn restitution_with_waves(restitution: f64, loss_fraction: f64) -> f64 {
    (restitution * restitution - loss_fraction).max(0.0).sqrt()
}

/// ∫ f'² |u| dx along these pieces to a turn at x = `turn`, or from there back.
fn integral(pieces: &[Piece], turn: f64) -> f64 {
    let most = pieces.last().map_or(0.0, |last| last.work_at(turn));
    let speed_at = |work: f64| (2.0 * ACCELERATION * (most - work)).max(0.0).sqrt();
    let mut integral = 0.0;
    let mut entry = speed_at(0.0);
    for (i, piece) in pieces.iter().enumerate() {
        let next = pieces.get(i + 1);
        let (end, exit) = next.map_or((turn, 0.0), |next| (next.start, speed_at(next.work)));
        integral += match piece.shape {
            Shape::Power { exponent, lead: 0.0, .. } if next.is_none() => {
                let run = end - piece.start;
                power_integral(&Peak { indentation: run, force: piece.force_at(end), elastic_approach: run }, exponent)
            }
            Shape::Straight { slope, .. } => straight_integral(slope, piece.force_at(end), piece.force, entry, exit),
            // no closed form here
            Shape::Power { .. } | Shape::Smooth(_) => integral_by_quadrature(piece, end, speed_at),
        };
        entry = exit;
    }
    integral
}

/// From rest at a peak along f = f_m (d/ε)^n to d = 0, or the other way:
/// n² (f_m²/ε) u_0 B((2n − 1)/(n + 1), 3/2)/(n + 1) with u_0² = 2c f_m ε/(n + 1).
fn power_integral(peak: &Peak, exponent: f64) -> f64 {
    let Peak { force, elastic_approach, .. } = *peak;
    let n = exponent;
    let fastest = (2.0 * ACCELERATION * force * elastic_approach / (n + 1.0)).sqrt();
    let shape = if n == 1.5 { HERTZ } else { n * n / (n + 1.0) * beta((2.0 * n - 1.0) / (n + 1.0)) };
    shape * (force * force / elastic_approach) * fastest
}

/// n²/(n + 1) B((2n − 1)/(n + 1), 3/2) for n = 3/2: 0.9 B(0.8, 1.5).
const HERTZ: f64 = 0.795_907_321_770_451_1;

/// B(a, 3/2).
fn beta(a: f64) -> f64 {
    // Γ(3/2)
    const GAMMA: f64 = 0.886_226_925_452_758;
    GAMMA * gamma(a) / gamma(a + 1.5)
}

/// On a straight piece u² + (5/4) f²/s = u² + g² is constant, so the integral s ∫ u df is a sector of an ellipse:
/// s^(3/2)/√5 [g u + (u² + g²) θ], tan θ = g/u.
fn straight_integral(slope: f64, to_force: f64, from_force: f64, entry: f64, exit: f64) -> f64 {
    let scale = (ACCELERATION / slope).sqrt();
    let (from, to) = (scale * from_force, scale * to_force);
    // the angle between the two states, without the difference of two nearly equal ones
    let angle = atan2(to * entry - from * exit, entry * exit + from * to);
    slope * slope.sqrt() / 5f64.sqrt() * (to * exit - from * entry + (entry * entry + from * from) * angle)
}

/// On any piece from its start to `end`, u from the work that is left.
fn integral_by_quadrature(piece: &Piece, end: f64, speed_at: impl Fn(f64) -> f64) -> f64 {
    integrate(piece.start, end, |x| {
        let slope = piece.slope_at(x);
        slope * slope * speed_at(piece.work_at(x))
    })
}

/// C(ν) \[1\] of a half-space of Poisson's ratio −1 < ν < ½.
///
/// ```text
/// C = (1/2π) [ |∫₀¹ Im(k √(k² − γ²)/R) dk| + π k_R √(k_R² − γ²)/|R'(k_R)| ],   γ² = (1 − 2ν)/(2 (1 − ν))
/// R(k) = (2k² − 1)² − 4k² √(k² − γ²) √(k² − 1),   R(k_R) = 0
/// ```
///
/// with wave numbers k in units of that of shear waves: the integral is the share of pressure (k < γ) and shear waves, the
/// rest that of Rayleigh waves. The integration variable is a = √|k² − γ²|, in which neither part has a root at k = γ.
pub fn radiation_factor(poissons_ratio: f64) -> f64 {
    const PART: f64 = FRAC_PI_2 / 4.0;
    let nu = poissons_ratio;
    let gamma_squared = (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu));
    let rest = 1.0 / (2.0 * (1.0 - nu)); // 1 − γ²
    // 2k² − 1 at k = γ
    let offset = -nu / (1.0 - nu);
    let pressure = integrate(0.0, gamma_squared.sqrt(), |a| {
        let k_squared = gamma_squared - a * a;
        let q = offset - 2.0 * a * a;
        a * a / (q * q + 4.0 * k_squared * a * (rest + a * a).sqrt())
    });
    // a = √(1 − γ²) sin φ removes the root at k = 1. Four parts, because leaky waves have poles not far from the middle
    let shear_at = |phi: f64| {
        let (a, b) = (rest.sqrt() * sin(phi), rest.sqrt() * cos(phi));
        let k_squared = gamma_squared + a * a;
        let q = offset + 2.0 * a * a;
        let product = 4.0 * k_squared * a * b;
        a * a * b * product / (q * q * q * q + product * product)
    };
    let shear: f64 = [0.0, 1.0, 2.0, 3.0].iter().map(|i| integrate(i * PART, (i + 1.0) * PART, shear_at)).sum();
    (pressure + shear + rayleigh(gamma_squared)) / (2.0 * PI)
}

/// π k_R √(k_R² − γ²)/|R'(k_R)|.
fn rayleigh(gamma_squared: f64) -> f64 {
    // c_R²/c_s² is the one root in (0, 1) of ξ³ − 8ξ² + (24 − 16γ²) ξ − 16 (1 − γ²), which is concave there: Newton's method
    // comes up to it from 0
    let mut xi = 0.0;
    for _ in 0..100 {
        let linear = 24.0 - 16.0 * gamma_squared;
        let value = ((xi - 8.0) * xi + linear) * xi - 16.0 * (1.0 - gamma_squared);
        let step = value / ((3.0 * xi - 16.0) * xi + linear);
        xi -= step;
        if step.abs() <= 1e-16 {
            break;
        }
    }
    let s = 1.0 / xi; // k_R²
    let q = 2.0 * s - 1.0;
    let root = q * q / (4.0 * s); // √(k_R² − γ²) √(k_R² − 1)
    // dR/d(k²), as R' = 2k dR/d(k²)
    let derivative = 4.0 * q - 4.0 * root - 2.0 * s * (q - gamma_squared) / root;
    PI * (s - gamma_squared).sqrt() / (2.0 * derivative.abs())
}
