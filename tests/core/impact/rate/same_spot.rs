//! Series on one spot where a strength rises with the strain rate: a dent becomes no shallower, and no impact gains energy.

use super::impulse;
use crate::common::prelude::*;

/// The impacts of a series on one spot, by the closed form where there is one.
fn series(text: &str, speeds: &[f64]) -> Vec<Impact> {
    let contact = contact(&format!("{text}\n[impact]\nspeed = 1.0"), NO_OVERRIDES);
    let mut spot = Spot::new();
    let mut shot = |speed: &f64| contact.impact_on(&mut spot, *speed, &solver(Method::Auto, 1e-11), None).unwrap();
    speeds.iter().map(&mut shot).collect()
}

fn dents(impacts: &[Impact]) -> Vec<f64> {
    impacts.iter().map(|impact| impact.row.residual_indentation).collect()
}

/// The shots after the deepest dent are slower than the one that made it: they turn in the dent, and leave it as it is.
fn turn_in_the_old_dent(impacts: &[Impact], first: usize) {
    let dent = impacts[first - 1].row.residual_indentation;
    assert!(dent > 0.0);
    for impact in &impacts[first..] {
        assert!(relative_error(impact.row.residual_indentation, dent) < 1e-12, "{:?}", dents(impacts));
        assert!(impact.row.strain_rate_result.is_none() && impact.energy.plastic == Some(0.0));
    }
}

#[test]
fn slower_impact_keeps_dent() {
    let free = r#"
        [sphere]
        radius = 0.00031167528426585155
        youngs_modulus = 413363689.69793886
        poissons_ratio = 0.2546961870320391
        density = 19973.074132639682
        yield_strength = 33319133.595487084
        rate = { johnson_cook = { c = 0.002236154828685046, reference = 0.001 }, tested_at = 7.35510292444888 }
        [half_space]
        youngs_modulus = 728950311.2448938
        poissons_ratio = 0.4999
        yield_strength = 3740857.195866987
        flow_stress = { power = { exponent = 0.4194819384368634 } }
        rate = { johnson_cook = { c = 0.002236154828685046, reference = 0.001 }, tested_at = 7.35510292444888 }
        radius = 0.0008837770896373699
        [law]
        plm = { unloading_exponent = "pressure-shape" }
    "#;
    let impacts = series(
        free,
        &[0.009_152_665_943_031_487, 0.028_003_095_724_817_777, 0.014_737_109_871_953_263, 0.011_167_023_142_073_155],
    );
    assert!(impacts.iter().all(|impact| impact.row.restitution == 1.0));
    turn_in_the_old_dent(&impacts, 2);

    let small = r"
        [sphere]
        radius = 1.9693133433434576e-06
        youngs_modulus = 355783174711.9749
        poissons_ratio = 0.34327596826714946
        density = 1324.9929621564957
        [half_space]
        youngs_modulus = 3651230789.769234
        poissons_ratio = 0.25857404271360035
        yield_strength = 2678116.9106851066
        rate = { cowper_symonds = { rate = 879409.7449669742, exponent = 3.3183199218482073 }, tested_at = 0.001 }
        radius = 5.616105103704115e-07
        [law]
        plm = { unloading_exponent = 1.3761732161115219 }
    ";
    let speeds = [
        1.512_691_419_151_420_4e-05,
        1.292_521_398_928_124_6e-05,
        2.641_722_857_972_204e-05,
        1.590_310_141_457_172e-05,
    ];
    let impacts = series(small, &speeds);
    turn_in_the_old_dent(&impacts[..2], 1);
    turn_in_the_old_dent(&impacts, 3);
    assert!(impacts[3].row.restitution == 1.0 && impacts[2].row.restitution < 1.0);
}

