//! Our own stepper for motions with drag: Dormand-Prince 8(5,3) on regularised variables, landed on every event.
//!
//! **Variables.** On a power law d'' = γ − k d^n − drag the force is not smooth at d = 0. With d = r^m and
//! dσ = dt/(m r^(m−1))
//!
//! ```text
//! r' = u,   u' = m r^(m−1) (γ − k r^(mn) − drag),   t' = m r^(m−1)        (' = d/dσ; u is the speed d' = dd/dt)
//! ```
//!
//! For n = 3/2 these are polynomials with m = 2, and with m = 4 where the drag goes with √g'(d), that is with d^¼. On a
//! straight piece m = 1: y = d and σ = t. The loss ∫ drag d' dt is integrated along.
//!
//! **Landing.** A step that has passed an event is taken again with the length that the cubic through both its ends gives,
//! and that length is mended by Newton's method on the step itself, whose derivative the rates are: two or three repeats.
//!
//! **One or many.** What a step has come to is judged in one place, whether steps are taken one by one or in lock step (see
//! [`lockstep`]).

use super::dop853::{self, EVALUATIONS, Quad, Step};
use super::forced::{ForcedIntegrator, ForcedLanding, ForcedPath, ForcedState};
use super::motions::{Hertz, Piece, Power, Straight};
use super::{IntegrationError, Restoring, Sampler, State, Work};
use crate::functions::pow;
use crate::smooth::Variable;
use curves::{Curve, Plain, Rooted};
use run::{Progress, Run, Verdict};

mod curves;
pub mod lockstep;
mod rows;
mod run;

/// The stepper.
#[derive(Debug, Clone)]
pub struct Damped {
    tolerance: f64,
    work: Work,
}

impl Damped {
    /// A stepper with this relative tolerance.
    #[must_use]
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, work: Work::default() }
    }
}

/// One step from a node with its rates, of this length.
#[inline(always)]
fn step<P: Piece>(piece: P, run: &Run, node: &Quad, rates: &Quad, length: f64) -> Step {
    dop853::step(piece, node, rates, length, &run.inverse_sizes)
}

/// Takes every sample due before `end`, the time at the end of a step of this length: by a shorter step of its own.
fn sample<P: Piece>(piece: P, run: &mut Run, samples: &mut Sampler, start: (&Quad, &Quad), length: f64, end: f64) {
    let (node, rates) = start;
    while let Some(time) = samples.due_before(end) {
        // the clock goes with y^m, between straight and this power
        let part = (time - node[2]) / (end - node[2]);
        let mut h = length * if node[0] == 0.0 { pow(part, 1.0 / f64::from(P::ROOT)) } else { part };
        let mut at = *node;
        for _ in 0..30 {
            let next = step(piece, run, node, rates, h);
            run.work.force_evaluations += EVALUATIONS;
            at = next.node;
            let change = (at[2] - time) / next.rates[2];
            let better = (h - change).clamp(0.0, length);
            if !change.is_finite() || change.abs() <= 1e-14 * length || better == h {
                break;
            }
            h = better;
        }
        samples.take(State { time, distance: P::distance_at(at[0]), speed: at[1] });
        samples.losses.push(at[3]);
    }
}

/// A state that had turned where its leg began.
fn turned(state: ForcedState) -> ForcedState {
    ForcedState { state: State { speed: 0.0, ..state.state }, ..state }
}

/// Takes steps until the leg has ended.
fn finish<P: Piece>(
    piece: P,
    run: &mut Run,
    mut samples: Option<&mut Sampler>,
) -> Result<(ForcedLanding, ForcedState), IntegrationError> {
    loop {
        let (node, rates) = (run.node, run.rates);
        let next = step(piece, run, &node, &rates, run.length);
        let verdict = if run.is_marching() { Verdict::of(&next, run.length, run.least) } else { Verdict::NONE };
        let (length, end, landed) = match run.tell(piece, &next, verdict)? {
            Progress::Again => continue,
            Progress::Moved { length } => (length, run.node[2], None),
            Progress::Landed { landing, length, state } => (length, state.state.time, Some((landing, state))),
        };
        if let Some(samples) = samples.as_deref_mut() {
            sample(piece, run, samples, (&node, &rates), length, end);
        }
        if let Some(landed) = landed {
            return Ok(landed);
        }
    }
}

impl Damped {
    fn run<P: Piece>(
        &mut self,
        piece: P,
        path: &ForcedPath,
        state: &mut ForcedState,
        samples: Option<&mut Sampler>,
    ) -> Result<ForcedLanding, IntegrationError> {
        let Some(mut run) = Run::begin(piece, path, state, self.tolerance) else {
            self.work.force_evaluations += 1;
            *state = turned(*state);
            return Ok(ForcedLanding::Turning);
        };
        let landed = finish(piece, &mut run, samples);
        self.work.steps += run.work.steps;
        self.work.rejected += run.work.rejected;
        self.work.force_evaluations += run.work.force_evaluations;
        let (landing, landed) = landed?;
        *state = landed;
        Ok(landing)
    }
}

impl ForcedIntegrator for Damped {
    fn traverse(
        &mut self,
        path: &ForcedPath,
        state: &mut ForcedState,
        samples: Option<&mut Sampler>,
    ) -> Result<ForcedLanding, IntegrationError> {
        let (chi, eta) = path.drag.coefficients();
        let pull = path.pull;
        match path.path.restoring {
            Restoring::Straight { at_start, slope } => {
                self.run(Straight::along(at_start, slope, path), path, state, samples)
            }
            Restoring::Power { coefficient, exponent: 1.5 } if eta == 0.0 => {
                self.run(Hertz::<2>::along(coefficient, path), path, state, samples)
            }
            Restoring::Power { coefficient, exponent: 1.5 } => {
                self.run(Hertz::<4>::along(coefficient, path), path, state, samples)
            }
            Restoring::Power { coefficient: k, exponent: n } => {
                let c = eta * (k * n).sqrt();
                if eta == 0.0 {
                    self.run(Power::<2> { k, n, chi, c, pull }, path, state, samples)
                } else {
                    self.run(Power::<4> { k, n, chi, c, pull }, path, state, samples)
                }
            }
            Restoring::Smooth { force, start, factor } => {
                let curve = Curve { force, start, factor, chi, eta, pull };
                match (force.variable(), eta == 0.0) {
                    (Variable::Indentation, _) => self.run(Plain(curve), path, state, samples),
                    (Variable::RootOfDistance, true) => self.run(Rooted::<2>(curve), path, state, samples),
                    (Variable::RootOfDistance, false) => self.run(Rooted::<4>(curve), path, state, samples),
                }
            }
        }
    }

    fn work(&self) -> Work {
        self.work
    }
}
