//! An impact without stepping: energy balance for the peak and the restitution, exact times on every piece.
//!
//! Without gravity and damping (for those see `with_forces`) the motion is conservative on each branch,
//! u² = q² − (5/2) w(x). So the peak is where the work is the kinetic energy, w(x_m) = (2/5) q², and
//! e² = f_m ε_m/(n + 1) / w(x_m). The time on a straight piece is an arctangent, on a power piece an incomplete beta
//! function, on any other a quadrature.

mod with_forces;

use super::outcome::{Fate, Outcome};
use super::scaled_forces::ScaledForces;
use super::scales::ACCELERATION;
use crate::law::crossing::Reached;
use crate::law::curve::Curve;
use crate::law::piece::{Piece, Shape};
use crate::law::{Law, Unloading};
use crate::math::functions::atan;
use crate::math::power::{arctangent, power_time};

pub use with_forces::closes;
pub(crate) use with_forces::way_to_peak;

/// The exact outcome of an impact at q = v/V, where there is one: without forces, under gravity without damping, or with
/// the damping of Hunt and Crossley without gravity.
pub fn solve_with(law: &Law, q: f64, forces: &ScaledForces) -> Option<Outcome> {
    if forces.is_none() { Some(solve(law, q)) } else { with_forces::solve(law, q, forces) }
}

/// Peak, exponent and restitution of an impact at q = v/V: the part that needs no times.
pub fn energy_balance(law: &Law, speed: f64) -> (Unloading, f64) {
    let Balance { unloading, restitution, .. } = balance(law, speed);
    (unloading, restitution)
}

/// What the balance of energy gives.
#[derive(Debug, Clone, Copy)]
struct Balance {
    unloading: Unloading,
    restitution: f64,
    /// (2/5) q².
    kinetic: f64,
    /// Index of the piece that the sphere turns on.
    last: usize,
    /// Distance of the turning point from the start of that piece.
    distance: f64,
}

#[inline(always)]
fn balance(law: &Law, speed: f64) -> Balance {
    let kinetic = 0.4 * speed * speed;
    let last = law.turning_piece(kinetic);
    let distance = law.loading.distance_at_work(last, kinetic);
    let unloading = law.turned_at(last, distance, kinetic);
    // a share that differs from 1 by rounding only is 1, and fresh surface gives back no more than was spent
    let share = unloading.capacity() / kinetic;
    let is_one = (share - 1.0).abs() < 8.0 * f64::EPSILON;
    let is_all = is_one || law.is_elastic_to(unloading.peak.indentation) || share > 1.0 && law.branch().is_none();
    let restitution = if is_all { 1.0 } else { share.sqrt() };
    Balance { unloading, restitution, kinetic, last, distance }
}

/// The whole outcome of an impact at q = v/V by the law alone, exact to rounding.
pub fn solve(law: &Law, speed: f64) -> Outcome {
    let Balance { unloading, restitution, kinetic, last, distance } = balance(law, speed);
    let curve = &law.loading;
    let Reached { piece: first, mut start, work, time: mut loading_time } = curve.crossed(kinetic, speed);
    let mut entry = if work == 0.0 { speed } else { (2.0 * ACCELERATION * (kinetic - work)).sqrt() };
    for index in first..last {
        let (piece, next) = (&curve.pieces()[index], &curve.pieces()[index + 1]);
        let exit = (2.0 * ACCELERATION * (kinetic - next.work)).sqrt();
        let length = next.start - piece.start;
        loading_time += match piece.shape {
            Shape::Smooth(_) => time_on_panels(curve, index, [start, length], exit),
            _ => time_on(piece, length, entry, exit),
        };
        (entry, start) = (exit, next.start);
    }
    let (peak, piece) = (&unloading.peak, &curve.pieces()[last]);
    loading_time += match piece.shape {
        Shape::Smooth(_) => time_to_turn_on_panels(curve, last, [start, distance], entry),
        _ => time_to_turn(piece, distance, entry),
    };
    let unloading_time = unloading.quarter_period() * peak.elastic_approach / (restitution * speed);
    Outcome {
        unloading,
        restitution,
        largest_force: law.largest_force(peak),
        loading_time,
        contact_time: loading_time + unloading_time,
        fate: Fate::Separated,
        end_indentation: law.dent(peak).residual(),
        end_speed: -restitution * speed,
        loss: 0.0,
    }
}

