//! Fits of PLM coefficients: to the finite-element curves and to curves of a known law; forms of a file; refused files.

mod command;
mod files;

use std::path::PathBuf;
use std::sync::LazyLock;

use crate::common::prelude::*;
use plm_impact::fit::solve::case_fit;
use plm_impact::fit::{self, knots};
use plm_impact::validation;

fn reference(case: u32) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("src/reference/fe_loading_case{case}.csv"))
}

/// The finite elements, and the fit to them from the built-in table on.
static CURVES: LazyLock<Vec<LoadingCurve>> =
    LazyLock::new(|| (1..=5).map(|case| LoadingCurve::load(&reference(case)).unwrap()).collect());
static FITTED: LazyLock<fit::Fit<'static>> =
    LazyLock::new(|| fit::fit(&CURVES, &plan(PlmCoefficients::built_in().clone())).unwrap());

fn plan(start: PlmCoefficients) -> Plan {
    Plan { start, has_knots: false }
}

#[test]
fn the_fit_to_the_finite_elements_is_as_good_as_the_built_in_table() {
    let built_in = PlmCoefficients::built_in();
    let with_knots = fit::fit(&CURVES, &Plan { start: built_in.clone(), has_knots: true }).unwrap();
    for (fitted, room) in [(&*FITTED, 1.0), (&with_knots, 1.05)] {
        fitted.coefficients.check().unwrap();
        for (curve, case) in CURVES.iter().zip(&fitted.cases) {
            let before = case_fit(curve, built_in);
            // no case may get worse by more than 0.2 %; documented for the built-in table: at most 1.4 % and 1.2 %
            assert!(case.force.rms < before.force.rms.min(0.014) + 0.002, "{}: {}", case.curve.name, case.force.rms);
            assert!(
                case.approach.rms < before.approach.rms.min(0.012) + 0.002,
                "{}: {}",
                case.curve.name,
                case.approach.rms
            );
            // a rise of 0.03 % is allowed; a larger rise is penalised, not forbidden
            assert!(case.restitution_rise < 4e-4, "{}: {}", case.curve.name, case.restitution_rise);
            // the fit is worse for a curve that was left out, but still good. The worst is the rigid sphere, to which
            // the other curves only extrapolate
            let (force, approach) = case.left_out.unwrap();
            assert!(force.rms > case.force.rms && force.rms < 0.03, "{}: {}", case.curve.name, force.rms);
            assert!(approach.rms < 0.02, "{}: {}", case.curve.name, approach.rms);
        }
        // nor is it further off anywhere else, after unloading, in impacts, with hardening: README says that it passes every
        // check; with other knots a few largest deviations pass their tolerance by up to a twentieth
        let mut checks = validation::checks(&fitted.coefficients, &Counter::default()).unwrap();
        checks.retain(|check| check.deviation.abs() > room * check.tolerance.limit || check.deviation.is_nan());
        assert!(checks.is_empty(), "{room}: {checks:?}");
    }
}

/// What the heads of the curves and the page say of the built-in table: it is near a fit to these curves, but no output of
/// `fit-plm`, which gives other slopes for soft spheres and meets the curves a little better.
#[test]
fn the_built_in_table_is_rounded_and_near_a_fit() {
    let built_in = PlmCoefficients::built_in();
    let (found, start) = (&FITTED.coefficients.force, &built_in.force);
    for (found, start) in found.slope.iter().zip(&start.slope) {
        assert_relative_eq!(*found, *start, max_relative = 0.05);
    }
    let mut other = found.slope_kappa_squared.iter().zip(&start.slope_kappa_squared).take(3);
    assert!(other.all(|(found, start)| (1.5..3.0).contains(&(found / start))), "{found:?}");
    let squares = |of: &dyn Fn(usize) -> f64| (0..5).map(|i| of(i) * of(i)).sum::<f64>();
    let (after, before) =
        (squares(&|i| FITTED.cases[i].force.rms), squares(&|i| case_fit(&CURVES[i], built_in).force.rms));
    assert!(after < before, "{after} {before}");
}

#[test]
fn scatter_of_the_curves_does_not_keep_the_fit_from_converging() {
    let mut curves = CURVES.clone();
    for (i, curve) in (1..).zip(&mut curves) {
        // 1.5 % rms of scatter without a pattern
        let scatter = |point: &LoadingPoint, j: u32| 0.021 * (f64::from(i * 7 + j) * 1e4 * point.indentation).sin();
        for point in &mut curve.points {
            point.elastic_approach *= 1.0 + scatter(point, 1);
            point.force *= 1.0 + scatter(point, 2);
        }
    }
    let fitted = fit::fit(&curves, &plan(PlmCoefficients::built_in().clone())).unwrap();
    for case in &fitted.cases {
        // 1.5 % of scatter and 1.1 % from the form of the law, added as squares, with a small margin
        assert!(case.force.rms < 0.022 && case.approach.rms < 0.022, "{case:?}");
    }
}

