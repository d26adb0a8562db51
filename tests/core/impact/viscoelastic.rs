//! Viscoelastic contacts (Kuwabara and Kono 1987): references of 20 digits, closed forms, energy, and what is refused.

use crate::common::prelude::*;

fn viscoelastic(time: f64) -> Forces {
    Forces { damping: Some(Damping::Viscoelastic(time)), ..Forces::default() }
}

fn elastic() -> Scene {
    Scene { yield_strength: None, ..Scene::steel() }
}

/// L = (m v²/k)^(2/5), the unit of length of the references.
fn unit_length(contact: &Contact, speed: f64) -> f64 {
    (contact.mass() * speed * speed / contact.pair().hertz_stiffness()).powf(0.4)
}

/// The elastic contact with a = (3/2) A v/L at this speed.
fn contact_with(a: f64, speed: f64) -> Contact {
    let contact = elastic().contact();
    let time = a * unit_length(&contact, speed) / (1.5 * speed);
    contact.with_forces(viscoelastic(time))
}

#[derive(Debug, serde::Deserialize)]
struct Reference {
    a: f64,
    restitution: f64,
    contact_time: f64,
    peak_indentation: f64,
    peak_force: f64,
    end_indentation: f64,
}

fn references() -> Vec<Reference> {
    records(include_str!("../../reference/viscoelastic.csv"))
}

/// The errors of e, contact time, peak indentation, peak force and the indentation at the end.
fn largest_error(reference: &Reference, speed: f64, solver: &Solver) -> f64 {
    let contact = contact_with(reference.a, speed);
    let length = unit_length(&contact, speed);
    let force = contact.pair().hertz_stiffness() * length.powf(1.5);
    let impact = contact.impact(speed, solver, None).unwrap();
    let row = &impact.row;
    let errors = [
        row.restitution - reference.restitution,
        relative_error(row.contact_time, reference.contact_time * length / speed),
        relative_error(row.peak_indentation, reference.peak_indentation * length),
        relative_error(row.peak_force, reference.peak_force * force),
        relative_error(impact.forces_result.unwrap().end_indentation, reference.end_indentation * length),
    ];
    max_magnitude(errors)
}

#[test]
fn impacts_agree_with_twenty_digits() {
    let references = references();
    assert_eq!(references.len(), 9);
    for reference in &references {
        for speed in [1e-3, 0.7, 30.0] {
            for (solver, allowed) in [
                (Solver::AUTO, 1e-10),
                (solver(Method::Rk8, 1e-13), 2e-13),
                (solver(Method::Dopri5, 1e-11), 1e-9),
                (solver(Method::Dop853, 1e-11), 1e-9),
            ] {
                let error = largest_error(reference, speed, &solver);
                assert!(error < allowed, "{reference:?} at {speed} by {:?}: {error:e}", solver.method);
            }
        }
    }
}

/// The contact ends where x^(3/2) + a √x x' = 0, at x = a e.
#[test]
fn sphere_separates_before_recovery() {
    for a in [1e-4, 0.02, 0.4, 2.0, 5.0] {
        let (contact, speed) = (contact_with(a, 2.0), 2.0);
        let impact = contact.impact(speed, &solver(Method::Rk8, 1e-12), None).unwrap();
        let under = impact.forces_result.unwrap();
        let want = a * impact.row.restitution * unit_length(&contact, speed);
        assert!(relative_error(under.end_indentation, want) < 1e-10, "{a}");
        // (2/5) k x^(5/2) is left in the contact
        let left = 0.4 * contact.pair().hertz_stiffness() * under.end_indentation.powf(2.5);
        assert!(relative_error(under.stored_at_separation.unwrap(), left) < 1e-9, "{a}");
        assert!(impact.energy.balance_error < 1e-11, "{a}: {}", impact.energy.balance_error);
    }
}

/// e = 1 − 1.15344 a for small a, which goes with v^(1/5): the loss is A ∫ f' δ'² dt with δ' = √(1 − (4/5) x^(5/2)) of the impact
/// without loss, so 1 − e = a ∫ 2 √x √(1 − (4/5) x^(5/2)) dx = (4/5) (5/4)^(3/5) B(3/5, 3/2) a = 1.15344 a.
#[test]
fn small_loss_grows_with_fifth_root_of_speed() {
    const FIRST_ORDER: f64 = 1.153_448_858_095_29;
    let loss = |contact: &Contact, speed| {
        1.0 - contact.impact(speed, &solver(Method::Rk8, 1e-13), None).unwrap().row.restitution
    };
    for a in [1e-5, 1e-4] {
        let contact = contact_with(a, 0.5);
        assert!((loss(&contact, 0.5) / (FIRST_ORDER * a) - 1.0).abs() < a, "{a}");
        let ratio = loss(&contact, 16.0) / loss(&contact, 0.5);
        assert!(relative_error(ratio, 2.0) < 2.0 * a, "{ratio}");
    }
}

