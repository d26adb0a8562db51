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
        let mut run = SeriesRun {
            contact,
            solver,
            samples,
            spot_mode: self.spot_mode,
            spot: Spot::new(),
            progress,
            result: SeriesResult {
                impacts: Vec::new(),
                fall: None,
                end: SeriesEnd::Shots,
                remaining_time: None,
                method: solver.method,
                warnings: Vec::new(),
            },
        };
        match self.mode {
            SeriesMode::Shots(ref speeds) => {
                for speed in speeds.iter().take_while(|_| !progress.is_stopped()) {
                    let hit = run.next_impact((*speed).into(), None, [0.0; 2])?;
                    run.result.impacts.push(hit);
                }
            }
            SeriesMode::Bouncing { gravity, drop_height, approach, most, until } => {
                let flying = contact.forces().flight.unwrap_or(FreeFlight::in_vacuum(gravity));
                run.result.fall = drop_height.map(|height| Flight::from_drop(flying, height));
                run.result.end = run.bounce(&flying, approach, most, until)?;
                run.result.remaining_time = run.result.estimated_rest(&flying);
            }
        }
        run.result.warnings.sort_by_key(|(_, warning)| !warning.is_fatal());
        Ok(run.result)
    }
}

/// A series during its computation.
struct SeriesRun<'a> {
    contact: &'a Contact,
    solver: &'a Solver,
    /// Rows of the trace of one impact.
    samples: usize,
    spot_mode: SpotMode,
    spot: Spot,
    progress: &'a Progress,
    result: SeriesResult,
}

impl SeriesRun<'_> {
    /// Computes the next impact, at this time and position.
    fn next_impact(
        &mut self,
        approach: Approach,
        time: Option<f64>,
        position: [f64; 2],
    ) -> Result<SeriesImpact, ImpactError> {
        if self.spot_mode == SpotMode::Fresh {
            self.spot = Spot::new();
        }
        let before = self.contact.dent_depth(&self.spot);
        let number = self.result.impacts.len() + 1;
        let traced = (MAX_TRACE_ROWS / (2 * self.samples).max(1)).max(1);
        let samples = (number <= traced).then_some(self.samples);
        let mut impact = impact_on_spot(self.contact, &mut self.spot, approach, self.solver, samples)?;
        self.result.method = impact.method;
        self.result.push_warnings(number, &std::mem::take(&mut impact.warnings));
        self.progress.advance();
        Ok(SeriesImpact::new(impact, approach, time, position, before))
    }

    /// The flight after an impact that ends at this time, or the reason why no flight follows.
    fn flight_after(&self, hit: &SeriesImpact, end: f64, flying: &FreeFlight) -> Result<Flight, SeriesEnd> {
        if hit.is_captured() {
            return Err(SeriesEnd::Captured);
        }
        let (dent, is_fresh) = (hit.impact.row.residual_indentation, self.spot_mode == SpotMode::Fresh);
        let touch = if is_fresh { 0.0 } else { dent };
        let flight = Flight::from_rebound(*flying, end, hit.end_indentation(), hit.rebound_speed, touch);
        // without a dent, or on the same spot, the sphere falls back into its contact
        let flight = flight.ok_or(if is_fresh && dent > 0.0 { SeriesEnd::InDent } else { SeriesEnd::Captured })?;
        Ok(flight.with_tangential_motion(hit.end_position(), hit.rebound_tangential_velocity()))
    }

    /// Bounces until the series ends by rule; returns the reason.
    fn bounce(
        &mut self,
        flying: &FreeFlight,
        mut approach: Approach,
        most: u64,
        until: Option<f64>,
    ) -> Result<SeriesEnd, ImpactError> {
        let (mut time, mut position) = (self.result.fall.map_or(0.0, |fall| fall.duration), [0.0; 2]);
        loop {
            let mut hit = self.next_impact(approach, Some(time), position)?;
            let flight = self.flight_after(&hit, time + hit.impact.row.contact_time, flying);
            let is_last = self.result.impacts.len() as u64 + 1 >= most || self.progress.is_stopped();
            let flight = match flight {
                Ok(flight) if until.is_some_and(|until| flight.landing_speed < until) => Err(SeriesEnd::Until),
                Ok(_) if is_last => Err(SeriesEnd::Impacts),
                flight => flight,
            };
            hit.flight = flight.ok();
            if let Ok(flight) = flight {
                (time, position) = (flight.begin + flight.duration, flight.position_at(flight.duration));
                approach = hit.next_approach(flight.landing_speed);
            }
            self.result.impacts.push(hit);
            if let Err(end) = flight {
                return Ok(end);
            }
        }
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
