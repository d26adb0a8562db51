//! Uncertain elastic constants and strengths: what the corners of their intervals make of every step.

use super::{Indentation, IndentationError, Indenter, StaticContact, Step, Target};
use crate::law::ContactLaw;
use crate::material::{HalfSpace, Material, Pair};
use crate::math::power::max_or_nan;

/// A half-space that is indented, with its name and how well its numbers are known.
#[derive(Debug, Clone, PartialEq)]
pub struct Specimen {
    /// Its name among several; `None` for a single one.
    pub name: Option<String>,
    /// What is indented.
    pub half_space: HalfSpace,
    /// ± of Young's modulus \[Pa\].
    pub modulus_uncertainty: Option<f64>,
    /// ± of the yield strength \[Pa\].
    pub strength_uncertainty: Option<f64>,
}

/// One half-space with what came of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Tested {
    /// What was indented.
    pub specimen: Specimen,
    /// What its pairing with the sphere fixes.
    pub pair: Pair,
    /// Whether a load that is large enough leaves a dent.
    pub can_yield: bool,
    /// The results.
    pub indentation: Indentation,
    /// The spans of each step, if there are uncertainties.
    pub spans: Option<Vec<Spans>>,
}

/// Lowest and highest value over the corners and the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Lowest.
    pub low: f64,
    /// Highest.
    pub high: f64,
}

/// What the uncertainties make of a step. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spans {
    /// δ at its end \[m\].
    pub indentation: Span,
    /// F at its end \[N\].
    pub force: Span,
    /// δ_r \[m\].
    pub residual_indentation: Span,
    /// S \[N/m\].
    pub unloading_stiffness: Span,
    /// a_m \[m\].
    pub contact_radius: Span,
    /// In the step \[J\].
    pub plastic_work: Span,
}

impl Specimen {
    /// The half-space with every combination of the ends of its intervals: two or four, or none without uncertainties.
    pub fn corners(&self) -> Vec<HalfSpace> {
        if self.modulus_uncertainty.is_none() && self.strength_uncertainty.is_none() {
            return Vec::new();
        }
        let ends = |uncertainty: Option<f64>| uncertainty.map_or(vec![0.0], |by| vec![-by, by]);
        let HalfSpace { material, yield_strength, .. } = self.half_space;
        let moduli = ends(self.modulus_uncertainty);
        let strengths = ends(self.strength_uncertainty);
        let corner = |modulus: f64, strength: f64| HalfSpace {
            material: Material { youngs_modulus: material.youngs_modulus + modulus, ..material },
            yield_strength: yield_strength.map(|value| value + strength),
            ..self.half_space
        };
        moduli.iter().flat_map(|modulus| strengths.iter().map(|strength| corner(*modulus, *strength))).collect()
    }

    /// The spans of every step of `middle`, the indentation of this specimen; `None` where all is known.
    ///
    /// # Errors
    /// [`IndentationError`] of a corner.
    pub fn spans(
        &self,
        indenter: Indenter,
        law: &dyn ContactLaw,
        targets: &[Target],
        middle: &Indentation,
    ) -> Result<Option<Vec<Spans>>, IndentationError> {
        let corners = self.corners();
        if corners.is_empty() {
            return Ok(None);
        }
        let corners: Vec<Indentation> = corners
            .iter()
            .map(|half_space| StaticContact::try_new(indenter, half_space, law)?.indent(targets, None))
            .collect::<Result<_, _>>()?;
        let spans = (0..middle.steps.len()).map(|step| {
            let span = |value: fn(&Step) -> f64| {
                let values = corners.iter().chain([middle]).map(|one| value(&one.steps[step]));
                values.fold(Span { low: f64::INFINITY, high: f64::NEG_INFINITY }, |span, value| Span {
                    low: -max_or_nan(-span.low, -value),
                    high: max_or_nan(span.high, value),
                })
            };
            Spans {
                indentation: span(|step| step.indentation),
                force: span(|step| step.force),
                residual_indentation: span(|step| step.memory.residual_indentation),
                unloading_stiffness: span(|step| step.memory.unloading_stiffness),
                contact_radius: span(|step| step.memory.contact_radius),
                plastic_work: span(|step| step.plastic_work),
            }
        });
        Ok(Some(spans.collect()))
    }
}