/// On a plate the dent stays too, and e is that of the branch.
#[test]
fn slower_impact_on_plate_keeps_dent() {
    let plate = r#"
        [sphere]
        radius = 0.0056072985118644034
        youngs_modulus = 109224331.33507206
        poissons_ratio = -0.2
        density = 6790.846883249364
        yield_strength = 1497865.3242291461
        rate = { johnson_cook = { c = 0.0023338127023028957, reference = 1.0 }, tested_at = 0.001 }
        [half_space]
        youngs_modulus = 265948114.15400252
        poissons_ratio = 0.0
        yield_strength = 754198.4839450017
        flow_stress = { power = { exponent = 0.2612492042793711 } }
        rate = { johnson_cook = { c = 0.0023338127023028957, reference = 1.0 }, tested_at = 0.001 }
        density = 172.99260614261908
        thickness = 0.05820951536372766
        [law]
        plm = { unloading_exponent = "pressure-shape" }
    "#;
    let speeds = [
        0.001_407_951_268_570_883,
        0.004_807_113_472_066_758,
        0.000_908_980_476_779_836_2,
        0.004_633_367_484_938_759_5,
    ];
    let impacts = series(plate, &[&speeds[..], &[0.002_817_033_316_231_018_4]].concat());
    turn_in_the_old_dent(&impacts, 2);
    assert!(impacts.iter().all(|impact| impact.row.restitution < 0.994));
}

/// An impact that yields but leaves no residual indentation leaves the surface fresh.
#[test]
fn peak_without_residual_indentation_is_no_dent() {
    let nylon_on_copper = r#"
        [sphere]
        radius = "10 mm"
        youngs_modulus = "3 GPa"
        poissons_ratio = 0.38
        density = "1150 kg/m^3"
        [half_space]
        youngs_modulus = "115 GPa"
        poissons_ratio = 0.34
        yield_strength = "60 MPa"
        rate = { johnson_cook = { c = 0.025 } }
    "#;
    let impacts = series(nylon_on_copper, &[1.0, 1.0, 3.0]);
    assert!(impacts[0].row.strain_rate_result.is_some_and(|rated| rated.factor > 1.0));
    for impact in &impacts[..2] {
        assert_eq!((impact.row.restitution, impact.row.residual_indentation), (1.0, 0.0));
    }
    // both are the impact on fresh surface, and so is a faster one that leaves a dent
    assert_eq!(impacts[0].row, impacts[1].row);
    let fresh = series(nylon_on_copper, &[3.0]);
    assert_eq!(impacts[2].row, fresh[0].row);
}

/// Along the unloading branch of a metal that relaxes, stiffness is the slope of the force and the stored energy is its integral. The
/// memory is that of loading, and the dent is deeper.
#[test]
fn stiffness_and_energy_of_relaxed_dent_follow_force() {
    let rated = ["half_space.rate.johnson_cook.c=0.03", "law.plm.unloading_exponent=pressure-shape"];
    let contact = contact(crate::common::STEEL, &rated).at_speed(3.0).unwrap().into_owned();
    let (deepest, n) = (30e-6, 20_000_u32);
    let mut memory = Memory::default();
    contact.force(deepest, &mut memory);
    let force = |indentation: f64| contact.force(indentation, &mut { memory });
    let step = deepest / f64::from(n);
    // from just below the peak, where the force drops, down
    let indentations = (0..n).map(|i| deepest * (1.0 - 1e-12) - f64::from(i) * step);
    let forces: Vec<f64> = indentations.clone().map(force).collect();
    let work: f64 = forces.windows(2).map(|pair| 0.5 * (pair[0] + pair[1]) * step).sum();
    let stored = contact.energy(deepest, memory.force, &memory).stored;
    assert!(relative_error(stored, work) < 1e-6, "{stored} {work}");
    let at = deepest - 1e-6;
    let slope = (force(at + 1e-9) - force(at - 1e-9)) / 2e-9;
    assert!(relative_error(contact.stiffness(at, &memory), slope) < 1e-6);
    assert!(force(deepest * (1.0 - 1e-12)) < 0.999 * memory.force, "the metal does not relax");
}

