//! Distributions and tests of a fit, against scipy and against counting by hand.

use plm_impact::calibrate::statistics::{RunsTest, chi_square_p_value, half_width, runs_test};

#[test]
fn distributions_are_those_of_scipy() {
    // scipy 1.17: stats.chi2.sf(12.3, 7), stats.t.ppf(0.975, 5), stats.norm.ppf(0.975)
    approx::assert_relative_eq!(chi_square_p_value(12.3, 7).unwrap(), 0.091_114_886_000_313_1, max_relative = 1e-11);
    approx::assert_relative_eq!(half_width(0.95, Some(5.0)), 2.570_581_835_636_314_6, max_relative = 1e-9);
    approx::assert_relative_eq!(half_width(0.95, None), 1.959_963_984_540_054, max_relative = 1e-14);
    assert_eq!(chi_square_p_value(1.0, 0), None);
}

#[test]
fn run_counts_match_all_orders() {
    // of the 20 orders of three + and three -, 2 have two runs, 4 have three runs and 8 have four runs
    let residuals_of = |signs: &str| signs.chars().map(|sign| if sign == '+' { 1.0 } else { -1.0 }).collect::<Vec<_>>();
    approx::assert_relative_eq!(runs_test(&residuals_of("+++---")).unwrap().p, 0.1, max_relative = 1e-11);
    approx::assert_relative_eq!(runs_test(&residuals_of("++---+")).unwrap().p, 0.3, max_relative = 1e-11);
    approx::assert_relative_eq!(runs_test(&residuals_of("+-++--")).unwrap().p, 0.7, max_relative = 1e-11);
    approx::assert_relative_eq!(runs_test(&residuals_of("+-++--")).unwrap().min_p, 0.1, max_relative = 1e-11);
    assert_eq!(runs_test(&residuals_of("+++")), Some(RunsTest { p: 0.25, min_p: 0.25 }));
    assert_eq!(runs_test(&residuals_of("+")), None);
}
