//! Whole impacts by explicit finite elements.

use serde::Deserialize;

/// The result of the finite elements for an impact.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct ImpactRow {
    /// "D1".
    pub case: String,
    /// e.
    pub restitution: f64,
    #[serde(rename = "contact_time_s")]
    pub contact_time: f64,
    #[serde(rename = "peak_force_N")]
    pub peak_force: f64,
    #[serde(rename = "residual_indentation_m")]
    pub residual_indentation: f64,
    /// Radiated as elastic waves, of the kinetic energy.
    pub radiated_share: f64,
}

/// A sample in time.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Sample {
    pub case: String,
    #[serde(rename = "time_s")]
    pub time: f64,
    #[serde(rename = "force_N")]
    pub force: f64,
    /// Approach of the centre of mass \[m\].
    #[serde(rename = "indentation_m")]
    pub indentation: f64,
    #[serde(rename = "sphere_indentation_m")]
    pub sphere_indentation: f64,
    #[serde(rename = "half_space_indentation_m")]
    pub half_space_indentation: f64,
}

/// The table of the impacts.
pub const TABLE: &str = "fe_dynamic.csv";

tables! {
    /// The impacts.
    impacts: ImpactRow = "fe_dynamic.csv";
    /// Their samples, by time.
    samples: Sample = "fe_dynamic_curves.csv";
}
