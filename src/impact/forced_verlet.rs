//! An impact under forces by velocity Verlet in fixed steps, as DEM codes do it: no landing, kinks stepped over.

use super::course::Event;
use super::forced::{Fate, ForcedOutcome, Load, equilibrium};
use super::forced_trace::{ForcedPoint, ForcedRecorder, On, drag_force};
use super::scales::ACCELERATION;
use crate::integrate::forced::ForcedState;
use crate::integrate::{IntegrationError, State, Work};
use crate::law::{Law, Unloading};
use crate::power::max_or_nan;

/// The law as a code with fixed steps evaluates it: the largest indentation so far is its memory.
struct Remembering<'a> {
    law: &'a Law,
    load: &'a Load,
    deepest: f64,
    unloading: Option<Unloading>,
}

impl<'a> Remembering<'a> {
    fn of(law: &'a Law, load: &'a Load) -> Self {
        let branch = law.branch().copied();
        Self { law, load, deepest: branch.map_or(0.0, |branch| branch.peak.indentation), unloading: branch }
    }
}

impl Remembering<'_> {
    /// Force of the law, and what damping adds to it, both in units of Φ.
    fn at(&mut self, x: f64, speed: f64) -> (f64, f64) {
        let (force, slope) = if x > self.deepest || x == self.deepest && self.unloading.is_none() {
            self.deepest = x;
            self.unloading = None;
            let piece = &self.law.loading.pieces()[self.law.loading.index_at(x)];
            (piece.force_at(x), piece.slope_at(x))
        } else {
            let law = self.law;
            let deepest = self.deepest;
            let unloading = self.unloading.get_or_insert_with(|| law.unloading(law.loaded_to(deepest)));
            let distance = (x - unloading.peak.residual()).max(0.0);
            (unloading.force(x), unloading.slope_after(distance))
        };
        (force, drag_force(self.load.drag(), force, slope, speed))
    }
}

/// Marches in steps of `step`; the force of damping is that of the speed half a step before. The peak is the deepest step,
/// separation the first step on the way out without a pushing force, capture the first with a speed inwards again.
///
/// # Errors
/// [`IntegrationError::TooManySteps`] if there is no end within `most_steps`.
pub fn march(
    law: &Law,
    q: f64,
    load: &Load,
    step: f64,
    most_steps: u64,
    work: &mut Work,
    recorder: Option<&mut ForcedRecorder>,
) -> Result<ForcedOutcome, IntegrationError> {
    let mut law_with_memory = Remembering::of(law, load);
    let touch = law.touch();
    let mut state = State { time: 0.0, distance: touch, speed: q };
    let (mut acceleration, mut loss) = (ACCELERATION * load.weight, 0.0);
    let mut peak = ForcedState { state: State { time: 0.0, distance: touch, speed: 0.0 }, loss: 0.0 };
    let mut samples: Vec<(ForcedState, Option<Event>)> = vec![(ForcedState { state, loss }, Some(Event::Touch))];
    let mut sampler = recorder.as_ref().map(|recorder| recorder.sampler.clone());
    work.force_evaluations += 1;
    for n in 1..=most_steps {
        let half = state.speed + 0.5 * step * acceleration;
        let distance = state.distance + step * half;
        #[allow(clippy::cast_precision_loss)] // counts below 2^53
        let time = step * n as f64;
        if let Some(sampler) = &mut sampler {
            while let Some(due) = sampler.due_before(time) {
                let t = due - state.time;
                let moved = t * (state.speed + 0.5 * acceleration * t);
                let at = State { time: due, distance: state.distance + moved, speed: state.speed + acceleration * t };
                sampler.take(at);
                samples.push((ForcedState { state: at, loss }, None));
            }
        }
        let (force, of_damping) = law_with_memory.at(distance, half);
        work.steps += 1;
        work.force_evaluations += 1;
        let total = max_or_nan(force + of_damping, 0.0);
        acceleration = ACCELERATION * (load.weight - total);
        loss += ACCELERATION * (total - force) * half * step;
        state = State { time, distance, speed: half + 0.5 * step * acceleration };
        if distance > peak.state.distance {
            peak = ForcedState { state: State { time, distance, speed: 0.0 }, loss };
        }
        if !(distance.is_finite() && state.speed.is_finite()) {
            return Err(IntegrationError::NotFinite { time });
        }
        let is_back = time > peak.state.time;
        let unloading = law.unloading(law.loaded_to(peak.state.distance));
        let lifts_off = is_back && total == 0.0 && state.speed < 0.0;
        let is_slower = is_back && state.speed >= 0.0;
        let is_out = load.is_conservative() && load.captures(&unloading, q) && is_back && force <= load.weight;
        let creeps = load.weight > 0.0 && !load.is_conservative() && creeps(law, load, &unloading, &state);
        if lifts_off || is_slower || is_out || creeps {
            let fate = if lifts_off && !load.captures(&unloading, q) { Fate::Separated } else { Fate::Captured };
            if let Some(recorder) = recorder {
                let end = if fate == Fate::Captured { Event::Captured } else { Event::Separation };
                samples.push((peak, Some(Event::Peak)));
                samples.push((ForcedState { state, loss }, Some(end)));
                samples.sort_by(|a, b| a.0.state.time.total_cmp(&b.0.state.time));
                record(law, load, &unloading, peak.state.time, &samples, recorder);
            }
            return Ok(ForcedOutcome {
                unloading,
                restitution: if fate == Fate::Captured { 0.0 } else { -state.speed / q },
                loading_time: peak.state.time,
                end: state,
                fate,
                loss: loss / ACCELERATION,
            });
        }
    }
    Err(IntegrationError::TooManySteps { steps: most_steps })
}

/// Whether an overdamped sphere has come near its static indentation.
fn creeps(law: &Law, load: &Load, unloading: &Unloading, state: &State) -> bool {
    let (at, slope) = if unloading.peak.force < load.weight {
        let (x, index) = equilibrium(law, load.weight);
        let piece = &law.loading.pieces()[index];
        (x - law.touch(), piece.slope_at(x))
    } else {
        let approach = load.static_approach(unloading);
        (approach, load.static_slope(unloading, approach))
    };
    let distance = (state.distance - load.static_indentation(law, unloading)).abs();
    load.creep(at, slope).is_some_and(|creep| distance <= creep.within && state.speed.abs() <= creep.below)
}

/// Points of the trace from states with x itself as their distance.
fn record(
    law: &Law,
    load: &Load,
    unloading: &Unloading,
    peak_time: f64,
    states: &[(ForcedState, Option<Event>)],
    recorder: &mut ForcedRecorder,
) {
    let drag = load.drag();
    for (at, event) in states {
        let State { time, distance: x, .. } = at.state;
        let (on, start) = if time <= peak_time {
            let index = law.loading.index_at(x);
            let piece = &law.loading.pieces()[index];
            (On::Piece { law, index, drag }, piece.start - piece.shape.lead())
        } else {
            (On::Unloading { unloading, drag }, law.dent(&unloading.peak).residual())
        };
        let along = ForcedState { state: State { distance: x - start, ..at.state }, ..*at };
        recorder.points.push(ForcedPoint { event: *event, ..on.point(&along) });
    }
}
