//! Fitting PLM coefficients: the finite-element curves, curves of a known law, the forms of a file, files that are refused.

#![allow(clippy::unwrap_used)]

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Output;

use approx::assert_relative_eq;
use assert_cmd::Command;
use plm_impact::fit::{self, LoadingCurve, LoadingPoint, Plan, knots, solve::case_fit};
use plm_impact::law::{PlmCoefficients, UnloadingExponent};
use plm_impact::material::{HalfSpace, Material, Pair};
use proptest::prelude::*;
use tempfile::TempDir;

fn reference(case: u32) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/reference/fe_loading_case{case}.csv"))
}

fn finite_elements() -> Vec<LoadingCurve> {
    (1..=5).map(|case| LoadingCurve::load(&reference(case)).unwrap()).collect()
}

fn plan(start: PlmCoefficients) -> Plan {
    Plan { start, has_knots: false }
}

#[test]
fn the_fit_to_the_finite_elements_is_as_good_as_the_built_in_table() {
    let curves = finite_elements();
    let built_in = PlmCoefficients::built_in();
    for has_knots in [false, true] {
        let fitted = fit::fit(&curves, &Plan { start: built_in.clone(), has_knots }).unwrap();
        fitted.coefficients.check().unwrap();
        for (curve, case) in curves.iter().zip(&fitted.cases) {
            let before = case_fit(curve, built_in);
            // no case may lose more than 0.2 %; documented of the built-in table: at most 1.4 % and 1.2 %
            assert!(case.force.rms < before.force.rms.min(0.014) + 0.002, "{}: {}", case.name, case.force.rms);
            assert!(case.approach.rms < before.approach.rms.min(0.012) + 0.002, "{}: {}", case.name, case.approach.rms);
            // allowed is 0.03 %; what is beyond is penalised, not forbidden
            assert!(case.restitution_rise < 4e-4, "{}: {}", case.name, case.restitution_rise);
            // a curve that was not fitted is met worse than one that was, but met: the worst is the rigid sphere, to which the
            // others only extrapolate
            let (force, approach) = case.left_out.unwrap();
            assert!(force.rms > case.force.rms && force.rms < 0.03, "{}: {}", case.name, force.rms);
            assert!(approach.rms < 0.02, "{}: {}", case.name, approach.rms);
        }
    }
}

#[test]
fn scatter_of_the_curves_does_not_keep_the_fit_from_converging() {
    let mut curves = finite_elements();
    for (i, curve) in (1..).zip(&mut curves) {
        // 1.5 % rms without any pattern
        let scatter = |point: &LoadingPoint, j: u32| 0.021 * (f64::from(i * 7 + j) * 1e4 * point.indentation).sin();
        for point in &mut curve.points {
            point.elastic_approach *= 1.0 + scatter(point, 1);
            point.force *= 1.0 + scatter(point, 2);
        }
    }
    let fitted = fit::fit(&curves, &plan(PlmCoefficients::built_in().clone())).unwrap();
    for case in &fitted.cases {
        // 1.5 % of scatter and 1.1 % of the form, added as squares, with a little left for chance
        assert!(case.force.rms < 0.022 && case.approach.rms < 0.022, "{case:?}");
    }
}

/// A law unlike the built-in one in every number.
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

/// Curves of that law for pairs from a hard to a very soft sphere, dense enough for points on every piece.
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
    // one curve that ends at x = 20: nothing is known of the slopes beyond
    let mut curve = finite_elements().remove(2);
    curve.points.retain(|point| point.indentation < 17.0);
    let built_in = PlmCoefficients::built_in();
    let fitted = fit::fit(&[curve], &plan(built_in.clone())).unwrap();
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

const HEADER: &str = "# sphere.youngs_modulus = 208 GPa\n# sphere.poissons_ratio = 0.3\n# half_space.youngs_modulus = 210 GPa\n\
                      # half_space.poissons_ratio = 0.3\n# half_space.yield_strength = 345 MPa\n";

/// The curve of case 3 in another form.
fn written(header: &str, columns: &str, row: impl Fn(&LoadingPoint) -> Vec<f64>) -> String {
    let mut text = format!("{header}{columns}\n");
    for point in LoadingCurve::load(&reference(3)).unwrap().points {
        let cells: Vec<String> = row(&point).iter().map(ToString::to_string).collect();
        writeln!(text, "{}", cells.join(",")).unwrap();
    }
    text
}

