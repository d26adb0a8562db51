//! The results of impacts one after the other: those of the series, of every impact, and the columns of the trace.

use super::{ResultSpec, result_specs};
use crate::impact::Contact;
use crate::impact::series::{ImpactSeries, SeriesEnd, SeriesImpact, SeriesMode, SeriesResult};
use crate::numerics::power::nan_max;
use crate::units::{Dimension, format_result};

/// A series of impacts.
#[derive(Debug, Clone, Copy)]
pub struct SeriesReport<'a> {
    pub contact: &'a Contact,
    pub repeat: &'a ImpactSeries,
    pub sequence: &'a SeriesResult,
    /// Warnings about the scene and the impacts.
    pub warnings: &'a [String],
}

impl SeriesReport<'_> {
    fn if_yields<V>(&self, value: V) -> Option<V> {
        self.contact.pair().yield_point.map(|_| value)
    }

    /// Height of the first fall, most impacts, and the speed at which bouncing ends, if the sphere bounces.
    fn bouncing_settings(&self) -> Option<(Option<f64>, u64, Option<f64>)> {
        match self.repeat.mode {
            SeriesMode::Bouncing { drop_height, most, until, .. } => Some((drop_height, most, until)),
            SeriesMode::Shots(_) => None,
        }
    }

    /// A value of the first impact; 0 for none.
    fn first_value(&self, value: fn(&SeriesImpact) -> f64) -> f64 {
        self.sequence.impacts.first().map_or(0.0, value)
    }

    /// A value of the last impact; 0 for none.
    fn last_value(&self, value: fn(&SeriesImpact) -> f64) -> f64 {
        self.sequence.impacts.last().map_or(0.0, value)
    }

    /// The energy in the plate after all impacts, if there is a plate.
    fn plate_energy(&self) -> Option<f64> {
        self.contact.forces().plate.map(|_| self.sequence.impacts.iter().filter_map(SeriesImpact::plate_energy).sum())
    }

    fn max_value(&self, value: fn(&SeriesImpact) -> f64) -> f64 {
        self.sequence.impacts.iter().map(value).fold(0.0, nan_max)
    }
}

/// How the time of bouncing after the end of the series is estimated.
const REMAINING_TIME_TEXT: &str = "2 v/(g (1 - e)) from the last separation, with the last rebound speed v and restitution e held \
                         for all bounces to come and contact times left out, or with [air] the sum of these flights (a lower bound where e rises as the speed \
                         falls); null if e is 1 or more, or the sphere stays in its dent";

