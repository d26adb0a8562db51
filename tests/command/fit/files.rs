//! The forms of a file of a loading curve, and curves without sense.

use std::fmt::Write as _;

use plm_impact::fit;

use super::{CURVES, reference};
use crate::common::prelude::*;

const HEADER: &str = "# sphere.youngs_modulus = 208 GPa\n# sphere.poissons_ratio = 0.3\n# half_space.youngs_modulus = 210 GPa\n\
                      # half_space.poissons_ratio = 0.3\n# half_space.yield_strength = 345 MPa\n";

/// The curve of case 3 in another form.
fn written(header: &str, columns: &str, row: impl Fn(&LoadingPoint) -> Vec<f64>) -> String {
    let mut text = format!("{header}{columns}\n");
    for point in &CURVES[2].points {
        let cells: Vec<String> = row(point).iter().map(ToString::to_string).collect();
        writeln!(text, "{}", cells.join(",")).unwrap();
    }
    text
}

#[test]
fn a_curve_in_si_units_is_the_same_curve() {
    let want = &CURVES[2];
    let material = |youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.3 };
    let half_space = HalfSpace { material: material(210e9), yield_strength: Some(345e6), density: None };
    let pair = Pair::try_new(0.035, &material(208e9), &half_space).unwrap();
    let point = pair.yield_point.unwrap();
    let header = format!("{HEADER}# sphere.radius = 35 mm\n");
    let row = |of: &LoadingPoint, approach: f64| {
        let radius = of.contact_radius.unwrap() * point.contact_radius;
        vec![
            radius,
            of.force * point.force,
            approach * of.elastic_approach * point.indentation,
            of.indentation * point.indentation,
        ]
    };
    for (column, factor) in [("sphere_indentation_m", pair.sphere_compliance), ("elastic_approach_m", 1.0)] {
        let columns = format!("contact_radius_m,force_N,{column},indentation_m");
        let curve = LoadingCurve::parse("si", &written(&header, &columns, |of| row(of, factor))).unwrap();
        assert_eq!(curve.pair, pair);
        for (found, want) in curve.points.iter().zip(&want.points) {
            assert_relative_eq!(found.indentation, want.indentation, max_relative = 1e-12);
            assert_relative_eq!(found.force, want.force, max_relative = 1e-12);
            assert_relative_eq!(found.elastic_approach, want.elastic_approach, max_relative = 1e-12);
            assert_relative_eq!(found.contact_radius.unwrap(), want.contact_radius.unwrap(), max_relative = 1e-12);
        }
    }
}

#[test]
fn a_curve_as_a_spreadsheet_writes_it_is_the_same_curve() {
    let want = &CURVES[2];
    let text = fs::read_to_string(reference(3)).unwrap();
    let with_mark = LoadingCurve::parse("mark", &format!("\u{feff}{}", text.replace('\n', "\r\n"))).unwrap();
    assert_eq!(with_mark.points, want.points);
    // without the contact radius, which is optional
    let row = |of: &LoadingPoint| {
        vec![of.indentation, of.force, of.elastic_approach * want.pair.sphere_compliance / of.indentation]
    };
    let text = written(HEADER, "delta_over_deltaY,F_over_FY,delta_s_over_delta", row);
    let without = LoadingCurve::parse("without", &text).unwrap();
    assert_relative_eq!(without.points[30].elastic_approach, want.points[30].elastic_approach, max_relative = 1e-12);
    assert!(without.points[30].contact_radius.is_none());
}

#[test]
fn any_curve_that_can_be_read_gives_a_law_or_an_error() {
    let steps = prop::collection::vec((0.01..3.0_f64, 0.01..5.0_f64, 0.02..1.1_f64), 9..20);
    let curves = (steps, 1e-4..0.999_f64, 1e-5..0.5_f64, any::<bool>());
    let fitted = checked(8, &curves, |(steps, kappa, yield_radius_ratio, has_knots)| {
        let mut text = format!(
            "# sphere.youngs_modulus = {} GPa\n# sphere.poissons_ratio = 0\n# half_space.youngs_modulus = {} GPa\n\
             # half_space.poissons_ratio = 0\n# half_space.yield_strength = {} GPa\n\
             delta_over_deltaY,F_over_FY,delta_s_over_delta\n",
            // E* = 100 GPa; a_Y/R = π C_ν σ_Y/(2 E*), and C_ν is 1.30075 at ν = 0
            100.0 / kappa,
            100.0 / (1.0 - kappa),
            100.0 * yield_radius_ratio / (0.5 * std::f64::consts::PI * 1.30075)
        );
        let (mut x, mut f) = (1.0, 1.0);
        for (ahead, up, share) in steps {
            x += ahead;
            f += up;
            writeln!(text, "{x},{f},{}", share * kappa).unwrap();
        }
        let curve = LoadingCurve::parse("random", &text).unwrap();
        let plan = Plan { start: PlmCoefficients::built_in().clone(), has_knots };
        let curves = [curve];
        let Ok(fitted) = fit::fit(&curves, &plan) else { return Ok(false) };
        prop_assert!(fitted.coefficients.check().is_ok());
        prop_assert!(fitted.cases[0].force.rms.is_finite() && fitted.cases[0].approach.rms.is_finite());
        Ok(true)
    });
    assert!(fitted >= 5, "{fitted} of 8");
}

#[test]
fn a_mangled_file_is_read_or_refused() {
    let text = fs::read_to_string(reference(3)).unwrap();
    let read = checked(256, &(0..3000_usize, "[ -~\n]{0,8}", 0..40_usize), |(at, with, skipped)| {
        let mangled: String =
            text.chars().take(at).chain(with.chars()).chain(text.chars().skip(at + skipped)).collect();
        let Ok(curve) = LoadingCurve::parse("mangled", &mangled) else { return Ok(false) };
        prop_assert!(curve.points.windows(2).all(|pair| pair[0].force < pair[1].force));
        Ok(true)
    });
    assert!(read >= 38, "{read} of 256");
}
