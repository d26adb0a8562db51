//! The course of one impact: piece after piece up the loading curve, the turning point, and back down the unloading branch.

use super::outcome::Outcome;
use super::scales::ACCELERATION;
use crate::integrate::verlet::{self, Deceleration};
use crate::integrate::{IntegrationError, Integrator, Landing, Leg, Path, Restoring, Sampler, Sizes, State, Work};
use crate::law::curve::{Piece, Shape};
use crate::law::{ElasticApproach, Law, Peak, Unloading};

/// What happens on the way; the kinds in their order of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Event {
    /// First touch.
    Touch,
    /// The half-space begins to yield (x = 1).
    Yield,
    /// The loading curve passes from one piece to the next.
    Knot,
    /// Maximum compression.
    Peak,
    /// The contact force vanishes: at the residual indentation, or before it under viscous damping.
    Separation,
    /// Where the run of a sphere that does not separate ends.
    Captured,
}

/// A point of a trace, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// τ.
    pub time: f64,
    /// x.
    pub indentation: f64,
    /// u.
    pub speed: f64,
    /// f.
    pub force: f64,
    /// ε: the part of x recovered if unloaded from here.
    pub elastic_approach: f64,
    /// Whether compression is over.
    pub is_unloading: bool,
    /// The event, if it is one.
    pub event: Option<Event>,
}

/// Collects a trace: even samples in time and every event.
#[derive(Debug, Clone, Default)]
pub struct Recorder {
    sampler: Sampler,
    /// The points in order of time.
    pub points: Vec<Point>,
}

impl Recorder {
    /// A recorder of `samples` points evenly spaced over `contact_time`, both ends included (they are events).
    #[must_use]
    pub fn new(samples: usize, contact_time: f64) -> Self {
        let inner = samples.saturating_sub(2);
        #[allow(clippy::cast_precision_loss)]
        let interval = contact_time / (inner + 1) as f64;
        Self { sampler: Sampler::every(interval, inner), points: Vec::with_capacity(samples + 16) }
    }

    fn loading(&mut self, law: &Law, piece: &Piece) {
        for state in self.sampler.states.drain(..) {
            self.points.push(loading_point(law, piece, on_curve(piece, state), None));
        }
    }

    fn unloading(&mut self, unloading: &Unloading) {
        for state in self.sampler.states.drain(..) {
            self.points.push(unloading_point(unloading, state, None));
        }
    }
}

/// From the distance along a piece to x.
fn on_curve(piece: &Piece, state: State) -> State {
    State { distance: piece.start + state.distance, ..state }
}

/// `state.distance` is x itself.
fn loading_point(law: &Law, piece: &Piece, state: State, event: Option<Event>) -> Point {
    let indentation = state.distance;
    let force = piece.force_at(indentation);
    let elastic_approach = law.elastic_approach(indentation, force);
    Point { time: state.time, indentation, speed: state.speed, force, elastic_approach, is_unloading: false, event }
}

fn unloading_point(unloading: &Unloading, state: State, event: Option<Event>) -> Point {
    let residual = unloading.peak.residual();
    let force = unloading.stiffness() * crate::power::power(state.distance.max(0.0), unloading.exponent);
    let (time, speed) = (state.time, state.speed);
    Point {
        time,
        indentation: residual + state.distance,
        speed,
        force,
        elastic_approach: state.distance,
        is_unloading: true,
        event,
    }
}

/// The deceleration of the sphere on a piece of the loading curve.
fn restoring(piece: &Piece) -> Restoring {
    match piece.shape {
        Shape::Power { stiffness, exponent } => Restoring::Power { coefficient: ACCELERATION * stiffness, exponent },
        Shape::Straight { slope, .. } => {
            Restoring::Straight { at_start: ACCELERATION * piece.force, slope: ACCELERATION * slope }
        }
    }
}

/// Sizes of the loading: the depth that the work curve gives (it only scales the error) and the impact speed.
pub(super) fn loading_sizes(law: &Law, speed: f64) -> Sizes {
    let pieces = law.loading.pieces();
    let kinetic = 0.4 * speed * speed;
    let deepest = pieces.partition_point(|piece| piece.work <= kinetic).saturating_sub(1);
    Sizes { distance: pieces[deepest].indentation_at_work(kinetic), speed }
}

/// The way along a piece of the loading curve.
pub(super) fn way_out(law: &Law, index: usize, sizes: Sizes) -> Path {
    let pieces = law.loading.pieces();
    let end = pieces.get(index + 1).map_or(f64::INFINITY, |next| next.start) - pieces[index].start;
    Path { restoring: restoring(&pieces[index]), leg: Leg::Outward(end), sizes }
}

/// The unloading branch from where a piece of the loading curve was left.
pub(super) fn unloading_from(law: &Law, piece: &Piece, distance: f64) -> Unloading {
    let indentation = piece.start + distance;
    let force = piece.force_at(indentation);
    law.unloading(Peak { indentation, force, elastic_approach: law.elastic_approach(indentation, force) })
}

/// The way back from rest at the peak to separation.
pub(super) fn way_back(unloading: &Unloading) -> Path {
    let peak = &unloading.peak;
    let stored = peak.force * peak.elastic_approach / (unloading.exponent + 1.0);
    Path {
        restoring: Restoring::Power { coefficient: ACCELERATION * unloading.stiffness(), exponent: unloading.exponent },
        leg: Leg::Back,
        sizes: Sizes { distance: peak.elastic_approach, speed: (2.0 * ACCELERATION * stored).sqrt() },
    }
}

