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
use super::forces::Damping;
use super::outcome::Outcome;
use super::scales::ACCELERATION;
use crate::integrate::forced::{Drag, ForcedIntegrator, ForcedLanding, ForcedPath, ForcedState, Rest};
use crate::integrate::{IntegrationError, Leg, Sizes, State};
use crate::law::{ElasticApproach, Law, Unloading};

/// Gravity and damping in the units of an impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// w = m g/Φ; 0 without gravity.
    pub weight: f64,
    /// χ in units of 1/V, or ζ.
    pub damping: Option<Damping>,
}

impl Load {
    /// Whether nothing takes energy but the dent.
    #[must_use]
    pub fn is_conservative(&self) -> bool {
        matches!(self.damping, None | Some(Damping::HuntCrossley(0.0) | Damping::Viscous(0.0)))
    }

    /// Without damping: whether a sphere that came at q = v/V stays in its dent.
    #[must_use]
    pub fn captures(&self, unloading: &Unloading, q: f64) -> bool {
        let has_dent = unloading.peak.residual() > 0.0;
        self.weight > 0.0 && (q == 0.0 || has_dent && unloading.peak.force <= (unloading.exponent + 1.0) * self.weight)
    }

    /// Elastic approach at which the unloading branch carries the weight; at most that of the peak.
    #[must_use]
    pub fn static_approach(&self, unloading: &Unloading) -> f64 {
        let peak = &unloading.peak;
        peak.elastic_approach * (self.weight / peak.force).min(1.0).powf(1.0 / unloading.exponent)
    }

    /// x at which the contact carries the weight: on the unloading branch, or on the loading curve where the sphere has
    /// not yet come so far.
    #[must_use]
    pub fn static_indentation(&self, law: &Law, unloading: &Unloading) -> f64 {
        if unloading.peak.force < self.weight {
            equilibrium(law, self.weight).0
        } else {
            law.dent(&unloading.peak).residual() + self.static_approach(unloading)
        }
    }

    pub(super) fn drag(&self) -> Drag {
        match self.damping {
            None | Some(Damping::HuntCrossley(0.0) | Damping::Viscous(0.0)) => Drag::None,
            Some(Damping::HuntCrossley(chi)) => Drag::OfForce(chi),
            Some(Damping::Viscous(zeta)) => Drag::OfStiffness(2.0 * zeta),
        }
    }
}

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

/// How near to its static indentation an overdamped sphere counts as captured there.
const NEAR: f64 = 1e-3;
/// How near a sphere is that the linear theory of the creep has missed: rounding ends its run.
const NEARER: f64 = 1e-7;

/// Creep to a static indentation: overdamped, a sphere comes near it and never passes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Creep {
    /// How far from the static indentation the run ends,
    pub(super) within: f64,
    /// at speeds up to this: less than the fast one of the two rates of decay times that distance.
    pub(super) below: f64,
}

impl Load {
    /// The creep to a static point at `distance` from where its branch begins, of tangent stiffness `slope`; `None` where
    /// the sphere swings through it.
    pub(super) fn creep(&self, distance: f64, slope: f64) -> Option<Creep> {
        let omega = (ACCELERATION * slope).sqrt();
        let zeta = match self.damping? {
            Damping::HuntCrossley(chi) => 0.5 * ACCELERATION * self.weight * chi / omega,
            Damping::Viscous(zeta) => zeta,
        };
        let within = NEAR * distance;
        // next to critical a swing is e^(−πζ/√(1−ζ²)) of the one before: too small to be seen
        let fast = zeta + (zeta * zeta - 1.0).max(0.0).sqrt();
        (self.weight > 0.0 && zeta >= 0.9).then_some(Creep { within, below: fast * omega * within })
    }
}

impl Creep {
    /// What the integrator itself takes for rest.
    fn rest(self, distance: f64) -> Rest {
        let nearer = NEARER / NEAR;
        Rest { distance, within: nearer * self.within, below: nearer * self.below }
    }
}

/// x at which the loading curve carries the weight, and its piece.
pub(super) fn equilibrium(law: &Law, weight: f64) -> (f64, usize) {
    let pieces = law.loading.pieces();
    let index = pieces.partition_point(|piece| piece.force <= weight).saturating_sub(1);
    let piece = &pieces[index];
    (piece.indentation_at_force(weight), index)
}

/// What stays the same along an impact.
struct Course<'a> {
    law: &'a Law,
    load: &'a Load,
    q: f64,
    pull: f64,
    drag: Drag,
    sizes: Sizes,
}

/// Where compression ended.
struct Deepest {
    piece: usize,
    /// Distance as the integrator counts it.
    at: ForcedState,
    /// Whether it will never be over: the sphere has crept up to its static indentation.
    is_at_rest: bool,
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
    let distance = balance::way_to_peak(law, 0.4 * q * q, load.weight);
    let pull = ACCELERATION * load.weight;
    let sizes = Sizes { distance, speed: (q * q + pull * distance).sqrt() };
    let course = Course { law, load, q, pull, drag: load.drag(), sizes };
    let deepest = course.compress(integrator, recorder.as_deref_mut())?;
    let Deepest { piece, at, is_at_rest } = deepest;
    let unloading = unloading_from(law, piece, at.state.distance);
    if let Some(recorder) = recorder.as_deref_mut() {
        let event = if is_at_rest { Event::Captured } else { Event::Peak };
        recorder.take(&course.on(piece), Some((event, &at)));
    }
    let (mut end, fate) = if is_at_rest {
        (ForcedState { state: State { distance: unloading.peak.elastic_approach, ..at.state }, ..at }, Fate::Captured)
    } else {
        course.go_back(&unloading, &at, integrator, recorder)?
    };
    end.state.distance += law.dent(&unloading.peak).residual();
    Ok(ForcedOutcome {
        unloading,
        restitution: if fate == Fate::Captured { 0.0 } else { -end.state.speed / q },
        loading_time: at.state.time,
        end: end.state,
        fate,
        loss: end.loss / ACCELERATION,
    })
}

