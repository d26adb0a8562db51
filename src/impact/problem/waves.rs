//! Energy that an impact radiates as elastic waves into the half-space, to first order: the force is the force of the impact
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

use super::scales::{FORCE_FACTOR, SQRT_FORCE_FACTOR, Scales, speed_at_energy};
use crate::contact::body::{HalfSpace, OutOfFloatRange, finite_positive};
use crate::contact::law::{Surface, Unloading};
use crate::numerics::curve::piece::{Piece, Shape};
use crate::numerics::functions::{atan2, gamma, ln_1p};
use crate::numerics::quadrature::tanh_sinh_between as integrate;

/// The radiation of a half-space under a changing normal force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waves {
    /// C/(ρ c_s³) \[s/kg\]: radiated power over F'².
    coefficient: f64,
}

impl Waves {
    /// Returns `None` for a half-space of unknown density.
    ///
    /// # Errors
    /// [`OutOfFloatRange`] where ρ c_s³ over- or underflows.
    pub fn try_new(half_space: &HalfSpace) -> Result<Option<Self>, OutOfFloatRange> {
        let Some(density) = half_space.density else { return Ok(None) };
        let nu = half_space.material.poissons_ratio;
        let shear_modulus = half_space.material.youngs_modulus / (2.0 * (1.0 + nu));
        let shear_speed =
            finite_positive("shear wave speed of the half-space (m/s)", (shear_modulus / density).sqrt())?;
        let resistance = finite_positive("rho c_s^3 of the half-space (kg/s)", shear_modulus * shear_speed)?;
        Ok(Some(Self { coefficient: radiation_factor(nu) / resistance }))
    }

    /// 2 W_rad/(m v²) \[1\]: the radiated energy of an impact at `speed` \[m/s\] over its kinetic energy.
    pub fn loss_fraction(
        &self,
        speed: f64,
        scales: &Scales,
        ground: Surface,
        unloading: &Unloading,
    ) -> Result<f64, OutOfFloatRange> {
        let (peak, branch) = (unloading.peak.indentation, unloading.to_piece());
        let of_loading = integral(&ground.reloading_path.pieces()[..=ground.reloading_path.index_at(peak)], peak);
        let integral = of_loading + integral(&[branch], peak);
        // over the energy of the speed q
        let ratio = scales.speed / speed;
        let fraction = 2.0
            * FORCE_FACTOR
            * integral
            * (self.coefficient * (scales.units.force / scales.units.length))
            * (scales.speed / scales.units.length)
            * ratio
            * ratio;
        if fraction.is_finite() {
            Ok(fraction)
        } else {
            Err(OutOfFloatRange { quantity: "share of the energy that is radiated as waves", value: fraction })
        }
    }
}

/// e_waves = √(e² − loss), or 0 if the waves would absorb more than the recovered energy.
pub fn restitution_with_waves(restitution: f64, loss_fraction: f64) -> f64 {
    (restitution * restitution - loss_fraction).max(0.0).sqrt()
}

/// ∫ f'² |u| dx along these pieces to a turning point at x = `turn`, or back from it.
fn integral(pieces: &[Piece], turn: f64) -> f64 {
    let most = pieces.last().map_or(0.0, |last| last.work_at(turn));
    let speed_at = |work: f64| speed_at_energy((most - work).max(0.0));
    let mut integral = 0.0;
    let mut entry = speed_at(0.0);
    for (i, piece) in pieces.iter().enumerate() {
        let next = pieces.get(i + 1);
        let (end, exit) = next.map_or((turn, 0.0), |next| (next.start, speed_at(next.work)));
        integral += match &piece.shape {
            Shape::Power { exponent, offset: 0.0, .. } if next.is_none() => {
                power_integral(piece.force_at(end), end - piece.start, *exponent)
            }
            Shape::Linear { slope, .. } => straight_integral(*slope, piece.force_at(end), piece.force, entry, exit),
            // no closed form here
            Shape::Power { .. } | Shape::Polynomial(_) | Shape::Unloading(_) => {
                integral_by_quadrature(piece, end, speed_at)
            }
        };
        entry = exit;
    }
    integral
}