/// The results of a series, in the order of `summary.json`.
pub fn series_results<'a>() -> Vec<ResultSpec<SeriesReport<'a>>> {
    result_specs! { |series: SeriesReport<'a>|
        /// Number of impacts.
        "impacts" as "impacts": series.sequence.impacts.len();
        /// Where they hit: `same` or `fresh`.
        "spot" as "{} spot": series.repeat.spot_mode.name();
        /// Why the series ended: `shots`, `impacts`, `until`, `captured` or `in_dent`.
        "ended_by": series.sequence.end.name();
        /// Why the series ended, as a sentence.
        "end" as "end of series": end_text(series.repeat, series.sequence);
        /// Restitution of the last impact; with waves, if the half-space has a density.
        "final_restitution" as "last restitution": series.last_value(|hit| hit.impact.row.measured_restitution());
        /// Rebound speed of the last impact.
        "final_rebound_speed_m_per_s" in Speed as "rebound speed {}": series.last_value(|hit| hit.rebound_speed);
        /// Largest contact force of all impacts.
        "largest_peak_force_N" in Force: series.max_value(|hit| hit.impact.row.peak_force);
        /// Largest indentation of all impacts, from the original surface.
        "largest_peak_indentation_m" in Length: series.max_value(|hit| hit.impact.row.peak_indentation);
        /// Depth of the deepest dent, with the flat on the sphere.
        "deepest_residual_indentation_m" in Length as "deepest dent" if YIELDS: series.if_yields(series.sequence.deepest_dent());
        /// Gravity.
        "gravity_m_per_s2" in Acceleration if BOUNCES: series.contact.forces().gravity;
        /// Height of the first fall; `null` where the first speed is given.
        "drop_height_m" in Length if BOUNCES: series.bouncing_settings().map(|(drop_height, ..)| drop_height);
        /// Largest number of impacts.
        "most_impacts" if BOUNCES: series.bouncing_settings().map(|(_, most, _)| most);
        /// Bouncing ends before an impact that would be slower than this; `null` without a limit.
        "until_speed_m_per_s" in Speed if BOUNCES: series.bouncing_settings().map(|(.., until)| until);
        /// Time of the last separation; `null` where the first impact captures the sphere.
        "last_separation_time_s" in Time as "last separation" if BOUNCES:
            series.bouncing_settings().map(|_| series.sequence.impacts.iter().rev().find_map(SeriesImpact::separation_time));
        /// Estimate of the time at which the sphere would be at rest, counted as all times of the series: the last separation
        /// and the remaining time; `null` as that is.
        "rest_time_s" in Time as "time to rest" if BOUNCES: series.bouncing_settings().map(|_| series.sequence.rest_time());
        /// The part of it after the last separation: an estimate of how long bouncing would still last; `null` if it would
        /// never end, or if the sphere stays in its dent.
        "remaining_time_s" in Time as "{} after the last separation" if BOUNCES:
            series.bouncing_settings().map(|_| series.sequence.remaining_time);
        /// How the remaining time is estimated.
        "remaining_time" if BOUNCES: series.bouncing_settings().map(|_| REMAINING_TIME_TEXT);
        /// Highest rebound over the original surface.
        "highest_rebound_m" in Length if BOUNCES: series.bouncing_settings().map(|_| {
            let flights = series.sequence.impacts.iter().filter_map(|hit| hit.flight);
            flights.map(|flight| flight.apex_height()).reduce(nan_max)
        });
        /// How far along the surface the last impact is from the first.
        "path_m" in Length as "path" if OBLIQUE:
            series.sequence.impacts.last().filter(|hit| hit.tangential_speed().is_some()).map(|hit| hit.position);
        /// Indentation at which a captured sphere comes to rest.
        "static_indentation_m" in Length as "final indentation" if CAPTURED:
            series.bouncing_settings().and_then(|_| series.sequence.impacts.last()?.forces_value(|forces| forces.static_indentation));
        /// Kinetic energy at the first touch.
        "energy.first_kinetic_in_J" in Energy: series.first_value(|hit| hit.impact.row.kinetic_in);
        /// Kinetic energy after the last impact.
        "energy.last_recovered_J" in Energy: series.last_value(SeriesImpact::recovered_energy);
        /// Energy radiated as elastic waves.
        "energy.waves_J" in Energy if WAVES:
            series.sequence.impacts.iter().filter_map(SeriesImpact::radiated_energy).reduce(|all, one| all + one);
        /// Energy spent on dents.
        "energy.plastic_J" in Energy if YIELDS: series.if_yields(series.sequence.impacts.iter().filter_map(|hit| hit.impact.energy.plastic).sum::<f64>());
        /// Energy that the plate has taken in all impacts.
        "energy.plate_J" in Energy if PLATE: series.plate_energy();
        /// Energy that friction has taken in all impacts.
        "energy.friction_J" in Energy if OBLIQUE:
            series.sequence.impacts.iter().filter_map(|hit| hit.impact.oblique).map(|friction| friction.loss).reduce(|all, one| all + one);
        /// Largest error of the energy balance of any impact.
        "energy.balance_error" in Error as "energy balance error": series.sequence.max_balance_error();
        /// Impacts that the trace has: the first ones of a long series.
        "traced_impacts": series.sequence.traced_impacts().len();
        /// Where the scene, the model or the run is doubtful.
        "warnings": series.warnings.to_vec();
        /// Effective modulus E* of the pair of bodies.
        "effective_modulus_Pa" in Pressure: series.contact.pair().effective_modulus;
        /// The sphere's share of the elastic approach; 0 for a rigid sphere.
        "sphere_compliance": series.contact.pair().sphere_compliance;
        /// Mass of the sphere.
        "sphere_mass_kg" in Mass: series.contact.mass();
        /// Impact speed above which the half-space yields.
        "yield_speed_m_per_s" in Speed if REACHES: series.contact.yield_speed();
    }
}

/// Why the series ended, for a person.
fn end_text(repeat: &ImpactSeries, sequence: &SeriesResult) -> String {
    let until = match repeat.mode {
        SeriesMode::Bouncing { until: Some(until), .. } => format_result(until, Dimension::Speed),
        _ => String::new(),
    };
    match sequence.end {
        SeriesEnd::Shots => "all given impacts computed".to_owned(),
        SeriesEnd::Impacts => "maximum number of impacts".to_owned(),
        SeriesEnd::Until => format!("the next impact would be slower than {until}"),
        SeriesEnd::Captured => "captured: the sphere does not leave the half-space".to_owned(),
        SeriesEnd::InDent => "the rebound is lower than the depth of the dent".to_owned(),
    }
}

