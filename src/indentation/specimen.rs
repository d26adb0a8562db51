//! Uncertain elastic constants and strengths: the same steps at every corner of their intervals.

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
    /// The results at every corner of the uncertainties; none without uncertainties.
    pub corners: Vec<Indentation>,
}

impl Tested {
    /// The lowest and the highest value that a result of a step has at the corners and in the middle; `None` without
    /// uncertainties. The first step is number 0.
    pub fn span(&self, step: usize, value: fn(&Step) -> f64) -> Option<[f64; 2]> {
        let all = self.corners.iter().chain([&self.indentation]).map(|one| value(&one.steps[step]));
        let wider = |[low, high]: [f64; 2], value: f64| [-max_or_nan(-low, -value), max_or_nan(high, value)];
        (!self.corners.is_empty()).then(|| all.fold([f64::INFINITY, f64::NEG_INFINITY], wider))
    }
}

impl Specimen {
    /// The half-space with every combination of the ends of its intervals: two or four, or none without uncertainties.
    fn corners(&self) -> Vec<HalfSpace> {
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

    /// The results at every corner.
    ///
    /// # Errors
    /// [`IndentationError`] of a corner.
    pub fn indent_corners(
        &self,
        indenter: Indenter,
        law: &dyn ContactLaw,
        targets: &[Target],
    ) -> Result<Vec<Indentation>, IndentationError> {
        let indent = |half_space| StaticContact::try_new(indenter, half_space, law)?.indent(targets, None);
        self.corners().iter().map(indent).collect()
    }
}
