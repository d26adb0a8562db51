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
use crate::law::piece::{Piece, Shape};
use crate::law::{Law, Unloading};
use crate::math::functions::atan;
use crate::math::power::{arctangent, power_time, quarter_period};
use crate::math::smooth::Smooth;

pub use with_forces::closes;
pub(crate) use with_forces::way_to_peak;

/// The exact outcome of an impact at q = v/V, where there is one: without forces, under gravity without damping, or with
/// the damping of Hunt and Crossley without gravity.
pub fn solve_with(law: &Law, q: f64, forces: &ScaledForces) -> Option<Outcome> {
    if forces.is_none() { Some(solve(law, q)) } else { with_forces::solve(law, q, forces) }
}

/// Peak, exponent and restitution of an impact at q = v/V: the part that needs no times.
pub fn energy_balance(law: &Law, speed: f64) -> (Unloading, f64) {
    let balance = if law.is_plain() { plain_balance(law, speed) } else { balance(law, speed) };
    (balance.unloading, balance.restitution)
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

fn balance(law: &Law, speed: f64) -> Balance {
    let kinetic = 0.4 * speed * speed;
    let last = law.turning_piece(kinetic);
    let distance = law.loading.distance_at_work(last, kinetic);
    Balance::new(law, kinetic, last, distance, law.unloading(law.state_at(last, distance)))
}

/// The same for a law that [is plain](Law::is_plain). It makes no calls, so that the peak stays in registers.
#[inline(always)]
fn plain_balance(law: &Law, speed: f64) -> Balance {
    let kinetic = 0.4 * speed * speed;
    let last = law.loading.index_at_work(kinetic);
    let distance = law.loading.pieces()[last].distance_at_work(kinetic);
    Balance::new(law, kinetic, last, distance, law.plain_unloading(law.plain_state_at(last, distance), kinetic))
}

impl Balance {
    #[inline(always)]
    fn new(law: &Law, kinetic: f64, last: usize, distance: f64, unloading: Unloading) -> Self {
        let recovered = unloading.capacity();
        // a share that differs from 1 by rounding only is 1, and fresh surface gives back no more than was spent
        let share = recovered / kinetic;
        let is_one = (share - 1.0).abs() < 8.0 * f64::EPSILON;
        let is_all = is_one || law.is_elastic_to(unloading.peak.indentation) || share > 1.0 && law.branch().is_none();
        let restitution = if is_all { 1.0 } else { share.sqrt() };
        Self { unloading, restitution, kinetic, last, distance }
    }
}

/// The whole outcome of an impact at q = v/V by the law alone, exact to rounding.
pub fn solve(law: &Law, speed: f64) -> Outcome {
    if law.is_plain() { outcome(law, speed, plain_balance(law, speed)) } else { outcome_of_other(law, speed) }
}

#[cold]
#[inline(never)]
fn outcome_of_other(law: &Law, speed: f64) -> Outcome {
    outcome(law, speed, balance(law, speed))
}

#[inline(always)]
fn outcome(law: &Law, speed: f64, balance: Balance) -> Outcome {
    let Balance { unloading, restitution, kinetic, last, distance } = balance;
    let (first, mut loading_time) = law.loading.crossed(kinetic, speed);
    let pieces = &law.loading.pieces()[first..=last];
    let mut entry = if first == 0 { speed } else { (2.0 * ACCELERATION * (kinetic - pieces[0].work)).sqrt() };
    for (piece, next) in pieces.iter().zip(&pieces[1..]) {
        let exit = (2.0 * ACCELERATION * (kinetic - next.work)).sqrt();
        loading_time += time_on(piece, next.start - piece.start, entry, exit);
        entry = exit;
    }
    let peak = &unloading.peak;
    loading_time += time_to_turn(&pieces[last - first], distance, entry);
    let unloading_time = if unloading.is_power() {
        quarter_period(unloading.exponent) * peak.elastic_approach / (restitution * speed)
    } else {
        other_unloading_time(&unloading, restitution * speed)
    };
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

/// Time on an unloading branch that is no power law; the sphere leaves it at speed `exit`.
#[cold]
fn other_unloading_time(unloading: &Unloading, exit: f64) -> f64 {
    time_to_turn(&unloading.branch(), unloading.peak.elastic_approach, exit)
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
        Shape::Smooth(smooth) => smooth_time_to_turn(piece, &smooth, distance, entry),
    }
}

#[cold]
fn smooth_time_to_turn(piece: &Piece, smooth: &Smooth, distance: f64, entry: f64) -> f64 {
    // just behind a knot the time is that on the tangent at the knot, for the same reason
    if entry * entry < NEAR_KNOT * ACCELERATION * piece.force * piece.start {
        let omega = (ACCELERATION * piece.slope_at(piece.start)).sqrt();
        return atan(omega * entry / (ACCELERATION * piece.force)) / omega;
    }
    smooth.time(piece.start, 0.0, distance, 0.0, ACCELERATION)
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
