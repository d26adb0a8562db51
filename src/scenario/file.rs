//! The scenario file, one to one: tables, keys, nothing else. What is not here is refused.

use std::path::PathBuf;

use serde::Deserialize;

use super::compare::CompareTable;
use super::forces::{DampingTable, GravityTable};
use super::indentation::IndentationTable;
use super::law::LawTable;
use super::repeat::RepeatTable;
use super::sweep::{MonteCarloTable, SweepTable};
use super::values::{
    Density, DropHeight, Exponent, Length, MethodName, Modulus, PoissonsRatio, Samples, Speed, SphereModulus, Steps,
    Strength, Tolerance,
};
use crate::material::{HalfSpace, Material};

/// The whole file.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ScenarioFile {
    /// The sphere.
    pub sphere: SphereTable,
    /// The half-space; only an indentation that names its own can do without.
    pub half_space: Option<HalfSpaceTable>,
    /// How they meet; only a scene without an impact can do without.
    pub impact: Option<ImpactTable>,
    /// Gravity, if it is to act.
    pub gravity: Option<GravityTable>,
    /// Damping, if there is any.
    pub damping: Option<DampingTable>,
    /// The law; PLM if absent.
    pub law: Option<LawTable>,
    /// How to compute.
    #[serde(default)]
    pub solver: SolverTable,
    /// What to write.
    #[serde(default)]
    pub output: OutputTable,
    /// Many cases on axes, or
    pub sweep: Option<SweepTable>,
    /// many random ones, or
    pub monte_carlo: Option<MonteCarloTable>,
    /// one after the other, or
    pub repeat: Option<RepeatTable>,
    /// unloading laws from one peak, or
    pub compare: Option<CompareTable>,
    /// an indentation instead of an impact.
    pub indentation: Option<IndentationTable>,
}

/// `[sphere]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct SphereTable {
    /// Radius, or
    pub radius: Option<Length>,
    /// diameter: exactly one of the two.
    pub diameter: Option<Length>,
    /// Young's modulus, or "rigid".
    pub youngs_modulus: SphereModulus,
    /// Poisson's ratio.
    pub poissons_ratio: PoissonsRatio,
    /// Density; only a scene without an impact can do without.
    pub density: Option<Density>,
    /// The sphere's own yield strength: only used to warn.
    pub yield_strength: Option<Strength>,
}

/// `[half_space]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct HalfSpaceTable {
    /// Young's modulus.
    pub youngs_modulus: Modulus,
    /// Poisson's ratio.
    pub poissons_ratio: PoissonsRatio,
    /// Yield strength; without it the half-space is elastic.
    pub yield_strength: Option<Strength>,
    /// Density; with it, the elastic waves that an impact radiates are reported.
    pub density: Option<Density>,
}

impl HalfSpaceTable {
    /// The half-space in SI.
    #[must_use]
    pub fn resolve(&self) -> HalfSpace {
        let material = Material { youngs_modulus: self.youngs_modulus.0, poissons_ratio: self.poissons_ratio.0 };
        HalfSpace {
            material,
            yield_strength: self.yield_strength.map(|strength| strength.0),
            density: self.density.map(|density| density.0),
        }
    }
}

/// `[impact]`
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct ImpactTable {
    /// Impact speed, or
    pub speed: Option<Speed>,
    /// height of the fall under gravity: exactly one of the two.
    pub drop_height: Option<DropHeight>,
}

/// `[law.plm]`
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct PlmTable {
    /// Exponent of the unloading branch, or "pressure-shape".
    pub unloading_exponent: Option<Exponent>,
    /// A file of coefficients, relative to the scenario.
    pub coefficients: Option<PathBuf>,
}

/// `[solver]`
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct SolverTable {
    /// Method.
    pub method: Option<MethodName>,
    /// Relative tolerance.
    pub tolerance: Option<Tolerance>,
    /// Steps over the contact time, for `verlet`.
    pub steps_per_contact: Option<Steps>,
}

/// `[output]`
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct OutputTable {
    /// Evenly spaced rows of the trace.
    pub samples: Option<Samples>,
    /// Of a table: the results it has besides the restitution; all if absent.
    pub columns: Option<Vec<String>>,
}
