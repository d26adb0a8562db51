//! A hardness test by the law itself: the strength of a metal follows from the pressure of its indentation.
//!
//! ```text
//! indenter   a diamond sphere, E = 1140 GPa, ν = 0.07, pressed in to a = 0.337 R: there its slope is that of the cone that
//!            replaces the Vickers pyramid (70.3°); between a/R = 0.28 and 0.40 it matters by 0.5 % of e
//! p          F/(π a²), with force and contact radius of the PLM
//! σ          the constant flow stress for which p is the pressure of the hardness
//! ```
//!
//! p/σ is 2.9 for soft metals, and falls with the strength, because elastic deformation carries more and more: on E = 210 GPa
//! from 2.87 at σ = 0.5 GPa to 2.34 at 3.9 GPa. It is less for a small Poisson's ratio, 2.68 at ν = 0.03 and σ = 0.5 GPa, and more
//! for a large one, 2.97 at ν = 0.42. The law is that of the built-in coefficients, whatever law the impact has.
//!
//! A metal that hardens has this σ at a plastic strain of 0.08, as Tabor measured. Its own indentation by the law, with the two
//! strains that stand for the strain field, has a lower pressure, 2.5 σ(0.08) at N = 0.25. Measured flow curves of annealed
//! metals are on the side of 2.9 (`tests/program/scenario/materials.rs`).

use super::coefficients::PlmCoefficients;
use super::unloading_rule::UnloadingExponent;
use crate::contact::body::{HalfSpace, Material, Sphere};
use crate::contact::pair::Pair;
use crate::contact::strength::flow_curve::{FlowCurve, yield_strength_of_power};
use crate::contact::strength::hardness::TABOR_STRAIN;
use crate::numerics::root::illinois;

const DIAMOND: Material = Material { youngs_modulus: 1140e9, poissons_ratio: 0.07 };

/// a/R of the indentation.
const INDENT_RADIUS_RATIO: f64 = 0.337;

/// The yield strength \[Pa\] of a body of this material whose hardness is given as mean pressure \[Pa\]. With a power law of
/// hardening, the curve has the flow stress of the hardness at the strain [`TABOR_STRAIN`]; otherwise the yield strength is that
/// flow stress. NaN if the indenter would leave no dent.
pub fn strength_of_hardness(mean_pressure: f64, flow: Option<&FlowCurve>, material: &Material) -> f64 {
    let stress = flow_stress_of_hardness(mean_pressure, material);
    match flow {
        Some(FlowCurve::Power { exponent }) => {
            yield_strength_of_power(stress, TABOR_STRAIN, *exponent, material.youngs_modulus)
        }
        _ => stress,
    }
}

/// The flow stress \[Pa\] of a body of this material with this hardness; NaN if the indenter would leave no dent.
pub fn flow_stress_of_hardness(mean_pressure: f64, material: &Material) -> f64 {
    let short_of = |stress: f64| mean_pressure - hardness_of_flow_stress(stress, material);
    let [low, high] = [mean_pressure / 8.0, 2.0 * mean_pressure];
    // a contact without a dent has one pressure, whatever the strength
    if !(short_of(high) <= 0.0 && high.is_finite()) {
        return f64::NAN;
    }
    illinois((low, high), short_of)
}