/// A law that differs from the built-in law in every number.
fn other() -> PlmCoefficients {
    let mut table = PlmCoefficients::built_in().clone();
    for (i, (slope, per_kappa)) in table.force.slope.iter_mut().zip(&mut table.force.slope_kappa_squared).enumerate() {
        let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
        *slope *= 0.96 + 0.002 * sign;
        *per_kappa *= 1.1;
    }
    let approach = &mut table.elastic_approach;
    approach.first_slope = 1.55;
    approach.first_slope_kappa_squared = 0.95;
    approach.first_slope_limit = 2.1;
    approach.plastic_from_rho = 8.0;
    approach.plastic_slope = 1.98;
    approach.plastic_slope_kappa_squared = 0.05;
    approach.geometry_factor = vec![0.9, 0.7];
    table.contact_radius.ratio = vec![1.0, 1.14, 1.2];
    table
}

/// Curves of this law for pairs from a hard to a very soft sphere, with points on every piece of the law.
fn curves_of(table: &PlmCoefficients) -> Vec<LoadingCurve> {
    let material = |youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 };
    // modulus of the sphere over that of the half-space, σ_Y/E_h, largest a/R
    let pairs = [
        (1e3, 2e-3, 0.45),
        (3.0, 1.5e-3, 0.45),
        (1.0, 2e-3, 0.45),
        (0.4, 5e-3, 0.45),
        (0.1, 1e-3, 0.4),
        (0.05, 5e-3, 0.4),
    ];
    pairs
        .into_iter()
        .enumerate()
        .map(|(i, (modulus_ratio, strength_ratio, widest))| {
            let half_space =
                HalfSpace { material: material(200e9), yield_strength: Some(strength_ratio * 200e9), density: None };
            let pair = Pair::try_new(0.01, &material(modulus_ratio * 200e9), &half_space).unwrap();
            let ratio = pair.yield_point.unwrap().contact_radius / pair.radius;
            let law = table.law(&pair, ratio, UnloadingExponent::Paper);
            let mut points = Vec::new();
            let mut x: f64 = 0.9;
            loop {
                let peak = law.loaded_to(x);
                let contact_radius = law.contact_radius(&peak);
                points.push(LoadingPoint {
                    indentation: x,
                    force: peak.force,
                    elastic_approach: peak.elastic_approach,
                    contact_radius: Some(contact_radius),
                });
                if contact_radius * ratio > widest {
                    break;
                }
                x *= 1.04;
            }
            LoadingCurve { name: format!("pair {i}"), pair, yield_radius_ratio: ratio, points }
        })
        .collect()
}

#[test]
fn the_coefficients_of_a_known_law_are_found_again() {
    let wanted = other();
    let found = fit::fit(&curves_of(&wanted), &plan(PlmCoefficients::built_in().clone())).unwrap().coefficients;
    let near = |found: f64, wanted: f64| assert_relative_eq!(found, wanted, max_relative = 1e-6, epsilon = 1e-6);
    let lists = |table: &PlmCoefficients| {
        let (force, approach) = (&table.force, &table.elastic_approach);
        let numbers = [
            approach.first_slope,
            approach.first_slope_kappa_squared,
            approach.first_slope_limit,
            approach.plastic_from_rho,
            approach.plastic_slope,
            approach.plastic_slope_kappa_squared,
        ];
        let mut all =
            [force.slope.clone(), force.slope_kappa_squared.clone(), approach.geometry_factor.clone()].concat();
        all.extend(numbers);
        all.extend(&table.contact_radius.ratio);
        all
    };
    for (found, wanted) in lists(&found).into_iter().zip(lists(&wanted)) {
        near(found, wanted);
    }
}

#[test]
fn what_the_curves_do_not_decide_stays_as_it_was() {
    // one curve that ends at x = 17: it does not determine the slopes beyond
    let mut curve = CURVES[2].clone();
    curve.points.retain(|point| point.indentation < 17.0);
    let built_in = PlmCoefficients::built_in();
    let curves = [curve];
    let fitted = fit::fit(&curves, &plan(built_in.clone())).unwrap();
    assert!(fitted.cases[0].left_out.is_none());
    let (found, start) = (&fitted.coefficients.force, &built_in.force);
    for i in 5..9 {
        assert_relative_eq!(found.slope[i], start.slope[i], max_relative = 0.02);
    }
    assert_eq!(fitted.coefficients.elastic_approach.first_slope_limit, built_in.elastic_approach.first_slope_limit);
}

#[test]
fn knots_of_ones_own_start_from_mean_slopes() {
    let table = knots::with_knots(PlmCoefficients::built_in(), &[1.7, 5.0, 36.0]).unwrap();
    // (f(5) − f(1.7))/3.3 of the built-in slopes at κ = 0: (0.7 × 2.00 + 1.0 × 2.29 + 1.6 × 2.62)/3.3
    assert_relative_eq!(table.force.slope[0], (0.7 * 2.0 + 2.29 + 1.6 * 2.62) / 3.3, max_relative = 1e-12);
    table.check().unwrap();
    for bad in [&[][..], &[0.5, 2.0], &[3.0, 2.0], &[2.0, f64::NAN]] {
        assert!(knots::with_knots(PlmCoefficients::built_in(), bad).unwrap_err().to_string().contains("--knots"));
    }
}
