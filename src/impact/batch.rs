//! Many impacts in lock step: the batch form of rk8, for sweeps of scenes that need stepping.

use super::course::{self, entry_of, loading_sizes, unloading_from, way_back, way_out};
use super::outcome::Outcome;
use super::{Contact, Essentials, ImpactError, Solver, forced_batch};
use crate::integrate::lockstep::{LANES, Lockstep};
use crate::integrate::rk8::Rk8;
use crate::integrate::{IntegrationError, Integrator, Landing, Leg, MOST_STEPS, Sizes, State};
use crate::law::curve::Shape;
use crate::law::{Law, Unloading};

/// Where the impact of a lane is.
#[derive(Debug, Clone, Copy)]
enum Phase {
    Loading { piece: usize, sizes: Sizes },
    Unloading { unloading: Unloading, loading_time: f64 },
}

/// One impact on its way.
#[derive(Debug, Clone, Copy)]
struct Flight {
    case: usize,
    phase: Phase,
    /// The common step before which it began.
    begun: u64,
}

/// Lanes whose state is no number, or that go on for ever, are looked for once in so many common steps.
const LOOK: u64 = 1024;

/// Integrates every (law, q) with rk8 at this relative tolerance, as many at a time as there are lanes; a lane that has
/// finished takes the next case. Each outcome has the bits that rk8 gives by itself.
#[must_use]
pub fn integrate(cases: &[(&Law, f64)], tolerance: f64) -> Vec<Result<Outcome, IntegrationError>> {
    let mut lockstep = Lockstep::new(tolerance);
    let mut alone = Rk8::new(tolerance);
    let mut outcomes = vec![Err(IntegrationError::NotFinite { time: 0.0 }); cases.len()];
    let mut flights: [Option<Flight>; LANES] = [None; LANES];
    let mut next = 0;
    let mut under_way = 0;
    let mut steps = 0;
    for ((law, speed), outcome) in cases.iter().zip(&mut outcomes).filter(|((law, _), _)| !fits_lanes(law)) {
        *outcome = course::integrate(law, *speed, &mut alone, None);
    }
    for (lane, flight) in flights.iter_mut().enumerate() {
        *flight = launch(&mut lockstep, lane, cases, &mut next, steps);
        under_way += usize::from(flight.is_some());
    }
    while under_way > 0 {
        steps += 1;
        let has_landed = lockstep.step();
        let looks = steps.is_multiple_of(LOOK);
        if !has_landed && !looks {
            continue;
        }
        for (lane, slot) in flights.iter_mut().enumerate() {
            let Some(flight) = slot else { continue };
            let ended = match lockstep.take_landing(lane) {
                Some((landing, state)) => {
                    let outcome = go_on(&mut lockstep, &mut alone, lane, cases, flight, landing, state);
                    outcome.map(|outcome| outcomes[flight.case] = outcome).is_some()
                }
                None if looks && (!lockstep.is_number(lane) || steps - flight.begun >= MOST_STEPS) => {
                    // by itself it says what is wrong, or does not fail
                    let (law, speed) = cases[flight.case];
                    outcomes[flight.case] = course::integrate(law, speed, &mut alone, None);
                    true
                }
                None => false,
            };
            if ended {
                *slot = launch(&mut lockstep, lane, cases, &mut next, steps);
                under_way -= usize::from(slot.is_none());
            }
        }
    }
    outcomes
}

/// The rows of a table: impacts of these contacts at these speeds \[m/s\]. Without gravity and damping by rk8 at the
/// tolerance of the solver, with them by its method.
#[must_use]
pub fn essentials(impacts: &[(&Contact, f64)], solver: &Solver) -> Vec<Result<Essentials, ImpactError>> {
    if impacts.iter().any(|(contact, _)| !contact.forces().is_none()) {
        return forced_batch::essentials(impacts, solver);
    }
    let scaled: Vec<_> = impacts.iter().map(|(contact, speed)| contact.scaled(*speed)).collect();
    let cases: Vec<_> = scaled.iter().flatten().map(|(_, law, q)| (*law, *q)).collect();
    let mut outcomes = integrate(&cases, solver.tolerance).into_iter();
    let rows = scaled.into_iter().zip(impacts).map(|(scaled, (contact, speed))| {
        let (scales, law, _) = scaled?;
        // there is one outcome for every case that could be scaled
        let outcome = outcomes.next().unwrap_or(Err(IntegrationError::NotFinite { time: 0.0 }))?;
        law.accept(&outcome.unloading.peak)?;
        Essentials::new(contact, *speed, &scales, law, &outcome)
    });
    rows.collect()
}

/// Whether lanes can do the loading curve: Hertz and straight pieces.
fn fits_lanes(law: &Law) -> bool {
    law.loading.pieces().iter().all(|piece| match piece.shape {
        Shape::Power { exponent, .. } => exponent == 1.5,
        Shape::Straight { .. } => true,
        Shape::LatePower { .. } | Shape::Smooth(_) => false,
    })
}

/// Starts the next case that fits, if there is one, in a lane.
fn launch(lockstep: &mut Lockstep, lane: usize, cases: &[(&Law, f64)], next: &mut usize, begun: u64) -> Option<Flight> {
    let case = *next + cases.get(*next..)?.iter().position(|(law, _)| fits_lanes(law))?;
    let (law, speed) = cases[case];
    *next = case + 1;
    let sizes = loading_sizes(law, speed);
    let mut path = way_out(law, 0, sizes);
    if law.stays_on_branch(0.4 * speed * speed, 0.0) {
        path.leg = Leg::Outward(f64::INFINITY);
    }
    let started = lockstep.start(lane, &path, &State { time: 0.0, distance: 0.0, speed });
    started.then_some(Flight { case, phase: Phase::Loading { piece: 0, sizes }, begun })
}

/// The next leg of a flight that has landed, or its outcome.
fn go_on(
    lockstep: &mut Lockstep,
    alone: &mut Rk8,
    lane: usize,
    cases: &[(&Law, f64)],
    flight: &mut Flight,
    landing: Landing,
    mut state: State,
) -> Option<Result<Outcome, IntegrationError>> {
    let (law, speed) = cases[flight.case];
    let finish = |unloading, loading_time, state: &State| Outcome {
        unloading,
        restitution: -state.speed / speed,
        loading_time,
        contact_time: state.time,
    };
    match flight.phase {
        Phase::Unloading { unloading, loading_time } => Some(Ok(finish(unloading, loading_time, &state))),
        Phase::Loading { ref mut piece, sizes } if landing == Landing::End => {
            *piece += 1;
            state.distance = entry_of(law, *piece);
            let _ = lockstep.start(lane, &way_out(law, *piece, sizes), &state);
            None
        }
        Phase::Loading { piece, .. } => {
            let unloading = unloading_from(law, piece, state.distance);
            let loading_time = state.time;
            let back = way_back(&unloading);
            state = State { time: loading_time, distance: unloading.peak.elastic_approach, speed: 0.0 };
            if lockstep.start(lane, &back, &state) {
                flight.phase = Phase::Unloading { unloading, loading_time };
                return None;
            }
            // an exponent that lanes cannot do
            let landed = alone.traverse(&back, &mut state, None);
            Some(landed.map(|_| finish(unloading, loading_time, &state)))
        }
    }
}
