//! The results of one impact, some of which are columns of tables.
//!
//! An entry says what a result means, then `"name" in Unit as "label on the terminal" if CONDITION [Requirement: column]: value`. A result
//! with a column has its value in tables too, where the scene has what the column needs.

use serde_json::{Value, json};

use super::{Requirement, ResultSpec, result_specs};
use crate::contact::pair::YieldPartition;
use crate::impact::flight::free_flight::FreeFlight;
use crate::impact::{Contact, FixedSteps, ForcesResult, Impact, ImpactRow, ObliqueResult, PlateResult, Rebound};
use crate::results::restitution_interval::RestitutionInterval;

/// One impact.
#[derive(Debug, Clone, Copy)]
pub struct SingleImpact<'a> {
    pub contact: &'a Contact,
    pub impact: &'a Impact,
    /// The interval of e, if it is known.
    pub interval: Option<&'a RestitutionInterval>,
    /// Notes for the user on the strength and on the exponent behind e.
    pub notes: &'a [String],
    /// The height of the fall \[m\]; `None` without a drop height.
    pub drop_height: Option<f64>,
}

impl SingleImpact<'_> {
    /// The value of a column of tables, if the impact has it.
    fn column_value(&self, needs: Requirement, value: fn(&ImpactRow) -> Option<f64>) -> Option<Value> {
        let row = &self.impact.essentials;
        needs.is_met_by(self.contact, row).then(|| value(row).into())
    }

    /// The value, if the sphere can yield.
    fn if_sphere_yields<V>(&self, value: V) -> Option<V> {
        self.contact.sphere().yield_strength.map(|_| value)
    }

    /// Which body flows.
    fn yielding_body(&self) -> &'static str {
        match self.contact.pair().yield_point.map(|point| point.yield_partition) {
            Some(flow) if self.impact.has_dent() => match flow {
                _ if flow.is_shared() => "both",
                YieldPartition { is_sphere: true, .. } => "sphere",
                _ => "half_space",
            },
            _ => "none",
        }
    }

    /// The value, if a body can yield.
    fn if_yields<V>(&self, value: V) -> Option<V> {
        self.contact.pair().yield_point.map(|_| value)
    }

    /// The value, if a body can yield before the contact is as wide as the sphere.
    fn at_first_yield<V>(&self, value: V) -> Option<V> {
        self.if_yields(value).filter(|_| self.contact.reaches_first_yield())
    }

    /// The value, if there is gravity or damping.
    fn if_forces<V>(&self, value: fn(&ForcesResult) -> V) -> Option<V> {
        self.impact.forces_result.as_ref().map(value)
    }

    /// The value, if a plate is hit.
    fn if_plate<V>(&self, value: impl FnOnce(&PlateResult) -> V) -> Option<V> {
        self.impact.plate.as_ref().map(value)
    }

    /// The value, if the sphere came in at an angle, or spinning.
    fn if_oblique(&self, value: fn(&ObliqueResult) -> f64) -> Option<f64> {
        self.impact.oblique.as_ref().map(value)
    }

    /// The flight, if there is air.
    fn flight_in_air(&self) -> Option<FreeFlight> {
        self.contact.forces().flight.filter(FreeFlight::has_air)
    }

    /// The value, if the steps are fixed.
    fn if_fixed_steps<V>(&self, value: fn(&FixedSteps) -> V) -> Option<V> {
        self.impact.fixed_steps.as_ref().map(value)
    }
}

/// A value of an oblique impact; none where it is no number.
fn rebound_value(row: &ImpactRow, value: fn(&Rebound) -> f64) -> Option<f64> {
    row.rebound.as_ref().map(value).filter(|value| value.is_finite())
}

/// Speed along the surface and spin of a second ball.
fn target_value(row: &ImpactRow, place: usize) -> Option<f64> {
    row.rebound.as_ref().and_then(|after| after.target).map(|target| target[place])
}

