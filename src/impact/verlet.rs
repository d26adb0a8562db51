//! An impact by velocity Verlet in fixed steps, as DEM codes do it: kinks stepped over, separation noticed at the first step
//! without force.
//!
//! A time in whole steps would hide the error of the motion. So the two times of the outcome lie within a step. Maximum
//! compression is where speed and acceleration of the deepest step give zero speed. Separation is found by following the free
//! flight at the end of the last step back to the contact. Without damping both are exact to second order in the step, as
//! the motion is. [`FixedSteps`] has the times that a code with this step sees.

use super::outcome::{Computed, Fate, FixedSteps, Outcome};
use super::record::{Along, Event, Recorder, loading_point};
use super::scaled_forces::{ScaledForces, equilibrium};
use super::scales::ACCELERATION;
use crate::integrate::{Drag, IntegrationError, State, Work};
use crate::law::piece::Piece;
use crate::law::{Law, Peak, Unloading};
use crate::math::power::max_or_nan;
use crate::math::root::halved;

/// The law as a code with fixed steps evaluates it: the largest indentation so far is its memory. Distances count from
/// first touch.
struct Remembering<'a> {
    law: &'a Law,
    drag: Drag,
    touch: f64,
    deepest: f64,
    unloading: Option<Unloading>,
}

impl<'a> Remembering<'a> {
    fn of(law: &'a Law, drag: Drag) -> Self {
        let deepest = law.branch().map_or(0.0, |branch| branch.peak.elastic_approach);
        Self { law, drag, touch: law.touch(), deepest, unloading: law.branch().copied() }
    }

    /// The piece of the loading curve at a distance.
    fn piece_at(&self, distance: f64) -> &'a Piece {
        &self.law.loading.pieces()[self.law.loading.index_at(self.touch + distance)]
    }

    /// The state on the loading curve at a distance.
    fn loaded_to(&self, distance: f64) -> Peak {
        match self.law.branch() {
            Some(branch) if distance <= branch.peak.elastic_approach => self.law.state_at(0, distance),
            _ => self.law.loaded_to(self.touch + distance),
        }
    }

    /// Force of the law, what damping adds to it, and the deceleration by drag on the motion alone.
    fn at(&mut self, distance: f64, speed: f64) -> (f64, f64, f64) {
        let drag = self.drag;
        if distance > self.deepest || (distance == self.deepest && self.unloading.is_none()) {
            (self.deepest, self.unloading) = (distance, None);
            let (x, piece) = (self.touch + distance, self.piece_at(distance));
            let force = piece.force_at(x);
            return resisted(drag, force, || piece.slope_at(x), speed);
        }
        let (law, touch, deepest) = (self.law, self.touch, self.deepest);
        let unloading = self.unloading.get_or_insert_with(|| law.unloading(law.loaded_to(touch + deepest)));
        let recovered = distance - (unloading.peak.residual() - touch);
        let force = unloading.force_of(recovered);
        resisted(drag, force, || unloading.slope_of(recovered.max(0.0)), speed)
    }

    /// The state in which the sphere left the contact, within the step of this length from `before` to `end`. At `end` nothing
    /// pushes the sphere any more, so its free flight is followed backwards: to the depth of the dent or, under viscous
    /// damping, to where the total force vanishes. If there is no such place, because the damping is larger than the force
    /// only through a coarse step, the sphere leaves at the end of the step.
    fn left_at(&mut self, before: &State, end: &State, step: f64, gravity: f64, residual: f64) -> State {
        let flown_back = |since: f64| State {
            time: end.time - since,
            distance: end.distance - since * (end.speed - 0.5 * gravity * since),
            speed: end.speed - gravity * since,
            ..*end
        };
        let gap = residual - end.distance;
        let speed_at_dent = (end.speed * end.speed + 2.0 * gravity * gap).sqrt();
        let is_past_dent = gap > 0.0;
        let since_dent = if is_past_dent { (2.0 * gap / (speed_at_dent - end.speed)).min(step) } else { 0.0 };
        if !self.drag.lifts_off() {
            let at_dent = flown_back(since_dent);
            let loss = before.loss;
            return if is_past_dent { State { distance: residual, loss, ..at_dent } } else { at_dent };
        }
        let mut is_pushed = |since: f64| {
            let State { distance, speed, .. } = flown_back(since);
            let (force, of_damping, _) = self.at(distance, speed);
            force + of_damping > 0.0
        };
        let (gone, _) = halved(since_dent, step, |since| !is_pushed(since));
        let left = flown_back(gone);
        let (force, of_damping, _) = self.at(left.distance, left.speed);
        let of_damping = max_or_nan(of_damping, -force);
        State { loss: before.loss + ACCELERATION * of_damping * left.speed * (step - gone), ..left }
    }
}

