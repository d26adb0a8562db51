//! Gravity alone, and the damping of Hunt and Crossley alone, without steps: what the integrators are compared with.
//!
//! Under gravity the motion is conservative on each branch; with w = m g/Φ, x the indentation and u the speed
//! (2/5) u² = (2/5) q² + w x − W(x). With the force factor 1 + χ u and no gravity, u du = −(5/4) f (1 + χ u) dx is separable,
//!
//! ```text
//! G(u) = G(q) − (5/4) W(x),   G(u) = u/χ − ln(1 + χ u)/χ²        (½ u² for χ → 0)
//! ```
//!
//! So peak and rebound are roots in both cases, and the time is ∫ dx/u, given the distances from both ends of a piece, which
//! keep their digits near the ends. Only for laws of power laws and straight lines.

use plm_impact::numerics::curve::piece::{Piece, Shape};
use plm_impact::numerics::quadrature;
use plm_impact::numerics::root::bisect;

use crate::common::prelude::*;

const C: f64 = 1.25;

#[derive(Clone, Copy)]
struct Speeds {
    /// χ in units of 1/V; with 0, G(u) is ½ u².
    chi: f64,
}

impl Speeds {
    /// G(u); u is negative during the rebound.
    fn energy(self, u: f64) -> f64 {
        let v = self.chi * u;
        if v == 0.0 { 0.5 * u * u } else { excess(v) / (self.chi * self.chi) }
    }

    /// |u| where G(u) = `energy` ≥ 0, during loading (`sign` 1) or rebound (−1).
    fn speed(self, energy: f64, sign: f64) -> f64 {
        let elastic = (2.0 * energy).max(0.0).sqrt();
        let wanted = energy * self.chi * self.chi;
        if wanted <= 0.0 {
            return elastic;
        }
        if sign < 0.0 && wanted > 2.0 {
            // y = 1 + v is so small that a double v cannot hold it; y = exp(y − 1 − wanted) is a contraction
            return (1.0 - (0..16).fold(0.0, |y: f64, _| (y - 1.0 - wanted).exp())) / self.chi;
        }
        let v = sign * elastic * self.chi;
        // from v²/2 − v³/3 + … = η (`wanted`), and above v = −1 during the rebound
        let mut v = if sign > 0.0 { v + wanted * (2.0 / 3.0) } else { (v - wanted).exp_m1() };
        for _ in 0..50 {
            let next = v - (excess(v) - wanted) * (1.0 + v) / v;
            let next = if next <= -1.0 { 0.5 * (v - 1.0) } else { next };
            let is_found = (next - v).abs() <= 2.0 * f64::EPSILON * v.abs();
            v = next;
            if is_found {
                break;
            }
        }
        v.abs() / self.chi
    }
}

/// v − ln(1 + v), without cancellation for small v.
fn excess(v: f64) -> f64 {
    if v.abs() > 0.05 {
        return v - v.ln_1p();
    }
    // Σ (−1)^k v^k/k, k ≥ 2
    v * v * (2..=15).rev().fold(0.0, |total, k| 1.0 / f64::from(k) - v * total)
}

