//! The stepper of rk8 for motions with drag: Dormand-Prince 8(5,3) on regularised variables, landed on every event.
//!
//! **Landing.** A step that has passed an event is repeated with another length: first the one at which the cubic through
//! both its ends is zero, then the one that Newton's method gives, with the rates at the end as derivative. As a rule the
//! distance to the event is far below the tolerance after two repeats. The end is then moved onto it along its rates.

use super::dop853::{self, EVALUATIONS};
use super::piece::power::{DraggedHertz, DraggedPower};
use super::piece::smooth::DraggedCurve;
use super::piece::straight::DraggedStraight;
use super::piece::{Dragged, Quad};
use super::{IntegrationError, Integrator, Landing, Path, Restoring, Sampler, State, Work};
use crate::math::functions::pow;
use crate::math::smooth::Variable;
use run::{Progress, Run, Verdict};

pub(super) mod run;

/// The stepper.
#[derive(Debug, Clone)]
pub struct Damped {
    tolerance: f64,
    work: Work,
}

impl Damped {
    /// A stepper with this relative tolerance.
    pub fn new(tolerance: f64) -> Self {
        Self { tolerance, work: Work::default() }
    }
}

/// Takes every sample that is due before `end`, the time at the end of a step of this length. Each sample is the end of a
/// shorter step of its own.
fn sample<P: Dragged>(piece: P, run: &mut Run, samples: &mut Sampler, start: (&Quad, &Quad), length: f64, end: f64) {
    let (node, rates) = start;
    while let Some(time) = samples.due_before(end) {
        // first guess of the length: from y = 0 the time grows with y^m, elsewhere about in proportion
        let part = (time - node[2]) / (end - node[2]);
        let mut h = length * if node[0] == 0.0 { pow(part, 1.0 / f64::from(P::ROOT)) } else { part };
        let mut at = *node;
        for _ in 0..30 {
            let next = dop853::step(piece, node, rates, h, &run.inverse_sizes);
            run.work.force_evaluations += EVALUATIONS;
            at = next.node;
            let miss = at[2] - time;
            let change = miss / next.rates[2];
            let better = (h - change).clamp(0.0, length);
            // a step that is short beside the time itself cannot hit it better than time is rounded
            let is_there = miss.abs() <= f64::EPSILON * time || change.abs() <= 1e-14 * length;
            if !change.is_finite() || is_there || better == h {
                break;
            }
            h = better;
        }
        samples.take(State { time, distance: P::distance_at(at[0]), speed: at[1], loss: at[3] });
    }
}

/// Takes steps until the leg has ended.
pub(super) fn finish<P: Dragged>(
    piece: P,
    run: &mut Run,
    mut samples: Option<&mut Sampler>,
) -> Result<(Landing, State), IntegrationError> {
    loop {
        let (node, rates) = (run.node, run.rates);
        let next = dop853::step(piece, &node, &rates, run.length, &run.inverse_sizes);
        let verdict = if run.is_marching() { Verdict::of(&next, run.length, run.least) } else { Verdict::NONE };
        let (length, end, landed) = match run.tell(piece, &next, verdict)? {
            Progress::Again => continue,
            Progress::Moved { length } => (length, run.node[2], None),
            Progress::Landed { landing, length, state } => (length, state.time, Some((landing, state))),
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
    fn run<P: Dragged>(
        &mut self,
        piece: P,
        path: &Path,
        state: &mut State,
        samples: Option<&mut Sampler>,
    ) -> Result<Landing, IntegrationError> {
        let Some(mut run) = Run::begin(piece, path, state, self.tolerance) else {
            self.work.force_evaluations += 1;
            state.speed = 0.0;
            return Ok(Landing::Turning);
        };
        let landed = finish(piece, &mut run, samples);
        self.work = self.work + run.work;
        let (landing, landed) = landed?;
        *state = landed;
        Ok(landing)
    }
}

impl Damped {
    /// Along any piece. On curves that begin without force r = d^(1/M): M = 4 where the drag goes with the stiffness, else 2.
    fn in_root<const M: u8>(
        &mut self,
        path: &Path,
        state: &mut State,
        samples: Option<&mut Sampler>,
    ) -> Result<Landing, IntegrationError> {
        match path.restoring {
            Restoring::Straight { at_start, slope } => {
                self.run(DraggedStraight::along(at_start, slope, path), path, state, samples)
            }
            Restoring::Power { coefficient, exponent: 1.5 } => {
                self.run(DraggedHertz::<M>::along(coefficient, path), path, state, samples)
            }
            Restoring::Power { coefficient, exponent } => {
                self.run(DraggedPower::<M>::along(coefficient, exponent, path), path, state, samples)
            }
            Restoring::Smooth { force, start, factor } => match force.variable() {
                Variable::Indentation => {
                    self.run(DraggedCurve::<1>::along(force, start, factor, path), path, state, samples)
                }
                Variable::RootOfDistance => {
                    self.run(DraggedCurve::<M>::along(force, start, factor, path), path, state, samples)
                }
            },
        }
    }
}

impl Integrator for Damped {
    fn traverse(
        &mut self,
        path: &Path,
        state: &mut State,
        samples: Option<&mut Sampler>,
    ) -> Result<Landing, IntegrationError> {
        if path.drag.eta == 0.0 {
            self.in_root::<2>(path, state, samples)
        } else {
            self.in_root::<4>(path, state, samples)
        }
    }

    fn work(&self) -> Work {
        self.work
    }
}
