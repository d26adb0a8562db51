//! The results of an indentation: those of every half-space, of every step, and the columns of the trace.

use super::entry::{Reported, file, results};
use crate::indentation::{Step, Target, Tested};

/// The results of one half-space, in the order of `summary.json`.
pub fn half_space() -> Vec<Reported<Tested>> {
    results! { |of: Tested|
        /// Name of the half-space.
        "name" if NAMED: of.specimen.name.clone();
        /// Young's modulus.
        "youngs_modulus_Pa" in Pressure: of.specimen.half_space.material.youngs_modulus;
        /// Poisson's ratio.
        "poissons_ratio": of.specimen.half_space.material.poissons_ratio;
        /// Yield strength.
        "yield_strength_Pa" in Pressure if YIELDS: of.specimen.half_space.yield_strength;
        /// Effective modulus E* of the pair of bodies.
        "effective_modulus_Pa" in Pressure: of.pair.effective_modulus;
        /// The sphere's share of the elastic approach; 0 for a rigid sphere.
        "sphere_compliance": of.pair.sphere_compliance;
        /// Indentation at first yield.
        "yield_indentation_m" in Length if YIELDS: of.pair.yield_point.map(|point| point.indentation);
        /// Force at first yield.
        "yield_force_N" in Force if YIELDS: of.pair.yield_point.map(|point| point.force);
        /// Work of all steps.
        "work_J" in Energy: of.indentation.steps.iter().map(|step| step.work).sum::<f64>();
        /// Energy spent on the dent in all steps.
        "plastic_work_J" in Energy if YIELDS: of.can_yield.then(|| {
            of.indentation.steps.iter().map(|step| step.plastic_work).sum::<f64>()
        });
    }
}

/// The steps of one half-space.
pub fn stepped(of: &Tested) -> Vec<Stepped<'_>> {
    (1..).zip(&of.indentation.steps).map(|(number, step)| Stepped { number, step, tested: of }).collect()
}

/// One step of an indentation.
#[derive(Debug, Clone, Copy)]
pub struct Stepped<'a> {
    pub number: usize,
    pub step: &'a Step,
    /// All of the half-space.
    pub tested: &'a Tested,
}

/// The results of one step.
pub fn step<'a>() -> Vec<Reported<Stepped<'a>>> {
    results! { |of: Stepped<'a>|
        /// Number of the step, from 1.
        "step" as "step": of.number;
        /// Load at which the step ends.
        "target_load_N" in Force as "to" if GIVEN: match of.step.target {
            Target::Load(load) => Some(load),
            Target::Indentation(_) => None,
        };
        /// Indentation at which the step ends.
        "target_indentation_m" in Length as "to" if GIVEN: match of.step.target {
            Target::Load(_) => None,
            Target::Indentation(indentation) => Some(indentation),
        };
        /// Branch of the law at its end: `elastic`, `plastic`, `unloading`, `reloading` or `separated`.
        "branch": of.step.branch.name();
        /// Indentation at its end.
        "indentation_m" in Length as "indentation": of.step.indentation;
        /// The sphere's own share of the indentation.
        "sphere_indentation_m" in Length: of.step.sphere_indentation;
        /// Force at its end.
        "force_N" in Force as "force": of.step.force;
        /// Work done in the step; negative on unloading.
        "work_J" in Energy as "work": of.step.work;
        /// Elastic energy in the contact at its end.
        "stored_energy_J" in Energy: of.step.stored_energy;
        /// Energy spent on the dent in the step.
        "plastic_work_J" in Energy as "plastic work" if YIELDS: of.tested.can_yield.then_some(of.step.plastic_work);
        /// Largest force so far.
        "peak_force_N" in Force: of.step.memory.force;
        /// Largest indentation so far.
        "peak_indentation_m" in Length: of.step.memory.indentation;
        /// Contact radius at that indentation.
        "peak_contact_radius_m" in Length as "contact radius": of.step.memory.contact_radius;
        /// Largest force over the contact area there.
        "peak_mean_pressure_Pa" in Pressure: of.step.memory.mean_pressure;
        /// Depth of the dent.
        "residual_indentation_m" in Length as "dent depth" if YIELDS: of.tested.can_yield.then_some(of.step.memory.residual_indentation);
        /// Slope of the unloading branch at its top.
        "unloading_stiffness_N_per_m" in Stiffness as "stiffness S": of.step.memory.unloading_stiffness;
        /// Exponent of the force on unloading.
        "unloading_exponent": of.step.memory.unloading_exponent;
    }
}

/// A row of the trace, with the name of the half-space.
pub type Traced<'a> = (Option<&'a str>, &'a crate::indentation::TraceRow);

/// The columns of `trace.csv`.
pub fn trace<'a>() -> Vec<Reported<Traced<'a>>> {
    results! { |row: Traced<'a>|
        /// Name of the half-space.
        "half_space" if NAMED: row.0.map(str::to_owned);
        /// Number of the step, from 1.
        "step": row.1.step;
        /// Indentation.
        "indentation_m" in Length: row.1.indentation;
        /// The sphere's own share of the indentation.
        "sphere_indentation_m" in Length: row.1.sphere_indentation;
        /// The half-space's share of the indentation.
        "half_space_indentation_m" in Length: row.1.half_space_indentation;
        /// Force.
        "force_N" in Force: row.1.force;
        /// Branch of the law: `elastic`, `plastic`, `unloading`, `reloading` or `separated`.
        "branch": row.1.branch.name();
    }
}

/// The files with these results, as Markdown.
pub(super) fn files() -> String {
    file("Indentation: every half-space in `summary.json`", &half_space())
        + &file("Indentation: every step of a half-space", &step())
        + &file("Indentation: `trace.csv`", &trace())
}
