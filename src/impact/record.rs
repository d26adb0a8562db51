//! The trace of an impact while it is integrated: even samples in time, and every event.

use super::outcome::Outcome;
use super::scales::ACCELERATION;
use crate::integrate::{Drag, Segment, State};
use crate::law::{Law, Peak, Unloading};
use crate::math::power::max_or_nan;
use crate::math::root::falls_through;

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
    /// What drag has taken so far, in units of Φ L.
    pub loss: f64,
    /// Whether compression is over.
    pub is_unloading: bool,
    /// The event, if it is one.
    pub event: Option<Event>,
}

/// A branch of the law that a leg runs along, with the drag there.
#[derive(Clone, Copy)]
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
    let of_drag = || drag.at(force, || slope() / ACCELERATION).0 * at.speed;
    // at lift-off the total force is zero but for rounding
    let total_force = if drag.is_in_contact() { max_or_nan(force + of_drag(), 0.0) } else { force };
    let (time, speed, loss) = (at.time, at.speed, at.loss / ACCELERATION);
    Point { time, indentation, speed, force, total_force, elastic_approach, loss, is_unloading: false, event }
}

/// A leg of a motion that is recorded.
#[derive(Debug)]
struct Recorded {
    /// The piece of the loading curve; `None` on the unloading branch.
    piece: Option<usize>,
    /// Its continuous solution.
    track: Vec<Segment>,
    /// Events at its start, on it and at its end, in order of time.
    events: Vec<(Event, State)>,
}

/// Collects a trace: the continuous solution of every leg, and every event. Its points are even samples in time, and the
/// events.
#[derive(Debug, Default)]
pub struct Recorder {
    /// Samples between first touch and the end.
    pub(super) inner: usize,
    /// What the samples are spread over; `None`: the contact time of this motion.
    pub(super) duration: Option<f64>,
    /// Whether compression and restitution have as many samples each, and the peak is one between them.
    is_by_leg: bool,
    legs: Vec<Recorded>,
    /// The points in order of time.
    pub points: Vec<Point>,
}

impl Recorder {
    /// A recorder of `samples` points evenly spaced over `duration`, or over the motion itself, both ends included (they are
    /// events).
    pub fn new(samples: usize, duration: Option<f64>) -> Self {
        Self { inner: samples.saturating_sub(2), duration, ..Self::default() }
    }

    /// A recorder with so many equal times from first touch to the peak, and as many from there to the end.
    pub(super) fn of_legs(steps: usize) -> Self {
        Self { inner: 2 * steps - 1, is_by_leg: true, ..Self::default() }
    }

    /// Time between two samples of a motion that lasts as long as this.
    #[allow(clippy::cast_precision_loss)] // counts below 2^53
    pub(super) fn interval(&self, contact_time: f64) -> f64 {
        self.duration.unwrap_or(contact_time) / (self.inner + 1) as f64
    }

    /// Begins a leg on a piece of the loading curve, or on the unloading branch, perhaps with an event.
    pub(super) fn begin(&mut self, piece: Option<usize>, event: Option<(Event, State)>) -> &mut Vec<Segment> {
        let place = self.legs.len();
        self.legs.push(Recorded { piece, track: Vec::new(), events: event.into_iter().collect() });
        &mut self.legs[place].track
    }

    /// Notes an event on the leg that was begun last.
    pub(super) fn mark(&mut self, event: Event, at: State) {
        if let Some(leg) = self.legs.last_mut() {
            leg.events.push((event, at));
        }
    }

    /// The state on the way out where the leg that was begun last passes a distance.
    pub(super) fn passage(&self, distance: f64) -> Option<State> {
        let track = &self.legs.last()?.track;
        let of = track.partition_point(|segment| segment.at(segment.end).distance < distance);
        let segment = track.get(of.min(track.len().checked_sub(1)?))?;
        let begun = of.checked_sub(1).map_or(0.0, |before| track[before].end);
        let time = falls_through((begun, segment.end), |time| distance - segment.at(time).distance);
        Some(State { distance, ..segment.at(time) })
    }

    /// Makes the points of a motion that has ended.
    pub(super) fn finish(&mut self, law: &Law, outcome: &Outcome, drag: Drag) {
        let interval = self.interval(outcome.contact_time);
        let (inward, whole) = (outcome.loading_time, outcome.contact_time);
        let half = self.inner.div_ceil(2);
        #[allow(clippy::cast_precision_loss)] // counts below 2^53
        let time_of = |next: usize| match self.is_by_leg {
            false => interval * next as f64,
            true if next < half => inward * (next as f64 / half as f64),
            true => inward + (whole - inward) * ((next - half) as f64 / half as f64),
        };
        let mut next = 1;
        for leg in self.legs.drain(..) {
            let along = match leg.piece {
                Some(index) => Along::Loading { law, index, drag },
                None => Along::Unloading { unloading: &outcome.unloading, drag },
            };
            let mut events = leg.events.into_iter().peekable();
            for segment in &leg.track {
                let due = |next: usize| Some(time_of(next)).filter(|time| *time < segment.end);
                while let Some(time) = due(next).filter(|_| next <= self.inner) {
                    while let Some((event, at)) = events.next_if(|(_, at)| at.time <= time) {
                        self.points.push(along.point(&at, Some(event)));
                    }
                    self.points.push(along.point(&segment.at(time), None));
                    next += 1;
                }
            }
            self.points.extend(events.map(|(event, at)| along.point(&at, Some(event))));
        }
    }
}
