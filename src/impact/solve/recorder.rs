//! The trace of an impact: the recorder keeps the continuous solution and the events of every leg during the integration, and
//! computes the points from them. A leg is the motion along one piece of the loading curve, or along the unloading branch.

use crate::contact::law::{ContactState, Surface, Unloading};
use crate::impact::problem::forces::total_force;
use crate::numerics::ode::{DampingCoefficients, DenseOutput, MotionState};
use crate::numerics::root::illinois;

/// The events of an impact that a trace marks, in their order of time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Event {
    Touch,
    /// First yield of the softer body.
    Yield,
    /// The loading curve passes from one piece to the next.
    Knot,
    Peak,
    /// The force drops at maximum compression, where the metal relaxes to the strength of a lower strain rate.
    Relaxation,
    /// The contact force vanishes: at the residual indentation, or before it under viscous damping.
    Separation,
    /// The end of the run of a sphere that does not separate.
    Captured,
}

/// A point of a trace, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TracePoint {
    /// τ, u and the energy absorbed by drag; the distance is the distance of the leg.
    pub at: MotionState,
    /// The state of the law: x, its force, and ε, the part of x that unloading from here recovers.
    pub state: ContactState,
    pub total_force: f64,
    /// True if compression is over.
    pub is_unloading: bool,
    pub event: Option<Event>,
}

impl TracePoint {
    /// A point of a motion on the loading curve, where the state of the law is `state`.
    pub(in crate::impact) fn from_loading(
        state: ContactState,
        slope: impl FnOnce() -> f64,
        drag: DampingCoefficients,
        at: &MotionState,
        event: Option<Event>,
    ) -> Self {
        let total_force = total_force(drag, state.force, slope, at.speed);
        Self { at: *at, state, total_force, is_unloading: false, event }
    }

    /// A point of a motion on the unloading branch; distances are measured from the residual indentation.
    pub(in crate::impact) fn from_unloading(
        unloading: &Unloading,
        drag: DampingCoefficients,
        at: &MotionState,
        event: Option<Event>,
    ) -> Self {
        let recovered = at.distance.max(0.0);
        let state = ContactState {
            indentation: unloading.peak.residual() + at.distance,
            force: unloading.force_at_elastic_approach(recovered),
            elastic_approach: at.distance,
        };
        Self { is_unloading: true, ..Self::from_loading(state, || unloading.slope_at(recovered), drag, at, event) }
    }
}

/// A recorded leg of a motion.
#[derive(Debug)]
struct RecordedLeg {
    /// The piece of the loading curve; `None` on the unloading branch.
    piece: Option<usize>,
    /// Its continuous solution.
    track: Vec<DenseOutput>,
    /// Events at its start, on it and at its end, in order of time.
    events: Vec<(Event, MotionState)>,
}

/// Records the continuous solution and the events of every leg of a motion.
#[derive(Debug, Default)]
pub struct TraceRecorder {
    legs: Vec<RecordedLeg>,
}

impl TraceRecorder {
    /// Begins a leg on a piece of the loading curve, or on the unloading branch. The first leg begins with first contact.
    #[cold] // a run without a trace is faster without this code in it
    pub(in crate::impact) fn begin_leg(&mut self, piece: Option<usize>, touch: &MotionState) -> &mut Vec<DenseOutput> {
        let events = if self.legs.is_empty() { vec![(Event::Touch, *touch)] } else { Vec::new() };
        let place = self.legs.len();
        self.legs.push(RecordedLeg { piece, track: Vec::new(), events });
        &mut self.legs[place].track
    }

    /// Records an event of the last leg.
    #[cold]
    pub(in crate::impact) fn record_event(&mut self, event: Event, at: MotionState) {
        if let Some(leg) = self.legs.last_mut() {
            leg.events.push((event, at));
        }
    }

    /// Returns the recorded motion on this surface.
    pub(in crate::impact) fn into_motion(
        self,
        ground: Surface<'_>,
        unloading: Unloading,
        drag: DampingCoefficients,
    ) -> RecordedMotion<'_> {
        RecordedMotion { ground, unloading, drag, legs: self.legs }
    }

    /// The points of the motion at these rising times and at its events, in order of time.
    pub(in crate::impact) fn into_points(
        self,
        ground: Surface,
        unloading: &Unloading,
        drag: DampingCoefficients,
        times: impl Iterator<Item = f64>,
    ) -> Vec<TracePoint> {
        let (mut points, mut times, mut begun) = (Vec::new(), times.peekable(), 0.0);
        for RecordedLeg { piece, track, mut events } in self.legs {
            let point = |at: &MotionState, event: Option<Event>| trace_point(ground, unloading, drag, piece, at, event);
            if let Some(state) = piece.and_then(|index| first_yield_state(ground, index, begun, &track)) {
                let place = events.partition_point(|(_, at)| at.time <= state.time);
                events.insert(place, (Event::Yield, state));
            }
            begun = track.last().map_or(begun, |last| last.end);
            let mut events = events.into_iter().peekable();
            for segment in &track {
                // the step before the last may end beyond the end of the leg, and the last step then returns to this end
                while let Some(time) = times.next_if(|time| *time < segment.end.min(begun)) {
                    while let Some((event, at)) = events.next_if(|(_, at)| at.time <= time) {
                        points.push(point(&at, Some(event)));
                    }
                    points.push(point(&segment.state_at(time), None));
                }
            }
            points.extend(events.map(|(event, at)| point(&at, Some(event))));
        }
        points
    }
}

