//! Impacts one after the other, on one spot or on fresh ones: a sphere bouncing under gravity, or shots of given speeds.
//!
//! A spot remembers its dent ([`Spot`]): on the same spot the sphere meets it next, at the depth of the dent, so that an
//! impact of no more energy than the last one gave back is elastic. On fresh spots every impact is the first, and a
//! bouncing sphere has to climb out of its dent before it can fall on new surface.
//!
//! Bouncing ends by rule ([`End`]); what would come after the end is estimated, not computed.

pub mod flight;

use std::mem::discriminant;

use crate::impact::{Contact, Fate, Impact, ImpactError, Method, Solver, Spot, Warning};
use flight::Flight;

/// More impacts than anyone will look at.
pub const MOST_IMPACTS: u64 = 1_000_000;

/// Rows of a trace that are recorded in all; impacts after that have none.
pub const MOST_ROWS: usize = 200_000;

/// Where the impacts hit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// All on one spot.
    Same,
    /// Each on surface that nothing has touched.
    Fresh,
}

impl Place {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Same, Self::Fresh];

    /// Its name in scenarios and reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Same => "same",
            Self::Fresh => "fresh",
        }
    }
}

/// What brings the sphere back.
#[derive(Debug, Clone, PartialEq)]
pub enum Drive {
    /// Gravity.
    Bouncing {
        /// g \[m/s²\].
        gravity: f64,
        /// Height of the first fall \[m\]; time then counts from the release, else from first touch.
        drop_height: Option<f64>,
        /// Speed of the first impact \[m/s\].
        speed: f64,
        /// Most impacts.
        most: u64,
        /// Ends before an impact slower than this \[m/s\].
        until: Option<f64>,
    },
    /// One shot after the other, of these speeds \[m/s\]; what happens between them is left open.
    Shots(Vec<f64>),
}

/// A series of impacts to be computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Repeat {
    /// Where.
    pub place: Place,
    /// How.
    pub drive: Drive,
}

/// Why a series ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// All shots are fired.
    Shots,
    /// As many impacts as were asked for.
    Impacts,
    /// The next impact would be slower than `until`.
    Until,
    /// The recovered work cannot lift the sphere, F_m ≤ (n + 1) m g.
    Captured,
    /// The rebound does not lift the sphere out of its dent onto fresh surface.
    InDent,
}

impl End {
    /// Its name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Shots => "shots",
            Self::Impacts => "impacts",
            Self::Until => "until",
            Self::Captured => "captured",
            Self::InDent => "in_dent",
        }
    }
}

/// One impact of a series. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// First touch \[s\]; `None` for shots.
    pub time: Option<f64>,
    /// Impact speed \[m/s\].
    pub speed: f64,
    /// e \[1\]; 0 if captured.
    pub restitution: f64,
    /// e v \[m/s\].
    pub rebound_speed: f64,
    /// F_m \[N\].
    pub peak_force: f64,
    /// δ_m \[m\] from the original surface.
    pub peak_indentation: f64,
    /// δ_r \[m\]: depth of the dent afterwards.
    pub residual_indentation: f64,
    /// How much deeper this impact made it \[m\].
    pub dent_growth: f64,
    /// First touch to separation \[s\]; infinite if captured.
    pub contact_time: f64,
    /// δ at separation \[m\]: that of the dent, or more under viscous damping.
    pub end_indentation: f64,
    /// ½ m v² \[J\].
    pub kinetic_in: f64,
    /// ½ m (e v)² \[J\].
    pub recovered: f64,
    /// Spent on the dent \[J\]; `None` for a half-space without a yield strength.
    pub plastic: Option<f64>,
    /// Taken by damping \[J\], if there is any.
    pub damping: Option<f64>,
    /// Error of the impact's own ledger \[1\].
    pub drift: f64,
    /// Whether the sphere stays in its dent: F_m ≤ (n + 1) m g.
    pub is_captured: bool,
    /// The flight after it, if there is one.
    pub flight: Option<Flight>,
}

/// What came of a series.
#[derive(Debug, Clone, PartialEq)]
pub struct Sequence {
    /// The impacts in order.
    pub hits: Vec<Hit>,
    /// The first of them with their traces.
    pub traced: Vec<Impact>,
    /// The fall before the first impact.
    pub fall: Option<Flight>,
    /// Why it ended.
    pub end: End,
    /// Time from the last separation until the sphere would rest, if the last e held for all bounces to come \[s\]:
    /// (2 v/g)(1 + e + e² + …) = 2 v/(g (1 − e)) with the last rebound speed v. Contact times are left out, and where e rises
    /// as the speed falls this is a lower bound. `None` where it is infinite (e = 1), or nothing bounces.
    pub remaining_time: Option<f64>,
    /// Method of the impacts.
    pub method: Method,
    /// The first warning of each kind, with the number of its impact.
    pub warnings: Vec<(usize, Warning)>,
}

impl Repeat {
    /// Whether the sphere bounces.
    #[must_use]
    pub fn is_bouncing(&self) -> bool {
        matches!(self.drive, Drive::Bouncing { .. })
    }

