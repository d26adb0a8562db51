//! Every law under gravity and damping, with its own unloading branch, first yield and elastic regime.

use super::whole_laws;
use crate::common::prelude::*;

const NOTHING: Damping = Damping::Viscous(0.0);

fn under(scene: &Scene, law: &LawChoice, gravity: Option<f64>, damping: Option<Damping>) -> Contact {
    scene.contact_by(law.get()).with_forces(Forces { gravity, damping, ..Forces::default() })
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

/// All laws, also with yield points below and above that of C_ν.
fn laws() -> Vec<(String, LawChoice)> {
    let mut laws = whole_laws();
    for pressure in [300e6, 900e6] {
        laws.push((format!("thornton {pressure}"), LawChoice::Thornton(Thornton { yield_pressure: Some(pressure) })));
    }
    for ratio in [1.1, 3.0] {
        let law = Stronge { yield_pressure_ratio: ratio, ..Stronge::default() };
        laws.push((format!("stronge {ratio}"), LawChoice::Stronge(law)));
    }
    laws
}

#[test]
fn damping_of_nothing_changes_no_law_at_any_speed() {
    for (name, choice) in laws() {
        let mut compared = 0;
        let plain = Scene::case_3().contact_by(choice.get());
        for (damping, share) in [NOTHING, Damping::HuntCrossley(0.0)]
            .into_iter()
            .flat_map(|damping| [1e-3, 0.1, 0.5, 0.9, 1.1, 3.0, 50.0].map(|share| (damping, share)))
        {
            let none = under(&Scene::case_3(), &choice, None, Some(damping));
            let speed = share * unit_speed(&plain);
            match (plain.closed_form(speed), none.impact(speed, &solver(Method::Rk8, 1e-12), None)) {
                (Ok(want), Ok(got)) => {
                    assert!(off(got.restitution, want.restitution) < 1e-10, "{name} at {share}: {}", got.restitution);
                    assert!(off(got.peak_force, want.peak_force) < 1e-10, "{name} at {share}");
                    assert!(off(got.contact_time, want.contact_time) < 1e-10, "{name} at {share}");
                    assert_eq!(got.has_dent(), want.has_dent(), "{name} at {share}");
                    assert_eq!(got.under_forces.unwrap().damping_loss, Some(0.0), "{name} at {share}");
                    compared += 1;
                }
                (Err(_), Err(_)) => {}
                (want, got) => panic!("{name} at {share}: {:?} but {:?}", want.err(), got.err()),
            }
        }
        assert!(compared >= 1, "{name}: {compared} of 14 impacts");
    }
}

#[test]
fn a_law_without_an_elastic_regime_loses_as_much_below_first_yield() {
    // Walton and Braun: loading with k_1 and unloading with k_1/0.36, so e = 0.6 at every speed; a damping of 1e-9
    // takes nothing
    let law = LawChoice::WaltonBraun(WaltonBraun { stiffness_ratio: 0.36, ..Default::default() });
    let scene = Scene::case_3();
    let weight = gravity_of(&scene, 1e-9);
    for (gravity, damping) in
        [(None, Some(Damping::Viscous(1e-9))), (Some(weight), None), (Some(weight), Some(NOTHING))]
    {
        let contact = under(&scene, &law, gravity, damping);
        for share in [0.05, 0.5, 0.99] {
            let speed = share * unit_speed(&contact);
            let impact = contact.impact(speed, &solver(Method::Rk8, 1e-12), None).unwrap();
            assert!(off(impact.restitution, 0.6) < 1e-6, "{share}: {}", impact.restitution);
            let mut spot = Spot::fresh();
            let _ = contact.impact_on(&mut spot, speed, &solver(Method::Rk8, 1e-10), None).unwrap();
            assert!(spot.memory().is_some(), "the dent of a slow impact is remembered");
        }
    }
}

#[test]
fn traces_under_forces_tell_of_yield_and_knots_where_each_law_has_them() {
    let scene = Scene::case_3();
    let late = LawChoice::Thornton(Thornton { yield_pressure: Some(2e9) });
    let forces = [
        (Some(9.81), None),
        (None, Some(Damping::Viscous(0.05))),
        (Some(9.81), Some(Damping::HuntCrossley(0.1))),
        (None, Some(Damping::HuntCrossley(1e-3))),
        (None, Some(Damping::Viscous(1e-3))),
    ];
    let told = |contact: &Contact, speed: f64, method: Method| {
        let trace = contact.impact(speed, &solver(method, 1e-10), Some(20))?.trace;
        let on_curve = |event: &Event| matches!(event, Event::Yield | Event::Knot);
        let rows = trace.iter().filter_map(|row| Some((row.event.filter(on_curve)?, row.indentation)));
        Ok::<_, ImpactError>(rows.collect::<Vec<(Event, f64)>>())
    };
    let mut compared = 0;
    for (name, choice) in laws().into_iter().chain([("thornton, late".to_owned(), late)]) {
        let plain = scene.contact_by(choice.get());
        // near the yield speeds of the laws, far beyond, and beyond the ranges that any of these laws refuses
        for speed in [0.025, 1.0, 5.0] {
            let Ok(want) = told(&plain, speed, Method::Rk8) else { continue };
            let yields: Vec<f64> = want.iter().filter(|(event, _)| *event == Event::Yield).map(|(_, at)| *at).collect();
            let until = plain.yields_at().map(|(indentation, _)| indentation);
            assert!(yields.len() == usize::from(until.is_some()) || speed < 1.0, "{name}: {yields:?}");
            assert!(
                yields.iter().zip(until).all(|(at, until)| off(*at, until) < 1e-12),
                "{name}: {yields:?} {until:?}"
            );
            for ((gravity, damping), (method, _)) in
                forces.iter().flat_map(|forces| STEPPING.map(|method| (forces, method)))
            {
                // strong damping may end a slow impact before the knots of the plain one
                if speed < 5.0 && damping.is_some() && *damping != forces[3].1 {
                    continue;
                }
                let got = told(&under(&scene, &choice, *gravity, *damping), speed, method);
                let got = got.unwrap_or_else(|error| panic!("{name} by {method:?} under {damping:?}: {error}"));
                let is_whole = *damping == forces[3].1 || damping.is_none();
                assert!(!is_whole || got.len() == want.len(), "{name} by {method:?}: {got:?} {want:?}");
                for ((event, at), (wanted, place)) in got.iter().zip(&want) {
                    assert!(event == wanted && off(*at, *place) < 1e-12, "{name} by {method:?}: {event:?} at {at}");
                }
                assert!(got.iter().any(|(event, _)| *event == Event::Yield) || yields.is_empty(), "{name} {method:?}");
            }
            compared += 1;
        }
    }
    assert!(compared >= 60, "{compared} traces");
}

/// The force at δ during unloading, from the peak and the dent of an impact, by the printed formula of each law.
fn printed_force(name: &str, impact: &Impact, indentation: f64) -> f64 {
    let (deepest, residual) = (impact.peak_indentation, impact.residual_indentation);
    if name.contains("mesarovic") {
        // F = (2 F_m/π)(θ − sin θ cos θ), 1 − cos θ = (δ − δ_r)/(δ_m − δ_r)
        let cosine = 1.0 - (indentation - residual) / (deepest - residual);
        let angle = cosine.acos();
        impact.force_at_peak_indentation * std::f64::consts::FRAC_2_PI * (angle - angle.sin() * cosine)
    } else {
        let hertz = |x: f64| x.powf(1.5) - residual.powf(1.5);
        impact.force_at_peak_indentation * hertz(indentation) / hertz(deepest)
    }
}

const NO_POWERS: [&str; 4] =
    ["mesarovic_johnson", "yigit_christoforou", "kogut_etsion + mesarovic_johnson", "thornton + yigit_christoforou"];

#[test]
fn rows_of_a_damped_trace_lie_on_branches_that_are_no_powers() {
    for name in NO_POWERS {
        for damping in [Damping::HuntCrossley(0.05), Damping::Viscous(0.02)] {
            let contact = under(&Scene::case_3(), &by_name(name), Some(9.81), Some(damping));
            for (method, _) in STEPPING {
                let impact = contact.impact(5.0, &solver(method, 1e-10), Some(200)).unwrap();
                let back = impact.trace.iter().filter(|row| row.branch.name() == "unloading");
                assert!(back.clone().count() > 10);
                for row in back {
                    let want = printed_force(name, &impact, row.indentation.max(impact.residual_indentation));
                    let miss = (row.elastic_force.unwrap() - want).abs();
                    // the last rows have fewer digits, because δ − δ_r is small
                    assert!(miss < 1e-7 * impact.peak_force, "{name}, {method:?}: {row:?} {want}");
                }
            }
        }
    }
}

#[test]
fn a_captured_sphere_rests_where_its_own_branch_carries_the_weight() {
    for name in NO_POWERS {
        let scene = Scene::case_3();
        // the weight is 2000 F_Y, so an impact at 1 m/s cannot leave the dent
        let contact = under(&scene, &by_name(name), Some(gravity_of(&scene, 2000.0)), None);
        let impact = contact.impact(1.0, &solver(Method::Rk8, 1e-12), Some(20)).unwrap();
        let report = *impact.captured().unwrap();
        let weight = contact.mass() * contact.forces().gravity.unwrap();
        let carried = printed_force(name, &impact, report.static_indentation.unwrap());
        assert!(off(carried, weight) < 1e-9, "{name}: {carried} {weight}");
        // the run ends there
        let last = impact.trace.last().unwrap();
        assert!(off(last.force, weight) < 1e-9 && last.event == Some(Event::Captured), "{name}: {last:?}");
    }
}

#[test]
fn energy_that_leaves_no_dent_is_accounted_for() {
    // loading is linear. A = f/ε is above that of the PLM, so unloading has no dent and follows Hertz: ½ F δ is spent
    // and (2/5) F δ is recovered, so e² = 4/5
    let scene = Scene::case_3();
    for name in ["johnson + plm", "mesarovic_johnson + plm"] {
        let plain = scene.contact_by(by_name(name).get());
        let speed = 4.0 * unit_speed(&plain);
        let weight = gravity_of(&scene, 1e-6);
        for contact in [plain.clone(), plain.with_forces(Forces { gravity: Some(weight), ..Forces::default() })] {
            for (method, factor) in STEPPING.into_iter().chain([(Method::ClosedForm, 1.0)]) {
                let impact = contact.impact(speed, &solver(method, 1e-11), None).unwrap();
                assert!(off(impact.restitution.powi(2), 0.8) < 1e-6, "{name} {method:?}: {}", impact.restitution);
                let energy = impact.energy;
                let sum = energy.recovered + energy.plastic.unwrap();
                // without a dent the work of gravity is zero in the end
                assert!(off(sum, energy.kinetic_in) < 2.0 * factor * 1e-11 + 1e-12, "{name} {method:?}: {energy:?}");
                assert!(energy.drift < factor * 1e-11 + 1e-12, "{name} {method:?}: {energy:?}");
            }
        }
    }
}

#[test]
fn energy_gained_is_said_under_forces_and_only_where_the_law_gains_it() {
    let gains = |impact: &Impact| impact.warnings.iter().any(|warning| warning.kind == WarningKind::EnergyGain);
    // just above first yield an exponent of 1.4 would give back more than is spent, and a damping of 0.1 % takes less than
    // that
    let exponent = UnloadingExponent::Fixed(1.4);
    let contact = Scene { exponent, ..Scene::case_3() }.contact();
    let speed = 1.1 * contact.yield_speed().unwrap();
    for (gravity, damping) in [(None, Damping::Viscous(1e-3)), (Some(1e-6), Damping::HuntCrossley(1e-3 / speed))] {
        let damped = contact.clone().with_forces(Forces { gravity, damping: Some(damping), ..Forces::default() });
        let impact = damped.impact(speed, &solver(Method::Rk8, 1e-10), None).unwrap();
        assert!(impact.restitution < 1.0 && !gains(&impact), "{} {:?}", impact.restitution, impact.warnings);
    }
    // a second hit beyond a knot gains 1e-5 of e (as in `energy_gained_at_a_knot_is_said`), and damping takes less than
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
        let mut spot = Spot::fresh();
        let hit = |spot: &mut Spot| damped.impact_on(spot, speed, &solver(Method::Rk8, 1e-10), None).unwrap();
        assert!(!gains(&hit(&mut spot)));
        let second = hit(&mut spot);
        assert!(second.restitution > 1.0 && gains(&second), "{} {:?}", second.restitution, second.warnings);
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
    assert!(impact.restitution > 100.0 && impact.energy.plastic.unwrap() > 0.0, "{impact:?}");
    assert!(!gains(&impact), "{:?}", impact.warnings);
}

#[test]
fn the_fastest_impact_that_changes_nothing_is_that_of_the_law() {
    let mut compared = 0;
    for (name, choice) in laws() {
        let contact = Scene::case_3().contact_by(choice.get());
        let Some(yield_speed) = contact.yield_speed() else { continue };
        let (_, law, _) = contact.scaled(10.0 * yield_speed).unwrap();
        let memory = |share: f64| Law::loaded_to(law, share * law.limits.elastic_until);
        assert_eq!(Spot::loaded_to(&contact, memory(0.99)), Spot::fresh(), "{name}");
        assert_ne!(Spot::loaded_to(&contact, memory(1.5)), Spot::fresh(), "{name}");
        compared += 1;
    }
    assert!(compared >= 19, "{compared} laws");
}
