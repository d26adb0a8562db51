//! Distributions, weights and tests of a fit, against scipy, against counting by hand, and against the theory of least squares.

use plm_impact::calibrate::statistics::{RunsTest, chi_square_p_value, half_width, runs_test};

use super::fits::{STRENGTH, run_calibration, scenario};

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

/// Least squares do not depend on the scale of the standard deviations: if the noise is estimated, the given deviations are weights.
#[test]
fn estimated_noise_keeps_given_weights() {
    let with_sds = |sds: [f64; 4]| {
        let values = [(0.5, 0.75), (1.0, 0.66), (2.0, 0.55), (4.0, 0.45)];
        let lines = values.iter().zip(sds).map(|((speed, e), sd)| format!("{speed},{e},{sd}\n"));
        format!("speed_m_per_s,restitution,restitution_sd\n{}", lines.collect::<String>())
    };
    let estimate = |noise: &str, data: &str| {
        let text = scenario(&format!("data = \"d.csv\"\n{STRENGTH}{noise}"));
        run_calibration(&text, data, &[], 0).1["keys"][0]["estimate"].as_f64().unwrap()
    };
    let given = estimate("", &with_sds([0.1, 0.3, 0.1, 0.5]));
    let scaled = estimate("noise = \"estimate\"\n", &with_sds([0.01, 0.03, 0.01, 0.05]));
    assert!((scaled / given - 1.0).abs() < 1e-6, "{scaled} {given}");
    let equal = estimate("noise = \"estimate\"\n", &with_sds([0.01; 4]));
    assert!((equal / given - 1.0).abs() > 1e-2, "{equal} {given}");
}
