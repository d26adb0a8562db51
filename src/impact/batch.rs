//! Many impacts in lock step: the batch form of rk8, for sweeps of scenes that need stepping.
//!
//! Lanes integrate the straight and the Hertz pieces, without gravity and damping or with damping. An impact that comes to
//! another piece (a force that is no power law, or an unloading exponent other than 3/2) leaves its lane and is integrated
//! alone to its end. Two more kinds are integrated alone: the last few impacts, when most lanes would be idle, and impacts
//! under gravity without damping. Each outcome has the same bits as that of rk8 alone.

use super::course::Course;
use super::outcome::Outcome;
use super::scaled_forces::ScaledForces;
use crate::integrate::lockstep::conservative::Conservative;
use crate::integrate::lockstep::damped::Damped;
use crate::integrate::lockstep::{LANES, Lanes, Started};
use crate::integrate::rk8::Rk8;
use crate::integrate::{Drag, IntegrationError};
use crate::law::Law;

/// An impact to be integrated: law, q = v/V, and what acts beside the law.
pub type Problem<'a> = (&'a Law, f64, ScaledForces);

/// Integrates every impact at this relative tolerance, as many at a time as there are lanes; a lane that has finished takes
/// the next one.
pub fn integrate(problems: &[Problem], tolerance: f64) -> Vec<Result<Outcome, IntegrationError>> {
    let mut outcomes = vec![Err(IntegrationError::NotFinite { time: 0.0 }); problems.len()];
    each(problems, tolerance, |index, outcome| outcomes[index] = outcome.copied().map_err(Clone::clone));
    outcomes
}

/// As [`integrate`], but calls `put` with each outcome as soon as it is known: in any order, with its index in `problems`.
pub fn each(problems: &[Problem], tolerance: f64, mut put: impl FnMut(usize, Result<&Outcome, &IntegrationError>)) {
    let mut alone = Rk8::new(tolerance);
    let drag = |problem: &Problem| problem.2.drag();
    fly(problems, |problem| problem.2.is_none(), || Conservative::new(tolerance), &mut alone, &mut put);
    fly(problems, |problem| Damped::<2>::fits(drag(problem)), || Damped::<2>::new(tolerance), &mut alone, &mut put);
    fly(problems, |problem| Damped::<4>::fits(drag(problem)), || Damped::<4>::new(tolerance), &mut alone, &mut put);
    for (index, (law, q, forces)) in problems.iter().enumerate() {
        if !forces.is_none() && forces.drag() == Drag::NONE {
            put(index, Course::begin(law, *q, forces, None).finish(&mut alone, None).as_ref());
        }
    }
}

/// One impact on its way.
struct InLane<'a> {
    index: usize,
    course: Course<'a>,
}

impl InLane<'_> {
    /// Puts the next leg into a lane, unless the impact has ended. A leg that the lane cannot integrate, and all legs after
    /// it, are integrated alone. True if the lane is taken.
    fn set_out(&mut self, lanes: &mut impl Lanes, lane: usize, alone: &mut Rk8) -> Result<bool, IntegrationError> {
        while !self.course.has_ended() {
            match lanes.start(lane, &self.course.path, &mut self.course.at) {
                Started::UnderWay => return Ok(true),
                Started::Foreign => drop(self.course.finish(alone, None)?),
                Started::Landed(landing) => self.course.landed(landing, None),
            }
        }
        Ok(false)
    }

    /// Hands over the outcome, or why there is none.
    fn put<T>(
        &self,
        ended: &Result<T, IntegrationError>,
        put: &mut impl FnMut(usize, Result<&Outcome, &IntegrationError>),
    ) {
        match (ended, self.course.outcome()) {
            (Err(error), _) => put(self.index, Err(error)),
            (Ok(_), Some(outcome)) => put(self.index, Ok(&outcome)),
            (Ok(_), None) => {}
        }
    }
}

/// Integrates the impacts that `fits` picks in these lanes.
fn fly<'a, L: Lanes, P: FnMut(usize, Result<&Outcome, &IntegrationError>)>(
    problems: &'a [Problem<'a>],
    fits: impl Fn(&Problem) -> bool,
    new_lanes: impl FnOnce() -> L,
    alone: &mut Rk8,
    put: &mut P,
) {
    let mut waiting = (0..problems.len()).filter(|index| fits(&problems[*index])).peekable();
    if waiting.peek().is_none() {
        return;
    }
    let mut lanes = new_lanes();
    // starts the next impact in a lane, if one is left; it is made in its slot, because it is large and moving it costs time
    let mut launch = |lane, slot: &mut Option<InLane<'a>>, lanes: &mut L, alone: &mut Rk8, put: &mut P| {
        *slot = None;
        for index in waiting.by_ref() {
            let (law, q, forces): &'a Problem = &problems[index];
            let flying = slot.insert(InLane { index, course: Course::begin(law, *q, forces, None) });
            match flying.set_out(lanes, lane, alone) {
                Ok(true) => return,
                ended => flying.put(&ended, put),
            }
            *slot = None;
        }
    };
    let mut flying = [const { None }; LANES];
    for (lane, slot) in flying.iter_mut().enumerate() {
        launch(lane, slot, &mut lanes, alone, put);
    }
    let mut under_way = flying.iter().flatten().count();
    // lanes are empty only when no impact is left
    while under_way > L::FEW {
        if !lanes.step() {
            continue;
        }
        for (lane, slot) in flying.iter_mut().enumerate() {
            let Some(impact) = slot else { continue };
            let course = &mut impact.course;
            let Some(landed) = lanes.take_landing(lane, &course.path, &mut course.at) else { continue };
            let goes_on = landed.and_then(|landing| {
                impact.course.landed(landing, None);
                impact.set_out(&mut lanes, lane, alone)
            });
            if goes_on != Ok(true) {
                impact.put(&goes_on, put);
                launch(lane, slot, &mut lanes, alone, put);
                under_way -= usize::from(slot.is_none());
            }
        }
    }
    for (lane, impact) in flying.iter_mut().enumerate().filter_map(|(lane, slot)| Some((lane, slot.as_mut()?))) {
        if let Some(landed) = lanes.finish(lane, &mut impact.course.at) {
            let ended = landed.and_then(|landing| {
                impact.course.landed(landing, None);
                if impact.course.has_ended() { Ok(()) } else { impact.course.finish(alone, None).map(drop) }
            });
            impact.put(&ended, put);
        }
    }
}