impl Course<'_> {
    fn on(&self, piece: usize) -> On<'_> {
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
            stops_at_yield &= piece.start + end > 1.0;
            if stops_at_yield {
                (end, event, rests) = (1.0 - piece.start, Some(Event::Yield), None);
            }
            path.leg = Leg::Outward(end);
        }
        let rest = creep.map(|(distance, creep)| creep.rest(distance));
        (ForcedPath { path, pull: self.pull, drag: self.drag, back_to: 0.0, rest }, event, rests)
    }

    fn compress<I: ForcedIntegrator>(
        &self,
        integrator: &mut I,
        mut recorder: Option<&mut ForcedRecorder>,
    ) -> Result<Deepest, IntegrationError> {
        let touch = ForcedState { state: State { time: 0.0, distance: 0.0, speed: self.q }, loss: 0.0 };
        let mut at = ForcedState { state: self.start(), loss: 0.0 };
        let mut piece = 0;
        if let Some(recorder) = recorder.as_deref_mut() {
            recorder.take(&self.on(0), Some((Event::Touch, &touch)));
        }
        let is_reload = self.law.branch().is_some();
        let is_elastic = matches!(self.law.elastic, ElasticApproach::All);
        let mut stops_at_yield = recorder.is_some() && !is_elastic && !is_reload;
        loop {
            let (path, mut event, creep) = self.leg(piece, &at.state, stops_at_yield);
            let landing = integrator.traverse(&path, &mut at, recorder.as_deref_mut().map(|r| &mut r.sampler))?;
            if let Some(recorder) = recorder.as_deref_mut() {
                recorder.take(&self.on(piece), None);
            }
            let is_near_rest = creep.is_some_and(|creep| at.state.speed <= creep.below);
            if landing != ForcedLanding::End || is_near_rest {
                let is_at_rest = landing == ForcedLanding::Rest || landing == ForcedLanding::End;
                return Ok(Deepest { piece, at, is_at_rest });
            }
            if event == Some(Event::Knot) {
                if is_reload && piece == 0 {
                    event = Some(Event::Yield);
                }
                piece += 1;
                at.state.distance = entry_of(self.law, piece);
            }
            stops_at_yield &= event != Some(Event::Yield);
            if let (Some(recorder), Some(event)) = (recorder.as_deref_mut(), event) {
                recorder.take(&self.on(piece), Some((event, &at)));
            }
        }
    }

    /// From rest at the peak to the end; the distance of the end is from the residual indentation.
    fn go_back<I: ForcedIntegrator>(
        &self,
        unloading: &Unloading,
        deepest: &ForcedState,
        integrator: &mut I,
        mut recorder: Option<&mut ForcedRecorder>,
    ) -> Result<(ForcedState, Fate), IntegrationError> {
        // a sphere that had no speed has none to leave with
        let is_captured = self.q == 0.0 || self.load.is_conservative() && self.load.captures(unloading, self.q);
        let at_rest = self.load.static_approach(unloading);
        let creep = self.load.creep(at_rest, unloading.exponent * self.load.weight / at_rest);
        let back_to = if is_captured && self.load.is_conservative() { at_rest } else { 0.0 };
        let rest = creep.map(|creep| creep.rest(at_rest));
        let path = ForcedPath { path: way_back(unloading), pull: self.pull, drag: self.drag, back_to, rest };
        let state = State { distance: unloading.peak.elastic_approach, speed: 0.0, ..deepest.state };
        let mut at = ForcedState { state, ..*deepest };
        let mut traverse = |path: &ForcedPath, at: &mut ForcedState| {
            integrator.traverse(path, at, recorder.as_deref_mut().map(|r| &mut r.sampler))
        };
        let mut landing = ForcedLanding::End;
        let mut creeps = false;
        if let Some(creep) = creep.filter(|creep| at_rest + creep.within < at.state.distance) {
            landing = traverse(&ForcedPath { back_to: at_rest + creep.within, ..path }, &mut at)?;
            creeps = landing == ForcedLanding::End && -at.state.speed <= creep.below;
        }
        if landing == ForcedLanding::End && !creeps {
            landing = traverse(&path, &mut at)?;
        }
        let fate = match landing {
            ForcedLanding::End | ForcedLanding::LiftOff if !is_captured && !creeps => Fate::Separated,
            _ => Fate::Captured,
        };
        if let Some(recorder) = recorder {
            let event = if fate == Fate::Captured { Event::Captured } else { Event::Separation };
            recorder.take(&On::Unloading { unloading, drag: self.drag }, Some((event, &at)));
        }
        Ok((at, fate))
    }
}
