//! Velocity Verlet with a fixed step over the whole law, as DEM codes do it: no landing, kinks stepped over, separation
//! noticed at the first step without force.

use super::{IntegrationError, Sampler, State, Work};

/// A force with memory: the deceleration at a distance, which may remember the largest one it has seen.
pub trait Deceleration {
    /// At a distance; called once a step, in order of time.
    fn at(&mut self, distance: f64) -> f64;
}

/// What a fixed-step run sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Run {
    /// The first state without force, on the way out.
    pub end: State,
    /// Time of the step with the largest distance.
    pub peak_time: f64,
    /// Largest distance at a step.
    pub peak_distance: f64,
}

/// Marches from distance 0 at `speed` in steps of `step` until the deceleration is zero on the way out.
///
/// # Errors
/// [`IntegrationError::TooManySteps`] if that has not happened after `most_steps`.
pub fn march(
    deceleration: &mut impl Deceleration,
    speed: f64,
    step: f64,
    most_steps: u64,
    work: &mut Work,
    mut samples: Option<&mut Sampler>,
) -> Result<Run, IntegrationError> {
    let mut state = State { time: 0.0, distance: 0.0, speed };
    let mut g = deceleration.at(0.0);
    let (mut peak_time, mut peak_distance) = (0.0, 0.0);
    work.force_evaluations += 1;
    for n in 1..=most_steps {
        let half = state.speed - 0.5 * step * g;
        let distance = state.distance + step * half;
        #[allow(clippy::cast_precision_loss)] // counts below 2^53
        let time = step * n as f64;
        if let Some(samples) = samples.as_deref_mut() {
            while let Some(due) = samples.due_before(time) {
                let t = due - state.time;
                let (distance, speed) = (state.distance + t * (state.speed - 0.5 * g * t), state.speed - g * t);
                samples.take(State { time: due, distance, speed });
            }
        }
        g = deceleration.at(distance);
        state = State { time, distance, speed: half - 0.5 * step * g };
        work.steps += 1;
        work.force_evaluations += 1;
        if distance > peak_distance {
            (peak_time, peak_distance) = (time, distance);
        }
        if g == 0.0 && state.speed < 0.0 {
            return Ok(Run { end: state, peak_time, peak_distance });
        }
        if !state.distance.is_finite() {
            return Err(IntegrationError::NotFinite { time });
        }
    }
    Err(IntegrationError::TooManySteps { steps: most_steps })
}
