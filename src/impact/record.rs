//! The trace of an impact while it is integrated: even samples in time, and every event.

use super::scales::ACCELERATION;
use crate::integrate::{Drag, Sampler, State};
use crate::law::{Law, Peak, Unloading};
use crate::math::power::max_or_nan;

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
    /// Force of the law.
    pub force: f64,
    /// Force with damping.
    pub total_force: f64,
    /// ε: the part of x recovered if unloaded from here.
    pub elastic_approach: f64,
    /// What damping has taken so far, in units of Φ L.
    pub loss: f64,
    /// Whether compression is over.
    pub is_unloading: bool,
    /// The event, if it is one.
    pub event: Option<Event>,
}

/// A branch of the law that a leg runs along, with the drag there.
pub(super) enum Along<'a> {
    /// A piece of the loading curve; distances count from the zero of a power law, else from the start of the piece.
    Loading { law: &'a Law, index: usize, drag: Drag },
    /// The unloading branch; distances count from the residual indentation.
    Unloading { unloading: &'a Unloading, drag: Drag },
}

impl Along<'_> {
    /// The point of a state on this branch.
    pub(super) fn point(&self, at: &State, event: Option<Event>) -> Point {
        match *self {
            Self::Loading { law, index, drag } => {
                let piece = &law.loading.pieces()[index];
                let distance = at.distance - piece.shape.lead();
                loading_point(law.state_at(index, distance), || piece.slope_beyond(distance), drag, at, event)
            }
            Self::Unloading { unloading, drag } => {
                let recovered = at.distance.max(0.0);
                let peak = Peak {
                    indentation: unloading.peak.residual() + at.distance,
                    force: unloading.force_of(recovered),
                    elastic_approach: at.distance,
                };
                let point = loading_point(peak, || unloading.slope_of(recovered), drag, at, event);
                Point { is_unloading: true, ..point }
            }
        }
    }
}

/// The point of a state on the loading curve. `loaded` is the state of the law there; `at.distance` is not used.
pub(super) fn loading_point(
    loaded: Peak,
    slope: impl FnOnce() -> f64,
    drag: Drag,
    at: &State,
    event: Option<Event>,
) -> Point {
    let Peak { indentation, force, elastic_approach } = loaded;
    let of_drag = drag.at(force, || slope() / ACCELERATION) * at.speed;
    // at lift-off the total force is zero but for rounding
    let total_force = if drag == Drag::NONE { force } else { max_or_nan(force + of_drag, 0.0) };
    let (time, speed, loss) = (at.time, at.speed, at.loss / ACCELERATION);
    Point { time, indentation, speed, force, total_force, elastic_approach, loss, is_unloading: false, event }
}

/// Collects a trace: even samples in time and every event.
#[derive(Debug, Clone, Default)]
pub struct Recorder {
    pub(super) sampler: Sampler,
    /// An event on the leg under way.
    marked: Option<(Event, State)>,
    /// The points in order of time.
    pub points: Vec<Point>,
}

impl Recorder {
    /// A recorder of `samples` points evenly spaced over `duration`, both ends included (they are events).
    pub fn new(samples: usize, duration: f64) -> Self {
        let inner = samples.saturating_sub(2);
        #[allow(clippy::cast_precision_loss)]
        let interval = duration / (inner + 1) as f64;
        Self { sampler: Sampler::every(interval, inner), marked: None, points: Vec::with_capacity(samples + 16) }
    }

    /// Notes an event on the leg under way.
    pub(super) fn mark(&mut self, event: Event, at: State) {
        self.marked = Some((event, at));
    }

    /// Turns the samples of a leg, an event noted on it, and the event at its end, into points.
    pub(super) fn take(&mut self, along: &Along, event: Option<(Event, &State)>) {
        let marked = self.marked.take().map(|(event, at)| along.point(&at, Some(event)));
        let before = marked.map_or(0, |marked| self.sampler.states.partition_point(|state| state.time < marked.time));
        self.points.extend(self.sampler.states.drain(..before).map(|state| along.point(&state, None)));
        self.points.extend(marked);
        self.points.extend(self.sampler.states.drain(..).map(|state| along.point(&state, None)));
        self.points.extend(event.map(|(event, at)| along.point(at, Some(event))));
    }
}
