//! The course of one impact, leg by leg: piece after piece up the loading curve, the turning point, and back down the
//! unloading branch.
//!
//! ```text
//! x'' = −(5/4) (f − w) − drag,    drag = (5/4) f χ u  or  2 ζ √((5/4) df/dx) u        (w = m g/Φ, χ in units of 1/V)
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
use super::record::{Along, Event, Recorder};
use super::scaled_forces::{Creep, ScaledForces, equilibrium};
use super::scales::ACCELERATION;
use crate::integrate::{Drag, IntegrationError, Integrator, Landing, Leg, Path, Restoring, Sizes, State};
use crate::law::piece::{Piece, Shape};
use crate::law::{Law, Unloading};

/// Where an impact is.
#[derive(Debug, Clone, Copy)]
enum Phase {
    /// On a piece of the loading curve: as far as a creep to rest would begin, or to the end of the piece.
    Loading { piece: usize, creep: Option<Creep> },
    /// On the way back, as far as the creep to rest would begin, or all of it; or at its end, with its fate. Distances count
    /// from the residual indentation.
    Unloading { unloading: Unloading, loading_time: f64, is_captured: bool, creep: Option<Creep>, fate: Option<Fate> },
}

/// An impact, leg by leg. The integrator carries `at` along `path` and reports how that leg ended.
#[derive(Debug, Clone)]
pub struct Course<'a> {
    law: &'a Law,
    forces: &'a ScaledForces,
    q: f64,
    /// Whether a trace is recorded and has not come to first yield. First yield ends no leg, because a trace must not change
    /// the steps.
    awaits_yield: bool,
    phase: Phase,
    /// The leg to be integrated.
    pub path: Path,
    /// The state at the start of that leg, and then at its end.
    pub at: State,
}

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
    let mut course = Course::begin(law, q, forces, recorder.as_deref_mut());
    course.finish(integrator, recorder)
}

impl<'a> Course<'a> {
    /// At first touch.
    #[inline(always)]
    pub fn begin(law: &'a Law, q: f64, forces: &'a ScaledForces, recorder: Option<&mut Recorder>) -> Self {
        let distance = way_to_peak(law, 0.4 * q * q, forces);
        let pull = ACCELERATION * forces.weight;
        let sizes = Sizes { distance, speed: (q * q + pull * distance).sqrt() };
        let (restoring, leg) = way_out(law, 0);
        let is_reload = law.branch().is_some();
        let yields_at = law.elastic_until();
        let touch = State { time: 0.0, distance: 0.0, speed: q, loss: 0.0 };
        let mut course = Self {
            law,
            forces,
            q,
            awaits_yield: recorder.is_some() && yields_at > 0.0 && yields_at.is_finite() && !is_reload,
            phase: Phase::Loading { piece: 0, creep: None },
            path: Path { restoring, leg, sizes, pull, drag: forces.drag(), rest: None },
            at: touch,
        };
        course.at = course.start();
        if let Some(recorder) = recorder {
            recorder.take(&course.along(0), Some((Event::Touch, &touch)));
        }
        course.set_out(0);
        course
    }

    /// Integrates the rest.
    ///
    /// # Errors
    /// What the integrator reports.
    pub fn finish<I: Integrator>(
        &mut self,
        integrator: &mut I,
        mut recorder: Option<&mut Recorder>,
    ) -> Result<Outcome, IntegrationError> {
        loop {
            let begun = self.at;
            let sampler = recorder.as_deref_mut().map(|recorder| &mut recorder.sampler);
            let landing = integrator.traverse(&self.path, &mut self.at, sampler)?;
            if let Some(recorder) = recorder.as_deref_mut() {
                self.mark_yield(&begun, integrator, recorder)?;
            }
            self.landed(landing, recorder.as_deref_mut());
            if let Some(outcome) = self.outcome() {
                return Ok(outcome);
            }
        }
    }

