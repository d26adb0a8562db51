//! Which bodies flow where a strength rises with the strain rate, and the relaxation at the turn.

use super::impulse;
use crate::common::prelude::*;
use crate::impact::strain_rate::{COOK, COWPER, rated};

/// A mild steel ball with Cowper and Symonds' constants on a wall of this strength without a rate, at 3 m/s.
fn ball_on_wall(strength: f64) -> Contact {
    let keys = [
        "sphere.yield_strength=300 MPa".to_owned(),
        "sphere.rate.cowper_symonds.rate=6844".to_owned(),
        "sphere.rate.cowper_symonds.exponent=3.91".to_owned(),
        "law.plm.unloading_exponent=pressure-shape".to_owned(),
        format!("half_space.yield_strength={strength:e}"),
    ];
    contact(STEEL, &keys)
}

/// The bodies share the flow by their strengths without a rate. A wall of 1.25 times the strength of the ball or more has no part in it,
/// also where the rate raises the ball above the wall.
#[test]
fn rate_of_one_body_keeps_yielding_body() {
    let want = ball_on_wall(1e9).closed_form(3.0).unwrap();
    for strength in [376e6, 380e6, 400e6, 440e6, 480e6, 500e6] {
        let impact = ball_on_wall(strength).closed_form(3.0).unwrap();
        assert!((impact.row.restitution - 0.50313).abs() < 5e-6, "{strength}: {}", impact.row.restitution);
        assert_eq!(
            (impact.row.restitution, impact.row.strain_rate_result),
            (want.row.restitution, want.row.strain_rate_result),
            "{strength}"
        );
        let StrainRateResult { factor, factor_at_peak, .. } = impact.row.strain_rate_result.unwrap();
        assert!(factor > 1.6 && factor > factor_at_peak && factor_at_peak > 1.3, "{factor} {factor_at_peak}");
        let point = ball_on_wall(strength).at_speed(3.0).unwrap().pair().yield_point.unwrap();
        assert!(point.yield_partition.is_sphere && relative_error(point.strength, 300e6 * factor) < 1e-15);
    }
}

/// e has no step where the strength of the wall passes that of the ball, nor where the wall stops to flow.
#[test]
fn restitution_is_continuous_in_the_ratio_of_strengths() {
    let e = |ratio: f64| ball_on_wall(300e6 * ratio).closed_form(3.0).unwrap().row.restitution;
    let mut before = e(0.6);
    for i in 1..=140_i32 {
        let ratio = 0.6 + 0.01 * f64::from(i);
        let (below, above) = (e(ratio * (1.0 - 1e-9)), e(ratio * (1.0 + 1e-9)));
        assert!((above - below).abs() < 1e-7, "{ratio}: {below} {above}");
        // from ratio to ratio nothing jumps either
        assert!((below - before).abs() < 0.02, "{ratio}: {before} {below}");
        before = above;
    }
    let [soft, equal, hard] = [0.79, 1.0, 1.26].map(|ratio| ball_on_wall(300e6 * ratio).closed_form(3.0).unwrap());
    let [soft, equal, hard] = [soft, equal, hard].map(|impact| impact.row.strain_rate_result.unwrap());
    assert_eq!((soft.factor, soft.factor_at_peak), (1.0, 1.0), "the wall flows alone, and has no rate");
    // bodies of one modulus share the flow in halves
    assert!((equal.factor - 1.0) / (hard.factor - 1.0) > 0.49 && (equal.factor - 1.0) / (hard.factor - 1.0) < 0.51);
}

/// The plastic energy is limited by the work of loading: the branch gives back no more than this work, which sets the exponent.
#[test]
fn relaxed_metal_recovers_at_most_work_spent() {
    let text = r"
        [sphere]
        radius = 8.603503350791451e-06
        youngs_modulus = 5365045196215.846
        poissons_ratio = -0.2
        density = 7923.565461924973
        yield_strength = 13706577863.874678
        flow_stress = { power = { exponent = 0.4325587002871408 } }
        rate = { cowper_symonds = { rate = 25.7064091662025, exponent = 6.956792760418017 }, tested_at = 572.2324778515317 }
        [half_space]
        youngs_modulus = 584484745870.6494
        poissons_ratio = 0.35140509905008027
        yield_strength = 110935527380.53993
        [impact]
        speed = 19.19239109127876
    ";
    let contact = contact(text, NO_OVERRIDES);
    for method in [Method::ClosedForm, Method::Rk8, Method::Dop853] {
        let impact = contact.impact(19.192_391_091_278_76, &solver(method, 1e-12), None).unwrap();
        assert!((impact.row.restitution - 1.0).abs() < 1e-11, "{method:?}: {}", impact.row.restitution);
        assert!(impact.energy.plastic.unwrap() >= 0.0 && impact.energy.balance_error < 1e-11);
        assert!(impact.warnings.iter().all(|warning| warning.kind != WarningKind::Inaccurate), "{:?}", impact.warnings);
    }
}

