//! Properties that hold for every scene, tested with random scenes.

use crate::common::prelude::*;

const TOLERANCE: f64 = 1e-10;

/// A random scene and v/v_Y: radius 1 nm to 10 m, moduli 1 MPa to 10 TPa, any Poisson's ratio, σ_Y/E* from 1e-5 to 0.1.
/// The dent is smaller than the sphere.
fn any_impact() -> impl Strategy<Value = (Scene, f64)> {
    (scenes(6.0..13.0, -0.9..0.49, -9.0..1.0, -5.0..-1.0), 2.0..4.3_f64, -3.0..4.0_f64)
        .prop_map(|(scene, log_rho, log_q)| (Scene { density: 10_f64.powf(log_rho), ..scene }, 10_f64.powf(log_q)))
        .prop_filter("too deep", |(scene, q)| scene.contact().row(q * scene.yield_speed(), &Solver::AUTO).is_ok())
}

/// The largest rise of e after a knot, by the definition of the law: 0.02 % for κ > 0.4 (0.03 % with the exponent
/// pressure-shape), and 0.12 % as κ → 1. For smaller κ there is no rise, up to rounding.
fn allowed_rise(scene: &Scene) -> f64 {
    let kappa = scene.contact().pair().sphere_compliance;
    match scene.exponent {
        _ if kappa <= 0.4 => 1e-12,
        _ if kappa > 0.9 => 1.2e-3,
        UnloadingExponent::PressureShape => 3e-4,
        _ => 2e-4,
    }
}

proptest! {
    #![proptest_config(crate::common::cases(500))]

    #[test]
    fn restitution_is_a_ratio_energy_closes_and_methods_agree((scene, q) in any_impact(), log_tolerance in -12.0..-3.0_f64) {
        let speed = q * scene.yield_speed();
        let tolerance = 10_f64.powf(log_tolerance);
        let exact = scene.impact(speed, Method::ClosedForm, tolerance, None);
        for (method, factor) in STEPPING {
            let impact = scene.impact(speed, method, tolerance, None);
            let slack = factor * tolerance;
            prop_assert!(impact.restitution > 0.0 && impact.restitution <= 1.0 + slack);
            let energy = impact.energy;
            let sum = energy.recovered + energy.plastic.unwrap();
            prop_assert!(off(sum, energy.kinetic_in) <= 2.0 * slack, "{} {}", method.name(), off(sum, energy.kinetic_in));
            prop_assert!(energy.drift <= 2.0 * slack);
            prop_assert!(energy.plastic.unwrap() >= -slack * energy.kinetic_in);
            prop_assert_eq!(impact.has_dent(), q > 1.0 && impact.residual_indentation > 0.0);
            prop_assert!(impact.residual_indentation >= 0.0 && impact.residual_indentation < impact.peak_indentation);
            prop_assert!(impact.unloading_radius >= scene.radius * (1.0 - 1e-12));
            prop_assert!(impact.residual_radius.is_none_or(|radius| radius > scene.radius));
            for (got, want) in results(&impact).into_iter().zip(results(&exact)) {
                prop_assert!((got - want).abs() <= factor * tolerance * want, "{} {tolerance:e}: {got} {want}", method.name());
            }
            // the impact reports the same errors
            prop_assert!(impact.accuracy.restitution_error <= factor * tolerance);
            prop_assert_eq!(impact.accuracy.closed_form_restitution, exact.restitution);
        }
    }

    #[test]
    fn restitution_does_not_rise_with_speed((scene, q) in any_impact(), log_step in -6.0..1.0_f64) {
        let scene_contact = scene.contact();
        let speed = q * scene.yield_speed();
        let slow = scene_contact.closed_form(speed).unwrap().restitution;
        let fast = held(scene_contact.closed_form(speed * (1.0 + 10_f64.powf(log_step))))?.restitution;
        prop_assert!(fast <= slow * (1.0 + allowed_rise(&scene)), "{slow} {fast}");
    }

    #[test]
    fn units_do_not_matter((scene, q) in any_impact(), log_length in -9.0..9.0_f64, log_time in -6.0..6.0_f64, log_mass in -9.0..9.0_f64) {
        // lengths × a, times × b, masses × c: moduli and strengths × c/(a b²), density × c/a³. A heavier sphere, a common
        // factor of moduli and strength, and another size are changes of units at the same v/v_Y
        let [a, b, c] = [log_length, log_time, log_mass].map(|log| 10_f64.powf(log));
        let pressure = c / (a * b * b);
        let body = |body: Material| Material { youngs_modulus: body.youngs_modulus * pressure, ..body };
        let other = Scene {
            radius: scene.radius * a,
            density: scene.density * c / a.powi(3),
            sphere: body(scene.sphere),
            half_space: body(scene.half_space),
            yield_strength: scene.yield_strength.map(|strength| strength * pressure),
            ..scene
        };
        let speed = q * scene.yield_speed();
        let factors = [1.0, b, b, c * a / (b * b), a, a, a];
        for (method, allowed) in invariant() {
            let one = scene.impact(speed, method, TOLERANCE, None);
            let two = match other.contact().impact(speed * a / b, &crate::common::solver(method, TOLERANCE), None) {
                Ok(impact) => impact,
                // extreme units leave the range of double precision, and the error says so
                Err(ImpactError::Range(_)) => continue,
                Err(error) => return Err(TestCaseError::fail(error.to_string())),
            };
            for ((got, want), factor) in results(&two).into_iter().zip(results(&one)).zip(factors) {
                prop_assert!((got - want * factor).abs() <= allowed * want * factor, "{}: {got} {want} {factor}", method.name());
            }
        }
    }

    #[test]
    fn restitution_is_continuous_in_speed_across_every_knot((scene, _) in any_impact(), log_gap in -12.0..-3.0_f64) {
        let contact = scene.contact();
        let yield_speed = scene.yield_speed();
        let gap = 10_f64.powf(log_gap);
        let law = scene.law();
        let knots = law.loading.pieces().iter().skip(1).map(|piece| (2.5 * piece.work).sqrt()).chain([1.0]);
        for q in knots {
            let at = |q: f64| held(contact.closed_form(q * yield_speed));
            let (Ok(below), Ok(above)) = (at(q * (1.0 - gap)), at(q * (1.0 + gap))) else { break };
            // |d ln e/d ln v| < 1/2 on every piece, |d ln T/d ln v| < 1
            prop_assert!(off(above.restitution, below.restitution) <= gap + 1e-13, "{q}");
            prop_assert!(off(above.contact_time, below.contact_time) <= 2.0 * gap + 1e-13, "{q}");
            prop_assert!(off(above.peak_force, below.peak_force) <= 4.0 * gap + 1e-13, "{q}");
        }
    }
}

