//! Strengths that rise with the strain rate: references, finite elements, limits, and what holds for any constants.

use plm_impact::impact::Spot;

use crate::common::prelude::*;
use crate::common::reference::rows;

/// A steel ball on mild steel, with these lines in the table of the rate.
pub fn rated(rate: &str, set: &[&str]) -> Input {
    scene(&STEEL.replace("[impact]", &format!("[half_space.rate]\n{rate}\n[impact]")), set)
}

pub const COOK: &str = "johnson_cook = { c = 0.03 }";
pub const COWPER: &str = "cowper_symonds = { rate = 6844, exponent = 3.91 }";

#[test]
fn impacts_are_those_of_an_independent_program() {
    let all = rows(include_str!("../../reference/rate.csv"));
    assert_eq!(all.len(), 9);
    for row in all {
        let scene = row.scene();
        let contact = scene.contact().unwrap();
        let own = contact.at_speed(scene.speed()).unwrap();
        let impact = contact.closed_form(scene.speed()).unwrap();
        let rated = impact.row.strain_rate_result.unwrap();
        let (indentation, force) = own.yield_indentation_and_force().unwrap();
        for (column, got) in [
            ("rate_factor", rated.factor),
            ("rate_factor_at_peak", rated.factor_at_peak),
            ("strain_rate_per_s", rated.strain_rate),
            ("restitution", impact.row.restitution),
            ("force_at_turn_N", impact.force_at_peak_indentation),
            ("peak_force_N", impact.row.peak_force),
            ("peak_indentation_m", impact.row.peak_indentation),
            ("elastic_approach_m", impact.elastic_approach),
            ("loading_time_s", impact.loading_time),
            ("contact_time_s", impact.row.contact_time),
            ("exponent_n", impact.unloading_exponent),
            ("yield_speed_m_per_s", own.yield_speed().unwrap()),
            ("yield_indentation_m", indentation),
            ("yield_force_N", force),
        ] {
            assert!(
                relative_error(got, row.number(column)) < 1e-9,
                "{} {column}: {got} {}",
                row.name(),
                row.number(column)
            );
        }
        // a difference of two numbers of the size of the depth
        let residual = impact.row.residual_indentation - row.number("residual_indentation_m");
        assert!(residual.abs() < 1e-9 * impact.row.peak_indentation, "{}", row.name());
        // without the rate
        let plain = contact.clone().with_rate_dependence([None; 2], &scene.law()).closed_form(scene.speed()).unwrap();
        assert!(relative_error(plain.row.restitution, row.number("restitution_without_rate")) < 1e-9, "{}", row.name());
    }
}

/// Own explicit finite elements with the rate in every Gauss point, by bounds that were set before the law was written: e with waves
/// 1.6 %, 3 % at 10 m/s and for Cowper-Symonds; residual indentation as a share of the depth.
#[test]
fn impacts_are_those_of_finite_elements() {
    let all = rows(include_str!("../../../src/reference/fe_rate.csv"));
    assert_eq!(all.len(), 10);
    for row in all {
        let scene = scene("", &[row.keys(&[]), vec!["law.plm.unloading_exponent=pressure-shape".to_owned()]].concat());
        let impact = scene.contact().unwrap().closed_form(scene.speed()).unwrap();
        let is_wide = scene.speed() == 10.0 || row.name().starts_with('K');
        let depth = row.number("peak_indentation_m");
        for (what, off, allowed) in [
            (
                "e",
                impact.row.restitution_with_waves().unwrap() / row.number("restitution") - 1.0,
                if is_wide { 0.03 } else { 0.016 },
            ),
            ("time", impact.row.contact_time / row.number("contact_time_s") - 1.0, 0.012),
            ("depth", impact.row.peak_indentation / depth - 1.0, 0.02),
            ("force", impact.row.peak_force / row.number("peak_force_N") - 1.0, 0.03),
            ("residual", (impact.row.residual_indentation - row.number("residual_indentation_m")) / depth, 0.03),
        ] {
            assert!(off.abs() < allowed, "{} {what}: {off}", row.name());
        }
    }
}

