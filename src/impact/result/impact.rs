//! The result of an impact in SI units, for reports and pictures.

use super::energy_balance::{EnergyBalance, TraceRow};
use super::row::ImpactRow;
use super::warning::Warning;
use crate::impact::oblique::{Approach, ObliqueImpact, ObliqueResult};
use crate::impact::problem::contact::Contact;
use crate::impact::problem::error::ImpactError;
use crate::impact::scaled_impact::ScaledImpact;
use crate::impact::solve::Method;
use crate::impact::solve::outcome::{FixedSteps, ImpactEnd, ScaledResult, Solution};
use crate::numerics::ode::SolverStats;

/// The energies of an impact \[J\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Energy {
    /// ½ m* v².
    pub kinetic_in: f64,
    /// Kinetic energy of the common motion of the sphere and a free target. It does not change.
    pub centre_of_mass: Option<f64>,
    /// ½ m* (e v)².
    pub recovered: f64,
    /// Plastic work, W(δ_m) − F_m δ_e/(n + 1); `None` if no body has a yield strength.
    pub plastic: Option<f64>,
    /// Largest |kinetic + stored + lost − ½ m v²| / ½ m v² at the peak, at separation and on every row of the trace: the error that
    /// the run itself can detect.
    pub balance_error: f64,
    /// The error of the energy balance at the end of the contact, relative as `balance_error`; positive for a gain.
    pub error_at_end: f64,
}

/// The error of the integration against the closed form (both relative).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Accuracy {
    pub closed_form_restitution: f64,
    /// |e − e_exact| / e_exact.
    pub restitution_error: f64,
    /// |T − T_exact| / T_exact.
    pub contact_time_error: f64,
}

impl Accuracy {
    /// The errors of an outcome; NaN without a closed form.
    fn from_outcomes(outcome: &ScaledResult, exact: Option<&ScaledResult>) -> Self {
        let relative = |got: f64, want: f64| if got == want { 0.0 } else { (got / want - 1.0).abs() };
        let error =
            |part: fn(&ScaledResult) -> f64| exact.map_or(f64::NAN, |exact| relative(part(outcome), part(exact)));
        Self {
            closed_form_restitution: exact.map_or(f64::NAN, |exact| exact.restitution),
            restitution_error: error(|outcome| outcome.restitution),
            contact_time_error: error(|outcome| outcome.contact_time),
        }
    }
}

/// Additional results under gravity, under damping, or on a plate or rod. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForcesResult {
    pub fate: ImpactEnd,
    /// Time of separation, or of the end of the run of a captured sphere \[s\].
    pub end_time: f64,
    /// δ at that time \[m\].
    pub end_indentation: f64,
    /// δ at which the unloading branch carries the weight \[m\]: the position of rest of a captured sphere.
    pub static_indentation: Option<f64>,
    /// Energy absorbed by damping \[J\] until separation, or until the end of the run of a captured sphere.
    pub damping_loss: Option<f64>,
    /// Elastic energy left \[J\] if the sphere separates before the contact has recovered, as under viscous damping and in a viscoelastic
    /// contact. No force is left then, so the damping of the contact absorbs this energy afterwards. `None` if the contact has recovered
    /// by rule.
    pub stored_at_separation: Option<f64>,
    /// Kinetic and elastic energy \[J\] where the run of a captured sphere ends.
    pub remaining_energy: Option<f64>,
    /// m g times the displacement of the centre of the sphere since first contact \[J\]: its indentation, and the displacement of a plate or rod.
    pub gravity_work: Option<f64>,
}

impl ForcesResult {
    fn new(
        contact: &Contact,
        case: &ScaledImpact,
        outcome: &ScaledResult,
        row: &ImpactRow,
        balance: &EnergyBalance,
    ) -> Self {
        let ScaledImpact { scales, ground, forces, .. } = case;
        let (length, energy) = (scales.units.length, scales.units.energy());
        let is_captured = outcome.end == ImpactEnd::Captured;
        let lifts_off = !is_captured && forces.damping.can_lift_off();
        let moved = row.waveguide.map_or(0.0, |waveguide| waveguide.displacement / length);
        let sunk = outcome.end_indentation - ground.first_contact() + moved;
        let at_rest = || forces.static_equilibrium(*ground, &outcome.unloading).indentation * length;
        let stored = || outcome.unloading.stored_energy(outcome.end_indentation) * energy;
        Self {
            fate: outcome.end,
            end_time: outcome.contact_time * scales.time(),
            end_indentation: outcome.end_indentation * length,
            static_indentation: is_captured.then(at_rest),
            damping_loss: contact.forces().damping.map(|_| outcome.loss * energy),
            stored_at_separation: lifts_off.then(stored),
            remaining_energy: is_captured.then(|| balance.remaining_energy() * energy),
            gravity_work: contact.forces().gravity.map(|_| forces.weight * sunk * energy),
        }
    }
}

