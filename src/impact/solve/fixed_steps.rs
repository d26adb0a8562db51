//! One impact in fixed steps: the loop over the steps of `verlet.rs`, the end of the contact, and the result.
//!
//! A time in whole steps would hide the error of the motion, so the two times of the outcome lie within a step. Maximum compression
//! is where the speed and the acceleration of the deepest step lead to zero speed. Separation is found by following the free
//! flight after the last step back to the contact. Without damping both times are accurate to second order in the step, like the
//! motion. [`FixedSteps`] has the times that a code with this step finds.

use super::outcome::{FixedSteps, ImpactEnd, ScaledResult, Solution};
use super::recorder::sample_times;
use super::verlet::{AfterRelaxation, VerletMotion};
use crate::contact::law::{Surface, Unloading};
use crate::impact::problem::forces::ScaledForces;
use crate::impact::problem::scales::FORCE_FACTOR;
use crate::numerics::ode::{DenseOutput, IntegrationError, MotionState, SolverStats};
use crate::numerics::power::nan_max;

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
    let mut run = FixedStepRun::new(VerletMotion::new(ground, q, forces, step), q, forces, trace.is_some());
    for _ in 0..most_steps {
        let before = run.motion.state;
        let (force, total) = run.advance()?;
        if let Some(end) = run.end(force, total) {
            return run.finish(&before, end, trace);
        }
    }
    Err(IntegrationError::TooManyFixedSteps { steps: most_steps })
}

/// A motion in steps of equal length, with what its result needs from all steps.
struct FixedStepRun<'a> {
    motion: VerletMotion<'a>,
    q: f64,
    forces: &'a ScaledForces,
    /// The deepest step.
    peak: MotionState,
    /// The time of zero speed near the deepest step.
    turning_time: f64,
    largest_force: f64,
    /// The motion in every step, for a trace.
    track: Option<Vec<DenseOutput>>,
}

impl<'a> FixedStepRun<'a> {
    fn new(motion: VerletMotion<'a>, q: f64, forces: &'a ScaledForces, has_trace: bool) -> Self {
        let peak = motion.state;
        Self { motion, q, forces, peak, turning_time: 0.0, largest_force: 0.0, track: has_trace.then(Vec::new) }
    }

    /// Makes a step; returns the force of the law and the total force.
    fn advance(&mut self) -> Result<(f64, f64), IntegrationError> {
        let Self { motion, peak, .. } = self;
        let (before, acceleration) = (motion.state, motion.acceleration);
        let (force, total) = motion.advance();
        let MotionState { time, distance, speed, .. } = motion.state;
        if !(distance.is_finite() && speed.is_finite()) {
            return Err(IntegrationError::NotFinite { time });
        }
        if let Some(track) = &mut self.track {
            track.push(parabolic_output(before, acceleration, time));
        }
        self.largest_force = nan_max(self.largest_force, total);
        if distance > peak.distance && motion.contact.after_relaxation == AfterRelaxation::NotYet {
            *peak = motion.state;
            let (acceleration, step) = (motion.acceleration, motion.step);
            let until = if acceleration < 0.0 { (speed / -acceleration).clamp(-step, step) } else { 0.0 };
            self.turning_time = time + until;
        }
        Ok((force, total))
    }

    /// True if the last step lies behind the deepest one.
    fn is_rebounding(&self) -> bool {
        self.motion.state.time > self.peak.time
    }

    /// The unloading branch from the deepest step.
    fn unloading(&self) -> Unloading {
        self.motion.contact.branch_from(self.peak.distance)
    }

