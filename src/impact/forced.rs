//! The course of an impact under gravity and damping: like [`super::course`], with more ways to end.
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

use super::balance;
use super::course::{Event, entry_of, unloading_from, way_back, way_out};
use super::forced_trace::{ForcedRecorder, On};
use super::outcome::Outcome;
use super::scales::ACCELERATION;
use crate::integrate::forced::{Drag, ForcedIntegrator, ForcedLanding, ForcedPath, ForcedState};
use crate::integrate::{IntegrationError, Leg, Sizes, State};
use crate::law::{Law, Unloading};
pub use load::Load;
pub(super) use load::{Creep, equilibrium};

mod load;

/// How a contact ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    /// The total contact force vanished.
    Separated,
    /// It never does.
    Captured,
}

impl Fate {
    /// `separated` or `captured`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Separated => "separated",
            Self::Captured => "captured",
        }
    }
}

/// What an impact under forces comes to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForcedOutcome {
    /// Peak state and exponent.
    pub unloading: Unloading,
    /// e; 0 for a captured sphere.
    pub restitution: f64,
    /// Time to the peak.
    pub loading_time: f64,
    /// Time, x and u at separation, or where the run of a captured sphere ends.
    pub end: State,
    /// How it ended.
    pub fate: Fate,
    /// Energy that damping has taken until then, in units of Φ L.
    pub loss: f64,
}

impl ForcedOutcome {
    /// The part that an impact without forces has too; the contact time is that of the run.
    #[must_use]
    pub fn outcome(&self) -> Outcome {
        let Self { unloading, restitution, loading_time, end, .. } = *self;
        Outcome { unloading, restitution, loading_time, contact_time: end.time }
    }
}

/// Where an impact is.
#[derive(Debug, Clone, Copy)]
enum Phase {
    /// On a piece of the loading curve; what is at the end of the leg, and the creep to rest if it ends near that.
    Loading { piece: usize, event: Option<Event>, creep: Option<Creep> },
    /// On the way back, as far as the creep to rest would begin, or all of it.
    Unloading { unloading: Unloading, loading_time: f64, is_captured: bool, creep: Option<Creep> },
}

/// An impact on its way, leg by leg: whoever integrates it carries `at` along `path` and says where that has landed.
#[derive(Debug, Clone)]
pub struct Course<'a> {
    law: &'a Law,
    load: Load,
    q: f64,
    pull: f64,
    drag: Drag,
    sizes: Sizes,
    stops_at_yield: bool,
    phase: Phase,
    path: ForcedPath,
    /// The state at the start of that leg, and then at its end.
    pub at: ForcedState,
}

/// Integrates an impact at q = v/V from first touch to its end.
///
/// # Errors
/// What the integrator reports.
pub fn integrate<I: ForcedIntegrator>(
    law: &Law,
    q: f64,
    load: &Load,
    integrator: &mut I,
    mut recorder: Option<&mut ForcedRecorder>,
) -> Result<ForcedOutcome, IntegrationError> {
    let mut course = Course::begin(law, q, load, recorder.as_deref_mut());
    course.finish(integrator, recorder)
}

impl<'a> Course<'a> {
    /// At first touch; with a recorder, legs end at first yield too.
    #[must_use]
    pub fn begin(law: &'a Law, q: f64, load: &Load, recorder: Option<&mut ForcedRecorder>) -> Self {
        let distance = balance::way_to_peak(law, 0.4 * q * q, load.weight);
        let pull = ACCELERATION * load.weight;
        let sizes = Sizes { distance, speed: (q * q + pull * distance).sqrt() };
        let is_reload = law.branch().is_some();
        let touch = ForcedState { state: State { time: 0.0, distance: 0.0, speed: q }, loss: 0.0 };
        let drag = load.drag();
        let mut course = Self {
            law,
            load: *load,
            q,
            pull,
            drag,
            sizes,
            stops_at_yield: recorder.is_some() && law.elastic_until() > 0.0 && !is_reload,
            phase: Phase::Loading { piece: 0, event: None, creep: None },
            path: ForcedPath { path: way_out(law, 0, sizes), pull, drag, back_to: 0.0, rest: None },
            at: touch,
        };
        course.at.state = course.start();
        if let Some(recorder) = recorder {
            recorder.take(&course.on(0), Some((Event::Touch, &touch)));
        }
        course.set_out(0);
        course
    }

