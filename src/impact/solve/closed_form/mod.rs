//! An impact without stepping: energy balance for the peak and the restitution, exact times on every piece.
//!
//! Without gravity (for that see `gravity`) and damping the motion is conservative on each branch,
//! u² = q² − (5/2) w(x). So the peak is where the work is the kinetic energy, w(x_m) = (2/5) q², and
//! e² = f_m ε_m/(n + 1) / w(x_m). The time on a straight piece is an arctangent, on a power piece an incomplete beta
//! function, on any other a rule of twenty nodes.

mod gravity;

use std::sync::OnceLock;

use super::outcome::{ImpactEnd, ScaledResult};
use crate::contact::law::{Surface, Unloading, UnloadingRule};
use crate::impact::problem::forces::ScaledForces;
use crate::impact::problem::scales::{FORCE_FACTOR, SQRT_FORCE_FACTOR, kinetic_energy, speed_at_energy};
use crate::numerics::curve::piece::{Piece, Shape};
use crate::numerics::curve::transit::Transit;
use crate::numerics::functions::atan;
use crate::numerics::ode::IntegrationError;
use crate::numerics::power::{arctangent, power_time};

/// The outcome of an impact at q = v/V by the balance of energy; `None` with damping, and on a plate or rod. Under gravity the times
/// have this relative tolerance, else all is exact to rounding.
///
/// # Errors
/// [`IntegrationError`] where the run for the times under gravity gives up.
pub fn solve_conservative<'a>(
    ground: impl Into<Surface<'a>>,
    q: f64,
    forces: &ScaledForces,
    tolerance: f64,
) -> Result<Option<ScaledResult>, IntegrationError> {
    // in units of peak and speed all elastic impacts without gravity are equal
    static ELASTIC: OnceLock<ScaledResult> = OnceLock::new();
    let ground = ground.into();
    let is_elastic = matches!(ground.law.unloading_rule, UnloadingRule::Hertz) && q == 1.0;
    match () {
        () if !forces.is_conservative() => Ok(None),
        () if forces.weight != 0.0 => gravity::solve(ground, q, forces, tolerance).map(Some),
        () if is_elastic && ground.reloading_branch().is_none() => Ok(Some(*ELASTIC.get_or_init(|| solve(ground, q)))),
        () => Ok(Some(solve(ground, q))),
    }
}

/// The results that follow from the balance of energy.
#[derive(Debug, Clone, Copy)]
pub struct EnergySolution {
    pub unloading: Unloading,
    pub restitution: f64,
    /// (2/5) q².
    kinetic: f64,
    /// Index of the piece that the sphere turns on.
    last: usize,
    /// Distance of the turning point from the start of that piece.
    distance: f64,
}

/// Peak, exponent and restitution of an impact at the dimensionless speed q = v/V, without any times.
#[inline(always)]
pub fn solve_energy_balance<'a>(ground: impl Into<Surface<'a>>, speed: f64) -> EnergySolution {
    let ground = ground.into();
    let kinetic = kinetic_energy(speed);
    let (last, distance) = ground.turning_point(kinetic, 0.0);
    let unloading = ground.unload(last, distance, Some(kinetic));
    // a share that differs from 1 by rounding only is 1, and fresh surface gives back no more than was spent
    let share = unloading.recoverable_energy() / kinetic;
    let is_one = (share - 1.0).abs() < 8.0 * f64::EPSILON;
    let is_all = is_one
        || ground.is_elastic_at(unloading.peak.indentation)
        || share > 1.0 && ground.reloading_branch().is_none();
    let restitution = if is_all { 1.0 } else { share.sqrt() };
    EnergySolution { unloading, restitution, kinetic, last, distance }
}

/// The whole outcome of an impact at the dimensionless speed q = v/V by the law alone, exact to rounding.
pub fn solve<'a>(ground: impl Into<Surface<'a>>, speed: f64) -> ScaledResult {
    let ground = ground.into();
    let EnergySolution { unloading, restitution, kinetic, last, distance } = solve_energy_balance(ground, speed);
    let Transit { piece: first, work, time: mut loading_time } = ground.reloading_path.transit(kinetic, speed);
    let mut entry = if work == 0.0 { speed } else { speed_at_energy(kinetic - work) };
    let pieces = ground.reloading_path.pieces();
    for pair in pieces[first..=last].windows(2) {
        let exit = speed_at_energy(kinetic - pair[1].work);
        loading_time += piece_time(&pair[0], pair[1].start - pair[0].start, [entry, exit]);
        entry = exit;
    }
    loading_time += piece_time(&pieces[last], distance, [entry, 0.0]);
    let peak = &unloading.peak;
    let unloading_time = unloading.quarter_period_factor() * peak.elastic_approach / (restitution * speed);
    ScaledResult {
        unloading,
        restitution,
        largest_force: ground.reported_force(&unloading, None),
        loading_time,
        contact_time: loading_time + unloading_time,
        end: ImpactEnd::Separated,
        end_indentation: ground.deepest_state(peak).residual(),
        end_speed: -restitution * speed,
        loss: 0.0,
    }
}

/// Time on a piece to a distance from its start, with the speeds at both; 0 is the turning point.
///
/// To the turning point of a straight piece it follows from the speed alone, tan(ωt) = ω u/g. The distance is not used there:
/// just behind a knot it is a difference of nearly equal numbers and has few digits.
#[inline(always)]
fn piece_time(piece: &Piece, distance: f64, [entry, exit]: [f64; 2]) -> f64 {
    match &piece.shape {
        Shape::Linear { slope, inverse_root } => {
            let omega = SQRT_FORCE_FACTOR * slope * inverse_root;
            let by_root = inverse_root * (1.0 / SQRT_FORCE_FACTOR);
            if exit == 0.0 {
                return atan(omega * entry / (FORCE_FACTOR * piece.force)) * by_root;
            }
            // harmonic motion: x_2 − x_1 = (u_1 + u_2) tan(ωt/2)/ω, which does not cancel on short pieces
            2.0 * arctangent(omega * distance / (entry + exit)) * by_root
        }
        Shape::Power { exponent, offset: 0.0, .. } => power_time(*exponent, distance, entry, exit),
        Shape::Power { exponent, offset, .. } => {
            let begun = 2.0 * FORCE_FACTOR * piece.force * offset / (exponent + 1.0);
            // the time from the zero of the force, where the speed is `whole`, less the time from there to the start
            let whole = (entry * entry + begun).sqrt();
            power_time(*exponent, offset + distance, whole, exit) - power_time(*exponent, *offset, whole, entry)
        }
        Shape::Polynomial(poly) => poly.travel_time(distance, distance, exit, FORCE_FACTOR),
        Shape::Unloading(branch) => branch.travel_time(distance, distance, exit, FORCE_FACTOR),
    }
}
