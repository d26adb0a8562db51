//! Gravity and damping: energy balances, closed forms, and hard cases.

mod at_rest;
mod creep;
mod error_control;
pub mod oracle;
mod peak_force;

use crate::common::prelude::*;
use plm_impact::numerics::integrate::Drag;

const GRAVITY: f64 = 9.81;

fn gravity(acceleration: f64) -> Forces {
    Forces { gravity: Some(acceleration), ..Forces::default() }
}

fn hunt_crossley(chi: f64) -> Forces {
    Forces { damping: Some(Damping::HuntCrossley(chi)), ..Forces::default() }
}

/// Damping of Hunt and Crossley with this χ in units of 1/V.
fn damped(chi: f64) -> ScaledForces {
    ScaledForces { drag: Drag { chi, ..Drag::NONE }, ..ScaledForces::NONE }
}

fn viscous(zeta: f64) -> Forces {
    Forces { damping: Some(Damping::Viscous(zeta)), ..Forces::default() }
}

fn under(scene: &Scene, forces: Forces) -> Contact {
    scene.contact().with_forces(forces)
}

fn elastic() -> Scene {
    Scene { yield_strength: None, ..Scene::steel() }
}

fn fate(impact: &Impact) -> Fate {
    impact.under_forces.unwrap().fate
}

#[test]
fn gravity_alone_keeps_the_balance_of_energy() {
    // ½ m v² + m g δ_m = W(δ_m) and ½ m (e v)² = F_m δ_e/(n + 1) − m g δ_e, with W of the law in units of its yield
    // point
    let law = Scene::steel().law();
    let scales = *Scene::steel().contact().pair();
    let point = scales.yield_point.unwrap();
    for (g, speed) in [(9.81, 3.0), (9.81, 0.02), (1e4, 0.1), (1e6, 5.0)] {
        let contact = under(&Scene::steel(), gravity(g));
        let impact = contact.closed_form(speed).unwrap();
        let mass = contact.mass();
        let work = law.loading.work(impact.peak_indentation / point.indentation) * point.force * point.indentation;
        let put_in = 0.5 * mass * speed * speed + mass * g * impact.peak_indentation;
        assert!(off(work, put_in) < 1e-13, "{g} {speed}: {work} {put_in}");
        let back = impact.peak_force * impact.elastic_approach / 2.5 - mass * g * impact.elastic_approach;
        let rebound = 0.5 * mass * impact.rebound_speed * impact.rebound_speed;
        assert!((rebound - back.max(0.0)).abs() < 1e-12 * put_in, "{g} {speed}: {rebound} {back}");
        let rk8 = contact.impact(speed, &solver(Method::Rk8, 1e-12), None).unwrap();
        assert!(off(rk8.under_forces.unwrap().end_time, impact.under_forces.unwrap().end_time) < 1e-11);
        assert!(off(rk8.loading_time, impact.loading_time) < 1e-11 && rk8.energy.drift < 1e-11);
    }
}

#[test]
fn a_sphere_let_go_at_first_touch_sinks_twice_and_a_half_as_deep_as_its_weight_alone() {
    // elastic: (2/5) F δ = m g δ at the peak, so F_m = 2.5 m g; without loss the sphere oscillates for ever
    for forces in [gravity(GRAVITY), gravity(1e-6), gravity(1e3)] {
        let contact = under(&elastic(), forces);
        let weight = contact.mass() * forces.gravity.unwrap();
        let exact = contact.closed_form(0.0).unwrap();
        assert!(off(exact.peak_force, 2.5 * weight) < 1e-14);
        // static: F = m g
        let at_rest = exact.under_forces.unwrap().static_indentation.unwrap();
        assert!(off(exact.peak_indentation / at_rest, 2.5_f64.powf(2.0 / 3.0)) < 1e-14);
        for (method, factor) in STEPPING {
            let impact = contact.impact(0.0, &solver(method, 1e-10), Some(20)).unwrap();
            assert_eq!((fate(&impact), impact.restitution), (Fate::Captured, 0.0));
            assert!(impact.contact_time.is_infinite());
            assert!(off(impact.peak_force, exact.peak_force) < factor * 1e-10, "{}", method.name());
            assert!(off(impact.loading_time, exact.loading_time) < factor * 1e-10, "{}", method.name());
            let last = impact.trace.last().unwrap();
            assert_eq!(last.event, Some(Event::Captured));
            assert!(off(last.force, weight) < 1e-12 && off(last.indentation, at_rest) < 1e-12);
            assert!(impact.trace[0].speed == 0.0 && impact.energy.drift <= factor * 1e-10);
        }
    }
}