    /// The leg to be integrated.
    #[must_use]
    pub fn path(&self) -> &ForcedPath {
        &self.path
    }

    /// What resists the motion.
    #[must_use]
    pub fn drag(&self) -> Drag {
        self.drag
    }

    /// Integrates the rest.
    ///
    /// # Errors
    /// What the integrator reports.
    pub fn finish<I: ForcedIntegrator>(
        &mut self,
        integrator: &mut I,
        mut recorder: Option<&mut ForcedRecorder>,
    ) -> Result<ForcedOutcome, IntegrationError> {
        loop {
            let sampler = recorder.as_deref_mut().map(|recorder| &mut recorder.sampler);
            let landing = integrator.traverse(&self.path, &mut self.at, sampler)?;
            if let Some(outcome) = self.landed(landing, recorder.as_deref_mut()) {
                return Ok(outcome);
            }
        }
    }

    /// Goes on where a leg has landed: to the next leg, or to the end.
    pub fn landed(
        &mut self,
        landing: ForcedLanding,
        mut recorder: Option<&mut ForcedRecorder>,
    ) -> Option<ForcedOutcome> {
        match self.phase {
            Phase::Loading { piece, event, creep } => {
                if let Some(recorder) = recorder.as_deref_mut() {
                    recorder.take(&self.on(piece), None);
                }
                let is_near_rest = creep.is_some_and(|creep| self.at.state.speed <= creep.below);
                if landing == ForcedLanding::End && !is_near_rest {
                    self.go_on(piece, event, recorder);
                    return None;
                }
                let is_at_rest = landing == ForcedLanding::Rest || landing == ForcedLanding::End;
                self.turn(piece, is_at_rest, recorder)
            }
            Phase::Unloading { unloading, loading_time, is_captured, creep } => {
                let is_still = |creep: Creep| -self.at.state.speed <= creep.below;
                let creeps = landing == ForcedLanding::End && creep.is_some_and(is_still);
                if creep.is_some() && landing == ForcedLanding::End && !creeps {
                    self.path.back_to = self.back_to(&unloading, is_captured);
                    self.phase = Phase::Unloading { unloading, loading_time, is_captured, creep: None };
                    return None;
                }
                let fate = match landing {
                    ForcedLanding::End | ForcedLanding::LiftOff if !is_captured && !creeps => Fate::Separated,
                    _ => Fate::Captured,
                };
                if let Some(recorder) = recorder {
                    let event = if fate == Fate::Captured { Event::Captured } else { Event::Separation };
                    recorder.take(&On::Unloading { unloading: &unloading, drag: self.drag }, Some((event, &self.at)));
                }
                Some(self.outcome(unloading, loading_time, fate))
            }
        }
    }

