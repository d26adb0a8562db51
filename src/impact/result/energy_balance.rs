//! The energy balance of one impact, and the rows of a trace, which contain its error.

use crate::contact::law::{Branch, ContactState};
use crate::impact::oblique::FrictionState;
use crate::impact::problem::contact::Contact;
use crate::impact::problem::scales::{FORCE_FACTOR, kinetic_energy};
use crate::impact::scaled_impact::ScaledImpact;
use crate::impact::solve::outcome::{ImpactEnd, ScaledResult};
use crate::impact::solve::recorder::{Event, TracePoint};
use crate::numerics::ode::{IntegrationError, MotionState};
use crate::numerics::power::nan_max;

/// A row of the trace of an impact. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TraceRow {
    /// Time since first contact \[s\].
    pub time: f64,
    /// δ \[m\].
    pub indentation: f64,
    /// δ_s \[m\], the part of the sphere; 0 for a rigid sphere.
    pub sphere_indentation: f64,
    /// δ_h = δ − δ_s \[m\], the part of the half-space.
    pub half_space_indentation: f64,
    /// δ' \[m/s\]: positive into the half-space, negative during the rebound.
    pub speed: f64,
    /// Speed of the centre of the sphere \[m/s\], the sum of δ' and the speed of the plate or rod; `None` without them.
    pub sphere_speed: Option<f64>,
    /// The contact force \[N\]: F of the law and damping.
    pub force: f64,
    /// F/A \[Pa\] at the end of a rod; `None` without a rod.
    pub rod_stress: Option<f64>,
    /// F of the law alone \[N\], if there is damping.
    pub elastic_force: Option<f64>,
    pub branch: Branch,
    /// Friction, in an oblique impact.
    pub friction: Option<FrictionState>,
    pub event: Option<Event>,
    /// (kinetic + stored + lost)/(½ m v²) − 1.
    pub energy_balance_error: f64,
}

/// The energy balance of one impact, in units of Φ L: kinetic + stored + lost in dent and drag − m g δ = ½ m v². On a waveguide
/// its "kinetic" and "lost" differ from the energies of sphere and waveguide, which [`crate::impact::problem::waveguide`] defines; their
/// sum is equal.
pub(in crate::impact) struct EnergyBalance<'a> {
    contact: &'a Contact,
    case: &'a ScaledImpact<'a>,
    outcome: &'a ScaledResult,
    /// ½ m v²; 0 for a sphere released at rest.
    kinetic: f64,
    /// The work spent on the dent.
    input_energy: f64,
}

impl<'a> EnergyBalance<'a> {
    pub(in crate::impact) fn new(contact: &'a Contact, case: &'a ScaledImpact, outcome: &'a ScaledResult) -> Self {
        let input_energy = case.ground.plastic_work_unrounded(&outcome.unloading);
        Self { contact, case, outcome, kinetic: kinetic_energy(case.q), input_energy }
    }

    /// The error of the sum, over ½ m v² + m g δ_m. During loading W(x) is the stored and the plastic energy together.
    fn balance_error(&self, speed: f64, potential: f64, loss: f64, indentation: f64) -> f64 {
        let sunk = |x: f64| self.case.forces.weight * (x - self.case.ground.first_contact());
        let put_in = self.kinetic + sunk(self.outcome.unloading.peak.indentation);
        (kinetic_energy(speed) + potential + loss - sunk(indentation) - self.kinetic) / put_in
    }

    /// The error at the end of the contact.
    pub(in crate::impact) fn error_at_end(&self) -> f64 {
        let ScaledResult { unloading, end_indentation: x, end_speed, loss, end: fate, .. } = *self.outcome;
        // at the bottom of the dent no energy is stored, but x has too few digits to show this
        let is_at_dent = fate == ImpactEnd::Separated && !self.case.forces.damping.can_lift_off();
        let stored = if is_at_dent { 0.0 } else { unloading.stored_energy(x) };
        self.balance_error(end_speed, self.input_energy + stored, loss, x)
    }