/// The outcome of a sphere that leaves, or stays without damping.
pub fn solve<'a>(ground: impl Into<Surface<'a>>, q: f64, forces: &ScaledForces) -> ScaledResult {
    let ground = ground.into();
    let (speeds, weight) = (Speeds { chi: forces.damping.hunt_crossley }, forces.weight);
    assert!(
        forces.damping.viscous == 0.0
            && forces.damping.plate == 0.0
            && (weight == 0.0 || forces.damping.hunt_crossley == 0.0)
    );
    let touch = ground.first_contact();
    let pieces = ground.reloading_path.pieces();
    let kinetic = speeds.energy(q) / C;
    // the turn: W(x) − w (x − touch) is convex, and not above the energy before it
    let missing = |piece: &Piece| piece.work - weight * (piece.start - touch) - kinetic;
    let last = pieces.partition_point(|piece| missing(piece) <= 0.0).saturating_sub(1);
    // a reload that has just the energy of the branch turns on it
    let last = if ground.reloading_branch().is_some_and(|branch| {
        kinetic + weight * branch.peak.elastic_approach <= branch.recoverable_energy() * (1.0 + 32.0 * f64::EPSILON)
    }) {
        0
    } else {
        last
    };
    let piece = pieces[last].clone();
    let spent = |d: f64| work_between(&piece, 0.0, d) - weight * d + missing(&piece);
    let mut far = 1.0;
    while spent(far) < 0.0 {
        far *= 2.0;
    }
    let distance = bisect(0.0, far, |d| spent(d) < 0.0 || piece.force_at(piece.start + d) < weight).1;
    // on the branch of a dent the distance has digits that the indentation has lost
    let on_branch = ground.reloading_branch().filter(|branch| last == 0 && distance < branch.peak.elastic_approach);
    let unloading = match on_branch {
        Some(branch) => {
            let indentation = piece.start + distance;
            let force = branch.power_stiffness() * distance.powf(branch.exponent);
            branch.with_peak(ContactState { indentation, force, elastic_approach: distance })
        }
        None => ground.unload_at(piece.start + distance - ground.first_contact()),
    };
    let loading_time = loading_time(&pieces[..=last], distance, q, weight, speeds);
    let is_captured = forces.is_captured(&unloading, q);
    let stored = unloading.recoverable_energy();
    let recovered = C * (stored - weight * unloading.peak.elastic_approach);
    let is_elastic = speeds.chi == 0.0 && ground.plastic_work(&unloading) == 0.0;
    let rebound = if is_elastic { q } else { speeds.speed(recovered, -1.0) };
    let branch = unloading.to_piece();
    let carries = |d: f64| unloading.force(unloading.peak.residual() + d) < weight;
    let at_rest = if is_captured { bisect(0.0, unloading.peak.elastic_approach, carries).1 } else { 0.0 };
    let length = (unloading.peak.elastic_approach - at_rest).max(0.0);
    let at_end = C * (work_between(&branch, at_rest, length) - weight * length);
    let at_end = if is_elastic && !is_captured { speeds.energy(-q) } else { at_end };
    let end_speed = if is_captured { speeds.speed(at_end.max(0.0), -1.0) } else { rebound };
    let back = time_between(&branch, [at_rest, length], [at_end, 0.0], weight, speeds, -1.0);
    ScaledResult {
        unloading,
        restitution: if is_captured { 0.0 } else { rebound / q },
        largest_force: largest_force(pieces, last, distance, speeds.energy(q), speeds),
        loading_time,
        contact_time: loading_time + back,
        end: if is_captured { ImpactEnd::Captured } else { ImpactEnd::Separated },
        end_indentation: ground.deepest_state(&unloading.peak).residual() + at_rest,
        end_speed: -end_speed,
        loss: 0.4 * q * q - ground.reloading_path.work(unloading.peak.indentation) + stored - 0.4 * rebound * rebound,
    }
}

/// The largest contact force f (1 + χ u) on the way to the turning point. It rises where df/dx u > (5/4) χ f².
fn largest_force(pieces: &[Piece], last: usize, distance: f64, energy: f64, speeds: Speeds) -> f64 {
    let mut largest: f64 = 0.0;
    for (index, piece) in pieces[..=last].iter().enumerate() {
        let end = if index < last { pieces[index + 1].start - piece.start } else { distance };
        let speed = |d: f64| speeds.speed(energy - C * piece.work_at(piece.start + d), 1.0);
        let force = |d: f64| piece.force_at(piece.start + d) * (1.0 + speeds.chi * speed(d));
        let grows = |d: f64| {
            let f = piece.force_at(piece.start + d);
            piece.slope_at(piece.start + d) * speed(d) >= C * speeds.chi * f * f
        };
        largest = largest.max(force(0.0)).max(force(end));
        if grows(0.0) && !grows(end) {
            largest = largest.max(force(bisect(0.0, end, grows).1));
        }
    }
    largest
}

/// Time along these pieces to the turning point at `distance` from the start of the last one.
fn loading_time(pieces: &[Piece], distance: f64, q: f64, weight: f64, speeds: Speeds) -> f64 {
    let (mut time, mut energy) = (0.0, speeds.energy(q));
    for (index, piece) in pieces.iter().enumerate() {
        let next = pieces.get(index + 1);
        let (length, left) = next.map_or((distance, 0.0), |next| {
            let spent = next.work - piece.work - weight * (next.start - piece.start);
            (next.start - piece.start, (energy - C * spent).max(0.0))
        });
        time += time_between(piece, [0.0, length], [energy, left], weight, speeds, 1.0);
        energy = left;
    }
    time
}

/// Time on a piece from a distance from its start over a length, where G(u) is `at_start` and `drift_at_end`, during loading (`sign`
/// 1) or rebound (−1).
fn time_between(
    piece: &Piece,
    [from, length]: [f64; 2],
    [at_start, at_end]: [f64; 2],
    weight: f64,
    speeds: Speeds,
    sign: f64,
) -> f64 {
    quadrature::tanh_sinh(length, |below, above| {
        // from the nearer end, where nothing cancels
        let near = if below < above {
            at_start - C * (work_between(piece, from, below) - weight * below)
        } else {
            at_end + C * (work_between(piece, from + below, above) - weight * above)
        };
        1.0 / speeds.speed(near, sign)
    })
}

/// Work on a piece between the distances `distance` and `distance + by` from its start, without cancellation.
fn work_between(piece: &Piece, distance: f64, by: f64) -> f64 {
    match &piece.shape {
        Shape::Linear { slope, .. } => by * (piece.force + slope * (distance + 0.5 * by)),
        Shape::Power { stiffness, exponent, offset } => {
            let (p, end) = (exponent + 1.0, offset + distance + by);
            stiffness * end.powf(p) / p * -(p * (-by / end).ln_1p()).exp_m1()
        }
        Shape::Polynomial(_) | Shape::Unloading(_) => panic!("no formulas here"),
    }
}
