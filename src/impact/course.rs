//! The course of one impact: piece after piece up the loading curve, the turning point, and back down the unloading branch.

use super::outcome::Outcome;
use super::scales::ACCELERATION;
use crate::integrate::verlet::{self, Deceleration};
use crate::integrate::{IntegrationError, Integrator, Landing, Leg, Path, Restoring, Sampler, Sizes, State, Work};
use crate::law::curve::{Piece, Shape};
use crate::law::{Law, Peak, Unloading};

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

    fn loading(&mut self, law: &Law, index: usize) {
        for state in self.sampler.states.drain(..) {
            self.points.push(loading_point(law, index, state, None));
        }
    }

    fn unloading(&mut self, unloading: &Unloading) {
        for state in self.sampler.states.drain(..) {
            self.points.push(unloading_point(unloading, state, None));
        }
    }
}

/// The state at a distance of the integrator, which counts from the zero of the force on a power law.
pub(super) fn loaded(law: &Law, index: usize, distance: f64) -> Peak {
    law.state_at(index, distance - law.loading.pieces()[index].shape.lead())
}

fn loading_point(law: &Law, index: usize, state: State, event: Option<Event>) -> Point {
    point(loaded(law, index, state.distance), state, event)
}

fn point(loaded: Peak, state: State, event: Option<Event>) -> Point {
    let Peak { indentation, force, elastic_approach } = loaded;
    Point { time: state.time, indentation, speed: state.speed, force, elastic_approach, is_unloading: false, event }
}

fn unloading_point(unloading: &Unloading, state: State, event: Option<Event>) -> Point {
    let residual = unloading.peak.residual();
    let force = unloading.force_after(state.distance.max(0.0));
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
        Shape::Power { stiffness, exponent } | Shape::LatePower { stiffness, exponent, .. } => {
            Restoring::Power { coefficient: ACCELERATION * stiffness, exponent }
        }
        Shape::Straight { slope, .. } => {
            Restoring::Straight { at_start: ACCELERATION * piece.force, slope: ACCELERATION * slope }
        }
        Shape::Smooth(force) => Restoring::Smooth { force, start: piece.start, factor: ACCELERATION },
    }
}

/// Sizes of the loading: the depth that the work curve gives (it only scales the error) and the impact speed.
pub(super) fn loading_sizes(law: &Law, speed: f64) -> Sizes {
    let pieces = law.loading.pieces();
    let kinetic = 0.4 * speed * speed;
    let deepest = &pieces[law.turning_piece(kinetic)];
    Sizes { distance: (deepest.start - pieces[0].start) + deepest.distance_at_work(kinetic), speed }
}

/// The way along a piece of the loading curve.
pub(super) fn way_out(law: &Law, index: usize, sizes: Sizes) -> Path {
    let pieces = law.loading.pieces();
    let end = pieces.get(index + 1).map_or(f64::INFINITY, |next| next.start) - pieces[index].start;
    let end = end + pieces[index].shape.lead();
    Path { restoring: restoring(&pieces[index]), leg: Leg::Outward(end), sizes }
}

/// The unloading branch from where a piece of the loading curve was left.
pub(super) fn unloading_from(law: &Law, index: usize, distance: f64) -> Unloading {
    law.unloading(loaded(law, index, distance))
}

/// The distance of the integrator at the start of a piece.
pub(super) fn entry_of(law: &Law, index: usize) -> f64 {
    law.loading.pieces()[index].shape.lead()
}

