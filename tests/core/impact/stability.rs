//! The stability suite: every hard case by every stepping method at all tolerances, and scenes that are hard in SI
//! units.
#![allow(clippy::unwrap_used, clippy::excessive_precision)] // values as printed

use plm_impact::impact::solve::closed_form;

use plm_impact::bench::problems::{BenchProblem, kinked_law, steel_speed_ratio};

use super::stability_cases::hard_cases;
use crate::common::prelude::*;

const TOLERANCES: [f64; 11] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13];

/// The error that rounding leaves at any tolerance. Between knots that are 1e-12 apart the contact time depends on the
/// speed at each knot, u² = q² − (5/2) w, which has four digits fewer. All other errors are below 1e-14.
fn rounding(case: &BenchProblem) -> f64 {
    if case.name.contains("peak among") { 2e-12 } else { 1e-13 }
}

#[test]
fn every_case_has_its_reference_value() {
    // 50-digit arithmetic, independent of the code of the law; the speed ratio is rounded to double precision here
    let table: Vec<(String, f64, f64)> = records(include_str!("../../reference/hard_cases.csv"));
    let cases = hard_cases();
    assert_eq!(table.len(), cases.len());
    for (case, (name, restitution, contact_time)) in cases.iter().zip(table) {
        assert_eq!(case.name, name);
        let exact = closed_form::solve(&case.law, case.speed);
        let listed = case.exact.restitution;
        assert!(relative_error(listed, restitution) < 1e-14, "{name}: {listed} ({})", case.description);
        assert!(relative_error(exact.restitution, restitution) < 1e-14, "{name}: {}", exact.restitution);
        // at 1e-100, x_m = (…)^0.4 has an error of 1e-14: 0.4 is rounded by 2e-17, times ln of 1e-200
        let allowed = match name.as_str() {
            "v = 1e-100 v_Y" => 3e-14,
            _ if name.contains("peak among") => rounding(case),
            _ => 1e-14,
        };
        assert!(relative_error(exact.contact_time, contact_time) < allowed, "{name}: {}", exact.contact_time);
    }
}

#[test]
fn every_method_meets_its_tolerance_on_all_cases() {
    let cases = hard_cases().into_iter().map(|case| {
        let rounding = rounding(&case);
        (case.name.to_string(), case.law, case.speed, case.exact, rounding)
    });
    // the problems of the bench have printed references
    let free = problems().unwrap().into_iter().filter(|problem| problem.forces.is_none());
    let free = free.map(|problem| (problem.name.to_string(), problem.law, problem.speed, problem.exact, 1e-13));
    for (name, law, speed, exact, rounding) in cases.chain(free) {
        let kinetic = 0.4 * speed * speed;
        for (method, factor) in STEPPING {
            for tolerance in TOLERANCES {
                let (outcome, work) = run(&law, speed, method, tolerance)
                    .unwrap_or_else(|error| panic!("{name}, {} at {tolerance:e}: {error}", method.name()));
                let at = format!("{name}, {} at {tolerance:e}", method.name());
                let error = max_relative_error_of_outcomes(&outcome, &exact);
                assert!(error <= factor * tolerance + rounding, "{at}: off by {error:e}");
                // not too many steps: a method of order 5 at 1e-13 takes about 400 steps for a piece
                assert!(work.steps < 1000 * (law.loading.pieces().len() as u64 + 1), "{at}: {work:?}");
                let peak: ContactState = outcome.unloading.peak;
                // a dent of 2.5e-13 is only 1100 ulps of x, but it is never negative, and R_e ≥ R
                assert!(tolerance > 1e-10 || peak.residual() >= 0.0, "{at}");
                assert!(tolerance > 1e-10 || peak.unloading_radius_ratio() >= 1.0 - 1e-9, "{at}");
                if method == Method::Rk8 {
                    // (kinetic + stored + lost)/kinetic at separation: e² + (w_m − f_m ε_m/(n + 1))/kinetic = 1
                    let spent = law.loading.work(peak.indentation);
                    let lost = spent - outcome.unloading.stored_energy(peak.indentation);
                    let at_separation = outcome.restitution.powi(2) + lost / kinetic - 1.0;
                    let drift = nan_max((spent / kinetic - 1.0).abs(), at_separation.abs());
                    assert!(drift <= 10.0 * tolerance + rounding, "{at}: {drift:e}");
                }
            }
        }
    }
}

#[test]
fn closed_form_matches_printed_values() {
    for problem in problems().unwrap().into_iter().filter(|problem| problem.forces.is_none()) {
        // the printed values have 16 digits or more; the speed ratio is rounded once more
        let error = max_relative_error_of_outcomes(&closed_form::solve(&problem.law, problem.speed), &problem.exact);
        assert!(error < 2e-15, "{}: {error:e}", problem.name);
    }
    // x_m/δ_Y of P2, P3 and P4a, as printed with their definitions
    for (law, speed, want) in
        [(kinked_law(), 1.0, 77.44), (problems().unwrap()[2].law.clone(), 3.2, 299.685), (kinked_law(), 10.0, 771.4)]
    {
        let got = closed_form::solve(&law, steel_speed_ratio(speed)).unloading.peak.indentation;
        assert!(relative_error(got, want) < 1e-4, "{got} against {want}");
    }
}

