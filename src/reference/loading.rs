//! The five loading curves of the quasi-static finite elements.

use super::{ReferenceRow, ReferenceTable, damaged_table, quasi_static};
use crate::contact::body::Sphere;
use crate::contact::pair::Pair;
use crate::error::Error;

/// A loading curve and its two bodies.
#[derive(Debug, Clone)]
pub struct ReferenceLoadingCurve {
    /// "case3".
    pub case: &'static str,
    /// The bodies, with a sphere of radius 1.
    pub pair: Pair,
    /// Contact radius at first yield over radius of the sphere, a_Y/R.
    pub yield_radius_ratio: f64,
    /// The points, by rising depth.
    pub points: Vec<ReferenceRow>,
}

const CURVES: [ReferenceTable; 5] = [
    ReferenceTable("case1", include_str!("fe_loading_case1.csv")),
    ReferenceTable("case2", include_str!("fe_loading_case2.csv")),
    ReferenceTable("case3", include_str!("fe_loading_case3.csv")),
    ReferenceTable("case4", include_str!("fe_loading_case4.csv")),
    ReferenceTable("case5", include_str!("fe_loading_case5.csv")),
];

/// The five curves.
///
/// # Errors
/// [`Error`] if a table is damaged.
pub fn curves() -> Result<Vec<ReferenceLoadingCurve>, Error> {
    CURVES.iter().map(curve).collect()
}

fn curve(table: &ReferenceTable) -> Result<ReferenceLoadingCurve, Error> {
    let case = table.0;
    let (sphere, half_space) = quasi_static::bodies(case).ok_or_else(|| damaged_table(case, "has no materials"))?;
    let pair = Pair::try_new(&Sphere::elastic(1.0, sphere, f64::NAN), &half_space)?;
    let yield_radius_ratio = pair.yield_point.map_or(f64::NAN, |point| point.contact_radius);
    Ok(ReferenceLoadingCurve { case, pair, yield_radius_ratio, points: table.rows()? })
}