/// The way back from rest at the peak to separation.
pub(super) fn way_back(unloading: &Unloading) -> Path {
    let peak = &unloading.peak;
    let stored = unloading.capacity();
    Path {
        restoring: restoring(&unloading.branch()),
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
        recorder.points.push(loading_point(law, 0, state, Some(Event::Touch)));
    }
    // first yield is no kink of the curve, but an event of a trace: there a leg stops too; a reload yields at the knot
    let is_reload = law.branch().is_some();
    let stays_on_branch = law.stays_on_branch(0.4 * speed * speed, 0.0);
    let elastic_until = law.elastic_until();
    let mut stops_at_yield = recorder.is_some() && elastic_until > 0.0 && !is_reload;
    loop {
        let piece = &pieces[index];
        let mut path = way_out(law, index, sizes);
        if stays_on_branch {
            path.leg = Leg::Outward(f64::INFINITY);
        }
        let mut event = Event::Knot;
        if let Leg::Outward(end) = path.leg
            && stops_at_yield
            && piece.start + end > elastic_until
        {
            path.leg = Leg::Outward(elastic_until - piece.start);
            event = Event::Yield;
            stops_at_yield = false;
        }
        let landing = integrator.traverse(&path, &mut state, recorder.as_deref_mut().map(|r| &mut r.sampler))?;
        if let Some(recorder) = recorder.as_deref_mut() {
            recorder.loading(law, index);
        }
        if landing == Landing::Turning {
            break;
        }
        if event == Event::Knot {
            if is_reload && index == 0 {
                event = Event::Yield;
            }
            index += 1;
            state.distance = entry_of(law, index);
            if stops_at_yield && pieces[index].start == elastic_until {
                event = Event::Yield;
                stops_at_yield = false;
            }
        }
        if let Some(recorder) = recorder.as_deref_mut() {
            recorder.points.push(loading_point(law, index, state, Some(event)));
        }
    }
    let loading_time = state.time;
    let unloading = unloading_from(law, index, state.distance);
    if let Some(recorder) = recorder.as_deref_mut() {
        recorder.points.push(loading_point(law, index, state, Some(Event::Peak)));
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

/// The law as a code with fixed steps evaluates it: the largest indentation so far is its memory. Distances count from
/// first touch.
struct Remembering<'a> {
    law: &'a Law,
    touch: f64,
    deepest: f64,
    unloading: Option<Unloading>,
}

impl<'a> Remembering<'a> {
    fn of(law: &'a Law) -> Self {
        let deepest = law.branch().map_or(0.0, |branch| branch.peak.elastic_approach);
        Self { law, touch: law.touch(), deepest, unloading: law.branch().copied() }
    }

    /// The state on the loading curve at a distance from first touch.
    fn loaded_to(&self, distance: f64) -> Peak {
        match self.law.branch() {
            Some(branch) if distance <= branch.peak.elastic_approach => self.law.state_at(0, distance),
            _ => self.law.loaded_to(self.touch + distance),
        }
    }
}

impl Deceleration for Remembering<'_> {
    fn at(&mut self, distance: f64) -> f64 {
        if distance > self.deepest || (distance == self.deepest && self.unloading.is_none()) {
            (self.deepest, self.unloading) = (distance, None);
            return ACCELERATION * self.law.loading.force(self.touch + distance);
        }
        let (law, touch, deepest) = (self.law, self.touch, self.deepest);
        let unloading = self.unloading.get_or_insert_with(|| law.unloading(law.loaded_to(touch + deepest)));
        ACCELERATION * unloading.force_of(distance - (unloading.peak.residual() - touch))
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
    let mut force = Remembering::of(law);
    let run =
        verlet::march(&mut force, speed, step, most_steps, work, recorder.as_deref_mut().map(|r| &mut r.sampler))?;
    let unloading = law.unloading(force.loaded_to(run.peak_distance));
    if let Some(recorder) = recorder {
        let touch = State { time: 0.0, distance: 0.0, speed };
        let peak = State { time: run.peak_time, distance: run.peak_distance, speed: 0.0 };
        let events = [(touch, Event::Touch), (peak, Event::Peak), (run.end, Event::Separation)];
        let samples = recorder.sampler.states.drain(..).map(|state| (state, None));
        let mut rows: Vec<_> = samples.chain(events.map(|(state, event)| (state, Some(event)))).collect();
        rows.sort_by(|a, b| a.0.time.total_cmp(&b.0.time));
        recorder.points.extend(rows.into_iter().map(|(state, event)| {
            if state.time <= run.peak_time {
                point(force.loaded_to(state.distance), state, event)
            } else {
                let distance = state.distance - (law.dent(&unloading.peak).residual() - force.touch);
                unloading_point(&unloading, State { distance, ..state }, event)
            }
        }));
    }
    let restitution = -run.end.speed / speed;
    Ok(Outcome { unloading, restitution, loading_time: run.peak_time, contact_time: run.end.time })
}
