//! Fitting PLM coefficients: the finite-element curves, curves of a known law, files that are refused.

#![allow(clippy::unwrap_used)]

use std::path::Path;

use plm_impact::fit::{self, LoadingCurve, Plan, report};
use plm_impact::law::PlmCoefficients;

fn finite_elements() -> Vec<LoadingCurve> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reference");
    (1..=5).map(|case| LoadingCurve::load(&directory.join(format!("fe_loading_case{case}.csv"))).unwrap()).collect()
}

#[test]
fn the_fit_to_the_finite_elements_is_as_good_as_the_built_in_table() {
    let curves = finite_elements();
    let start = PlmCoefficients::built_in().clone();
    let before: Vec<_> = curves.iter().map(|curve| fit::solve::case_fit(curve, &start)).collect();
    for has_knots in [false, true] {
        let fitted = fit::fit(&curves, &Plan { start: start.clone(), has_knots }).unwrap();
        println!("{}", report::table(&fitted, &before));
        println!("{}", report::toml(&report::coefficients(&fitted, "x", "c")).unwrap());
    }
}
