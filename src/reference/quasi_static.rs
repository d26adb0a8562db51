//! Finite-element unloadings of known materials: the points beside the laws in comparisons and pictures.

use std::sync::LazyLock;

use super::{ReferenceRow, UNLOADINGS};
use crate::contact::body::{HalfSpace, Material, Sphere};
use crate::contact::law::YieldingPair;
use crate::error::Error;

/// Xie et al. (2024), Table 1: E_s, E_h, σ_Y \[Pa\] of every case; ν is 0.3 in all. The sphere of case 5 is as good as rigid.
const MATERIALS: [(&str, [f64; 3]); 5] = [
    ("case1", [52e9, 210e9, 50e6]),
    ("case2", [104e9, 210e9, 120e6]),
    ("case3", [208e9, 210e9, 345e6]),
    ("case4", [208e9, 52.5e9, 550e6]),
    ("case5", [210e12, 210e9, 345e6]),
];

// a damaged table gives no points in pictures; the test below would find it
static UNLOADED: LazyLock<Vec<ReferenceRow>> = LazyLock::new(|| read_unloadings().unwrap_or_default());

/// The unloadings whose loading is known back to first yield.
fn read_unloadings() -> Result<Vec<ReferenceRow>, Error> {
    Ok(UNLOADINGS.rows()?.into_iter().filter(|row| row.optional_number("spent").is_some()).collect())
}

/// The unloadings of the case that has these materials, by rising depth; none for other materials. Quasi-static results in
/// units of the yield point do not depend on the radius.
pub fn unloadings(sphere_modulus: f64, bodies: &YieldingPair) -> Vec<&'static ReferenceRow> {
    let materials = [sphere_modulus, bodies.modulus(), bodies.yield_point.strength];
    let is_near = |(a, b): (f64, f64)| (a / b - 1.0).abs() < 1e-6;
    let case = MATERIALS.iter().find(|(_, of_case)| of_case.iter().copied().zip(materials).all(is_near));
    let Some((case, _)) = case.filter(|_| (bodies.yield_point.poissons_ratio - 0.3).abs() <= 1e-9) else {
        return Vec::new();
    };
    let mut rows: Vec<_> = UNLOADED.iter().filter(|row| row.cell_text("case") == *case).collect();
    rows.sort_by(|a, b| a.number("x").total_cmp(&b.number("x")));
    rows
}

/// The sphere's material and the half-space of a case.
pub(super) fn bodies(case: &str) -> Option<(Material, HalfSpace)> {
    let (_, [sphere, half_space, strength]) = MATERIALS.iter().find(|(name, _)| *name == case)?;
    let [sphere, material] =
        [sphere, half_space].map(|modulus| Material { youngs_modulus: *modulus, poissons_ratio: 0.3 });
    Some((sphere, HalfSpace::flat(material, Some(*strength))))
}

/// Every unloading, with a sphere of 5 mm and the half-space of its case.
pub fn load_cycles() -> impl Iterator<Item = (Sphere, HalfSpace, &'static ReferenceRow)> {
    UNLOADED.iter().filter_map(|row| {
        let (sphere, half_space) = bodies(row.cell_text("case"))?;
        Some((Sphere::elastic(5e-3, sphere, 7850.0), half_space, row))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_are_whole() {
        // of 63 unloadings four have no loading curve that reaches back to first yield
        let rows = read_unloadings().unwrap_or_default();
        assert_eq!((rows.len(), UNLOADINGS.rows().unwrap_or_default().len()), (59, 63));
        for (case, _) in MATERIALS {
            assert!(rows.iter().any(|row| row.cell_text("case") == case));
        }
        // recovered work f ε/(n + 1) with n between 1.35 and 1.55 for every unloading but the shallowest
        for row in rows.iter().filter(|row| row.number("x") > 5.0) {
            let [x, f, spent, restitution] = ["x", "f", "spent", "restitution"].map(|column| row.number(column));
            let n = f * x * (1.0 - row.number("residual_share")) / (restitution * restitution * spent) - 1.0;
            assert!((1.2..1.6).contains(&n), "{row:?}: {n}");
        }
    }
}