    /// Tells the recorder of first yield, if the leg since `begun` has passed it. The state there comes from a second run of
    /// the first part of that leg.
    fn mark_yield<I: Integrator>(
        &mut self,
        begun: &State,
        integrator: &mut I,
        recorder: &mut Recorder,
    ) -> Result<(), IntegrationError> {
        let Phase::Loading { piece, .. } = self.phase else { return Ok(()) };
        let distance = self.law.elastic_until() - self.law.loading.pieces()[piece].start + entry_of(self.law, piece);
        if !self.awaits_yield || distance <= begun.distance || self.at.distance <= distance {
            return Ok(());
        }
        self.awaits_yield = false;
        let mut at = *begun;
        integrator.traverse(&Path { leg: Leg::Outward(distance), ..self.path }, &mut at, None)?;
        // where the peak is at first yield to rounding, the second run may turn just before first yield
        let time = at.time.min(self.at.time);
        recorder.mark(Event::Yield, State { time, distance, ..at });
        Ok(())
    }

    /// Goes on after a landing: to the next leg, or to the end.
    pub fn landed(&mut self, landing: Landing, mut recorder: Option<&mut Recorder>) {
        match self.phase {
            Phase::Loading { piece, creep } => {
                if let Some(recorder) = recorder.as_deref_mut() {
                    recorder.take(&self.along(piece), None);
                }
                let is_near_rest = creep.is_some_and(|creep| self.at.speed <= creep.below);
                if landing == Landing::End && !is_near_rest {
                    self.go_on(piece, creep.is_none(), recorder);
                } else {
                    self.turn(piece, landing == Landing::Rest || landing == Landing::End, recorder);
                }
            }
            Phase::Unloading { fate: Some(_), .. } => {}
            Phase::Unloading { ref unloading, is_captured, ref mut creep, ref mut fate, .. } => {
                let is_still = |creep: Creep| -self.at.speed <= creep.below;
                let creeps = landing == Landing::End && creep.is_some_and(is_still);
                if creep.is_some() && landing == Landing::End && !creeps {
                    self.path.leg = Leg::Back(back_to(self.forces, unloading, is_captured));
                    *creep = None;
                    return;
                }
                let (end, event) = match landing {
                    Landing::End | Landing::LiftOff if !is_captured && !creeps => (Fate::Separated, Event::Separation),
                    _ => (Fate::Captured, Event::Captured),
                };
                *fate = Some(end);
                if let Some(recorder) = recorder {
                    recorder.take(&Along::Unloading { unloading, drag: self.path.drag }, Some((event, &self.at)));
                }
            }
        }
    }

    /// Whether the sphere may come to rest without turning. This needs gravity and damping.
    fn may_creep(&self) -> bool {
        self.path.pull > 0.0 && self.path.drag != Drag::NONE
    }