#[test]
fn the_factor_goes_to_one_without_a_step() {
    let plain = scene(STEEL, NO_OVERRIDES).contact().unwrap().closed_form(3.0).unwrap();
    let mut last = f64::INFINITY;
    for k in 1..=12 {
        let c = 10_f64.powi(-k);
        let impact = rated(&format!("johnson_cook = {{ c = {c} }}"), &[]).contact().unwrap().closed_form(3.0).unwrap();
        let apart = max_relative_error(&impact, &plain);
        // to first order in c: ln of the ratio of the rates is below 15
        assert!(apart < 15.0 * c && apart < last, "{c}: {apart}");
        last = apart;
    }
    // a test at least as fast as the loading
    let fast = rated("johnson_cook = { c = 0.03 }\ntested_at = 1e6", &[]).contact().unwrap().closed_form(3.0).unwrap();
    assert_eq!(fast.row.restitution.to_bits(), plain.row.restitution.to_bits());
    // slower and slower: the factor of a sphere that hardly moves is 1
    let slow = rated(COOK, &["half_space.rate.tested_at=0.1"]).contact().unwrap();
    assert_eq!(slow.closed_form(1e-9).unwrap().row.strain_rate_result.unwrap().factor, 1.0);
    // across the speed of first yield at the turn e has no step
    let contact = rated(COOK, &[]).contact().unwrap();
    let e = |speed: f64| contact.closed_form(speed).unwrap().row.restitution;
    let (mut low, mut high) = (1e-3, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if e(middle) == 1.0 { &mut low } else { &mut high }) = middle;
    }
    assert!(e(low) == 1.0 && e(high) > 1.0 - 1e-7, "{high} {}", e(high));
}

/// A reload goes up the branch of the old dent until that meets the loading curve of its own rate.
#[test]
fn loading_at_new_rate_meets_old_dent() {
    for exponent in ["1.5", "pressure-shape"] {
        let input = rated(COWPER, &[&*format!("law.plm.unloading_exponent={exponent}")]);
        let contact = input.contact().unwrap();
        let mut spot = Spot::new();
        let first = contact.impact_on(&mut spot, 3.0, &Solver::AUTO, None).unwrap();
        assert!(relative_error(contact.dent_depth(&spot), first.row.residual_indentation) < 1e-12);
        // a slow one is elastic, leaves the dent as it is, and has no factor
        let slow = contact.impact_on(&mut spot, 0.5, &solver(Method::Rk8, 1e-12), Some(20)).unwrap();
        assert!(
            relative_error(slow.row.restitution, 1.0) < 1e-9
                && slow.row.strain_rate_result.is_none()
                && slow.energy.balance_error < 1e-11
        );
        assert!(relative_error(contact.dent_depth(&spot), first.row.residual_indentation) < 1e-12);
        // a faster one makes the dent deeper than a fresh impact of its speed
        for speed in [4.0, 6.0] {
            let before = contact.dent_depth(&spot);
            let impact = contact.impact_on(&mut spot, speed, &Solver::AUTO, None).unwrap();
            let fresh = contact.closed_form(speed).unwrap();
            assert!(
                impact.row.residual_indentation > before && impact.row.peak_indentation > fresh.row.peak_indentation
            );
            assert!(
                relative_error(
                    impact.row.strain_rate_result.unwrap().factor,
                    fresh.row.strain_rate_result.unwrap().factor
                ) < 1e-15
            );
        }
    }
}

/// Both bodies with a rate: of one metal they flow as ever, with one factor; and the harder of two stays out of it.
#[test]
fn each_body_has_its_own_factor() {
    let both = |sphere: &str, half_space: &str, strength: &str| {
        let keys = [sphere, strength, "sphere.rate.tested_at=0.001", half_space];
        rated("tested_at = 0.001", &keys).contact().unwrap().closed_form(3.0).unwrap()
    };
    let [cook, cowper] = ["sphere.rate.johnson_cook.c=0.03", "half_space.rate.johnson_cook.c=0.03"];
    let equal = both(cook, cowper, "sphere.yield_strength=345 MPa");
    // the strengths by hand, with the factors that came out; at the turn they are others
    let rated = equal.row.strain_rate_result.unwrap();
    let strength = 345e6 * rated.factor;
    let by_hand = scene(
        STEEL,
        &[format!("half_space.yield_strength={strength:e}"), format!("sphere.yield_strength={strength:e}")],
    );
    let by_hand = by_hand.contact().unwrap().closed_form(3.0).unwrap();
    assert!(relative_error(equal.row.peak_indentation, by_hand.row.peak_indentation) < 1e-12);
    assert!(equal.row.flat_depth > 0.0 && equal.row.dent_depth() > 0.0);
    // a sphere of twice the strength has no part in it
    let hard = both(cook, cowper, "sphere.yield_strength=690 MPa");
    let alone = self::rated(COOK, &[]).contact().unwrap().closed_form(3.0).unwrap();
    assert!(
        relative_error(hard.row.restitution, alone.row.restitution) < 1e-12
            && hard.row.strain_rate_result == alone.row.strain_rate_result
    );
}

