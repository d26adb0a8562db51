//! The motion of one impact, leg by leg: the pieces of the loading curve one after the other, the turning point, and the unloading
//! branch.
//!
//! ```text
//! x'' = −(5/4) (f − w) − drag,    drag = (5/4) f χ u  or  2 ζ √((5/4) df/dx) u  or  y df/dx u
//! w = m g/Φ,  χ in units of 1/V
//! ```
//!
//! The contact ends where its total force vanishes during the rebound: at the residual indentation, or before it under viscous
//! damping. The run of a captured sphere ends when the rebound reaches the static indentation. With damping, the run also ends if
//! the sphere moves towards the half-space again before the contact force has vanished. Trajectories in the phase plane do not
//! cross, so all later oscillations stay inside this one and the sphere remains captured. An overdamped sphere (ζ from 0.9 on)
//! creeps up to its static indentation, and its run ends within one part in a thousand of it.
//!
//! On a plate the momentum of the sphere stays constant when the force drops from f_1 to f_2, as in the relaxation of the metal:
//!
//! ```text
//! p = u + y f   =>   u rises by y (f_1 − f_2)
//! ```
//!
//! So the bodies approach a little further after the relaxation, along the unloading branch. They turn before the branch meets the
//! loading curve, because u + y f can only fall. The peak in the results is the peak before the relaxation.

use super::outcome::{ImpactEnd, ScaledResult};
use super::recorder::{Event, TraceRecorder};
use crate::contact::law::Surface;
use crate::impact::problem::forces::{ScaledForces, StaticEquilibrium};
use crate::impact::problem::scales::{FORCE_FACTOR, kinetic_energy, speed_at_energy};
use crate::numerics::ode::{
    DampingCoefficients, ErrorScales, IntegrationError, Integrator, Leg, LegEnd, LegProblem, LegResult, MotionState,
};
use crate::numerics::power::nan_max;

