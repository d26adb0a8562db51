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
//!   overdamped sphere has crept up to its static indentation, to one part in a thousand.

use super::balance;
use super::course::Event;
use super::forces::Damping;
use super::outcome::Outcome;
use super::scales::ACCELERATION;
use crate::integrate::forced::{Drag, ForcedIntegrator, ForcedLanding, ForcedPath, ForcedState, Rest};
use crate::integrate::{IntegrationError, Leg, Sampler, Sizes, State};
use crate::law::curve::Shape;
use crate::law::{ElasticApproach, Law, Peak, Unloading};
use crate::power::power;

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

/// A point of a trace, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForcedPoint {
    /// Time, x and u.
    pub state: State,
    /// Force of the law.
    pub force: f64,
    /// With damping.
    pub total_force: f64,
    /// ε.
    pub elastic_approach: f64,
    /// What damping has taken so far, in units of Φ L.
    pub loss: f64,
    /// Whether compression is over.
    pub is_unloading: bool,
    /// The event, if it is one.
    pub event: Option<Event>,
}

/// Collects a trace: even samples in time and every event.
#[derive(Debug, Clone, Default)]
pub struct ForcedRecorder {
    pub(super) sampler: Sampler,
    /// The points in order of time.
    pub points: Vec<ForcedPoint>,
}

impl ForcedRecorder {
    /// A recorder of `samples` points evenly spaced over `duration`, both ends included (they are events).
    #[must_use]
    pub fn new(samples: usize, duration: f64) -> Self {
        let inner = samples.saturating_sub(2);
        #[allow(clippy::cast_precision_loss)]
        let interval = duration / (inner + 1) as f64;
        Self { sampler: Sampler::every(interval, inner), points: Vec::with_capacity(samples + 16) }
    }

    /// Turns the samples of a leg, and the event at its end, into points.
    fn take(&mut self, leg: &On, event: Option<(Event, &ForcedState)>) {
        let states = std::mem::take(&mut self.sampler.states);
        let losses = std::mem::take(&mut self.sampler.losses);
        let sampled =
            states.iter().zip(&losses).map(|(state, loss)| leg.point(&ForcedState { state: *state, loss: *loss }));
        self.points.extend(sampled);
        self.points.extend(event.map(|(event, at)| ForcedPoint { event: Some(event), ..leg.point(at) }));
    }
}

/// A branch of the law that points lie on.
pub(super) enum On<'a> {
    Piece { law: &'a Law, index: usize, drag: Drag },
    Unloading { unloading: &'a Unloading, drag: Drag },
}

impl On<'_> {
    /// `at.state.distance` is from the zero of a power law, from the start of a straight piece, or from the residual
    /// indentation.
    pub(super) fn point(&self, at: &ForcedState) -> ForcedPoint {
        let State { time, distance, speed } = at.state;
        let (x, force, slope, elastic_approach, drag, is_unloading) = match *self {
            Self::Piece { law, index, drag } => {
                let Peak { indentation, force, elastic_approach } = super::course::loaded(law, index, distance);
                let piece = &law.loading.pieces()[index];
                let slope = piece.slope_beyond(distance - piece.shape.lead());
                (indentation, force, slope, elastic_approach, drag, false)
            }
            Self::Unloading { unloading, drag } => {
                let (k, n, d) = (unloading.stiffness(), unloading.exponent, distance.max(0.0));
                let slope = k * n * power(d, n - 1.0);
                (unloading.peak.residual() + distance, k * power(d, n), slope, distance, drag, true)
            }
        };
        let of_drag = match drag {
            Drag::None => 0.0,
            Drag::OfForce(chi) => force * chi * speed,
            Drag::OfStiffness(eta) => eta * (slope / ACCELERATION).sqrt() * speed,
        };
        let state = State { time, distance: x, speed };
        // where it lifts off the total is zero up to rounding
        let total_force = (force + of_drag).max(0.0);
        let loss = at.loss / ACCELERATION;
        ForcedPoint { state, force, total_force, elastic_approach, loss, is_unloading, event: None }
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
        (self.weight > 0.0 && zeta >= 1.0)
            .then(|| Creep { within, below: (zeta + (zeta * zeta - 1.0).sqrt()) * omega * within })
    }
}

/// What the integrator itself takes for rest.
fn rest(distance: f64, creep: Option<Creep>) -> Option<Rest> {
    creep.map(|creep| {
        let nearer = NEARER / NEAR;
        Rest { distance, within: nearer * creep.within, below: nearer * creep.below }
    })
}