#[test]
fn a_sphere_almost_at_rest_at_first_touch_sinks_at_any_tolerance() {
    for scene in [elastic(), Scene { yield_strength: Some(1e6), ..Scene::steel() }] {
        let contact = under(&scene, gravity(GRAVITY));
        let from_rest = contact.closed_form(0.0).unwrap();
        // drop heights far below the peak indentation of the fall from 0: gravity does all of the work
        for part in [0.0, 1e-30, 1e-24, 1e-18, 1e-12] {
            let speed = (2.0 * GRAVITY * part * from_rest.peak_indentation).sqrt();
            let exact = contact.closed_form(speed).unwrap();
            assert!(off(exact.peak_force, from_rest.peak_force) < 1e-11);
            for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
                for (method, factor) in STEPPING {
                    for samples in [None, Some(20)] {
                        let impact = contact.impact(speed, &solver(method, tolerance), samples).unwrap();
                        let error = off(impact.peak_force, exact.peak_force);
                        assert!(error < factor * tolerance, "{} {tolerance:e} {part:e}: {error:e}", method.name());
                    }
                }
            }
        }
    }
}

#[test]
fn drops_from_below_the_static_indentation_are_computed() {
    // drop heights of a thousandth and a millionth of the static indentation: gravity does nearly all of the work
    let contact = under(&elastic(), gravity(GRAVITY));
    let at_rest = contact.closed_form(0.0).unwrap().under_forces.unwrap().static_indentation.unwrap();
    for part in [1e-3, 1e-6] {
        let speed = (2.0 * GRAVITY * part * at_rest).sqrt();
        let exact = contact.closed_form(speed).unwrap();
        assert_eq!((fate(&exact), exact.restitution), (Fate::Separated, 1.0), "elastic: as high as it came from");
        for (method, factor) in STEPPING {
            let impact = contact.impact(speed, &solver(method, 1e-12), None).unwrap();
            assert!(off(impact.contact_time, exact.contact_time) < factor * 1e-11, "{}", method.name());
            // the energy of the rebound is a small difference of large works, so errors grow by their ratio
            assert!(off(impact.restitution, 1.0) < factor * 1e-12 * 10.0 / part, "{}", method.name());
        }
        // on a soft half-space with a dent the sphere is captured
        let soft = Scene { yield_strength: Some(1e6), ..Scene::steel() };
        let impact = under(&soft, gravity(GRAVITY)).impact(speed, &Solver::default(), Some(20)).unwrap();
        assert_eq!(fate(&impact), Fate::Captured);
    }
}

#[test]
fn capture_begins_where_the_peak_force_is_five_halves_of_the_weight() {
    let law = Scene::steel().law();
    // exactly at the limit: captured
    let unloading = law.unloading(law.loaded_to(20.0));
    let at = |weight: f64| ScaledForces { weight, ..ScaledForces::NONE }.captures(&unloading, 1.0);
    let limit = unloading.peak.force / 2.5;
    assert!(at(limit) && at(limit * (1.0 + 1e-15)) && !at(limit * (1.0 - 1e-15)));
    // the speed at which a whole impact reaches this limit, approached from both sides
    let contact = under(&Scene::steel(), gravity(1e6));
    let weight = contact.mass() * 1e6;
    let captured = |speed: f64| fate(&contact.closed_form(speed).unwrap()) == Fate::Captured;
    let (mut slow, mut fast) = (1e-3, 100.0_f64);
    assert!(captured(slow) && !captured(fast));
    while fast - slow > 1e-15 * fast {
        let middle = 0.5 * (slow + fast);
        if middle == slow || middle == fast {
            break;
        }
        if captured(middle) { slow = middle } else { fast = middle }
    }
    let (last, first) = (contact.closed_form(slow).unwrap(), contact.closed_form(fast).unwrap());
    assert!(last.peak_force <= 2.5 * weight * (1.0 + 1e-14) && off(first.peak_force, 2.5 * weight) < 1e-12);
    assert!(first.restitution < 1e-5 && last.restitution == 0.0);
    for speed in [slow, fast] {
        for (method, _) in STEPPING {
            let impact = contact.impact(speed, &solver(method, 1e-10), Some(20)).unwrap();
            // the rebound speed is the square root of a difference of 1e-10
            assert!(impact.restitution < 1e-3, "{} {}", method.name(), impact.restitution);
            assert!(impact.trace.last().unwrap().time.is_finite());
        }
    }
}

