//! The motion by velocity Verlet in fixed steps, as in DEM codes: steps pass over kinks, and separation is noticed at the first step
//! without force.

use super::outcome::{ImpactEnd, ScaledResult};
use super::recorder::{Event, TracePoint};
use crate::contact::law::{ContactState, Surface, Unloading};
use crate::impact::problem::forces::ScaledForces;
use crate::impact::problem::scales::FORCE_FACTOR;
use crate::numerics::curve::piece::Piece;
use crate::numerics::ode::{DampingCoefficients, DenseOutput, MotionState};
use crate::numerics::power::nan_max;
use crate::numerics::root::bisect;

/// The law as a code with fixed steps evaluates it: its memory is the largest indentation so far. Distances are measured from first
/// contact.
pub(super) struct FixedStepContact<'a> {
    pub(super) ground: Surface<'a>,
    drag: DampingCoefficients,
    pub(super) touch: f64,
    deepest: f64,
    unloading: Option<Unloading>,
    /// The phase after the metal relaxed on a plate or rod, in which the bodies approach a little further along the unloading branch.
    pub(super) after_relaxation: AfterRelaxation,
}

/// The phase of the motion since the metal relaxed on a plate or rod.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum AfterRelaxation {
    NotYet,
    Approaching,
    Parting,
}

impl<'a> FixedStepContact<'a> {
    pub(super) fn new(ground: Surface<'a>, drag: DampingCoefficients) -> Self {
        let deepest = ground.reloading_branch().map_or(0.0, |branch| branch.peak.elastic_approach);
        let unloading = ground.reloading_branch().copied();
        Self {
            ground,
            drag,
            touch: ground.first_contact(),
            deepest,
            unloading,
            after_relaxation: AfterRelaxation::NotYet,
        }
    }

    /// The speed that the sphere gains when the metal relaxes on a plate or rod: the force falls, and the momentum stays (`motion.rs`).
    /// `speed` is the speed against the plate or rod.
    fn relaxation_speed(&mut self, speed: f64) -> f64 {
        if speed >= 0.0 || self.drag.plate == 0.0 || !self.ground.law.relaxes() {
            return 0.0;
        }
        if self.after_relaxation != AfterRelaxation::NotYet {
            self.after_relaxation = AfterRelaxation::Parting;
            return 0.0;
        }
        let unloading = self.branch_from(self.deepest);
        let fall = self.ground.force_drop_at_peak(&unloading);
        if fall > 0.0 {
            (self.unloading, self.after_relaxation) = (Some(unloading), AfterRelaxation::Approaching);
        }
        FORCE_FACTOR * self.drag.plate * fall
    }

    /// The unloading branch from the deepest step. After a relaxation it is the branch of the relaxed metal.
    pub(super) fn branch_from(&self, deepest: f64) -> Unloading {
        match self.unloading {
            Some(unloading) if self.after_relaxation != AfterRelaxation::NotYet => unloading,
            _ => self.ground.unload_at(deepest),
        }
    }

    /// The distance at which the force of an unloading branch vanishes.
    fn residual_distance(&self, unloading: &Unloading) -> f64 {
        self.ground.deepest_state(&unloading.peak).residual() - self.touch
    }

    /// The piece of the loading curve at a distance.
    fn piece_at(&self, distance: f64) -> &'a Piece {
        self.ground.piece(self.ground.place_at(distance).0)
    }

    /// The state on the loading curve at a distance.
    fn loaded_state(&self, distance: f64) -> ContactState {
        let (index, distance) = self.ground.place_at(distance);
        self.ground.state_at(index, distance)
    }

    /// Force of the law, what damping adds to it, and the deceleration by drag on the motion alone.
    fn forces_at(&mut self, distance: f64, speed: f64) -> (f64, f64, f64) {
        let drag = self.drag;
        let is_loading = distance > self.deepest && self.after_relaxation == AfterRelaxation::NotYet;
        if is_loading || (distance == self.deepest && self.unloading.is_none()) {
            (self.deepest, self.unloading) = (distance, None);
            let (x, piece) = (self.touch + distance, self.piece_at(distance));
            let force = piece.force_at(x);
            return with_damping(drag, force, || piece.slope_at(x), speed);
        }
        let (ground, touch, deepest) = (self.ground, self.touch, self.deepest);
        let unloading = self.unloading.get_or_insert_with(|| ground.unload_at(deepest));
        let recovered = distance - (unloading.peak.residual() - touch);
        let force = unloading.force_at_elastic_approach(recovered);
        with_damping(drag, force, || unloading.slope_at(recovered.max(0.0)), speed)
    }

    /// The state at separation, within the step of this length from `before` to `end`. At `end` no force pushes the sphere, so
    /// its free flight is followed backwards: to the depth of the dent or, under viscous damping, to the zero of the total force.
    /// If the damping exceeds the force only because the step is coarse, there is no such zero, and the separation is at the end
    /// of the step.
    pub(super) fn separation_within_step(
        &mut self,
        before: &MotionState,
        end: &MotionState,
        step: f64,
        gravity: f64,
        unloading: &Unloading,
    ) -> MotionState {
        let residual = self.residual_distance(unloading);
        let flown_back = |since: f64| MotionState {
            time: end.time - since,
            distance: end.distance - since * (end.speed - 0.5 * gravity * since),
            speed: end.speed - gravity * since,
            ..*end
        };
        let gap = residual - end.distance;
        let speed_at_dent = (end.speed * end.speed + 2.0 * gravity * gap).sqrt();
        let is_past_dent = gap > 0.0;
        let since_dent = if is_past_dent { (2.0 * gap / (speed_at_dent - end.speed)).min(step) } else { 0.0 };
        if !self.drag.can_lift_off() {
            let at_dent = flown_back(since_dent);
            let loss = before.loss;
            return if is_past_dent { MotionState { distance: residual, loss, ..at_dent } } else { at_dent };
        }
        let mut is_pushed = |since: f64| {
            let MotionState { distance, speed, .. } = flown_back(since);
            let (force, of_damping, _) = self.forces_at(distance, speed);
            force + of_damping > 0.0
        };
        let (gone, _) = bisect(since_dent, step, |since| !is_pushed(since));
        let separated = flown_back(gone);
        let (force, of_damping, _) = self.forces_at(separated.distance, separated.speed);
        let of_damping = nan_max(of_damping, -force);
        MotionState { loss: before.loss + FORCE_FACTOR * of_damping * separated.speed * (step - gone), ..separated }
    }
}