/// √c, so that ω = √c √s on a straight piece of slope s.
const ROOT_ACCELERATION: f64 = 1.118_033_988_749_895;

/// Time from the start of a piece, entered at speed `entry`, to the turning point at `distance` beyond it.
///
/// On a straight piece it follows from the speed alone, tan(ωt) = ω u/g. The distance is not used there: just behind a knot
/// it is a difference of nearly equal numbers and has few digits.
#[inline]
fn time_to_turn(piece: &Piece, distance: f64, entry: f64) -> f64 {
    match piece.shape {
        Shape::Straight { slope, inverse_root } => {
            let omega = ROOT_ACCELERATION * slope * inverse_root;
            atan(omega * entry / (ACCELERATION * piece.force)) * inverse_root * (1.0 / ROOT_ACCELERATION)
        }
        Shape::Power { exponent, lead, .. } => time_on_power(piece, exponent, lead, distance, entry, 0.0),
        Shape::Smooth(smooth) => smooth.time(piece.start, 0.0, distance, 0.0, ACCELERATION),
    }
}

#[cold]
fn time_to_turn_on_panels(curve: &Curve, index: usize, way: [f64; 2], entry: f64) -> f64 {
    let piece = &curve.pieces()[index];
    // just behind a knot the time is that on the tangent at the knot, for the same reason
    if way[0] == piece.start && entry * entry < NEAR_KNOT * ACCELERATION * piece.force * piece.start {
        let omega = (ACCELERATION * piece.slope_at(piece.start)).sqrt();
        return atan(omega * entry / (ACCELERATION * piece.force)) / omega;
    }
    time_on_panels(curve, index, way, 0.0)
}

/// Time from x = `from` to a distance from the start of a piece, where the speed is `exit`: on the panels of the piece, or on
/// the piece where it has none, as on a spot that was loaded before.
#[cold]
fn time_on_panels(curve: &Curve, index: usize, [from, distance]: [f64; 2], exit: f64) -> f64 {
    let on_panels = curve.time_on_panels(index, from, distance, exit, ACCELERATION);
    on_panels.unwrap_or_else(|| time_on(&curve.pieces()[index], distance, 0.0, exit))
}

/// The distance of a turning point from a knot has lost digits if it is below half this share of the indentation.
const NEAR_KNOT: f64 = 1e-6;

/// Time from the start of a piece to `distance` beyond it, entered at speed `entry` and left at `exit`.
#[inline]
fn time_on(piece: &Piece, distance: f64, entry: f64, exit: f64) -> f64 {
    match piece.shape {
        // harmonic motion: x_2 − x_1 = (u_1 + u_2) tan(ωt/2)/ω, which does not cancel on short pieces
        Shape::Straight { slope, inverse_root } => {
            let omega = ROOT_ACCELERATION * slope * inverse_root;
            arctangent(omega * distance / (entry + exit)) * inverse_root * (2.0 / ROOT_ACCELERATION)
        }
        Shape::Power { exponent, lead, .. } => time_on_power(piece, exponent, lead, distance, entry, exit),
        Shape::Smooth(smooth) => smooth.time(piece.start, 0.0, distance, exit, ACCELERATION),
    }
}

/// Time on a power law; one that is entered beyond its zero takes the time from the zero, less the time from the zero to the
/// start.
#[inline(always)]
fn time_on_power(piece: &Piece, exponent: f64, lead: f64, distance: f64, entry: f64, exit: f64) -> f64 {
    if lead == 0.0 {
        power_time(exponent, distance, entry, exit)
    } else {
        late_time(piece, exponent, lead, distance, entry, exit)
    }
}

#[cold]
fn late_time(piece: &Piece, exponent: f64, lead: f64, distance: f64, entry: f64, exit: f64) -> f64 {
    let before = 2.0 * ACCELERATION * piece.force * lead / (exponent + 1.0);
    let whole = (entry * entry + before).sqrt();
    power_time(exponent, lead + distance, whole, exit) - power_time(exponent, lead, whole, entry)
}