#[test]
fn a_curve_in_si_units_is_the_same_curve() {
    let want = LoadingCurve::load(&reference(3)).unwrap();
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
fn ratios_in_a_comment_do_for_the_keys() {
    let want = LoadingCurve::load(&reference(3)).unwrap();
    // E' of the paper's case 3, as the finite-element campaign prints it
    let header = "# any text\n# E'=114833 MPa E'_s=228571 E'_h=230769 sY=345 a_Y/R=0.00761293\n";
    let row = |of: &LoadingPoint| {
        vec![of.indentation, of.force, of.elastic_approach * want.pair.sphere_compliance / of.indentation]
    };
    let curve =
        LoadingCurve::parse("ratios", &written(header, "delta_over_deltaY,F_over_FY,delta_s_over_delta", row)).unwrap();
    assert_relative_eq!(curve.pair.sphere_compliance, want.pair.sphere_compliance, max_relative = 1e-5);
    assert_relative_eq!(curve.yield_radius_ratio, want.yield_radius_ratio, max_relative = 1e-5);
    assert_relative_eq!(curve.points[30].elastic_approach, want.points[30].elastic_approach, max_relative = 1e-5);
    assert!(curve.points[30].contact_radius.is_none());
    // as a spreadsheet writes it
    let text = fs::read_to_string(reference(3)).unwrap();
    let with_mark = LoadingCurve::parse("mark", &format!("\u{feff}{}", text.replace('\n', "\r\n"))).unwrap();
    assert_eq!(with_mark.points, want.points);
}

fn call(directory: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_plm-impact"));
    command.current_dir(directory).args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn the_command_writes_a_file_that_a_scenario_takes() {
    let directory = TempDir::new().unwrap();
    let names: Vec<String> = (1..=5).map(|case| format!("case{case}.csv")).collect();
    for (case, name) in (1..).zip(&names) {
        fs::copy(reference(case), directory.path().join(name)).unwrap();
    }
    let mut arguments = vec!["fit-plm"];
    arguments.extend(names.iter().map(String::as_str));
    arguments.extend(["-o", "mine.toml", "--name", "PLM of mine"]);
    let output = call(directory.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let table = text(&output.stdout);
    assert!(names.iter().all(|name| table.contains(name)) && table.contains("left out"), "{table}");

    let toml = fs::read_to_string(directory.path().join("mine.toml")).unwrap();
    let table = PlmCoefficients::from_toml(&toml).unwrap();
    assert_eq!(table.provenance.name, "PLM of mine");
    assert!(table.provenance.source.contains("5 loading curves: plm-impact fit-plm case1.csv"), "{toml}");
    assert!(table.provenance.range.contains("0.48"), "{toml}");
    // what is written is what was fitted, to ten digits
    let fitted = fit::fit(&finite_elements(), &plan(PlmCoefficients::built_in().clone())).unwrap().coefficients;
    assert_relative_eq!(table.force.slope[4], fitted.force.slope[4], max_relative = 1e-9);

    let scenario = include_str!("../scenarios/steel-on-steel.toml")
        .replace("[law.plm]", "[law.plm]\ncoefficients = \"mine.toml\"");
    fs::write(directory.path().join("s.toml"), scenario).unwrap();
    let output = call(directory.path(), &["run", "s.toml"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let summary = fs::read_to_string(directory.path().join("plots/s/summary.json")).unwrap();
    assert!(summary.contains("PLM of mine"));
}

#[test]
fn bad_files_are_refused_and_nothing_is_written() {
    let good = fs::read_to_string(reference(3)).unwrap();
    let line = |text: &str, n: usize| text.lines().nth(n).unwrap().to_owned();
    let first = good.lines().position(|line| line.starts_with("delta_over")).unwrap();
    let row = line(&good, first + 20);
    let replaced = |with: &str| good.replace(&row, with);
    let at = format!("bad.csv:{}: ", first + 21);
    let swapped = {
        let next = line(&good, first + 21);
        good.replace(&row, "\u{1}").replace(&next, &row).replace('\u{1}', &next)
    };
    let short: String = good.lines().take(first + 8).collect::<Vec<_>>().join("\n");
    let cases: Vec<(String, Vec<&str>)> = vec![
        (good.replace("delta_s_over_delta", "share"), vec!["elastic approach", "delta_s_over_delta"]),
        (good.replace("F_over_FY", "force"), vec!["no column gives the force", "force_N"]),
        (good.replace("F_over_FY", "force_N"), vec!["force_N", "sphere.radius = 35 mm"]),
        (
            good.replace("a_over_R", "force_N").replace("# sphere.youngs", "# sphere.radius = 1 mm\n# sphere.youngs"),
            vec!["two columns give the force"],
        ),
        (replaced("13.5,NaN,0.3,0.03"), vec![&at, "F_over_FY = NaN", "finite number above 0"]),
        (replaced("13.5,-3,0.3,0.03"), vec![&at, "F_over_FY = -3"]),
        (replaced("13.5,many,0.3,0.03"), vec![&at, "is not a number"]),
        (replaced("13.5,40"), vec![&at, "not as many values"]),
        (swapped, vec!["delta_over_deltaY does not rise"]),
        (short, vec!["beyond first yield", "at least 8"]),
        (good.replace("# half_space.yield_strength = 345 MPa", "#"), vec!["half_space.yield_strength", "do not say"]),
        (good.replace("345 MPa", "345 mm"), vec!["half_space.yield_strength", "345 mm", "a pressure"]),
        (good.replace("poissons_ratio = 0.3", "poissons_ratio = 0.7"), vec!["poissons_ratio", "0.7"]),
        (
            good.replace("half_space.yield_strength", "half_space.yield_strenght"),
            vec!["did you mean `half_space.yield_strength`"],
        ),
        (good.replace("208 GPa", "rigid"), vec!["rigid sphere", "elastic_approach_m"]),
        (good.replace("208 GPa", "20800 GPa"), vec!["cannot exceed 1", "check moduli"]),
        (String::new(), vec!["do not say"]),
    ];
    for (content, wants) in cases {
        let directory = TempDir::new().unwrap();
        fs::write(directory.path().join("bad.csv"), &content).unwrap();
        let output = call(directory.path(), &["fit-plm", "bad.csv", "-o", "out/c.toml"]);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{wants:?}: {message}");
        assert!(message.contains("bad.csv"), "{message}");
        for want in &wants {
            assert!(message.contains(want), "{want:?} is not in\n{message}");
        }
        assert!(output.stdout.is_empty());
        assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 1, "{wants:?}");
    }
}

#[test]
fn requests_that_make_no_sense_are_refused() {
    let directory = TempDir::new().unwrap();
    fs::copy(reference(3), directory.path().join("c.csv")).unwrap();
    let before = fs::read(directory.path().join("c.csv")).unwrap();
    for (arguments, want) in [
        (vec!["fit-plm", "missing.csv", "-o", "c.toml"], "missing.csv"),
        (vec!["fit-plm", "c.csv", "-o", "c.csv"], "is one of the curves"),
        (vec!["fit-plm", "c.csv", "-o", "./c.csv"], "is one of the curves"),
        (vec!["fit-plm", "c.csv", "-o", "c.toml", "--knots", "3,2"], "--knots"),
        (vec!["fit-plm", "c.csv", "-o", ".."], "is not the name of a file"),
        (vec!["fit-plm", ".", "-o", "c.toml"], "cannot be read"),
    ] {
        let output = call(directory.path(), &arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {message}");
        assert!(message.contains(want), "{arguments:?}: {message}");
        assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 1, "{arguments:?}");
    }
    assert_eq!(fs::read(directory.path().join("c.csv")).unwrap(), before);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, ..ProptestConfig::default() })]

    #[test]
    fn any_curve_that_can_be_read_gives_a_law_or_an_error(
        steps in prop::collection::vec((0.01..3.0_f64, 0.01..5.0_f64, 0.02..1.1_f64), 9..30),
        kappa in 1e-4..0.999_f64,
        yield_radius_ratio in 1e-5..0.5_f64,
        has_knots: bool,
    ) {
        let mut text = format!(
            "# E'=1e11 E'_s={} E'_h={} a_Y/R={yield_radius_ratio}\ndelta_over_deltaY,F_over_FY,delta_s_over_delta\n",
            1e11 / kappa,
            1e11 / (1.0 - kappa)
        );
        let (mut x, mut f) = (1.0, 1.0);
        for (ahead, up, share) in steps {
            x += ahead;
            f += up;
            writeln!(text, "{x},{f},{}", share * kappa).unwrap();
        }
        let curve = LoadingCurve::parse("random", &text).unwrap();
        if let Ok(fitted) = fit::fit(&[curve], &Plan { start: PlmCoefficients::built_in().clone(), has_knots }) {
            prop_assert!(fitted.coefficients.check().is_ok());
            prop_assert!(fitted.cases[0].force.rms.is_finite() && fitted.cases[0].approach.rms.is_finite());
        }
    }

    #[test]
    fn a_mangled_file_is_read_or_refused(at in 0..3000_usize, with in "[ -~\n]{0,8}", skipped in 0..40_usize) {
        let text = fs::read_to_string(reference(3)).unwrap();
        let mangled: String = text.chars().take(at).chain(with.chars()).chain(text.chars().skip(at + skipped)).collect();
        if let Ok(curve) = LoadingCurve::parse("mangled", &mangled) {
            prop_assert!(curve.points.windows(2).all(|pair| pair[0].force < pair[1].force));
        }
    }
}
