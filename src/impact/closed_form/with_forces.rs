//! An impact under gravity, or with the damping of Hunt and Crossley, without stepping.
//!
//! Under gravity alone the motion is conservative on each branch; with w = m g/Φ, x the indentation and u the speed
//!
//! ```text
//! (2/5) u² = (2/5) q² + w x − W(x)
//! ```
//!
//! With the force factor 1 + χ u and no gravity, u du = −(5/4) f (1 + χ u) dx is separable,
//!
//! ```text
//! G(u) = G(q) − (5/4) W(x),   G(u) = u/χ − ln(1 + χ u)/χ²        (½ u² for χ → 0)
//! ```
//!
//! So peak and rebound are roots in both cases, and the time is ∫ dx/u. On straight pieces under gravity it has a closed
//! form. Elsewhere a quadrature is given the distances from both ends of the piece, which keep their digits near the ends.

use crate::impact::forces::ScaledForces;
use crate::impact::outcome::{Fate, Outcome};
use crate::impact::scales::ACCELERATION;
use crate::integrate::Drag;
use crate::law::Law;
use crate::law::piece::{Piece, Shape};
use crate::math::functions::{atan, atan2, exp, exp_m1, ln_1p};
use crate::math::power::{max_or_nan, power};
use crate::math::quadrature;
use crate::math::root::falls_through;

/// Where an impact of energy `kinetic` (in units of Φ L) and weight w turns: the piece, and the distance from its start.
fn peak(law: &Law, kinetic: f64, weight: f64) -> (usize, f64) {
    let pieces = law.loading.pieces();
    let touch = law.touch();
    // W(x) − w x is convex, and not above the energy before the peak
    let last = if law.stays_on_branch(kinetic, weight) {
        0
    } else {
        pieces.partition_point(|piece| piece.work - weight * (piece.start - touch) <= kinetic).saturating_sub(1)
    };
    let piece = &pieces[last];
    let rest = (kinetic + weight * (piece.start - touch) - piece.work).max(0.0);
    (last, piece.way_to_turn(rest, weight))
}

/// The whole way from first touch to the turning point of an impact of energy `kinetic`, as it would be without damping.
pub(crate) fn way_to_peak(law: &Law, kinetic: f64, forces: &ScaledForces) -> f64 {
    let pieces = law.loading.pieces();
    let (last, distance) = peak(law, kinetic, forces.weight);
    pieces[last].start - law.touch() + distance
}

/// The function G(u) of the text above, and its inverse.
#[derive(Debug, Clone, Copy)]
struct Speeds {
    /// χ in units of 1/V; with 0, G(u) is ½ u².
    chi: f64,
}

impl Speeds {
    /// G(u); u is negative on the way out.
    fn energy(self, u: f64) -> f64 {
        let v = self.chi * u;
        if v == 0.0 { 0.5 * u * u } else { excess(v) / (self.chi * self.chi) }
    }

    /// |u| where G(u) = `energy` ≥ 0, on the way in (`sign` 1) or out (−1).
    fn speed(self, energy: f64, sign: f64) -> f64 {
        let elastic = (2.0 * energy).max(0.0).sqrt();
        let wanted = energy * self.chi * self.chi;
        if wanted <= 0.0 {
            return elastic;
        }
        if sign < 0.0 && wanted > FAR {
            return (1.0 - far_out(wanted)) / self.chi;
        }
        let mut v = sign * elastic * self.chi;
        // first guess from v²/2 − v³/3 + … = η (`wanted`): on the way in v is above √(2η); on the way out |v| is smaller, and
        // the guess must stay above v = −1
        v = if sign > 0.0 { v + wanted * (2.0 / 3.0) } else { exp_m1(-elastic * self.chi - wanted) };
        for _ in 0..50 {
            let change = (excess(v) - wanted) * (1.0 + v) / v;
            let next = v - change;
            let next = if next <= -1.0 { 0.5 * (v - 1.0) } else { next };
            if (next - v).abs() <= 2.0 * f64::EPSILON * v.abs() {
                v = next;
                break;
            }
            v = next;
        }
        v.abs() / self.chi
    }
}

/// Above this χ² G the way out is solved for 1 + v.
const FAR: f64 = 2.0;