    fn along(&self, piece: usize) -> Along<'a> {
        Along::Loading { law: self.law, index: piece, drag: self.path.drag }
    }

    /// The first state: first touch. A sphere without speed starts a very short way further in, where the force of the law is
    /// still negligible beside the weight.
    fn start(&self) -> State {
        if self.q != 0.0 {
            return self.at;
        }
        let distance = 1e-22 * (equilibrium(self.law, self.forces.weight).0 - self.law.touch());
        let speed = (2.0 * distance * self.path.pull).sqrt();
        State { time: speed / self.path.pull, distance, speed, loss: 0.0 }
    }

    /// Begins a piece of the loading curve: sets the leg along it, and the creep if the sphere may come to rest on it.
    fn set_out(&mut self, index: usize) {
        (self.path.restoring, self.path.leg) = way_out(self.law, index);
        if index == 0 && self.law.stays_on_branch(0.4 * self.q * self.q, self.forces.weight) {
            self.path.leg = Leg::Outward(f64::INFINITY);
        }
        let creep = if self.may_creep() { self.creep_on(index) } else { None };
        self.phase = Phase::Loading { piece: index, creep };
    }

    /// Sets where the sphere may come to rest on a piece of the loading curve. If that lies ahead, the leg ends near it, and
    /// this is the creep there.
    #[cold]
    fn creep_on(&mut self, index: usize) -> Option<Creep> {
        self.path.rest = None;
        let piece = &self.law.loading.pieces()[index];
        let (x, of) = equilibrium(self.law, self.forces.weight);
        let at_rest = (of == index).then_some(x)?;
        let creep = self.forces.creep(at_rest - self.law.touch(), piece.slope_at(at_rest))?;
        let distance = at_rest - (piece.start - piece.shape.lead());
        self.path.rest = Some(creep.rest(distance));
        let near = distance - creep.within;
        if self.at.distance < near && near < self.path.leg.end() {
            self.path.leg = Leg::Outward(near);
            return Some(creep);
        }
        None
    }

    /// Goes on from the end of a leg of the loading curve, which is a knot or the beginning of a creep.
    fn go_on(&mut self, mut piece: usize, is_knot: bool, recorder: Option<&mut Recorder>) {
        let mut event = None;
        if is_knot {
            let is_end_of_branch = piece == 0 && self.law.branch().is_some();
            piece += 1;
            let begins_at_yield = || self.law.loading.pieces()[piece].start == self.law.elastic_until();
            let is_yield = is_end_of_branch || self.awaits_yield && begins_at_yield();
            self.awaits_yield &= !is_yield;
            event = Some(if is_yield { Event::Yield } else { Event::Knot });
            self.at.distance = entry_of(self.law, piece);
        }
        if let (Some(recorder), Some(event)) = (recorder, event) {
            recorder.take(&self.along(piece), Some((event, &self.at)));
        }
        self.set_out(piece);
    }

    /// Begins the way back at the end of compression, unless the sphere has crept up to its static indentation.
    fn turn(&mut self, piece: usize, is_at_rest: bool, recorder: Option<&mut Recorder>) {
        let unloading = self.law.unloading(self.law.state_at(piece, self.at.distance - entry_of(self.law, piece)));
        if let Some(recorder) = recorder {
            let event = if is_at_rest { Event::Captured } else { Event::Peak };
            recorder.take(&self.along(piece), Some((event, &self.at)));
        }
        let loading_time = self.at.time;
        self.at.distance = unloading.peak.elastic_approach;
        if is_at_rest {
            let fate = Some(Fate::Captured);
            self.phase = Phase::Unloading { unloading, loading_time, is_captured: true, creep: None, fate };
            return;
        }
        self.at.speed = 0.0;
        // a sphere that came without speed does not leave
        let is_captured = self.q == 0.0 || self.forces.is_conservative() && self.forces.captures(&unloading, self.q);
        let (mut creep, mut back_to) = (None, back_to(self.forces, &unloading, is_captured));
        if self.may_creep() {
            let at_rest = self.forces.static_approach(&unloading);
            creep = self.forces.creep(at_rest, self.forces.static_slope(&unloading, at_rest));
            self.path.rest = creep.map(|creep| creep.rest(at_rest));
            creep = creep.filter(|creep| at_rest + creep.within < self.at.distance);
            back_to = creep.map_or(back_to, |creep| at_rest + creep.within);
        }
        (self.path.restoring, self.path.leg) = (restoring(&unloading.branch()), Leg::Back(back_to));
        let distance = unloading.peak.elastic_approach;
        self.path.sizes = Sizes { distance, speed: (2.0 * ACCELERATION * unloading.capacity()).sqrt() };
        self.phase = Phase::Unloading { unloading, loading_time, is_captured, creep, fate: None };
    }

    /// Whether it has come to its end.
    pub fn has_ended(&self) -> bool {
        matches!(self.phase, Phase::Unloading { fate: Some(_), .. })
    }

    /// The outcome of an impact that has ended. It is large, so it is made only when it is wanted.
    #[inline(always)]
    pub fn outcome(&self) -> Option<Outcome> {
        let Phase::Unloading { ref unloading, loading_time, fate: Some(fate), .. } = self.phase else { return None };
        let State { time, distance, speed, loss } = self.at;
        Some(Outcome {
            unloading: *unloading,
            restitution: if fate == Fate::Captured { 0.0 } else { -speed / self.q },
            loading_time,
            contact_time: time,
            fate,
            end_indentation: distance + self.law.dent(&unloading.peak).residual(),
            end_speed: speed,
            loss: loss / ACCELERATION,
        })
    }
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
