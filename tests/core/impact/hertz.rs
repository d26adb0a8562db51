//! Elastic impacts of random bodies by every method, compared with the closed forms of Hertz.

use crate::common::prelude::*;

/// An elastic half-space: without a yield strength, or with one that is not reached.
fn any_elastic_impact() -> impl Strategy<Value = (Scene, f64)> {
    let bodies = (scenes(6.0..13.0, -0.9..0.49, -9.0..1.0, -2.1..-2.0), 2.0..4.3_f64);
    let any = (bodies, -3.0..3.0_f64, prop::option::of(0.01..0.999_f64));
    let any = any.prop_map(|((scene, log_rho), log_v, share_of_yield)| {
        let scene = Scene { density: 10_f64.powf(log_rho), ..scene };
        let elastic = Scene { yield_strength: None, ..scene };
        share_of_yield.map_or((elastic, 10_f64.powf(log_v)), |share| (scene, share * scene.yield_speed()))
    });
    any.prop_filter("too deep", |(scene, v)| scene.contact().row(*v, &Solver::AUTO).is_ok())
}

proptest! {
    #![proptest_config(crate::common::proptest_config(200))]

    #[test]
    fn peak_time_and_energy_are_hertzs((scene, v) in any_elastic_impact()) {
        const TOLERANCE: f64 = 1e-11;
        // formulas of Johnson (1985), Section 11.4, with m = (4/3) π R³ ρ
        let m = 4.0 / 3.0 * std::f64::consts::PI * scene.radius.powi(3) * scene.density;
        let compliance = |body: Material| (1.0 - body.poissons_ratio.powi(2)) / body.youngs_modulus;
        let e_star = 1.0 / (compliance(scene.sphere) + compliance(scene.half_space));
        let k = 4.0 / 3.0 * e_star * scene.radius.sqrt();
        let indentation = (1.25 * m * v * v / k).powf(0.4);
        let force = k * indentation.powf(1.5);
        for (method, factor) in STEPPING.into_iter().chain([(Method::ClosedForm, 1e-2)]) {
            let impact = scene.impact(v, method, TOLERANCE, None);
            let error = [
                relative_error(impact.row.restitution, 1.0),
                relative_error(impact.rebound_speed, v),
                relative_error(impact.row.peak_indentation, indentation),
                relative_error(impact.row.peak_force, force),
                relative_error(impact.row.contact_time, HERTZ_CONTACT_TIME * indentation / v),
                relative_error(impact.loading_time, 0.5 * HERTZ_CONTACT_TIME * indentation / v),
                relative_error(impact.energy.kinetic_in, 0.4 * force * indentation),
                relative_error(impact.energy.recovered, 0.5 * m * v * v),
                relative_error(impact.row.peak_contact_radius, (scene.radius * indentation).sqrt()),
                // p_m = (2/3) p_0, p_0 = 3F/(2πa²)
                relative_error(impact.peak_mean_pressure, force / (std::f64::consts::PI * scene.radius * indentation)),
                relative_error(impact.peak_sphere_indentation, compliance(scene.sphere) * e_star * indentation),
                impact.energy.balance_error,
            ].into_iter().fold(0.0, nan_max);
            prop_assert!(error <= 2.0 * factor * TOLERANCE, "{}: {error:e}", method.name());
            prop_assert_eq!(impact.row.residual_indentation, 0.0);
            prop_assert_eq!((impact.dent_radius, impact.residual_radius), (None, None));
            prop_assert_eq!(impact.energy.plastic, scene.yield_strength.map(|_| 0.0));
        }
    }
}

/// Deepest overlap, peak force and contact time, with half a unit of the last printed digit.
#[test]
fn published_impacts_of_hertz_are_reproduced() {
    let rigid = Material { youngs_modulus: f64::INFINITY, poissons_ratio: 0.3 };
    let body = |youngs_modulus, poissons_ratio| Material { youngs_modulus, poissons_ratio };
    let glass = body(100e9, 0.25);
    let none = (f64::NAN, f64::NAN);
    for ((radius, density, speed), sphere, half_space, printed) in [
        // LAMMPS `hertz/material` against a wall of the same material, and against a rigid one
        ((2.5e-3, 7000.0, 3.9), glass, glass, [(22.6806e-6, 5e-11), none, none]),
        ((2.5e-3, 7000.0, 3.9), rigid, glass, [(17.19e-6, 5e-9), none, none]),
        // Chung and Ooi (2011), test 2: spheres of aluminium and magnesium on a rigid plane; a rigid sphere of the same
        // density on a half-space with the modulus of the sphere is the same problem
        ((0.1, 2699.0, 0.2), rigid, body(70e9, 0.3), [(49.72e-6, 0.005e-6), (11_370.0, 0.5), (731.7e-6, 0.05e-6)]),
        ((0.1, 1800.0, 0.2), rigid, body(40e9, 0.35), [(52.12e-6, 0.005e-6), (7233.0, 0.5), (767.1e-6, 0.05e-6)]),
    ] {
        let exponent = UnloadingExponent::Paper;
        let scene = Scene { radius, density, sphere, half_space, yield_strength: None, exponent };
        for (method, _) in STEPPING {
            let impact = scene.impact(speed, method, 1e-10, None);
            let got = [impact.row.peak_indentation, impact.row.peak_force, impact.row.contact_time];
            for (got, (want, half_a_digit)) in got.into_iter().zip(printed).filter(|(_, (want, _))| want.is_finite()) {
                assert!((got - want).abs() <= half_a_digit, "{}: {got} {want}", method.name());
            }
        }
    }
}