#[test]
fn hunt_crossley_restitution_falls_by_two_thirds_of_chi_v() {
    // Hunt and Crossley (1975), J. Appl. Mech. 42, 440-445: e = 1 − α v and damping (3/2) α of the force, so χ = (3/2)
    // α, to first order in χ v; the next term of G(−e v) = G(v) is + (4/9) (χ v)²
    let contact = |chi| under(&elastic(), hunt_crossley(chi));
    for chi_v in [1e-6, 1e-4, 1e-3, 1e-2] {
        let (chi, speed) = (0.1, chi_v / 0.1);
        let contact = contact(chi);
        let (scales, law, q) = contact.scaled(speed).unwrap();
        let exact = oracle::solve(law, q, &damped(chi * scales.speed));
        let third = exact.restitution - (1.0 - 2.0 / 3.0 * chi_v + 4.0 / 9.0 * chi_v * chi_v);
        assert!(third.abs() < 0.5 * chi_v.powi(3) + 1e-15, "{chi_v}: {third:e}");
        for (method, factor) in STEPPING {
            let impact = contact.impact(speed, &solver(method, 1e-10), None).unwrap();
            assert!(off(impact.restitution, exact.restitution) < factor * 1e-10);
            assert!(off(impact.contact_time, exact.contact_time * scales.time()) < factor * 1e-10);
        }
    }
    // the force never pulls, even with strong damping
    let impact = contact(100.0).impact(10.0, &Solver::default(), Some(100)).unwrap();
    assert!(impact.restitution > 0.0);
    // G(−e v) = G(v) with χ v = 1000: e χ v + ln(1 − e χ v) = ln 1001 − 1000, so e χ v = 1 − e^(−992…)
    assert!(off(impact.restitution, 1e-3) < 1e-9);
    assert!(impact.trace.iter().all(|row| row.force >= 0.0));
}

#[test]
fn strong_hunt_crossley_damping_leaves_one_over_chi_of_speed() {
    // on the way out 1 + χ δ' > 0 keeps the speed below 1/χ; for χ v ≫ 1 the contact ends at this speed, up to exp(−χ²
    // G)
    for chi in [30.0, 100.0, 1e3, 1e4] {
        let contact = under(&Scene::steel(), hunt_crossley(chi));
        let (scales, law, q) = contact.scaled(3.0).unwrap();
        let exact = oracle::solve(law, q, &damped(chi * scales.speed));
        let rebound = exact.restitution * 3.0;
        assert!(off(rebound, 1.0 / chi) < 1e-9, "{chi}: {rebound}");
        let stepped = contact.impact(3.0, &solver(Method::Rk8, 1e-12), None).unwrap();
        assert!(off(stepped.rebound_speed, 1.0 / chi) < 1e-9 && fate(&stepped) == Fate::Separated);
        let (got, want) = (stepped.contact_time, exact.contact_time * scales.time());
        assert!(off(got, want) < 1e-7, "{chi}: {got} {want}");
    }
}

#[test]
fn viscous_damping_of_a_hertz_contact_does_not_know_the_speed() {
    // Tsuji, Tanaka and Ishida (1992), Powder Technol. 71, 239-250, chose δ^¼ so that e does not depend on the speed
    for zeta in [0.01, 0.1, 0.5, 0.9, 1.0, 3.0] {
        let at = |speed| under(&elastic(), viscous(zeta)).impact(speed, &solver(Method::Rk8, 1e-11), None).unwrap();
        let (slow, fast) = (at(1e-3), at(10.0));
        assert!(off(slow.restitution, fast.restitution) < 1e-9, "{zeta}");
        // contact time as v^(−1/5)
        assert!(off(slow.contact_time / fast.contact_time, 1e4_f64.powf(0.2)) < 1e-9);
    }
}

#[test]
fn an_overdamped_contact_without_gravity_lets_go_and_with_gravity_creeps_to_rest() {
    let scene = Scene::steel();
    for zeta in [1.0, 2.0, 20.0] {
        // on the way back the sphere would slow down only under a pulling force, and there is none
        let impact = under(&scene, viscous(zeta)).impact(3.0, &Solver::default(), None).unwrap();
        assert!(fate(&impact) == Fate::Separated && impact.restitution > 0.0 && impact.restitution < 0.1);
        let both = Forces { gravity: Some(1e6), ..viscous(zeta) };
        for speed in [0.0, 1e-3, 0.1] {
            let mut times = Vec::new();
            for (method, _) in STEPPING {
                let impact = under(&scene, both).impact(speed, &solver(method, 1e-9), Some(40)).unwrap();
                let report = impact.under_forces.unwrap();
                assert_eq!((report.fate, impact.restitution), (Fate::Captured, 0.0));
                let at_rest = report.static_indentation.unwrap();
                // the end is within a thousandth of the static indentation, or at an earlier turning point
                let distance = (report.end_indentation / at_rest - 1.0).abs();
                assert!(distance < 1.1e-3, "{zeta} {speed}: {distance}");
                assert_eq!(impact.trace.last().unwrap().event, Some(Event::Captured));
                assert!(impact.energy.drift < 1e-7, "{}", impact.energy.drift);
                times.push(report.end_time);
            }
            assert!(off(times[0], times[1]) < 1e-6 && off(times[0], times[2]) < 1e-6, "{zeta} {speed} {times:?}");
        }
    }
}

