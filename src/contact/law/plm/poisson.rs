//! Poisson's ratio of the body that yields. First yield is at the pressure C_ν σ_Y, but the pressure of a fully plastic dent hardly
//! depends on ν. In units of first yield, the pressure of such a dent must be larger where C_ν is smaller than at ν = 0.3.
//!
//! ```text
//! c = C(0.3)/C(ν), with C(0) for ν < 0              t_i = ln(x_i/x_1)/ln(x_last/x_1) at the knots of the force
//! slope i of the force                    × c^min(1, 0.8 (1 + κ²) t_i²)
//! plastic slope of the elastic approach   × c^0.7
//! ```
//!
//! The coefficients were fitted to finite elements with ν = 0.3, where c = 1. The two numbers are fitted to finite elements with
//! ν from 0.03 to 0.42.

use serde::{Deserialize, Serialize};

use crate::contact::pair::{Pair, yield_factor};
use crate::numerics::functions::{exp, ln, pow};

/// ν of the finite elements behind the other coefficients.
const FITTED: f64 = 0.3;

/// The two numbers of the correction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PoissonTable {
    /// The factor in the exponent for the slopes of the force.
    pub force: f64,
    /// The exponent of the plastic slope of the elastic approach.
    pub approach: f64,
}

/// c of the body of a pair that yields; exactly 1 for ν = 0.3, and for bodies that do not yield.
pub(super) fn pressure_ratio(pair: &Pair) -> f64 {
    let Some(point) = &pair.yield_point else { return 1.0 };
    let of_body = if point.poissons_ratio < 0.0 { yield_factor(0.0) } else { point.factor };
    yield_factor(FITTED) / of_body
}

/// t² at the knots of the force.
pub(super) fn squared_positions(knots: &[f64]) -> Vec<f64> {
    let (Some(first), Some(last)) = (knots.first(), knots.last()) else { return Vec::new() };
    let whole = ln(last / first);
    let position = |knot: &f64| if whole > 0.0 { ln(knot / first) / whole } else { 0.0 };
    knots.iter().map(position).map(|t| t * t).collect()
}

impl PoissonTable {
    /// The factors of the slopes of the force that begin at knots with these t².
    pub(super) fn force_factors(
        &self,
        squared_positions: &[f64],
        kappa_squared: f64,
        ratio: f64,
    ) -> impl Iterator<Item = f64> {
        let (of_ratio, share) = (ln(ratio), self.force * (1.0 + kappa_squared));
        squared_positions.iter().map(move |square| {
            let exponent = share * square;
            if exponent < 1.0 { exp(of_ratio * exponent) } else { ratio }
        })
    }

    /// The factor of the plastic slope of the elastic approach.
    pub(super) fn approach_factor(&self, ratio: f64) -> f64 {
        if ratio == 1.0 { 1.0 } else { pow(ratio, self.approach) }
    }
}
