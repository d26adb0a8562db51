//! Impacts one after the other, on one spot or on fresh ones: a sphere bouncing under gravity, or shots of given speeds.
//!
//! A spot remembers its dent ([`Spot`]): on the same spot the sphere meets it next, at the depth of the dent, so that an
//! impact of no more energy than the last one gave back is elastic. On fresh spots every impact is the first, and a
//! bouncing sphere has to climb out of its dent before it can fall on new surface.
//!
//! Bouncing ends by rule ([`End`]). What would come after the end is estimated, not computed.
//!
//! [`law::Ground`](crate::contact::law::Ground) says what a spot remembers, and when an impact on it is elastic. So a second
//! equal shot is not elastic: it goes as deep as one impact of √(2 − e²) times the speed. Equal shots deepen the dent less and
//! less, up to the one whose branch holds their whole energy.
//!
//! Time counts from the release if there is a drop height, else from first touch. Numbers come from the closed form where
//! there is one, so that a long series gathers no error of steps: 10⁵ bounces of an elastic ball end with the speed of the
//! first to the last bit. Under damping, and with `method = "rk8"`, impacts are stepped. The energy balance of 100 bounces from
//! 3 m/s on steel closes to 2e-15 without damping, to 1e-11 with Hunt-Crossley damping (χ = 0.02 s/m), and to 5e-12 with
//! viscous damping (ζ = 0.002), at a tolerance of 1e-10.

pub mod flight;
pub mod sequence;

use crate::files::progress::Counter;
use crate::impact::air::Flying;
use crate::impact::{Approach, Contact, Impact, ImpactError, Method, Solver, Spot};
use crate::units::names::named;
use flight::Flight;
pub use sequence::{End, Hit, Sequence};

/// The largest number of impacts that a scenario may ask for.
pub const MOST_IMPACTS: u64 = 1_000_000;

/// Rows of a trace that are recorded in all; impacts after that have none.
pub const MOST_ROWS: usize = 200_000;

named! {
    /// Where the impacts hit.
    pub enum Place {
        Same = "same",
        Fresh = "fresh",
    }
}

/// The reason why the sphere hits again: it falls back, or it is shot again.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    Bouncing {
        /// g \[m/s²\].
        gravity: f64,
        /// Height of the first fall \[m\]; time then counts from the release, else from first touch.
        drop_height: Option<f64>,
        /// The first impact. A ball that comes at an angle, or spins, hops along.
        approach: Approach,
        most: u64,
        /// Ends before an impact slower than this \[m/s\]; the first one is always run.
        until: Option<f64>,
    },
    /// One shot after the other, of these speeds \[m/s\]; what happens between them is left open.
    Shots(Vec<f64>),
}

/// A series of impacts to be computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Repeat {
    pub place: Place,
    pub drive: Drive,
}

impl Repeat {
    /// True if the sphere bounces.
    pub fn is_bouncing(&self) -> bool {
        matches!(self.drive, Drive::Bouncing { .. })
    }

