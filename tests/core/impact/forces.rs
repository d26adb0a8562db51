//! Gravity and damping: energy balances, closed forms, and hard cases.

mod at_rest;
mod creep;
mod error_control;
pub mod exact_solutions;
mod peak_force;

use crate::common::prelude::*;
use plm_impact::numerics::ode::DampingCoefficients;

const GRAVITY: f64 = 9.81;

fn gravity(acceleration: f64) -> Forces {
    Forces { gravity: Some(acceleration), ..Forces::default() }
}

fn hunt_crossley(chi: f64) -> Forces {
    Forces { damping: Some(Damping::HuntCrossley(chi)), ..Forces::default() }
}

/// Damping of Hunt and Crossley with this χ in units of 1/V.
pub fn damped(chi: f64) -> ScaledForces {
    ScaledForces {
        damping: DampingCoefficients { hunt_crossley: chi, ..DampingCoefficients::NONE },
        ..ScaledForces::NONE
    }
}

fn viscous(zeta: f64) -> Forces {
    Forces { damping: Some(Damping::Viscous(zeta)), ..Forces::default() }
}

fn viscoelastic(time: f64) -> Forces {
    Forces { damping: Some(Damping::Viscoelastic(time)), ..Forces::default() }
}

fn contact_with_forces(scene: &Scene, forces: Forces) -> Contact {
    scene.contact().with_forces(forces)
}

fn elastic() -> Scene {
    Scene { yield_strength: None, ..Scene::steel() }
}

fn fate(impact: &Impact) -> ImpactEnd {
    impact.forces_result.unwrap().fate
}

#[test]
fn hunt_crossley_restitution_has_slope_two_thirds() {
    // Hunt and Crossley (1975), J. Appl. Mech. 42, 440-445: e = 1 − α v and damping (3/2) α of the force, so χ = (3/2)
    // α, to first order in χ v; the next term of G(−e v) = G(v) is + (4/9) (χ v)²
    let contact = |chi| contact_with_forces(&elastic(), hunt_crossley(chi));
    for chi_v in [1e-6, 1e-4, 1e-3, 1e-2] {
        let (chi, speed) = (0.1, chi_v / 0.1);
        let contact = contact(chi);
        let (scales, law, q) = contact.scaling(speed).unwrap();
        let exact = exact_solutions::solve(law, q, &damped(chi * scales.speed));
        let third = exact.restitution - (1.0 - 2.0 / 3.0 * chi_v + 4.0 / 9.0 * chi_v * chi_v);
        assert!(third.abs() < 0.5 * chi_v.powi(3) + 1e-15, "{chi_v}: {third:e}");
    }
    // the force never pulls, even with strong damping
    let impact = contact(100.0).impact(10.0, &Solver::default(), Some(100)).unwrap();
    assert!(impact.row.restitution > 0.0);
    // G(−e v) = G(v) with χ v = 1000: e χ v + ln(1 − e χ v) = ln 1001 − 1000, so e χ v = 1 − e^(−992…)
    assert!(relative_error(impact.row.restitution, 1e-3) < 1e-9);
    assert!(impact.trace.iter().all(|row| row.force >= 0.0));
}

#[test]
fn viscous_hertz_restitution_is_independent_of_speed() {
    // Tsuji, Tanaka and Ishida (1992), Powder Technol. 71, 239-250, chose δ^¼ so that e does not depend on the speed
    for zeta in [0.01, 0.1, 0.5, 0.9, 1.0, 3.0] {
        let at = |speed| {
            contact_with_forces(&elastic(), viscous(zeta)).impact(speed, &solver(Method::Rk8, 1e-11), None).unwrap()
        };
        let (slow, fast) = (at(1e-3), at(10.0));
        assert!(relative_error(slow.row.restitution, fast.row.restitution) < 1e-9, "{zeta}");
        // contact time as v^(−1/5)
        assert!(relative_error(slow.row.contact_time / fast.row.contact_time, 1e4_f64.powf(0.2)) < 1e-9);
    }
}