/// Just beyond first yield at the turn the force does not rise there.
#[test]
fn the_force_never_rises_where_the_metal_relaxes() {
    let plain = scene(STEEL, NO_OVERRIDES);
    for rate in [COOK, COWPER] {
        let contact = rated(rate, &[]).contact().unwrap();
        for i in 1..400 {
            let speed = contact.yield_speed().unwrap() * (1.0 + 2e-3 * f64::from(i));
            let impact = contact.closed_form(speed).unwrap();
            let strength = 345e6 * impact.row.strain_rate_result.unwrap().factor;
            let loading = scene(STEEL, &[format!("half_space.yield_strength={strength:e}")]).contact().unwrap();
            let force = loading.force(impact.row.peak_indentation, &mut Memory::default());
            assert!(impact.force_at_peak_indentation <= force * (1.0 + 1e-12), "{speed}: {impact:?} {force}");
            assert!(impact.row.restitution <= 1.0 && impact.row.plastic_fraction >= 0.0, "{speed}");
        }
    }
    assert!(plain.contact().unwrap().closed_form(3.0).unwrap().row.strain_rate_result.is_none());
}

/// On a plate the momentum of the ball stays where the metal relaxes: its speed does not jump, the impulse of the force is the
/// change of its momentum, and the energies add up.
#[test]
fn plate_keeps_momentum_at_relaxation() {
    let keys = [
        "half_space.yield_strength=300 MPa",
        "half_space.density=7850",
        "half_space.rate.cowper_symonds.rate=6844",
        "half_space.rate.cowper_symonds.exponent=3.91",
    ];
    for (thickness, restitution) in [("3 mm", 0.18959), ("2 mm", 0.0362)] {
        let thickness = format!("half_space.thickness={thickness}");
        let contact = contact(STEEL, &[&keys[..], &[&thickness]].concat());
        for method in [Method::Rk8, Method::Dop853] {
            let impact = contact.impact(3.0, &solver(method, 1e-11), Some(4001)).unwrap();
            assert!((impact.row.restitution - restitution).abs() < 1e-5, "{}", impact.row.restitution);
            let at = impact.trace.iter().position(|row| row.event == Some(Event::Relaxation)).unwrap();
            let [before, after] = [impact.trace[at - 1], impact.trace[at]];
            assert!(before.event == Some(Event::Peak) && before.force > 1.1 * after.force);
            assert!((after.sphere_speed.unwrap() - before.sphere_speed.unwrap()).abs() < 1e-13);
            let impulse = impulse(&impact.trace);
            let momentum = contact.mass() * (1.0 + impact.row.restitution) * 3.0;
            assert!(relative_error(impulse, momentum) < 1e-6, "{impulse} {momentum}");
            let shares = impact.row.recovered_fraction()
                + impact.row.plastic_fraction
                + impact.row.waveguide_loss_fraction(WaveguideKind::Plate).unwrap();
            assert!(
                (shares - 1.0).abs() < 1e-9 && impact.energy.balance_error < 1e-9,
                "{shares} {}",
                impact.energy.balance_error
            );
        }
        // in fixed steps to the order of a step
        let steps = Solver { method: Method::Verlet, steps_per_contact: 4000, ..Solver::default() };
        let fixed = contact.impact(3.0, &steps, None).unwrap();
        assert!((fixed.row.restitution - restitution).abs() < 1e-4, "{}", fixed.row.restitution);
        let lost = |impact: &Impact| impact.row.waveguide_loss_fraction(WaveguideKind::Plate).unwrap();
        let stepped = contact.impact(3.0, &solver(Method::Rk8, 1e-11), None).unwrap();
        assert!((lost(&fixed) - lost(&stepped)).abs() < 1e-3, "{} {}", lost(&fixed), lost(&stepped));
    }
}