#[test]
fn a_damped_sphere_that_turns_back_is_captured() {
    let both = Forces { gravity: Some(GRAVITY), ..viscous(0.2) };
    for (method, _) in STEPPING {
        let impact = under(&elastic(), both).impact(1e-5, &solver(method, 1e-10), Some(30)).unwrap();
        let last = impact.trace.last().unwrap();
        assert_eq!((fate(&impact), last.event, last.speed), (Fate::Captured, Some(Event::Captured), 0.0));
        let weight = under(&elastic(), both).mass() * GRAVITY;
        assert!(last.force < weight && last.force > 0.0);
    }
}

#[test]
fn methods_without_steps_say_where_they_end() {
    let closed = Solver { method: Method::ClosedForm, ..Solver::default() };
    let contact = under(&Scene::steel(), viscous(0.1));
    assert_eq!(contact.impact(3.0, &closed, None), Err(ImpactError::NoClosedForm));
    assert_eq!(contact.closed_form(3.0), Err(ImpactError::NoClosedForm));
    assert!(matches!(contact.closed_form(1e200), Err(ImpactError::Range(_))));
    let auto = Solver::AUTO;
    let method = |forces, samples| under(&Scene::steel(), forces).impact(3.0, &auto, samples).unwrap().method;
    assert_eq!(method(gravity(GRAVITY), None), Method::ClosedForm);
    assert_eq!(method(gravity(GRAVITY), Some(10)), Method::Rk8);
    assert_eq!(method(viscous(0.1), None), Method::Rk8);
}

/// Strong damping of Hunt and Crossley lets the sphere out at 1/χ, where F (1 + χ δ') is zero but for rounding. The contact ends
/// at the dent all the same: once it ended up to seven times too early.
#[test]
fn fixed_steps_follow_a_strongly_damped_sphere_to_the_dent() {
    for speed in [7.0, 15.0, 30.0] {
        for scene in [Scene::steel(), Scene { yield_strength: Some(900e6), ..Scene::steel() }] {
            let contact = under(&scene, hunt_crossley(10.0));
            let exact = contact.impact(speed, &solver(Method::Rk8, 1e-10), None).unwrap();
            let error = |steps_per_contact| {
                let verlet = Solver { method: Method::Verlet, steps_per_contact, ..Solver::default() };
                off(contact.impact(speed, &verlet, None).unwrap().contact_time, exact.contact_time)
            };
            assert!(error(50) < 0.15 && error(5000) < 0.01, "{speed} {} {}", error(50), error(5000));
        }
    }
}

/// Under gravity `auto` is as exact as the energy and costs what rk8 does: the rebound is that of the balance of energy, the
/// times are those of a run by rk8.
#[test]
fn auto_has_the_times_of_rk8_under_gravity_and_a_rebound_without_its_error() {
    let contact = under(&Scene::steel(), gravity(1e4));
    let [auto, stepped] = [Method::Auto, Method::Rk8].map(|method| contact.row(0.5, &solver(method, 1e-5)).unwrap());
    assert_eq!(auto.contact_time, stepped.contact_time);
    assert_eq!(auto.restitution, contact.closed_form(0.5).unwrap().restitution);
    assert!(auto.restitution != stepped.restitution && off(stepped.restitution, auto.restitution) < 1e-4);
}

#[test]
fn verlet_comes_nearer_with_more_steps() {
    for forces in [gravity(1e4), hunt_crossley(0.1), viscous(0.1)] {
        let contact = under(&Scene::steel(), forces);
        let exact = contact.impact(0.5, &solver(Method::Rk8, 1e-12), None).unwrap();
        let error = |steps_per_contact| {
            let verlet = Solver { method: Method::Verlet, steps_per_contact, ..Solver::default() };
            off(contact.impact(0.5, &verlet, None).unwrap().restitution, exact.restitution)
        };
        // first order at the kinks and at the end of a contact
        assert!(error(20_000) < 1e-3 && error(20_000) < 0.2 * error(200), "{} {}", error(200), error(20_000));
    }
}
