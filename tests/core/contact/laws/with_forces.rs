//! Every law under gravity and damping, with its own unloading branch, first yield and elastic regime.

use crate::common::prelude::*;

fn under(scene: &Scene, law: &LawChoice, gravity: Option<f64>, damping: Option<Damping>) -> Contact {
    scene.contact_by(law.as_contact_law()).with_forces(Forces { gravity, damping, ..Forces::default() })
}

fn by_name(name: &str) -> LawChoice {
    LawChoice::from_name(name).unwrap()
}

/// The yield speed v_Y by C_ν, which is the unit of speed for every law.
fn unit_speed(contact: &Contact) -> f64 {
    let point = contact.pair().yield_point.unwrap();
    (0.8 * point.force / contact.mass() * point.indentation).sqrt()
}

/// The gravity at which the weight of the sphere is `share` of F_Y.
fn gravity_of(scene: &Scene, share: f64) -> f64 {
    let contact = scene.contact();
    share * contact.pair().yield_point.unwrap().force / contact.mass()
}

#[test]
fn energy_that_leaves_no_dent_is_accounted_for() {
    // loading is linear. A = f/ε is above that of the PLM, so unloading has no dent and follows Hertz: ½ F δ is spent
    // and (2/5) F δ is recovered, so e² = 4/5
    let scene = Scene::case_3();
    for name in ["johnson + plm", "mesarovic_johnson + plm"] {
        let plain = scene.contact_by(by_name(name).as_contact_law());
        let speed = 4.0 * unit_speed(&plain);
        let weight = gravity_of(&scene, 1e-6);
        for contact in [plain.clone(), plain.with_forces(Forces { gravity: Some(weight), ..Forces::default() })] {
            for (method, factor) in STEPPING.into_iter().chain([(Method::ClosedForm, 1.0)]) {
                let impact = contact.impact(speed, &solver(method, 1e-11), None).unwrap();
                assert!(
                    relative_error(impact.row.restitution.powi(2), 0.8) < 1e-6,
                    "{name} {method:?}: {}",
                    impact.row.restitution
                );
                let energy = impact.energy;
                let sum = energy.recovered + energy.plastic.unwrap();
                // without a dent the work of gravity is zero in the end
                assert!(
                    relative_error(sum, energy.kinetic_in) < 2.0 * factor * 1e-11 + 1e-12,
                    "{name} {method:?}: {energy:?}"
                );
                assert!(energy.balance_error < factor * 1e-11 + 1e-12, "{name} {method:?}: {energy:?}");
            }
        }
    }
}

#[test]
fn energy_gain_under_forces_warns_only_when_gained() {
    let gains = |impact: &Impact| impact.warnings.iter().any(|warning| warning.kind == WarningKind::EnergyGain);
    // just above first yield an exponent of 1.4 would give back more than is spent, and a damping of 0.1 % takes less than
    // that
    let exponent = UnloadingExponent::Fixed(1.4);
    let contact = Scene { exponent, ..Scene::case_3() }.contact();
    let speed = 1.1 * contact.yield_speed().unwrap();
    for (gravity, damping) in [(None, Damping::Viscous(1e-3)), (Some(1e-6), Damping::HuntCrossley(1e-3 / speed))] {
        let damped = contact.clone().with_forces(Forces { gravity, damping: Some(damping), ..Forces::default() });
        let impact = damped.impact(speed, &solver(Method::Rk8, 1e-10), None).unwrap();
        assert!(impact.row.restitution < 1.0 && !gains(&impact), "{} {:?}", impact.row.restitution, impact.warnings);
    }
    // a second hit beyond a knot gains 1e-5 of e (as in `energy_gain_at_knot_warns`), and damping takes less than
    // that
    let soft = Scene {
        radius: 1.0,
        density: 5000.0,
        sphere: Material { youngs_modulus: 1.342e9, poissons_ratio: 0.0 },
        half_space: Material { youngs_modulus: 27.858e9, poissons_ratio: 0.0 },
        yield_strength: Some(7.76e6),
        ..Scene::case_3()
    };
    let speed = 1.945 * soft.yield_speed();
    for damping in [Damping::Viscous(1e-9), Damping::HuntCrossley(1e-9 / speed)] {
        let damped =
            soft.contact_by(&nine_pieces()).with_forces(Forces { damping: Some(damping), ..Forces::default() });
        let mut spot = Spot::new();
        let hit = |spot: &mut Spot| damped.impact_on(spot, speed, &solver(Method::Rk8, 1e-10), None).unwrap();
        assert!(!gains(&hit(&mut spot)));
        let second = hit(&mut spot);
        assert!(second.row.restitution > 1.0 && gains(&second), "{} {:?}", second.row.restitution, second.warnings);
    }
    // a heavy sphere that is slow at first touch falls into its own dent: it leaves faster than it came, although
    // energy is lost
    let body = |youngs_modulus, poissons_ratio| Material { youngs_modulus, poissons_ratio };
    let heavy = Scene {
        radius: 3.114e-6,
        density: 554.8,
        sphere: body(9.267e9, 0.358),
        half_space: body(6.682e9, 0.285),
        yield_strength: Some(19.53e6),
        ..Scene::case_3()
    };
    let contact = under(&heavy, &by_name("stronge + kogut_etsion"), Some(2.758e6), None);
    let impact = contact.impact(2.2e-3 * unit_speed(&contact), &solver(Method::Rk8, 1e-11), None).unwrap();
    assert!(impact.row.restitution > 100.0 && impact.energy.plastic.unwrap() > 0.0, "{impact:?}");
    assert!(!gains(&impact), "{:?}", impact.warnings);
}