    /// Computes the impacts one after the other. A counter counts them, and may stop them. `samples` rows of each contact are
    /// traced, of the first impacts only if there are many.
    ///
    /// # Errors
    /// [`ImpactError`] of the first impact that has no result.
    pub fn run(
        &self,
        contact: &Contact,
        solver: &Solver,
        samples: usize,
        progress: Option<&Counter>,
    ) -> Result<Sequence, ImpactError> {
        let unwatched = Counter::default();
        let progress = progress.unwrap_or(&unwatched);
        progress.expect(match &self.drive {
            Drive::Bouncing { most, .. } => *most,
            Drive::Shots(speeds) => speeds.len() as u64,
        });
        let traced = (MOST_ROWS / (2 * samples).max(1)).max(1);
        let mut sequence = Sequence {
            hits: Vec::new(),
            traced: Vec::new(),
            fall: None,
            end: End::Shots,
            remaining_time: None,
            method: solver.method,
            warnings: Vec::new(),
        };
        let mut spot = Spot::fresh();
        let mut hit = |sequence: &mut Sequence, approach: Approach, time: Option<f64>| -> Result<Hit, ImpactError> {
            if self.place == Place::Fresh {
                spot = Spot::fresh();
            }
            let before = contact.dent_depth(&spot);
            let number = sequence.hits.len() + 1;
            let samples = (number <= traced).then_some(samples);
            let impact = strike(contact, &mut spot, approach, solver, samples)?;
            let hit = Hit::of(&impact, approach, time, before);
            sequence.method = impact.method;
            sequence.warn(number, &impact.warnings);
            sequence.hits.push(hit);
            progress.step();
            if samples.is_some() {
                sequence.traced.push(impact);
            }
            Ok(hit)
        };
        match self.drive {
            Drive::Shots(ref speeds) => {
                for speed in speeds.iter().take_while(|_| !progress.is_stopped()) {
                    hit(&mut sequence, (*speed).into(), None)?;
                }
            }
            Drive::Bouncing { gravity, drop_height, approach, most, until } => {
                let flying = contact.forces().flying.unwrap_or(Flying::in_vacuum(gravity));
                sequence.fall = drop_height.map(|height| Flight::fall(flying, height));
                let mut time = sequence.fall.map_or(0.0, |fall| fall.duration);
                let (mut approach, mut position) = (approach, 0.0);
                sequence.end = loop {
                    let hit = hit(&mut sequence, approach, Some(time))?;
                    sequence.hits.last_mut().into_iter().for_each(|last| last.position = position);
                    if hit.is_captured() {
                        break End::Captured;
                    }
                    let touch = if self.place == Place::Same { hit.residual_indentation } else { 0.0 };
                    let (begin, from) = (time + hit.contact_time, hit.end_indentation());
                    let Some(flight) = Flight::between(flying, begin, from, hit.rebound_speed, touch) else {
                        // without a dent, or on the same spot, it falls back into the contact that it has left
                        let in_dent = self.place == Place::Fresh && hit.residual_indentation > 0.0;
                        break if in_dent { End::InDent } else { End::Captured };
                    };
                    if until.is_some_and(|until| flight.landing_speed < until) {
                        break End::Until;
                    }
                    if sequence.hits.len() as u64 >= most || progress.is_stopped() {
                        break End::Impacts;
                    }
                    let flight = flight.along(position + hit.way_in_contact(), hit.rebound_along());
                    if let Some(last) = sequence.hits.last_mut() {
                        last.flight = Some(flight);
                    }
                    time = flight.begin + flight.duration;
                    position = flight.position_at(flight.duration);
                    approach = hit.next_approach(flight.landing_speed);
                };
                sequence.remaining_time = sequence.estimated_rest(&flying);
            }
        }
        sequence.warnings.sort_by_key(|(_, warning)| !warning.is_grave());
        Ok(sequence)
    }
}

/// One impact on a spot, with a trace if there are samples. The method `auto` takes the closed form, if there is one, for the
/// numbers that the next impact depends on, so that a long series gathers no error of steps. The trace is then another run.
fn strike(
    contact: &Contact,
    spot: &mut Spot,
    approach: Approach,
    solver: &Solver,
    samples: Option<usize>,
) -> Result<Impact, ImpactError> {
    if !matches!(solver.method, Method::Auto | Method::ClosedForm) {
        return contact.impact_on(spot, approach, solver, samples);
    }
    let mut before = spot.clone();
    let mut impact = contact.impact_on(spot, approach, solver, None)?;
    if samples.is_some() {
        let method = Method::ClosedForm.chosen(contact.forces(), true).unwrap_or(Method::Rk8);
        impact.trace = contact.impact_on(&mut before, approach, &Solver { method, ..*solver }, samples)?.trace;
    }
    Ok(impact)
}