/// On a plate the momentum of the ball stays where the loading continues behind an old dent: the impulse of the force is the change of
/// the momentum.
#[test]
fn plate_keeps_momentum_behind_old_dent() {
    let keys = [
        "half_space.density=7850",
        "half_space.thickness=3 mm",
        "half_space.rate.cowper_symonds.rate=6844",
        "half_space.rate.cowper_symonds.exponent=3.91",
    ];
    let contact = contact(crate::common::STEEL, &keys);
    for slow in [0.1, 1.0] {
        let mut spot = Spot::new();
        let mut shot =
            |speed: f64| contact.impact_on(&mut spot, speed, &solver(Method::Rk8, 1e-11), Some(4001)).unwrap();
        let (first, again) = (shot(slow), shot(3.0));
        assert!(again.row.residual_indentation > 1.5 * first.row.residual_indentation);
        let impulse = impulse(&again.trace);
        let momentum = contact.mass() * (1.0 + again.row.restitution) * 3.0;
        assert!(relative_error(impulse, momentum) < 1e-6, "{impulse} {momentum}");
        assert!(again.energy.balance_error < 1e-9, "{}", again.energy.balance_error);
    }
}

/// A fast impact in a shallow dent of a slow one follows the branch beyond its old peak, until it meets the loading curve of its own
/// strength. This curve is Hertz there: K_e d^1.5 = K (x_r + d)^1.5, and K goes with the root of the radius.
#[test]
fn old_branch_meets_far_stronger_loading() {
    let keys = ["half_space.rate.cowper_symonds.rate=40", "half_space.rate.cowper_symonds.exponent=2"];
    let contact = contact(crate::common::STEEL, &keys);
    for (slow, fast) in [(0.1, 3.0), (0.2, 10.0)] {
        let mut spot = Spot::new();
        let mut shot =
            |speed: f64| contact.impact_on(&mut spot, speed, &solver(Method::Rk8, 1e-11), Some(20_001)).unwrap();
        let (first, again) = (shot(slow), shot(fast));
        let stiffer = (first.unloading_radius / contact.pair().radius).cbrt();
        let meets = first.row.residual_indentation * stiffer / (stiffer - 1.0);
        let on_branch = again.trace.iter().filter(|row| row.branch == Branch::Reloading);
        let got = on_branch.map(|row| row.indentation).fold(0.0, f64::max);
        assert!(got > 1.1 * first.row.peak_indentation && relative_error(got, meets) < 1e-13, "{slow}: {got} {meets}");
    }
}

/// On a plate the impulse of the force is the change of the momentum, and the energy stays, where the branch of a much faster impact ends
/// above the loading curve of a slower, heavier sphere, and the force drops.
#[test]
fn plate_keeps_momentum_where_force_drops() {
    let keys = [
        "half_space.density=7850",
        "half_space.thickness=40 mm",
        "half_space.rate.cowper_symonds.rate=40",
        "half_space.rate.cowper_symonds.exponent=2",
    ];
    let light = contact(crate::common::STEEL, &keys);
    let heavy = contact(crate::common::STEEL, &[&keys[..], &["sphere.density=7.85e7"]].concat());
    let mut spot = Spot::new();
    let first = light.impact_on(&mut spot, 10.0, &solver(Method::Rk8, 1e-11), None).unwrap();
    let again = heavy.impact_on(&mut spot, 0.1, &solver(Method::Rk8, 1e-11), Some(10_001)).unwrap();
    assert!(again.row.residual_indentation > 1.5 * first.row.residual_indentation);
    let ends = |two: &&[TraceRow]| two[0].branch == Branch::Reloading && two[1].branch == Branch::Plastic;
    let [end, start] = again.trace.windows(2).find(ends).unwrap() else { panic!() };
    assert!(start.force < 0.8 * end.force, "{} {}", start.force, end.force);
    let impulse = impulse(&again.trace);
    let momentum = heavy.mass() * (0.1 + again.rebound_speed);
    assert!(relative_error(impulse, momentum) < 1e-4, "{impulse} {momentum}");
    assert!(again.energy.balance_error < 1e-9, "{}", again.energy.balance_error);
}