/// A force of the law with the drag on it, see [`FixedStepContact::forces_at`].
fn with_damping(drag: DampingCoefficients, force: f64, slope: impl FnOnce() -> f64, speed: f64) -> (f64, f64, f64) {
    // the drag is that of the deceleration g = c f
    let (in_contact, on_motion) = drag.rates_at_force(FORCE_FACTOR * force, || FORCE_FACTOR * slope());
    (force, in_contact * speed / FORCE_FACTOR, on_motion * speed)
}

/// A motion in steps of equal length.
pub(super) struct VerletMotion<'a> {
    pub(super) contact: FixedStepContact<'a>,
    weight: f64,
    pub(super) step: f64,
    /// Steps so far.
    pub(super) count: u64,
    pub(super) state: MotionState,
    pub(super) acceleration: f64,
}

impl<'a> VerletMotion<'a> {
    /// At first contact.
    pub(super) fn new(ground: Surface<'a>, q: f64, forces: &ScaledForces, step: f64) -> Self {
        let state = MotionState { time: 0.0, distance: 0.0, speed: q, loss: 0.0 };
        let (contact, weight) = (FixedStepContact::new(ground, forces.damping), forces.weight);
        Self { contact, weight, step, count: 0, state, acceleration: FORCE_FACTOR * weight }
    }

    /// Makes a step, with the damping force at the speed half a step earlier; returns the force of the law and the total force.
    pub(super) fn advance(&mut self) -> (f64, f64) {
        let (step, mut from) = (self.step, self.state);
        let mut half = from.speed + 0.5 * step * self.acceleration;
        let gained = self.contact.relaxation_speed(half);
        if gained > 0.0 {
            from.loss -= gained * (half + 0.5 * gained);
            half += gained;
        }
        let distance = from.distance + step * half;
        let (force, of_damping, on_motion) = self.contact.forces_at(distance, half);
        let total = nan_max(force + of_damping, 0.0);
        self.acceleration = FORCE_FACTOR * (self.weight - total) - on_motion;
        self.count += 1;
        #[allow(clippy::cast_precision_loss)] // counts below 2^53
        let time = step * self.count as f64;
        let loss = from.loss + (FORCE_FACTOR * (total - force) + on_motion) * half * step;
        self.state = MotionState { time, distance, speed: half + 0.5 * step * self.acceleration, loss };
        (force, total)
    }
}

impl FixedStepContact<'_> {
    /// The points of this outcome at these rising times and at its events, from the steps up to its end.
    pub(super) fn points(
        &self,
        outcome: &ScaledResult,
        peak: &MotionState,
        track: &[DenseOutput],
        times: impl Iterator<Item = f64>,
    ) -> Vec<TracePoint> {
        let mut times = times.take_while(|time| *time < outcome.contact_time).peekable();
        let mut states = Vec::new();
        for segment in track {
            while let Some(time) = times.next_if(|time| *time < segment.end) {
                states.push((segment.state_at(time), None));
            }
        }
        let touch = track.first().map_or(*peak, |first| first.state_at(0.0));
        let turning = MotionState { time: outcome.loading_time, speed: 0.0, ..*peak };
        let end = MotionState {
            time: outcome.contact_time,
            distance: outcome.end_indentation - self.touch,
            speed: outcome.end_speed,
            loss: outcome.loss * FORCE_FACTOR,
        };
        let of_end = if outcome.end == ImpactEnd::Separated { Event::Separation } else { Event::Captured };
        let until_peak = states.partition_point(|(state, _)| state.time <= outcome.loading_time);
        if self.ground.force_drop_at_peak(&outcome.unloading) > 0.0 {
            states.insert(until_peak, (turning, Some(Event::Relaxation)));
        }
        states.insert(until_peak, (turning, Some(Event::Peak)));
        states.insert(0, (touch, Some(Event::Touch)));
        states.push((end, Some(of_end)));
        let residual = self.residual_distance(&outcome.unloading);
        let point = |(state, event): (MotionState, Option<Event>)| {
            if state.time <= outcome.loading_time && event != Some(Event::Relaxation) {
                let slope = || self.piece_at(state.distance).slope_at(self.touch + state.distance);
                TracePoint::from_loading(self.loaded_state(state.distance), slope, self.drag, &state, event)
            } else {
                let at = MotionState { distance: state.distance - residual, ..state };
                TracePoint::from_unloading(&outcome.unloading, self.drag, &at, event)
            }
        };
        states.into_iter().map(point).collect()
    }
}
