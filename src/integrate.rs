//! Integrators for one smooth piece of motion, d'' = −g(d), landed on its end.
//!
//! Nothing here knows bodies, laws or units: of contact mechanics only that a force grows along a piece, and that drag can be
//! made of it or of its slope. A piece is a power law g = k d^n measured from its zero, a straight line, or any
//! other smooth force; a [`Leg`] is the way along it, and an [`Integrator`] carries a state to where the leg ends: at a given distance, or where
//! the speed reaches zero. The state lands *on* the end, so that no step ever crosses a kink.

pub mod damped;
mod dense;
mod dop853;
pub mod exact;
mod field;
pub mod forced;
mod landing;
mod lanes;
pub mod lockstep;
mod motions;
mod nystrom;
pub mod ode_forced;
pub mod ode_solvers;
pub mod pulled;
pub mod rk8;
pub mod verlet;

use thiserror::Error;

/// The deceleration g(d) along one piece, d measured from the start of the piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Restoring {
    /// g = k d^n.
    Power {
        /// k > 0.
        coefficient: f64,
        /// n > 1.
        exponent: f64,
    },
    /// g = g_0 + s d.
    Straight {
        /// g_0 ≥ 0.
        at_start: f64,
        /// s > 0.
        slope: f64,
    },
    /// g = c f.
    Smooth {
        /// f.
        force: crate::smooth::Smooth,
        /// Where the piece begins in the variable of f.
        start: f64,
        /// c > 0.
        factor: f64,
    },
}

impl Restoring {
    /// g(d), continued smoothly a little beyond both ends of the piece.
    #[inline]
    #[must_use]
    pub fn at(&self, distance: f64) -> f64 {
        match *self {
            Self::Power { coefficient, exponent } => coefficient * crate::power::power(distance, exponent),
            Self::Straight { at_start, slope } => at_start + slope * distance,
            Self::Smooth { force, start, factor } => factor * force.value(start, distance),
        }
    }
}

/// Time, distance along the piece, and speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Since first touch.
    pub time: f64,
    /// d, from the start of the piece.
    pub distance: f64,
    /// d'; negative on the way back.
    pub speed: f64,
}

/// The way along one piece: outward until `end` or the turning point, whichever comes first; or back from rest to 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Leg {
    /// Outward from d = 0 with positive speed; the piece ends at this distance (infinite for the last one).
    Outward(f64),
    /// Back from rest to d = 0.
    Back,
}

/// Sizes of the variables, so that one relative tolerance serves all of them: an error is measured against these.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sizes {
    /// Largest distance.
    pub distance: f64,
    /// Largest speed.
    pub speed: f64,
}

/// One smooth piece and the way along it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Path {
    /// The deceleration.
    pub restoring: Restoring,
    /// From where to where.
    pub leg: Leg,
    /// What errors are measured against.
    pub sizes: Sizes,
}

/// Where a leg ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Landing {
    /// At the end of the piece, exactly.
    End,
    /// At speed zero, exactly.
    Turning,
}

/// What the integration cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Work {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the deceleration.
    pub force_evaluations: u64,
}

/// More steps than any leg needs, accepted and rejected, unless its drag is hundreds of times beyond critical: explicit steps
/// are no longer than the fast decay, a creep lasts as long as the slow one, and their ratio goes with the square of the drag.
pub(crate) const MOST_STEPS: u64 = 1_000_000;

/// Why an integration stopped.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum IntegrationError {
    /// The step became too small to advance.
    #[error(
        "step size underflow at dimensionless time {time:e} (step {step:e}); loosen the tolerance or use another method"
    )]
    StepUnderflow {
        /// Where.
        time: f64,
        /// The step.
        step: f64,
    },
    /// More steps than any impact needs.
    #[error(
        "no landing within {steps} steps; loosen the tolerance, lower the damping, or use method = \"auto\", which takes the closed form where there is one"
    )]
    TooManySteps {
        /// The limit.
        steps: u64,
    },
    /// A motion that creeps, damped far beyond critical.
    #[error("no end of the contact within {steps} steps: damped far beyond critical it only creeps; lower the damping")]
    Creeping {
        /// The limit.
        steps: u64,
    },
    /// A state that is no number.
    #[error("the state became infinite or not a number at dimensionless time {time:e}")]
    NotFinite {
        /// Where.
        time: f64,
    },
}

/// Evenly spaced sampling of a motion, filled while it is integrated. Times are absolute, distances those of the leg.
#[derive(Debug, Clone, Default)]
pub struct Sampler {
    interval: f64,
    count: usize,
    next: usize,
    /// The samples of the current leg.
    pub states: Vec<State>,
    /// What drag had taken at each of them, where there is drag.
    pub losses: Vec<f64>,
}

impl Sampler {
    /// Samples at i × `interval`, i = 1 … `count`; the first touch at time 0 is not among them.
    #[must_use]
    pub fn every(interval: f64, count: usize) -> Self {
        Self { interval, count, next: 1, states: Vec::new(), losses: Vec::new() }
    }

    /// The next sample time before `end`, if there is one left.
    #[must_use]
    pub fn due_before(&self, end: f64) -> Option<f64> {
        #[allow(clippy::cast_precision_loss)] // counts below 2^53
        let time = self.interval * self.next as f64;
        (self.next <= self.count && time < end).then_some(time)
    }

    /// Takes the sample that was due.
    pub fn take(&mut self, state: State) {
        self.states.push(state);
        self.next += 1;
    }
}

/// Carries a state along smooth pieces.
pub trait Integrator {
    /// From `state` to where the path ends; `state` is then that landing: distance equal to the end, or speed zero, exactly.
    ///
    /// # Errors
    /// [`IntegrationError`] if the step underflows, the steps run out, or the state is not finite.
    fn traverse(
        &mut self,
        path: &Path,
        state: &mut State,
        samples: Option<&mut Sampler>,
    ) -> Result<Landing, IntegrationError>;

    /// Cost so far.
    fn work(&self) -> Work;
}
