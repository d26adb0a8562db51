//! The results of impacts one after the other: those of the series, of every impact, and the columns of the trace.

use super::{ResultSpec, result_specs};
use crate::impact::series::{ImpactSeries, SeriesEnd, SeriesImpact, SeriesMode, SeriesResult};
use crate::impact::{Contact, WaveguideKind};
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

    /// The energy in a waveguide of this kind after all impacts, if the target is one.
    fn waveguide_energy(&self, kind: WaveguideKind) -> Option<f64> {
        let energies = || self.sequence.impacts.iter().filter_map(|impact| impact.waveguide_energy(kind));
        self.contact.forces().waveguide.filter(|guide| guide.kind() == kind).map(|_| energies().sum())
    }

    /// The azimuth of the last rebound, in degrees, if the sphere has a spin out of the plane of incidence.
    fn last_azimuth(&self) -> Option<f64> {
        let last = self.sequence.impacts.last().filter(|hit| hit.cross_motion().is_some())?;
        Some(last.impact.row.rebound.map_or(f64::NAN, |after| after.tangential.azimuth().to_degrees()))
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
        /// Spot of the impacts: `same` or `fresh`.
        "spot" as "{} spot": series.repeat.spot_mode.name();
        /// Reason for the end of the series: `shots`, `impacts`, `until`, `captured` or `in_dent`.
        "ended_by": series.sequence.end.name();
        /// Reason for the end of the series, as text.
        "end" as "end of series": end_text(series.repeat, series.sequence);
        /// Restitution of the last impact; with waves, if the half-space has a density.
        "final_restitution" as "last restitution": series.last_value(|hit| hit.impact.row.measured_restitution());
        /// Rebound speed of the last impact.
        "final_rebound_speed_m_per_s" in Speed as "rebound speed {}": series.last_value(|hit| hit.rebound_speed);
        /// Maximum contact force of all impacts.
        "largest_peak_force_N" in Force: series.max_value(|hit| hit.impact.row.peak_force);
        /// Maximum indentation of all impacts, from the original surface.
        "largest_peak_indentation_m" in Length: series.max_value(|hit| hit.impact.row.peak_indentation);
        /// Depth of the deepest dent, including the flat on the sphere.
        "deepest_residual_indentation_m" in Length as "deepest dent" if YIELDS: series.if_yields(series.sequence.deepest_dent());
        /// Gravity.
        "gravity_m_per_s2" in Acceleration if BOUNCES: series.contact.forces().gravity;
        /// Height of the first fall; `null` if the first speed is given.
        "drop_height_m" in Length if BOUNCES: series.bouncing_settings().map(|(drop_height, ..)| drop_height);
        /// Maximum number of impacts.
        "most_impacts" if BOUNCES: series.bouncing_settings().map(|(_, most, _)| most);
        /// Bouncing ends before an impact that is slower than this speed; `null` without a limit.
        "until_speed_m_per_s" in Speed if BOUNCES: series.bouncing_settings().map(|(.., until)| until);
        /// Time of the last separation; `null` if the first impact captures the sphere.
        "last_separation_time_s" in Time as "last separation" if BOUNCES:
            series.bouncing_settings().map(|_| series.sequence.impacts.iter().rev().find_map(SeriesImpact::separation_time));
        /// Estimated time at which the sphere comes to rest: last separation plus remaining time; `null` if the remaining time is
        /// `null`.
        "rest_time_s" in Time as "time to rest" if BOUNCES: series.bouncing_settings().map(|_| series.sequence.rest_time());
        /// Estimated time from the last separation to rest; `null` if bouncing never ends, or if the sphere stays in its dent.
        "remaining_time_s" in Time as "{} after the last separation" if BOUNCES:
            series.bouncing_settings().map(|_| series.sequence.remaining_time);
        /// Method of the estimate of the remaining time, as text.
        "remaining_time" if BOUNCES: series.bouncing_settings().map(|_| REMAINING_TIME_TEXT);
        /// Highest rebound over the original surface.
        "highest_rebound_m" in Length if BOUNCES: series.bouncing_settings().map(|_| {
            let flights = series.sequence.impacts.iter().filter_map(|hit| hit.flight);
            flights.map(|flight| flight.apex_height()).reduce(nan_max)
        });
        /// Distance from the first impact to the last, in the direction of the first path.
        "path_m" in Length as "path" if OBLIQUE:
            series.sequence.impacts.last().filter(|hit| hit.tangential().is_some()).map(|hit| hit.position[0]);
        /// Distance of the last impact from the first path: positive to the left, seen from above.
        "cross_path_m" in Length as "across the path {}" if CROSS:
            series.sequence.impacts.last().filter(|hit| hit.cross_motion().is_some()).map(|hit| hit.position[1]);
        /// Direction of the last rebound along the surface, in degrees from the direction of the first path: positive to the left, seen
        /// from above; `null` for a rebound along the normal and for a captured sphere.
        "final_azimuth_deg" as "last azimuth (deg)" if CROSS: series.last_azimuth();
        /// Indentation at which a captured sphere comes to rest.
        "static_indentation_m" in Length as "final indentation" if CAPTURED:
            series.bouncing_settings().and_then(|_| series.sequence.impacts.last()?.forces_value(|forces| forces.static_indentation));
        /// Kinetic energy at the first contact.
        "energy.first_kinetic_in_J" in Energy: series.first_value(|hit| hit.impact.row.kinetic_in);
        /// Kinetic energy after the last impact.
        "energy.last_recovered_J" in Energy: series.last_value(SeriesImpact::recovered_energy);
        /// Energy radiated as elastic waves.
        "energy.waves_J" in Energy if WAVES:
            series.sequence.impacts.iter().filter_map(SeriesImpact::radiated_energy).reduce(|all, one| all + one);
        /// Plastic work of all impacts.
        "energy.plastic_J" in Energy if YIELDS: series.if_yields(series.sequence.impacts.iter().filter_map(|hit| hit.impact.energy.plastic).sum::<f64>());
        /// Energy that the plate absorbed in all impacts.
        "energy.plate_J" in Energy if PLATE: series.waveguide_energy(WaveguideKind::Plate);
        /// Energy that the rod absorbed in all impacts.
        "energy.rod_J" in Energy if ROD: series.waveguide_energy(WaveguideKind::Rod);
        /// Energy that friction absorbed in all impacts.
        "energy.friction_J" in Energy if OBLIQUE:
            series.sequence.impacts.iter().filter_map(|hit| hit.impact.oblique).map(|friction| friction.loss).reduce(|all, one| all + one);
        /// Maximum error of the energy balance of all impacts.
        "energy.balance_error" in Error as "energy balance error": series.sequence.max_balance_error();
        /// Number of impacts in the trace: the first impacts of a long series.
        "traced_impacts": series.sequence.traced_impacts().len();
        /// Warnings about scenario, model and run.
        "warnings": series.warnings.to_vec();
        /// Effective modulus E* of the pair of bodies.
        "effective_modulus_Pa" in Pressure: series.contact.pair().effective_modulus;
        /// Fraction of the elastic approach in the sphere; 0 for a rigid sphere.
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
        /// Time of first contact, since the release of the sphere; without a drop height, since the first contact of the series.
        "time_s" in Time as "time" if BOUNCES: row.1.time;
        /// Distance of the impact from the first impact, in the direction of the first path.
        "position_m" in Length as "place" if OBLIQUE: row.1.tangential().map(|_| row.1.position[0]);
        /// Distance of the impact from the first path: positive to the left, seen from above.
        "cross_position_m" in Length as "across" if CROSS: row.1.cross_motion().map(|_| row.1.position[1]);
        /// Normal speed at first contact.
        "impact_speed_m_per_s" in Speed as "speed": row.1.approach.normal;
        /// Tangential speed of the sphere at first contact, in the direction of the first path.
        "tangential_speed_m_per_s" in Speed as "along" if OBLIQUE: row.1.tangential().map(|motion| motion.speed);
        /// Speed across the first path at first contact: positive to the left, seen from above.
        "cross_speed_m_per_s" in Speed if CROSS: row.1.cross_motion().map(|cross| cross.speed);
        /// Spin of the sphere at first contact; positive for rolling forward.
        "spin_rad_per_s" in AngularSpeed as "spin" if OBLIQUE: row.1.tangential().map(|motion| motion.spin);
        /// Spin about the direction of the first path at first contact.
        "spin_about_path_rad_per_s" in AngularSpeed if CROSS: row.1.cross_motion().map(|cross| cross.spin_about_path);
        /// Coefficient of restitution by the law; 0 if captured.
        "restitution" as "e": row.1.impact.row.restitution;
        /// Restitution reduced by the energy of elastic waves.
        "restitution_with_waves" as "with waves" if WAVES: row.1.impact.row.restitution_with_waves();
        /// Rebound speed at the start of the flight; with waves if the half-space has a density.
        "rebound_speed_m_per_s" in Speed as "rebound": row.1.rebound_speed;
        /// Tangential speed of the sphere at the start of the flight, in the direction of the first path.
        "rebound_tangential_speed_m_per_s" in Speed if OBLIQUE: row.1.impact.row.rebound.map(|after| after.tangential.speed);
        /// Speed across the first path at the start of the flight: positive to the left, seen from above.
        "rebound_cross_speed_m_per_s" in Speed if CROSS: row.1.cross_motion_after().map(|cross| cross.speed);
        /// Spin of the sphere in the flight.
        "rebound_spin_rad_per_s" in AngularSpeed if OBLIQUE: row.1.impact.row.rebound.map(|after| after.tangential.spin);
        /// Spin about the direction of the first path in the flight.
        "rebound_spin_about_path_rad_per_s" in AngularSpeed if CROSS: row.1.cross_motion_after().map(|cross| cross.spin_about_path);
        /// Maximum contact force.
        "peak_force_N" in Force as "peak force": row.1.impact.row.peak_force;
        /// Maximum indentation, from the original surface.
        "peak_indentation_m" in Length as "peak depth": row.1.impact.row.peak_indentation;
        /// Depth of the dent after the impact, including the flat on the sphere.
        "residual_indentation_m" in Length as "dent" if YIELDS: row.1.impact.energy.plastic.map(|_| row.1.impact.row.residual_indentation);
        /// Increase of the dent depth by this impact.
        "dent_growth_m" in Length as "growth" if YIELDS: row.1.impact.energy.plastic.map(|_| row.1.dent_growth);
        /// Time from first contact to separation; empty if captured.
        "contact_time_s" in Time as "contact": row.1.impact.row.contact_time;
        /// Kinetic energy at first contact.
        "kinetic_in_J" in Energy: row.1.impact.row.kinetic_in;
        /// Kinetic energy at the start of the flight.
        "recovered_J" in Energy: row.1.recovered_energy();
        /// Energy radiated as elastic waves.
        "waves_J" in Energy if WAVES: row.1.radiated_energy();
        /// Plastic work.
        "plastic_J" in Energy if YIELDS: row.1.impact.energy.plastic;
        /// Energy in the plate at separation, or at the end of the computation of a captured sphere.
        "plate_J" in Energy if PLATE: row.1.waveguide_energy(WaveguideKind::Plate);
        /// Energy in the rod at separation, or at the end of the computation of a captured sphere.
        "rod_J" in Energy if ROD: row.1.waveguide_energy(WaveguideKind::Rod);
        /// Energy absorbed by damping.
        "damping_J" in Energy if DAMPING: row.1.forces_value(|forces| forces.damping_loss);
        /// Energy absorbed by friction.
        "friction_J" in Energy if OBLIQUE: row.1.impact.oblique.map(|friction| friction.loss);
        /// Elastic energy left in the contact if the sphere separates before the contact has recovered.
        "stored_at_separation_J" in Energy if VISCOUS: row.1.forces_value(|forces| forces.stored_at_separation);
        /// Kinetic and elastic energy at the end of the computation of a captured sphere.
        "remaining_J" in Energy if CAPTURED: row.1.forces_value(|forces| forces.remaining_energy);
        /// Work of gravity since first contact.
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
    pub cross_position: Option<f64>,
    pub height: f64,
    pub speed: f64,
    pub force: f64,
    pub branch: &'static str,
    pub event: &'static str,
}

/// The columns of the `trace.csv` of a series.
pub fn trace_columns() -> Vec<ResultSpec<SeriesTraceRow>> {
    result_specs! { |row: SeriesTraceRow|
        /// Number of the current or previous impact; 0 during the first fall.
        "impact": row.impact;
        /// Time since the start of the series; for given speeds, time since each first contact.
        "time_s" in Time: row.time;
        /// Distance from the first impact, in the direction of the first path.
        "position_m" in Length if OBLIQUE: row.position;
        /// Distance from the first path: positive to the left, seen from above.
        "cross_position_m" in Length if CROSS: row.cross_position;
        /// Height of the lowest point of the sphere over the original surface; negative in contact.
        "height_m" in Length: row.height;
        /// Speed towards the half-space.
        "speed_m_per_s" in Speed: row.speed;
        /// Force on the sphere.
        "force_N" in Force: row.force;
        /// Branch of the law, or `flight`.
        "branch": row.branch;
        /// Event in this row, as in the trace of one impact; `release` at the start of a fall.
        "event": row.event;
    }
}
