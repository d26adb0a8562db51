//! The course of one impact, leg by leg: piece after piece up the loading curve, the turning point, and back down the
//! unloading branch.
//!
//! ```text
//! x'' = −(5/4) (f − w) − drag,    drag = (5/4) f χ u  or  2 ζ √((5/4) df/dx) u  or  y df/dx u
//! w = m g/Φ,  χ in units of 1/V
//! ```
//!
//! The contact ends where its total force vanishes on the way out: at the residual indentation, or before it under viscous
//! damping. It does not end if the sphere is captured:
//!
//! * without damping, if the recovered work cannot lift the sphere out of the dent, f_m ε/(n + 1) ≤ w ε, or if it had no
//!   speed to begin with; the run then ends at the static indentation on the way out;
//! * with damping, if the sphere turns back towards the half-space before the contact force has vanished. Phase curves
//!   do not cross, so every later swing lies inside of this one and ends in it. The run ends there; or where an
//!   overdamped sphere (ζ from 0.9 on) has crept up to its static indentation, to one part in a thousand.

use super::closed_form::way_to_peak;
use super::outcome::{Fate, Outcome};
use super::record::{Event, Recorder};
use super::scaled_forces::{Creep, ScaledForces, equilibrium};
use super::scales::ACCELERATION;
use crate::integrate::{Arrival, Drag, IntegrationError, Integrator, Landing, Leg, Path, Restoring, Sizes, State};
use crate::law::piece::{Piece, Shape};
use crate::law::{Law, Unloading};
use crate::math::power::max_or_nan;

/// Integrates an impact at q = v/V from first touch to its end.
///
/// # Errors
/// What the integrator reports.
pub fn integrate<I: Integrator>(
    law: &Law,
    q: f64,
    forces: &ScaledForces,
    integrator: &mut I,
    mut recorder: Option<&mut Recorder>,
) -> Result<Outcome, IntegrationError> {
    let distance = way_to_peak(law, 0.4 * q * q, forces);
    let (pull, drag) = (ACCELERATION * forces.weight, forces.drag());
    let sizes = Sizes { distance, speed: (q * q + pull * distance).sqrt() };
    let (first, leg) = way_out(law, 0);
    let mut path = Path { restoring: first, leg, sizes, pull, drag, rest: None };
    // a sphere may come to rest without turning only under gravity and damping
    let may_creep = pull > 0.0 && drag != Drag::NONE;
    let touch = State { time: 0.0, distance: 0.0, speed: q, loss: 0.0 };
    let mut at = start(law, touch, forces.weight, pull);
    let mut largest = 0.0;
    let mut event = Some((Event::Touch, touch));
    let mut go = |path: &Path, at: &mut State, piece: Option<usize>, recorder: Option<&mut Recorder>| {
        let track = recorder.map(|recorder| {
            let first = event.take();
            recorder.begin(piece, first)
        });
        let Arrival { landing, largest_force } = integrator.traverse(path, at, track)?;
        largest = max_or_nan(largest, largest_force / ACCELERATION);
        Ok(landing)
    };

    // first yield ends no leg, because a trace must not change the steps
    let yields_at = law.elastic_until();
    let mut awaits_yield = yields_at > 0.0 && yields_at.is_finite() && law.branch().is_none();
    let mut piece = 0;
    let is_at_rest = loop {
        (path.restoring, path.leg) = way_out(law, piece);
        if piece == 0 && law.stays_on_branch(0.4 * q * q, forces.weight) {
            path.leg = Leg::Outward(f64::INFINITY);
        }
        let creep = if may_creep { creep_on(law, piece, forces, &at, &mut path) } else { None };
        let begun = at.distance;
        let landing = go(&path, &mut at, Some(piece), recorder.as_deref_mut())?;
        if let Some(recorder) = recorder.as_deref_mut().filter(|_| awaits_yield) {
            let distance = yields_at - law.loading.pieces()[piece].start + entry_of(law, piece);
            if distance > begun && at.distance > distance {
                awaits_yield = false;
                recorder.passage(distance).into_iter().for_each(|state| recorder.mark(Event::Yield, state));
            }
        }
        if landing != Landing::End || creep.is_some_and(|creep| at.speed <= creep.below) {
            break landing == Landing::Rest || landing == Landing::End;
        }
        if creep.is_some() {
            // from the place near rest on along the same piece
            continue;
        }
        let is_end_of_branch = piece == 0 && law.branch().is_some();
        piece += 1;
        let is_yield = is_end_of_branch || awaits_yield && law.loading.pieces()[piece].start == yields_at;
        awaits_yield &= !is_yield;
        if let Some(recorder) = recorder.as_deref_mut() {
            recorder.mark(if is_yield { Event::Yield } else { Event::Knot }, at);
        }
        at.distance = entry_of(law, piece);
    };

    let unloading = law.unloading(law.state_at(piece, at.distance - entry_of(law, piece)));
    if let Some(recorder) = recorder.as_deref_mut() {
        recorder.mark(if is_at_rest { Event::Captured } else { Event::Peak }, at);
    }
    let loading_time = at.time;
    at.distance = unloading.peak.elastic_approach;
    let mut fate = Fate::Captured;
    if !is_at_rest {
        at.speed = 0.0;
        path.sizes = Sizes { distance: at.distance, speed: (2.0 * ACCELERATION * unloading.capacity()).sqrt() };
        path.restoring = restoring(&unloading.branch());
        // a sphere that came without speed does not leave
        let is_captured = q == 0.0 || forces.is_conservative() && forces.captures(&unloading, q);
        let end = back_to(forces, &unloading, is_captured);
        path.leg = Leg::Back(end);
        let creep = if may_creep { creep_back(forces, &unloading, &mut path) } else { None };
        let mut landing = go(&path, &mut at, None, recorder.as_deref_mut())?;
        let mut creeps = false;
        if let Some(creep) = creep.filter(|_| landing == Landing::End) {
            creeps = -at.speed <= creep.below;
            if !creeps {
                path.leg = Leg::Back(end);
                landing = go(&path, &mut at, None, recorder.as_deref_mut())?;
            }
        }
        if matches!(landing, Landing::End | Landing::LiftOff) && !is_captured && !creeps {
            fate = Fate::Separated;
        }
        if let Some(recorder) = recorder.as_deref_mut() {
            recorder.mark(if fate == Fate::Separated { Event::Separation } else { Event::Captured }, at);
        }
    }
    let State { time, distance, speed, loss } = at;
    // nothing was lost, so what is above 1 is the error of the run
    let limit = if drag == Drag::NONE && law.plastic(&unloading) == 0.0 { 1.0 } else { f64::INFINITY };
    let outcome = Outcome {
        restitution: if fate == Fate::Captured { 0.0 } else { (-speed / q).min(limit) },
        loading_time,
        contact_time: time,
        fate,
        largest_force: if drag.is_in_contact() { largest } else { law.largest_force(&unloading.peak) },
        end_indentation: distance + law.dent(&unloading.peak).residual(),
        end_speed: speed,
        loss: loss / ACCELERATION,
        unloading,
    };
    if let Some(recorder) = recorder {
        recorder.finish(law, &outcome, drag);
    }
    Ok(outcome)
}

