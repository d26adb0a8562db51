//! The results of one impact, some of which are columns of tables.
//!
//! An entry says what a result means, then `"name" in Unit as "label on the terminal" if CONDITION [Requirement: column]: value`. A result
//! with a column has its value in tables too, where the scene has what the column needs.

use serde_json::{Value, json};

use super::entry::leeb_scale;
use super::hardness_scales::{leeb_hardness, shore_hardness};
use super::{Requirement, ResultSpec, result_specs};
use crate::contact::pair::YieldPartition;
use crate::impact::flight::free_flight::FreeFlight;
use crate::impact::result::subsurface::{COMPRESSION_SCATTER, LAYER_DEPTH_SCATTER, ZONE_DEPTH_SCATTER};
use crate::impact::{
    Contact, CrossMotion, FixedSteps, ForcesResult, Impact, ImpactRow, ObliqueResult, Pulse, Rebound, TangentialMotion,
    WaveguideKind, WaveguideResult,
};
use crate::results::dent_interval::DentInterval;
use crate::results::restitution_interval::RestitutionInterval;

/// One impact.
#[derive(Debug, Clone, Copy)]
pub struct SingleImpact<'a> {
    pub contact: &'a Contact,
    pub impact: &'a Impact,
    /// The interval of e, if it is known.
    pub interval: Option<&'a RestitutionInterval>,
    /// The interval of the dent, if the impact has `[peening]` and the interval is known.
    pub dent_interval: Option<&'a DentInterval>,
    /// Notes for the user on the strength and on the exponent behind e.
    pub notes: &'a [String],
    /// The height of the fall \[m\]; `None` without a drop height.
    pub drop_height: Option<f64>,
    /// The pulse, if it is asked for.
    pub pulse: Option<&'a Pulse>,
}

impl<'a> SingleImpact<'a> {
    /// An impact without intervals, notes and a pulse.
    pub fn new(contact: &'a Contact, impact: &'a Impact, drop_height: Option<f64>) -> Self {
        Self { contact, impact, interval: None, dent_interval: None, notes: &[], drop_height, pulse: None }
    }
}