#[test]
fn modulus_ratio_goes_to_its_limits() {
    let scene = Scene { exponent: UnloadingExponent::PressureShape, ..Scene::steel() };
    let impact = |sphere: f64, half_space: f64| {
        let mut scene = scene;
        scene.sphere.youngs_modulus = sphere;
        scene.half_space.youngs_modulus = half_space;
        // σ_Y is a fixed share of E*, and v is a fixed multiple of v_Y, so only κ changes
        let compliance = (1.0 - 0.09) * (1.0 / sphere + 1.0 / half_space);
        scene.yield_strength = Some(3e-3 / compliance);
        scene.impact(300.0 * scene.yield_speed(), Method::Rk8, 1e-12, None)
    };
    let (rigid, soft) = (impact(f64::INFINITY, 1e11), impact(1e9, 1e21));
    for ratio in [1e3, 1e6, 1e9, 1e12] {
        // e differs from its limits κ = 0 and κ = 1 in proportion to κ and 1 − κ, about 1/ratio
        assert!(
            relative_error(impact(1e11 * ratio, 1e11).row.restitution, rigid.row.restitution) < 1.0 / ratio + 1e-11,
            "{ratio:e}"
        );
        assert!(
            relative_error(impact(1e9, 1e9 * ratio).row.restitution, soft.row.restitution) < 1.0 / ratio + 1e-11,
            "{ratio:e}"
        );
    }
    assert_eq!(rigid.peak_sphere_indentation, 0.0);
    assert!(rigid.unloading_radius.is_finite() && rigid.elastic_approach > 0.0);
}

#[test]
fn force_is_exact_at_zero_and_near_knots() {
    let cases = hard_cases().into_iter().map(|case| (case.name, case.law));
    for (name, law) in cases.chain([("case 3", Scene::case_3().law())]) {
        assert_eq!(
            (law.force_and_memory(0.0, None), law.force_and_memory(-1.0, None)),
            ((0.0, None), (0.0, None)),
            "{name}"
        );
        assert!((0.0..1e-300).contains(&law.force_and_memory(f64::MIN_POSITIVE, None).0));
        assert!(law.force_and_memory(f64::NAN, None).0.is_nan());
        for (i, pair) in law.loading.pieces().windows(2).enumerate() {
            let knot = pair[1].start;
            assert_eq!((law.loading.index_at(knot.next_down()), law.loading.index_at(knot)), (i, i + 1), "{name}");
            assert!(relative_error(pair[0].force_at(knot), pair[1].force_at(knot)) < 1e-15, "{name}");
            assert!(relative_error(pair[0].work_at(knot), pair[1].work_at(knot)) < 1e-15, "{name}");
            let [before, on, behind] = [knot.next_down(), knot, knot.next_up()].map(|x| law.loaded_state(x));
            assert!(before.force <= on.force && on.force <= behind.force, "{name}");
            // one ulp of x changes f by less than two ulps, because f' x/f < 2
            for beside in [before, behind] {
                assert!(relative_error(beside.force, on.force) < 1e-15, "{name}: {knot}");
                let is_near = relative_error(beside.elastic_approach, on.elastic_approach) < 1e-15;
                assert!(is_near || name != "case 3", "{name}: {knot}");
            }
        }
    }
}

proptest! {
    #![proptest_config(crate::common::proptest_config(500))]

    #[test]
    fn restitution_is_continuous_in_speed_across_every_knot(scene in any_scene(), log_gap in -12.0..-3.0_f64) {
        let contact = scene.contact();
        let yield_speed = scene.yield_speed();
        let gap = 10_f64.powf(log_gap);
        let law = scene.law();
        let knots = law.loading.pieces().iter().skip(1).map(|piece| (2.5 * piece.work).sqrt()).chain([1.0]);
        for q in knots {
            let at = |q: f64| skip_if_law_has_no_answer(contact.closed_form(q * yield_speed));
            let (Ok(below), Ok(above)) = (at(q * (1.0 - gap)), at(q * (1.0 + gap))) else { break };
            // |d ln e/d ln v| < 1/2 on every piece, |d ln T/d ln v| < 1
            prop_assert!(relative_error(above.row.restitution, below.row.restitution) <= gap + 1e-13, "{q}");
            prop_assert!(relative_error(above.row.contact_time, below.row.contact_time) <= 2.0 * gap + 1e-13, "{q}");
            prop_assert!(relative_error(above.row.peak_force, below.row.peak_force) <= 4.0 * gap + 1e-13, "{q}");
        }
    }
}

#[test]
fn extreme_scales_are_computed_or_refused() {
    let mut computed = 0;
    for radius in [1e-300, 1e-100, 1e-30, 1e30, 1e100, 1e300] {
        for modulus in [1e-300, 1e-30, 1e30, 1e300] {
            for speed in [1e-300, 1.0, 1e300] {
                let mut scene = Scene { radius, yield_strength: Some(1e-3 * modulus), ..Scene::steel() };
                scene.sphere.youngs_modulus = modulus;
                scene.half_space.youngs_modulus = modulus;
                let Ok(contact) = scene.try_contact() else { continue };
                match contact.impact(speed, &solver(Method::Rk8, 1e-10), None) {
                    Ok(impact) => {
                        let results = [
                            impact.row.restitution,
                            impact.row.contact_time,
                            impact.loading_time,
                            impact.row.peak_force,
                        ];
                        assert!(results.iter().all(|result| result.is_finite() && *result > 0.0), "{impact:?}");
                        assert!(impact.row.restitution <= 1.0 + 1e-9);
                        // of an elastic impact, (2/5) F_m δ_m = ½ m v²
                        let stored = 0.4 * impact.row.peak_force * impact.row.peak_indentation;
                        assert!(
                            impact.row.has_dent() || relative_error(stored, impact.row.kinetic_in) < 1e-9,
                            "{impact:?}"
                        );
                        computed += 1;
                    }
                    Err(ImpactError::Range(_) | ImpactError::TooDeep { .. }) => {}
                    Err(error) => panic!("R = {radius:e}, E = {modulus:e}, v = {speed:e}: {error}"),
                }
            }
        }
    }
    // of the others many would go deeper than the sphere
    assert!(computed >= 5, "{computed} of 72 scenes");
}
