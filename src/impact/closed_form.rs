//! An impact without stepping: energy balance for the peak and the restitution, exact times on every piece.
//!
//! Without gravity and damping the motion is conservative on each branch, u² = q² − (5/2) w(x), so the peak is where the
//! work is the kinetic energy, w(x_m) = (2/5) q², and e² = f_m ε_m/(n + 1) / w(x_m). The time on a straight piece is an
//! arctangent, on a power piece an incomplete beta function.

use super::outcome::Outcome;
use crate::impact::scales::ACCELERATION;
use crate::law::curve::{Piece, Shape};
use crate::law::{Law, Unloading};
use crate::power::{arctangent, power_time, quarter_period};

/// Peak, exponent and restitution of an impact at q = v/V: the part that needs no times.
#[must_use]
pub fn energy_balance(law: &Law, speed: f64) -> (Unloading, f64) {
    let kinetic = 0.4 * speed * speed;
    let pieces = law.loading.pieces();
    let last = &pieces[pieces.partition_point(|piece| piece.work <= kinetic).saturating_sub(1)];
    let indentation = last.indentation_at_work(kinetic);
    let force = last.force_at(indentation);
    let elastic_approach = law.elastic_approach(indentation, force);
    let unloading = law.unloading(crate::law::Peak { indentation, force, elastic_approach });
    let recovered = force * elastic_approach / (unloading.exponent + 1.0);
    let is_elastic = indentation <= 1.0;
    (unloading, if is_elastic { 1.0 } else { (recovered / kinetic).sqrt() })
}

/// The whole outcome of an impact at q = v/V, exact to rounding.
#[must_use]
pub fn solve(law: &Law, speed: f64) -> Outcome {
    let (unloading, restitution) = energy_balance(law, speed);
    let kinetic = 0.4 * speed * speed;
    let mut loading_time = 0.0;
    let mut entry = speed;
    let pieces = law.loading.pieces();
    for (i, piece) in pieces.iter().enumerate() {
        // the piece is left at its end, or the sphere turns within it
        let Some(next) = pieces.get(i + 1).filter(|next| next.work <= kinetic) else {
            loading_time += time_to_turn(piece, unloading.peak.indentation - piece.start, entry);
            break;
        };
        let exit = (2.0 * ACCELERATION * (kinetic - next.work)).sqrt();
        loading_time += time_on(piece, next.start - piece.start, entry, exit);
        entry = exit;
    }
    let peak = &unloading.peak;
    let unloading_time = quarter_period(unloading.exponent) * peak.elastic_approach / (restitution * speed);
    Outcome { unloading, restitution, loading_time, contact_time: loading_time + unloading_time }
}

/// Time from the start of a piece, entered at speed `entry`, to the turning point at `distance` beyond it.
///
/// On a straight piece it follows from the speed alone, tan(ωt) = ω u/g. The distance of a turning point just behind a
/// knot would not do: it is a difference of nearly equal numbers.
fn time_to_turn(piece: &Piece, distance: f64, entry: f64) -> f64 {
    match piece.shape {
        Shape::Straight { slope } => {
            let omega = (ACCELERATION * slope).sqrt();
            (omega * entry / (ACCELERATION * piece.force)).atan() / omega
        }
        Shape::Power { exponent, .. } => power_time(exponent, distance, entry, 0.0),
    }
}

/// Time from the start of a piece to `distance` beyond it, entered at speed `entry` and left at `exit`.
fn time_on(piece: &Piece, distance: f64, entry: f64, exit: f64) -> f64 {
    match piece.shape {
        // harmonic motion: x_2 − x_1 = (u_1 + u_2) tan(ωt/2)/ω, which does not cancel on short pieces
        Shape::Straight { slope } => {
            let omega = (ACCELERATION * slope).sqrt();
            2.0 / omega * arctangent(omega * distance / (entry + exit))
        }
        Shape::Power { exponent, .. } => power_time(exponent, distance, entry, exit),
    }
}