/// A ball that hardens on a much harder wall, with this rate and these keys more.
fn ball_that_hardens(rate: &[&str]) -> Contact {
    let keys = ["sphere.yield_strength=100 MPa", "sphere.flow_stress.linear.slope=1 GPa"];
    scene(STEEL, &[&keys[..], rate].concat()).contact().unwrap()
}

/// The rate of a ball raises its whole flow curve: while it goes in it is the ball of the raised strength and slope, and at the turn
/// the force is the one of the relaxed strength and slope at that depth. A rise of nothing changes no bit.
#[test]
fn ball_with_flow_curve_has_its_rate() {
    let plain = ball_that_hardens(&[]);
    let (none, rising) =
        (ball_that_hardens(&["sphere.rate.johnson_cook.c=0"]), ball_that_hardens(&["sphere.rate.johnson_cook.c=0.03"]));
    for speed in [0.1, 1.0, 3.0] {
        let [a, b, rated] = [&plain, &none, &rising].map(|contact| contact.closed_form(speed).unwrap());
        assert!(
            a.row.restitution < 0.9 && a.row.flat_depth > 0.0 && a.row.dent_depth() == 0.0,
            "the ball flows, alone: {a:?}"
        );
        assert_eq!(ImpactRow { strain_rate_result: None, ..b.row }, a.row);

        let by_hand = |factor: f64| {
            let keys = [
                format!("sphere.yield_strength={:e}", 100e6 * factor),
                format!("sphere.flow_stress.linear.slope={:e}", 1e9 * factor),
            ];
            scene(STEEL, &keys).contact().unwrap()
        };
        let StrainRateResult { factor, factor_at_peak, .. } = rated.row.strain_rate_result.unwrap();
        assert!(factor > factor_at_peak && factor_at_peak > 1.1, "{factor} {factor_at_peak}");
        let raised = by_hand(factor).closed_form(speed).unwrap();
        assert!(relative_error(rated.row.peak_indentation, raised.row.peak_indentation) < 1e-12, "{speed}");
        assert!(relative_error(rated.loading_time, raised.loading_time) < 1e-12, "{speed}");
        let at_turn = by_hand(factor_at_peak).force(rated.row.peak_indentation, &mut Memory::default());
        assert!(relative_error(rated.force_at_peak_indentation, at_turn) < 1e-12, "{speed}");
        assert!(rated.row.restitution > a.row.restitution);
        let run = rising.impact(speed, &solver(Method::Rk8, 1e-13), Some(50)).unwrap();
        assert!(
            max_relative_error(&run, &rated) < 1e-11 && run.energy.balance_error < 1e-12,
            "{speed}: {}",
            max_relative_error(&run, &rated)
        );
    }
}

/// A soft sphere on a metal that relaxes stays elastic a little beyond first yield. Once its dent was below zero by a rounding.
#[test]
fn a_dent_of_nothing_is_not_below_zero() {
    let keys =
        ["sphere.youngs_modulus=84 MPa", "half_space.youngs_modulus=13.2 GPa", "half_space.yield_strength=66.5 kPa"];
    let contact = rated("johnson_cook = { c = 0.0348 }", &keys).contact().unwrap();
    let slowest = contact.yield_speed().unwrap();
    for i in 0..2000 {
        let impact = contact.closed_form(slowest * (1.0 + 1e-3 * f64::from(i))).unwrap();
        assert!(impact.row.residual_indentation >= 0.0, "{i}: {:e}", impact.row.residual_indentation);
    }
}
