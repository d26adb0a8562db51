//! The results of a series: its impacts, why it ended, and an estimate of what would follow.

use crate::impact::flight::free_flight::FreeFlight;
use crate::impact::flight::trajectory::Flight;
use crate::impact::{
    Approach, CrossMotion, ForcesResult, Impact, ImpactEnd, Method, TangentialMotion, Warning, WaveguideKind,
};
use crate::numerics::power::nan_max;
use crate::strings::names::named_enum;

named_enum! {
    /// Why a series ended.
    pub enum SeriesEnd {
        /// The list of shots is finished.
        Shots = "shots",
        /// The requested number of impacts is reached.
        Impacts = "impacts",
        /// The next impact would be slower than `until`.
        Until = "until",
        /// The sphere does not separate. Without damping this happens if the recovered work cannot lift the sphere, F_m ≤ (n + 1) m g.
        /// Under viscous damping, or after losses by waves, the sphere may separate, but not rise high enough to leave the spot.
        Captured = "captured",
        /// The rebound does not lift the sphere out of its dent onto the requested fresh surface.
        InDent = "in_dent",
    }
}

/// One impact of a series. SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct SeriesImpact {
    /// Time of first contact \[s\]; `None` for shots.
    pub time: Option<f64>,
    /// Position of this impact on the surface \[m\]: along the path of the first impact, and to the left of this path.
    pub position: [f64; 2],
    /// How the sphere comes in.
    pub approach: Approach,
    /// The impact. Its warnings are those of the series, and only the first impacts have a trace.
    pub impact: Impact,
    /// Take-off speed of the flight \[m/s\]: e v, where e includes the loss by waves if the half-space has a density.
    pub rebound_speed: f64,
    /// Growth of the dent depth in this impact \[m\].
    pub dent_growth: f64,
    pub flight: Option<Flight>,
}

/// The results of a series.
#[derive(Debug, Clone, PartialEq)]
pub struct SeriesResult {
    pub impacts: Vec<SeriesImpact>,
    /// The fall before the first impact.
    pub fall: Option<Flight>,
    pub end: SeriesEnd,
    /// Time from the last separation until rest, if the last e held for all later bounces \[s\]:
    /// (2 v/g)(1 + e + e² + …) = 2 v/(g (1 − e)) with the last rebound speed v; in air the sum of the flights in air. Contact times are
    /// not included, and if e rises as the speed falls, this is a lower bound. `None` if the time is infinite (e of 1 or more), if
    /// more than 10 000 flights in air would follow, or if nothing bounces.
    pub remaining_time: Option<f64>,
    pub method: Method,
    /// The first warning of each kind, with the number of its impact.
    pub warnings: Vec<(usize, Warning)>,
}

impl SeriesImpact {
    pub(super) fn new(
        impact: Impact,
        approach: Approach,
        time: Option<f64>,
        position: [f64; 2],
        dent_before: f64,
    ) -> Self {
        let rebound_speed = impact.row.measured_restitution() * approach.normal;
        let dent_growth = impact.row.residual_indentation - dent_before;
        Self { time, position, approach, impact, rebound_speed, dent_growth, flight: None }
    }

    /// The energy of the rebound \[J\], without that of the waves.
    pub fn recovered_energy(&self) -> f64 {
        let restitution = self.impact.row.measured_restitution();
        self.impact.row.kinetic_in * (restitution * restitution)
    }

    /// Tangential velocity and spin before the impact, if the sphere comes at an angle or spins.
    pub fn tangential(&self) -> Option<TangentialMotion> {
        self.approach.friction.map(|_| self.approach.tangential)
    }

    /// The motion out of the first plane of incidence before the impact, if the sphere has a spin out of this plane.
    pub fn cross_motion(&self) -> Option<CrossMotion> {
        self.tangential()?.cross
    }

    /// This motion after the impact; `None` for a captured sphere.
    pub fn cross_motion_after(&self) -> Option<CrossMotion> {
        self.impact.row.rebound?.tangential.cross
    }

    /// Tangential velocity after the impact \[m/s\].
    pub(super) fn rebound_tangential_velocity(&self) -> [f64; 2] {
        self.impact.row.rebound.map_or([0.0; 2], |rebound| rebound.tangential.velocity())
    }

    /// The place on the surface at separation \[m\], with the mean of the velocities before and after during the contact.
    pub(super) fn end_position(&self) -> [f64; 2] {
        let before = self.tangential().map_or([0.0; 2], |motion| motion.velocity());
        let after = self.rebound_tangential_velocity();
        [0, 1].map(|axis| self.position[axis] + 0.5 * (before[axis] + after[axis]) * self.impact.row.contact_time)
    }

    /// The approach of the next impact, for this landing speed. The flight changes neither the tangential velocity nor the spin.
    pub(super) fn next_approach(&self, landing_speed: f64) -> Approach {
        let tangential = self.impact.row.rebound.map_or(self.approach.tangential, |rebound| rebound.tangential);
        Approach { normal: landing_speed, tangential, ..self.approach }
    }

