//! An impact by velocity Verlet in fixed steps, as in DEM codes: steps pass over kinks, and separation is noticed at the first step
//! without force.
//!
//! A time in whole steps would hide the error of the motion, so the two times of the outcome lie within a step. Maximum compression
//! is where the speed and the acceleration of the deepest step lead to zero speed. Separation is found by following the free
//! flight after the last step back to the contact. Without damping both times are accurate to second order in the step, like the
//! motion. [`FixedSteps`] has the times that a code with this step finds.

use super::outcome::{FixedSteps, ImpactEnd, ScaledResult, Solution};
use super::recorder::{Event, TracePoint, sample_times};
use crate::contact::law::{ContactState, Surface, Unloading};
use crate::impact::problem::forces::ScaledForces;
use crate::impact::problem::scales::FORCE_FACTOR;
use crate::numerics::curve::piece::Piece;
use crate::numerics::ode::{DampingCoefficients, DenseOutput, IntegrationError, MotionState, SolverStats};
use crate::numerics::power::nan_max;
use crate::numerics::root::bisect;

/// The law as a code with fixed steps evaluates it: its memory is the largest indentation so far. Distances are measured from first
/// contact.
struct FixedStepContact<'a> {
    ground: Surface<'a>,
    drag: DampingCoefficients,
    touch: f64,
    deepest: f64,
    unloading: Option<Unloading>,
    /// The phase after the metal relaxed on a plate or rod, in which the bodies approach a little further along the unloading branch.
    after_relaxation: AfterRelaxation,
}

/// The phase of the motion since the metal relaxed on a plate or rod.
#[derive(Clone, Copy, PartialEq)]
enum AfterRelaxation {
    NotYet,
    Approaching,
    Parting,
}

