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
//! On a plate or rod the momentum of the sphere stays constant when the force drops from f_1 to f_2, as in the relaxation of the metal:
//!
//! ```text
//! p = u + y f   =>   u rises by y (f_1 − f_2)
//! ```
//!
//! So the bodies approach a little further after the relaxation, along the unloading branch. They turn before the branch meets the
//! loading curve, because u + y f can only fall. The peak in the results is the peak before the relaxation.

use super::outcome::{ImpactEnd, ScaledResult};
use super::recorder::{Event, TraceRecorder};
use crate::contact::law::{Surface, Unloading};
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
    recorder: Option<&mut TraceRecorder>,
) -> Result<ScaledResult, IntegrationError> {
    let ground = ground.into();
    let touch = MotionState { time: 0.0, distance: 0.0, speed: q, loss: 0.0 };
    let at = initial_state(ground, touch, forces);
    let mut motion = Motion { ground, q, forces, integrator, recorder, touch, at, largest_force: 0.0 };
    let (piece, landing) = motion.load()?;
    let unloading = ground.unload(piece, motion.at.distance - entry_distance(ground, piece), None);
    let is_at_rest = landing == LegEnd::Rest;
    let turning = motion.at;
    motion.record(if is_at_rest { Event::Captured } else { Event::Peak }, turning);
    motion.at.distance = unloading.peak.elastic_approach;
    let end = if is_at_rest { ImpactEnd::Captured } else { motion.unload(&unloading)? };
    Ok(motion.result(unloading, turning.time, end))
}

/// An impact during its integration.
struct Motion<'a, 'r, I> {
    ground: Surface<'a>,
    q: f64,
    forces: &'r ScaledForces,
    integrator: &'r mut I,
    recorder: Option<&'r mut TraceRecorder>,
    /// First contact.
    touch: MotionState,
    at: MotionState,
    /// The largest contact force so far.
    largest_force: f64,
}

impl<I: Integrator> Motion<'_, '_, I> {
    /// Integrates a leg, on a piece of the loading curve or on the unloading branch.
    fn run_leg(&mut self, problem: &LegProblem, piece: Option<usize>) -> Result<LegEnd, IntegrationError> {
        let track = self.recorder.as_deref_mut().map(|recorder| recorder.begin_leg(piece, &self.touch));
        let LegResult { end, largest_force } = self.integrator.integrate_leg(problem, &mut self.at, track)?;
        self.largest_force = nan_max(self.largest_force, largest_force / FORCE_FACTOR);
        Ok(end)
    }

    fn record(&mut self, event: Event, at: MotionState) {
        if let Some(recorder) = self.recorder.as_deref_mut() {
            recorder.record_event(event, at);
        }
    }

    /// True if the sphere may come to rest without turning, which takes gravity and damping.
    fn may_creep(&self) -> bool {
        self.forces.weight > 0.0 && !self.forces.is_conservative()
    }

    /// The legs along the pieces of the loading curve. Returns the last piece, and how the leg on it ended.
    fn load(&mut self) -> Result<(usize, LegEnd), IntegrationError> {
        let Self { ground, q, forces, .. } = *self;
        let (pull, drag) = (FORCE_FACTOR * forces.weight, forces.damping);
        let (last, distance) = ground.turning_point(kinetic_energy(q), forces.weight);
        let distance = ground.piece(last).start - ground.first_contact() + distance;
        let error_scales = ErrorScales { distance, speed: (q * q + pull * distance).sqrt() };
        let static_point = self.may_creep().then(|| forces.equilibrium_on_loading(ground));
        let mut index = 0;
        loop {
            let piece = ground.piece(index);
            let turns_here = index == 0 && ground.turns_on_branch(kinetic_energy(q), forces.weight);
            let leg = if turns_here { Leg::Loading(f64::INFINITY) } else { loading_leg(ground, index) };
            let rest_of = |point: StaticEquilibrium| {
                let is_here = ground.reloading_path.index_at(point.indentation) == index;
                let place = point.indentation - piece.start + entry_distance(ground, index);
                forces.rest_criterion(&point, place).filter(|_| is_here)
            };
            let rest = static_point.and_then(rest_of);
            let problem =
                LegProblem { piece, factor: FORCE_FACTOR, leg, error_scales, constant_acceleration: pull, drag, rest };
            let landing = self.run_leg(&problem, Some(index))?;
            if landing != LegEnd::PieceEnd {
                return Ok((index, landing));
            }
            index += 1;
            give_way(&mut self.at, ground.fall_at_start(index), drag);
            if !ground.piece(index).is_subdivision {
                let is_yield = ground.piece(index).start == ground.elastic_until();
                self.record(if is_yield { Event::Yield } else { Event::Knot }, self.at);
            }
            self.at.distance = entry_distance(ground, index);
        }
    }