/// The results of one impact, in the order of `summary.json`.
#[allow(clippy::too_many_lines)] // one list, which is read from top to bottom
pub fn impact_results<'a>() -> Vec<ResultSpec<SingleImpact<'a>>> {
    result_specs! { |single: SingleImpact<'a>|
        /// Relative normal speed after the impact over the relative normal speed before it; `null` for a sphere that is released at first
        /// touch.
        "restitution" briefly "restitution" [Nothing: |row| row.has_speed().then_some(row.restitution)];
        /// Both ends of the uncertainty interval (95 %) of the measured restitution: of `restitution_with_waves` where the
        /// half-space has a density, else of `restitution`. Known biases move both ends, and scatter is added as squares. There is no
        /// interval if a warning reports an error of e of unknown size.
        "restitution_interval" if INTERVAL: single.interval.map(|interval| vec![interval.low, interval.high]);
        /// The interval and its parts as text.
        "restitution_interval_text" briefly "({})" if INTERVAL: single.interval.map(RestitutionInterval::to_text);
        /// The parts of the interval: `name`, `kind` (`shift`, `width` or `not_included`), `low` and `high` as shares of e, less 1.
        "restitution_interval_parts" if INTERVAL: single.interval.map(|interval| json!(interval.parts));
        /// The lower end of the interval.
        "restitution_interval_low" if TABLES [Interval: |row| row.restitution_interval.map(|[low, _]| low)];
        /// The upper end of the interval.
        "restitution_interval_high" if TABLES [Interval: |row| row.restitution_interval.map(|[_, high]| high)];
        /// Energy in the plate at separation over the kinetic energy of the motion normal to the plate at first touch; under
        /// gravity it may exceed 1, as the weight does work too.
        "plate_loss_fraction" in Percent as "plate loss"
            [Thickness: ImpactRow::plate_loss_fraction];
        /// Zener's inelasticity parameter: 0 for a thick plate; from 1 on little comes back.
        "zener_number" as "Zener number" [Thickness: |row| row.plate.map(|plate| plate.zener_number)];
        /// How many plate thicknesses a wave travels during the contact time on a half-space: below 2 the plate acts as a
        /// half-space, from 10 on it is thin.
        "plate_wave_transits" as "wave transits of the plate" if PLATE: single.if_plate(|plate| plate.wave_transits);
        /// How far the plate has moved at separation.
        "plate_displacement_m" in Length as "plate displacement"
            [Thickness: |row| row.plate.map(|plate| plate.displacement)];
        /// How far away an edge must be, so that no bending wave comes back from it during the contact.
        "plate_wave_reach_m" in Length as "required edge distance {}"
            [Thickness: |row| row.plate.map(|plate| plate.wave_reach).filter(|reach| reach.is_finite())];
        /// Energy radiated as elastic waves, to first order, over the kinetic energy of the motion normal to the half-space.
        "wave_loss_fraction" in Percent as "wave loss" [Density: |row| row.wave_loss_fraction];
        /// Restitution after the waves have taken their energy; 0 where they would take more than comes back.
        "restitution_with_waves" briefly "restitution with waves" [Density: ImpactRow::restitution_with_waves];
        /// Speed of the sphere when it separates, normal to the half-space; negative where it pushes a lighter body on and follows it.
        "rebound_speed_m_per_s" in Speed as "rebound speed": single.impact.rebound_speed;
        /// Speed of the body that is hit after the impact, in the direction of the approach.
        "target_speed_m_per_s" in Speed as "target speed" [Target: |row| row.target_speed];
        /// Its speed along the surface, in the direction of the sphere's path.
        "target_tangential_speed_m_per_s" in Speed as "along the surface {}" [Struck: |row| target_value(row, 0)];
        /// Its spin, in the direction of a sphere that rolls forward.
        "target_spin_rad_per_s" in AngularSpeed as "spin {}" [Struck: |row| target_value(row, 1)];
        /// Height to which the sphere rises, with waves and air where they are known.
        "rebound_height_m" in Length briefly "rebound height" [Flight: |row| row.rebound_height];
        /// Share of the energy m g h of a fall to the impact speed that the air takes, buoyancy counted.
        "air_loss_fraction" in Percent as "air absorbed {} of the drop energy" if AIR: single.flight_in_air().and_then(|flying| {
            // near the terminal speed the height cannot be found from the speed
            let from_given = |height: &f64| flying.landing_speed(*height) == single.impact.speed;
            let height = single.drop_height.filter(from_given);
            let height = height.unwrap_or_else(|| flying.drop_height(single.impact.speed));
            height.is_finite().then(|| flying.loss_fraction(height))
        });
        /// Speed at which the drag of the air carries the weight.
        "terminal_speed_m_per_s" in Speed if AIR: single.flight_in_air().map(|flying| flying.terminal_speed());
        /// Angle of the rebound from the normal, in degrees; negative where the sphere is thrown back.
        "rebound_angle_deg" briefly "rebound angle (deg)" [Incidence: |row| rebound_value(row, |after| after.angle.to_degrees())];
        /// Tangential speed of the sphere's centre after the impact over that before; `null` without one before.
        "tangential_restitution" as "tangential restitution"
            [Incidence: |row| rebound_value(row, |after| after.tangential_restitution)];
        /// Slip speed of the contact point after the impact over that before, negative where it slips on: -s_1/s_0; `null`
        /// where it did not slip.
        "contact_point_restitution" as "contact-point restitution {}"
            [Incidence: |row| rebound_value(row, |after| after.contact_point_restitution)];
        /// Speed of the sphere along the half-space after the impact.
        "rebound_tangential_speed_m_per_s" in Speed as "speed along the surface"
            [Incidence: |row| rebound_value(row, |after| after.tangential_speed)];
        /// Spin of the sphere after the impact; positive for rolling forward.
        "rebound_spin_rad_per_s" in AngularSpeed as "spin after" [Incidence: |row| rebound_value(row, |after| after.spin)];
        /// Tangential impulse over normal impulse, positive where friction pushes the sphere back along its path; its size is
        /// at most the coefficient of friction. A sphere that spins faster than it would roll is pushed forward: negative.
        "impulse_ratio" as "impulse ratio" [Incidence: |row| rebound_value(row, |after| after.impulse_ratio)];
        /// Energy taken by friction over the kinetic energy of the whole speed, without that of the spin; a fast spin may bring
        /// more than that.
        "friction_loss_fraction" in Percent as "friction loss {} of the kinetic energy"
            [Incidence: |row| rebound_value(row, |after| after.loss_fraction)];
        /// `sliding` where the contact point slips all the time, by the closed form; else `partial`.
        "sliding_regime" as "friction regime" if OBLIQUE:
            single.impact.rebound.map(|after| if after.is_sliding { "sliding" } else { "partial" });
        /// 1 where the contact point slips all the time, else 0.
        "is_sliding" if TABLES [Incidence: |row| rebound_value(row, |after| f64::from(u8::from(after.is_sliding)))];
        /// Slip speed before the impact over friction, 4 (G*/E*) s_0/(mu v_n); infinite (`null`) without friction.
        "psi_1" [Incidence: |row| rebound_value(row, |after| after.psi)];
        /// Slip speed after the impact over friction, 4 (G*/E*) s_1/(mu v_n).
        "psi_2" [Incidence: |row| rebound_value(row, Rebound::psi_after)];
        /// Error of -s_1/s_0: the sum of what halving each step of friction changes; 0 for gross sliding.
        "friction_error" in Error [Incidence: |row| rebound_value(row, |after| after.error)];
        /// Time from first touch to separation; `null` for a captured sphere.
        "contact_time_s" in Time briefly "contact time"
            [Nothing: |row| row.contact_time.is_finite().then_some(row.contact_time)];
        /// Time from first touch to the largest indentation.
        "loading_time_s" in Time as "compression {}": single.impact.loading_time;
        /// Largest contact force.
        "peak_force_N" in Force briefly "peak force" [Nothing: |row| Some(row.peak_force)];
        /// Largest indentation: how far the sphere's centre has come closer to the half-space.
        "peak_indentation_m" in Length as "peak indentation" [Nothing: |row| Some(row.peak_indentation)];
        /// The sphere's own share of the largest indentation, with the flat that it keeps; 0 for a rigid sphere.
        "peak_sphere_indentation_m" in Length as "of it in the sphere {}": single.impact.peak_sphere_indentation;
        /// Contact radius at the largest indentation.
        "peak_contact_radius_m" in Length as "contact radius": single.impact.peak_contact_radius;
        /// Contact radius over the radius of the sphere, or of a smaller second ball; the warning of a dent that is too wide names the limit of the law.
        "contact_radius_over_R" as "{} of the sphere's radius" [Nothing: |row| Some(row.radius_ratio)];
        /// 1 where the contact radius or the indentation is outside of the range that the law holds for, or is stated for: take
        /// the row for an estimate; else 0.
        "is_outside_validity" if TABLES [Nothing: |row| Some(f64::from(u8::from(row.is_outside_validity)))];
        /// Peak force over the contact area there.
        "peak_mean_pressure_Pa" in Pressure as "mean pressure {}": single.impact.peak_mean_pressure;
        /// The part of the largest indentation that is recovered on unloading.
        "elastic_approach_m" in Length: single.impact.elastic_approach;
        /// How much closer the bodies stay: the depth of the dent and of the flat on the sphere; 0 without both.
        "residual_indentation_m" in Length briefly "dent depth" [Strength: |row| Some(row.residual_indentation)];
        /// The part of the residual indentation that is a dent in the half-space. Where both bodies yield, the division is an
        /// estimate, validated up to a contact radius of 0.11 of the sphere's.
        "dent_depth_m" in Length as "dent {}" [Flat: |row| Some(row.dent_depth())];
        /// The part of the residual indentation that is a flat on the sphere.
        "flat_depth_m" in Length as "flat on the sphere {}" [Flat: |row| Some(row.flat_depth)];
        /// Diameter of the flat on the sphere: that of the contact at the peak; `null` without one.
        "flat_diameter_m" in Length briefly "flat diameter {}" [Flat: |row| row.has_flat().then_some(2.0 * row.peak_contact_radius)];
        /// Which body flows: `half_space`, `sphere`, `both`, or `none`.
        "yielding_body" as "yielding body" if FLATTENS: single.if_sphere_yields(single.yielding_body());
        /// Effective radius of the contact on unloading.
        "unloading_radius_m" in Length if YIELDS: single.if_yields(single.impact.unloading_radius);
        /// Radius of curvature of the dent; `null` without one.
        "residual_radius_m" in Length as "radius of curvature {}" if YIELDS: single.if_yields(single.impact.residual_radius);
        /// Diameter of the dent's rim: twice the contact radius at the peak that shaped it; `null` without a dent.
        "dent_diameter_m" in Length briefly "dent diameter"
            [Strength: |row| (row.dent_depth() > 0.0).then_some(2.0 * row.peak_contact_radius)];
        /// Impact speed above which a body yields.
        "yield_speed_m_per_s" in Speed as "yield speed" if REACHES: single.at_first_yield(single.contact.yield_speed());
        /// Indentation at first yield.
        "yield_indentation_m" in Length if REACHES:
            single.at_first_yield(single.contact.yield_indentation_and_force().map(|(indentation, _)| indentation));
        /// Force at first yield.
        "yield_force_N" in Force as "yield force {}" if REACHES:
            single.at_first_yield(single.contact.yield_indentation_and_force().map(|(_, force)| force));
        /// Rate of strain while the sphere goes in; empty for an impact in the dent of another one that leaves it as it was, as the
        /// two factors below.
        "strain_rate_per_s" in StrainRate as "strain rate" [Rate: |row| row.strain_rate_result.map(|rated| rated.strain_rate)];
        /// By how much the strength of the body that yields is raised at that rate.
        "rate_factor" as "strain-rate factor {}" [Rate: |row| row.strain_rate_result.map(|rated| rated.factor)];
        /// By how much that strength is raised where the sphere turns, as the metal relaxes there.
        "rate_factor_at_peak" as "at maximum compression {}" [Rate: |row| row.strain_rate_result.map(|rated| rated.factor_at_peak)];
        /// Share of the normal kinetic energy that comes back: the square of the restitution.
        "recovered_fraction" in Percent if TABLES [Nothing: |row| row.has_speed().then(|| row.recovered_fraction())];
        /// Energy spent on the dent over the normal kinetic energy; under gravity it may exceed 1.
        "plastic_fraction" in Percent if TABLES [Strength: |row| row.has_speed().then_some(row.plastic_fraction)];
        /// `separated` if the sphere left, `captured` if it stayed.
        "outcome" as "outcome" if FORCES: single.if_forces(|under| under.fate.name());
        /// Time of separation; for a captured sphere, the time at which the computation ends.
        "end_time_s" in Time as "at {}" if FORCES: single.if_forces(|under| under.end_time);
        /// Indentation at that time.
        "end_indentation_m" in Length if FORCES: single.if_forces(|under| under.end_indentation);
        /// Indentation at which a captured sphere comes to rest.
        "static_indentation_m" in Length as "final indentation {}" if CAPTURED:
            single.if_forces(|under| under.static_indentation).flatten();
        /// Length of a step.
        "verlet.step_s" in Time as "verlet step" if VERLET: single.if_fixed_steps(|seen| seen.step);
        /// Time from first touch to the deepest step.
        "verlet.compression_time_s" in Time as "compression {}" if VERLET: single.if_fixed_steps(|seen| seen.compression_time);
        /// Time from first touch to the first step without a pushing force; `null` for a captured sphere.
        "verlet.separation_time_s" in Time as "separation {}" if VERLET: single.if_fixed_steps(|seen| seen.separation_time);
        /// Relative error of the energy at the end of the contact; positive for a gain.
        "verlet.energy_error_at_end" in Error as "energy error at the end {}" if VERLET:
            single.if_fixed_steps(|_| ()).map(|()| single.impact.energy.error_at_end);
        /// Kinetic energy of the sphere at first touch; at an angle, of the motion normal to the half-space, as below. With a body
        /// that is free to move, of their relative motion.
        "energy.kinetic_in_J" in Energy as "energy": single.impact.energy.kinetic_in;
        /// Kinetic energy of the normal motion at separation.
        "energy.recovered_J" in Energy as "{%} recovered": single.impact.energy.recovered;
        /// Energy spent on the dent.
        "energy.plastic_J" in Energy as "{%} plastic work" if YIELDS: single.impact.energy.plastic;
        /// Kinetic energy of the common motion of sphere and body that is hit: of their centre of mass, which stays.
        "energy.centre_of_mass_J" in Energy as "centre-of-mass energy {}" if FREE: single.impact.energy.centre_of_mass;
        /// Energy in the plate at separation, or where the computation of a captured sphere ends.
        "energy.plate_J" in Energy as "{%} plate loss" if PLATE: single.if_plate(|plate| plate.energy);
        /// Energy taken by damping.
        "energy.damping_J" in Energy as "{%} damping loss" if DAMPING: single.if_forces(|under| under.damping_loss).flatten();
        /// Elastic energy left in the contact where the sphere lifts off before it has recovered.
        "energy.stored_at_separation_J" in Energy as "{%} elastic energy lost at separation" if VISCOUS:
            single.if_forces(|under| under.stored_at_separation).flatten();
        /// Kinetic and elastic energy where the computation of a captured sphere ends.
        "energy.remaining_J" in Energy as "{%} remaining energy" if CAPTURED: single.if_forces(|under| under.remaining_energy).flatten();
        /// Work of gravity since first touch: the weight times the way of the sphere's centre, which a plate below it lengthens.
        "energy.gravity_work_J" in Energy as "{%} from gravity" if GRAVITY: single.if_forces(|under| under.gravity_work).flatten();
        /// Kinetic energy along the half-space and of the spin at first touch.
        "energy.tangential_in_J" in Energy as "along the surface" if OBLIQUE: single.if_oblique(|friction| friction.kinetic_in);
        /// Kinetic energy along the half-space and of the spin at separation.
        "energy.tangential_recovered_J" in Energy as "{%} recovered" if OBLIQUE: single.if_oblique(|friction| friction.recovered);
        /// Energy taken by friction.
        "energy.friction_J" in Energy as "{%} friction loss" if OBLIQUE: single.if_oblique(|friction| friction.loss);
        /// Change of the angular momentum about the contact point, relative: it stays but for rounding.
        "energy.angular_momentum_error" in Error if OBLIQUE: single.if_oblique(|friction| friction.momentum_error);
        /// Largest error of the energy balance on the way, as a share of the energy put in: kinetic energy at first touch, and
        /// with gravity the work of the weight down to the peak.
        "energy.balance_error" in Error as "energy balance error {}": single.impact.energy.balance_error;
        /// Restitution of the closed form; `null` where the scene has none, as for the two errors below.
        "accuracy.closed_form_restitution" as "closed form": single.impact.accuracy.closed_form_restitution;
        /// Relative difference of the restitution from the closed form.
        "accuracy.restitution_error" in Error as "deviation of restitution {}": single.impact.accuracy.restitution_error;
        /// Relative difference of the contact time from the closed form.
        "accuracy.contact_time_error" in Error as "deviation of contact time {}": single.impact.accuracy.contact_time_error;
        /// Steps of the integration.
        "work.steps" as "steps": single.impact.stats.steps;
        /// Steps that were repeated with a shorter length.
        "work.rejected" as "{} rejected": single.impact.stats.rejected;
        /// How often the contact force was computed.
        "work.force_evaluations" as "{} force evaluations": single.impact.stats.force_evaluations;
        /// Notes for the user on the strength and on the exponent behind e, if the scenario leaves them open.
        "notes" if NOTES: (!single.notes.is_empty()).then(|| single.notes.to_vec());
        /// Where the scene, the model or the run is doubtful.
        "warnings": single.impact.warnings.iter().map(ToString::to_string).collect::<Vec<_>>();
        /// Effective modulus E* of the pair of bodies.
        "effective_modulus_Pa" in Pressure: single.contact.pair().effective_modulus;
        /// The sphere's share of the elastic approach; 0 for a rigid sphere.
        "sphere_compliance": single.contact.pair().sphere_compliance;
        /// Mass of the sphere.
        "sphere_mass_kg" in Mass: single.contact.mass();
        /// Exponent of the force on unloading.
        "unloading_exponent": single.impact.unloading_exponent;
    }
}