    /// Computes the impacts one after the other; `samples` rows of each contact are traced, of the first impacts only if
    /// there are many.
    ///
    /// # Errors
    /// [`ImpactError`] of the first impact that has no result.
    pub fn run(&self, contact: &Contact, solver: &Solver, samples: usize) -> Result<Sequence, ImpactError> {
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
        let mut hit = |sequence: &mut Sequence, speed: f64, time: Option<f64>| -> Result<Hit, ImpactError> {
            if self.place == Place::Fresh {
                spot = Spot::fresh();
            }
            let before = contact.dent_depth(&spot);
            let number = sequence.hits.len() + 1;
            let samples = (number <= traced).then_some(samples);
            let impact = strike(contact, &mut spot, speed, solver, samples)?;
            let hit = Hit::of(&impact, time, before);
            sequence.method = impact.method;
            sequence.warn(number, &impact.warnings);
            sequence.hits.push(hit);
            if samples.is_some() {
                sequence.traced.push(impact);
            }
            Ok(hit)
        };
        match self.drive {
            Drive::Shots(ref speeds) => {
                for speed in speeds {
                    hit(&mut sequence, *speed, None)?;
                }
            }
            Drive::Bouncing { gravity, drop_height, speed, most, until } => {
                sequence.fall = drop_height.map(|height| Flight::fall(gravity, height));
                let mut time = sequence.fall.map_or(0.0, |fall| fall.duration);
                let mut speed = speed;
                sequence.end = loop {
                    let hit = hit(&mut sequence, speed, Some(time))?;
                    if hit.is_captured {
                        break End::Captured;
                    }
                    let touch = if self.place == Place::Same { hit.residual_indentation } else { 0.0 };
                    let (begin, from) = (time + hit.contact_time, hit.end_indentation);
                    let Some(flight) = Flight::between(gravity, begin, from, hit.rebound_speed, touch) else {
                        break End::InDent;
                    };
                    if until.is_some_and(|until| flight.landing_speed < until) {
                        break End::Until;
                    }
                    if sequence.hits.len() as u64 >= most {
                        break End::Impacts;
                    }
                    if let Some(last) = sequence.hits.last_mut() {
                        last.flight = Some(flight);
                    }
                    time = flight.begin + flight.duration;
                    speed = flight.landing_speed;
                };
                sequence.remaining_time = sequence.geometric_rest(gravity);
            }
        }
        Ok(sequence)
    }
}

/// One impact on a spot, with a trace if there are samples. The cheapest method takes no steps for the numbers that the
/// next impact depends on, so that a long series gathers no error of steps; its trace is then a run of its own.
fn strike(
    contact: &Contact,
    spot: &mut Spot,
    speed: f64,
    solver: &Solver,
    samples: Option<usize>,
) -> Result<Impact, ImpactError> {
    if !matches!(solver.method, Method::Auto | Method::ClosedForm) {
        return contact.impact_on(spot, speed, solver, samples);
    }
    let mut before = spot.clone();
    let mut impact = contact.impact_on(spot, speed, solver, None)?;
    if samples.is_some() {
        let method = if contact.forces().is_none() { Method::ClosedForm } else { Method::Rk8 };
        impact.trace = contact.impact_on(&mut before, speed, &Solver { method, ..*solver }, samples)?.trace;
    }
    Ok(impact)
}

impl Hit {
    fn of(impact: &Impact, time: Option<f64>, dent_before: f64) -> Self {
        let (energy, under_forces) = (&impact.energy, impact.under_forces.as_ref());
        Self {
            time,
            speed: impact.speed,
            restitution: impact.restitution,
            rebound_speed: impact.rebound_speed,
            peak_force: impact.peak_force,
            peak_indentation: impact.peak_indentation,
            residual_indentation: impact.residual_indentation,
            dent_growth: impact.residual_indentation - dent_before,
            contact_time: impact.contact_time,
            end_indentation: under_forces.map_or(impact.residual_indentation, |forces| forces.end_indentation),
            kinetic_in: energy.kinetic_in,
            recovered: energy.recovered,
            plastic: energy.plastic,
            damping: under_forces.and_then(|forces| forces.damping_loss),
            drift: energy.drift,
            is_captured: under_forces.is_some_and(|forces| forces.fate == Fate::Captured),
            flight: None,
        }
    }

    /// Time of separation \[s\]; `None` for shots and for a captured sphere.
    #[must_use]
    pub fn separation_time(&self) -> Option<f64> {
        self.time.filter(|_| !self.is_captured).map(|time| time + self.contact_time)
    }
}

impl Sequence {
    /// The deepest dent \[m\].
    #[must_use]
    pub fn deepest_dent(&self) -> f64 {
        self.hits.iter().map(|hit| hit.residual_indentation).fold(0.0, f64::max)
    }

    /// Largest drift of the ledgers of the impacts.
    #[must_use]
    pub fn drift(&self) -> f64 {
        self.hits.iter().map(|hit| hit.drift).fold(0.0, f64::max)
    }

    fn warn(&mut self, number: usize, warnings: &[Warning]) {
        for warning in warnings {
            let same = |(_, known): &(usize, Warning)| discriminant(known) == discriminant(warning);
            if !self.warnings.iter().any(same) {
                self.warnings.push((number, *warning));
            }
        }
    }

    fn geometric_rest(&self, gravity: f64) -> Option<f64> {
        let last = self.hits.last().filter(|_| matches!(self.end, End::Impacts | End::Until))?;
        let missing = 1.0 - last.restitution;
        (missing > 0.0).then(|| 2.0 * last.rebound_speed / gravity / missing)
    }
}