/// The first state: first touch. A sphere without speed starts a very short way further in, where the force of the law is
/// still negligible beside the weight.
fn start(law: &Law, touch: State, weight: f64, pull: f64) -> State {
    if touch.speed != 0.0 {
        return touch;
    }
    let distance = 1e-22 * (equilibrium(law, weight).0 - law.touch());
    let speed = (2.0 * distance * pull).sqrt();
    State { time: speed / pull, distance, speed, loss: 0.0 }
}

/// Sets where the sphere may come to rest on the way back. If that lies ahead, the leg ends near it, and this is the creep
/// there.
#[cold]
fn creep_back(forces: &ScaledForces, unloading: &Unloading, path: &mut Path) -> Option<Creep> {
    let at_rest = forces.static_approach(unloading);
    let creep = forces.creep(at_rest, forces.static_slope(unloading, at_rest));
    path.rest = creep.map(|creep| creep.rest(at_rest));
    let creep = creep.filter(|creep| at_rest + creep.within < unloading.peak.elastic_approach)?;
    path.leg = Leg::Back(at_rest + creep.within);
    Some(creep)
}

/// Sets where the sphere may come to rest on a piece of the loading curve. If that lies ahead, the leg ends near it, and
/// this is the creep there.
#[cold]
fn creep_on(law: &Law, index: usize, forces: &ScaledForces, at: &State, path: &mut Path) -> Option<Creep> {
    path.rest = None;
    let piece = &law.loading.pieces()[index];
    let (x, of) = equilibrium(law, forces.weight);
    let at_rest = (of == index).then_some(x)?;
    let creep = forces.creep(at_rest - law.touch(), piece.slope_at(at_rest))?;
    let distance = at_rest - (piece.start - piece.shape.lead());
    path.rest = Some(creep.rest(distance));
    let near = distance - creep.within;
    if at.distance < near && near < path.leg.end() {
        path.leg = Leg::Outward(near);
        return Some(creep);
    }
    None
}

/// Where the way back ends, if nothing ends it before.
fn back_to(forces: &ScaledForces, unloading: &Unloading, is_captured: bool) -> f64 {
    if is_captured && forces.is_conservative() { forces.static_approach(unloading) } else { 0.0 }
}

/// The deceleration of the sphere on a piece of the loading curve.
#[inline(always)]
fn restoring(piece: &Piece) -> Restoring {
    match piece.shape {
        Shape::Power { stiffness, exponent, .. } => {
            Restoring::Power { coefficient: ACCELERATION * stiffness, exponent }
        }
        Shape::Straight { slope, .. } => {
            Restoring::Straight { at_start: ACCELERATION * piece.force, slope: ACCELERATION * slope }
        }
        Shape::Smooth(force) => Restoring::Smooth { force, start: piece.start, factor: ACCELERATION },
    }
}

/// The way along a piece of the loading curve.
#[inline(always)]
fn way_out(law: &Law, index: usize) -> (Restoring, Leg) {
    let pieces = law.loading.pieces();
    let end = pieces.get(index + 1).map_or(f64::INFINITY, |next| next.start) - pieces[index].start;
    let end = end + pieces[index].shape.lead();
    (restoring(&pieces[index]), Leg::Outward(end))
}

/// The distance of the integrator at the start of a piece.
fn entry_of(law: &Law, index: usize) -> f64 {
    law.loading.pieces()[index].shape.lead()
}