/// The hardness, as mean pressure \[Pa\], of a body of this material with a constant flow stress \[Pa\]; NaN if they are not
/// possible for a body.
pub fn hardness_of_flow_stress(flow_stress: f64, material: &Material) -> f64 {
    let indenter = Sphere::elastic(1.0, DIAMOND, 1.0);
    let body = HalfSpace::flat(*material, Some(flow_stress));
    let Ok(pair) = Pair::try_new(&indenter, &body) else { return f64::NAN };
    let Some(point) = pair.yield_point else { return f64::NAN };
    let ratio = point.contact_radius;
    let law = PlmCoefficients::built_in().law(&pair, ratio, UnloadingExponent::Paper);
    let width = |x: f64| ratio * law.plm_contact_radius_at(x);
    // an elastic contact is as wide at δ = a²/R, a plastic one at no less than a fifth of that
    let elastic = (INDENT_RADIUS_RATIO / ratio) * (INDENT_RADIUS_RATIO / ratio);
    let x = illinois((0.1 * elastic, 2.0 * elastic), |x| INDENT_RADIUS_RATIO - width(x));
    point.force * law.loading.force_at_one_point(x) / (std::f64::consts::PI * INDENT_RADIUS_RATIO * INDENT_RADIUS_RATIO)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::*;
    use crate::numerics::functions::powi;

    const STEEL: Material = Material { youngs_modulus: 210e9, poissons_ratio: 0.3 };

    /// The pressures of the text above, which were computed with another program of 30 digits.
    #[test]
    fn pressure_to_strength_ratio_falls_with_strength() {
        for (strength, poissons_ratio, constraint) in [
            (0.5e9, 0.3, 2.870_167_5),
            (3.9e9, 0.3, 2.343_391_3),
            (0.5e9, 0.03, 2.681_563_4),
            (0.5e9, 0.42, 2.972_180_5),
        ] {
            let material = Material { poissons_ratio, ..STEEL };
            let ratio = hardness_of_flow_stress(strength, &material) / strength;
            assert_relative_eq!(ratio, constraint, max_relative = 1e-7);
        }
        let mut last = f64::INFINITY;
        for k in 0..200 {
            let strength = 1e7 * powi(1.04, k);
            let constraint = hardness_of_flow_stress(strength, &STEEL) / strength;
            assert!(constraint > 0.1 && constraint < last * 1.001, "{strength} {constraint} {last}");
            last = constraint;
        }
    }

    /// The force at one point of a deep dent is the force of the whole curve: between two points, at one, and beyond the range.
    #[test]
    fn force_at_one_point_is_that_of_the_curve() {
        for (strength, poissons_ratio) in [(2e8, 0.3), (9e8, 0.1), (1.9e10, 0.3)] {
            let body = HalfSpace::flat(Material { poissons_ratio, ..STEEL }, Some(strength));
            let pair = Pair::try_new(&Sphere::elastic(1.0, DIAMOND, 1.0), &body).unwrap();
            let ratio = pair.yield_point.unwrap().contact_radius;
            let law = PlmCoefficients::built_in().law(&pair, ratio, UnloadingExponent::Paper);
            let starts = law.loading.pieces().iter().map(|piece| piece.start);
            let between = (0..200).map(|i| 0.3 * f64::from(i) / 200.0 / (ratio * ratio));
            for x in starts.chain(between) {
                let force = law.loading.force(x);
                assert_relative_eq!(law.loading.force_at_one_point(x), force, max_relative = 1e-13);
            }
        }
    }

    /// A strength gives the pressure that it comes from, and rises with it; where there is no dent there is no strength.
    #[test]
    fn a_strength_gives_back_its_pressure() {
        for (modulus, poissons_ratio) in [(210e9, 0.3), (70e9, 0.33), (1e9, 0.49), (600e9, -0.9)] {
            let material = Material { youngs_modulus: modulus, poissons_ratio };
            let mut last = 0.0;
            for k in 0..40 {
                let hardness = 1e-5 * modulus * powi(1.25, k);
                let strength = flow_stress_of_hardness(hardness, &material);
                assert!(strength > last, "{material:?} {hardness} {strength} {last}");
                assert_relative_eq!(hardness_of_flow_stress(strength, &material), hardness, max_relative = 1e-11);
                last = strength;
            }
            assert!(flow_stress_of_hardness(0.4 * modulus, &material).is_nan());
        }
        // near the limit of an elastic contact the strength is larger than the pressure
        let zero_ratio = Material { poissons_ratio: 0.0, ..STEEL };
        let strength = flow_stress_of_hardness(25e9, &zero_ratio);
        assert!(strength > 25e9, "{strength}");
        assert_relative_eq!(hardness_of_flow_stress(strength, &zero_ratio), 25e9, max_relative = 1e-11);
        let nothing = Material { youngs_modulus: f64::NAN, ..STEEL };
        assert!(flow_stress_of_hardness(3e9, &nothing).is_nan());
    }
}
