//! The full unloadings of the quasi-static runs: results, points of the curves, and shapes of the dents.

use serde::Deserialize;

/// A full unloading. Lengths are in units of the yield indentation, forces of the yield force.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct UnloadingRow {
    /// "case3".
    pub case: String,
    /// The run.
    pub run: String,
    /// Number of the unloading in it, from 1.
    pub cycle: u32,
    /// Elements over the contact radius at the peak.
    #[serde(rename = "elements_in_contact")]
    pub elements: f64,
    /// x_m.
    pub x: f64,
    /// f_m.
    pub f: f64,
    /// δ_s/δ at the peak.
    pub sphere_share: f64,
    /// a_m/R.
    #[serde(rename = "contact_radius_over_R")]
    pub contact_radius: f64,
    /// δ_r/δ_m.
    pub residual_share: f64,
    /// W/(F_Y δ_Y) of loading, where the loading curve reaches back to first yield.
    pub spent: Option<f64>,
    /// √(recovered/spent work), if the spent work is known.
    pub restitution: Option<f64>,
    /// R_res/R fitted within the contact radius.
    #[serde(rename = "residual_radius_over_R")]
    pub residual_radius: f64,
    /// The same within 0.7 of it.
    #[serde(rename = "inner_residual_radius_over_R")]
    pub inner_residual_radius: f64,
}

/// A full unloading whose loading is known back to first yield, in units of the yield point.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Unloaded {
    /// Name of the material, or of the case.
    pub material: String,
    /// x_m.
    pub x: f64,
    /// f_m.
    pub f: f64,
    /// W/(F_Y δ_Y) of loading.
    pub spent: f64,
    /// a_m/R.
    #[serde(rename = "contact_radius_over_R")]
    pub contact_radius: f64,
    /// δ_r/δ_m.
    pub residual_share: f64,
    /// √(recovered/spent work).
    pub restitution: f64,
}

/// An increment in contact on the way back, behind the peak.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct UnloadingPoint {
    pub run: String,
    pub cycle: u32,
    /// x.
    pub x: f64,
    /// f.
    pub f: f64,
    /// δ_s/δ_Y.
    pub sphere_x: f64,
}

tables! {
    /// All unloadings.
    unloadings: UnloadingRow = "fe_unloading.csv";
    /// Points of all of them.
    points: UnloadingPoint = "fe_unloading_curves.csv";
}