/// x at which the loading curve carries the weight, and its piece.
pub(super) fn equilibrium(law: &Law, weight: f64) -> (f64, usize) {
    let pieces = law.loading.pieces();
    let index = pieces.partition_point(|piece| piece.force <= weight).saturating_sub(1);
    let piece = &pieces[index];
    let distance = match piece.shape {
        Shape::Power { stiffness, exponent } => (weight / stiffness).powf(1.0 / exponent),
        Shape::Straight { slope, .. } => (weight - piece.force) / slope,
        Shape::LatePower { stiffness, exponent, lead } => (weight / stiffness).powf(1.0 / exponent) - lead,
        Shape::Smooth(smooth) => smooth.distance_at_force(piece.start, weight),
    };
    (piece.start + distance, index)
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
    let pieces = law.loading.pieces();
    let (last, distance) = balance::peak(law, 0.4 * q * q, load.weight);
    let deepest = (pieces[last].start - pieces[0].start) + distance;
    let (pull, drag) = (ACCELERATION * load.weight, load.drag());
    let sizes = Sizes { distance: deepest, speed: (q * q + pull * deepest).sqrt() };
    let balanced = (pull > 0.0 && drag != Drag::None).then(|| equilibrium(law, load.weight));
    let mut state = ForcedState { state: State { time: 0.0, distance: 0.0, speed: q }, loss: 0.0 };
    let mut index = 0;
    let on = |index: usize| On::Piece { law, index, drag };
    let touch = law.touch();
    if let Some(recorder) = recorder.as_deref_mut() {
        recorder.take(&on(0), Some((Event::Touch, &state)));
    }
    if q == 0.0 {
        // so little of the way that the force is nothing beside the weight, also under viscous damping: free fall
        let distance = 1e-22 * (equilibrium(law, load.weight).0 - touch);
        state.state = State { time: (2.0 * distance / pull).sqrt(), distance, speed: (2.0 * distance * pull).sqrt() };
    }
    let is_reload = law.branch().is_some();
    let stays_on_branch = law.stays_on_branch(0.4 * q * q, load.weight);
    let mut stops_at_yield = recorder.is_some() && !matches!(law.elastic, ElasticApproach::All) && !is_reload;
    let is_at_rest = loop {
        let piece = &pieces[index];
        let mut path = super::course::way_out(law, index, sizes);
        if stays_on_branch {
            path.leg = Leg::Outward(f64::INFINITY);
        }
        let mut event = Some(Event::Knot);
        if let Leg::Outward(end) = path.leg
            && stops_at_yield
            && piece.start + end > 1.0
        {
            path.leg = Leg::Outward(1.0 - piece.start);
            event = Some(Event::Yield);
            stops_at_yield = false;
        }
        let creep = balanced.filter(|(_, of)| *of == index).and_then(|(x, _)| {
            let distance = x - piece.start + piece.shape.lead();
            load.creep(x - touch, piece.slope_at(x)).map(|creep| (distance, creep))
        });
        if let (Leg::Outward(end), Some((distance, creep))) = (path.leg, creep)
            && (state.state.distance..end).contains(&(distance - creep.within))
            && state.state.distance < distance - creep.within
        {
            path.leg = Leg::Outward(distance - creep.within);
            if event == Some(Event::Yield) {
                stops_at_yield = true;
            }
            event = None;
        }
        let rest = creep.and_then(|(distance, creep)| rest(distance, Some(creep)));
        let path = ForcedPath { path, pull, drag, back_to: 0.0, rest };
        let landing = integrator.traverse(&path, &mut state, recorder.as_deref_mut().map(|r| &mut r.sampler))?;
        if let Some(recorder) = recorder.as_deref_mut() {
            recorder.take(&on(index), None);
        }
        if landing != ForcedLanding::End {
            break landing == ForcedLanding::Rest;
        }
        if event.is_none() && creep.is_some_and(|(_, creep)| state.state.speed <= creep.below) {
            break true;
        }
        if event == Some(Event::Knot) {
            if is_reload && index == 0 {
                event = Some(Event::Yield);
            }
            index += 1;
            state.state.distance = super::course::entry_of(law, index);
        }
        if let (Some(recorder), Some(event)) = (recorder.as_deref_mut(), event) {
            recorder.take(&on(index), Some((event, &state)));
        }
    };
    let loading_time = state.state.time;
    let unloading = super::course::unloading_from(law, index, state.state.distance);
    let last = if is_at_rest { Event::Captured } else { Event::Peak };
    if let Some(recorder) = recorder.as_deref_mut() {
        recorder.take(&on(index), Some((last, &state)));
    }
    let residual = law.dent(&unloading.peak).residual();
    let outcome = |state: &ForcedState, fate| ForcedOutcome {
        unloading,
        restitution: if fate == Fate::Captured { 0.0 } else { -state.state.speed / q },
        loading_time,
        end: state.state,
        fate,
        loss: state.loss / ACCELERATION,
    };
    if is_at_rest {
        state.state.distance = unloading.peak.indentation;
        return Ok(outcome(&state, Fate::Captured));
    }

    let is_captured = load.is_conservative() && load.captures(&unloading, q);
    let at_rest = load.static_approach(&unloading);
    let mut path = super::course::way_back(&unloading);
    path.sizes.speed = path.sizes.speed.max(sizes.speed * f64::EPSILON);
    let creep = load.creep(at_rest, unloading.exponent * load.weight / at_rest);
    let mut path = ForcedPath { path, pull, drag, back_to: 0.0, rest: rest(at_rest, creep) };
    state.state = State { time: loading_time, distance: unloading.peak.elastic_approach, speed: 0.0 };
    let mut traverse = |path: &ForcedPath, state: &mut ForcedState| {
        integrator.traverse(path, state, recorder.as_deref_mut().map(|r| &mut r.sampler))
    };
    if is_captured {
        path.back_to = at_rest;
    }
    let mut landing = ForcedLanding::End;
    let mut creeps = false;
    if let Some(creep) = creep.filter(|creep| at_rest + creep.within < state.state.distance) {
        let near = ForcedPath { back_to: at_rest + creep.within, ..path };
        landing = traverse(&near, &mut state)?;
        creeps = landing == ForcedLanding::End && -state.state.speed <= creep.below;
    }
    if landing == ForcedLanding::End && !creeps {
        landing = traverse(&path, &mut state)?;
    }
    let fate = match landing {
        ForcedLanding::End | ForcedLanding::LiftOff if !is_captured && !creeps => Fate::Separated,
        _ => Fate::Captured,
    };
    if let Some(recorder) = recorder {
        let event = if fate == Fate::Captured { Event::Captured } else { Event::Separation };
        recorder.take(&On::Unloading { unloading: &unloading, drag }, Some((event, &state)));
    }
    state.state.distance += residual;
    Ok(outcome(&state, fate))
}
