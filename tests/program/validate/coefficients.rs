//! The built-in coefficients of shallow dents follow from the curves that they were fitted to: this fits them again, by least squares.

use std::collections::BTreeMap;

use nalgebra::{SMatrix, SVector};

use super::independent_law::{CURVES, IndependentLaw, list};
use crate::common::prelude::*;

type Row = BTreeMap<String, f64>;

/// The laws of the bodies of the five curves, and the points of each from x = 1.7 on, where the first knot is.
fn curves() -> Vec<(IndependentLaw, Vec<Row>)> {
    let of = |curve: &str| {
        let mut rows = records::<Row>(curve);
        rows.retain(|row| row["delta_over_deltaY"] > 1.7);
        (IndependentLaw::for_curve(curve), rows)
    };
    CURVES.into_iter().map(of).collect()
}

/// The force at x of df/dx = a + b κ², where a is 1.9558 (Hertz's slope at x = 1.7) and three powers of t, and b is three
/// powers from t² on, with t = ln(x/1.7)/ln(700/1.7): the part that is known, and the six integrals over the powers.
fn smooth(x: f64, kappa: f64) -> (f64, SVector<f64, 6>) {
    let t = |x: f64| ((x / 1.7).ln() / (700.0_f64 / 1.7).ln()).min(1.0);
    let of = |part: usize, power: i32| {
        let weight = if part == 0 { 1.0 } else { kappa * kappa };
        weight * tanh_sinh_reference(1.7, x, |x| t(x).powi(power))
    };
    let integrals = [of(0, 1), of(0, 2), of(0, 3), of(1, 2), of(1, 3), of(1, 4)];
    (1.7_f64.powf(1.5) + 1.9558 * (x - 1.7), SVector::from(integrals))
}

/// The six coefficients of the smooth law by least squares of ln F. The built-in pieces follow that law: the forces agree to
/// what the pieces wave about it.
#[test]
fn force_slopes_follow_from_curves() {
    let curves = curves();
    let points: Vec<(f64, SVector<f64, 6>, f64, f64)> = curves
        .iter()
        .flat_map(|(law, rows)| {
            rows.iter().map(|row| {
                let x = row["delta_over_deltaY"];
                let (known, integrals) = smooth(x, law.kappa);
                (known, integrals, row["F_over_FY"], law.shallow_force(x))
            })
        })
        .collect();
    let mut fitted = SVector::<f64, 6>::zeros();
    // Gauss and Newton; the force is linear in the coefficients, its logarithm nearly
    fitted[0] = 4.0;
    for _ in 0..12 {
        let (mut matrix, mut right) = (SMatrix::<f64, 6, 6>::zeros(), SVector::<f64, 6>::zeros());
        for (known, integrals, force, _) in &points {
            let now = known + fitted.dot(integrals);
            let slope = integrals / now;
            matrix += slope * slope.transpose();
            right += slope * (force / now).ln();
        }
        fitted += matrix.cholesky().unwrap().solve(&right);
    }
    let off_by = points.iter().map(|(known, integrals, _, law)| relative_error(*law, known + fitted.dot(integrals)));
    let largest = off_by.fold(0.0, nan_max);
    assert!(points.len() > 280 && largest < 0.005, "{largest} {fitted}");
}

/// The factors of the geometry are the steps of 1/(1 + (A a_Y/R/0.51)²), a mean over each interval of A a_Y/R.
#[test]
fn geometry_factors_follow_one_smooth_law() {
    let law = IndependentLaw::for_curve(CURVES[0]);
    let [from, factor] = ["geometry_from", "geometry_factor"].map(|key| list(&law.table, "elastic_approach", key));
    let mut product = 1.0;
    for (pair, factor) in from.windows(2).zip(factor) {
        product *= factor;
        let mean = tanh_sinh_reference(pair[0], pair[1], |at| 1.0 / (1.0 + (at / 0.51).powi(2))) / (pair[1] - pair[0]);
        assert!((product - mean).abs() < 1.5e-3, "{pair:?}: {product} {mean}");
    }
}

/// A change of any coefficient of the elastic approach by a few per cent lowers no sum of squares of its logarithm by more than
/// the rounding of the coefficients does.
#[test]
fn elastic_approach_coefficients_are_least_squares() {
    let mut curves = curves();
    let mut sum = |key: &str, by: f64| -> f64 {
        let mut sum = 0.0;
        for (law, rows) in &mut curves {
            let before = law.table["elastic_approach"][key].as_float().unwrap();
            law.table["elastic_approach"][key] = (by * before).into();
            for row in rows.iter() {
                let x = row["delta_over_deltaY"];
                let reference = row["delta_s_over_delta"] * x / law.kappa;
                sum += (law.shallow_approach(x) / reference).ln().powi(2);
            }
            law.table["elastic_approach"][key] = before.into();
        }
        sum
    };
    let least = sum("plastic_slope", 1.0);
    for key in
        ["first_slope", "first_slope_kappa_squared", "plastic_from_rho", "plastic_slope", "plastic_slope_kappa_squared"]
    {
        for by in [0.9, 1.1] {
            let changed = sum(key, by);
            assert!(changed > least, "{key} {by}: {changed} {least}");
        }
    }
}
