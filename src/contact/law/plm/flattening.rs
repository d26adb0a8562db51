//! A ball that yields: a flat is softer than a dent of the same depth, and recovers less.
//!
//! ```text
//! φ = 1 + 5 Σ β_i (δ R/R_i²) max(0, 1 − A_fp/A_P)
//! f = f_P/φ                                                 at points at most 10 % apart, straight between them
//! ε = min(x, ε_line(f) (1 − 0.8 Σ β_i (E*/E_i*) s_i)),      s_i = (√(δ R) − √(δ_Y R))/R_i
//! ```
//!
//! The sums are over the sphere and a half-space with a positive radius, and β_i is the fraction of the yielding in each ball
//! ([`YieldPartition`](crate::contact::pair::YieldPartition)). Two equal balls are one ball on a rigid wall at half the approach. f_P, ε_P and
//! A_P = f_P/ε_P belong to the law without φ, and from A_fp on its approach is fully plastic. The contact radius and the exponent
//! "pressure-shape" follow from A_P. A sphere that hardens has A' in place of A_P, and the yield point of σ_rep in s
//! ([`hardening`](super::hardening)). φ stays constant after a/R has reached 0.6. If no ball yields, φ = 1.
//!
//! Two constants are fitted to finite elements of 11 pairs of bodies and 31 unloadings with a/R up to 0.3: force
//! 0.94 % rms and 2.5 % largest, residual indentation 0.5 and 1.5 % of the depth, e with "pressure-shape" 0.93 and 1.9 %.

use std::sync::Arc;

use super::hardening::{MAX_POINT_RATIO, geometric_points};
use crate::contact::pair::{Ball, Pair};
use crate::numerics::curve::LoadingCurve;

/// The constants 5 and 0.8 of the formulas above: the flat is softer, and recovers less.
const SOFTENING: f64 = 5.0;
const RECOVERY: f64 = 0.8;

/// From this a/R on φ is constant.
const MAX_RADIUS_RATIO: f64 = 0.6;

/// How the flat of a ball changes the PLM, in units of first yield.
#[derive(Debug, Clone, PartialEq)]
pub struct Flattening {
    /// f_P.
    pub(super) unflattened_curve: Arc<LoadingCurve>,
    /// 0.8 Σ β_i (E*/E_i*) a_Y/R_i.
    recovery: f64,
}

impl Flattening {
    /// Makes the loading curve f, and the flattening, which keeps f_P. `equivalents` computes two values at (x, f_P): A_P, and A_P in
    /// units of the strength reached there. `radius` computes a/a_Y at (x, A_P), and `plastic_from` is A_fp. While φ is constant, the
    /// straight pieces of f_P are not divided.
    pub(super) fn new(
        pair: &Pair,
        yield_radius_ratio: f64,
        plastic_from: f64,
        unflattened_curve: Arc<LoadingCurve>,
        mut equivalents: impl FnMut(f64, f64) -> [f64; 2],
        radius: impl Fn(f64, f64) -> f64,
    ) -> (LoadingCurve, Self) {
        let (mut softening, mut recovery) = (0.0, 0.0);
        for Ball { share, compliance, curvature } in pair.balls {
            softening += SOFTENING * share * (curvature * curvature);
            recovery += RECOVERY * share * compliance * curvature;
        }
        let softening = softening * yield_radius_ratio * yield_radius_ratio;
        // from the indentation R on, no law holds
        let end = 1.0 / (yield_radius_ratio * yield_radius_ratio);
        // φ, and whether it stays constant from here on: A is never less than a/a_Y
        let mut flat = |x: f64, force: f64| {
            let [equivalent, in_strength] = equivalents(x, force);
            let is_wide = || radius(x, equivalent) * yield_radius_ratio >= MAX_RADIUS_RATIO;
            let is_held = x >= end || equivalent * yield_radius_ratio >= MAX_RADIUS_RATIO && is_wide();
            (1.0 + softening * x * (1.0 - plastic_from / in_strength).max(0.0), is_held)
        };
        let pieces = unflattened_curve.pieces();
        let (last, mut x) = (&pieces[pieces.len() - 1], pieces.get(1).map_or(1.0, |piece| piece.start));
        let (mut factor, mut is_held, mut points) = (1.0, false, Vec::with_capacity(128));
        points.push([x, x * x.sqrt()]);
        for pair in pieces.windows(2).skip(1) {
            let (piece, next) = (&pair[0], &pair[1]);
            if is_held || flat(next.start, next.force).0 == 1.0 {
                points.push([next.start, next.force / factor]);
                continue;
            }
            for x in geometric_points(piece.start, next.start) {
                let force = piece.force_at(x);
                if !is_held {
                    (factor, is_held) = flat(x, force);
                }
                points.push([x, force / factor]);
            }
        }
        x = last.start.max(x);
        while !is_held {
            x *= MAX_POINT_RATIO;
            let force = last.force_at(x);
            (factor, is_held) = flat(x, force);
            points.push([x, force / factor]);
        }
        let (from, [to, _]) = (points[0], points[points.len() - 1]);
        let curve = LoadingCurve::hertz().then_points(from, points[1..].iter().copied());
        let curve = curve.then_line(to, last.slope_at(to) / factor);
        (curve.with_transit_series(), Self { unflattened_curve, recovery: recovery * yield_radius_ratio })
    }

    /// The fraction of ε_line that is recovered at x > 1, where the strength is σ_rep = r σ_Y. Beyond δ = R, where no law holds, it
    /// stays positive.
    pub(super) fn recovery_factor(&self, x: f64, r: f64) -> f64 {
        1.0 - (self.recovery * (x.sqrt() - r)).min(RECOVERY)
    }
}