impl SingleImpact<'_> {
    /// The value of a column of tables, if the impact has it.
    fn column_value(&self, needs: Requirement, value: fn(&ImpactRow) -> Option<f64>) -> Option<Value> {
        let row = &self.impact.row;
        needs.is_met_by(self.contact, row).then(|| value(row).into())
    }

    /// The value, if the sphere can yield.
    fn if_sphere_yields<V>(&self, value: V) -> Option<V> {
        self.contact.sphere().yield_strength.map(|_| value)
    }

    /// Which body flows.
    fn yielding_body(&self) -> &'static str {
        match self.contact.pair().yield_point.map(|point| point.yield_partition) {
            Some(flow) if self.impact.row.has_dent() => match flow {
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
    fn if_plate<V>(&self, value: impl FnOnce(&WaveguideResult) -> V) -> Option<V> {
        self.impact.row.waveguide_of(WaveguideKind::Plate).map(value)
    }

    /// The value, if a rod is hit.
    fn if_rod<V>(&self, value: impl FnOnce(&WaveguideResult) -> V) -> Option<V> {
        self.impact.row.waveguide_of(WaveguideKind::Rod).map(value)
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

/// A value of the motion out of the plane of incidence.
fn cross_value(row: &ImpactRow, value: fn(&CrossMotion) -> f64) -> Option<f64> {
    row.rebound.as_ref().and_then(|after| after.tangential.cross).as_ref().map(value)
}

/// A value of the tangential motion of a second ball.
fn target_value(row: &ImpactRow, value: fn(&TangentialMotion) -> f64) -> Option<f64> {
    row.rebound.as_ref().and_then(|after| after.target).as_ref().map(value)
}

/// A value of the motion of a second ball out of the plane of incidence.
fn target_cross_value(row: &ImpactRow, value: fn(&CrossMotion) -> f64) -> Option<f64> {
    row.rebound.as_ref().and_then(|after| after.target?.cross).as_ref().map(value)
}

/// The results of one impact, in the order of `summary.json`.
#[allow(clippy::too_many_lines)] // one list, which is read from top to bottom
pub fn impact_results<'a>() -> Vec<ResultSpec<SingleImpact<'a>>> {
    result_specs! { |single: SingleImpact<'a>|
        /// Coefficient of restitution e: relative normal speed after the impact over relative normal speed before the impact;
        /// `null` for a sphere that is released at first contact.
        "restitution" briefly "restitution" [Nothing: |row| row.has_speed().then_some(row.restitution)];
        /// Both ends of the uncertainty interval (95 %) of the measured restitution: of `restitution_with_waves` if the half-space
        /// has a density, otherwise of `restitution`. Known biases move both ends; scatter is added as squares.
        "restitution_interval" if INTERVAL: single.interval.map(|interval| vec![interval.low, interval.high]);
        /// Interval and its parts as text.
        "restitution_interval_text" briefly "({})" if INTERVAL: single.interval.map(RestitutionInterval::to_text);
        /// Parts of the interval: `name`, `kind` (`shift`, `width` or `not_included`), `low` and `high` as ratios to e, minus 1.
        "restitution_interval_parts" if INTERVAL: single.interval.map(|interval| json!(interval.parts));
        /// Lower end of the interval.
        "restitution_interval_low" if TABLES [Interval: |row| row.restitution_interval.map(|[low, _]| low)];
        /// Upper end of the interval.
        "restitution_interval_high" if TABLES [Interval: |row| row.restitution_interval.map(|[_, high]| high)];
        /// Fraction of the normal kinetic energy that the plate absorbs; with gravity the fraction may exceed 1.
        "plate_loss_fraction" in Percent as "plate loss"
            [Thickness: |row| row.waveguide_loss_fraction(WaveguideKind::Plate)];
        /// Fraction of the normal kinetic energy that the rod absorbs; with gravity the fraction may exceed 1.
        "rod_loss_fraction" in Percent as "rod loss" [Rod: |row| row.waveguide_loss_fraction(WaveguideKind::Rod)];
        /// Zener's inelasticity parameter: 0 for a thick plate or rod; at 1 and above the sphere hardly rebounds.
        "zener_number" as "Zener number" [Waveguide: |row| row.waveguide.map(|waveguide| waveguide.zener_number)];
        /// Number of plate thicknesses that a wave travels during the contact time on a half-space: below 2 the plate acts as a
        /// half-space, at 10 and above the plate is thin.
        "plate_wave_transits" as "wave transits of the plate" if PLATE: single.if_plate(|plate| plate.wave_transits);
        /// Displacement of the plate at separation.
        "plate_displacement_m" in Length as "plate displacement"
            [Thickness: |row| row.waveguide_of(WaveguideKind::Plate).map(|plate| plate.displacement)];
        /// Minimum distance of an edge from which no bending wave returns during the contact.
        "plate_wave_reach_m" in Length as "required edge distance {}"
            [Thickness: |row| row.waveguide_of(WaveguideKind::Plate).and_then(WaveguideResult::finite_wave_reach)];
        /// Number of rod diameters that a wave travels during the contact time on a half-space: at 4 and above the wave in the rod is
        /// one-dimensional.
        "rod_wave_transits" as "wave transits of the rod" if ROD: single.if_rod(|rod| rod.wave_transits);
        /// Largest stress of the pulse in the rod: peak force over cross section.
        "rod_peak_stress_Pa" in Pressure as "peak stress in the rod" [Rod: ImpactRow::rod_peak_stress];
        /// Displacement of the end of the rod at separation: impulse over impedance.
        "rod_displacement_m" in Length as "rod displacement"
            [Rod: |row| row.waveguide_of(WaveguideKind::Rod).map(|rod| rod.displacement)];
        /// Minimum length of the rod, from whose far end no wave returns during the contact.
        "rod_wave_reach_m" in Length as "required rod length {}"
            [Rod: |row| row.waveguide_of(WaveguideKind::Rod).and_then(WaveguideResult::finite_wave_reach)];
        /// Energy radiated as elastic waves, to first order, over the kinetic energy of the motion normal to the half-space.
        "wave_loss_fraction" in Percent as "wave loss" [Density: |row| row.wave_loss_fraction];
        /// Restitution reduced by the energy of elastic waves; 0 if the waves would absorb all recovered energy.
        "restitution_with_waves" briefly "restitution with waves" [Density: ImpactRow::restitution_with_waves];
        /// Speed at which an elastic sphere would stick, if it unloads as this contact does: a sphere sticks if its rebound without
        /// adhesion is slower. In a dent the contact is flatter, and this speed is higher.
        "sticking_speed_m_per_s" in Speed as "sticking speed" [Adhesion: |row| row.adhesion.map(|adhesion| adhesion.sticking_speed)];
        /// Restitution reduced by the work of adhesion, and by elastic waves if the half-space has a density; 0 for a sphere that
        /// sticks.
        "restitution_with_adhesion" as "restitution with adhesion" [Adhesion: |row| row.adhesion.map(|adhesion| adhesion.restitution)];
        /// Leeb hardness: 1000 times the restitution that a test measures, which is `restitution_with_waves` if it is there. The scale is
        /// that of `leeb_scale`.
        "leeb_hardness_HL" briefly "Leeb hardness" [LeebTester: |row| Some(leeb_hardness(row.measured_restitution()))];
        /// Scale of the Leeb tester with this body: HLD, HLD+15, HLC, HLE or HLG.
        "leeb_scale" briefly "{}" if LEEB: leeb_scale(single.contact, &single.impact.row);
        /// Shore hardness of a scleroscope, model C: (10000/65) times the ratio of rebound height to drop height, without air, which is the
        /// square of the restitution that a test measures.
        "shore_hardness_HSC" briefly "Shore hardness HSC"
            [Scleroscope: |row| Some(shore_hardness(row.measured_restitution()))];
        /// Normal speed of the sphere at separation; negative if the sphere continues in the direction of the impact (free target).
        "rebound_speed_m_per_s" in Speed as "rebound speed": single.impact.rebound_speed;
        /// Speed of the target after the impact, in the direction of the impact.
        "target_speed_m_per_s" in Speed as "target speed" [Target: |row| row.target_speed];
        /// Speed of the target along the surface, in the direction of the sphere's path.
        "target_tangential_speed_m_per_s" in Speed as "along the surface {}" [Struck: |row| target_value(row, |ball| ball.speed)];
        /// Spin of the target, in the direction of a sphere that rolls forward.
        "target_spin_rad_per_s" in AngularSpeed as "spin {}" [Struck: |row| target_value(row, |ball| ball.spin)];
        /// Speed of the target across the sphere's path: positive to the left, seen from above.
        "target_cross_speed_m_per_s" in Speed as "across the path {}"
            [StruckCross: |row| target_cross_value(row, |ball| ball.speed)];
        /// Spin of the target about the direction of the sphere's path.
        "target_spin_about_path_rad_per_s" in AngularSpeed as "about the path {}"
            [StruckCross: |row| target_cross_value(row, |ball| ball.spin_about_path)];
        /// Height of the rebound, with waves and air if the scenario has them.
        "rebound_height_m" in Length briefly "rebound height" [Flight: |row| row.rebound_height];
        /// Fraction of the drop energy m g h that the air absorbs by drag and buoyancy.
        "air_loss_fraction" in Percent as "air absorbed {} of the drop energy" if AIR: single.flight_in_air().and_then(|flying| {
            // near the terminal speed the height cannot be found from the speed
            let from_given = |height: &f64| flying.landing_speed(*height) == single.impact.speed;
            let height = single.drop_height.filter(from_given);
            let height = height.unwrap_or_else(|| flying.drop_height(single.impact.speed));
            height.is_finite().then(|| flying.loss_fraction(height))
        });
        /// Terminal speed: the drag equals the weight.
        "terminal_speed_m_per_s" in Speed if AIR: single.flight_in_air().map(|flying| flying.terminal_speed());
        /// Angle of the rebound from the normal, in degrees; negative if the tangential velocity reverses. With a spin about the path
        /// or the normal the angle is never negative, and `rebound_azimuth_deg` has the direction.
        "rebound_angle_deg" briefly "rebound angle (deg)" [Incidence: |row| rebound_value(row, |after| after.angle.to_degrees())];
        /// Direction of the rebound along the surface, in degrees from the direction of the path: positive to the left, seen from above,
        /// 180 if the sphere moves back; `null` for a rebound along the normal.
        "rebound_azimuth_deg" as "azimuth {} deg"
            [Cross: |row| rebound_value(row, |after| after.tangential.azimuth().to_degrees())];
        /// Tangential speed of the sphere's centre in the direction of the path after the impact, over the tangential speed before; `null` for a normal impact.
        "tangential_restitution" as "tangential restitution"
            [Incidence: |row| rebound_value(row, |after| after.tangential_restitution)];
        /// Tangential restitution of the contact point: -s_1/s_0, with the slip speeds before and after the impact; `null` without
        /// slip before.
        "contact_point_restitution" as "contact-point restitution {}"
            [Incidence: |row| rebound_value(row, |after| after.contact_point_restitution)];
        /// Speed of the sphere along the half-space after the impact, in the direction of the path.
        "rebound_tangential_speed_m_per_s" in Speed as "speed along the surface"
            [Incidence: |row| rebound_value(row, |after| after.tangential.speed)];
        /// Speed of the sphere across its path after the impact: positive to the left, seen from above.
        "rebound_cross_speed_m_per_s" in Speed as "across the path {}" [Cross: |row| cross_value(row, |cross| cross.speed)];
        /// Spin of the sphere after the impact; positive for rolling forward.
        "rebound_spin_rad_per_s" in AngularSpeed as "spin after" [Incidence: |row| rebound_value(row, |after| after.tangential.spin)];
        /// Spin of the sphere about the direction of the path after the impact.
        "rebound_spin_about_path_rad_per_s" in AngularSpeed as "about the path {}"
            [Cross: |row| cross_value(row, |cross| cross.spin_about_path)];
        /// Spin of the sphere about the normal after the impact, which is that before the impact.
        "rebound_spin_about_normal_rad_per_s" in AngularSpeed as "about the normal {}"
            [Cross: |row| cross_value(row, |cross| cross.spin_about_normal)];
        /// Tangential impulse over normal impulse. Positive if friction slows the sphere, negative if friction accelerates a
        /// spinning sphere; the magnitude is at most the coefficient of friction.
        "impulse_ratio" as "impulse ratio" [Incidence: |row| rebound_value(row, |after| after.impulse_ratio)];
        /// Energy absorbed by friction over the translational kinetic energy; with a fast spin the fraction may exceed 1.
        "friction_loss_fraction" in Percent as "friction loss {} of the kinetic energy"
            [Incidence: |row| rebound_value(row, |after| after.loss_fraction)];
        /// `sliding` for gross sliding (closed form), `partial` for partial slip.
        "sliding_regime" as "friction regime" if OBLIQUE:
            single.impact.row.rebound.map(|after| if after.is_sliding { "sliding" } else { "partial" });
        /// 1 for gross sliding, 0 for partial slip.
        "is_sliding" if TABLES [Incidence: |row| rebound_value(row, |after| f64::from(u8::from(after.is_sliding)))];
        /// Dimensionless slip speed before the impact, 4 (G*/E*) s_0/(mu v_n); infinite (`null`) without friction.
        "psi_1" [Incidence: |row| rebound_value(row, |after| after.psi)];
        /// Dimensionless slip speed after the impact, 4 (G*/E*) s_1/(mu v_n).
        "psi_2" [Incidence: |row| rebound_value(row, Rebound::psi_after)];
        /// Estimated numerical error of -s_1/s_0, by halving the steps; 0 for gross sliding.
        "friction_error" in Error [Incidence: |row| rebound_value(row, |after| after.error)];
        /// Time from first contact to separation; `null` for a captured sphere.
        "contact_time_s" in Time briefly "contact time"
            [Nothing: |row| row.contact_time.is_finite().then_some(row.contact_time)];
        /// Time from first contact to the maximum indentation.
        "loading_time_s" in Time as "compression {}": single.impact.loading_time;
        /// Maximum contact force.
        "peak_force_N" in Force briefly "peak force" [Nothing: |row| Some(row.peak_force)];
        /// Maximum indentation: the approach of the two bodies.
        "peak_indentation_m" in Length as "peak indentation" [Nothing: |row| Some(row.peak_indentation)];
        /// Part of the maximum indentation in the sphere, including its permanent flat; 0 for a rigid sphere.
        "peak_sphere_indentation_m" in Length as "of it in the sphere {}": single.impact.peak_sphere_indentation;
        /// Contact radius at the maximum indentation.
        "peak_contact_radius_m" in Length as "contact radius": single.impact.row.peak_contact_radius;
        /// Contact radius over the radius of the sphere, or of a smaller second ball; see the limits of validity.
        "contact_radius_over_R" as "{} of the sphere's radius" [Nothing: |row| Some(row.radius_ratio)];
        /// 1 if the contact radius or the indentation is outside the range of validity of the law, so the row is an estimate;
        /// otherwise 0.
        "is_outside_validity" if TABLES [Nothing: |row| Some(f64::from(u8::from(row.is_outside_validity)))];
        /// Mean contact pressure at maximum compression.
        "peak_mean_pressure_Pa" in Pressure as "mean pressure {}": single.impact.peak_mean_pressure;
        /// Part of the maximum indentation that is recovered on unloading.
        "elastic_approach_m" in Length: single.impact.elastic_approach;
        /// Residual indentation: dent depth plus flat depth; 0 without permanent deformation.
        "residual_indentation_m" in Length briefly "dent depth" [Strength: |row| Some(row.residual_indentation)];
        /// Both ends of the uncertainty interval (95 %) of the dent depth: hardness of a named material, and law.
        "dent_depth_interval_m" in Length if PEENED_INTERVAL: single.dent_interval.map(|interval| interval.depth.to_vec());
        /// This interval as text.
        "dent_depth_interval_text" briefly "({})" if PEENED_INTERVAL:
            single.dent_interval.map(DentInterval::depth_text);
        /// Dent depth in the half-space. If both bodies yield, the split between dent and flat is an estimate, validated up to a/R
        /// = 0.11.
        "dent_depth_m" in Length as "dent {}" [Flat: |row| Some(row.dent_depth())];
        /// Depth of the flat on the sphere.
        "flat_depth_m" in Length as "flat on the sphere {}" [Flat: |row| Some(row.flat_depth)];
        /// Diameter of the flat on the sphere: twice the maximum contact radius; `null` without a flat.
        "flat_diameter_m" in Length briefly "flat diameter {}" [Flat: |row| row.has_flat().then_some(2.0 * row.peak_contact_radius)];
        /// Body that yields: `half_space`, `sphere`, `both`, or `none`.
        "yielding_body" as "yielding body" if FLATTENS: single.if_sphere_yields(single.yielding_body());
        /// Effective radius of the contact on unloading.
        "unloading_radius_m" in Length if YIELDS: single.if_yields(single.impact.unloading_radius);
        /// Radius of curvature of the dent; `null` without a dent.
        "residual_radius_m" in Length as "radius of curvature {}" if YIELDS: single.if_yields(single.impact.residual_radius);
        /// Diameter of the dent: twice the maximum contact radius; the rim in a microscope is a little wider; `null` without a dent.
        "dent_diameter_m" in Length briefly "dent diameter"
            [Strength: |row| (row.dent_depth() > 0.0).then_some(2.0 * row.peak_contact_radius)];
        /// Both ends of the uncertainty interval (95 %) of the dent diameter: hardness of a named material, and law.
        "dent_diameter_interval_m" in Length if PEENED_INTERVAL: single.dent_interval.map(|interval| interval.diameter.to_vec());
        /// This interval as text.
        "dent_diameter_interval_text" briefly "({})" if PEENED_INTERVAL:
            single.dent_interval.map(DentInterval::diameter_text);
        /// Area of the dent, from the contact radius at the maximum indentation; 0 without a dent.
        "dent_area_m2" in Area [Peening: |row| row.peened.map(|peened| peened.dent_area)];
        /// Mass of a shot.
        "shot_mass_kg" in Mass [Peening: |row| row.peened.map(|peened| peened.shot_mass)];
        /// Impacts per area, at random places, for the coverage that the scenario asks for; `null` without a dent.
        "impacts_for_coverage_per_m2" in ArealNumber briefly "impacts for the coverage"
            [Peening: |row| row.peened.and_then(|peened| peened.impacts_per_area())];
        /// Mass of shot per area for this coverage.
        "mass_for_coverage_kg_per_m2" in ArealMass briefly "mass for the coverage"
            [Peening: |row| row.peened.and_then(|peened| peened.mass_per_area())];
        /// Time for this coverage.
        "time_for_coverage_s" in Time briefly "time for the coverage"
            [MassFlow: |row| row.peened.and_then(|peened| peened.time())];
        /// Covered fraction of the surface after the time that the scenario gives.
        "coverage_after_time" in Percent briefly "coverage after the time"
            [PeeningTime: |row| row.peened.and_then(|peened| peened.coverage_after_time())];
        /// Depth of the plastic zone below the centre of a single dent, from formulas fitted to finite elements.
        "plastic_zone_depth_m" in Length briefly "plastic zone depth" [Subsurface: |row| row.subsurface.map(|below| below.zone_depth())];
        /// Standard deviation of this depth from the finite elements.
        "plastic_zone_depth_sd_m" in Length briefly "± {}"
            [Subsurface: |row| row.subsurface.map(|below| ZONE_DEPTH_SCATTER * below.zone_depth())];
        /// Depth of the layer with radial compression below the centre of a single dent.
        "compressive_layer_depth_m" in Length briefly "compressive layer depth"
            [Subsurface: |row| row.subsurface.map(|below| below.layer_depth())];
        /// Standard deviation of this depth from the finite elements.
        "compressive_layer_depth_sd_m" in Length briefly "± {}"
            [Subsurface: |row| row.subsurface.map(|below| LAYER_DEPTH_SCATTER * below.layer_depth())];
        /// Largest radial residual compression below the centre of a single dent, as a positive stress.
        "residual_compression_Pa" in Pressure briefly "largest residual compression"
            [Subsurface: |row| row.subsurface.map(|below| below.largest_compression())];
        /// Standard deviation of this stress from the finite elements.
        "residual_compression_sd_Pa" in Pressure briefly "± {}"
            [Subsurface: |row| row.subsurface.map(|below| COMPRESSION_SCATTER * below.representative_strength())];
        /// Impact speed above which a body yields.
        "yield_speed_m_per_s" in Speed as "yield speed" if REACHES: single.at_first_yield(single.contact.yield_speed());
        /// Indentation at first yield.
        "yield_indentation_m" in Length if REACHES:
            single.at_first_yield(single.contact.yield_indentation_and_force().map(|(indentation, _)| indentation));
        /// Force at first yield.
        "yield_force_N" in Force as "yield force {}" if REACHES:
            single.at_first_yield(single.contact.yield_indentation_and_force().map(|(_, force)| force));
        /// Strain rate during loading. Strain rate and the two factors below are empty for an impact that does not deform the
        /// existing dent.
        "strain_rate_per_s" in StrainRate as "strain rate" [Rate: |row| row.strain_rate_result.map(|rated| rated.strain_rate)];
        /// Ratio of dynamic to quasi-static strength during loading.
        "rate_factor" as "strain-rate factor {}" [Rate: |row| row.strain_rate_result.map(|rated| rated.factor)];
        /// Ratio of dynamic to quasi-static strength at maximum compression, after the relaxation of the metal.
        "rate_factor_at_peak" as "at maximum compression {}" [Rate: |row| row.strain_rate_result.map(|rated| rated.factor_at_peak)];
        /// Recovered fraction of the normal kinetic energy: the square of the restitution.
        "recovered_fraction" in Percent if TABLES [Nothing: |row| row.has_speed().then(|| row.recovered_fraction())];
        /// Plastic work over normal kinetic energy; with gravity the fraction may exceed 1.
        "plastic_fraction" in Percent if TABLES [Strength: |row| row.has_speed().then_some(row.plastic_fraction)];
        /// `separated` or `captured`.
        "outcome" as "outcome" if FORCES: single.if_forces(|under| under.fate.name());
        /// Time of separation; for a captured sphere, the time at which the computation ends.
        "end_time_s" in Time as "at {}" if FORCES: single.if_forces(|under| under.end_time);
        /// Indentation at separation, or at the end of the computation.
        "end_indentation_m" in Length if FORCES: single.if_forces(|under| under.end_indentation);
        /// Indentation at which a captured sphere comes to rest.
        "static_indentation_m" in Length as "final indentation {}" if CAPTURED:
            single.if_forces(|under| under.static_indentation).flatten();
        /// Time step.
        "verlet.step_s" in Time as "verlet step" if VERLET: single.if_fixed_steps(|seen| seen.step);
        /// Time from first contact to the deepest step.
        "verlet.compression_time_s" in Time as "compression {}" if VERLET: single.if_fixed_steps(|seen| seen.compression_time);
        /// Time from first contact to the first step without a repulsive force; `null` for a captured sphere.
        "verlet.separation_time_s" in Time as "separation {}" if VERLET: single.if_fixed_steps(|seen| seen.separation_time);
        /// Relative error of the energy at the end of the contact; positive for a gain.
        "verlet.energy_error_at_end" in Error as "energy error at the end {}" if VERLET:
            single.if_fixed_steps(|_| ()).map(|()| single.impact.energy.error_at_end);
        /// Impulse of the force: the spectrum at frequency 0.
        "pulse.impulse_N_s" in Impulse as "impulse" if PULSE: single.pulse.map(|pulse| pulse.impulse);
        /// Relative error of this impulse against the change of momentum, the mass times the sum of impact and rebound speed; with
        /// gravity also the weight times the contact time.
        "pulse.impulse_error" in Error as "error against the momentum {}" if PULSE: single.pulse.map(|pulse| pulse.impulse_error.abs());
        /// Frequency at which the spectrum of the force has fallen to the impulse over the square root of 2.
        "pulse.corner_frequency_Hz" in Frequency as "corner frequency" if PULSE: single.pulse.and_then(|pulse| pulse.corner_frequency);
        /// Frequency of the first minimum of the spectrum, which is a zero if the pulse is symmetric in time.
        "pulse.first_minimum_Hz" in Frequency as "first minimum of the spectrum {}" if PULSE:
            single.pulse.and_then(|pulse| pulse.first_minimum);
        /// Kinetic energy of the normal relative motion at first contact.
        "energy.kinetic_in_J" in Energy as "energy": single.impact.energy.kinetic_in;
        /// Kinetic energy of the normal motion at separation.
        "energy.recovered_J" in Energy as "{%} recovered": single.impact.energy.recovered;
        /// Plastic work.
        "energy.plastic_J" in Energy as "{%} plastic work" if YIELDS: single.impact.energy.plastic;
        /// Kinetic energy of the centre of mass of sphere and free target; constant.
        "energy.centre_of_mass_J" in Energy as "centre-of-mass energy {}" if FREE: single.impact.energy.centre_of_mass;
        /// Energy in the plate at separation, or at the end of the computation of a captured sphere.
        "energy.plate_J" in Energy as "{%} plate loss" if PLATE: single.if_plate(|plate| plate.energy);
        /// Energy in the rod at separation, or at the end of the computation of a captured sphere.
        "energy.rod_J" in Energy as "{%} rod loss" if ROD: single.if_rod(|rod| rod.energy);
        /// Energy absorbed by damping.
        "energy.damping_J" in Energy as "{%} damping loss" if DAMPING: single.if_forces(|under| under.damping_loss).flatten();
        /// Elastic energy left in the contact if the sphere separates before the contact has recovered.
        "energy.stored_at_separation_J" in Energy as "{%} elastic energy lost at separation" if VISCOUS:
            single.if_forces(|under| under.stored_at_separation).flatten();
        /// Kinetic and elastic energy at the end of the computation of a captured sphere.
        "energy.remaining_J" in Energy as "{%} remaining energy" if CAPTURED: single.if_forces(|under| under.remaining_energy).flatten();
        /// Work of gravity since first contact: weight times displacement of the sphere's centre.
        "energy.gravity_work_J" in Energy as "{%} from gravity" if GRAVITY: single.if_forces(|under| under.gravity_work).flatten();
        /// Kinetic energy of tangential motion and spin at first contact.
        "energy.tangential_in_J" in Energy as "along the surface" if OBLIQUE: single.if_oblique(|friction| friction.kinetic_in);
        /// Kinetic energy of tangential motion and spin at separation.
        "energy.tangential_recovered_J" in Energy as "{%} recovered" if OBLIQUE: single.if_oblique(|friction| friction.recovered);
        /// Energy absorbed by friction.
        "energy.friction_J" in Energy as "{%} friction loss" if OBLIQUE: single.if_oblique(|friction| friction.loss);
        /// Relative error of the angular momentum about the contact point; expected to be a rounding error.
        "energy.angular_momentum_error" in Error if OBLIQUE: single.if_oblique(|friction| friction.momentum_error);
        /// Maximum error of the energy balance relative to the energy input: kinetic energy at first contact, plus the work of
        /// gravity until maximum compression.
        "energy.balance_error" in Error as "energy balance error {}": single.impact.energy.balance_error;
        /// Restitution by the closed form. This value and the two errors below are `null` if no closed form exists.
        "accuracy.closed_form_restitution" as "closed form": single.impact.accuracy.closed_form_restitution;
        /// Relative difference of the restitution from the closed form.
        "accuracy.restitution_error" in Error as "deviation of restitution {}": single.impact.accuracy.restitution_error;
        /// Relative difference of the contact time from the closed form.
        "accuracy.contact_time_error" in Error as "deviation of contact time {}": single.impact.accuracy.contact_time_error;
        /// Steps of the integration.
        "work.steps" as "steps": single.impact.stats.steps;
        /// Steps that were repeated with a shorter step length.
        "work.rejected" as "{} rejected": single.impact.stats.rejected;
        /// Number of evaluations of the contact force.
        "work.force_evaluations" as "{} force evaluations": single.impact.stats.force_evaluations;
        /// Notes on the strength and on the unloading exponent, if the scenario does not define them.
        "notes" if NOTES: (!single.notes.is_empty()).then(|| single.notes.to_vec());
        /// Warnings about scenario, model and run.
        "warnings": single.impact.warnings.iter().map(ToString::to_string).collect::<Vec<_>>();
        /// Effective modulus E* of the pair of bodies.
        "effective_modulus_Pa" in Pressure: single.contact.pair().effective_modulus;
        /// Fraction of the elastic approach in the sphere; 0 for a rigid sphere.
        "sphere_compliance": single.contact.pair().sphere_compliance;
        /// Mass of the sphere.
        "sphere_mass_kg" in Mass: single.contact.mass();
        /// Exponent of the unloading force.
        "unloading_exponent": single.impact.unloading_exponent;
    }
}