/// Integrates an impact at q = v/V from first contact to its end.
pub fn integrate<'a, I: Integrator>(
    ground: impl Into<Surface<'a>>,
    q: f64,
    forces: &ScaledForces,
    integrator: &mut I,
    recorder: &mut TraceRecorder,
) -> Result<ScaledResult, IntegrationError> {
    let ground = ground.into();
    let distance = forces.turning_distance(ground, kinetic_energy(q));
    let (pull, drag) = (FORCE_FACTOR * forces.weight, forces.damping);
    let sizes = ErrorScales { distance, speed: (q * q + pull * distance).sqrt() };
    let mut path = LegProblem {
        piece: ground.piece(0),
        factor: FORCE_FACTOR,
        leg: loading_leg(ground, 0),
        error_scales: sizes,
        constant_acceleration: pull,
        drag,
        rest: None,
    };
    // a sphere may come to rest without turning only under gravity and damping
    let may_creep = pull > 0.0 && drag != DampingCoefficients::NONE;
    let static_point = may_creep.then(|| forces.equilibrium_on_loading(ground));
    let touch = MotionState { time: 0.0, distance: 0.0, speed: q, loss: 0.0 };
    let mut at = initial_state(ground, touch, forces);
    let mut largest = 0.0;
    let mut go = |path: &LegProblem, at: &mut MotionState, piece: Option<usize>, recorder: &mut TraceRecorder| {
        let track = recorder.begin_leg(piece, &touch);
        let LegResult { end: landing, largest_force } = integrator.integrate_leg(path, at, track)?;
        largest = nan_max(largest, largest_force / FORCE_FACTOR);
        Ok(landing)
    };

    let mut piece = 0;
    let is_at_rest = loop {
        (path.piece, path.leg) = (ground.piece(piece), loading_leg(ground, piece));
        if piece == 0 && ground.turns_on_branch(kinetic_energy(q), forces.weight) {
            path.leg = Leg::Loading(f64::INFINITY);
        }
        let rest_of = |point: StaticEquilibrium| {
            let is_here = ground.reloading_path.index_at(point.indentation) == piece;
            let place = point.indentation - path.piece.start + entry_distance(ground, piece);
            forces.rest_criterion(&point, place).filter(|_| is_here)
        };
        path.rest = static_point.and_then(rest_of);
        let landing = go(&path, &mut at, Some(piece), recorder)?;
        if landing != LegEnd::PieceEnd {
            break landing == LegEnd::Rest;
        }
        piece += 1;
        give_way(&mut at, ground.fall_at_start(piece), drag);
        if recorder.is_enabled() && !ground.piece(piece).is_subdivision {
            let is_yield = ground.piece(piece).start == ground.elastic_until();
            recorder.record_event(if is_yield { Event::Yield } else { Event::Knot }, &at);
        }
        at.distance = entry_distance(ground, piece);
    };

    let unloading = ground.unload(piece, at.distance - entry_distance(ground, piece), None);
    recorder.record_event(if is_at_rest { Event::Captured } else { Event::Peak }, &at);
    let loading_time = at.time;
    let branch = unloading.to_piece();
    at.distance = unloading.peak.elastic_approach;
    let mut fate = ImpactEnd::Captured;
    if !is_at_rest {
        at.speed = 0.0;
        path.error_scales =
            ErrorScales { distance: at.distance, speed: speed_at_energy(unloading.recoverable_energy()) };
        path.piece = &branch;
        // a sphere that arrived without speed does not separate
        let is_captured = q == 0.0 || forces.is_conservative() && forces.is_captured(&unloading, q);
        let stops = is_captured && forces.is_conservative();
        let end = if stops { unloading.elastic_approach_at_force(forces.weight) } else { 0.0 };
        let static_point = may_creep.then(|| forces.equilibrium_on_unloading(ground, &unloading));
        path.rest = static_point.and_then(|point| forces.rest_criterion(&point, point.distance));
        let step = ground.force_drop_at_peak(&unloading);
        give_way(&mut at, step, drag);
        let relaxed = at;
        let mut landing = LegEnd::Turning;
        if at.speed > 0.0 {
            path.leg = Leg::Loading(f64::INFINITY);
            landing = go(&path, &mut at, None, recorder)?;
            if step > 0.0 {
                recorder.record_event(Event::Relaxation, &relaxed);
            }
            at.speed = 0.0;
        }
        path.leg = Leg::Unloading(end);
        if landing == LegEnd::Turning {
            landing = go(&path, &mut at, None, recorder)?;
        }
        if step > 0.0 && relaxed.speed == 0.0 {
            recorder.record_event(Event::Relaxation, &relaxed);
        }
        if matches!(landing, LegEnd::PieceEnd | LegEnd::LiftOff) && !is_captured {
            fate = ImpactEnd::Separated;
        }
        recorder.record_event(if fate == ImpactEnd::Separated { Event::Separation } else { Event::Captured }, &at);
    }
    // an excess above 1 is the error of the run
    let limit = if forces.is_lossless(ground, &unloading) { 1.0 } else { f64::INFINITY };
    Ok(ScaledResult {
        restitution: if fate == ImpactEnd::Captured { 0.0 } else { (-at.speed / q).min(limit) },
        loading_time,
        contact_time: at.time,
        end: fate,
        largest_force: ground.reported_force(&unloading, drag.acts_in_contact().then_some(largest)),
        end_indentation: at.distance + ground.deepest_state(&unloading.peak).residual(),
        end_speed: at.speed,
        loss: at.loss / FORCE_FACTOR,
        unloading,
    })
}

/// The first state: first contact. A sphere without speed starts a very small distance further in, where the force of the law is
/// still negligible compared with the weight.
fn initial_state(ground: Surface, touch: MotionState, forces: &ScaledForces) -> MotionState {
    if touch.speed != 0.0 {
        return touch;
    }
    let pull = FORCE_FACTOR * forces.weight;
    let distance = 1e-22 * forces.equilibrium_on_loading(ground).distance;
    let speed = (2.0 * distance * pull).sqrt();
    MotionState { time: speed / pull, distance, speed, loss: 0.0 }
}

/// The speed and the loss after the force drops by `fall`. Only a plate gives way.
fn give_way(at: &mut MotionState, fall: f64, drag: DampingCoefficients) {
    let gained = FORCE_FACTOR * drag.plate * fall;
    if gained != 0.0 {
        at.loss -= gained * (at.speed + 0.5 * gained);
        at.speed += gained;
    }
}

/// The leg along a piece of the loading curve.
#[inline(always)]
fn loading_leg(ground: Surface, index: usize) -> Leg {
    let is_last = index + 1 == ground.reloading_path.pieces().len();
    let end = if is_last { f64::INFINITY } else { ground.piece(index + 1).start - ground.piece(index).start };
    Leg::Loading(end + entry_distance(ground, index))
}

/// The distance of the integrator at the start of a piece.
fn entry_distance(ground: Surface, index: usize) -> f64 {
    ground.piece(index).shape.zero_offset()
}
