//! The five loading curves of the quasi-static finite elements.

use super::{damaged, quasi_static};
use crate::contact::material::{Pair, Sphere};
use crate::error::Error;

rows! {
    /// A point of a loading curve.
    pub struct LoadingPoint {
        /// x = δ/δ_Y.
        pub indentation as "delta_over_deltaY": f64,
        /// f = F/F_Y.
        pub force as "F_over_FY": f64,
        /// δ_s/δ.
        pub sphere_share as "delta_s_over_delta": f64,
        /// a/R.
        pub contact_radius as "a_over_R": f64,
    }
}

/// A loading curve and its two bodies.
#[derive(Debug, Clone)]
pub struct LoadingCurve {
    /// "case3".
    pub case: &'static str,
    /// The bodies, with a sphere of radius 1.
    pub pair: Pair,
    /// Contact radius at first yield over radius of the sphere, a_Y/R.
    pub yield_radius_ratio: f64,
    /// The points, by rising depth.
    pub points: Vec<LoadingPoint>,
}

const CURVES: [(&str, &str); 5] = [
    ("case1", include_str!("fe_loading_case1.csv")),
    ("case2", include_str!("fe_loading_case2.csv")),
    ("case3", include_str!("fe_loading_case3.csv")),
    ("case4", include_str!("fe_loading_case4.csv")),
    ("case5", include_str!("fe_loading_case5.csv")),
];

/// The five curves.
///
/// # Errors
/// [`Error`] if a table is damaged.
pub fn curves() -> Result<Vec<LoadingCurve>, Error> {
    CURVES.iter().map(|(case, text)| curve(case, text)).collect()
}

fn curve(case: &'static str, text: &str) -> Result<LoadingCurve, Error> {
    let (sphere, half_space) = quasi_static::bodies(case).ok_or_else(|| damaged(case, "has no materials"))?;
    let pair = Pair::try_new(&Sphere::elastic(1.0, sphere, f64::NAN), &half_space)?;
    let yield_radius_ratio = pair.yield_point.map_or(f64::NAN, |point| point.contact_radius);
    Ok(LoadingCurve { case, pair, yield_radius_ratio, points: super::rows(case, text)? })
}