/// One impact, for reports and pictures. SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Impact {
    /// Impact speed v \[m/s\]; for an oblique impact the magnitude of the velocity.
    pub speed: f64,
    /// The method that computed the impact. For `Auto` it is the method that `Auto` chose.
    pub method: Method,
    /// The results that a row of a table has too.
    pub row: ImpactRow,
    /// Speed of the sphere \[m/s\], normal to the half-space: e v if the target is fixed.
    pub rebound_speed: f64,
    /// First contact to maximum compression \[s\], by [`Method::Verlet`] within a step.
    pub loading_time: f64,
    /// δ_sm \[m\].
    pub peak_sphere_indentation: f64,
    /// δ_e = δ_m − δ_r \[m\].
    pub elastic_approach: f64,
    pub unloading_exponent: f64,
    /// R_e \[m\] of the peak that shaped the dent, (3 F_m/4E*)²/δ_e³ (Eq. 24), also if the branch is no power law with n = 3/2;
    /// R without a dent.
    pub unloading_radius: f64,
    /// R_res \[m\] (Eq. 25): radius of curvature of the dent; `None` without one.
    pub residual_radius: Option<f64>,
    /// F_m \[N\]: the force at δ_m, where the sphere stands still. Under damping the peak force comes before it.
    pub force_at_peak_indentation: f64,
    /// F_m/(π a_m²) \[Pa\].
    pub peak_mean_pressure: f64,
    /// Radius of the dent \[m\]: the contact radius at the peak that shaped it; `None` without a dent.
    pub dent_radius: Option<f64>,
    pub energy: Energy,
    pub stats: SolverStats,
    /// Error against the closed form; NaN if there is no closed form.
    pub accuracy: Accuracy,
    /// End, losses and work under gravity, damping, or on a plate or rod, if the scene names them.
    pub forces_result: Option<ForcesResult>,
    /// The times in fixed steps, by [`Method::Verlet`].
    pub fixed_steps: Option<FixedSteps>,
    /// Energy, momentum and error of an oblique impact; its other results are in `row.rebound`.
    pub oblique: Option<ObliqueResult>,
    /// The warnings about the model and the run.
    pub warnings: Vec<Warning>,
    /// The trace, in order of time; empty if no trace is requested.
    pub trace: Vec<TraceRow>,
}

impl Impact {
    /// The result of a computed impact, without warnings. `exact` is the closed form, if it exists.
    pub(in crate::impact) fn new(
        contact: &Contact,
        speed: f64,
        case: &ScaledImpact,
        method: Method,
        computed: &Solution,
        exact: Option<&ScaledResult>,
    ) -> Result<Self, ImpactError> {
        let ScaledImpact { scales, ground, .. } = case;
        let Solution { outcome, stats: work, fixed_steps, trace_points: points } = computed;
        let row = ImpactRow::new(contact, speed, case, outcome)?;
        let ImpactRow { restitution, kinetic_in, peak_contact_radius, .. } = row;
        let pair = contact.pair();
        let peak = &outcome.unloading.peak;
        let balance = EnergyBalance::new(contact, case, outcome);
        let (trace, balance_error) = balance.rows(points)?;
        let has_dent = row.has_dent();
        let is_in_half_space = row.dent_depth() > 0.0;
        let dent = ground.deepest_state(peak);
        let radius_ratio = dent.unloading_radius_ratio();
        let energy = scales.units.energy();
        let has_forces = !contact.forces().is_none();
        let forces_result = has_forces.then(|| ForcesResult::new(contact, case, outcome, &row, &balance));
        Ok(Self {
            speed,
            method,
            row,
            rebound_speed: contact.speeds_after(speed, restitution).0,
            loading_time: outcome.loading_time * scales.time(),
            peak_sphere_indentation: pair.sphere_indentation(peak.indentation, peak.elastic_approach)
                * scales.units.length,
            elastic_approach: peak.elastic_approach * scales.units.length,
            unloading_exponent: outcome.unloading.exponent,
            unloading_radius: if has_dent { pair.radius * radius_ratio } else { pair.radius },
            residual_radius: (is_in_half_space && radius_ratio > 1.0)
                .then(|| pair.radius * (radius_ratio / (radius_ratio - 1.0))),
            force_at_peak_indentation: peak.force * scales.units.force,
            peak_mean_pressure: peak.force * scales.units.force
                / (std::f64::consts::PI * peak_contact_radius)
                / peak_contact_radius,
            dent_radius: is_in_half_space.then(|| scales.units.contact_radius * ground.contact_radius(&dent)),
            energy: Energy {
                kinetic_in,
                centre_of_mass: contact.target_mass().map(|target| kinetic_in * (contact.mass() / target)),
                recovered: kinetic_in * row.recovered_fraction(),
                plastic: pair.yield_point.map(|_| ground.plastic_work(&outcome.unloading) * energy),
                balance_error,
                error_at_end: balance.error_at_end(),
            },
            stats: *work,
            accuracy: Accuracy::from_outcomes(outcome, exact),
            forces_result,
            fixed_steps: fixed_steps.map(|seen| seen.in_seconds(scales.time())),
            oblique: None,
            warnings: Vec::new(),
            trace,
        })
    }

    /// Adds the results of friction to an oblique impact, whose other results describe the normal motion.
    pub(in crate::impact) fn add_friction(
        &mut self,
        inclined: &ObliqueImpact,
        approach: Approach,
    ) -> Result<(), ImpactError> {
        let slip = inclined.slip_result(true)?;
        self.speed = approach.speed();
        self.row.rebound = Some(inclined.rebound(&slip)?);
        self.oblique = Some(inclined.result(&slip));
        for row in &mut self.trace {
            row.friction =
                Some(inclined.friction_at(&slip, row.time, row.sphere_speed.unwrap_or(row.speed), row.force));
        }
        Ok(())
    }

    /// The results of a captured sphere; `None` for a sphere that separates.
    pub fn captured_result(&self) -> Option<&ForcesResult> {
        self.forces_result.as_ref().filter(|under| under.fate == ImpactEnd::Captured)
    }

    /// The simulated time \[s\]: the contact time, or the time to the end of the run of a captured sphere.
    pub fn duration(&self) -> f64 {
        self.captured_result().map_or(self.row.contact_time, |under| under.end_time)
    }
}