impl<'a> FixedStepContact<'a> {
    fn new(ground: Surface<'a>, drag: DampingCoefficients) -> Self {
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
    fn branch_from(&self, deepest: f64) -> Unloading {
        match self.unloading {
            Some(unloading) if self.after_relaxation != AfterRelaxation::NotYet => unloading,
            _ => self.ground.unload_at(deepest),
        }
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
    fn separation_within_step(
        &mut self,
        before: &MotionState,
        end: &MotionState,
        step: f64,
        gravity: f64,
        residual: f64,
    ) -> MotionState {
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
struct VerletMotion<'a> {
    contact: FixedStepContact<'a>,
    weight: f64,
    step: f64,
    /// Steps so far.
    count: u64,
    state: MotionState,
    acceleration: f64,
}

impl<'a> VerletMotion<'a> {
    /// At first contact.
    fn new(ground: Surface<'a>, q: f64, forces: &ScaledForces, step: f64) -> Self {
        let state = MotionState { time: 0.0, distance: 0.0, speed: q, loss: 0.0 };
        let (contact, weight) = (FixedStepContact::new(ground, forces.damping), forces.weight);
        Self { contact, weight, step, count: 0, state, acceleration: FORCE_FACTOR * weight }
    }

    /// Makes a step, with the damping force at the speed half a step earlier; returns the force of the law and the total force.
    fn advance(&mut self) -> (f64, f64) {
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

/// A contact of fewer steps has no result.
const MIN_STEPS: u64 = 5;
/// A run with a larger restitution has no result; a restitution above 1 gets a warning.
const MAX_RESTITUTION: f64 = 1.05;

/// Integrates in steps of `step`. The peak is the deepest step. The run ends with the first step of the rebound in which no force
/// pushes; or, for a captured sphere, with the first step in which the sphere moves inwards again.
///
/// # Errors
/// [`IntegrationError::TooManyFixedSteps`] if there is no end within `most_steps`, [`IntegrationError::CoarseSteps`] if the steps
/// are too long to follow the contact.
pub(crate) fn integrate_fixed_steps(
    ground: Surface,
    q: f64,
    forces: &ScaledForces,
    step: f64,
    most_steps: u64,
    trace: Option<(usize, Option<f64>)>,
) -> Result<Solution, IntegrationError> {
    let mut motion = VerletMotion::new(ground, q, forces, step);
    let (mut peak, mut track) = (motion.state, Vec::new());
    // time of zero speed near the deepest step
    let mut turns_at = 0.0;
    let mut largest_force = 0.0;
    for n in 1..=most_steps {
        let (before, acceleration) = (motion.state, motion.acceleration);
        let (force, total) = motion.advance();
        if trace.is_some() {
            track.push(parabolic_output(before, acceleration, motion.state.time));
        }
        largest_force = nan_max(largest_force, total);
        let mut state = motion.state;
        let time = state.time;
        if state.distance > peak.distance && motion.contact.after_relaxation == AfterRelaxation::NotYet {
            peak = state;
            let acceleration = motion.acceleration;
            let until = if acceleration < 0.0 { (state.speed / -acceleration).clamp(-step, step) } else { 0.0 };
            turns_at = time + until;
        }
        if !(state.distance.is_finite() && state.speed.is_finite()) {
            return Err(IntegrationError::NotFinite { time });
        }
        let is_back = time > peak.time;
        // the total force of Hunt and Crossley vanishes before the force of the law only through rounding or a coarse step
        let pushes = if forces.damping.can_lift_off() { total } else { force };
        let lifts_off = is_back && pushes == 0.0 && state.speed < 0.0;
        let is_slower =
            is_back && state.speed >= 0.0 && motion.contact.after_relaxation != AfterRelaxation::Approaching;
        let deepest = || motion.contact.branch_from(peak.distance);
        let stays = || {
            if forces.is_conservative() {
                is_back && forces.is_captured(&deepest(), q) && force <= forces.weight
            } else {
                has_crept_to_rest(&motion, forces, &deepest())
            }
        };
        if !(lifts_off || is_slower || forces.weight > 0.0 && stays()) {
            continue;
        }
        let unloading = deepest();
        let separates = lifts_off && !forces.is_captured(&unloading, q);
        if separates {
            let residual = ground.deepest_state(&unloading.peak).residual() - motion.contact.touch;
            state =
                motion.contact.separation_within_step(&before, &state, step, FORCE_FACTOR * forces.weight, residual);
        }
        let restitution = if separates { -state.speed / q } else { 0.0 };
        // under gravity a slow sphere that sinks into its dent separates faster than it arrived
        let makes_energy = forces.weight == 0.0 && restitution > MAX_RESTITUTION;
        if separates && n < MIN_STEPS || makes_energy {
            return Err(IntegrationError::CoarseSteps { steps: n, restitution });
        }
        let outcome = ScaledResult {
            unloading,
            restitution,
            largest_force: ground.reported_force(&unloading, Some(largest_force)),
            loading_time: if is_back { turns_at.min(state.time) } else { peak.time },
            contact_time: state.time,
            end: if separates { ImpactEnd::Separated } else { ImpactEnd::Captured },
            end_indentation: motion.contact.touch + state.distance,
            end_speed: state.speed,
            loss: state.loss / FORCE_FACTOR,
        };
        // one evaluation a step, and one at first contact
        let work = SolverStats { steps: n, rejected: 0, force_evaluations: n + 1 };
        let separation_time = separates.then_some(time);
        let fixed_steps = Some(FixedSteps { step, compression_time: peak.time, separation_time });
        let of_samples = |(samples, duration): (usize, Option<f64>)| {
            let times = sample_times(samples, duration.unwrap_or(outcome.contact_time));
            motion.contact.points(&outcome, &peak, &track, times)
        };
        let points = trace.map_or_else(Vec::new, of_samples);
        return Ok(Solution { fixed_steps, trace_points: points, ..Solution::new(outcome, work) });
    }
    Err(IntegrationError::TooManyFixedSteps { steps: most_steps })
}

/// True if an overdamped sphere is near its static indentation.
fn has_crept_to_rest(motion: &VerletMotion, forces: &ScaledForces, unloading: &Unloading) -> bool {
    let point = forces.static_equilibrium(motion.contact.ground, unloading);
    let indentation = motion.contact.touch + motion.state.distance;
    forces
        .rest_criterion(&point, point.indentation)
        .is_some_and(|rest| rest.excess(indentation, motion.state.speed) <= 0.0)
}

/// The motion in a step that begins in this state and ends at this time.
fn parabolic_output(from: MotionState, acceleration: f64, end: f64) -> DenseOutput {
    DenseOutput::new(end, move |time| {
        let t = time - from.time;
        let distance = from.distance + t * (from.speed + 0.5 * acceleration * t);
        MotionState { time, distance, speed: from.speed + acceleration * t, loss: from.loss }
    })
}

impl FixedStepContact<'_> {
    /// The points of this outcome at these rising times and at its events, from the steps up to its end.
    fn points(
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
        let residual = self.ground.deepest_state(&outcome.unloading.peak).residual() - self.touch;
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
