//! Series of impacts, on one spot or on fresh spots: a sphere bouncing under gravity, or shots of given speeds.
//!
//! A spot remembers its dent ([`Spot`]). On the same spot the next contact begins at the depth of the dent, so an impact with no
//! more energy than the last one recovered is elastic. On fresh spots every impact meets original surface, and a bouncing
//! sphere must rise out of its dent before it can fall on new surface.
//!
//! Bouncing ends by rule ([`SeriesEnd`]). The motion after the end is estimated, not computed.
//!
//! [`Surface`](crate::contact::law::Surface) states when an impact on a used spot is elastic. A second equal shot is not
//! elastic: it is as deep as one impact at √(2 − e²) times the speed. Equal shots deepen the dent less and less, until its branch
//! can store their whole energy.
//!
//! Time counts from the release if there is a drop height, otherwise from first contact. Impacts are computed by the closed form if
//! possible, so that a long series accumulates no error of steps. Under damping, and with `method = "rk8"`, impacts are
//! integrated with the tolerance of the solver.

pub mod result;
pub mod spot;

use super::flight::free_flight::FreeFlight;
use super::flight::trajectory::Flight;
use crate::files::progress::Progress;
use crate::impact::{Approach, Contact, Impact, ImpactError, Method, Solver, Spot};
use crate::strings::names::named_enum;
pub use result::{SeriesEnd, SeriesImpact, SeriesResult};

/// The largest number of impacts that a scenario may ask for.
pub const MAX_IMPACTS: u64 = 1_000_000;

/// Maximum number of recorded rows of all traces; later impacts have no trace.
pub const MAX_TRACE_ROWS: usize = 200_000;

named_enum! {
    /// The spots of the impacts.
    pub enum SpotMode {
        Same = "same",
        Fresh = "fresh",
    }
}

/// The kind of series: the sphere bounces, or it is shot repeatedly.
#[derive(Debug, Clone, PartialEq)]
pub enum SeriesMode {
    Bouncing {
        /// g \[m/s²\].
        gravity: f64,
        /// Height of the first fall \[m\]. Time counts from the release; without a height, from first contact.
        drop_height: Option<f64>,
        /// The first impact. A ball with an angle or a spin hops along the surface.
        approach: Approach,
        most: u64,
        /// The series ends before an impact slower than this \[m/s\]; the first impact is always computed.
        until: Option<f64>,
    },
    /// Shots at these speeds \[m/s\]; the motion between them is not computed.
    Shots(Vec<f64>),
}

/// The input of a series of impacts.
#[derive(Debug, Clone, PartialEq)]
pub struct ImpactSeries {
    pub spot_mode: SpotMode,
    pub mode: SeriesMode,
}

impl ImpactSeries {
    /// True if the sphere bounces.
    pub fn is_bouncing(&self) -> bool {
        matches!(self.mode, SeriesMode::Bouncing { .. })
    }

    /// Computes the impacts one after the other. The counter counts them, and may stop them. Each contact is traced with `samples` rows;
    /// in a long series only the first impacts are traced.
    ///
    /// # Errors
    /// [`ImpactError`] of the first impact that has no result.
    pub fn run(
        &self,
        contact: &Contact,
        solver: &Solver,
        samples: usize,
        progress: Option<&Progress>,
    ) -> Result<SeriesResult, ImpactError> {
        let unwatched = Progress::default();
        let progress = progress.unwrap_or(&unwatched);
        progress.add_total(match &self.mode {
            SeriesMode::Bouncing { most, .. } => *most,
            SeriesMode::Shots(speeds) => speeds.len() as u64,
        });
        let traced = (MAX_TRACE_ROWS / (2 * samples).max(1)).max(1);
        let mut sequence = SeriesResult {
            impacts: Vec::new(),
            traced_impacts: Vec::new(),
            fall: None,
            end: SeriesEnd::Shots,
            remaining_time: None,
            method: solver.method,
            warnings: Vec::new(),
        };
        let mut spot = Spot::new();
        let mut hit =
            |sequence: &mut SeriesResult, approach: Approach, time: Option<f64>| -> Result<SeriesImpact, ImpactError> {
                if self.spot_mode == SpotMode::Fresh {
                    spot = Spot::new();
                }
                let before = contact.dent_depth(&spot);
                let number = sequence.impacts.len() + 1;
                let samples = (number <= traced).then_some(samples);
                let impact = impact_on_spot(contact, &mut spot, approach, solver, samples)?;
                let hit = SeriesImpact::new(&impact, approach, time, before);
                sequence.method = impact.method;
                sequence.push_warnings(number, &impact.warnings);
                sequence.impacts.push(hit);
                progress.advance();
                if samples.is_some() {
                    sequence.traced_impacts.push(impact);
                }
                Ok(hit)
            };
        match self.mode {
            SeriesMode::Shots(ref speeds) => {
                for speed in speeds.iter().take_while(|_| !progress.is_stopped()) {
                    hit(&mut sequence, (*speed).into(), None)?;
                }
            }
            SeriesMode::Bouncing { gravity, drop_height, approach, most, until } => {
                let flying = contact.forces().flight.unwrap_or(FreeFlight::in_vacuum(gravity));
                sequence.fall = drop_height.map(|height| Flight::from_drop(flying, height));
                let mut time = sequence.fall.map_or(0.0, |fall| fall.duration);
                let (mut approach, mut position) = (approach, 0.0);
                sequence.end = loop {
                    let hit = hit(&mut sequence, approach, Some(time))?;
                    sequence.impacts.last_mut().into_iter().for_each(|last| last.position = position);
                    if hit.is_captured() {
                        break SeriesEnd::Captured;
                    }
                    let touch = if self.spot_mode == SpotMode::Same { hit.residual_indentation } else { 0.0 };
                    let (begin, from) = (time + hit.contact_time, hit.end_indentation());
                    let Some(flight) = Flight::from_rebound(flying, begin, from, hit.rebound_speed, touch) else {
                        // without a dent, or on the same spot, the sphere falls back into its contact
                        let in_dent = self.spot_mode == SpotMode::Fresh && hit.residual_indentation > 0.0;
                        break if in_dent { SeriesEnd::InDent } else { SeriesEnd::Captured };
                    };
                    if until.is_some_and(|until| flight.landing_speed < until) {
                        break SeriesEnd::Until;
                    }
                    if sequence.impacts.len() as u64 >= most || progress.is_stopped() {
                        break SeriesEnd::Impacts;
                    }
                    let flight = flight
                        .with_tangential_motion(position + hit.tangential_travel(), hit.rebound_tangential_speed());
                    if let Some(last) = sequence.impacts.last_mut() {
                        last.flight = Some(flight);
                    }
                    time = flight.begin + flight.duration;
                    position = flight.position_at(flight.duration);
                    approach = hit.next_approach(flight.landing_speed);
                };
                sequence.remaining_time = sequence.estimated_rest(&flying);
            }
        }
        sequence.warnings.sort_by_key(|(_, warning)| !warning.is_fatal());
        Ok(sequence)
    }
}

/// One impact on a spot, with a trace if samples are requested. For the method `auto`, the next impact depends only on the closed
/// form, if it exists, so that a long series accumulates no error of steps. The trace is then a separate run.
fn impact_on_spot(
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
        let method = Method::ClosedForm.resolve(contact.forces(), true).unwrap_or(Method::Rk8);
        impact.trace = contact.impact_on(&mut before, approach, &Solver { method, ..*solver }, samples)?.trace;
    }
    Ok(impact)
}