/// A force of the law with what drag does there, see [`Remembering::at`].
fn resisted(drag: Drag, force: f64, slope: impl FnOnce() -> f64, speed: f64) -> (f64, f64, f64) {
    // the drag is that of g = c f, and so are its shares
    let (in_contact, on_motion) = drag.at(force, || slope() / ACCELERATION);
    (force, in_contact * speed, ACCELERATION * ACCELERATION * on_motion * speed)
}

/// Evenly spaced samples of a motion, filled while it goes on.
struct Sampler {
    interval: f64,
    count: usize,
    next: usize,
    states: Vec<State>,
}

impl Sampler {
    /// Takes the samples that are due before `end` on a parabola from `state`.
    fn take(&mut self, state: &State, acceleration: f64, end: f64) {
        #[allow(clippy::cast_precision_loss)] // counts below 2^53
        while self.next <= self.count && self.interval * (self.next as f64) < end {
            let time = self.interval * self.next as f64;
            let t = time - state.time;
            let distance = state.distance + t * (state.speed + 0.5 * acceleration * t);
            self.states.push(State { time, distance, speed: state.speed + acceleration * t, loss: state.loss });
            self.next += 1;
        }
    }
}

/// Marches in steps of `step`. The force of damping is taken at the speed half a step before. The peak is the deepest step.
/// The run ends with the first step on the way out in which no force pushes; or, for a captured sphere, with the first step
/// in which the sphere moves inwards again.
///
/// # Errors
/// [`IntegrationError::TooManySteps`] if there is no end within `most_steps`.
pub(crate) fn march(
    law: &Law,
    q: f64,
    forces: &ScaledForces,
    step: f64,
    most_steps: u64,
    recorder: Option<&mut Recorder>,
) -> Result<Computed, IntegrationError> {
    let mut contact = Remembering::of(law, forces.drag());
    let touch = State { time: 0.0, distance: 0.0, speed: q, loss: 0.0 };
    let gravity = ACCELERATION * forces.weight;
    let (mut state, mut acceleration) = (touch, gravity);
    let mut peak = State { speed: 0.0, ..touch };
    // time of zero speed near the deepest step
    let mut turns_at = 0.0;
    let mut sampler = recorder.as_ref().map(|recorder| {
        let interval = recorder.interval(f64::INFINITY);
        Sampler { interval, count: recorder.inner, next: 1, states: Vec::new() }
    });
    let mut largest_force = 0.0;
    for n in 1..=most_steps {
        let half = state.speed + 0.5 * step * acceleration;
        let distance = state.distance + step * half;
        #[allow(clippy::cast_precision_loss)] // counts below 2^53
        let time = step * n as f64;
        let (before, acceleration_before) = (state, acceleration);
        let (force, of_damping, on_motion) = contact.at(distance, half);
        let total = max_or_nan(force + of_damping, 0.0);
        largest_force = max_or_nan(largest_force, total);
        acceleration = ACCELERATION * (forces.weight - total) - on_motion;
        let loss = state.loss + (ACCELERATION * (total - force) + on_motion) * half * step;
        state = State { time, distance, speed: half + 0.5 * step * acceleration, loss };
        if distance > peak.distance {
            peak = State { speed: 0.0, ..state };
            let until = if acceleration < 0.0 { (state.speed / -acceleration).clamp(-step, step) } else { 0.0 };
            turns_at = time + until;
        }
        if !(distance.is_finite() && state.speed.is_finite()) {
            return Err(IntegrationError::NotFinite { time });
        }
        let is_back = time > peak.time;
        let lifts_off = is_back && total == 0.0 && state.speed < 0.0;
        let is_slower = is_back && state.speed >= 0.0;
        let stays = || {
            let unloading = law.unloading(contact.loaded_to(peak.distance));
            if forces.is_conservative() {
                is_back && forces.captures(&unloading, q) && force <= forces.weight
            } else {
                creeps(&contact, forces, &unloading, &state)
            }
        };
        let is_end = lifts_off || is_slower || forces.weight > 0.0 && stays();
        let unloading = is_end.then(|| law.unloading(contact.loaded_to(peak.distance)));
        let separates = lifts_off && unloading.is_some_and(|unloading| !forces.captures(&unloading, q));
        if let Some(unloading) = unloading.filter(|_| separates) {
            let residual = law.dent(&unloading.peak).residual() - contact.touch;
            state = contact.left_at(&before, &state, step, gravity, residual);
        }
        if let Some(sampler) = &mut sampler {
            sampler.take(&before, acceleration_before, state.time);
        }
        if let Some(unloading) = unloading {
            let loading_time = if is_back { turns_at.min(state.time) } else { peak.time };
            let (fate, end) =
                if separates { (Fate::Separated, Event::Separation) } else { (Fate::Captured, Event::Captured) };
            if let (Some(recorder), Some(sampler)) = (recorder, sampler) {
                let turning = State { time: loading_time, ..peak };
                let events = [(touch, Event::Touch), (turning, Event::Peak), (state, end)];
                record(&contact, &unloading, loading_time, sampler, &events, recorder);
            }
            let outcome = Outcome {
                unloading,
                restitution: if separates { -state.speed / q } else { 0.0 },
                largest_force,
                loading_time,
                contact_time: state.time,
                fate,
                end_indentation: contact.touch + state.distance,
                end_speed: state.speed,
                loss: state.loss / ACCELERATION,
            };
            // one evaluation a step, and one at first touch
            let work = Work { steps: n, rejected: 0, force_evaluations: n + 1 };
            let fixed_steps = Some(FixedSteps { step, loading_time: peak.time, contact_time: time });
            return Ok(Computed { outcome, work, fixed_steps });
        }
    }
    Err(IntegrationError::TooManySteps { steps: most_steps })
}