/// y = 1 + v where v − ln(1 + v) = `wanted` is large: v is then so near to −1 that a double cannot hold the difference.
fn far_out(wanted: f64) -> f64 {
    // y = exp(y − 1 − wanted), a contraction by y < 0.06
    (0..16).fold(0.0, |y: f64, _| exp(y - 1.0 - wanted))
}

/// v − ln(1 + v), without cancellation for small v.
fn excess(v: f64) -> f64 {
    if v.abs() > 0.05 {
        return v - ln_1p(v);
    }
    // Σ (−1)^k v^k/k, k ≥ 2: the first term left out is 0.05^14/15 of the first
    let mut total = 0.0;
    for k in (2..=15).rev() {
        total = 1.0 / f64::from(k) - v * total;
    }
    v * v * total
}

/// Whether motion under gravity has a closed form on this law: loading and unloading are made of power laws and straight
/// lines.
pub fn closes(law: &Law) -> bool {
    // the kind of the unloading branch is the same from every plastic peak
    let is_power = || {
        law.elastic_until().is_infinite() || law.unloading(law.loaded_to(2.0 * law.elastic_until().max(1.0))).is_power()
    };
    has_closed_loading(law) && is_power()
}

fn has_closed_loading(law: &Law) -> bool {
    law.loading.pieces().iter().all(|piece| !matches!(piece.shape, Shape::Smooth(_)))
}

/// The exact outcome, where there is one: gravity without damping, or Hunt and Crossley without gravity.
pub(super) fn solve(law: &Law, q: f64, forces: &ScaledForces) -> Option<Outcome> {
    let (Drag { chi, eta, theta }, weight) = (forces.drag, forces.weight);
    if eta != 0.0 || theta != 0.0 || chi != 0.0 && weight != 0.0 || !has_closed_loading(law) {
        return None;
    }
    let speeds = Speeds { chi };
    let kinetic = speeds.energy(q) / ACCELERATION;
    let (last, distance) = peak(law, kinetic, weight);
    let unloading = law.turned(last, distance);
    if !unloading.is_power() {
        return None;
    }
    let loading_time = loading_time(&law.loading.pieces()[..=last], distance, q, weight, speeds);

    let elastic_approach = unloading.peak.elastic_approach;
    let is_captured = forces.captures(&unloading, q);
    let is_elastic = chi == 0.0 && law.plastic(&unloading) == 0.0;
    let stored = unloading.capacity();
    // if the dent does not grow and nothing is lost, the rebound speed is the impact speed
    let recovered = ACCELERATION * (stored - weight * elastic_approach);
    let rebound = if is_elastic { q } else { speeds.speed(recovered, -1.0) };
    // under strong damping G(u) cannot be computed from the rounded rebound speed
    let at_end = if chi == 0.0 { speeds.energy(-rebound) } else { recovered };
    // the sphere leaves at the end of the branch, or its run ends at the static indentation
    let at_rest = if is_captured { unloading.recovered_at(weight) } else { 0.0 };
    let (branch, length) = (unloading.branch(), (elastic_approach - at_rest).max(0.0));
    let (at_end, end_speed) = if is_captured {
        let energy = ACCELERATION * (work_between(&branch, at_rest, length) - weight * length);
        (energy, -speeds.speed(energy.max(0.0), -1.0))
    } else {
        (at_end, -rebound)
    };
    let contact_time = loading_time + time_between(&branch, [at_rest, length], [at_end, 0.0], weight, speeds, -1.0);
    let loss = if chi == 0.0 {
        0.0
    } else {
        // the energy that damping takes on the way in and on the way out
        let way_in = 0.4 * q * q - law.work_to(&unloading.peak);
        way_in + stored - 0.4 * rebound * rebound
    };
    Some(Outcome {
        unloading,
        restitution: if is_captured { 0.0 } else { rebound / q },
        largest_force: if chi == 0.0 {
            law.largest_force(&unloading.peak)
        } else {
            largest_force(law, last, distance, speeds.energy(q), speeds)
        },
        loading_time,
        contact_time,
        fate: if is_captured { Fate::Captured } else { Fate::Separated },
        end_indentation: law.dent(&unloading.peak).residual() + at_rest,
        end_speed,
        loss,
    })
}