#[test]
fn overdamped_contact_separates_or_creeps_under_gravity() {
    let scene = Scene::steel();
    for zeta in [1.0, 2.0, 20.0] {
        // during the rebound only a pulling force could slow the sphere down, and the contact never pulls
        let impact = contact_with_forces(&scene, viscous(zeta)).impact(3.0, &Solver::default(), None).unwrap();
        assert!(fate(&impact) == ImpactEnd::Separated && impact.row.restitution > 0.0 && impact.row.restitution < 0.1);
        let both = Forces { gravity: Some(1e6), ..viscous(zeta) };
        for speed in [0.0, 1e-3, 0.1] {
            let mut times = Vec::new();
            for (method, _) in STEPPING {
                let impact = contact_with_forces(&scene, both).impact(speed, &solver(method, 1e-9), Some(40)).unwrap();
                let report = impact.forces_result.unwrap();
                assert_eq!((report.fate, impact.row.restitution), (ImpactEnd::Captured, 0.0));
                let at_rest = report.static_indentation.unwrap();
                // the end is within a thousandth of the static indentation, or at an earlier turning point
                let distance = (report.end_indentation / at_rest - 1.0).abs();
                assert!(distance < 1.1e-3, "{zeta} {speed}: {distance}");
                assert_eq!(impact.trace.last().unwrap().event, Some(Event::Captured));
                assert!(impact.energy.balance_error < 1e-7, "{}", impact.energy.balance_error);
                times.push(report.end_time);
            }
            assert!(
                relative_error(times[0], times[1]) < 1e-6 && relative_error(times[0], times[2]) < 1e-6,
                "{zeta} {speed} {times:?}"
            );
        }
    }
}

#[test]
fn methods_without_steps_name_their_limits() {
    let closed = Solver { method: Method::ClosedForm, ..Solver::default() };
    let contact = contact_with_forces(&Scene::steel(), viscous(0.1));
    assert_eq!(contact.impact(3.0, &closed, None), Err(ImpactError::NoClosedForm));
    assert_eq!(contact.closed_form(3.0), Err(ImpactError::NoClosedForm));
    assert!(matches!(contact.closed_form(1e200), Err(ImpactError::Range(_))));
    let auto = Solver::AUTO;
    let method =
        |forces, samples| contact_with_forces(&Scene::steel(), forces).impact(3.0, &auto, samples).unwrap().method;
    assert_eq!(method(gravity(GRAVITY), None), Method::ClosedForm);
    assert_eq!(method(gravity(GRAVITY), Some(10)), Method::Rk8);
    assert_eq!(method(viscous(0.1), None), Method::Rk8);
}

/// Strong damping of Hunt and Crossley lets the sphere out at 1/χ, where F (1 + χ δ') is zero but for rounding. The contact ends
/// at the dent all the same: once it ended up to seven times too early.
#[test]
fn fixed_steps_follow_strong_damping_to_dent() {
    for speed in [7.0, 15.0, 30.0] {
        for scene in [Scene::steel(), Scene { yield_strength: Some(900e6), ..Scene::steel() }] {
            let contact = contact_with_forces(&scene, hunt_crossley(10.0));
            let exact = contact.impact(speed, &solver(Method::Rk8, 1e-10), None).unwrap();
            let error = |steps_per_contact| {
                let verlet = Solver { method: Method::Verlet, steps_per_contact, ..Solver::default() };
                relative_error(contact.impact(speed, &verlet, None).unwrap().row.contact_time, exact.row.contact_time)
            };
            assert!(error(50) < 0.15 && error(5000) < 0.01, "{speed} {} {}", error(50), error(5000));
        }
    }
}

/// Under gravity `auto` is as exact as the energy and costs what rk8 does: the rebound is that of the balance of energy, the
/// times are those of a run by rk8.
#[test]
fn auto_matches_energy_and_rk8_under_gravity() {
    let contact = contact_with_forces(&Scene::steel(), gravity(1e4));
    let [auto, stepped] = [Method::Auto, Method::Rk8].map(|method| contact.row(0.5, &solver(method, 1e-5)).unwrap());
    assert_eq!(auto.contact_time, stepped.contact_time);
    assert_eq!(auto.restitution, contact.closed_form(0.5).unwrap().row.restitution);
    assert!(auto.restitution != stepped.restitution && relative_error(stepped.restitution, auto.restitution) < 1e-4);
}