/// From rest at a force f_m along f = f_m (d/ε)^n to d = 0, or the other way:
/// n² (f_m²/ε) u_0 B((2n − 1)/(n + 1), 3/2)/(n + 1) with u_0² = 2c f_m ε/(n + 1).
fn power_integral(force: f64, length: f64, n: f64) -> f64 {
    let fastest = speed_at_energy(force * length / (n + 1.0));
    let shape = if n == 1.5 { HERTZ_FACTOR } else { n * n / (n + 1.0) * beta((2.0 * n - 1.0) / (n + 1.0)) };
    shape * (force * force / length) * fastest
}

/// n²/(n + 1) B((2n − 1)/(n + 1), 3/2) for n = 3/2: 0.9 B(0.8, 1.5).
const HERTZ_FACTOR: f64 = 0.795_907_321_770_451_1;

/// B(a, 3/2).
fn beta(a: f64) -> f64 {
    // Γ(3/2)
    const GAMMA: f64 = 0.886_226_925_452_758;
    GAMMA * gamma(a) / gamma(a + 1.5)
}

/// On a straight piece u² + c f²/s = u² + g² is constant, so the integral s ∫ u df is a sector of an ellipse:
/// s^(3/2)/(2√c) [g u + (u² + g²) θ], tan θ = g/u.
fn straight_integral(slope: f64, to_force: f64, from_force: f64, entry: f64, exit: f64) -> f64 {
    let scale = (FORCE_FACTOR / slope).sqrt();
    let (from, to) = (scale * from_force, scale * to_force);
    // the angle between the two states, without the difference of two nearly equal ones
    let angle = atan2(to * entry - from * exit, entry * exit + from * to);
    slope * slope.sqrt() / (2.0 * SQRT_FORCE_FACTOR)
        * (to * exit - from * entry + (entry * entry + from * from) * angle)
}

/// On any piece from its start to `end`, with u from the remaining work.
fn integral_by_quadrature(piece: &Piece, end: f64, speed_at: impl Fn(f64) -> f64) -> f64 {
    integrate(piece.start, end, |x| {
        let slope = piece.slope_at(x);
        slope * slope * speed_at(piece.work_at(x))
    })
}

/// C(ν) \[1\] of a half-space of Poisson's ratio −1 < ν < ½, to 1e-14.
///
/// It is an integral over wave numbers plus the pole of the Rayleigh waves; the tests have its derivation. Here it is a row of
/// Chebyshev's polynomials in z = 2 artanh(γ)/artanh(√¾) − 1, with γ² = (1 − 2ν)/(2 (1 − ν)).
pub fn radiation_factor(poissons_ratio: f64) -> f64 {
    /// artanh(√¾), that of ν = −1.
    const FULL_ROW: f64 = 1.316_957_896_924_816_7;
    const ROW: [f64; 22] = [
        0.245_051_744_118_894_3,
        0.219_008_176_166_169_33,
        0.104_312_334_976_485_98,
        0.032_296_834_997_097_21,
        0.007_625_650_800_456_279,
        0.001_466_307_867_317_199_2,
        0.000_235_118_115_891_131_28,
        3.283_936_415_432_639e-5,
        3.975_733_839_670_003e-6,
        4.361_245_982_804_659_7e-7,
        4.013_895_965_116_79e-8,
        4.823_963_389_923_287e-9,
        -5.836_292_077_671_936e-11,
        1.334_161_551_844_190_4e-10,
        -2.888_427_978_881_062_8e-11,
        8.339_824_877_452_499e-12,
        -2.191_857_536_108_888_7e-12,
        5.823_031_810_096_746e-13,
        -1.526_251_186_849_913_9e-13,
        3.985_149_462_211_029e-14,
        -1.040_923_213_157_348_3e-14,
        2.727_682_219_488_268e-15,
    ];
    let gamma = ((1.0 - 2.0 * poissons_ratio) / (2.0 * (1.0 - poissons_ratio))).sqrt();
    let z = ln_1p(2.0 * gamma / (1.0 - gamma)) / FULL_ROW - 1.0;
    let (last, before) = ROW.iter().rev().fold((0.0, 0.0), |(b, c), a| (a + 2.0 * z * b - c, b));
    last - z * before
}
