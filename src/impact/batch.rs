//! Many impacts in lock step: the batch form of rk8, for sweeps of scenes that need stepping.
//!
//! Lanes do the straight and the Hertz pieces, without gravity and damping or with damping. An impact that meets another
//! piece (a law that is no power, or an unloading exponent other than 3/2) leaves its lane and is integrated to its end by
//! itself; so are the last few, when most lanes would idle, and impacts that no lanes are for. Each outcome has the bits
//! that rk8 gives by itself.

use super::course::Course;
use super::outcome::Outcome;
use super::scaled_forces::ScaledForces;
use crate::integrate::lockstep::conservative::Conservative;
use crate::integrate::lockstep::damped::Damped;
use crate::integrate::lockstep::{LANES, Landed, Lanes, Started};
use crate::integrate::rk8::Rk8;
use crate::integrate::{Drag, IntegrationError};
use crate::law::Law;

/// An impact to be integrated: law, q = v/V, and what acts beside the law.
pub type Problem<'a> = (&'a Law, f64, ScaledForces);

/// Integrates every impact at this relative tolerance, as many at a time as there are lanes; a lane that has finished takes
/// the next one.
#[must_use]
pub fn integrate(problems: &[Problem], tolerance: f64) -> Vec<Result<Outcome, IntegrationError>> {
    let mut alone = Rk8::new(tolerance);
    let mut outcomes = vec![Err(IntegrationError::NotFinite { time: 0.0 }); problems.len()];
    let drag = |problem: &Problem| problem.2.drag();
    fly(problems, |problem| problem.2.is_none(), || Conservative::new(tolerance), &mut alone, &mut outcomes);
    fly(
        problems,
        |problem| Damped::<2>::fits(drag(problem)),
        || Damped::<2>::new(tolerance),
        &mut alone,
        &mut outcomes,
    );
    fly(
        problems,
        |problem| Damped::<4>::fits(drag(problem)),
        || Damped::<4>::new(tolerance),
        &mut alone,
        &mut outcomes,
    );
    for ((law, q, forces), outcome) in problems.iter().zip(&mut outcomes) {
        if !forces.is_none() && forces.drag() == Drag::NONE {
            *outcome = Course::begin(law, *q, forces, None).finish(&mut alone, None);
        }
    }
    outcomes
}

/// One impact on its way.
struct InLane<'a> {
    index: usize,
    course: Course<'a>,
}

impl InLane<'_> {
    /// Puts the next leg into a lane. If there is none that the lane can do, this is the outcome.
    fn set_out(
        &mut self,
        lanes: &mut impl Lanes,
        lane: usize,
        alone: &mut Rk8,
    ) -> Option<Result<Outcome, IntegrationError>> {
        loop {
            let (landing, at) = match lanes.start(lane, self.course.path(), &self.course.at) {
                Started::UnderWay => return None,
                Started::Foreign => return Some(self.course.finish(alone, None)),
                Started::Landed(landing, at) => (landing, at),
            };
            self.course.at = at;
            if let Some(outcome) = self.course.landed(landing, None) {
                return Some(Ok(outcome));
            }
        }
    }

    /// On to the start of the next leg from where one has landed. The outcome, if that is the end.
    fn go_on(&mut self, landed: Landed) -> Option<Result<Outcome, IntegrationError>> {
        match landed {
            Ok((landing, at)) => {
                self.course.at = at;
                self.course.landed(landing, None).map(Ok)
            }
            Err(error) => Some(Err(error)),
        }
    }
}

/// Integrates the impacts that `fits` picks in these lanes.
fn fly<L: Lanes>(
    problems: &[Problem],
    fits: impl Fn(&Problem) -> bool,
    new_lanes: impl FnOnce() -> L,
    alone: &mut Rk8,
    outcomes: &mut [Result<Outcome, IntegrationError>],
) {
    let mut waiting = (0..problems.len()).filter(|index| fits(&problems[*index])).peekable();
    if waiting.peek().is_none() {
        return;
    }
    let mut lanes = new_lanes();
    // starts the next impact in a lane
    let mut launch = |lanes: &mut L, lane, alone: &mut Rk8, outcomes: &mut [_]| loop {
        let index = waiting.next()?;
        let (law, q, forces) = &problems[index];
        let mut flying = InLane { index, course: Course::begin(law, *q, forces, None) };
        match flying.set_out(lanes, lane, alone) {
            Some(outcome) => outcomes[index] = outcome,
            None => return Some(flying),
        }
    };
    let mut flying: Vec<_> = (0..LANES).map(|lane| launch(&mut lanes, lane, alone, outcomes)).collect();
    let mut under_way = flying.iter().flatten().count();
    // lanes are empty only when no impact is left
    while under_way > L::FEW {
        if !lanes.step() {
            continue;
        }
        for (lane, slot) in flying.iter_mut().enumerate() {
            let Some(impact) = slot else { continue };
            let Some(landed) = lanes.take_landing(lane) else { continue };
            if let Some(outcome) = impact.go_on(landed).or_else(|| impact.set_out(&mut lanes, lane, alone)) {
                outcomes[impact.index] = outcome;
                *slot = launch(&mut lanes, lane, alone, outcomes);
                under_way -= usize::from(slot.is_none());
            }
        }
    }
    for (lane, slot) in flying.iter_mut().enumerate() {
        if let (Some(impact), Some(landed)) = (slot, lanes.finish(lane)) {
            outcomes[impact.index] = impact.go_on(landed).unwrap_or_else(|| impact.course.finish(alone, None));
        }
    }
}
