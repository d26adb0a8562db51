//! Impacts on a spot that was hit before, and the memory of a contact.

use plm_impact::impact::solve::closed_form;

use plm_impact::numerics::power::quarter_period_factor;

use crate::common::prelude::*;

const EXPONENTS: [UnloadingExponent; 3] =
    [UnloadingExponent::Paper, UnloadingExponent::PressureShape, UnloadingExponent::Fixed(1.8)];

/// A spot of steel after an impact at 300 v_Y, and this impact.
fn dented(exponent: UnloadingExponent) -> (Contact, Spot, Impact) {
    let contact = Scene { exponent, ..Scene::steel() }.contact();
    let mut spot = Spot::new();
    let first = closed_form_on_spot(&contact, &mut spot, 3.0);
    (contact, spot, first)
}

#[test]
fn equal_shots_approach_elastic_dent() {
    // in the limit of w(x_(k+1)) = w(x_k) + kinetic − f ε/(n + 1), kinetic = f ε/(n + 1) and e = 1
    for exponent in EXPONENTS {
        let (contact, mut spot, first) = dented(exponent);
        let mut before = first;
        for _ in 0..1000 {
            let shot = closed_form_on_spot(&contact, &mut spot, 3.0);
            assert!(
                shot.row.restitution >= before.row.restitution
                    && shot.row.residual_indentation >= before.row.residual_indentation
            );
            before = shot;
        }
        assert!(relative_error(before.row.restitution, 1.0) < 1e-13);
        assert!(
            relative_error(
                before.row.peak_force * before.elastic_approach / (before.unloading_exponent + 1.0),
                before.energy.kinetic_in
            ) < 1e-13
        );
    }
}

#[test]
fn slow_reloads_keep_their_digits() {
    // on k d^n: d_max = ε_m (v/v_el)^(2/(n + 1)), F = F_m (d/ε_m)^n, T = 2 quarter periods × d/v
    for exponent in EXPONENTS {
        let (contact, spot, first) = dented(exponent);
        let n = first.unloading_exponent;
        for share in [0.9, 1e-3, 1e-9, 1e-30, 1e-100] {
            let speed = share * first.rebound_speed;
            for (method, factor) in STEPPING.into_iter().chain([(Method::ClosedForm, 0.0)]) {
                let mut spot = spot.clone();
                let hit = contact.impact_on(&mut spot, speed, &solver(method, 1e-10), Some(50)).unwrap();
                let distance = first.elastic_approach * share.powf(2.0 / (n + 1.0));
                // the power of 1e-100 has the error of the rounded exponent times ln 1e-100
                let allowed = factor * 1e-10 + 1e-13;
                assert!(relative_error(hit.elastic_approach, distance) < allowed, "{share} {}", method.name());
                assert!(
                    relative_error(
                        hit.row.peak_force,
                        first.row.peak_force * (distance / first.elastic_approach).powf(n)
                    ) < allowed
                );
                assert!(
                    relative_error(hit.row.contact_time, 2.0 * quarter_period_factor(n) * distance / speed) < allowed
                );
                // a ∝ dF/dδ on an unchanged dent (Sneddon 1965), so a ∝ d^(n − 1)
                let radius = first.row.peak_contact_radius * (distance / first.elastic_approach).powf(n - 1.0);
                assert!(relative_error(hit.row.peak_contact_radius, radius) < allowed);
                assert!(
                    hit.energy.balance_error < allowed,
                    "{share} {}: {:e}",
                    method.name(),
                    hit.energy.balance_error
                );
            }
        }
    }
}

#[test]
fn dent_on_hertz_piece_is_cut() {
    // between first yield and the first knot (x = 1.7) the force is that of Hertz, but there is a dent
    for x in [1.000_001, 1.1, 1.5, 1.699_999, 1.7] {
        let law = Scene::steel().law();
        let branch = law.unload(law.loaded_state(x));
        let dent = law.history_after(branch.peak);
        let reloaded = Surface::new(&law, Some(&dent));
        for target in [x * (1.0 + 1e-9), 1.2 * x, 10.0] {
            let kinetic = branch.recoverable_energy() + (law.loading.work(target) - law.loading.work(x));
            let outcome = closed_form::solve(reloaded, (2.5 * kinetic).sqrt());
            assert!(relative_error(outcome.unloading.peak.indentation, target) < 1e-14, "{x} {target}");
            for (method, factor) in STEPPING {
                let (stepped, _) = crate::common::run(reloaded, (2.5 * kinetic).sqrt(), method, 1e-11).unwrap();
                let error = crate::common::max_relative_error_of_outcomes(&stepped, &outcome);
                assert!(error < factor * 1e-11 + 1e-12, "{x} {target} {}: {error:e}", method.name());
            }
        }
    }
}

/// A soft sphere on a half-space twenty times stiffer: with nine pieces the plastic work falls by 2e-5 of the energy after the
/// knot at x = 1.7. The second hit goes beyond the knot and gains this energy. This follows from such a law, and a warning says
/// so.
#[test]
fn energy_gain_at_knot_warns() {
    let material = |youngs_modulus| Material { youngs_modulus, poissons_ratio: 0.0 };
    let (sphere, half_space) = (material(1.342e9), material(27.858e9));
    let scene =
        Scene { radius: 1.0, density: 5000.0, sphere, half_space, yield_strength: Some(7.76e6), ..Scene::case_3() };
    let (contact, speed) = (scene.contact_by(&nine_pieces()), 1.945 * scene.yield_speed());
    let mut spot = Spot::new();
    let is_gain = |impact: &Impact| impact.warnings.iter().any(|warning| warning.kind == WarningKind::EnergyGain);
    let first = closed_form_on_spot(&contact, &mut spot, speed);
    assert!(first.row.restitution < 1.0 && !is_gain(&first));
    let second = closed_form_on_spot(&contact, &mut spot, speed);
    assert!(second.row.restitution > 1.0 && is_gain(&second), "{}", second.row.restitution);
}

/// Beyond the old peak force and work grow as on fresh surface, whatever the shape of the pieces of a law.
#[test]
fn reloading_continues_on_loading_curve_of_law() {
    let (sphere, half_space) = Scene::steel().bodies();
    let bodies = YieldingPair::new(&Pair::try_new(&sphere, &half_space).unwrap()).unwrap();
    let mut compared = 0;
    for (name, choice) in super::laws::whole_laws() {
        let law = choice.as_contact_law().law(&bodies).unwrap();
        for x in [3.0, 27.0, 160.0, 900.0] {
            let branch = law.unload(law.loaded_state(x));
            if law.check(&branch).is_err() {
                continue;
            }
            let dent = law.history_after(branch.peak);
            let path = Surface::new(&law, Some(&dent)).reloading_path;
            for deeper in [1.0001, 1.1, 2.3, 40.0].map(|factor| factor * x) {
                let (force, work) = (law.loading.force(deeper), law.loading.work(deeper) - law.loading.work(x));
                let about = format!("{name} {x} {deeper}");
                assert!(relative_error(path.force(deeper), force) < 1e-12, "{about}: {} {force}", path.force(deeper));
                let got = path.work(deeper) - branch.recoverable_energy();
                assert!((got - work).abs() < 1e-12 * law.loading.work(deeper), "{about}: {got} {work}");
            }
            compared += 1;
        }
    }
    assert!(compared > 40, "{compared}");
}