/// Whether an overdamped sphere has come near its static indentation.
fn creeps(contact: &Remembering, forces: &ScaledForces, unloading: &Unloading, state: &State) -> bool {
    let law = contact.law;
    let (at, slope) = if unloading.peak.force < forces.weight {
        let (x, index) = equilibrium(law, forces.weight);
        (x - contact.touch, law.loading.pieces()[index].slope_at(x))
    } else {
        let approach = forces.static_approach(unloading);
        (approach, forces.static_slope(unloading, approach))
    };
    let distance = (contact.touch + state.distance - forces.static_indentation(law, unloading)).abs();
    forces.creep(at, slope).is_some_and(|creep| distance <= creep.within && state.speed.abs() <= creep.below)
}

/// The points of the trace, in order of time.
fn record(
    contact: &Remembering,
    unloading: &Unloading,
    peak_time: f64,
    mut sampler: Sampler,
    events: &[(State, Event)],
    recorder: &mut Recorder,
) {
    let samples = sampler.states.drain(..).map(|state| (state, None));
    let mut rows: Vec<_> = samples.chain(events.iter().map(|(state, event)| (*state, Some(*event)))).collect();
    rows.sort_by(|a, b| a.0.time.total_cmp(&b.0.time));
    let (law, drag) = (contact.law, contact.drag);
    let start = law.dent(&unloading.peak).residual() - contact.touch;
    recorder.points.extend(rows.into_iter().map(|(state, event)| {
        if state.time <= peak_time {
            let slope = || contact.piece_at(state.distance).slope_at(contact.touch + state.distance);
            loading_point(contact.loaded_to(state.distance), slope, drag, &state, event)
        } else {
            let along = Along::Unloading { unloading, drag };
            along.point(&State { distance: state.distance - start, ..state }, event)
        }
    }));
}
