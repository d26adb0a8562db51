//! Many damped impacts in lock step: the batch form of the damped stepper, for sweeps.
//!
//! Lanes do the straight and the Hertz pieces, whatever comes of an impact there. An impact that meets another piece (a law
//! that is no power, or an unloading exponent other than 3/2) leaves its lane and is integrated to its end by itself; so are
//! the last few, when most lanes would idle.

use super::forced::{Course, ForcedOutcome, Load};
use super::with_forces::Scene;
use super::{Contact, Essentials, ImpactError, Method, Solver};
use crate::integrate::IntegrationError;
use crate::integrate::damped::lockstep::{LANES, Landed, Lockstep, Started};
use crate::integrate::pulled::Pulled;
use crate::law::Law;

/// So few impacts under way are done faster one by one.
const FEW: usize = LANES / 8;

/// Integrates every (law, q, forces) at this relative tolerance, those with drag as many at a time as there are lanes; a lane
/// that has finished takes the next case. Each outcome has the bits that [`Pulled`] gives by itself.
#[must_use]
pub fn integrate(cases: &[(&Law, f64, Load)], tolerance: f64) -> Vec<Result<ForcedOutcome, IntegrationError>> {
    let mut alone = Pulled::new(tolerance);
    let mut outcomes = vec![Err(IntegrationError::NotFinite { time: 0.0 }); cases.len()];
    fly::<2>(cases, tolerance, &mut alone, &mut outcomes);
    fly::<4>(cases, tolerance, &mut alone, &mut outcomes);
    for ((law, q, load), outcome) in cases.iter().zip(&mut outcomes) {
        if !Lockstep::<2>::fits(load.drag()) && !Lockstep::<4>::fits(load.drag()) {
            *outcome = Course::begin(law, *q, load, None).finish(&mut alone, None);
        }
    }
    outcomes
}

/// The rows of a table by this solver: impacts of these contacts at these speeds \[m/s\].
#[must_use]
pub fn essentials(impacts: &[(&Contact, f64)], solver: &Solver) -> Vec<Result<Essentials, ImpactError>> {
    let scenes: Vec<Option<Scene>> =
        impacts.iter().map(|(contact, speed)| stepped_scene(contact, *speed, solver)).collect();
    let cases: Vec<_> = scenes.iter().flatten().map(|scene| (scene.law, scene.q, scene.load)).collect();
    let mut outcomes = integrate(&cases, solver.tolerance).into_iter();
    let rows = impacts.iter().zip(&scenes).map(|((contact, speed), scene)| {
        let Some(scene) = scene else { return contact.essentials_by(*speed, solver) };
        // there is one outcome for every scene
        let outcome = outcomes.next().unwrap_or(Err(IntegrationError::NotFinite { time: 0.0 }))?;
        contact.row(*speed, scene, &outcome)
    });
    rows.collect()
}

/// An impact that this solver would step with damping, if it is one.
fn stepped_scene<'a>(contact: &'a Contact, speed: f64, solver: &Solver) -> Option<Scene<'a>> {
    if contact.forces().damping.is_none() || !matches!(solver.method, Method::Rk8 | Method::Auto) {
        return None;
    }
    let scene = contact.scene(None, speed).ok()?;
    (!scene.load.is_conservative()).then_some(scene)
}

/// One impact on its way.
struct Flight<'a> {
    case: usize,
    course: Course<'a>,
}

impl Flight<'_> {
    /// Puts the next leg into a lane. If there is none that the lane can do, this is the outcome.
    fn set_out<const M: u8>(
        &mut self,
        lanes: &mut Lockstep<M>,
        lane: usize,
        alone: &mut Pulled,
    ) -> Option<Result<ForcedOutcome, IntegrationError>> {
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

    /// On from where a leg has landed. The outcome, if that is the end.
    fn go_on<const M: u8>(
        &mut self,
        landed: Landed,
        lanes: &mut Lockstep<M>,
        lane: usize,
        alone: &mut Pulled,
    ) -> Option<Result<ForcedOutcome, IntegrationError>> {
        let (landing, at) = match landed {
            Ok(landed) => landed,
            Err(error) => return Some(Err(error)),
        };
        self.course.at = at;
        match self.course.landed(landing, None) {
            Some(outcome) => Some(Ok(outcome)),
            None => self.set_out(lanes, lane, alone),
        }
    }

    /// The rest by itself.
    fn finish(&mut self, landed: Landed, alone: &mut Pulled) -> Result<ForcedOutcome, IntegrationError> {
        let (landing, at) = landed?;
        self.course.at = at;
        match self.course.landed(landing, None) {
            Some(outcome) => Ok(outcome),
            None => self.course.finish(alone, None),
        }
    }
}

/// Integrates the cases whose drag is that of these lanes.
fn fly<const M: u8>(
    cases: &[(&Law, f64, Load)],
    tolerance: f64,
    alone: &mut Pulled,
    outcomes: &mut [Result<ForcedOutcome, IntegrationError>],
) {
    let mut waiting = (0..cases.len()).filter(|case| Lockstep::<M>::fits(cases[*case].2.drag())).peekable();
    if waiting.peek().is_none() {
        return;
    }
    let mut lanes = Lockstep::<M>::new(tolerance);
    // starts the next case in a lane
    let mut launch = |lanes: &mut Lockstep<M>, lane, alone: &mut Pulled, outcomes: &mut [_]| loop {
        let case = waiting.next()?;
        let (law, q, load) = &cases[case];
        let mut flight = Flight { case, course: Course::begin(law, *q, load, None) };
        match flight.set_out(lanes, lane, alone) {
            Some(outcome) => outcomes[case] = outcome,
            None => return Some(flight),
        }
    };
    let mut flights: Vec<_> = (0..LANES).map(|lane| launch(&mut lanes, lane, alone, outcomes)).collect();
    let mut under_way = flights.iter().flatten().count();
    // lanes are empty only when no case is left
    while under_way > FEW {
        lanes.step();
        for (lane, slot) in flights.iter_mut().enumerate() {
            let Some(flight) = slot else { continue };
            let Some(landed) = lanes.tell(lane) else { continue };
            if let Some(outcome) = flight.go_on(landed, &mut lanes, lane, alone) {
                outcomes[flight.case] = outcome;
                *slot = launch(&mut lanes, lane, alone, outcomes);
                under_way -= usize::from(slot.is_none());
            }
        }
    }
    for (lane, slot) in flights.iter_mut().enumerate() {
        if let (Some(flight), Some(landed)) = (slot, lanes.finish(lane)) {
            outcomes[flight.case] = flight.finish(landed, alone);
        }
    }
}