    /// The legs along the unloading branch: a little further in, if the force dropped on a plate or rod, and back. Returns whether the
    /// sphere separates.
    fn unload(&mut self, unloading: &Unloading) -> Result<ImpactEnd, IntegrationError> {
        let Self { ground, q, forces, .. } = *self;
        let (branch, drag) = (unloading.to_piece(), forces.damping);
        self.at.speed = 0.0;
        // a sphere that arrived without speed does not separate
        let is_captured = q == 0.0 || forces.is_conservative() && forces.is_captured(unloading, q);
        let stops = is_captured && forces.is_conservative();
        let end = if stops { unloading.elastic_approach_at_force(forces.weight) } else { 0.0 };
        let static_point = self.may_creep().then(|| forces.equilibrium_on_unloading(ground, unloading));
        let mut problem = LegProblem {
            piece: &branch,
            factor: FORCE_FACTOR,
            leg: Leg::Loading(f64::INFINITY),
            error_scales: ErrorScales {
                distance: self.at.distance,
                speed: speed_at_energy(unloading.recoverable_energy()),
            },
            constant_acceleration: FORCE_FACTOR * forces.weight,
            drag,
            rest: static_point.and_then(|point| forces.rest_criterion(&point, point.distance)),
        };
        let drop = ground.force_drop_at_peak(unloading);
        give_way(&mut self.at, drop, drag);
        let relaxed = self.at;
        let mut landing = LegEnd::Turning;
        if relaxed.speed > 0.0 {
            landing = self.run_leg(&problem, None)?;
            if drop > 0.0 {
                self.record(Event::Relaxation, relaxed);
            }
            self.at.speed = 0.0;
        }
        problem.leg = Leg::Unloading(end);
        if landing == LegEnd::Turning {
            landing = self.run_leg(&problem, None)?;
        }
        if drop > 0.0 && relaxed.speed == 0.0 {
            self.record(Event::Relaxation, relaxed);
        }
        let separates = matches!(landing, LegEnd::PieceEnd | LegEnd::LiftOff) && !is_captured;
        self.record(if separates { Event::Separation } else { Event::Captured }, self.at);
        Ok(if separates { ImpactEnd::Separated } else { ImpactEnd::Captured })
    }

    fn result(&self, unloading: Unloading, loading_time: f64, end: ImpactEnd) -> ScaledResult {
        let Self { ground, q, forces, at, largest_force, .. } = *self;
        // an excess above 1 is the error of the run
        let limit = if forces.is_lossless(ground, &unloading) { 1.0 } else { f64::INFINITY };
        let largest = forces.damping.acts_in_contact().then_some(largest_force);
        ScaledResult {
            restitution: if end == ImpactEnd::Captured { 0.0 } else { (-at.speed / q).min(limit) },
            loading_time,
            contact_time: at.time,
            end,
            largest_force: ground.reported_force(&unloading, largest),
            end_indentation: at.distance + ground.deepest_state(&unloading.peak).residual(),
            end_speed: at.speed,
            loss: at.loss / FORCE_FACTOR,
            unloading,
        }
    }
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

/// The speed and the loss after the force drops by `fall`. Only a plate or rod gives way.
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
