//! The trace of an impact: the continuous solution of every leg and every event while it is integrated, and the points that
//! are made of them.

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
    /// τ, u and what drag has taken; the distance is that of its leg.
    pub at: State,
    /// Where the law is: x, its force, and ε, the part of x recovered if unloaded from here.
    pub state: Peak,
    /// Force with damping.
    pub total_force: f64,
    /// Whether compression is over.
    pub is_unloading: bool,
    /// The event, if it is one.
    pub event: Option<Event>,
}

impl Point {
    /// Of a motion on the loading curve, where the state of the law is `state`.
    pub(super) fn loading(
        state: Peak,
        slope: impl FnOnce() -> f64,
        drag: Drag,
        at: &State,
        event: Option<Event>,
    ) -> Self {
        let of_drag = || drag.at(state.force, || slope() / ACCELERATION).0 * at.speed;
        // at lift-off the total force is zero but for rounding
        let total_force = if drag.is_in_contact() { max_or_nan(state.force + of_drag(), 0.0) } else { state.force };
        Self { at: *at, state, total_force, is_unloading: false, event }
    }

    /// Of a motion on the unloading branch; distances count from the residual indentation.
    pub(super) fn unloading(unloading: &Unloading, drag: Drag, at: &State, event: Option<Event>) -> Self {
        let recovered = at.distance.max(0.0);
        let state = Peak {
            indentation: unloading.peak.residual() + at.distance,
            force: unloading.force_of(recovered),
            elastic_approach: at.distance,
        };
        Self { is_unloading: true, ..Self::loading(state, || unloading.slope_of(recovered), drag, at, event) }
    }
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

/// The continuous solution of every leg of a motion, and every event.
#[derive(Debug, Default)]
pub struct Recorder {
    legs: Vec<Recorded>,
}

impl Recorder {
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

    /// The points of the motion at these rising times, and its events, in order of time.
    pub(super) fn points(
        self,
        law: &Law,
        unloading: &Unloading,
        drag: Drag,
        times: impl Iterator<Item = f64>,
    ) -> Vec<Point> {
        let (mut points, mut times) = (Vec::new(), times.peekable());
        for Recorded { piece, track, events } in self.legs {
            let point = |at: &State, event: Option<Event>| {
                let Some(index) = piece else { return Point::unloading(unloading, drag, at, event) };
                let piece = &law.loading.pieces()[index];
                // distances count from the zero of a power law, else from the start of the piece
                let distance = at.distance - piece.shape.lead();
                Point::loading(law.state_at(index, distance), || piece.slope_beyond(distance), drag, at, event)
            };
            let mut events = events.into_iter().peekable();
            for segment in &track {
                while let Some(time) = times.next_if(|time| *time < segment.end) {
                    while let Some((event, at)) = events.next_if(|(_, at)| at.time <= time) {
                        points.push(point(&at, Some(event)));
                    }
                    points.push(point(&segment.at(time), None));
                }
            }
            points.extend(events.map(|(event, at)| point(&at, Some(event))));
        }
        points
    }
}

/// The times of so many points evenly spaced over a motion of this length, but for both ends, which are events.
#[allow(clippy::cast_precision_loss)] // counts below 2^53
pub(super) fn even_times(samples: usize, duration: f64) -> impl Iterator<Item = f64> {
    let inner = samples.saturating_sub(2);
    let interval = duration / (inner + 1) as f64;
    (1..=inner).map(move |k| interval * k as f64)
}