    /// The energy that elastic waves carry away \[J\], if the half-space has a density.
    pub fn radiated_energy(&self) -> Option<f64> {
        let row = &self.impact.row;
        row.wave_loss_fraction.map(|_| (row.recovered_fraction() * row.kinetic_in - self.recovered_energy()).max(0.0))
    }

    /// A result that only an impact under gravity or damping has.
    pub fn forces_value(&self, value: fn(&ForcesResult) -> Option<f64>) -> Option<f64> {
        self.impact.forces_result.as_ref().and_then(value)
    }

    /// Energy in a waveguide of this kind at the end of the impact \[J\], if the target is one.
    pub fn waveguide_energy(&self, kind: WaveguideKind) -> Option<f64> {
        self.impact.row.waveguide_of(kind).map(|waveguide| waveguide.energy)
    }

    /// True if the sphere does not separate: without damping F_m ≤ (n + 1) m g.
    pub fn is_captured(&self) -> bool {
        self.impact.forces_result.is_some_and(|forces| forces.fate == ImpactEnd::Captured)
    }

    /// δ at separation \[m\]: the depth of the dent, or more under viscous damping.
    pub fn end_indentation(&self) -> f64 {
        self.impact.forces_result.map_or(self.impact.row.residual_indentation, |forces| forces.end_indentation)
    }

    /// Time of separation \[s\]; `None` for shots and for a captured sphere.
    pub fn separation_time(&self) -> Option<f64> {
        self.time.filter(|_| !self.is_captured()).map(|time| time + self.impact.row.contact_time)
    }
}

impl SeriesResult {
    /// The impacts with a trace: the first ones.
    pub fn traced_impacts(&self) -> &[SeriesImpact] {
        let count = self.impacts.iter().take_while(|hit| !hit.impact.trace.is_empty()).count();
        &self.impacts[..count]
    }

    /// The deepest dent \[m\].
    pub fn deepest_dent(&self) -> f64 {
        self.impacts.iter().map(|hit| hit.impact.row.residual_indentation).fold(0.0, nan_max)
    }

    /// The imprint of the first impact: `dent`, `flat`, or `dent and flat`.
    pub fn imprint_name(&self) -> &'static str {
        self.impacts.first().map_or("dent", |hit| hit.impact.row.imprint_name())
    }

    /// Estimated time of rest \[s\]: the last separation and the remaining time.
    pub fn rest_time(&self) -> Option<f64> {
        Some(self.impacts.iter().rev().find_map(SeriesImpact::separation_time)? + self.remaining_time?)
    }

    /// Largest error of the energy balances of the impacts.
    pub fn max_balance_error(&self) -> f64 {
        self.impacts.iter().map(|hit| hit.impact.energy.balance_error).fold(0.0, nan_max)
    }

    pub(super) fn push_warnings(&mut self, number: usize, warnings: &[Warning]) {
        for warning in warnings {
            if !self.warnings.iter().any(|(_, known)| known.is_same_kind(warning)) {
                self.warnings.push((number, warning.clone()));
            }
        }
    }

    /// [`SeriesResult::remaining_time`] for flights under these forces.
    pub(super) fn estimated_rest(&self, flying: &FreeFlight) -> Option<f64> {
        let last = self.impacts.last().filter(|_| matches!(self.end, SeriesEnd::Impacts | SeriesEnd::Until))?;
        let (speed, restitution) = (last.rebound_speed, last.impact.row.measured_restitution());
        let missing = 1.0 - restitution;
        match flying.has_air() {
            _ if missing <= 0.0 => None,
            true => rest_in_air(flying, speed, restitution),
            false => Some(2.0 * speed / flying.gravity / missing),
        }
    }
}

/// The time until rest of bounces in air with this restitution < 1, from this take-off speed on.
///
/// After a take-off at v the series has two bounds: every flight loses the fraction of the next flight (lower bound), or there is no
/// drag (upper bound). The two bounds meet as the speed falls.
fn rest_in_air(flying: &FreeFlight, take_off: f64, restitution: f64) -> Option<f64> {
    const MAX_FLIGHTS: u32 = 10_000;
    const REST_TIME_TOLERANCE: f64 = 1e-6;
    let (mut time, mut speed) = (0.0, take_off);
    for _ in 0..MAX_FLIGHTS {
        if speed <= 0.0 {
            return Some(time);
        }
        let height = flying.rise_height(speed);
        let flight = flying.rise_time(speed) + flying.fall_time(height);
        let next = restitution * flying.landing_speed(height);
        let least = flight / (1.0 - next / speed);
        let most = 2.0 * speed / (flying.pull() * (1.0 - restitution));
        if most - least <= REST_TIME_TOLERANCE * (time + least) {
            return Some(time + 0.5 * (least + most));
        }
        (time, speed) = (time + flight, next);
    }
    None
}
