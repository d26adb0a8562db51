//! What an unloading of known materials gave: the points beside the laws in comparisons and pictures.

use std::sync::LazyLock;

use serde::Deserialize;

use super::unloading;
use super::{ReferenceError, rows};
use crate::law::Bodies;

/// A full unloading of a finite-element run, quasi-static, in units of the yield point.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Unloaded {
    /// Which material case.
    pub case: String,
    /// E_s \[Pa\]; ν is 0.3.
    #[serde(rename = "sphere_youngs_modulus_Pa")]
    pub sphere_modulus: f64,
    /// E_h \[Pa\]; ν is 0.3.
    #[serde(rename = "half_space_youngs_modulus_Pa")]
    pub half_space_modulus: f64,
    /// σ_Y \[Pa\].
    #[serde(rename = "yield_strength_Pa")]
    pub yield_strength: f64,
    /// x_m.
    #[serde(rename = "x")]
    pub indentation: f64,
    /// f_m.
    #[serde(rename = "f")]
    pub force: f64,
    /// a_m/a_Y.
    #[serde(rename = "a")]
    pub contact_radius: f64,
    /// δ_s/δ at the peak.
    pub sphere_share: f64,
    /// δ_r/δ_m.
    pub residual_share: f64,
    /// W/(F_Y δ_Y).
    pub spent: f64,
    /// √(recovered/spent work).
    pub restitution: f64,
}

/// An unloading curve, from its peak to the residual indentation.
#[derive(Debug, Clone, PartialEq)]
pub struct UnloadingCurve {
    /// x_m.
    pub peak: f64,
    /// (x, f), the peak first.
    pub points: Vec<(f64, f64)>,
}

/// The unloadings with the finest increments at the depths of Figure 10 of the paper, which is case 3: run and number.
const FIGURE_10: [(&str, u32); 3] = [("case3_mini", 2), ("case3_fs", 1), ("case3_large_finesteps", 2)];

// without a row there is no point in a picture: a damaged table shows in the test below
static UNLOADED: LazyLock<Vec<Unloaded>> = LazyLock::new(|| unloaded().unwrap_or_default());
static CURVES: LazyLock<Vec<UnloadingCurve>> = LazyLock::new(|| curves().unwrap_or_default());

fn unloaded() -> Result<Vec<Unloaded>, ReferenceError> {
    rows("fe_quasi_static.csv", include_str!("../../tests/reference/fe_quasi_static.csv"))
}

fn curves() -> Result<Vec<UnloadingCurve>, ReferenceError> {
    let (cycles, points) = (unloading::unloadings()?, unloading::points()?);
    let peaks =
        FIGURE_10.iter().filter_map(|(run, cycle)| cycles.iter().find(|row| row.run == *run && row.cycle == *cycle));
    let curve = |peak: &unloading::UnloadingRow| {
        let way = points.iter().filter(|point| point.run == peak.run && point.cycle == peak.cycle);
        let ends = [(peak.x, peak.f), (peak.residual_share * peak.x, 0.0)];
        let points =
            ends[..1].iter().copied().chain(way.map(|point| (point.x, point.f))).chain(ends[1..].iter().copied());
        UnloadingCurve { peak: peak.x, points: points.collect() }
    };
    Ok(peaks.map(curve).collect())
}

/// The unloadings of the case that has these materials, by rising depth; none for others. Quasi-static results in units of
/// the yield point know no radius.
#[must_use]
pub fn unloadings(sphere_modulus: f64, bodies: &Bodies) -> Vec<&'static Unloaded> {
    let materials = [sphere_modulus, half_space_modulus(bodies), bodies.yield_strength];
    let is_near = |(a, b): (f64, f64)| (a / b - 1.0).abs() < 1e-6;
    let has_materials = |row: &&Unloaded| {
        [row.sphere_modulus, row.half_space_modulus, row.yield_strength].into_iter().zip(materials).all(is_near)
    };
    let mut rows: Vec<_> = UNLOADED.iter().filter(has_materials).collect();
    if (bodies.poissons_ratio - 0.3).abs() > 1e-9 {
        rows.clear();
    }
    rows.sort_by(|a, b| a.indentation.total_cmp(&b.indentation));
    rows
}

/// E_h from E_h* = E*/ρ_E.
fn half_space_modulus(bodies: &Bodies) -> f64 {
    let nu = bodies.poissons_ratio;
    bodies.pair.effective_modulus / bodies.pair.half_space_compliance * (1.0 - nu * nu)
}

/// The unloading curve of case 3 whose peak is within 1 % of this depth.
#[must_use]
pub fn unloading_curve(sphere_modulus: f64, bodies: &Bodies, indentation: f64) -> Option<&'static UnloadingCurve> {
    if unloadings(sphere_modulus, bodies).first()?.case != "case3" {
        return None;
    }
    CURVES.iter().find(|curve| (curve.peak / indentation - 1.0).abs() < 0.01)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_are_whole() {
        // fe_unloading.csv has four unloadings more, which have no restitution
        let cycles = unloading::unloadings().unwrap_or_default();
        let cycles: Vec<_> = cycles.iter().filter(|row| row.restitution.is_some()).collect();
        let rows = unloaded().unwrap_or_default();
        assert_eq!((rows.len(), cycles.len()), (59, 59));
        for (row, cycle) in rows.iter().zip(cycles) {
            assert_eq!((&row.case, Some(row.restitution)), (&cycle.case, cycle.restitution));
            // the head of fe_quasi_static.csv: two units of the sixth digit, and 1 % of a shallow dent
            assert!((row.indentation / cycle.x - 1.0).abs() < 1e-5 && (row.force / cycle.f - 1.0).abs() < 1e-5);
            assert_eq!(row.sphere_share, cycle.sphere_share);
            assert!((row.residual_share / cycle.residual_share - 1.0).abs() < 0.01);
        }
        let curves = curves().unwrap_or_default();
        assert_eq!(curves.iter().map(|curve| curve.peak).collect::<Vec<_>>(), [13.4969, 105.086, 843.257]);
        for curve in curves {
            assert!(curve.points.len() >= 9 && curve.points.windows(2).all(|pair| pair[0].0 > pair[1].0));
            assert!(curve.points.windows(2).all(|pair| pair[0].1 > pair[1].1));
        }
    }
}
