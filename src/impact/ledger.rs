//! The energy ledger of one impact, and the rows of a trace, which show it.

use super::case::Case;
use super::essentials::Essentials;
use super::oblique::Rubbing;
use super::outcome::Outcome;
use super::record::{Event, Point};
use super::scales::Scales;
use crate::law::{Branch, Peak};

/// One row of a trace.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TraceRow {
    /// Since first touch \[s\].
    pub time: f64,
    /// δ \[m\].
    pub indentation: f64,
    /// δ_s \[m\], the sphere's share; 0 for a rigid sphere.
    pub sphere_indentation: f64,
    /// δ_h = δ − δ_s \[m\], the half-space's share.
    pub half_space_indentation: f64,
    /// δ' \[m/s\]: positive into the half-space, negative on the way out.
    pub speed: f64,
    /// Speed of the sphere's centre \[m/s\], which is δ' and that of the plate, if there is a plate.
    pub sphere_speed: Option<f64>,
    /// The contact force \[N\]: F of the law and damping.
    pub force: f64,
    /// F of the law alone \[N\], if there is damping.
    pub elastic_force: Option<f64>,
    /// Branch of the law.
    pub branch: Branch,
    /// Friction, in an oblique impact.
    pub rubbing: Option<Rubbing>,
    /// The event, if the row is one.
    pub event: Option<Event>,
    /// (kinetic + stored + lost)/(½ m v²) − 1.
    pub energy_drift: f64,
}

/// The energy ledger of one impact, in units of Φ L: kinetic + stored + lost in dent and drag − m g δ = ½ m v².
/// On a plate its "kinetic" and "lost" are not those of sphere and plate, which [`super::plate`] gives; their sum is.
pub(super) struct Ledger<'a> {
    case: &'a Case<'a>,
    outcome: &'a Outcome,
    /// ½ m v².
    kinetic: f64,
    /// V/v.
    unit_of_speed: f64,
    /// The work spent on the dent.
    spent: f64,
}

impl<'a> Ledger<'a> {
    pub(super) fn new(case: &'a Case, speed: f64, essentials: &Essentials, outcome: &'a Outcome) -> Self {
        let Case { scales, law, q, forces, .. } = case;
        // 0 for a sphere that is let go at rest
        let kinetic = if forces.is_none() { essentials.kinetic_in / scales.energy() } else { 0.4 * q * q };
        let spent = law.spent(&outcome.unloading);
        Self { case, outcome, kinetic, unit_of_speed: scales.speed / speed, spent }
    }

    /// The error of the sum, over ½ m v² + m g δ_m. While loading, W(x) stands for stored and plastic energy together.
    fn drift(&self, speed: f64, potential: f64, loss: f64, indentation: f64) -> f64 {
        let Case { law, forces, .. } = self.case;
        if forces.is_none() {
            let ratio = speed * self.unit_of_speed;
            return ratio * ratio + potential / self.kinetic - 1.0;
        }
        let sunk = |x: f64| forces.weight * (x - law.touch());
        let put_in = self.kinetic + sunk(self.outcome.unloading.peak.indentation);
        (0.4 * speed * speed + potential + loss - sunk(indentation) - self.kinetic) / put_in
    }

    /// The error at the end of the contact.
    pub(super) fn at_end(&self) -> f64 {
        let Outcome { unloading, restitution, end_indentation, end_speed, loss, .. } = self.outcome;
        if self.case.forces.is_none() {
            return restitution * restitution + self.spent / self.kinetic - 1.0;
        }
        self.drift(*end_speed, self.spent + unloading.stored(*end_indentation), *loss, *end_indentation)
    }

    /// The error at the peak. With damping the loss up to the peak is not known, and this is 0.
    pub(super) fn at_peak(&self) -> f64 {
        if !self.case.forces.is_conservative() {
            return 0.0;
        }
        let peak = &self.outcome.unloading.peak;
        self.drift(0.0, self.case.law.work_to(peak), 0.0, peak.indentation)
    }

    /// A row of the trace.
    pub(super) fn row(&self, point: &Point, scales: &Scales, sphere_compliance: f64) -> TraceRow {
        let Point { time, indentation: x, speed, force, total_force, elastic_approach, loss, is_unloading, event } =
            *point;
        let law = self.case.law;
        let potential = if is_unloading {
            self.outcome.unloading.stored_of(elastic_approach) + self.spent
        } else {
            law.work_to(&Peak { indentation: x, force, elastic_approach })
        };
        let branch = match () {
            () if is_unloading => Branch::Unloading,
            () if law.branch_at(x).is_some() => Branch::Reloading,
            () if elastic_approach < x => Branch::Plastic,
            () => Branch::Elastic,
        };
        let indentation = x * scales.length;
        let sphere_indentation = sphere_compliance * elastic_approach * scales.length;
        TraceRow {
            time: time * scales.time(),
            indentation,
            sphere_indentation,
            half_space_indentation: indentation - sphere_indentation,
            speed: speed * scales.speed,
            sphere_speed: self.case.plate.map(|_| (speed + self.case.forces.plate * force) * scales.speed),
            force: total_force * scales.force,
            elastic_force: self.case.forces.damping.map(|_| force * scales.force),
            branch,
            rubbing: None,
            event,
            energy_drift: self.drift(speed, potential, loss, x),
        }
    }
}