    /// How the run ends with the last step, in which the law and all forces push like this; `None` if another step follows.
    fn end(&self, force: f64, total: f64) -> Option<ImpactEnd> {
        let Self { motion, forces, .. } = self;
        let (is_back, speed) = (self.is_rebounding(), motion.state.speed);
        // the total force of Hunt and Crossley vanishes before the force of the law only through rounding or a coarse step
        let pushes = if forces.damping.can_lift_off() { total } else { force };
        if is_back && pushes == 0.0 && speed < 0.0 {
            let is_captured = forces.is_captured(&self.unloading(), self.q);
            return Some(if is_captured { ImpactEnd::Captured } else { ImpactEnd::Separated });
        }
        let moves_inwards = is_back && speed >= 0.0 && motion.contact.after_relaxation != AfterRelaxation::Approaching;
        let stays = moves_inwards || forces.weight > 0.0 && self.stays_under_weight(force);
        stays.then_some(ImpactEnd::Captured)
    }

    /// True if the weight holds the sphere in the contact, whose law pushes with this force.
    fn stays_under_weight(&self, force: f64) -> bool {
        let forces = self.forces;
        if forces.is_conservative() {
            self.is_rebounding() && forces.is_captured(&self.unloading(), self.q) && force <= forces.weight
        } else {
            // an overdamped sphere creeps up to its static indentation
            let contact = &self.motion.contact;
            let point = forces.static_equilibrium(contact.ground, &self.unloading());
            let indentation = contact.touch + self.motion.state.distance;
            let rest = forces.rest_criterion(&point, point.indentation);
            rest.is_some_and(|rest| rest.excess(indentation, self.motion.state.speed) <= 0.0)
        }
    }

    /// The solution of a run that ends so, in the step from `before`.
    fn finish(
        mut self,
        before: &MotionState,
        end: ImpactEnd,
        trace: Option<(usize, Option<f64>)>,
    ) -> Result<Solution, IntegrationError> {
        let (unloading, weight) = (self.unloading(), self.forces.weight);
        let VerletMotion { step, count: steps, state: last, .. } = self.motion;
        let loading_time = if self.is_rebounding() { self.turning_time } else { self.peak.time };
        let contact = &mut self.motion.contact;
        let separates = end == ImpactEnd::Separated;
        let state = match end {
            ImpactEnd::Separated => {
                contact.separation_within_step(before, &last, step, FORCE_FACTOR * weight, &unloading)
            }
            ImpactEnd::Captured => last,
        };
        let restitution = if separates { -state.speed / self.q } else { 0.0 };
        // under gravity a slow sphere that sinks into its dent separates faster than it arrived
        let makes_energy = weight == 0.0 && restitution > MAX_RESTITUTION;
        if separates && steps < MIN_STEPS || makes_energy {
            return Err(IntegrationError::CoarseSteps { steps, restitution });
        }
        let outcome = ScaledResult {
            unloading,
            restitution,
            largest_force: contact.ground.reported_force(&unloading, Some(self.largest_force)),
            loading_time: loading_time.min(state.time),
            contact_time: state.time,
            end,
            end_indentation: contact.touch + state.distance,
            end_speed: state.speed,
            loss: state.loss / FORCE_FACTOR,
        };
        let trace_points = trace.map_or_else(Vec::new, |(samples, duration)| {
            let times = sample_times(samples, duration.unwrap_or(outcome.contact_time));
            contact.points(&outcome, &self.peak, self.track.as_deref().unwrap_or_default(), times)
        });
        Ok(Solution {
            outcome,
            // one evaluation a step, and one at first contact
            stats: SolverStats { steps, rejected: 0, force_evaluations: steps + 1 },
            fixed_steps: Some(FixedSteps {
                step,
                compression_time: self.peak.time,
                separation_time: separates.then_some(last.time),
            }),
            trace_points,
        })
    }
}

/// The motion in a step that begins in this state and ends at this time.
fn parabolic_output(from: MotionState, acceleration: f64, end: f64) -> DenseOutput {
    DenseOutput::new(end, move |time| {
        let t = time - from.time;
        let distance = from.distance + t * (from.speed + 0.5 * acceleration * t);
        MotionState { time, distance, speed: from.speed + acceleration * t, loss: from.loss }
    })
}