    /// Kinetic and elastic energy at the end of the contact. The sphere moves with its plate or rod.
    pub(in crate::impact) fn remaining_energy(&self) -> f64 {
        let ScaledResult { unloading, end_indentation: x, end_speed, .. } = *self.outcome;
        let force = unloading.force_at_elastic_approach(x - self.case.ground.deepest_state(&unloading.peak).residual());
        let speed = end_speed + self.case.waveguide.map_or(0.0, |waveguide| waveguide.mobility * force);
        kinetic_energy(speed) + unloading.stored_energy(x)
    }

    /// The error at the peak. With damping the loss up to the peak is not known, and the error is set to 0.
    fn error_at_peak(&self) -> f64 {
        if !self.case.forces.is_conservative() {
            return 0.0;
        }
        let peak = &self.outcome.unloading.peak;
        self.balance_error(0.0, self.case.ground.loading_work(peak), 0.0, peak.indentation)
    }

    /// The row of the trace at a point of the motion.
    fn row(&self, point: &TracePoint) -> TraceRow {
        let TracePoint { at: MotionState { time, speed, loss, .. }, state, total_force, is_unloading, event } = *point;
        let ContactState { indentation: x, force, elastic_approach } = state;
        let ScaledImpact { ground, scales, .. } = self.case;
        let potential = if is_unloading {
            self.outcome.unloading.stored_energy_at(elastic_approach) + self.input_energy
        } else {
            ground.loading_work(&state)
        };
        let branch = match () {
            () if is_unloading => Branch::Unloading,
            () if ground.reloading_branch_at(x).is_some() => Branch::Reloading,
            () if elastic_approach < x => Branch::Plastic,
            () => Branch::Elastic,
        };
        let indentation = x * scales.units.length;
        let sphere_indentation = self.contact.pair().sphere_indentation(x, elastic_approach) * scales.units.length;
        TraceRow {
            time: time * scales.time(),
            indentation,
            sphere_indentation,
            half_space_indentation: indentation - sphere_indentation,
            speed: speed * scales.speed,
            sphere_speed: self.case.waveguide.map(|waveguide| (speed + waveguide.mobility * force) * scales.speed),
            force: total_force * scales.units.force,
            rod_stress: self.case.waveguide.and_then(|waveguide| {
                let rod = waveguide.target.guide.rod()?;
                Some(total_force * scales.units.force / rod.cross_section())
            }),
            elastic_force: self.contact.forces().damping.map(|_| force * scales.units.force),
            branch,
            friction: None,
            event,
            energy_balance_error: self.balance_error(speed, potential, loss / FORCE_FACTOR, x),
        }
    }

    /// The rows of a trace at these points, and the largest error in them, at the peak and at the end.
    pub(in crate::impact) fn rows(&self, points: &[TracePoint]) -> Result<(Vec<TraceRow>, f64), IntegrationError> {
        let mut rows: Vec<TraceRow> = points.iter().map(|point| self.row(point)).collect();
        let errors = rows.iter().map(|row| row.energy_balance_error);
        let errors = errors.chain([self.error_at_peak(), self.error_at_end()]);
        let largest = errors.fold(0.0, |worst, error: f64| nan_max(worst, error.abs()));
        if !largest.is_finite() {
            // from the first row of the trace on, or from the end
            let row = rows.iter().find(|row| !row.energy_balance_error.is_finite());
            let time = row.map_or(self.outcome.contact_time, |row| row.time / self.case.scales.time());
            return Err(IntegrationError::NotFinite { time });
        }
        remove_duplicate_end_rows(&mut rows);
        Ok((rows, largest))
    }
}

/// Removes rows at the time of the last row, a sample or a peak, because the last row holds the same values.
fn remove_duplicate_end_rows(trace: &mut Vec<TraceRow>) {
    while let [.., before, end] = trace.as_slice()
        && before.time == end.time
    {
        trace.remove(trace.len() - 2);
    }
}