/// The columns of `impacts.csv`, behind the number of the impact.
pub fn impact_columns<'a>() -> Vec<ResultSpec<(usize, &'a SeriesImpact)>> {
    result_specs! { |row: (usize, &'a SeriesImpact)|
        /// Number of the impact, from 1.
        "impact" as "impact": row.0;
        /// Time of first touch: since the release of the sphere, or since the first touch where no height is given.
        "time_s" in Time as "time" if BOUNCES: row.1.time;
        /// Place of the impact along the surface, from the first.
        "position_m" in Length as "place" if OBLIQUE: row.1.tangential_speed().map(|_| row.1.position);
        /// Speed at first touch, normal to the half-space.
        "impact_speed_m_per_s" in Speed as "speed": row.1.approach.normal;
        /// Speed of the sphere along the half-space at first touch.
        "tangential_speed_m_per_s" in Speed as "along" if OBLIQUE: row.1.tangential_speed();
        /// Spin of the sphere at first touch; positive for rolling forward.
        "spin_rad_per_s" in AngularSpeed as "spin" if OBLIQUE: row.1.approach.friction.map(|_| row.1.approach.spin);
        /// Rebound speed over impact speed by the law; 0 if captured.
        "restitution" as "e": row.1.impact.row.restitution;
        /// Restitution after the waves have taken their energy.
        "restitution_with_waves" as "with waves" if WAVES: row.1.impact.row.restitution_with_waves();
        /// Speed with which the flight begins: with waves, if the half-space has a density.
        "rebound_speed_m_per_s" in Speed as "rebound": row.1.rebound_speed;
        /// Speed of the sphere along the half-space with which the flight begins.
        "rebound_tangential_speed_m_per_s" in Speed if OBLIQUE: row.1.impact.row.rebound.map(|after| after.tangential_speed);
        /// Spin of the sphere in the flight.
        "rebound_spin_rad_per_s" in AngularSpeed if OBLIQUE: row.1.impact.row.rebound.map(|after| after.spin);
        /// Largest contact force.
        "peak_force_N" in Force as "peak force": row.1.impact.row.peak_force;
        /// Largest indentation, from the original surface.
        "peak_indentation_m" in Length as "peak depth": row.1.impact.row.peak_indentation;
        /// Depth of the dent afterwards, with the flat on the sphere.
        "residual_indentation_m" in Length as "dent" if YIELDS: row.1.impact.energy.plastic.map(|_| row.1.impact.row.residual_indentation);
        /// How much deeper this impact made the dent.
        "dent_growth_m" in Length as "growth" if YIELDS: row.1.impact.energy.plastic.map(|_| row.1.dent_growth);
        /// Time from first touch to separation; empty if captured.
        "contact_time_s" in Time as "contact": row.1.impact.row.contact_time;
        /// Kinetic energy at first touch.
        "kinetic_in_J" in Energy: row.1.impact.row.kinetic_in;
        /// Kinetic energy with which the flight begins.
        "recovered_J" in Energy: row.1.recovered_energy();
        /// Energy radiated as elastic waves.
        "waves_J" in Energy if WAVES: row.1.radiated_energy();
        /// Energy spent on the dent.
        "plastic_J" in Energy if YIELDS: row.1.impact.energy.plastic;
        /// Energy in the plate at separation, or where the computation of a captured sphere ends.
        "plate_J" in Energy if PLATE: row.1.plate_energy();
        /// Energy taken by damping.
        "damping_J" in Energy if DAMPING: row.1.forces_value(|forces| forces.damping_loss);
        /// Energy taken by friction.
        "friction_J" in Energy if OBLIQUE: row.1.impact.oblique.map(|friction| friction.loss);
        /// Elastic energy left in the contact where the sphere lifts off before it has recovered.
        "stored_at_separation_J" in Energy if VISCOUS: row.1.forces_value(|forces| forces.stored_at_separation);
        /// Kinetic and elastic energy where the computation of a captured sphere ends.
        "remaining_J" in Energy if CAPTURED: row.1.forces_value(|forces| forces.remaining_energy);
        /// Work of gravity since first touch.
        "gravity_work_J" in Energy if GRAVITY: row.1.forces_value(|forces| forces.gravity_work);
        /// Error of the energy balance.
        "energy_balance_error" in Error: row.1.impact.energy.balance_error;
    }
}

/// A row of the trace of a series, in SI; see [`trace_columns`].
#[derive(Debug, Clone, Copy)]
pub struct SeriesTraceRow {
    pub impact: usize,
    pub time: f64,
    pub position: Option<f64>,
    pub height: f64,
    pub speed: f64,
    pub force: f64,
    pub branch: &'static str,
    pub event: &'static str,
}

/// The columns of the `trace.csv` of a series.
pub fn trace_columns() -> Vec<ResultSpec<SeriesTraceRow>> {
    result_specs! { |row: SeriesTraceRow|
        /// Number of the impact that the row belongs to or follows; 0 during the fall before the first.
        "impact": row.impact;
        /// Time of the series for a bouncing sphere; for shots, time since each first touch.
        "time_s" in Time: row.time;
        /// Place along the surface, from the first impact.
        "position_m" in Length if OBLIQUE: row.position;
        /// Height of the lowest point of the sphere over the original surface; negative in contact.
        "height_m" in Length: row.height;
        /// Speed towards the half-space.
        "speed_m_per_s" in Speed: row.speed;
        /// Force on the sphere.
        "force_N" in Force: row.force;
        /// Branch of the law, or `flight`.
        "branch": row.branch;
        /// The event in this row, if there is one, as in the trace of one impact; `release` where a fall begins.
        "event": row.event;
    }
}