/// Integrates an impact at q = v/V from first touch to separation.
///
/// # Errors
/// What the integrator reports.
pub fn integrate<I: Integrator>(
    law: &Law,
    speed: f64,
    integrator: &mut I,
    mut recorder: Option<&mut Recorder>,
) -> Result<Outcome, IntegrationError> {
    let pieces = law.loading.pieces();
    let sizes = loading_sizes(law, speed);
    let mut state = State { time: 0.0, distance: 0.0, speed };
    let mut index = 0;
    if let Some(recorder) = recorder.as_deref_mut() {
        recorder.points.push(loading_point(law, &pieces[0], on_curve(&pieces[0], state), Some(Event::Touch)));
    }
    // first yield is no kink of the curve, but an event of a trace: there a leg stops too
    let mut stops_at_yield = recorder.is_some() && !matches!(law.elastic, ElasticApproach::All);
    let piece = loop {
        let piece = &pieces[index];
        let mut path = way_out(law, index, sizes);
        let mut event = Event::Knot;
        if let Leg::Outward(end) = path.leg
            && stops_at_yield
            && piece.start + end > 1.0
        {
            path.leg = Leg::Outward(1.0 - piece.start);
            event = Event::Yield;
            stops_at_yield = false;
        }
        let landing = integrator.traverse(&path, &mut state, recorder.as_deref_mut().map(|r| &mut r.sampler))?;
        if let Some(recorder) = recorder.as_deref_mut() {
            recorder.loading(law, piece);
        }
        if landing == Landing::Turning {
            break piece;
        }
        if event == Event::Knot {
            index += 1;
            state.distance = 0.0;
        }
        if let Some(recorder) = recorder.as_deref_mut() {
            let piece = &pieces[index];
            recorder.points.push(loading_point(law, piece, on_curve(piece, state), Some(event)));
        }
    };
    let loading_time = state.time;
    let unloading = unloading_from(law, piece, state.distance);
    if let Some(recorder) = recorder.as_deref_mut() {
        recorder.points.push(loading_point(law, piece, on_curve(piece, state), Some(Event::Peak)));
    }

    let path = way_back(&unloading);
    state = State { time: loading_time, distance: unloading.peak.elastic_approach, speed: 0.0 };
    integrator.traverse(&path, &mut state, recorder.as_deref_mut().map(|r| &mut r.sampler))?;
    if let Some(recorder) = recorder {
        recorder.unloading(&unloading);
        recorder.points.push(unloading_point(&unloading, state, Some(Event::Separation)));
    }
    Ok(Outcome { unloading, restitution: -state.speed / speed, loading_time, contact_time: state.time })
}

/// The law as a code with fixed steps evaluates it: the largest indentation so far is its memory.
struct Remembering<'a> {
    law: &'a Law,
    deepest: f64,
    unloading: Option<Unloading>,
}

impl Deceleration for Remembering<'_> {
    fn at(&mut self, x: f64) -> f64 {
        if x >= self.deepest {
            self.deepest = x;
            return ACCELERATION * self.law.loading.force(x);
        }
        let unloading = self.unloading.get_or_insert_with(|| self.law.unloading(self.law.loaded_to(self.deepest)));
        ACCELERATION * unloading.force(x)
    }
}

/// The same impact by velocity Verlet in steps of `step`, without landing on anything (see [`verlet`]). The peak is the
/// deepest step, separation the first step without force.
///
/// # Errors
/// [`IntegrationError::TooManySteps`] if the sphere does not separate.
pub fn march_verlet(
    law: &Law,
    speed: f64,
    step: f64,
    most_steps: u64,
    work: &mut Work,
    mut recorder: Option<&mut Recorder>,
) -> Result<Outcome, IntegrationError> {
    let mut force = Remembering { law, deepest: 0.0, unloading: None };
    let run =
        verlet::march(&mut force, speed, step, most_steps, work, recorder.as_deref_mut().map(|r| &mut r.sampler))?;
    let unloading = law.unloading(law.loaded_to(run.peak_distance));
    if let Some(recorder) = recorder {
        let touch = State { time: 0.0, distance: 0.0, speed };
        let peak = State { time: run.peak_time, distance: run.peak_distance, speed: 0.0 };
        let events = [(touch, Event::Touch), (peak, Event::Peak), (run.end, Event::Separation)];
        let samples = recorder.sampler.states.drain(..).map(|state| (state, None));
        let mut rows: Vec<_> = samples.chain(events.map(|(state, event)| (state, Some(event)))).collect();
        rows.sort_by(|a, b| a.0.time.total_cmp(&b.0.time));
        recorder.points.extend(rows.into_iter().map(|(state, event)| {
            if state.time <= run.peak_time {
                loading_point(law, &law.loading.pieces()[law.loading.index_at(state.distance)], state, event)
            } else {
                let distance = state.distance - unloading.peak.residual();
                unloading_point(&unloading, State { distance, ..state }, event)
            }
        }));
    }
    let restitution = -run.end.speed / speed;
    Ok(Outcome { unloading, restitution, loading_time: run.peak_time, contact_time: run.end.time })
}
