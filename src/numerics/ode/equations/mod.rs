//! The smooth pieces of a motion, each in variables in which it is smooth. Each kind of piece has a file of its own, where it
//! is written once without drag and once with it.
//!
//! **Without drag** a piece is a Nyström problem y'' = g(y) ([`NystromEquation`]), also under a constant pull γ.
//! On a power law d'' = γ − k d^n the force is not smooth at d = 0, which costs any method its order. With s = √d and
//! dσ = dt/(2 s)
//!
//! ```text
//! s' = u,   u' = 2 γ s − 2 k s^(2n+1),   t' = 2 s        (' = d/dσ; u is the speed d' = dd/dt)
//! ```
//!
//! which for n = 3/2 is a polynomial and again of the form y'' = g(y). On straight and other smooth pieces y = d and σ = t.
//!
//! **With drag** it is given by its rates ([`DampedEquation`]), with d = r^m and dσ = dt/(m r^(m−1)):
//!
//! ```text
//! r' = u,   u' = m r^(m−1) (γ − k r^(mn) − drag),   t' = m r^(m−1)
//! ```
//!
//! For n = 3/2 these are polynomials with m = 2, and with m = 4 where the drag goes with √g'(d), that is with d^¼. On a
//! straight piece m = 1. The loss ∫ drag d' dt is integrated along.

pub(super) mod general;
pub(super) mod linear;
pub(super) mod power;

use super::LegProblem;
use crate::numerics::functions::powi;

/// g(y) of one smooth piece without drag, with what stepping, landing and dense output need.
pub(super) trait NystromEquation: Copy + Send + Sync + 'static {
    /// True for y = d and σ = t; false for y = √d and dσ = dt/(2 y).
    const USES_PLAIN_VARIABLES: bool;
    /// True if g is a polynomial, or as smooth as one, also at y = 0.
    const IS_SMOOTH_AT_ZERO: bool;
    fn scale_by(self, factor: f64) -> Self;
    /// g(y).
    fn g(self, y: f64) -> f64;
    /// (g', g'') at y; g' ≤ 0.
    fn derivatives(self, y: f64) -> (f64, f64);
    /// The time that a stretch h of σ with this mean of y takes.
    #[inline(always)]
    fn duration(self, h: f64, mean: f64) -> f64 {
        if Self::USES_PLAIN_VARIABLES { h } else { mean * 2.0 * h }
    }
    #[inline(always)]
    fn y_at(self, distance: f64) -> f64 {
        if Self::USES_PLAIN_VARIABLES { distance } else { distance.sqrt() }
    }
    /// d for y.
    #[inline(always)]
    fn distance_at(self, y: f64) -> f64 {
        if Self::USES_PLAIN_VARIABLES { y } else { y * y }
    }
    /// Potential −∫ g.
    fn potential(self, y: f64) -> f64;
    /// The y > 0 of a given potential.
    fn y_at_potential(self, potential: f64) -> f64;
    /// −g' at y, for the first step.
    #[inline(always)]
    fn stiffness(self, y: f64) -> f64 {
        -self.derivatives(y).0
    }
}

/// A point of a motion with drag: \[y, u, t, loss\]; and its rate along the independent variable.
pub(super) type DampedState = [f64; 4];

/// A motion with drag in its own variables.
pub(super) trait DampedEquation: Copy {
    /// m.
    const VARIABLE_ROOT: i32;
    fn rates(&self, y: f64, u: f64) -> DampedState;

    fn y_at(distance: f64) -> f64 {
        match Self::VARIABLE_ROOT {
            1 => distance,
            2 => distance.sqrt(),
            _ => distance.sqrt().sqrt(),
        }
    }
    /// d for y.
    fn distance_at(y: f64) -> f64 {
        powi(y, Self::VARIABLE_ROOT)
    }
    /// √ of about −du'/dr at y on this path, for the first step.
    fn frequency(path: &LegProblem, y: f64) -> f64 {
        if Self::VARIABLE_ROOT == 1 {
            return path.sqrt_slope(y).max(f64::MIN_POSITIVE);
        }
        let (m, distance) = (f64::from(Self::VARIABLE_ROOT), Self::distance_at(y));
        let [force, slope, _] = path.derivatives(distance);
        (m * powi(y, Self::VARIABLE_ROOT - 2) * ((m - 1.0) * force + m * distance * slope)).sqrt()
    }
}

/// Any piece with drag, by the forces of its path.
#[derive(Debug, Clone, Copy)]
pub(super) struct DampedPieceEquation<'a, const M: u8>(pub LegProblem<'a>);

impl<const M: u8> DampedEquation for DampedPieceEquation<'_, M> {
    const VARIABLE_ROOT: i32 = M as i32;
    fn rates(&self, y: f64, u: f64) -> DampedState {
        // dd/dr, which is also dt/dσ
        let clock = f64::from(M) * powi(y, i32::from(M) - 1);
        let (force, in_contact, on_motion) = self.0.forces(Self::distance_at(y), u);
        let drag = in_contact + on_motion;
        [u, clock * (self.0.constant_acceleration - force - drag), clock, clock * drag * u]
    }
}