/// On a straight line A k δ' is a viscous force of the fraction ζ = (A/2) √(k/m) of critical damping.
#[test]
fn straight_contact_is_viscous() {
    let law = WaltonBraun { stiffness_ratio: 1.0, ..WaltonBraun::default() };
    let contact = Scene::steel().contact_by(&law);
    let point = contact.pair().yield_point.unwrap();
    let stiffness = point.force / point.indentation;
    for zeta in [1e-3, 0.1, 0.6, 1.0, 2.0] {
        let time = 2.0 * zeta * (contact.mass() / stiffness).sqrt();
        let run = |damping| {
            let forces = Forces { damping: Some(damping), ..Forces::default() };
            contact.clone().with_forces(forces).impact(3.0, &solver(Method::Rk8, 1e-12), None).unwrap().row
        };
        let (own, viscous) = (run(Damping::Viscoelastic(time)), run(Damping::Viscous(zeta)));
        for [own, viscous] in [
            [own.restitution, viscous.restitution],
            [own.contact_time, viscous.contact_time],
            [own.peak_force, viscous.peak_force],
        ] {
            assert!(relative_error(own, viscous) < 1e-10, "{zeta}: {own} {viscous}");
        }
    }
}

/// A metal with an inner loss: the trace closes the balance of energy at every row, and no row pulls.
#[test]
fn yielding_contact_keeps_its_balance() {
    for exponent in [UnloadingExponent::Paper, UnloadingExponent::PressureShape] {
        let scene = Scene { exponent, ..Scene::steel() };
        for (speed, time) in [(0.05, 1e-6), (3.0, 1e-7), (3.0, 1e-5), (20.0, 1e-4)] {
            let contact = scene.contact().with_forces(viscoelastic(time));
            let impact = contact.impact(speed, &solver(Method::Rk8, 1e-11), Some(300)).unwrap();
            for row in &impact.trace {
                assert!(row.force >= 0.0 && row.energy_balance_error.abs() < 1e-9, "{speed} {time}: {row:?}");
            }
            let elastic = contact.clone().with_forces(Forces::default()).impact(speed, &Solver::AUTO, None).unwrap();
            assert!(impact.row.restitution < elastic.row.restitution);
            assert!(impact.row.peak_indentation < elastic.row.peak_indentation);
        }
    }
}

/// The impulse of friction that slides is μ times the impulse of the whole contact force, m v (1 + e). The springs of the tangential contact
/// reach this limit after μ A v E*/(4 G* s_0), 1 % of A, which lowers the impulse by less than 1e-6 of the tangential speed.
#[test]
fn sliding_friction_takes_the_whole_force() {
    let contact = contact_with(0.1, 1.0);
    let approach = Approach::at_angle(10_f64.sqrt(), 3_f64.atan(), 0.0, 0.1);
    let row = contact.impact(approach, &Solver::AUTO, None).unwrap().row;
    let left = 3.0 - 0.1 * (1.0 + row.restitution);
    assert!(relative_error(row.rebound.unwrap().tangential.speed, left) < 1e-6);
}

/// A slow sphere under its weight stays, and rests at the static indentation.
#[test]
fn slow_sphere_is_captured_under_gravity() {
    // from a twentieth of critical damping to twenty times as much
    for time in [1e-6, 1e-5, 1e-4, 5e-4] {
        let forces = Forces { gravity: Some(1e4), ..viscoelastic(time) };
        let contact = elastic().contact().with_forces(forces);
        let impact = contact.impact(0.0, &Solver::AUTO, None).unwrap();
        let under = impact.forces_result.unwrap();
        assert_eq!((under.fate, impact.row.restitution), (ImpactEnd::Captured, 0.0), "{time}");
        let at_rest = (contact.mass() * 1e4 / contact.pair().hertz_stiffness()).powf(2.0 / 3.0);
        assert!(relative_error(under.static_indentation.unwrap(), at_rest) < 1e-12, "{time}");
    }
}

/// At maximum compression a metal with a strain rate relaxes at once, and A f' δ' of a drop is not defined; a plate would also move with
/// the damping.
#[test]
fn strain_rate_and_plate_are_refused() {
    let run = |settings: &[&str]| contact(STEEL, settings).with_forces(viscoelastic(1e-6));
    let rated = run(&["half_space.rate={ johnson_cook = { c = 0.014 } }"]);
    assert_eq!(rated.impact(3.0, &Solver::AUTO, None).unwrap_err(), ImpactError::ViscoelasticRate);
    assert_eq!(rated.row(3.0, &Solver::AUTO).unwrap_err(), ImpactError::ViscoelasticRate);
    let plate = Plate { thickness: 5e-3, edge_distance: None, theory: PlateTheory::Zener };
    let on_plate = run(&["half_space.density=7850"])
        .with_forces(Forces { waveguide: Some(Waveguide::Plate(plate)), ..viscoelastic(1e-6) });
    assert_eq!(
        on_plate.impact(3.0, &Solver::AUTO, None).unwrap_err(),
        WaveguideError { kind: WaveguideKind::Plate, reason: WaveguideFault::Damped }.into()
    );
}
