//! Quasi-static indentation: the contact law without inertia, through a list of loads and indentations.
//!
//! Each step ends at a set point: a load or an indentation. A step follows the loading curve or the unloading branch. The contact
//! remembers the largest state so far. Every law with a loading curve and an unloading rule is possible.
//!
//! The interface uses SI units, the inside dimensionless numbers.
//!
//! Xie et al. (2024), section 4.3; Oliver and Pharr (1992), J. Mater. Res. 7, 1564-1583, for the unloading stiffness.

mod load_step;

use thiserror::Error;

use super::problem::scales::Units;
use crate::contact::body::{HalfSpace, OutOfFloatRange, Sphere, finite_positive};
use crate::contact::law::{Branch, ContactLaw, ContactState, Law, LawError, LoadingHistory, Surface};
use crate::contact::pair::{Pair, PairError};
use crate::impact::{
    Warning, WarningKind, dent_warning, exponent_warning, flow_warnings, ignored_strength, peak_warnings,
    yielding_warning,
};
use crate::numerics::comparison::is_above;
use load_step::LoadStep;

/// A step that moves by a smaller fraction of the indentation is rounding, and counts as no motion.
const MIN_MOVE: f64 = 1e-12;

/// The set point at which a step ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SetPoint {
    /// F \[N\], ≥ 0.
    Load(f64),
    /// δ \[m\], ≥ 0. Below the residual indentation there is no contact, and the load is zero.
    Indentation(f64),
}

/// The half-space of an indentation.
#[derive(Debug, Clone, PartialEq)]
pub struct Specimen {
    /// Its name if there are several half-spaces; `None` for a single one.
    pub name: Option<String>,
    pub half_space: HalfSpace,
}

/// A half-space and its results.
#[derive(Debug, Clone, PartialEq)]
pub struct SpecimenResult {
    /// The half-space.
    pub specimen: Specimen,
    /// The sphere and this half-space as a pair.
    pub pair: Pair,
    /// True if a sufficiently large load leaves a dent.
    pub can_yield: bool,
    /// True if the law is a pair of springs, which leave no dent.
    pub is_spring: bool,
    /// The results.
    pub indentation: Indentation,
}

/// Why a list of steps has no result.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum IndentationError {
    #[error(transparent)]
    Range(#[from] OutOfFloatRange),
    #[error(transparent)]
    Pair(#[from] PairError),
    /// A law without a loading or an unloading rule.
    #[error(transparent)]
    Law(#[from] LawError),
    /// A step to a point where the law has no answer.
    #[error("step {step}: {reason}")]
    Outside {
        step: usize,
        /// Why the law has no answer.
        reason: LawError,
    },
    /// A step that ends at its start.
    #[error("step {step} ends where it begins. Remove this step, or give it another target.")]
    NoMove { step: usize },
    /// A step whose contact is wider than any sphere.
    #[error(
        "step {step}: the contact radius would be {contact_radius:.4e} m, and the radius of the sphere is {radius:.4e} m. No contact law applies there. Reduce the target."
    )]
    TooWide { step: usize, contact_radius: f64, radius: f64 },
    /// A step deeper than any sphere can go.
    #[error(
        "step {step}: the indentation would be {indentation:.4e} m, and the radius of the sphere is {radius:.4e} m. No contact law applies there. Reduce the target."
    )]
    TooDeep {
        step: usize,
        /// δ \[m\].
        indentation: f64,
        /// R \[m\].
        radius: f64,
    },
}

/// A warning about a step.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("step {step}: {warning}")]
pub struct StepWarning {
    pub step: usize,
    pub warning: Warning,
}

/// The largest state that a contact has reached, and the unloading from there. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakResult {
    /// F_m \[N\].
    pub force: f64,
    /// δ_m \[m\].
    pub indentation: f64,
    /// δ_r \[m\]: what is left of it when the load is taken off.
    pub residual_indentation: f64,
    /// S = dF/dδ where unloading begins, n F_m/δ_e \[N/m\].
    pub unloading_stiffness: f64,
    /// n \[1\].
    pub unloading_exponent: f64,
    /// a_m \[m\]; its accuracy is given at [`Law::contact_radius`].
    pub contact_radius: f64,
    /// F_m/(π a_m²) \[Pa\].
    pub mean_pressure: f64,
}

