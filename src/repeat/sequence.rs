//! What came of a series: its impacts, why it ended, and what would come after.

use std::mem::discriminant;

use super::flight::Flight;
use crate::impact::{Fate, Impact, Method, Warning};
use crate::math::power::max_or_nan;

/// Why a series ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// All shots are fired.
    Shots,
    /// As many impacts as were asked for.
    Impacts,
    /// The next impact would be slower than `until`.
    Until,
    /// The sphere does not leave; without damping, as the recovered work cannot lift it, F_m ≤ (n + 1) m g.
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
    /// Elastic energy left at separation under viscous damping \[J\].
    pub stored_at_separation: Option<f64>,
    /// Error of the impact's own ledger \[1\].
    pub drift: f64,
    /// Whether the sphere does not leave: without damping F_m ≤ (n + 1) m g.
    pub is_captured: bool,
    /// δ where a captured sphere comes to rest \[m\].
    pub static_indentation: Option<f64>,
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
    /// as the speed falls this is a lower bound. `None` where it is infinite (e of 1 or more), or nothing bounces.
    pub remaining_time: Option<f64>,
    /// Method of the impacts.
    pub method: Method,
    /// The first warning of each kind, with the number of its impact.
    pub warnings: Vec<(usize, Warning)>,
}

impl Hit {
    pub(super) fn of(impact: &Impact, time: Option<f64>, dent_before: f64) -> Self {
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
            stored_at_separation: under_forces.and_then(|forces| forces.stored_at_separation),
            drift: energy.drift,
            static_indentation: under_forces.and_then(|forces| forces.static_indentation),
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
        self.hits.iter().map(|hit| hit.residual_indentation).fold(0.0, max_or_nan)
    }

    /// Largest drift of the ledgers of the impacts.
    #[must_use]
    pub fn drift(&self) -> f64 {
        self.hits.iter().map(|hit| hit.drift).fold(0.0, max_or_nan)
    }

    pub(super) fn warn(&mut self, number: usize, warnings: &[Warning]) {
        for warning in warnings {
            let same = |(_, known): &(usize, Warning)| discriminant(known) == discriminant(warning);
            if !self.warnings.iter().any(same) {
                self.warnings.push((number, *warning));
            }
        }
    }

    pub(super) fn geometric_rest(&self, gravity: f64) -> Option<f64> {
        let last = self.hits.last().filter(|_| matches!(self.end, End::Impacts | End::Until))?;
        let missing = 1.0 - last.restitution;
        (missing > 0.0).then(|| 2.0 * last.rebound_speed / gravity / missing)
    }
}