/// A point of a motion on a piece of the loading curve, or on the unloading branch.
fn trace_point(
    ground: Surface,
    unloading: &Unloading,
    drag: DampingCoefficients,
    piece: Option<usize>,
    at: &MotionState,
    event: Option<Event>,
) -> TracePoint {
    let Some(index) = piece else { return TracePoint::from_unloading(unloading, drag, at, event) };
    let piece = ground.piece(index);
    // distances are measured from the zero of a power law, otherwise from the start of the piece
    let distance = at.distance - piece.shape.zero_offset();
    TracePoint::from_loading(ground.state_at(index, distance), || piece.slope_at_distance(distance), drag, at, event)
}

/// A recorded motion, which can be evaluated at any time.
#[derive(Debug)]
pub struct RecordedMotion<'a> {
    ground: Surface<'a>,
    unloading: Unloading,
    drag: DampingCoefficients,
    legs: Vec<RecordedLeg>,
}

impl RecordedMotion<'_> {
    /// The times at which the motion passes from one formula of the force to the next, in order, and the time of its end.
    pub(in crate::impact) fn piece_end_times(&self) -> impl Iterator<Item = f64> {
        let goes_on = |leg: Option<&RecordedLeg>| {
            leg.and_then(|leg| leg.piece).is_some_and(|piece| self.ground.piece(piece).is_subdivision)
        };
        let ends = self.legs.iter().enumerate().filter(move |(i, _)| !goes_on(self.legs.get(i + 1)));
        ends.filter_map(|(_, leg)| leg.track.last()).map(|segment| segment.end)
    }

    /// The state at a time, or at the nearest end of the motion for a time outside of it; and the piece of the loading curve of this
    /// state, `None` on the unloading branch.
    pub(in crate::impact) fn state(&self, time: f64) -> (MotionState, Option<usize>) {
        let ends_before = |leg: &RecordedLeg| leg.track.last().is_none_or(|segment| segment.end < time);
        let leg = self.legs.partition_point(ends_before).min(self.legs.len() - 1);
        let RecordedLeg { piece, track, .. } = &self.legs[leg];
        let segment = track.partition_point(|segment| segment.end < time).min(track.len() - 1);
        (track[segment].state_at(time.min(track[segment].end)), *piece)
    }

    /// The point of the motion at a state on this piece of the loading curve.
    pub(in crate::impact) fn loading_point(&self, piece: usize, at: &MotionState) -> TracePoint {
        trace_point(self.ground, &self.unloading, self.drag, Some(piece), at, None)
    }
}

/// The state of first yield on a leg that begins at this time, if the leg passes it. First yield ends no leg, because a trace must
/// not change the steps.
fn first_yield_state(ground: Surface, index: usize, begun: f64, track: &[DenseOutput]) -> Option<MotionState> {
    let (piece, yields_at) = (ground.piece(index), ground.elastic_until());
    let distance = yields_at - piece.start + piece.shape.zero_offset();
    let number = track.iter().position(|segment| segment.state_at(segment.end).distance > distance)?;
    let begun = number.checked_sub(1).map_or(begun, |before| track[before].end);
    let ahead = |time: f64| distance - track[number].state_at(time).distance;
    let is_inside = index == ground.reloading_path.index_at(yields_at) && piece.start < yields_at;
    let is_passed = is_inside && ahead(begun) > 0.0;
    is_passed.then(|| MotionState { distance, ..track[number].state_at(illinois((begun, track[number].end), ahead)) })
}

/// The times of `samples` points evenly spaced over a motion of this length, without both ends, which are events.
#[allow(clippy::cast_precision_loss)] // counts below 2^53
pub(in crate::impact) fn sample_times(samples: usize, duration: f64) -> impl Iterator<Item = f64> {
    let inner = samples.saturating_sub(2);
    let interval = duration / (inner + 1) as f64;
    (1..=inner).map(move |k| interval * k as f64)
}