    fn on(&self, piece: usize) -> On<'a> {
        On::Piece { law: self.law, index: piece, drag: self.drag }
    }

    /// The first state: at first touch, or after so little of a fall from rest that the force is nothing beside the weight.
    fn start(&self) -> State {
        if self.q > 0.0 {
            return State { time: 0.0, distance: 0.0, speed: self.q };
        }
        let distance = 1e-22 * (equilibrium(self.law, self.load.weight).0 - self.law.touch());
        let speed = (2.0 * distance * self.pull).sqrt();
        State { time: speed / self.pull, distance, speed }
    }

    /// The leg along a piece from `state` on, what is at its end, and the creep to rest if it ends near that.
    fn leg(&self, index: usize, state: &State, mut stops_at_yield: bool) -> (ForcedPath, Option<Event>, Option<Creep>) {
        let piece = &self.law.loading.pieces()[index];
        let zero = piece.start - piece.shape.lead();
        let mut path = way_out(self.law, index, self.sizes);
        if self.law.stays_on_branch(0.4 * self.q * self.q, self.load.weight) {
            path.leg = Leg::Outward(f64::INFINITY);
        }
        let mut event = Some(Event::Knot);
        let creep = (self.pull > 0.0 && self.drag != Drag::None)
            .then(|| equilibrium(self.law, self.load.weight))
            .filter(|(_, of)| *of == index)
            .and_then(|(x, _)| Some((x - zero, self.load.creep(x - self.law.touch(), piece.slope_at(x))?)));
        let mut rests = None;
        if let Leg::Outward(mut end) = path.leg {
            if let Some((distance, creep)) = creep
                && (state.distance..end).contains(&(distance - creep.within))
                && state.distance < distance - creep.within
            {
                (end, event, rests) = (distance - creep.within, None, Some(creep));
            }
            let elastic_until = self.law.elastic_until();
            stops_at_yield &= piece.start + end > elastic_until;
            if stops_at_yield {
                (end, event, rests) = (elastic_until - piece.start, Some(Event::Yield), None);
            }
            path.leg = Leg::Outward(end);
        }
        let rest = creep.map(|(distance, creep)| creep.rest(distance));
        (ForcedPath { path, pull: self.pull, drag: self.drag, back_to: 0.0, rest }, event, rests)
    }

    /// Onto a piece of the loading curve.
    fn set_out(&mut self, piece: usize) {
        let (path, event, creep) = self.leg(piece, &self.at.state, self.stops_at_yield);
        self.path = path;
        self.phase = Phase::Loading { piece, event, creep };
    }

    /// On from the end of a leg of the loading curve.
    fn go_on(&mut self, mut piece: usize, mut event: Option<Event>, recorder: Option<&mut ForcedRecorder>) {
        if event == Some(Event::Knot) {
            if piece == 0 && self.law.branch().is_some() {
                event = Some(Event::Yield);
            }
            piece += 1;
            self.at.state.distance = entry_of(self.law, piece);
            // a law may yield at a knot
            if self.stops_at_yield && self.law.loading.pieces()[piece].start == self.law.elastic_until() {
                event = Some(Event::Yield);
            }
        }
        self.stops_at_yield &= event != Some(Event::Yield);
        if let (Some(recorder), Some(event)) = (recorder, event) {
            recorder.take(&self.on(piece), Some((event, &self.at)));
        }
        self.set_out(piece);
    }

    /// Compression has ended: onto the way back, unless the sphere has crept up to its static indentation.
    fn turn(&mut self, piece: usize, is_at_rest: bool, recorder: Option<&mut ForcedRecorder>) -> Option<ForcedOutcome> {
        let unloading = unloading_from(self.law, piece, self.at.state.distance);
        if let Some(recorder) = recorder {
            let event = if is_at_rest { Event::Captured } else { Event::Peak };
            recorder.take(&self.on(piece), Some((event, &self.at)));
        }
        let loading_time = self.at.state.time;
        self.at.state.distance = unloading.peak.elastic_approach;
        if is_at_rest {
            return Some(self.outcome(unloading, loading_time, Fate::Captured));
        }
        self.at.state.speed = 0.0;
        // a sphere that had no speed has none to leave with
        let is_captured = self.q == 0.0 || self.load.is_conservative() && self.load.captures(&unloading, self.q);
        let at_rest = self.load.static_approach(&unloading);
        let creep = self.load.creep(at_rest, unloading.exponent * self.load.weight / at_rest);
        let rest = creep.map(|creep| creep.rest(at_rest));
        let creep = creep.filter(|creep| at_rest + creep.within < self.at.state.distance);
        let back_to = creep.map_or_else(|| self.back_to(&unloading, is_captured), |creep| at_rest + creep.within);
        self.path = ForcedPath { path: way_back(&unloading), pull: self.pull, drag: self.drag, back_to, rest };
        self.phase = Phase::Unloading { unloading, loading_time, is_captured, creep };
        None
    }

    /// Where the way back ends, if nothing ends it before.
    fn back_to(&self, unloading: &Unloading, is_captured: bool) -> f64 {
        if is_captured && self.load.is_conservative() { self.load.static_approach(unloading) } else { 0.0 }
    }

    /// The outcome of a run that ends here; distances have been from the residual indentation.
    fn outcome(&self, unloading: Unloading, loading_time: f64, fate: Fate) -> ForcedOutcome {
        let mut end = self.at;
        end.state.distance += self.law.dent(&unloading.peak).residual();
        ForcedOutcome {
            unloading,
            restitution: if fate == Fate::Captured { 0.0 } else { -end.state.speed / self.q },
            loading_time,
            end: end.state,
            fate,
            loss: end.loss / ACCELERATION,
        }
    }
}