/// The largest contact force f (1 + χ u) on the way to the turning point at `distance` from the start of piece `last`. It
/// rises where df/dx u > (5/4) χ f².
fn largest_force(law: &Law, last: usize, distance: f64, energy: f64, speeds: Speeds) -> f64 {
    let pieces = law.loading.pieces();
    let mut largest = 0.0;
    for (index, piece) in pieces[..=last].iter().enumerate() {
        let end = if index < last { pieces[index + 1].start - piece.start } else { distance };
        let speed = |d: f64| speeds.speed(energy - ACCELERATION * piece.work_at(piece.start + d), 1.0);
        let force = |d: f64| piece.force_at(piece.start + d) * (1.0 + speeds.chi * speed(d));
        largest = max_or_nan(largest, max_or_nan(force(0.0), force(end)));
        let growth = |d: f64| {
            let f = piece.force_at(piece.start + d);
            piece.slope_at(piece.start + d) * speed(d) - ACCELERATION * speeds.chi * f * f
        };
        if growth(0.0) >= 0.0 && growth(end) < 0.0 {
            largest = max_or_nan(largest, force(falls_through((0.0, end), growth)));
        }
    }
    largest
}

/// Time along these pieces to the turning point at `distance` from the start of the last one.
fn loading_time(pieces: &[Piece], distance: f64, q: f64, weight: f64, speeds: Speeds) -> f64 {
    let mut time = 0.0;
    let (mut entry, mut energy) = (q, speeds.energy(q));
    for (index, piece) in pieces.iter().enumerate() {
        let next = pieces.get(index + 1);
        let (length, left) = next.map_or((distance, 0.0), |next| {
            let spent = next.work - piece.work - weight * (next.start - piece.start);
            (next.start - piece.start, (energy - ACCELERATION * spent).max(0.0))
        });
        let exit = speeds.speed(left, 1.0);
        time += match piece.shape {
            Shape::Straight { slope, .. } if speeds.chi == 0.0 => {
                let omega = (ACCELERATION * slope).sqrt();
                if next.is_none() {
                    atan2(omega * entry, ACCELERATION * (piece.force - weight)) / omega
                } else {
                    // harmonic motion: x_2 − x_1 = (u_1 + u_2) tan(ωt/2)/ω
                    2.0 * atan(omega * length / (entry + exit)) / omega
                }
            }
            _ => time_between(piece, [0.0, length], [energy, left], weight, speeds, 1.0),
        };
        (entry, energy) = (exit, left);
    }
    time
}

/// Time on a piece from a distance from its start over a length, where G(u) is `at_start` and `at_end`, on the way in (`sign` 1)
/// or out (−1).
fn time_between(
    piece: &Piece,
    [from, length]: [f64; 2],
    [at_start, at_end]: [f64; 2],
    weight: f64,
    speeds: Speeds,
    sign: f64,
) -> f64 {
    quadrature::integrate(length, |below, above| {
        // from the nearer end, where nothing cancels
        let near = if below < above {
            at_start - ACCELERATION * (work_between(piece, from, below) - weight * below)
        } else {
            at_end + ACCELERATION * (work_between(piece, from + below, above) - weight * above)
        };
        1.0 / speeds.speed(near, sign)
    })
}

/// Work on a piece between the distances `distance` and `distance + by` from its start.
fn work_between(piece: &Piece, distance: f64, by: f64) -> f64 {
    match piece.shape {
        Shape::Straight { slope, .. } => by * (piece.force + slope * (distance + 0.5 * by)),
        Shape::Power { stiffness, exponent, lead } => stiffness * power_between(exponent, lead + distance, by),
        Shape::Smooth(smooth) => smooth.work(piece.start, distance, distance + by),
    }
}

/// ∫ d^n between `distance` and `distance + by`: the difference of d^(n+1)/(n+1) at the ends, without cancellation.
fn power_between(exponent: f64, distance: f64, by: f64) -> f64 {
    let p = exponent + 1.0;
    let end = distance + by;
    power(end, exponent) * end / p * -exp_m1(p * ln_1p(-by / end))
}