/// The result of a step. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepResult {
    pub set_point: SetPoint,
    pub branch: Branch,
    /// δ at its end \[m\].
    pub indentation: f64,
    /// δ_s at its end \[m\].
    pub sphere_indentation: f64,
    /// F at its end \[N\].
    pub force: f64,
    /// ∫ F dδ over the step \[J\]; negative while unloading.
    pub work: f64,
    /// The part of it spent on the dent \[J\].
    pub plastic_work: f64,
    /// Elastic energy stored at its end \[J\].
    pub stored_energy: f64,
    /// The largest state up to its end.
    pub peak: PeakResult,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IndentationRow {
    pub step: usize,
    /// δ \[m\].
    pub indentation: f64,
    /// δ_s \[m\]; 0 for a rigid sphere.
    pub sphere_indentation: f64,
    /// δ_h \[m\]: δ − δ_s in contact, the residual indentation where the surfaces have parted.
    pub half_space_indentation: f64,
    /// F \[N\].
    pub force: f64,
    pub branch: Branch,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Indentation {
    pub steps: Vec<StepResult>,
    /// The trace; empty if none was asked for.
    pub trace: Vec<IndentationRow>,
    pub warnings: Vec<StepWarning>,
}

/// A sphere on a half-space under a law.
#[derive(Debug, Clone)]
pub struct StaticContact {
    /// Yield strengths of sphere and half-space \[Pa\]; `None` for a body without one.
    strengths: [Option<f64>; 2],
    pair: Pair,
    units: Units,
    law: Law,
}

impl StaticContact {
    /// Pairs the bodies under a law (or Hertz alone, for a half-space without a yield strength). The sphere needs no density.
    ///
    /// # Errors
    /// [`IndentationError::Range`] where a constant of the pair over- or underflows, [`IndentationError::Law`] for a law that
    /// has no loading or no unloading.
    pub fn try_new(sphere: &Sphere, half_space: &HalfSpace, law: &dyn ContactLaw) -> Result<Self, IndentationError> {
        let pair = Pair::try_new(sphere, half_space)?;
        let units = Units::from_pair(&pair);
        finite_positive("force of the contact at first yield, or one radius deep (N)", units.force)?;
        let strengths = [sphere.yield_strength, half_space.yield_strength];
        Ok(Self { strengths, pair, units, law: law.law_for_pair(&pair)? })
    }

    pub fn pair(&self) -> &Pair {
        &self.pair
    }

    /// True if a sufficiently large load leaves a dent.
    pub fn can_yield(&self) -> bool {
        self.law.validity.elastic_until.is_finite()
    }

    /// True if the law is a pair of springs, which leave no dent.
    pub fn is_spring(&self) -> bool {
        self.law.is_spring()
    }

    /// Goes through the steps from first contact on; with `samples` ≥ 2, with a trace of that many evenly spaced rows a step
    /// and one more at every change of branch.
    ///
    /// # Errors
    /// [`IndentationError`] naming the step.
    pub fn indent(&self, targets: &[SetPoint], samples: Option<usize>) -> Result<Indentation, IndentationError> {
        let Units { length, force, .. } = self.units;
        // the place of the sphere, and the dent that the half-space remembers
        let (mut from, mut dent) = (0.0, None::<LoadingHistory>);
        let (mut steps, mut trace, mut warnings) = (Vec::with_capacity(targets.len()), Vec::new(), Vec::new());
        for (number, target) in (1..).zip(targets) {
            let ground = Surface::new(&self.law, dent.as_ref());
            let to = match *target {
                SetPoint::Load(load) => ground.indentation_at_force(load / force),
                SetPoint::Indentation(indentation) => indentation / length,
            };
            let (indentation, radius) = (to * length, self.pair.smaller_radius);
            if indentation.is_nan() || is_above(indentation, radius) {
                return Err(IndentationError::TooDeep { step: number, indentation, radius });
            }
            if (to - from).abs() <= MIN_MOVE * from.max(to) {
                return Err(IndentationError::NoMove { step: number });
            }
            let after = dent.clone().filter(|_| ground.reloading_branch_at(to).is_some());
            let after = after.unwrap_or_else(|| self.law.history_after(self.law.loaded_state(to)));
            let stroke = LoadStep { ground, from, to, branch: after.unloading };
            let peak = &stroke.branch.peak;
            self.law.check(&stroke.branch).map_err(|reason| IndentationError::Outside { step: number, reason })?;
            if let Some(samples) = samples {
                trace.extend(stroke.sampled_states(samples).map(|point| self.row(number, &stroke, point)));
            }
            let step = self.step(*target, &stroke)?;
            let PeakResult { contact_radius, .. } = step.peak;
            if is_above(contact_radius, radius) {
                return Err(IndentationError::TooWide { step: number, contact_radius, radius });
            }
            if stroke.is_new_peak() {
                let new =
                    peak_warnings((&self.law).into(), peak).chain(exponent_warning((&self.law).into(), &stroke.branch));
                warnings.extend(new.map(|warning| StepWarning { step: number, warning }));
            }
            self.push_warnings(number, &step, steps.last(), &mut warnings);
            steps.push(step);
            (from, dent) = (to, Some(after));
        }
        Ok(Indentation { steps, trace, warnings })
    }

    fn row(&self, step: usize, stroke: &LoadStep, (state, branch): (ContactState, Branch)) -> IndentationRow {
        let Units { length, force, .. } = self.units;
        let approach = if branch == Branch::Separated { stroke.ground.first_contact() } else { state.indentation };
        let sphere_indentation = self.pair.sphere_indentation(approach, state.elastic_approach) * length;
        IndentationRow {
            step,
            indentation: state.indentation * length,
            sphere_indentation,
            half_space_indentation: approach * length - sphere_indentation,
            force: state.force * force,
            branch,
        }
    }

    fn step(&self, target: SetPoint, stroke: &LoadStep) -> Result<StepResult, OutOfFloatRange> {
        let Units { length, force, contact_radius } = self.units;
        let energy = self.units.energy();
        let end = stroke.state_at(stroke.to);
        let row = self.row(0, stroke, end);
        let unloading = &stroke.branch;
        let peak = unloading.peak;
        let peak_force = finite_positive("peak force (N)", peak.force * force)?;
        let radius = finite_positive("contact radius (m)", self.law.contact_radius(&peak) * contact_radius)?;
        Ok(StepResult {
            set_point: target,
            branch: row.branch,
            indentation: row.indentation,
            sphere_indentation: row.sphere_indentation,
            force: row.force,
            work: stroke.work() * energy,
            plastic_work: stroke.plastic_work() * energy,
            stored_energy: unloading.stored_energy(end.0.indentation) * energy,
            peak: PeakResult {
                force: peak_force,
                indentation: peak.indentation * length,
                residual_indentation: peak.residual() * length,
                unloading_stiffness: finite_positive(
                    "unloading stiffness (N/m)",
                    unloading.slope_at(peak.elastic_approach) * force / length,
                )?,
                unloading_exponent: unloading.exponent,
                contact_radius: radius,
                mean_pressure: peak_force / (std::f64::consts::PI * radius) / radius,
            },
        })
    }

    /// Adds the warnings that no step before this one had.
    fn push_warnings(
        &self,
        number: usize,
        step: &StepResult,
        before: Option<&StepResult>,
        warnings: &mut Vec<StepWarning>,
    ) {
        let radius = self.pair.smaller_radius;
        let left_out = ignored_strength(&self.pair, &self.law, self.strengths);
        let of_step = |step: &StepResult| {
            let PeakResult { contact_radius, mean_pressure, .. } = step.peak;
            let yields =
                yielding_warning(mean_pressure, left_out, "The computed rebound of the indentation is too large");
            dent_warning(&self.law, contact_radius / radius).into_iter().chain(yields).chain(flow_warnings(&self.pair))
        };
        let known: Vec<_> = before.into_iter().flat_map(of_step).map(|warning| warning.kind).collect();
        let gain = (step.plastic_work < 0.0).then(|| {
            let text = format!(
                "The plastic work is too low: {:.3e} J is below 0. Use 0. Just beyond a segment boundary of the loading curve, the plastic work of the law falls slightly.",
                step.plastic_work
            );
            Warning::new(WarningKind::EnergyGain, 0.0, text)
        });
        let new = of_step(step).filter(|warning| !known.contains(&warning.kind)).chain(gain);
        warnings.extend(new.map(|warning| StepWarning { step: number, warning }));
    }
}