/// How much two computations of one dimensionless impact may differ. The input differs by the rounding of v/v_Y and of
/// the constants of the law, so closed forms agree to rounding. A stepper may accept a step in one case and reject it
/// in the other, so it agrees to its tolerance.
fn invariant() -> impl Iterator<Item = (Method, f64)> {
    [(Method::ClosedForm, 1e-12)].into_iter().chain(STEPPING.map(|(method, factor)| (method, factor * TOLERANCE)))
}

/// Results with the dimensions 1, time, time, force and three lengths. The elastic approach stands for the dent,
/// because x − ε of a shallow dent has lost digits.
fn results(impact: &Impact) -> [f64; 7] {
    [
        impact.restitution,
        impact.contact_time,
        impact.loading_time,
        impact.peak_force,
        impact.peak_indentation,
        impact.elastic_approach,
        impact.peak_contact_radius,
    ]
}

#[test]
fn the_smallest_and_the_largest_scenes_are_computed_or_refused_by_name() {
    let mut computed = 0;
    for radius in [1e-300, 1e-100, 1e-30, 1e30, 1e100, 1e300] {
        for modulus in [1e-300, 1e-30, 1e30, 1e300] {
            for speed in [1e-300, 1.0, 1e300] {
                let mut scene = Scene { radius, yield_strength: Some(1e-3 * modulus), ..Scene::steel() };
                scene.sphere.youngs_modulus = modulus;
                scene.half_space.youngs_modulus = modulus;
                let Ok(contact) = scene.try_contact() else { continue };
                match contact.impact(speed, &crate::common::solver(Method::Rk8, 1e-10), None) {
                    Ok(impact) => {
                        assert!(
                            results(&impact).iter().all(|result| result.is_finite() && *result > 0.0),
                            "{impact:?}"
                        );
                        assert!(impact.restitution <= 1.0 + 1e-9);
                        // of an elastic impact, (2/5) F_m δ_m = ½ m v²
                        let stored = 0.4 * impact.peak_force * impact.peak_indentation;
                        assert!(impact.has_dent() || off(stored, impact.kinetic_in) < 1e-9, "{impact:?}");
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
